//! Zeros and extrema of functions of one variable, and the positions at which they are sampled.

use crate::real::Float;

/// Sampling positions in each step, in fractions of it; the value at the start is available from the step before. The
/// outermost positions show the slope at the ends.
pub(super) const PLACES: [f64; 10] = [0.01, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 0.99, 1.0];
/// First of the additional sampling positions after a reset, in fractions of the step; the others follow in decades. A
/// rebound may return at once.
const FIRST_PLACE: f64 = 1e-15;

/// Error of the cubic, relative to the fall of a function, up to which the function has a single zero.
const MOST_ERROR: f64 = 1.0 / 16.0;
/// Width of an interval, relative to its distance from the start of a step, up to which the bend of a function is
/// neglected.
const LEAST_WIDTH: f64 = 1.0 / 4096.0;
/// Maximum number of evaluations of a function between two positions: one that needs more is noise, or overflows.
const MOST_EVALUATIONS: usize = 1 << 14;

/// Sampling positions of a step; more at the start of the integration.
pub(crate) fn places<T: Float>(starts: bool) -> impl Iterator<Item = T> {
    let mut decade = FIRST_PLACE;
    let decades = core::iter::from_fn(move || {
        let place = decade;
        decade *= 10.0;
        (starts && place < PLACES[0]).then_some(place)
    });
    decades.chain(PLACES).map(T::from_f64)
}

/// Finds a zero of `f` between `from`, where `f` is nonzero, and `to`, where it is zero or of opposite sign; both are
/// pairs of a position and a value. The result lies after the zero, by at most two ulps.
///
/// T. R. Chandrupatla, "A new hybrid quadratic/bisection algorithm for finding the zero of a nonlinear function without
/// using derivatives", Adv. Eng. Softw. 28 (1997) 145-149.
pub(crate) fn root<T: Float>(f: impl Fn(T) -> T, from: (T, T), to: (T, T)) -> T {
    root_from(f, from, to, T::from_f64(0.5))
}

/// Like [`root`], but for an almost linear function: begins at the root of the line through the ends.
pub(crate) fn root_of_line<T: Float>(f: impl Fn(T) -> T, from: (T, T), to: (T, T)) -> T {
    let fraction = to.1 / (to.1 - from.1);
    root_from(f, from, to, fraction.max(T::EPSILON).min(T::from_f64(1.0) - T::EPSILON))
}

/// Like [`root`], but begins at a fraction of the way back from `to`.
#[inline]
fn root_from<T: Float>(f: impl Fn(T) -> T, from: (T, T), to: (T, T), mut fraction: T) -> T {
    let (zero, one, two) = (T::default(), T::from_f64(1.0), T::from_f64(2.0));
    let (mut a, mut b) = (to, from);
    let is_past = |value: T| (value > zero) != (from.1 > zero) || value == zero;
    // bisection alone takes as many steps as a number has bits; the hybrid takes at most a few times as many
    for _ in 0..200 {
        let at = |fraction: T| Some(a.0 + fraction * (b.0 - a.0)).filter(|&place| place != a.0 && place != b.0);
        // bisect if interpolation rounds to an end that is not the zero
        let Some(place) = at(fraction).or_else(|| at(one / two)) else {
            break;
        };
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
        // resolution of numbers near each end
        let resolution = |end: T| (T::EPSILON * end.abs()).max(T::MIN_POSITIVE) / (b.0 - a.0).abs();
        let (least, most) = (resolution(a.0), one - resolution(b.0));
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
        fraction = fraction.max(least).min(most);
    }
    let zero = if is_past(a.1) { a.0 } else { b.0 };
    zero.zero_of(one, f)
}

