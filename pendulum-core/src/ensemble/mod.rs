//! Integration of many trajectories at once, in the lanes of vector registers.

mod check;
mod entry;
mod hybrid;
mod in_lanes;
mod judge;
mod lanes;
mod leave;
mod march;
mod members;
mod observe;
mod on_grid;
mod ready;
mod together;
mod turnover;
mod watch;

use std::error::Error;
use std::fmt;

use nalgebra::SVector;

pub(crate) use check::{in_lane, set_lane};
pub(crate) use entry::go_on;
pub use lanes::{Expanded, InLanes};
pub(crate) use together::Marches;
pub use together::Together;

use crate::error::{Reason, debug_as_display};
use crate::event::Event;
use crate::method::{Method, require};
use crate::real::Float;
use crate::real::lanes::{Isa, LaneElement};
use crate::solution::Observer;
use crate::system::Cast;
use watch::Watch;

/// A method that integrates many trajectories at once.
///
/// Explicit methods, [`Taylor`](crate::Taylor), Rosenbrock methods and [`Auto`](crate::Auto) run in lanes of vector
/// registers, one trajectory per lane. [`Radau5`](crate::Radau5) and the Gauss methods integrate the trajectories one
/// by one, as do Rosenbrock methods and `Auto` for [hybrid](crate::hybrid) systems, and `Auto` with tolerances up to
/// 1e-9 from where a trajectory turns stiff.
pub trait Ensemble<M, T: LaneElement, const N: usize> {
    /// Integrates from each of the states `starts` at `t0` to `t1`, and returns the final states.
    ///
    /// Pass one model per start, or a single model for all. Each final state is bit for bit the one computed by
    /// [`solve`](crate::Method::solve); the trajectories are not recorded. Apart from the result no heap is used.
    /// Without compiler optimisation, lanes are slower than scalars.
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    ///
    /// mechanism! {
    ///     pub Swing {
    ///         params { l: m = 1.0 }
    ///         gravity: [0, -9.81, 0],
    ///         body bob on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: angle }
    ///     }
    /// }
    ///
    /// let lengths = (1..=100).map(|i| Swing::new(SwingParams { l: 0.1 * f64::from(i) }));
    /// let swings = lengths.collect::<Result<Vec<_>, _>>()?;
    /// let starts = vec![SVector::from([0.5, 0.0]); swings.len()];
    /// let ends = Rk4::new(0.001).ensemble(&swings, 0.0, 10.0, &starts)?;
    /// assert_eq!(ends[41], Rk4::new(0.001).solve(&swings[41], 0.0, 10.0, starts[41])?.end());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// An adaptive method chooses the steps of each trajectory separately. When a trajectory ends, the next one takes
    /// its lane.
    ///
    /// # Errors
    /// [`EnsembleError::InvalidInput`] if there is neither one model nor one for each start, or if times or settings
    /// are invalid. [`EnsembleError::Stopped`] lists the trajectories that stopped early or had an invalid start, and
    /// holds the final states of the others.
    fn ensemble(
        &self,
        models: &[M],
        t0: T,
        t1: T,
        starts: &[SVector<T, N>],
    ) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>> {
        self.ensemble_on(Isa::widest(), models, t0, t1, starts)
    }

    /// [`ensemble`](Self::ensemble) on the instruction set `isa`, for comparisons. The results are bit-identical.
    ///
    /// # Errors
    /// See [`ensemble`](Self::ensemble).
    fn ensemble_on(
        &self,
        isa: Isa,
        models: &[M],
        t0: T,
        t1: T,
        starts: &[SVector<T, N>],
    ) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>>;

    /// Recommended number of trajectories per call, if there are many.
    fn batch(&self) -> usize {
        256
    }
}

/// A method that integrates many trajectories at once and passes them to observers.
pub trait ObservedEnsemble<M, T: LaneElement, const N: usize>: Ensemble<M, T, N> {
    /// [`ensemble`](Ensemble::ensemble) with one observer per start. `events(i)` are the events of trajectory `i`.
    ///
    /// Each observer receives bit for bit the data that [`solve_with`](crate::Method::solve_with) records. A terminal
    /// event ends its trajectory; the final state is the state at the event.
    ///
    /// Trajectories with events that reset their state, and those of hybrid systems, are integrated one by one.
    ///
    /// # Errors
    /// Errors of [`ensemble`](Ensemble::ensemble), and [`EnsembleError::InvalidInput`] if there is not one observer for
    /// each start.
    fn observe<'w, 'e: 'w, O>(
        &self,
        models: &[M],
        span: (T, T),
        starts: &[SVector<T, N>],
        events: impl Fn(usize) -> &'w [Event<'e, T, N>],
        observers: &mut [O],
    ) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>>
    where
        Self: Sized,
        O: Observer<T, N>,
        T: 'w,
    {
        self.observe_on(Isa::widest(), models, span, starts, events, observers)
    }

    /// [`observe`](Self::observe) on the instruction set `isa`.
    ///
    /// # Errors
    /// See [`observe`](Self::observe).
    fn observe_on<'w, 'e: 'w, O>(
        &self,
        isa: Isa,
        models: &[M],
        span: (T, T),
        starts: &[SVector<T, N>],
        events: impl Fn(usize) -> &'w [Event<'e, T, N>],
        observers: &mut [O],
    ) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>>
    where
        Self: Sized,
        O: Observer<T, N>,
        T: 'w;
}

