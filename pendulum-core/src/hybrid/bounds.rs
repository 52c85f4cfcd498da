//! Bounds of the polynomials of a step.

use nalgebra::SVector;

use super::Constraint;
use super::fired::FORWARD;
#[cfg(feature = "std")]
use super::fired::{BACKWARD, UPPER, WAYS};
#[cfg(feature = "std")]
use super::{Law, MOST};
use crate::method::MAX_DEGREE;
use crate::real::lanes::Lanes;
use crate::taylor::MAX_ORDER;

/// Bounds of polynomials have this part of all their terms to spare.
const SLACK: f64 = 1e-4;

/// What a step in lanes leaves of each function of [`Watch::look`](super::Watch::look), at least, in a mode in which
/// nothing is held: where all of a lane are positive, its mode does not end. All rates are sums of components of the
/// state.
#[cfg(feature = "std")]
#[inline(always)]
pub(crate) fn room<V: Lanes, const N: usize>(
    (constraints, laws): (&[Constraint], &[Law<V>; MOST]),
    measures: &[[V; 2]; MOST],
    terms: &[SVector<V, N>],
) -> [[V; WAYS]; MOST] {
    let one = V::from_f64(1.0);
    let mut room = [[one; WAYS]; MOST];
    for (n, constraint) in constraints.iter().enumerate() {
        let [value, rate] = measures[n];
        let least = |way, value, sign| least((value, sign), (constraint, way), terms);
        room[n] = [
            least(FORWARD, rate.abs(), rate.signum()),
            laws[n].low.map_or(one, |low| least(BACKWARD, value - low, one)),
            laws[n].high.map_or(one, |high| least(UPPER, high - value, -one)),
        ];
    }
    room
}

/// What a function of a step stays above: a value, and `sign` times a sum of components of the state, of the polynomial
/// `x0 + c_1 theta + c_2 theta^2 + ..`. It is the least of the coefficients in the basis of Bernstein, between which a
/// polynomial lies (G. Farin, "Curves and Surfaces for CAGD" 2002, Sec. 5.1), less what rounding errors may do.
#[inline(always)]
pub(super) fn least<V: Lanes, const N: usize>(
    (value, sign): (V, V),
    (constraint, way): (&Constraint, usize),
    terms: &[SVector<V, N>],
) -> V {
    if terms.len() <= MAX_DEGREE {
        least_of::<V, N, { MAX_DEGREE + 1 }>((value, sign), (constraint, way), terms)
    } else {
        least_of::<V, N, { MAX_ORDER + 1 }>((value, sign), (constraint, way), terms)
    }
}

/// [`least`] of a polynomial of so many coefficients at most.
#[inline(always)]
fn least_of<V: Lanes, const N: usize, const MOST_TERMS: usize>(
    (value, sign): (V, V),
    (constraint, way): (&Constraint, usize),
    terms: &[SVector<V, N>],
) -> V {
    let degree = terms.len();
    let back = if way == FORWARD { 0 } else { N / 2 };
    let mut sums = [V::default(); MOST_TERMS];
    sums[0] = value;
    let (mut size, mut choices) = (V::default(), 1.0);
    for (power, term) in terms.iter().enumerate() {
        let mut change = V::default();
        for &(component, its) in constraint.rate {
            change += term[component - back] * V::from_f64(f64::from(its));
        }
        // over the number of ways to choose so many of all
        choices *= (degree - power) as f64 / (power + 1) as f64;
        sums[power + 1] = sign * change * V::from_f64(1.0 / choices);
        size += change.abs();
    }
    let mut least = value;
    for first in 0..degree {
        for n in (first..degree).rev() {
            let sum = sums[n];
            sums[n + 1] += sum;
        }
        least = (least - sums[first + 1]).select(least, sums[first + 1]);
    }
    least - size * V::from_f64(SLACK)
}
