//! Integration methods: plain values with settings, each with `solve` and `stepper`.

mod adaptive;
#[cfg(feature = "std")]
mod adjoint;
mod auto;
mod collocation;
mod explicit;
mod fixed;
#[cfg(feature = "std")]
mod fused;
mod gauss;
mod grid;
mod hermite;
mod input;
pub(crate) mod jump;
mod operations;
mod radau;
mod rosenbrock;
#[cfg(feature = "std")]
mod scan;
mod scheme;
#[cfg(feature = "std")]
mod search;
#[cfg(feature = "std")]
mod side;
mod smooth;
pub(crate) mod stage_sums;
mod stages;
mod step_control;
mod stepper;
#[cfg(feature = "std")]
mod tangent;
mod taylor;
pub(crate) mod toggle;
#[cfg(feature = "std")]
mod watch;
mod zero;

use crate::error::Reason;
#[cfg(feature = "std")]
use crate::error::SolveError;
#[cfg(feature = "std")]
use crate::event::Event;
use crate::real::Float;
#[cfg(feature = "std")]
use crate::solution::{Observer, Solution};
use crate::system::IntoState;
#[cfg(feature = "std")]
use crate::system::System;
use crate::tableau::{self, DormandPrince5, Kutta4, Tsitouras5, Verner7, Verner9};
#[cfg(feature = "std")]
use nalgebra::SVector;

pub(crate) use explicit::MAX_DEGREE;
#[cfg(feature = "std")]
pub(crate) use input::check_loops;
pub(crate) use input::{check_start, place, require};
pub(crate) use zero::{Known, first_zero, places, root, root_of_line, unseen_bend, zero_between};
#[cfg(feature = "std")]
pub(crate) use {
    grid::Grid,
    input::check_span,
    rosenbrock::RosenbrockStages,
    scheme::{NonFinite, StepFailure},
    search::Search,
    stages::SHORT,
    step_control::{Pace, is_within_tolerance},
    stepper::Progress,
    tangent::{Carried, CarriedStages, Carry, Tangent},
    watch::{Early, see},
};

pub use crate::step_size::{Estimates, Tolerance};
pub use adaptive::Adaptive;
#[cfg(feature = "std")]
pub use adjoint::{AdjointStep, DiscreteAdjoint};
pub use auto::{Auto, Switching};
#[cfg(feature = "std")]
pub(crate) use auto::{Bounded, MethodPair, SwitchInLanes, SwitchingFrom};
pub use explicit::Explicit;
pub use fixed::Fixed;
#[cfg(feature = "std")]
pub use fused::{FusedMethod, Fusible};
pub use gauss::Gauss;
pub use radau::RadauIIA;
pub use rosenbrock::Rosenbrock;
pub use scheme::{Accepted, OneStep, Scheme, Stalled};
pub use step_control::StepControl;
pub use stepper::Stepper;
pub use taylor::{PowerSeries, Taylor};

/// An integration method.
pub trait Method<S: ?Sized, T: Float, const N: usize> {
    /// Scheme that takes the steps.
    type Scheme: Scheme<S, T, N>;

    /// Tolerance of the steps; `None` if their length is given.
    fn tolerance(&self) -> Option<Tolerance<T>> {
        None
    }

