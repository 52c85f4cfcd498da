//! Zeros and extrema of functions of one variable.

use crate::real::Float;

/// The place where `f` passes zero between `from`, where it is not zero, and `to`, where it is or has the other sign;
/// each is a place and the value there. It is after the zero, by at most two ulps.
///
/// T. R. Chandrupatla, "A new hybrid quadratic/bisection algorithm for finding the zero of a nonlinear function without
/// using derivatives", Adv. Eng. Softw. 28 (1997) 145-149.
pub(super) fn root<T: Float>(f: impl Fn(T) -> T, from: (T, T), to: (T, T)) -> T {
    let (zero, one, two) = (T::default(), T::from_f64(1.0), T::from_f64(2.0));
    let (mut a, mut b) = (to, from);
    let is_past = |value: T| (value > zero) != (from.1 > zero) || value == zero;
    let mut fraction = T::from_f64(0.5);
    // Bisection alone would end in as many steps as a number has bits; the hybrid takes at most a few times as many.
    for _ in 0..200 {
        let place = a.0 + fraction * (b.0 - a.0);
        if place == a.0 || place == b.0 {
            break;
        }
        let new = (place, f(place));
        let c;
        if is_past(new.1) == is_past(a.1) {
            c = a;
        } else {
            c = b;
            b = a;
        }
        a = new;
        if a.1 == zero {
            break;
        }
        let smallest = if a.1.abs() < b.1.abs() { a } else { b };
        let resolution = (T::EPSILON * smallest.0.abs()).max(T::MIN_POSITIVE);
        let least = resolution / (b.0 - a.0).abs();
        if least > T::from_f64(0.5) {
            break;
        }
        let (xi, phi) = ((a.0 - b.0) / (c.0 - b.0), (a.1 - b.1) / (c.1 - b.1));
        fraction = if phi * phi < xi && (one - phi) * (one - phi) < one - xi {
            a.1 / (b.1 - a.1) * (c.1 / (b.1 - c.1))
                + (c.0 - a.0) / (b.0 - a.0) * (a.1 / (c.1 - a.1)) * (b.1 / (c.1 - b.1))
        } else {
            one / two
        };
        fraction = fraction.max(least).min(one - least);
    }
    if is_past(a.1) { a.0 } else { b.0 }
}

/// Where a function that has the same sign in three places, nearest to zero in the middle one, touches or passes zero
/// between them, if it does: a place and the value there.
pub(super) fn dip<T: Float>(f: impl Fn(T) -> T, places: [(T, T); 3]) -> Option<(T, T)> {
    let [first, middle, last] = places;
    let zero = T::default();
    let sign = T::from_f64(if middle.1 > zero { 1.0 } else { -1.0 });
    let height = |point: (T, T)| sign * point.1;
    if !(height(middle) < height(first) && height(middle) <= height(last)) || height(first) <= zero {
        return None;
    }
    // The parabola through the three shows how deep it may go: a search is for the few that come near.
    let (left, right) = (middle.0 - first.0, last.0 - middle.0);
    let (fall, rise) = (
        (height(first) - height(middle)) / left,
        (height(last) - height(middle)) / right,
    );
    let curvature = (rise + fall) / (left + right);
    let slope = (rise * left - fall * right) / (left + right);
    let depth = slope * slope / (T::from_f64(4.0) * curvature);
    if depth < T::from_f64(0.25) * height(middle) {
        return None;
    }
    // The golden section, until it is below zero or too short to be there.
    let golden = T::from_f64(0.381_966_011_250_105_1);
    let (mut low, mut best, mut high) = (first.0, middle, last.0);
    while (high - low).abs() > T::EPSILON.sqrt() * (low.abs() + high.abs()) {
        let place = if high - best.0 > best.0 - low {
            best.0 + golden * (high - best.0)
        } else {
            best.0 - golden * (best.0 - low)
        };
        let new = (place, f(place));
        if height(new) <= zero {
            return Some(new);
        }
        let is_right = place > best.0;
        if height(new) < height(best) {
            *(if is_right { &mut low } else { &mut high }) = best.0;
            best = new;
        } else {
            *(if is_right { &mut high } else { &mut low }) = place;
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::{dip, root};

    #[test]
    fn a_root_is_found_to_the_last_bit_and_from_behind() {
        let count = core::cell::Cell::new(0);
        let f = |x: f64| {
            count.set(count.get() + 1);
            x.cos() - x
        };
        let x = root(f, (0.0, 1.0), (1.0, 1.0_f64.cos() - 1.0));
        assert!(f(x) <= 0.0 && f(x.next_down().next_down()) >= 0.0, "{x:e}");
        assert!(count.get() < 14, "{}", count.get());
        // steep, flat, and with a jump
        let x = root(|x: f64| x.powi(9) - 1e-9, (0.0, -1e-9), (1.0, 1.0));
        assert!((x - 0.1).abs() < 1e-15);
        let x = root(|x: f64| if x < 0.3 { -1.0 } else { 1.0 }, (0.0, -1.0), (1.0, 1.0));
        assert!((0.3..0.3_f64.next_up().next_up()).contains(&x));
    }

    #[test]
    fn a_dip_is_found_where_it_passes_zero_only() {
        let places = |f: fn(f64) -> f64| [0.1, 0.5, 1.0].map(|x| (x, f(x)));
        let shallow = |x: f64| (x - 0.55) * (x - 0.55) + 1e-12;
        assert!(dip(shallow, places(shallow)).is_none());
        let deep = |x: f64| (x - 0.55) * (x - 0.55) - 1e-12;
        let (x, value) = dip(deep, places(deep)).expect("a dip");
        assert!((x - 0.55).abs() < 1e-6 && value < 0.0);
    }
}
