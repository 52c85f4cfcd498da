//! Kalman filters.

use nalgebra::{Complex, DMatrix, SMatrix};

use super::reach::without_idle;
use super::riccati::Problem;
use super::state_space::along;
use super::weights::weights;
use super::{ControlError, StateSpace};

/// The stationary Kalman filter of a linear model, computed by [`StateSpace::kalman`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Estimator<const N: usize, const P: usize> {
    /// The gain `L`, one column per output. With the estimate `z` of `x - x0`, and the output `e = y0 + C z + D du`
    /// that it predicts:
    ///
    /// | | estimate |
    /// |---|---|
    /// | continuous | `z' = A z + B du + drift + L (y - e)` |
    /// | sampled | correction by the measurement, `z + L (y - e)`; prediction for the next, `A z + B du + drift` |
    pub gain: SMatrix<f64, N, P>,
    /// Covariance of the error of the estimate; for a sampled model, of the prediction, before the correction.
    pub covariance: SMatrix<f64, N, N>,
    /// Eigenvalues of the error: of `A - L C`, or `A - A L C` for a sampled model.
    pub eigenvalues: Vec<Complex<f64>>,
}

impl<const N: usize, const M: usize, const P: usize> StateSpace<N, M, P> {
    /// Stationary Kalman filter for the process noise `W` and the measurement noise `V`: symmetric matrices of spectral
    /// densities for a continuous model, and of covariances per sample for a sampled one.
    ///
    /// The Riccati equation is that of [`lqr`](Self::lqr) for `A^T`, `C^T`, `W` and `V` (R. E. Kalman, R. S. Bucy,
    /// J. Basic Eng. 83 (1961) 95).
    ///
    /// # Errors
    /// [`ControlError::NotSymmetric`] and [`ControlError::NotPositive`] unless `W` is symmetric and positive
    /// semidefinite, and `V` is symmetric and positive definite. [`ControlError::Undetectable`] with each mode that
    /// does not decay and that no output shows. [`ControlError::Undisturbed`] with each mode on the limit of stability
    /// that the noise does not drive. [`ControlError::NotFinite`], [`ControlError::TooLarge`] and
    /// [`ControlError::NoConvergence`].
    pub fn kalman(&self, w: &SMatrix<f64, N, N>, v: &SMatrix<f64, P, P>) -> Result<Estimator<N, P>, ControlError<N>> {
        self.require_finite()?;
        let (a, basis) = self.restricted();
        let problem = Problem {
            b: without_idle(&a.transpose(), &along(&basis, &self.c.transpose())),
            a: a.transpose(),
            q: basis.transpose() * weights("W", w, false)? * &basis,
            r: weights("V", v, true)?,
            is_discrete: self.period.is_some(),
        };
        let solution = self.solved(
            &problem,
            &basis,
            [ControlError::Undetectable, ControlError::Undisturbed],
        )?;
        let gain = if self.period.is_some() {
            let shown = problem.b.transpose() * &solution.cost;
            let innovation = (&shown * &problem.b + &problem.r).cholesky();
            let innovation = innovation.ok_or(ControlError::NoConvergence { residual: f64::NAN })?;
            innovation.solve(&shown).transpose()
        } else {
            solution.gain.transpose()
        };
        let (gain, covariance): (DMatrix<f64>, DMatrix<f64>) =
            (&basis * gain, &basis * solution.cost * basis.transpose());
        Ok(Estimator {
            gain: SMatrix::from_column_slice(gain.as_slice()),
            covariance: SMatrix::from_column_slice(covariance.as_slice()),
            eigenvalues: solution.eigenvalues,
        })
    }
}
