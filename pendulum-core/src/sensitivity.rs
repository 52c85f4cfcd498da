//! Derivatives of trajectories by initial conditions and parameters.
//!
//! A sensitivity is the derivative of the state at a time by a number on which the motion depends. It satisfies the
//! variational equations `S' = (df/dx) S + df/dp`. Here the method itself is differentiated: it integrates
//! [dual numbers](crate::dual), which carry the derivatives through each step. Unless the method
//! [controls their errors](crate::method::Adaptive::control_derivatives), the steps are those of the values alone. Thus
//! they are exact derivatives of the numerical solution at these steps, for every method, and converge with it.
//!
//! A mode switch, an impact or an event with a reset occurs at a time that depends on the variables. Its time carries
//! derivatives, too, and so does everything after it: the jump of the derivatives (saltation) follows. The derivatives
//! of a rate that dry friction holds are zero: from another initial rate friction would stop it at once, by an impulse
//! that changes the other rates. Where a motion starts from rest against dry friction and slips, those by the initial
//! rate are one-sided, in the direction of the slip. Dry friction of zero does not act, and has no derivatives with
//! respect to its coefficient: start from a small one.
//!
//! Contacts that close at the same time have derivatives only if they close together for other values of the variables,
//! too: otherwise the error is [`Reason::NotDifferentiable`], as it is where a motion reaches a limit no further than
//! rounding errors resolve. An impact at the start occurs at a time that depends on the variables as well. One at the
//! last time does not move it: the derivatives there are those before the impact. Where the order of impacts decides
//! the motion, which [`Solution::ambiguities`] reports, it is one of several.
//!
//! [`ensemble`] integrates many trajectories with their derivatives in the lanes of vector registers. All three take
//! methods in [fused arithmetic](crate::method::FusedMethod), such as `Vern9::new().fused()`, which needs less time.
//!
//! A rate that jumps or bends elsewhere, as by `clamp`, costs digits of the derivatives unless steps end there: pass
//! the events of the model ([`seeded`]), or control the errors of the derivatives.
//!
//! Where a single number is of interest, such as a cost, [`gradient`] computes its derivatives by all variables
//! backward in time, in a time that does not grow with their number.
//!
//! ```
//! use pendulum_core::prelude::*;
//! use pendulum_core::sensitivity::{self, Variable};
//!
//! mechanism! {
//!     pub Swing {
//!         params { l: m = 1, damping: N m s = 0.1 }
//!         gravity: [0, -9.81, 0],
//!         body bob on ground {
//!             solids: [point(1, [0, -l, 0])], joint: revolute(z), coordinate: theta, friction: damping,
//!         }
//!     }
//! }
//!
//! let swing = Swing::new(SwingParams::default())?;
//! // by the initial angle, and by both parameters
//! let by = [Variable::Start(Swing::THETA), Variable::Parameter(0), Variable::Parameter(1)];
//! let method = Vern9::new().rtol(1e-10).atol(1e-10);
//! let motion = sensitivity::solve(&method, &swing, 0.0, 2.0, [1.0, 0.0], by)?;
//! let (x, derivatives) = motion.end();
//! // the angle after 2 s with a length of 1.001 m
//! let longer = Swing::new(SwingParams { l: 1.001, ..SwingParams::default() })?;
//! let end = method.solve(&longer, 0.0, 2.0, [1.0, 0.0])?.end();
//! assert!((x[0] + 0.001 * derivatives[(0, 1)] - end[0]).abs() < 1e-5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! C. Fuehrer, E. Eich-Soellner, "Numerical Methods in Multibody Dynamics" (1998), section 4.6; A. Griewank, A.
//! Walther, "Evaluating Derivatives" (2008), chapter 3.

mod differentiable;
mod gradient;
mod seeded;

use nalgebra::{SMatrix, SVector};

pub use differentiable::{Differentiable, DifferentiableEnsemble};
pub use gradient::{Cost, Gradient, gradient};
pub use seeded::Seeded;
use seeded::{check, started};

use crate::dual::Dual;
use crate::ensemble::EnsembleError;
use crate::error::{Reason, SolveError};
use crate::solution::{OutsideSpan, Solution};
use crate::system::{Cast, IntoState, Parametric};

/// A number on which a trajectory depends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Variable {
    /// Component of the initial condition, by its index in the state.
    Start(usize),
    /// Parameter, by its index in the declaration, as in [`Parametric::parameter_names`].
    Parameter(usize),
}

