//! Linear-quadratic regulators.

use nalgebra::{Complex, DMatrix, SMatrix, SVector};

use super::reach::without_idle;
use super::riccati::Problem;
use super::state_space::along;
use super::weights::weights;
use super::{ControlError, StateSpace};
use crate::inputs::InputLaw;
use crate::real::Real;

/// The law that minimizes a quadratic cost, computed by [`StateSpace::lqr`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Regulator<const N: usize, const M: usize> {
    /// The law, for [`with_law`](crate::Controlled::with_law).
    pub law: LinearLaw<N, M>,
    /// The matrix `P` of the cost to go from a deviation `dx`, `dx . P dx`: the solution of the Riccati equation.
    pub cost: SMatrix<f64, N, N>,
    /// Eigenvalues of the closed loop, `A - B K`: in 1/s for a continuous model. Fewer than `N` if the state has more
    /// positions than rates.
    pub eigenvalues: Vec<Complex<f64>>,
}

/// The law `u = u0 - K (x - x0)`, with its gain `K` from anywhere. It works in every number type, so that closed loops
/// have exact Jacobians and run in lanes. It takes angles as they are, without removing full turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearLaw<const N: usize, const M: usize> {
    /// The gain `K`, one row per input.
    pub gain: SMatrix<f64, M, N>,
    /// The state `x0`.
    pub x0: SVector<f64, N>,
    /// The inputs `u0`.
    pub u0: [f64; M],
}

impl<const N: usize, const M: usize> InputLaw<N, M> for LinearLaw<N, M> {
    #[inline(always)]
    fn inputs<T: Real>(&self, _t: T, x: &SVector<T, N>) -> [T; M] {
        let mut inputs = self.u0.map(T::from_f64);
        for n in 0..N {
            let deviation = x[n] - T::from_f64(self.x0[n]);
            for (m, input) in inputs.iter_mut().enumerate() {
                *input -= T::from_f64(self.gain[(m, n)]) * deviation;
            }
        }
        inputs
    }
}

impl<const N: usize, const M: usize, const P: usize> StateSpace<N, M, P> {
    /// Linear-quadratic regulator: the law `u = u0 - K (x - x0)` that minimizes the integral of
    /// `dx . Q dx + du . R du`, or the sum over the samples of a model with a [period](Self::period). The inputs of
    /// such a law have to be held between samples.
    ///
    /// The units of `Q` are those of a cost over squares of the state. Reciprocals of squares of the largest
    /// permissible deviations are a good start (A. E. Bryson, Y.-C. Ho, "Applied Optimal Control" (1975), 5.2).
    ///
    /// The stable subspace of the Hamiltonian matrix (A. J. Laub, IEEE Trans. Autom. Control 24 (1979) 913) gives a
    /// first solution of the Riccati equation, and Newton's method reduces its residual to rounding errors. A sampled
    /// model may have a singular `A`.
    ///
    /// ```
    /// use pendulum_core::control::StateSpace;
    /// use pendulum_core::prelude::*;
    ///
    /// // a mass of 1 kg, pushed: the gain is [1, sqrt(3)]
    /// let mass = StateSpace::new(SMatrix::from([[0.0, 0.0], [1.0, 0.0]]), SMatrix::from([[0.0, 1.0]]));
    /// let regulator = mass.lqr(&SMatrix::identity(), &SMatrix::identity())?;
    /// assert!((regulator.law.gain - SMatrix::from([[1.0], [3.0_f64.sqrt()]])).amax() < 1e-14);
    /// # Ok::<(), pendulum_core::control::ControlError<2>>(())
    /// ```
    ///
    /// # Errors
    /// [`ControlError::NotAtRest`] if the model is not linearized about an equilibrium.
    /// [`ControlError::NotSymmetric`] and [`ControlError::NotPositive`] unless `Q` is symmetric and positive
    /// semidefinite, and `R` is symmetric and positive definite. [`ControlError::Unstabilizable`] with each mode that
    /// does not decay and that no input acts on. [`ControlError::Unweighted`] with each mode on the limit of stability
    /// that does not contribute to the cost. [`ControlError::NotFinite`], [`ControlError::TooLarge`] and
    /// [`ControlError::NoConvergence`].
    pub fn lqr(&self, q: &SMatrix<f64, N, N>, r: &SMatrix<f64, M, M>) -> Result<Regulator<N, M>, ControlError<N>> {
        self.require_finite()?;
        self.require_rest()?;
        let (a, basis) = self.restricted();
        let problem = Problem {
            b: without_idle(&a, &along(&basis, &self.b)),
            a,
            q: basis.transpose() * weights("Q", q, false)? * &basis,
            r: weights("R", r, true)?,
            is_discrete: self.period.is_some(),
        };
        let solution = self.solved(
            &problem,
            &basis,
            [ControlError::Unstabilizable, ControlError::Unweighted],
        )?;
        let (gain, cost): (DMatrix<f64>, DMatrix<f64>) = (
            solution.gain * basis.transpose(),
            &basis * solution.cost * basis.transpose(),
        );
        Ok(Regulator {
            law: LinearLaw {
                gain: SMatrix::from_column_slice(gain.as_slice()),
                x0: self.x0,
                u0: self.u0,
            },
            cost: SMatrix::from_column_slice(cost.as_slice()),
            eigenvalues: solution.eigenvalues,
        })
    }

    /// Rejects a model that drifts away from its state by more than its rounding.
    ///
    /// Each component is compared with its own row, since rows have different units. From sample to sample, the
    /// comparison is of the mean rates over a period.
    fn require_rest(&self) -> Result<(), ControlError<N>> {
        let change = match self.period {
            Some(_) => self.a - SMatrix::identity(),
            None => self.a,
        };
        let excess = |i: usize| {
            let by_state = (0..N)
                .map(|j| change[(i, j)].abs() * (1.0 + self.x0[j].abs()))
                .sum::<f64>();
            let by_inputs = (0..M).map(|m| (self.b[(i, m)] * self.u0[m]).abs()).sum::<f64>();
            self.drift[i].abs() / (AT_REST * (self.period.unwrap_or(1.0) + by_state + by_inputs))
        };
        let Some(index) = (0..N).max_by(|&i, &j| excess(i).total_cmp(&excess(j))) else {
            return Ok(());
        };
        if excess(index) <= 1.0 {
            return Ok(());
        }
        let component = self.names.get(index).cloned();
        Err(ControlError::NotAtRest {
            component: component.unwrap_or_else(|| format!("x[{index}]")),
            rate: self.drift[index],
            period: self.period,
        })
    }
}

/// Rate below which a component counts as at rest: relative to 1 per s, plus its changes by deviations of the size of
/// the state, plus those by the inputs.
const AT_REST: f64 = 1e-6;