/// A trajectory that stopped early.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Stopped<T = f64> {
    /// Index of the trajectory among the starts.
    pub index: usize,
    /// Last valid time.
    pub t: T,
    /// Reason of the stop.
    pub reason: Reason,
}

impl<T> Stopped<T> {
    /// Trajectory `index` stopped at `t`.
    #[must_use]
    pub const fn new(index: usize, t: T, reason: Reason) -> Self {
        Self { index, t, reason }
    }
}

debug_as_display! { [T: Float, const N: usize] EnsembleError<T, N>; }

/// Reason why some trajectories of an ensemble did not reach the end.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum EnsembleError<T, const N: usize> {
    /// A setting or an argument is invalid; nothing was integrated.
    InvalidInput(Reason),
    /// Some trajectories stopped early.
    Stopped {
        /// The trajectories that stopped, in ascending order; at least one.
        stopped: Vec<Stopped<T>>,
        /// Final states, and the last valid states of trajectories that stopped.
        x: Vec<SVector<T, N>>,
    },
}

impl<T, const N: usize> From<Reason> for EnsembleError<T, N> {
    fn from(reason: Reason) -> Self {
        Self::InvalidInput(reason)
    }
}

impl<T: Float, const N: usize> fmt::Display for EnsembleError<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::InvalidInput(reason) => reason.fmt(f),
            Self::Stopped { stopped, x } => {
                write!(f, "{} of {} trajectories stopped", stopped.len(), x.len())?;
                if let Some(Stopped { index, t, reason }) = stopped.first() {
                    write!(f, "; trajectory {index} at t = {:?}: {reason}", t.to_f64())?;
                }
                Ok(())
            }
        }
    }
}

impl<T: Float, const N: usize> Error for EnsembleError<T, N> {}

/// Checks that there is one model, or one for each start, and that the models can share lanes. For implementations of
/// [`Ensemble`].
///
/// # Errors
/// [`Reason::InvalidInput`].
pub fn check_models<M: Cast<N>, X, const N: usize>(models: &[M], starts: &[X]) -> Result<(), Reason> {
    let rule = "an ensemble takes one model for all starts, or one for each";
    check_number("models", models, starts, rule)?;
    check_lanes(models)
}

/// Checks that there is one of the arguments for all starts or states, or one for each.
pub(crate) fn check_number<A, X>(
    name: &'static str,
    arguments: &[A],
    starts: &[X],
    rule: &'static str,
) -> Result<(), Reason> {
    let count = arguments.len();
    require(count == 1 || count == starts.len(), name, count as f64, rule)
}

/// Checks that models can share lanes.
pub(crate) fn check_lanes<M: Cast<N>, const N: usize>(models: &[M]) -> Result<(), Reason> {
    let rule = "the models of an ensemble may differ in the constants of declarations, not in laws of inputs or \
                equations by hand, as this one does";
    let strange = models.iter().position(|model| !model.shares_lanes(&models[0]));
    require(strange.is_none(), "models", strange.unwrap_or(0) as f64, rule)
}

fn check_observers<O, X>(observers: &[O], starts: &[X]) -> Result<(), Reason> {
    let rule = "an ensemble takes one observer for each start";
    require(
        observers.len() == starts.len(),
        "observers",
        observers.len() as f64,
        rule,
    )
}

/// Returns the final states, or the list of trajectories that stopped. For implementations of [`Ensemble`].
///
/// # Errors
/// [`EnsembleError::Stopped`] if any trajectory stopped.
pub fn conclude<T, const N: usize>(
    x: Vec<SVector<T, N>>,
    mut stopped: Vec<Stopped<T>>,
) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>> {
    if stopped.is_empty() {
        return Ok(x);
    }
    stopped.sort_by_key(|stopped| stopped.index);
    Err(EnsembleError::Stopped { stopped, x })
}

/// Integrates the trajectories `which` from the states `x`, one by one, and replaces `x` by the final states. Scalars
/// are faster than a single lane: their right-hand side is one function, not a copy inlined in each stage.
fn alone<A, M, T, W, const N: usize>(
    method: &A,
    models: &[M],
    (t0, t1): (T, T),
    which: impl IntoIterator<Item = usize>,
    (x, watch): (&mut [SVector<T, N>], &mut W),
    stopped: &mut Vec<Stopped<T>>,
) where
    A: Method<M::In<T>, T, N>,
    M: Cast<N>,
    T: Float,
    W: Watch<T, N>,
{
    for index in which {
        let x = &mut x[index];
        let model = model_of(models, index).cast::<T>();
        let (t, reason) = match method.stepper(&model, t0, t1, *x) {
            Ok(mut stepper) => {
                let ended = watch.run((index, *x), &mut stepper, method.tolerance());
                let (t, end, reason) = match ended {
                    Ok(end) => (stepper.t(), end, None),
                    Err(early) => (early.t, early.x, Some(early.reason)),
                };
                *x = end;
                (t, reason)
            }
            Err(reason) => (t0, Some(reason)),
        };
        stopped.extend(reason.map(|reason| Stopped { index, t, reason }));
    }
}

/// Returns the model of trajectory `i`.
pub(crate) fn model_of<M>(models: &[M], i: usize) -> &M {
    if let [model] = models { model } else { &models[i] }
}

/// Largest number of lanes: four registers of sixteen `f32`, or eight of eight.
pub(crate) const MOST_LANES: usize = 64;
