//! Admissible directions of a state with more positions than rates.

use nalgebra::{DMatrix, SMatrix};

use crate::system::System;

/// Number of admissible directions of a state: the number of active components, less the surplus of positions over
/// rates.
pub(super) fn dimension<const N: usize>(system: &(impl System<f64, N> + ?Sized)) -> usize {
    match system.layout() {
        Some(layout) => system.active() - layout.positions() + layout.rates().min(layout.positions()),
        None => system.active(),
    }
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
    let (all, positions) = (dimension(system), system.layout()?.positions());
    if all == N {
        return None;
    }
    let rates = all - (system.active() - positions);
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