/// Finds where a function of the same sign at three positions, closest to zero at the middle one, touches or passes
/// zero between them. Returns the position and the value there.
pub(super) fn dip<T: Float>(f: impl Fn(T) -> T, places: [(T, T); 3]) -> Option<(T, T)> {
    let [first, middle, last] = places;
    let zero = T::default();
    let sign = T::from_f64(if middle.1 > zero { 1.0 } else { -1.0 });
    let height = |point: (T, T)| sign * point.1;
    if !(height(middle) < height(first) && height(middle) <= height(last)) {
        return None;
    }
    // the parabola through the three estimates the depth: search only those that come close to zero
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
    // golden-section search, until the value is below zero or the interval too short
    let golden = T::from_f64(0.381_966_011_250_105_1);
    let (mut low, mut best, mut high) = (first.0, middle, last.0);
    while (high - low).abs() > T::EPSILON.sqrt() * (low.abs() + high.abs()) {
        let is_right = high - best.0 > best.0 - low;
        let place = if is_right {
            best.0 + golden * (high - best.0)
        } else {
            best.0 - golden * (best.0 - low)
        };
        let new = (place, f(place));
        if height(new) <= zero {
            return Some(new);
        }
        if height(new) < height(best) {
            *(if is_right { &mut low } else { &mut high }) = best.0;
            best = new;
        } else {
            *(if is_right { &mut high } else { &mut low }) = place;
        }
    }
    None
}

/// First zero of an initially positive function, up to the last of three samples. The first sample may be missing.
/// Values within the noise of zero do not count as a crossing.
#[inline]
pub(crate) fn zero_between<T: Float>(
    function: impl Fn(T) -> T,
    noise: T,
    earlier: Option<(T, T)>,
    [last, here]: [(T, T); 2],
) -> Option<T> {
    let zero = T::default();
    if here.1 < -noise || here.1 <= zero && noise == zero {
        let raised = if last.1 > zero { zero } else { noise };
        let raise = |(theta, value): (T, T)| (theta, value + raised);
        return Some(root(|theta| function(theta) + raised, raise(last), raise(here)));
    }
    let earlier = earlier.filter(|earlier| earlier.1 > zero)?;
    let bottom = dip(&function, [earlier, last, here])?;
    (bottom.1 < -noise || noise == zero).then(|| root(&function, earlier, bottom))
}

/// A position, with the value of a function there and its derivative.
pub(crate) type Known<T> = (T, [T; 2]);

/// Bend of a function that the values and derivatives at the outer two of three positions do not show. It is the
/// deviation of the middle value from their cubic, scaled to cubics over each half and divided by the square of the
/// width of those. Deviations below `noise` may be rounding errors. Positions near the start of a step are skipped:
/// there deviations show only that values and derivatives are inconsistent.
pub(crate) fn unseen_bend<T: Float>([first, middle, last]: [Known<T>; 3], noise: T) -> T {
    let width = last.0 - first.0;
    let part = (middle.0 - first.0) / width;
    let bubble = part * (T::from_f64(1.0) - part);
    let apart = (middle.1[0] - cubic((first, last), part)).abs();
    if apart <= noise || last.0 <= T::from_f64(PLACES[0]) {
        return T::default();
    }
    let error = apart / (T::from_f64(16.0) * bubble * bubble);
    T::from_f64(4.0) * error / (width * width)
}

/// First zero of an initially positive function between two positions. Values within `noise` below zero do not count.
///
/// The function deviates from the cubic through the ends by at most `bend` times the square of the width, as far as
/// samples show. So it is positive if its Bernstein coefficients are, and has one zero if it falls by far more than the
/// deviation. Otherwise the interval is bisected, and `bend` updated.
pub(crate) fn first_zero<T: Float>(
    f: &impl Fn(T) -> [T; 2],
    ends: (Known<T>, Known<T>),
    bend: &mut T,
    noise: T,
) -> Option<T> {
    let mut left = MOST_EVALUATIONS;
    search_halves(f, ends, bend, noise, &mut left)
}