/// A trajectory of a state of `N` components, with its derivatives by `K` variables.
#[derive(Clone, Debug)]
pub struct Sensitivity<const N: usize, const K: usize> {
    solution: Solution<Dual<f64, K>, N>,
}

/// Integrates a model from `t0` to `t1` with the derivatives by some variables.
///
/// The errors of the values are controlled as without derivatives, those of the derivatives on request:
/// [`control_derivatives`](crate::method::Adaptive::control_derivatives). For explicit methods and
/// [`Radau5`](crate::Radau5) the derivatives of smooth motions have errors of the same order. On stiff models those of
/// Rosenbrock methods are several digits worse.
///
/// # Errors
///
/// As for [`Method::solve`](crate::Method::solve). Where a motion only touches a limit, or the zero of an event that
/// resets it, the time of the event has no derivatives, and the motion ends with an error that says so if rounding
/// errors do not let it pass.
///
/// # Panics
///
/// If the index of a variable is out of range.
#[track_caller]
pub fn solve<X, S, M, const N: usize, const P: usize, const K: usize>(
    method: &X,
    model: &M,
    t0: f64,
    t1: f64,
    x0: impl IntoState<f64, N>,
    variables: [Variable; K],
) -> Result<Sensitivity<N, K>, SolveError<Dual<f64, K>, N>>
where
    M: Parametric<N, P>,
    X: Differentiable<S, M, N, P, K>,
{
    check::<N, P>(&variables);
    let x0 = started(&x0.into_state(), &variables);
    let motion = method.trajectory(&Seeded::new(model, variables), [t0, t1].map(Dual::constant), x0)?;
    Ok(motion.into())
}

/// Integrates like [`solve`] and returns only the last state and its derivatives, without dense output and without a
/// heap, in about half the time.
///
/// # Errors
///
/// As for [`Method::stepper`](crate::Method::stepper).
///
/// # Panics
///
/// If the index of a variable is out of range.
#[track_caller]
pub fn end<X, S, M, const N: usize, const P: usize, const K: usize>(
    method: &X,
    model: &M,
    t0: f64,
    t1: f64,
    x0: impl IntoState<f64, N>,
    variables: [Variable; K],
) -> Result<(SVector<f64, N>, SMatrix<f64, N, K>), Reason>
where
    M: Parametric<N, P>,
    X: Differentiable<S, M, N, P, K>,
{
    check::<N, P>(&variables);
    let x0 = started(&x0.into_state(), &variables);
    let end = method.last(&Seeded::new(model, variables), [t0, t1].map(Dual::constant), x0)?;
    Ok(split(&end))
}

/// The model and the initial condition as dual numbers, whose derivatives are those by some variables: for
/// [`Method::solve_with`](crate::Method::solve_with) with events, or a [`stepper`](crate::Method::stepper). The
/// [`Solution`] converts to a [`Sensitivity`].
///
/// An initial condition that depends on the variables gets their derivatives from the caller.
///
/// ```
/// use pendulum_core::dual::Dual;
/// use pendulum_core::prelude::*;
/// use pendulum_core::sensitivity::{self, Sensitivity, Variable};
///
/// mechanism! {
///     pub Ball {
///         params { g: m/s^2 = 8 }
///         gravity: [0, -g, 0],
///         body ball on ground { mass: 1, joint: prismatic(y), coordinate: y }
///     }
/// }
///
/// let ball = Ball::new(BallParams::default())?;
/// let (model, x0) = sensitivity::seeded(&ball, [1.0, 0.0], [Variable::Start(0), Variable::Parameter(0)]);
/// let landing = Event::new(|_t, x: &SVector<Dual<f64, 2>, 2>| x[0]).terminal();
/// let [t0, t1] = [0.0, 2.0].map(Dual::constant);
/// let motion: Sensitivity<2, 2> = Vern9::new().solve_with(&model, t0, t1, x0, &[landing])?.into();
/// let (t, _) = motion.solution().last();
/// // it lands at sqrt(2 y / g)
/// assert!((t.value - 0.5).abs() < 1e-9);
/// assert!((t.slopes[0] - 0.25).abs() < 1e-9 && (t.slopes[1] + 0.03125).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Panics
///
/// If the index of a variable is out of range.
#[track_caller]
pub fn seeded<M, const N: usize, const P: usize, const K: usize>(
    model: &M,
    x0: impl IntoState<f64, N>,
    variables: [Variable; K],
) -> (M::In<Dual<f64, K>>, SVector<Dual<f64, K>, N>)
where
    M: Parametric<N, P>,
{
    check::<N, P>(&variables);
    let model = Seeded::new(model, variables);
    (model.cast(), started(&x0.into_state(), &variables))
}

