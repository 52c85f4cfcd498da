//! Detection of non-finite results of a step in lanes.

use nalgebra::SVector;

use crate::method::NonFinite;
use crate::real::lanes::Lanes;

/// State at the end of a step.
pub(super) struct End<'a, V, const N: usize> {
    pub(super) x: &'a SVector<V, N>,
    /// Derivative there, if the method computes it, and unless all numbers are finite.
    pub(super) slope: Option<&'a SVector<V, N>>,
    /// [Sum](sum) of both.
    pub(super) sum: V,
}

/// Sum of all components of the state and of its derivative. It is not finite in lanes with a non-finite component.
#[inline(always)]
pub(super) fn sum<V: Lanes, const N: usize>(x: &SVector<V, N>, slope: Option<&SVector<V, N>>) -> V {
    let mut sum = V::default();
    for &x in &x.data.0[0] {
        sum += x;
    }
    if let Some(slope) = slope {
        for &slope in &slope.data.0[0] {
            sum += slope;
        }
    }
    sum
}

/// First non-finite component of the state in a lane, or else of its derivative.
pub(super) fn first_not_finite<V: Lanes, const N: usize>(
    x: &SVector<V, N>,
    slope: Option<&SVector<V, N>>,
    lane: usize,
) -> Option<NonFinite> {
    let mut vectors = [Some(x), slope].into_iter().flatten();
    vectors.find_map(|vector| NonFinite::check(&in_lane(vector, lane)).err())
}

/// Extracts the vector of one lane.
#[inline(always)]
pub(crate) fn in_lane<V: Lanes, const N: usize>(vector: &SVector<V, N>, lane: usize) -> SVector<V::Scalar, N> {
    let mut own = [V::Scalar::default(); N];
    for (own, number) in own.iter_mut().zip(&vector.data.0[0]) {
        *own = number.lane(lane);
    }
    SVector::from(own)
}

/// Replaces the state of a lane.
pub(crate) fn set_lane<V: Lanes, const N: usize>(x: &mut SVector<V, N>, lane: usize, state: &SVector<V::Scalar, N>) {
    set_lanes(x, |other| if other == lane { Some(state) } else { None });
}

/// Replaces the states of those lanes for which there is one.
#[inline(always)]
pub(super) fn set_lanes<'x, V: Lanes, const N: usize>(
    x: &mut SVector<V, N>,
    states: impl Fn(usize) -> Option<&'x SVector<V::Scalar, N>>,
) where
    V::Scalar: 'x,
{
    for (k, x) in x.data.0[0].iter_mut().enumerate() {
        *x = V::from_fn(|lane| match states(lane) {
            Some(state) => state[k],
            None => x.lane(lane),
        });
    }
}
