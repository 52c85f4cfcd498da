//! Regulators that act on the estimate of a Kalman filter.

use nalgebra::{SMatrix, SVector};

use super::sampled::Controller;
use super::{ControlError, Estimator, LinearLaw, StateSpace};
use crate::inputs::InputLaw as _;
use crate::real::Float;
use crate::system::IntoState;

/// A controller that estimates the state from `P` outputs by a Kalman filter, and applies a linear law to the estimate:
/// see [`StateSpace::output_feedback`].
///
/// The filter predicts with the command that was sent, so that limits do not mislead it. It assumes that the command
/// acts at once: a delay makes its estimate worse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputFeedback<const N: usize, const M: usize, const P: usize> {
    a: SMatrix<f64, N, N>,
    b: SMatrix<f64, N, M>,
    c: SMatrix<f64, P, N>,
    d: SMatrix<f64, P, M>,
    x0: SVector<f64, N>,
    u0: [f64; M],
    y0: SVector<f64, P>,
    drift: SVector<f64, N>,
    law: LinearLaw<N, M>,
    gain: SMatrix<f64, N, P>,
    guess: SVector<f64, N>,
}

impl<const N: usize, const M: usize, const P: usize> StateSpace<N, M, P> {
    /// Combines a law and a filter for this sampled model to a [`Controller`] of its outputs. The first estimate is the
    /// state of the linearization.
    ///
    /// # Errors
    /// [`ControlError::Continuous`] if the model has no sampling period: [discretize](Self::discretize) it, and design
    /// law and filter with the result.
    pub fn output_feedback(
        &self,
        law: &LinearLaw<N, M>,
        filter: &Estimator<N, P>,
    ) -> Result<OutputFeedback<N, M, P>, ControlError<N>> {
        if self.period.is_none() {
            return Err(ControlError::Continuous);
        }
        Ok(OutputFeedback {
            a: self.a,
            b: self.b,
            c: self.c,
            d: self.d,
            x0: self.x0,
            u0: self.u0,
            y0: self.y0,
            drift: self.drift,
            law: *law,
            gain: filter.gain,
            guess: self.x0,
        })
    }
}

impl<const N: usize, const M: usize, const P: usize> OutputFeedback<N, M, P> {
    /// Sets the estimate of the state before the first measurement.
    #[must_use]
    pub fn guess(mut self, x: impl IntoState<f64, N>) -> Self {
        self.guess = x.into_state();
        self
    }
}

/// Memory of an [`OutputFeedback`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Estimate<T, const N: usize, const M: usize> {
    /// State predicted for the next sample, without its measurement.
    pub x: SVector<T, N>,
    /// Deviation of the inputs sent last from those of the linearization.
    du: SVector<T, M>,
}

impl<T: Float, const N: usize, const M: usize, const P: usize> Controller<T, P, M> for OutputFeedback<N, M, P> {
    type State = Estimate<T, N, M>;

    fn start(&self, _period: T) -> Self::State {
        Estimate {
            x: self.guess.map(T::from_f64),
            du: SVector::from([T::default(); M]),
        }
    }

    fn sample(&self, t: T, measured: &SVector<T, P>, estimate: &mut Self::State) -> [T; M] {
        let z = estimate.x - self.x0.map(T::from_f64);
        let predicted = self.y0.map(T::from_f64) + product(&self.c, &z) + product(&self.d, &estimate.du);
        estimate.x += product(&self.gain, &(measured - predicted));
        self.law.inputs(t, &estimate.x)
    }

    fn sent(&self, _command: &[T; M], sent: &[T; M], estimate: &mut Self::State) {
        estimate.du = SVector::from(*sent) - SVector::from(self.u0.map(T::from_f64));
        let x0 = self.x0.map(T::from_f64);
        let next = product(&self.a, &(estimate.x - x0)) + product(&self.b, &estimate.du);
        estimate.x = x0 + self.drift.map(T::from_f64) + next;
    }
}

/// Product of a matrix of constants and a vector.
fn product<T: Float, const R: usize, const K: usize>(
    matrix: &SMatrix<f64, R, K>,
    vector: &SVector<T, K>,
) -> SVector<T, R> {
    let mut product = SVector::from([T::default(); R]);
    for k in 0..K {
        for (r, entry) in product.iter_mut().enumerate() {
            *entry += T::from_f64(matrix[(r, k)]) * vector[k];
        }
    }
    product
}
