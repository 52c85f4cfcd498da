//! Linear models, regulators and filters against published cases, closed forms and their own equations.

mod discretize;
mod ilqr;
mod lost;
mod published;
mod random;
mod refused;
mod through_switches;

use pendulum_core::nalgebra::{DMatrix, SMatrix};

/// Pseudorandom numbers (SplitMix64).
struct Random(u64);

impl Random {
    /// Number between -1 and 1.
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn matrix<const R: usize, const C: usize>(&mut self) -> SMatrix<f64, R, C> {
        SMatrix::from_fn(|_, _| self.number())
    }

    /// Orthogonal matrix.
    fn rotation<const N: usize>(&mut self) -> SMatrix<f64, N, N> {
        fixed(&dynamic(&self.matrix::<N, N>()).qr().q())
    }
}

fn dynamic<const R: usize, const C: usize>(matrix: &SMatrix<f64, R, C>) -> DMatrix<f64> {
    DMatrix::from_column_slice(R, C, matrix.as_slice())
}

fn fixed<const R: usize, const C: usize>(matrix: &DMatrix<f64>) -> SMatrix<f64, R, C> {
    SMatrix::from_column_slice(matrix.as_slice())
}

fn diagonal<const N: usize>(entries: [f64; N]) -> SMatrix<f64, N, N> {
    SMatrix::from_diagonal(&entries.into())
}