/// Like [`first_zero`], with a limited number of evaluations `left`.
fn search_halves<T: Float>(
    f: &impl Fn(T) -> [T; 2],
    (from, to): (Known<T>, Known<T>),
    bend: &mut T,
    noise: T,
    left: &mut usize,
) -> Option<T> {
    let at = |place: Known<T>| (place.0, place.1[0]);
    let passed = || root(|place| f(place)[0], at(from), at(to));
    let width = to.0 - from.0;
    let error = if width > T::from_f64(LEAST_WIDTH) * to.0 {
        *bend * width * width
    } else {
        T::default()
    };
    let is_short = width <= T::EPSILON.sqrt() * to.0;
    if to.1[0] <= T::default() {
        if is_short || error <= T::from_f64(MOST_ERROR) * (from.1[0] - to.1[0]) + noise {
            return Some(passed());
        }
    } else {
        let tangents = |part: f64| {
            let width = width * T::from_f64(part);
            [from.1[0] + width * from.1[1], to.1[0] - width * to.1[1]]
        };
        // Bernstein coefficients of degree four, including the deviation `error theta^2 (1 - theta)^2 16`
        let ([second, fourth], [left, right]) = (tangents(1.0 / 4.0), tangents(1.0 / 3.0));
        let third = T::from_f64(0.5) * (left + right) - T::from_f64(8.0 / 3.0) * error;
        if is_short || second.min(third).min(fourth) >= -noise {
            return None;
        }
    }
    let place = from.0 + T::from_f64(0.5) * width;
    let middle = (place, f(place));
    *bend = bend.max(unseen_bend([from, middle, to], noise));
    let is_finite = bend.is_finite() && middle.1.iter().all(|number| number.is_finite());
    if !is_finite || middle.0 == from.0 {
        return None;
    }
    if *left == 0 {
        return (to.1[0] <= T::default()).then(passed);
    }
    *left -= 1;
    search_halves(f, (from, middle), bend, noise, left).or_else(|| search_halves(f, (middle, to), bend, noise, left))
}

/// Value of the cubic through two positions with their derivatives, at a fraction of the way between them.
fn cubic<T: Float>((from, to): (Known<T>, Known<T>), part: T) -> T {
    let (rest, width) = (T::from_f64(1.0) - part, to.0 - from.0);
    let (three, two) = (T::from_f64(3.0), T::from_f64(2.0));
    let ([start, falls], [end, rises]) = (from.1, to.1);
    rest * rest * (start * (three - two * rest) + width * falls * part)
        + part * part * (end * (three - two * part) - width * rises * rest)
}

#[cfg(test)]
mod tests {
    use std::cell::{Cell, RefCell};
    use std::f64::consts::PI;

    use super::{MOST_EVALUATIONS, dip, first_zero, root, root_of_line, unseen_bend};