    /// Integrates `system` from the state `x0` at `t0` towards `t1`, which may lie before `t0`, one step at a time.
    /// Records nothing, and allocates nothing on the heap.
    ///
    /// # Errors
    /// [`Reason::InvalidInput`] if a setting is out of range, or if a time or the state is not finite;
    /// [`Reason::NonFinite`] if the derivative at the initial point is not finite.
    fn stepper<'s>(
        &self,
        system: &'s S,
        t0: T,
        t1: T,
        x0: impl IntoState<T, N>,
    ) -> Result<Stepper<'s, Self::Scheme, S, T, N>, Reason>;

    /// Integrates `system` from the state `x0` at `t0` to `t1`, which may lie before `t0`, and returns the trajectory.
    ///
    /// If `t1 == t0`, the trajectory is the initial point alone.
    ///
    /// # Errors
    /// Errors of [`stepper`](Self::stepper) and of [`Stepper::step`]. The error contains the solution up to the last
    /// good state.
    #[cfg(feature = "std")]
    fn solve(&self, system: &S, t0: T, t1: T, x0: impl IntoState<T, N>) -> Result<Solution<T, N>, SolveError<T, N>>
    where
        S: System<T, N>,
    {
        self.solve_with(system, t0, t1, x0, &[])
    }

    /// Like [`solve`](Self::solve), but with events: [`Solution::events`] lists their occurrences.
    ///
    /// A terminal event ends the solution. Where an event resets the state, the solution has two points at the same
    /// time.
    ///
    /// # Errors
    /// Errors of [`solve`](Self::solve), [`Reason::EventNotFinite`], [`Reason::EventsAccumulate`], and
    /// [`Reason::BadReset`].
    #[cfg(feature = "std")]
    fn solve_with(
        &self,
        system: &S,
        t0: T,
        t1: T,
        x0: impl IntoState<T, N>,
        events: &[Event<'_, T, N>],
    ) -> Result<Solution<T, N>, SolveError<T, N>>
    where
        S: System<T, N>,
    {
        let x0 = x0.into_state();
        match self.stepper(system, t0, t1, x0) {
            Ok(stepper) => stepper.collect(x0, events, self.tolerance()),
            Err(reason) => Err(SolveError::at_start(reason, t0, x0)),
        }
    }

    /// Like [`solve_with`](Self::solve_with), but passes the trajectory to an observer and returns only the final
    /// state. A [`Solution`] is itself an observer. Only the observer stores anything.
    ///
    /// ```
    /// use pendulum_core::dense::Dense;
    /// use pendulum_core::prelude::*;
    /// use pendulum_core::{Need, Observer, Reason};
    ///
    /// /// The greatest height among the ends of steps.
    /// struct Top(f64);
    ///
    /// impl Observer<f64, 2> for Top {
    ///     fn needs(&self, _t0: f64, _t1: f64) -> Need {
    ///         Need::Ends
    ///     }
    ///
    ///     fn step(&mut self, dense: &Dense<'_, f64, 2>) {
    ///         self.0 = self.0.max(-dense.step().x1[0].cos());
    ///     }
    /// }
    ///
    /// let swing = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0].sin()]));
    /// let mut top = Top(-1.0);
    /// let end = Vern9::new().h_max(0.1).follow(&swing, 0.0, 1000.0, [1.0, 0.0], &[], &mut top)?;
    /// assert!((top.0 + 1.0_f64.cos()).abs() < 1e-3 && end[0].abs() <= 1.0);
    /// # Ok::<(), Reason>(())
    /// ```
    ///
    /// # Errors
    /// Reasons of [`solve_with`](Self::solve_with). The observer has then received the trajectory up to the last good
    /// state.
    #[cfg(feature = "std")]
    fn follow(
        &self,
        system: &S,
        t0: T,
        t1: T,
        x0: impl IntoState<T, N>,
        events: &[Event<'_, T, N>],
        observer: &mut impl Observer<T, N>,
    ) -> Result<SVector<T, N>, Reason>
    where
        S: System<T, N>,
    {
        let x0 = x0.into_state();
        let mut stepper = self.stepper(system, t0, t1, x0)?;
        let ended = stepper.watched(x0, events, self.tolerance(), observer);
        ended.map_err(|early| early.reason)
    }
}

/// The classical Runge-Kutta method of order 4 with a fixed step; see [`Fixed`].
///
/// Four evaluations a step; dense output of order 3.
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::SolveError;
///
/// let swing = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0].sin()]));
/// let solution = Rk4::new(0.01).solve(&swing, 0.0, 1.0, [0.5, 0.0])?;
/// assert_eq!(solution.t().len(), 101);
/// # Ok::<(), SolveError<f64, 2>>(())
/// ```
pub type Rk4 = Fixed<Explicit<Kutta4, 5>>;

/// The Runge-Kutta pair 5(4) of Dormand and Prince with step-size control; see [`Adaptive`] for its settings.
///
/// Six evaluations a step; dense output of order 4.
///
/// ```
/// use pendulum_core::prelude::*;
///
/// let swing = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0].sin()]));
/// let solution = Rk45::new().rtol(1e-9).atol(1e-9).solve(&swing, 0.0, 10.0, [0.5, 0.0])?;
/// let (t, x) = solution.last();
/// let energy = |x: &SVector<f64, 2>| 0.5 * x[1] * x[1] - x[0].cos();
/// assert_eq!(t, 10.0);
/// assert!((energy(&x) - energy(&solution.at(0.0)?)).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type Rk45 = Adaptive<Explicit<DormandPrince5, 7>>;

/// The Runge-Kutta pair 5(4) of Tsitouras with step-size control; see [`Adaptive`] for its settings.
///
/// Six evaluations a step, as for [`Rk45`], with smaller errors; dense output of order 4.
pub type Tsit5 = Adaptive<Explicit<Tsitouras5, 7>>;

/// The Runge-Kutta pair 7(6) of Verner with step-size control; see [`Adaptive`] for its settings.
///
/// Ten evaluations a step; dense output of order 7, with five more evaluations in steps where it is computed.
pub type Vern7 = Adaptive<Explicit<Verner7, 11>>;

/// The Runge-Kutta pair 9(8) of Verner with step-size control; see [`Adaptive`] for its settings.
///
/// Sixteen evaluations a step; dense output of order 9, with nine more evaluations in steps where it is computed.
pub type Vern9 = Adaptive<Explicit<Verner9, 17>>;

/// The Rosenbrock method Rodas of order 4 for stiff systems; see [`Adaptive`] for its settings, and
/// [`tableau::HairerWanner4`].
///
/// Six evaluations, one Jacobian and one factorisation a step; dense output of order 3.
pub type Rodas4 = Adaptive<Rosenbrock<tableau::HairerWanner4, 6>>;

/// The Rosenbrock method Rodas5P of order 5 for stiff systems; see [`Adaptive`] for its settings, and
/// [`tableau::Steinebach5`].
///
/// Eight evaluations, one Jacobian and one factorisation a step; dense output of order 4.
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::SolveError;
///
/// /// Returns to the cosine of time within microseconds.
/// struct Follower;
///
/// impl System<f64, 1> for Follower {
///     fn rhs(&self, t: f64, x: &SVector<f64, 1>) -> SVector<f64, 1> {
///         SVector::from([-1e6 * (x[0] - t.cos()) - t.sin()])
///     }
/// }
///
/// impl Jacobian<f64, 1> for Follower {
///     fn jacobian(&self, _t: f64, _x: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> {
///         SMatrix::from([[-1e6]])
///     }
/// }
///
/// let solution = Rodas5P::new().solve(&Follower, 0.0, 10.0, [2.0])?;
/// assert!((solution.end()[0] - 10.0_f64.cos()).abs() < 1e-6);
/// assert!(solution.statistics().accepted < 100);
/// # Ok::<(), SolveError<f64, 1>>(())
/// ```
pub type Rodas5P = Adaptive<Rosenbrock<tableau::Steinebach5, 8>>;

/// The method Radau IIA of order 5 for stiff systems; see [`Adaptive`] for its settings, and [`RadauIIA`].
///
/// Three evaluations an iteration and at most one Jacobian a step; dense output of order 3. The error estimate is of
/// order 3 too, so tight tolerances lead to shorter steps than necessary, and to errors far below the tolerance: use
/// [`Radau9`] or [`Radau13`] there.
///
/// More robust than the cheaper [`Rodas5P`]: it converges with inexact Jacobians and for strongly nonlinear right-hand
/// sides.
pub type Radau5 = Adaptive<RadauIIA>;

/// The method Radau IIA of order 9, for stiff systems and tolerances below 1e-7; see [`Adaptive`] for its settings, and
/// [`RadauIIA`].
///
/// Five evaluations an iteration; dense output and error estimate of order 5. Relaxation oscillations of van der Pol
/// (`epsilon` of 1e-6, two seconds) at a tolerance of 1e-10 take 18,000 evaluations and 360 Jacobians, those of
/// [`Radau5`] 67,000 and 1,300, and those of [`Rodas5P`] 65,000 and 8,100.
pub type Radau9 = Adaptive<RadauIIA<5, 2>>;

/// The method Radau IIA of order 13, for stiff systems and the tightest tolerances; see [`Adaptive`] for its settings,
/// and [`RadauIIA`].
///
/// Seven evaluations an iteration; dense output and error estimate of order 7. At loose tolerances the iterations of
/// its long steps converge slowly or not at all.
pub type Radau13 = Adaptive<RadauIIA<7, 3>>;

/// The Gauss-Legendre method of order 4 in canonical variables, with a fixed step; see [`Gauss`].
///
/// Dense output of order 3.
///
/// ```
/// use pendulum_core::prelude::*;
///
/// mechanism! {
///     pub Swing {
///         gravity: [0, -9.81, 0],
///         generate: [canonical, energy],
///         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle }
///     }
/// }
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let swing = Swing::new(SwingParams {})?;
/// let start = SVector::from([1.0, 0.0]);
/// let end = Gauss4::new(0.05).stepper(&swing, 0.0, 1000.0, start)?.run()?;
/// assert!((swing.energy(1000.0, &end) - swing.energy(0.0, &start)).abs() < 1e-4);
/// # Ok(())
/// # }
/// ```
pub type Gauss4 = Fixed<Gauss<2>>;

/// The Gauss-Legendre method of order 6 in canonical variables, with a fixed step; see [`Gauss`].
///
/// Dense output of order 5.
pub type Gauss6 = Fixed<Gauss<3>>;

/// The Gauss-Legendre method of order 16 in canonical variables, with a fixed step; see [`Gauss`].
///
/// For smooth motions over long times: without friction, the error of the energy is the random walk of rounding errors.
/// Over a million swings of a double pendulum (0.3 and 0.4 rad, steps of 0.4 s, a fifth of a swing) it stays below
/// 2e-13 of the energy; with [`Taylor`] at its tightest tolerance, in 0.4 of the time, it drifts by 2e-12. Larger
/// motions need shorter steps: where the iterations do not converge, an error says so.
///
/// Dense output of order 8.
pub type Gauss16 = Fixed<Gauss<8, 4>>;
