//! Admissible directions of a state with more positions than rates.

use nalgebra::{DMatrix, SMatrix};

use crate::layout::StateLayout;
use crate::system::System;

/// Number of admissible directions of a state: the number of active components, less the surplus of positions over
/// rates.
pub(super) fn dimension<const N: usize>(system: &(impl System<f64, N> + ?Sized)) -> usize {
    system
        .layout()
        .map_or(system.active(), |layout| dimension_of(layout, system.active()))
}

fn dimension_of(layout: StateLayout<'_>, active: usize) -> usize {
    active - layout.positions() + layout.rates().min(layout.positions())
}

/// Admissible directions of a state as orthonormal columns: first directions of the positions, `q' = K(q) v`, then
/// directions of the rates and of first-order states. `None` if all directions are admissible, since there are no more
/// positions than rates, and no padding.
///
/// Quaternions stay on the unit sphere, and dependent coordinates of closed loops follow the independent ones. `K` is a
/// block of the Jacobian.
pub(super) fn directions<const N: usize>(
    system: &(impl System<f64, N> + ?Sized),
    jacobian: &SMatrix<f64, N, N>,
) -> Option<DMatrix<f64>> {
    directions_of(system.layout()?, system.active(), jacobian)
}

/// [`directions`] of a state with this layout and number of active components.
pub(crate) fn directions_of<const N: usize>(
    layout: StateLayout<'_>,
    active: usize,
    jacobian: &SMatrix<f64, N, N>,
) -> Option<DMatrix<f64>> {
    let (all, positions) = (dimension_of(layout, active), layout.positions());
    if all == N {
        return None;
    }
    let rates = all - (active - positions);
    let by_rates = DMatrix::from_fn(positions, rates, |i, j| jacobian[(i, positions + j)]);
    let along = by_rates.qr().q();
    Some(DMatrix::from_fn(N, all, |i, j| {
        match (i.checked_sub(positions), j.checked_sub(rates)) {
            (None, None) => along[(i, j)],
            (Some(i), Some(j)) => f64::from(u8::from(i == j)),
            _ => 0.0,
        }
    }))
}
