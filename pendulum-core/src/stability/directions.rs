//! Admissible directions of a state with more positions than rates.

use nalgebra::{DMatrix, SMatrix};

use crate::system::System;

/// Number of admissible directions of a state: the number of components, or twice the number of rates if there are more
/// positions than rates.
pub(super) fn dimension<const N: usize>(system: &(impl System<f64, N> + ?Sized)) -> usize {
    match system.layout() {
        Some(layout) if 2 * layout.positions() > N => 2 * (N - layout.positions()),
        _ => N,
    }
}

/// Admissible directions of a state as orthonormal columns: first directions of the positions, `q' = K(q) v`, then
/// directions of the rates. `None` if all directions are admissible, since there are no more positions than rates.
///
/// Quaternions stay on the unit sphere, and dependent coordinates of closed loops follow the independent ones. `K` is a
/// block of the Jacobian.
pub(super) fn directions<const N: usize>(
    system: &(impl System<f64, N> + ?Sized),
    jacobian: &SMatrix<f64, N, N>,
) -> Option<DMatrix<f64>> {
    if dimension(system) == N {
        return None;
    }
    let rates = dimension(system) / 2;
    let positions = N - rates;
    let by_rates = DMatrix::from_fn(positions, rates, |i, j| jacobian[(i, positions + j)]);
    let along = by_rates.qr().q();
    Some(DMatrix::from_fn(N, 2 * rates, |i, j| {
        match (i.checked_sub(positions), j.checked_sub(rates)) {
            (None, None) => along[(i, j)],
            (Some(i), Some(j)) => f64::from(u8::from(i == j)),
            _ => 0.0,
        }
    }))
}
