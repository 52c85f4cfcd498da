//! Linear models of mechanisms.

use nalgebra::{DMatrix, SMatrix, SVector};

use super::exponential::held;
use super::reach::{Mode, margins, unreached, without_idle};
use super::riccati::{Obstacle, Problem, Solution};
use super::{ControlError, LostModes, ModeMargin, PbhTest};
use crate::constraint::MAX_CONSTRAINTS;
use crate::dual::Dual;
use crate::inputs::Controlled;
use crate::layout::StateLayout;
use crate::stability::directions_of;
use crate::system::{ActsWith, IntoState};

/// A linear model of a state of `N` components with `M` inputs and `P` outputs, for small deviations from a state `x0`
/// with the inputs `u0`:
///
/// | continuous | with a [period](Self::period) |
/// |---|---|
/// | `dx' = A dx + B du + drift` | `dx+ = A dx + B du + drift` |
/// | `y = y0 + C dx + D du` | `y = y0 + C dx + D du` |
///
/// [`linearize`] computes it from a mechanism, and [`new`](Self::new) takes matrices.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct StateSpace<const N: usize, const M: usize, const P: usize = 0> {
    /// Derivative of the rates, or of the next state, with respect to the state.
    pub a: SMatrix<f64, N, N>,
    /// Derivative of the rates, or of the next state, with respect to the inputs.
    pub b: SMatrix<f64, N, M>,
    /// Derivative of the outputs with respect to the state.
    pub c: SMatrix<f64, P, N>,
    /// Derivative of the outputs with respect to the inputs.
    pub d: SMatrix<f64, P, M>,
    /// State about which the model is linearized.
    pub x0: SVector<f64, N>,
    /// Inputs at this state.
    pub u0: [f64; M],
    /// Outputs at this state.
    pub y0: SVector<f64, P>,
    /// Rates at this state, or change from sample to sample: zero at an equilibrium.
    pub drift: SVector<f64, N>,
    /// Sampling period in s; `None` for a continuous model.
    pub period: Option<f64>,
    /// Time of the linearization.
    pub(super) t: f64,
    pub(super) names: Vec<String>,
    /// Orthonormal columns: admissible directions of the state, all of them if `None`.
    pub(super) basis: Option<DMatrix<f64>>,
}

/// Linearizes a model with inputs about the state `x` with the inputs `u` at the time `t`, by its generated
/// derivatives. Use [`with_outputs`](StateSpace::with_outputs) to add outputs.
///
/// Dry friction and contacts are left out, as in [`equilibrium`](crate::stability::equilibrium). Where a state has more
/// positions than rates, as with quaternions and some closed loops, controllers and tests are restricted to admissible
/// directions.
///
/// ```
/// use pendulum_core::control::linearize;
/// use pendulum_core::prelude::*;
///
/// mechanism! {
///     pub CartPole {
///         input push: N,
///         gravity: [0, -9.81, 0],
///         body slider on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: push }
///         body rod on slider {
///             solids: [rod(0.2, [0, 0, 0], [0, 0.6, 0])], joint: revolute(z), coordinate: theta,
///         }
///         point tip on rod at [0, 0.6, 0],
///         output tip: tip,
///     }
/// }
///
/// let model = CartPole::new(CartPoleParams {})?;
/// let dual = model.cast();
/// let upright = linearize(&model, 0.0, [0.0; 4], [0.0])?.with_outputs(|t, x, _u| [dual.tip(t, x)[0]]);
/// assert!((upright.c[CartPole::THETA] + 0.6).abs() < 1e-15);
/// assert!(upright.controllability()?.is_complete() && upright.observability()?.is_complete());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ControlError::NotFinite`] if the state, an input, the right-hand side or a derivative is not finite,
/// [`ControlError::TooLarge`] if the square of a derivative is not.
pub fn linearize<S, const N: usize, const M: usize>(
    model: &S,
    t: f64,
    x: impl IntoState<f64, N>,
    u: impl Into<S::Inputs>,
) -> Result<StateSpace<N, M>, ControlError<N>>
where
    S: Controlled<f64, N, M>,
{
    let (x0, inputs) = (x.into_state(), u.into());
    let given = S::Given::with(inputs, &[0.0; MAX_CONSTRAINTS]);
    let (drift, a) = model.eval_with_jacobian(t, &x0, &given);
    let mut linear = StateSpace::new(a, model.input_jacobian(t, &x0, &inputs));
    (linear.x0, linear.u0, linear.drift, linear.t) = (x0, inputs.into(), drift, t);
    linear.require_finite()?;
    linear.names = model.layout().as_ref().map(StateLayout::components).unwrap_or_default();
    linear.basis = model.layout().and_then(|layout| directions_of(layout, N, &a));
    Ok(linear)
}

