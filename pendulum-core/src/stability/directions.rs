//! The directions in which a state can move, where its positions outnumber its rates.

use nalgebra::{DMatrix, SMatrix};

use crate::system::System;

/// The number of directions in which a state can move: as many as it has components, or two for each rate where its positions outnumber
/// its rates.
pub(super) fn dimension<const N: usize>(system: &(impl System<f64, N> + ?Sized)) -> usize {
    match system.layout() {
        Some(layout) if 2 * layout.positions() > N => 2 * (N - layout.positions()),
        _ => N,
    }
}

/// The directions in which a state can move, as orthonormal columns: first those of its positions, `q' = K(q) v`, then those of its rates.
/// None where positions do not outnumber rates, so that it can move in all directions.
///
/// Quaternions move along the unit sphere, and what follows from closed loops moves with the rest. `K` stands in the Jacobian.
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