    /// Root of `f` between 0 and 1, or between 1 and 0 in reverse, and the evaluated positions.
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
        // backward it lies before the zero
        let (x, places) = search(f, (1.0, 0.0));
        assert!(f(x) >= 0.0 && f(x.next_up().next_up()) <= 0.0, "{x:e}");
        assert!(places.len() < 14, "{}", places.len());
        // steep, flat, and discontinuous functions
        let (x, _) = search(|x| x.powi(9) - 1e-9, (0.0, 1.0));
        assert!((x - 0.1).abs() < 1e-15);
        let (x, places) = search(|x| if x < 0.3 { -1.0 } else { 1.0 }, (0.0, 1.0));
        assert!((0.3..0.3_f64.next_up().next_up()).contains(&x));
        assert!(places.len() < 60, "{}", places.len());
    }

    #[test]
    fn where_the_inverse_is_a_parabola_the_third_place_is_the_root() {
        // x = (y + c)^2 - 1: bisection first, then interpolation of the inverse, which is exact
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
    fn what_is_almost_a_line_is_found_in_a_few_places() {
        for zero in [1e-9, 1e-3, 0.3, 0.999] {
            for bend in [0.0, 1e-6, -1e-3, 0.2] {
                let count = Cell::new(0);
                let f = |x: f64| {
                    count.set(count.get() + 1);
                    (x - zero) * (1.0 + bend * x)
                };
                let found = root_of_line(f, (0.0, f(0.0)), (1.0, f(1.0)));
                assert!(
                    (found - zero).abs() <= 1e-15 && found >= zero,
                    "{zero} {bend}: {found:e}"
                );
                let most = if bend.abs() < 0.1 { 8 } else { 12 };
                assert!(count.get() <= most, "{zero} {bend}: {}", count.get());
            }
        }
    }

    #[test]
    fn where_interpolation_would_mislead_it_halves() {
        // Chandrupatla's criterion for the ends, the middle and xi = 1/2: interpolate if phi lies between 1 - sqrt(1/2)
        // and sqrt(1/2). phi is the rise from the end beyond the zero to the middle, over the rise to the other end.
        let second = |[first, middle, last]: [f64; 3]| {
            let f = move |x: f64| match x {
                0.0 => first,
                1.0 => last,
                _ => x - 0.5 + middle,
            };
            let places = search(f, (0.0, 1.0)).1;
            assert_eq!(places[0], 0.5);
            places[1]
        };
        for (phi, middle) in [(0.715, 0.43), (0.95, 0.9), (0.7, 0.4), (0.6, 0.2)] {
            let halves = phi > 0.5_f64.sqrt();
            // from -1 to 1 through a middle on either side of zero
            assert_eq!(second([-1.0, middle, 1.0]) == 0.25, halves, "{middle}");
            assert_eq!(second([-1.0, -middle, 1.0]) == 0.75, halves, "{middle}");
        }
        for (phi, middle) in [(0.28, 0.208), (0.14, 0.054), (0.3, 0.23), (0.4, 0.34)] {
            let halves = phi < 1.0 - 0.5_f64.sqrt();
            // from -0.1 to 1, and reversed
            assert_eq!(second([-0.1, middle, 1.0]) == 0.25, halves, "{middle}");
            assert_eq!(second([-1.0, -middle, 0.1]) == 0.75, halves, "{middle}");
        }
        // Lagrange's parabola x(y) through (-1, 0), (middle, 1/2), (1, 1) at y = 0: the last two terms
        for middle in [0.41, 0.2, -0.2, -0.41_f64] {
            let expected = -0.5 / (middle * middle - 1.0) + middle / (2.0 * (middle - 1.0));
            let found = second([-1.0, middle, 1.0]);
            assert!((found - expected).abs() < 1e-15, "{middle}: {found} {expected}");
        }
    }

    #[test]
    fn roots_are_bracketed_to_two_ulps_whatever_the_function() {
        let functions: [fn(f64, f64) -> f64; 11] = [
            |x, zero| x - zero,
            |x, zero| (x - zero) * 1e-300,
            |x, zero| x.exp() - zero.exp(),
            |x, zero| x * x * x - zero * zero * zero,
            |x, zero| (x - zero).cbrt(),
            |x, zero| (x - zero).powi(3),
            |x, zero| (1e3 * (x - zero)).tanh(),
            |x, zero| if x < zero { -1.0 } else { 1e-9 },
            |x, zero| if x < zero { 1e-9 * (x - zero) } else { x - zero },
            |x, zero| if x < zero { x - zero } else { 1e-9 * (x - zero) },
            |x, zero| (x - zero) * (1.0 + 1e6 * (x - zero).powi(2)),
        ];
        for (index, f) in functions.into_iter().enumerate() {
            for zero in [0.3, 0.5, 0.123_456_789, 0.999, 1e-3, 1e-9] {
                for sign in [1.0, -1.0] {
                    for (from, to) in [(0.0, 1.0), (1.0, 0.0), (-0.5, 1.0)] {
                        let g = |x: f64| sign * f(x, zero);
                        let (x, places) = search(g, (from, to));
                        let what = format!("{index} {zero} {sign} {from} {to}: {x:e} {places:?}");
                        let two_before = if from < to {
                            x.next_down().next_down()
                        } else {
                            x.next_up().next_up()
                        };
                        let is_past = |x: f64| (g(x) > 0.0) != (g(from) > 0.0) || g(x) == 0.0;
                        assert!(is_past(x), "{what}");
                        assert!(!is_past(two_before) || g(two_before) == 0.0 || g(x) == 0.0, "{what}");
                        // bisection alone takes some 52 from 1 on, and 30 more from 1e-9 on; at most every other
                        // evaluation bisects
                        assert!(places.len() <= 170, "{what}");
                        let inside = places.iter().all(|x| (from.min(to)..=from.max(to)).contains(x));
                        assert!(inside, "{what}");
                    }
                }
            }
        }
        // a straight line needs the middle, its zero, and a point beyond the zero, whatever the length
        for (from, to) in [(0.5, 0.5 + 1e-6), (1000.0, 1e6), (0.3, 0.4)] {
            let zero = from + 0.3 * (to - from);
            let (_, places) = search(|x| x - zero, (from, to));
            assert!(places.len() <= 6, "{from} {to}: {places:?}");
        }
        // a straight line, whose zero is far closer to 0 than the ends
        let (x, places) = search(|x| x - 1e-30, (-0.5, 1.0));
        assert!(
            (x / 1e-30 - 1.0).abs() < 1e-15 && places.len() <= 10,
            "{x:e} {places:?}"
        );
    }

    #[test]
    fn between_neighbours_there_is_nothing_to_look_at() {
        let (from, to) = (1.0, 1.0_f64.next_up());
        for (from, to) in [(from, to), (to, from)] {
            let (x, places) = search(
                |x| x - f64::midpoint(1.0, 1.0_f64.next_up()) + if x > 1.0 { 1e-20 } else { -1e-20 },
                (from, to),
            );
            assert_eq!((x, places.len()), (to, 0));
        }
    }

    #[test]
    fn between_places_two_ulps_apart_there_is_one_to_look_at() {
        // the middle of the first four is the last position before the zero
        let from = 1.0 - 2.0 * f64::EPSILON;
        let to = 1.0 + 2.0 * f64::EPSILON;
        let middle = 1.0 + f64::EPSILON;
        let (x, places) = search(|x| if x > 1.0 { 1.0 } else { -1.0 }, (from, to));
        assert_eq!((x, &places[..]), (middle, &[1.0, middle][..]));
    }

    #[test]
    fn an_end_that_is_zero_is_the_root() {
        let (x, places) = search(|x| x - 1.0, (0.0, 1.0));
        assert_eq!((x, places.len() < 56), (1.0, true), "{places:?}");
        let (x, places) = search(|x| x - 0.5, (0.0, 1.0));
        assert_eq!((x, &places[..]), (0.5, &[0.5][..]));
        // zero from some position on
        let (x, places) = search(|x| (x - 0.3).min(0.0), (0.0, 1.0));
        assert_eq!((x, &places[..]), (0.5, &[0.5][..]));
    }

    #[test]
    fn a_root_at_zero_is_found_in_bounded_time() {
        let (x, places) = search(|x| if x > 0.0 { 1.0 } else { -1.0 }, (-1e-3, 1.0));
        assert!(x > 0.0 && x < 1e-15, "{x:e} after {}", places.len());
        assert!(places.len() <= 200);
    }

    /// Uses exact arithmetic or roundings common to all machines. The sum reveals one interpolation more or less, and
    /// an interpolation too close to an end to be distinguished from it.
    #[test]
    fn where_a_slope_changes_the_evaluations_are_counted() {
        let mut sum = 0;
        for zero in [0.3, 0.123_456_789, 0.77, 0.999, 1e-3, 1e-9, 0.999_999_9] {
            let bent = |x: f64| if x < zero { x - zero } else { 2.0 * (x - zero) };
            for (from, to) in [
                (0.0, 1.0),
                (1.0, 0.0),
                (-0.5, 1.0),
                (zero - 1e-6, zero + 3e-6),
                (zero - 3e-6, zero + 1e-7),
            ] {
                sum += search(bent, (from, to)).1.len();
            }
        }
        assert_eq!(sum, 495);
    }

    /// Result of a search for a dip, and the evaluated positions.
    fn look(f: impl Fn(f64) -> f64, at: [f64; 3]) -> (Option<(f64, f64)>, Vec<f64>) {
        let places = RefCell::new(Vec::new());
        let watched = |x: f64| {
            places.borrow_mut().push(x);
            f(x)
        };
        let found = dip(watched, at.map(|x| (x, f(x))));
        (found, places.into_inner())
    }

    /// Positions whose middle one is, or is not, the closest to 0.57, 0.53 and 0.61.
    const AT: [[f64; 3]; 7] = [
        [0.1, 0.5, 1.0],
        [0.1, 0.6, 1.0],
        [0.1, 0.55, 0.7],
        [0.4, 0.54, 1.0],
        [0.1, 0.1001, 2.0],
        [0.58, 0.7, 1.0],
        [-0.3, 0.1, 0.5],
    ];

    #[test]
    fn a_dip_is_found_where_it_passes_zero_only() {
        for (sign, at, bottom) in [1.0, -1.0]
            .into_iter()
            .flat_map(|sign| AT.map(|at| (sign, at)))
            .flat_map(|(sign, at)| [0.57, 0.53, 0.61].map(|bottom| (sign, at, bottom)))
        {
            let f = |height: f64| move |x: f64| sign * ((x - bottom) * (x - bottom) + height);
            let [first, middle, last] = at.map(|x: f64| (x - bottom).abs());
            let is_lowest = middle < first && middle <= last;
            for height in [1e-12, -1e-12] {
                let (found, places) = look(f(height), at);
                assert_eq!(places.is_empty(), !is_lowest, "{at:?} {bottom}: {places:?}");
                assert!(
                    places.iter().all(|&x| at[0] < x && x < at[2]),
                    "{at:?} {bottom}: {places:?}"
                );
                // golden section: from 2 to 1e-8 in 40 steps
                assert!(places.len() <= 42, "{at:?} {bottom}: {places:?}");
                if is_lowest && height < 0.0 {
                    let (x, value) = found.expect("a dip");
                    assert!(
                        (x - bottom).abs() <= 1.001e-6 && sign * value <= 0.0,
                        "{at:?} {bottom}: {x}"
                    );
                    assert_eq!((places.last(), value), (Some(&x), f(height)(x)));
                } else {
                    assert!(found.is_none(), "{at:?} {bottom}");
                }
            }
        }
    }

    #[test]
    fn a_dip_is_searched_where_a_parabola_goes_down_by_a_quarter_of_the_height() {
        // the parabola goes down by apart^2 below the middle position, which is `apart` from its bottom
        for at in AT {
            for apart in [0.01, -0.01, 0.1, -0.1_f64] {
                let bottom = at[1] + apart;
                let [first, middle, last] = at.map(|x: f64| (x - bottom).abs());
                if middle >= first || middle > last {
                    continue;
                }
                for (quarters, searches) in [(2.9, true), (3.1, false), (100.0, false)] {
                    let (found, places) = look(|x| 3.0 * ((x - bottom).powi(2) + quarters * apart.powi(2)), at);
                    assert!(found.is_none());
                    assert_eq!(!places.is_empty(), searches, "{at:?} {apart} {quarters}");
                }
            }
        }
        // from 0.9 to 3e-5, the distance at which squares distinguish positions near 1000
        let (found, places) = look(|x| (x - 1000.57).powi(2) + 1e-9, [1000.1, 1000.5, 1001.0]);
        assert!(found.is_none() && (20..=24).contains(&places.len()), "{}", places.len());
        // level, or with the lowest position at an end
        assert!(look(|_| 1.0, [0.0, 0.5, 1.0]).1.is_empty());
        assert!(look(|x| x.max(0.5), [0.0, 0.5, 1.0]).1.is_empty());
        assert!(look(|x| 2.0 - x, [0.0, 0.5, 1.0]).1.is_empty());
    }

    /// Evaluated positions for given values of a function at three positions, and 1/2 at all others.
    fn look_beside(places: [f64; 3], values: [f64; 3]) -> Vec<f64> {
        let at = |x| places.iter().position(|&place| place == x);
        look(|x| at(x).map_or(0.5, |index| values[index]), places).1
    }

    #[test]
    fn ties_are_settled() {
        // the parabola through 3/2, 1/2 and 7/2 goes down by 1/8, which is a quarter of 1/2; of equal parts the left
        // one is divided, and of equal values the old one is the best: the right part is longer then
        let golden = 0.381_966_011_250_105_1;
        let values = [1.5, 0.5, 3.5];
        let places = look_beside([0.0, 0.5, 1.0], values);
        assert_eq!(places[..2], [0.5 - golden * 0.5, 0.5 + golden * 0.5]);
        // the length over the sum of the sizes of the ends is 2^-26 in the first case, the square root of the precision
        let short = f64::EPSILON.sqrt();
        assert!(look_beside([1.0 - short, 1.0, 1.0 + short], values).is_empty());
        let longer = 2.0 * short;
        assert!(!look_beside([1.0 - longer, 1.0, 1.0 + longer], values).is_empty());
    }

    #[test]
    fn the_longer_part_is_divided_by_the_golden_section() {
        let golden = (3.0 - 5.0_f64.sqrt()) / 2.0;
        let valley = |bottom: f64| move |x: f64| (x - bottom).powi(2) + 1e-3;
        for (at, bottom, expected) in [
            // to the right of the middle, which stays the lowest, then to its left
            ([0.0, 0.4, 1.0], 0.43, [0.4 + golden * 0.6, 0.4 - golden * 0.4]),
            // to the left, where it is lower, then left of that, in the longer part
            (
                [0.0, 0.6, 1.0],
                0.38,
                [0.6 - golden * 0.6, 0.6 - golden * 0.6 - golden * (0.6 - golden * 0.6)],
            ),
        ] {
            let (_, places) = look(valley(bottom), at);
            for (place, expected) in places.iter().zip(expected) {
                assert!(
                    (place - expected).abs() < 1e-14,
                    "{at:?} {bottom}: {places:?} {expected}"
                );
            }
            let last = places.last().expect("a search");
            assert!((last - bottom).abs() < 1e-7, "{last}");
        }
    }

    /// Given its bend, the first of many zeros of a function is found.
    #[test]
    fn of_many_zeros_the_first_is_found() {
        for (turns, height) in [0.7, 1.0, 3.3, 8.0, 8.1, 50.0, 150.7].into_iter().flat_map(|turns| {
            let heights = [1.01, 1.5, 3.0, 7.0];
            heights.map(|height| (turns, height))
        }) {
            for phase in (0..12).map(|n| f64::from(n) * PI / 6.0) {
                // a wave on a curve that falls by eight
                let f = |x: f64| {
                    let angle = 2.0 * PI * turns * x + phase;
                    [
                        height - 8.0 * x * x - angle.sin(),
                        -16.0 * x - 2.0 * PI * turns * angle.cos(),
                    ]
                };
                let at = |x: f64| (x, f(x));
                let first = (1..)
                    .map(|n| f64::from(n) * 1e-5)
                    .find(|&x| f(x)[0] <= 0.0)
                    .expect("a zero");
                // an eighth of the second derivative of the wave
                let mut bend = (2.0 * PI * turns).powi(2) / 8.0;
                let found = first_zero(&f, (at(0.0), at(1.0)), &mut bend, 1e-15).expect("a zero");
                assert!(
                    (found - first).abs() < 2e-5,
                    "{turns} {height} {phase}: {found}, not {first}"
                );
            }
        }
    }

    /// A method far beyond its stability limit gives such noise shortly before its numbers overflow.
    #[test]
    fn a_search_among_noise_ends() {
        let count = Cell::new(0);
        let noise = |x: f64| {
            count.set(count.get() + 1);
            let fall = if x == 1.0 { 3.0 } else { 0.0 };
            [1.01 + (1e18 * x).sin() - fall, 1e100 * (1e18 * x).cos()]
        };
        for (end, passes) in [(0.999, false), (1.0, true)] {
            count.set(0);
            let ends = [0.25, end].map(|place| (place, noise(place)));
            let found = first_zero(&noise, ends.into(), &mut 1.0, 1e-15);
            assert!(count.get() <= MOST_EVALUATIONS + 200, "{}", count.get());
            assert_eq!(found.is_some(), passes, "{found:?}");
        }
    }

    #[test]
    fn values_and_derivatives_show_zeros_between_places() {
        let search = |f: &dyn Fn(f64) -> [f64; 2], first: Option<f64>| {
            let [middle, last] = [0.5, 1.0].map(|place| (place, f(place)));
            let Some(first) = first.map(|place| (place, f(place))) else {
                return first_zero(&f, (middle, last), &mut 0.0, 1e-15);
            };
            let mut bend = unseen_bend([first, middle, last], 1e-15);
            let mut between = |from, to| first_zero(&f, (from, to), &mut bend, 1e-15);
            between(first, middle).or_else(|| between(middle, last))
        };
        // both sides of a dip are sampled, and the lowest value is at neither of them
        for (depth, zero) in [(1e-9, Some(0.7 - 1e-9_f64.sqrt())), (-1e-9, None)] {
            let dip = |x: f64| [(x - 0.7) * (x - 0.7) - depth, 2.0 * (x - 0.7)];
            for first in [None, Some(0.0)] {
                let found = search(&dip, first);
                assert_eq!(found.is_some(), zero.is_some());
                assert!(found.zip(zero).is_none_or(|(found, zero)| (found - zero).abs() < 1e-10));
            }
        }
        // the value in the middle shows that the function is not the cubic through the others
        let wave = |x: f64| {
            let (once, twice) = (2.0 * PI * x, 4.0 * PI * x);
            let slope = -1.2 * PI * once.sin() - 4.0 * PI * twice.sin();
            [1.0 + 0.6 * once.cos() + twice.cos(), slope]
        };
        let found = search(&wave, Some(0.0)).expect("a zero");
        assert!(wave(found)[0].abs() < 1e-14, "{found}");
    }
}
