//! Whether what a step in lanes brings is finite.

use nalgebra::SVector;

use crate::method::NonFinite;
use crate::real::lanes::Lanes;

/// A number that is not finite in the lanes where the state or its derivative is not.
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

/// The first component of the state in a lane, or else of its derivative, that is not finite.
pub(super) fn first_not_finite<V: Lanes, const N: usize>(
    x: &SVector<V, N>,
    slope: Option<&SVector<V, N>>,
    lane: usize,
) -> Option<NonFinite> {
    let mut vectors = [Some(x), slope].into_iter().flatten();
    vectors.find_map(|vector| NonFinite::check(&in_lane(vector, lane)).err())
}

/// The vector of one lane.
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
    for (x, state) in x.iter_mut().zip(state.iter()) {
        *x = V::from_fn(|other| if other == lane { *state } else { x.lane(other) });
    }
}
