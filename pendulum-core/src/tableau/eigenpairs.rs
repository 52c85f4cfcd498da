//! Eigenvectors of collocation methods, which decouple their equations.

use nalgebra::Complex;

/// An eigenvalue of the matrix `a_ij` of a method with its eigenvectors, normalised to `left . right = 1`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Eigenpair<F, const STAGES: usize> {
    pub(crate) value: F,
    pub(crate) left: [F; STAGES],
    pub(crate) right: [F; STAGES],
}

/// Eigenvalues of a method: complex pairs, and for an odd number of stages a real one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Eigenpairs<const STAGES: usize, const PAIRS: usize> {
    pub(crate) real: Option<Eigenpair<f64, STAGES>>,
    /// The eigenvalues with positive imaginary part.
    pub(crate) pairs: [Eigenpair<Complex<f64>, STAGES>; PAIRS],
}

#[cfg(test)]
impl<const STAGES: usize, const PAIRS: usize> Eigenpairs<STAGES, PAIRS> {
    /// Largest residual of the equations that define the eigenvectors of `a`.
    pub(super) fn residual(&self, a: &[[f64; STAGES]; STAGES]) -> f64 {
        let complex = |x: f64| Complex::new(x, 0.0);
        let real = self.real.map(|Eigenpair { value, left, right }| Eigenpair {
            value: complex(value),
            left: left.map(complex),
            right: right.map(complex),
        });
        let sum = |terms: &dyn Fn(usize) -> Complex<f64>| (0..STAGES).map(terms).sum::<Complex<f64>>();
        let mut residuals = Vec::new();
        for Eigenpair { value, left, right } in self.pairs.into_iter().chain(real) {
            residuals.push(sum(&|j| left[j] * right[j]) - 1.0);
            for i in 0..STAGES {
                residuals.push(sum(&|j| left[j] * a[j][i]) - value * left[i]);
                residuals.push(sum(&|j| right[j] * a[i][j]) - value * right[i]);
            }
        }
        residuals
            .iter()
            .flat_map(|r| [r.re.abs(), r.im.abs()])
            .fold(0.0, f64::max)
    }
}