/// Integrates many trajectories at once like [`end`], in the lanes of vector registers.
///
/// Pass one model for each start, or a single one for all. Each result is bit-identical to [`end`].
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::sensitivity::{self, Variable};
///
/// mechanism! {
///     pub Swing {
///         params { l: m = 1 }
///         gravity: [0, -9.81, 0],
///         body bob on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: theta }
///     }
/// }
///
/// let swing = Swing::new(SwingParams::default())?;
/// let starts: Vec<_> = (1..=20).map(|n| SVector::from([0.1 * f64::from(n), 0.0])).collect();
/// let by = [Variable::Start(0), Variable::Parameter(0)];
/// let ends = sensitivity::ensemble(&Vern9::new(), &[swing], 0.0, 3.0, &starts, by)?;
/// assert_eq!(ends[4], sensitivity::end(&Vern9::new(), &swing, 0.0, 3.0, starts[4], by)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// As for [`Ensemble::ensemble`](crate::ensemble::Ensemble::ensemble).
///
/// # Panics
///
/// If the index of a variable is out of range.
#[allow(clippy::type_complexity, reason = "a state and its derivatives for each")]
#[track_caller]
pub fn ensemble<'m, X, S, M, const N: usize, const P: usize, const K: usize>(
    method: &X,
    models: &'m [M],
    t0: f64,
    t1: f64,
    starts: &[SVector<f64, N>],
    variables: [Variable; K],
) -> Result<Vec<(SVector<f64, N>, SMatrix<f64, N, K>)>, EnsembleError<Dual<f64, K>, N>>
where
    M: Parametric<N, P>,
    X: DifferentiableEnsemble<S, Seeded<'m, M, N, P, K>, N, K>,
{
    check::<N, P>(&variables);
    let models: Vec<_> = models.iter().map(|model| Seeded::new(model, variables)).collect();
    let starts: Vec<_> = starts.iter().map(|start| started(start, &variables)).collect();
    let ends = method.ends(&models, [t0, t1].map(Dual::constant), &starts)?;
    Ok(ends.iter().map(split).collect())
}

/// Splits a state into its values and its derivatives: a row for each component, a column for each variable.
#[must_use]
pub fn split<const N: usize, const K: usize>(x: &SVector<Dual<f64, K>, N>) -> (SVector<f64, N>, SMatrix<f64, N, K>) {
    (x.map(|x| x.value), SMatrix::from_fn(|n, k| x[n].slopes[k]))
}

impl<const N: usize, const K: usize> Sensitivity<N, K> {
    /// State at the time `t`, and its derivatives at this time: a row for each component, a column for each variable.
    /// At the time of an event that ended the motion they differ from those of [`end`](Self::end).
    ///
    /// # Errors
    ///
    /// If `t` is outside of the span.
    pub fn at(&self, t: f64) -> Result<(SVector<f64, N>, SMatrix<f64, N, K>), OutsideSpan> {
        self.solution.at(Dual::constant(t)).map(|x| split(&x))
    }

    /// Last state, and its derivatives. If an event ended the motion, they are those at the time of the event, which
    /// depends on the variables.
    #[must_use]
    pub fn end(&self) -> (SVector<f64, N>, SMatrix<f64, N, K>) {
        split(&self.solution.end())
    }

    /// Indices of the variables on which no state of the motion depends, such as a friction that never slips: their
    /// derivatives are zero. The friction that holds a joint has none at first order, either.
    pub fn without_influence(&self) -> impl Iterator<Item = usize> {
        let depends = |k: usize| self.solution.x().iter().flatten().any(|x| x.slopes[k] != 0.0);
        (0..K).filter(move |&k| !depends(k))
    }

    /// Solution in dual numbers: points, [events](Solution::events), [modes](Solution::modes) and
    /// [impacts](Solution::impacts), with their times.
    #[must_use]
    pub fn solution(&self) -> &Solution<Dual<f64, K>, N> {
        &self.solution
    }
}

impl<const N: usize, const K: usize> From<Solution<Dual<f64, K>, N>> for Sensitivity<N, K> {
    fn from(solution: Solution<Dual<f64, K>, N>) -> Self {
        Self { solution }
    }
}