impl<const N: usize, const M: usize> StateSpace<N, M> {
    /// The continuous model `x' = A x + B u` without outputs.
    #[must_use]
    pub fn new(a: SMatrix<f64, N, N>, b: SMatrix<f64, N, M>) -> Self {
        Self {
            a,
            b,
            c: SMatrix::zeros(),
            d: SMatrix::zeros(),
            x0: SVector::zeros(),
            u0: [0.0; M],
            y0: SVector::zeros(),
            drift: SVector::zeros(),
            period: None,
            t: 0.0,
            names: Vec::new(),
            basis: None,
        }
    }

    /// The model `x+ = A x + B u` from sample to sample, without outputs.
    ///
    /// # Errors
    /// [`ControlError::Period`] if the period is not positive and finite.
    pub fn sampled(a: SMatrix<f64, N, N>, b: SMatrix<f64, N, M>, period: f64) -> Result<Self, ControlError<N>> {
        let period = Some(require_period(period)?);
        Ok(Self {
            period,
            ..Self::new(a, b)
        })
    }
}

impl<const N: usize, const M: usize, const P: usize> StateSpace<N, M, P> {
    /// Replaces the outputs by `outputs(t, x, u)`, a function of dual numbers: points and energies of `model.cast()`,
    /// components of the state, inputs. Its derivatives are exact to rounding errors.
    #[must_use]
    pub fn with_outputs<const Q: usize>(
        self,
        outputs: impl Fn(Dual<f64, 1>, &SVector<Dual<f64, 1>, N>, &[Dual<f64, 1>; M]) -> [Dual<f64, 1>; Q],
    ) -> StateSpace<N, M, Q> {
        let constant = self.x0.map(Dual::constant);
        let given = self.u0.map(Dual::constant);
        let t = Dual::constant(self.t);
        let (mut c, mut d) = (SMatrix::<f64, Q, N>::zeros(), SMatrix::<f64, Q, M>::zeros());
        for n in 0..N {
            let mut x = constant;
            x[n] = Dual::variable(self.x0[n], 0);
            c.set_column(n, &outputs(t, &x, &given).map(|y| y.slopes[0]).into());
        }
        for m in 0..M {
            let mut u = given;
            u[m] = Dual::variable(self.u0[m], 0);
            d.set_column(m, &outputs(t, &constant, &u).map(|y| y.slopes[0]).into());
        }
        let y0 = outputs(t, &constant, &given).map(|y| y.value).into();
        self.replaced(c, d, y0)
    }

    /// The model of small deviations from a steady motion, such as that of a vehicle at constant speed: the drift is
    /// zero, all else is kept. A law designed with it takes the state of the motion at the time as `x0`.
    #[must_use]
    pub fn without_drift(self) -> Self {
        Self {
            drift: SVector::zeros(),
            ..self
        }
    }

    /// Replaces the outputs by `y = C dx + D du`.
    #[must_use]
    pub fn with_output_matrices<const Q: usize>(
        self,
        c: SMatrix<f64, Q, N>,
        d: SMatrix<f64, Q, M>,
    ) -> StateSpace<N, M, Q> {
        self.replaced(c, d, SVector::zeros())
    }

    fn replaced<const Q: usize>(
        self,
        c: SMatrix<f64, Q, N>,
        d: SMatrix<f64, Q, M>,
        y0: SVector<f64, Q>,
    ) -> StateSpace<N, M, Q> {
        StateSpace {
            a: self.a,
            b: self.b,
            c,
            d,
            x0: self.x0,
            u0: self.u0,
            y0,
            drift: self.drift,
            period: self.period,
            t: self.t,
            names: self.names,
            basis: self.basis,
        }
    }

    /// The model from sample to sample with the period `period` in s, for inputs that are held between samples
    /// (zero-order hold). It is exact for the linear model: `exp([A, B, drift; 0, 0, 0] h)` has its matrices.
    ///
    /// C. F. Van Loan, IEEE Trans. Autom. Control 23 (1978) 395; N. J. Higham, SIAM J. Matrix Anal. Appl. 26 (2005)
    /// 1179 for the exponential.
    ///
    /// # Errors
    /// [`ControlError::Period`] if the period is not positive and finite, [`ControlError::Sampled`] if the model has
    /// one already, [`ControlError::NotFinite`] and [`ControlError::TooLarge`] for entries of the model, and
    /// [`ControlError::Growth`] if those of the result are too large, as after growth over a long period.
    pub fn discretize(&self, period: f64) -> Result<Self, ControlError<N>> {
        if let Some(period) = self.period {
            return Err(ControlError::Sampled { period });
        }
        require_period(period)?;
        self.require_finite()?;
        let driven = DMatrix::from_fn(N, M + 1, |i, j| if j < M { self.b[(i, j)] } else { self.drift[i] });
        let dynamic = DMatrix::from_column_slice(N, N, self.a.as_slice());
        let (a, b) = held(&dynamic, &driven, period).ok_or(ControlError::Growth { period })?;
        let sampled = Self {
            a: SMatrix::from_column_slice(a.as_slice()),
            b: SMatrix::from_column_slice(&b.as_slice()[..N * M]),
            drift: SVector::from_column_slice(&b.as_slice()[N * M..]),
            period: Some(period),
            ..self.clone()
        };
        sampled.require_finite().map_err(|_| ControlError::Growth { period })?;
        Ok(sampled)
    }

