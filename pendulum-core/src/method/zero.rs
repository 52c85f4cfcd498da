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
    use std::cell::RefCell;

    use super::{dip, root};

    /// The root of `f` between 0 and 1, or between 1 and 0 in reverse, and the places that were looked at.
    fn search(f: impl Fn(f64) -> f64, (from, to): (f64, f64)) -> (f64, Vec<f64>) {
        let places = RefCell::new(Vec::new());
        let watched = |x: f64| {
            places.borrow_mut().push(x);
            f(x)
        };
        let x = root(watched, (from, f(from)), (to, f(to)));
        (x, places.into_inner())
    }

    #[test]
    fn a_root_is_found_to_the_last_bit_and_from_behind() {
        let f = |x: f64| x.cos() - x;
        let (x, places) = search(f, (0.0, 1.0));
        assert!(f(x) <= 0.0 && f(x.next_down().next_down()) >= 0.0, "{x:e}");
        assert!(places.len() < 14, "{}", places.len());
        // backward it is before the zero
        let (x, places) = search(f, (1.0, 0.0));
        assert!(f(x) >= 0.0 && f(x.next_up().next_up()) <= 0.0, "{x:e}");
        assert!(places.len() < 14, "{}", places.len());
        // steep, flat, and with a jump
        let (x, _) = search(|x| x.powi(9) - 1e-9, (0.0, 1.0));
        assert!((x - 0.1).abs() < 1e-15);
        let (x, places) = search(|x| if x < 0.3 { -1.0 } else { 1.0 }, (0.0, 1.0));
        assert!((0.3..0.3_f64.next_up().next_up()).contains(&x));
        assert!(places.len() < 60, "{}", places.len());
    }

    #[test]
    fn where_the_inverse_is_a_parabola_the_third_place_is_the_root() {
        // x = (y + c)^2 - 1: halving first, then interpolation of the inverse, which is exact.
        for c in [1.15_f64, 1.2, 1.3, 1.35] {
            for (from, to) in [(0.0, 1.0), (1.0, 0.0)] {
                let (x, places) = search(|x| (1.0 + x).sqrt() - c, (from, to));
                let expected = c * c - 1.0;
                assert_eq!(places[0], 0.5);
                assert!((places[1] - expected).abs() < 1e-15, "{c}: {places:?}");
                assert!((x - expected).abs() < 1e-15 && places.len() <= 5, "{c}: {places:?}");
            }
        }
    }

    #[test]
    fn where_interpolation_would_mislead_it_halves() {
        // By Chandrupatla's criterion: from (0, -1), (1/2, f) and (1, 1), with xi = 1/2, interpolation is for
        // phi = (f - 1) / (-1 - 1) between 1 - sqrt(1/2) and sqrt(1/2), which is for f between -0.414 and 0.414.
        let second = |middle: f64| {
            let f = move |x: f64| match x {
                0.0 => -1.0,
                1.0 => 1.0,
                0.5 => middle,
                _ => x - 0.5 + middle,
            };
            search(f, (0.0, 1.0)).1[1]
        };
        for middle in [0.42, 0.9, -0.42, -0.9] {
            assert_eq!(second(middle), if middle > 0.0 { 0.25 } else { 0.75 }, "{middle}");
        }
        // The parabola x(y) through (-1, 0), (middle, 1/2), (1, 1) at y = 0, by Lagrange: of the last two terms.
        for middle in [0.41, 0.2, -0.2, -0.41_f64] {
            let expected = -0.5 / (middle * middle - 1.0) + middle / (2.0 * (middle - 1.0));
            assert!(
                (second(middle) - expected).abs() < 1e-15,
                "{middle}: {} {expected}",
                second(middle)
            );
        }
    }

    #[test]
    fn an_end_that_is_zero_is_the_root() {
        let (x, places) = search(|x| x - 1.0, (0.0, 1.0));
        assert_eq!((x, places.len() < 56), (1.0, true), "{places:?}");
        let (x, places) = search(|x| x - 0.5, (0.0, 1.0));
        assert_eq!((x, &places[..]), (0.5, &[0.5][..]));
        // zero from some place on
        let (x, places) = search(|x| (x - 0.3).min(0.0), (0.0, 1.0));
        assert_eq!((x, &places[..]), (0.5, &[0.5][..]));
    }

    #[test]
    fn a_root_at_zero_is_found_in_bounded_time() {
        let (x, places) = search(|x| if x > 0.0 { 1.0 } else { -1.0 }, (-1e-3, 1.0));
        assert!(x > 0.0 && x < 1e-15, "{x:e} after {}", places.len());
        assert!(places.len() <= 200);
    }

    fn places(f: impl Fn(f64) -> f64, at: [f64; 3]) -> [(f64, f64); 3] {
        at.map(|x| (x, f(x)))
    }

    #[test]
    fn a_dip_is_found_where_it_passes_zero_only() {
        for sign in [1.0, -1.0] {
            for at in [
                [0.1, 0.5, 1.0],
                [0.1, 0.6, 1.0],
                [0.1, 0.55, 0.7],
                [0.4, 0.54, 1.0],
                [0.1, 0.1001, 2.0],
            ] {
                for bottom in [0.57, 0.53, 0.61] {
                    let f = |height: f64| move |x: f64| sign * ((x - bottom) * (x - bottom) + height);
                    let lowest_in_the_middle =
                        (at[1] - bottom).abs() < (at[0] - bottom).abs().min((at[2] - bottom).abs());
                    assert!(dip(f(1e-12), places(f(1e-12), at)).is_none());
                    let found = dip(f(-1e-12), places(f(-1e-12), at));
                    if !lowest_in_the_middle {
                        assert!(found.is_none(), "{at:?} {bottom}");
                        continue;
                    }
                    let (x, value) = found.expect("a dip");
                    assert!((x - bottom).abs() < 1e-6 && sign * value <= 0.0, "{at:?} {bottom}: {x}");
                }
            }
        }
    }
}