    /// Tests if the inputs reach each mode, and returns the modes that they do not reach, with the direction that is
    /// lost, and how near the others are to it.
    ///
    /// # Errors
    /// [`ControlError::NotFinite`] and [`ControlError::TooLarge`] for entries of the model, and
    /// [`ControlError::NoConvergence`] if the eigenvalues do not converge.
    pub fn controllability(&self) -> Result<PbhTest<N>, ControlError<N>> {
        self.require_finite()?;
        let (a, basis) = self.restricted();
        self.pbh_test(&a, &along(&basis, &self.b), &basis)
    }

    /// Tests if the outputs show each mode, and returns the modes that they do not show, with the direction that is
    /// lost, and how near the others are to it.
    ///
    /// # Errors
    /// As for [`controllability`](Self::controllability).
    pub fn observability(&self) -> Result<PbhTest<N>, ControlError<N>> {
        self.require_finite()?;
        let (a, basis) = self.restricted();
        self.pbh_test(&a.transpose(), &along(&basis, &self.c.transpose()), &basis)
    }

    fn pbh_test(
        &self,
        a: &DMatrix<f64>,
        b: &DMatrix<f64>,
        basis: &DMatrix<f64>,
    ) -> Result<PbhTest<N>, ControlError<N>> {
        let failed = ControlError::NoConvergence { residual: f64::NAN };
        let (Some(lost), Some(margins)) = (unreached(a, &without_idle(a, b)), margins(a, b)) else {
            return Err(failed);
        };
        let margins = margins.into_iter();
        Ok(PbhTest {
            margins: margins
                .map(|(eigenvalue, margin)| ModeMargin { eigenvalue, margin })
                .collect(),
            lost: self.named(lost, basis),
        })
    }

    /// Solves a Riccati equation in the directions of `basis`. `lost` are the errors for modes that are not reached,
    /// and for modes without weight.
    pub(super) fn solved(
        &self,
        problem: &Problem,
        basis: &DMatrix<f64>,
        lost: [fn(LostModes<N>) -> ControlError<N>; 2],
    ) -> Result<Solution, ControlError<N>> {
        let named = |modes| self.named(modes, basis);
        problem.solve().map_err(|obstacle| match obstacle {
            Obstacle::Unreached(modes) => lost[0](named(modes)),
            Obstacle::Unweighted(modes) => lost[1](named(modes)),
            Obstacle::NoConvergence(residual) => ControlError::NoConvergence { residual },
        })
    }

    /// Modes in the directions of `basis`, in the names of the model.
    fn named(&self, modes: Vec<Mode>, basis: &DMatrix<f64>) -> LostModes<N> {
        LostModes::new(modes, basis, self.period.is_some(), self.names.clone())
    }

    /// The matrix `A` in admissible directions, and these as columns.
    pub(super) fn restricted(&self) -> (DMatrix<f64>, DMatrix<f64>) {
        let basis = self.basis.clone().unwrap_or_else(|| DMatrix::identity(N, N));
        (along(&basis, &self.a) * &basis, basis)
    }

    /// Rejects entries that are not finite, and those of matrices whose squares are not.
    pub(super) fn require_finite(&self) -> Result<(), ControlError<N>> {
        let entries: [(&'static str, &[f64]); 8] = [
            ("the state", self.x0.as_slice()),
            ("the input", &self.u0),
            ("A", self.a.as_slice()),
            ("B", self.b.as_slice()),
            ("C", self.c.as_slice()),
            ("D", self.d.as_slice()),
            ("the output", self.y0.as_slice()),
            ("the right-hand side", self.drift.as_slice()),
        ];
        let is_finite = |entries: &[f64]| entries.iter().all(|entry| entry.is_finite());
        if let Some((what, _)) = entries.into_iter().find(|(_, entries)| !is_finite(entries)) {
            return Err(ControlError::NotFinite { what });
        }
        let squares = [
            ("A", self.a.norm_squared()),
            ("B", self.b.norm_squared()),
            ("C", self.c.norm_squared()),
        ];
        match squares.into_iter().find(|(_, square)| !square.is_finite()) {
            Some((what, _)) => Err(ControlError::TooLarge { what }),
            None => Ok(()),
        }
    }
}

/// Components of the columns of a matrix along the columns of a basis.
pub(super) fn along<const N: usize, const K: usize>(basis: &DMatrix<f64>, matrix: &SMatrix<f64, N, K>) -> DMatrix<f64> {
    basis.transpose() * DMatrix::from_column_slice(N, K, matrix.as_slice())
}

fn require_period<const N: usize>(period: f64) -> Result<f64, ControlError<N>> {
    if period > 0.0 && period.is_finite() {
        Ok(period)
    } else {
        Err(ControlError::Period(period))
    }
}
