//! Results of an integration: accepted points, and dense output between them.

use std::error::Error;
use std::fmt;

use nalgebra::SVector;

use crate::dense::{Dense, polynomial};
use crate::error::debug_as_display;
use crate::event::{Missed, Occurrence};
use crate::forward::forward;
use crate::hybrid::{Ambiguity, Impact, Mode};
use crate::real::Float;
use crate::step_size::Tolerance;

mod below;
mod unresolved;

pub use crate::statistics::Statistics;
pub use below::BelowTolerance;
pub use unresolved::Unresolved;

/// A trajectory: the accepted points, and dense output between them.
///
/// It has at least one point, the initial one; an integration over an empty span has no other. Times ascend, or descend
/// for an integration backward in time. At an impact, and at an event that resets the state, a time occurs twice, with
/// the states before and after.
#[derive(Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        try_from = "Unchecked<T, N>",
        bound(
            serialize = "T: Float + serde::Serialize",
            deserialize = "T: Float + serde::Deserialize<'de>"
        )
    )
)]
pub struct Solution<T, const N: usize> {
    t: Vec<T>,
    x: Vec<SVector<T, N>>,
    /// Coefficients of the steps, concatenated: `x(t_i + theta h) = x_i + c_1 theta + c_2 theta^2 + ..`.
    coefficients: Vec<SVector<T, N>>,
    /// End index of the coefficients of each step.
    ends: Vec<usize>,
    events: Vec<Occurrence<T, N>>,
    modes: Vec<(T, Mode)>,
    impacts: Vec<Impact<T, N>>,
    ambiguities: Vec<Ambiguity<T>>,
    statistics: Statistics,
    missed: Vec<Missed<T>>,
    tolerance: Option<Tolerance<T>>,
}

impl<T: Float, const N: usize> Solution<T, N> {
    /// A solution that consists of its initial point. As an [`Observer`] it records the following steps.
    #[must_use]
    pub fn start(t0: T, x0: SVector<T, N>) -> Self {
        Self {
            t: vec![t0],
            x: vec![x0],
            coefficients: Vec::new(),
            ends: Vec::new(),
            events: Vec::new(),
            modes: Vec::new(),
            impacts: Vec::new(),
            ambiguities: Vec::new(),
            statistics: Statistics::default(),
            missed: Vec::new(),
            tolerance: None,
        }
    }

    /// Times of the accepted points, the initial one first. The last one is exactly the end of the span.
    #[must_use]
    pub fn t(&self) -> &[T] {
        &self.t
    }

    /// States at the times [`t`](Self::t).
    #[must_use]
    pub fn x(&self) -> &[SVector<T, N>] {
        &self.x
    }

    /// Iterates over the accepted points, each a time and a state.
    pub fn points(&self) -> impl DoubleEndedIterator<Item = (T, &SVector<T, N>)> + ExactSizeIterator {
        self.t.iter().copied().zip(&self.x)
    }

    /// Last time and state.
    #[must_use]
    pub fn last(&self) -> (T, SVector<T, N>) {
        let last = self.t.len() - 1;
        (self.t[last], self.x[last])
    }

    /// Final state: the last valid one if the integration stopped early.
    #[must_use]
    pub fn end(&self) -> SVector<T, N> {
        self.last().1
    }

    /// Events in the order of their occurrence.
    #[must_use]
    pub fn events(&self) -> &[Occurrence<T, N>] {
        &self.events
    }

    /// Modes of a [hybrid](crate::hybrid) system, each with the time at which it begins; empty for other systems.
    ///
    /// An impact begins a mode, even if the same constraints are held as before. Its time then occurs twice in
    /// [`t`](Self::t), with the states before and after.
    ///
    /// Times ascend from the start of the span to at most its end; the last entry is the mode at the end. Rebounds too
    /// low to resolve are replaced by lasting contact, beginning with the first of them. The mode of this contact is
    /// dated to the calculated end of the rebounds, or to the next mode switch if that comes earlier.
    #[must_use]
    pub fn modes(&self) -> &[(T, Mode)] {
        &self.modes
    }

    /// Impacts of a [hybrid](crate::hybrid) system in the order of their occurrence; empty for other systems.
    ///
    /// Simultaneous impacts form one entry. Rebounds too low to resolve are omitted, and the impact before them is
    /// recorded as one without rebound.
    ///
    /// ```
    /// use pendulum_core::hybrid::Hybrid;
    /// use pendulum_core::prelude::*;
    ///
    /// mechanism! {
    ///     pub Ball {
    ///         gravity: [0, -9.81, 0],
    ///         wall floor { gap: y, restitution: 0.5 }
    ///         body ball on ground { mass: 2, joint: prismatic(y), coordinate: y }
    ///     }
    /// }
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let ball = Ball::new(BallParams {})?;
    /// let solution = Vern7::new().solve(&ball, 0.0, 1.0, [1.0, 0.0])?;
    /// for impact in solution.impacts() {
    ///     for (constraint, impulse) in impact.pushes() {
    ///         println!("{:.4} s: {impulse:.3} N s from the {}", impact.t, ball.constraints()[constraint].name);
    ///     }
    /// }
    /// let [first, ..] = solution.impacts() else { return Err("no impact".into()) };
    /// let rate = (2.0 * 9.81_f64).sqrt();
    /// assert!((first.impulses[0] - 2.0 * 1.5 * rate).abs() < 1e-6);
    /// assert!((first.after[Ball::DOT_Y] - 0.5 * rate).abs() < 1e-6);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn impacts(&self) -> &[Impact<T, N>] {
        &self.impacts
    }

    /// Simultaneous impacts of a [hybrid](crate::hybrid) system whose unknown order determines the subsequent motion,
    /// in the order of their occurrence. The motion after such an impact is one of several equally possible ones.
    #[must_use]
    pub fn ambiguities(&self) -> &[Ambiguity<T>] {
        &self.ambiguities
    }

    /// Time intervals in which an event may have occurred more often than reported by [`events`](Self::events); empty
    /// if all roots were found.
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    ///
    /// let clock = FnSystem(|_t: f64, _x: &SVector<f64, 1>| SVector::from([1.0]));
    /// let ticks = || Event::new(|t, _x: &SVector<f64, 1>| (1e5_f64 * t).sin());
    /// let solution = Rk4::new(1.0).solve_with(&clock, 0.0, 10.0, [0.0], &[ticks()])?;
    /// let [missed] = solution.missed() else { panic!("318,311 zeros in ten steps") };
    /// assert_eq!((missed.index, missed.from, missed.to), (0, 0.0, 10.0));
    /// println!("{missed}");
    /// # Ok::<(), pendulum_core::SolveError<f64, 1>>(())
    /// ```
    #[must_use]
    pub fn missed(&self) -> &[Missed<T>] {
        &self.missed
    }

    /// Evaluations and steps of the integration.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// State at the time `t`, by the dense output of the method. At an accepted point, exactly that point; at a reset,
    /// the state after it.
    ///
    /// # Errors
    /// If `t` is outside of the span, or NaN.
    pub fn at(&self, t: T) -> Result<SVector<T, N>, OutsideSpan> {
        let (start, end) = (self.t[0], self.t[self.t.len() - 1]);
        let forward = start <= end;
        let inside = if forward {
            start <= t && t <= end
        } else {
            end <= t && t <= start
        };
        if !inside {
            return Err(OutsideSpan {
                t: t.to_f64(),
                start: start.to_f64(),
                end: end.to_f64(),
            });
        }
        // Last point not after `t`, which exists inside the span.
        let left = self
            .t
            .partition_point(|&point| if forward { point <= t } else { point >= t })
            - 1;
        if self.t[left] == t && self.t[left].has_same_slopes(&t) {
            return Ok(self.x[left]);
        }
        // the last point, at a time that depends on other variables than `t`
        let left = left.min(self.t.len() - 2);
        let right = left + 1;
        let theta = (t - self.t[left]) / (self.t[right] - self.t[left]);
        let first = if left == 0 { 0 } else { self.ends[left - 1] };
        let coefficients = &self.coefficients[first..self.ends[left]];
        Ok(polynomial(&self.x[left], coefficients, theta))
    }

    /// States at many times, in any order.
    ///
    /// # Errors
    /// If a time is outside of the span.
    pub fn sample(&self, times: impl IntoIterator<Item = T>) -> Result<Vec<SVector<T, N>>, OutsideSpan> {
        times.into_iter().map(|t| self.at(t)).collect()
    }
}

/// Part of a step that an [`Observer`] needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Need {
    /// Nothing: [`Observer::step`] need not be called.
    Nothing,
    /// The ends of the step alone.
    Ends,
    /// All states within the step.
    Inside,
}

/// Observer of a trajectory during the integration, for
/// [`ObservedEnsemble::observe`](crate::ObservedEnsemble::observe). A [`Solution`] is an observer that records
/// everything.
pub trait Observer<T, const N: usize> {
    /// The part of a step from `t0` to `t1` that is needed: by default, all of it. [`step`](Self::step) may receive
    /// more. The less is needed, the less time the step takes.
    fn needs(&self, _t0: T, _t1: T) -> Need {
        Need::Inside
    }

    /// True if every step is kept; methods with fixed steps then reject more than ten million steps. False by default.
    fn keeps_all(&self) -> bool {
        false
    }

    /// Called before the first step with the initial time and state, which is the one on the constraints of the system.
    fn start(&mut self, _t: T, _x: &SVector<T, N>) {}

    /// True if the integration shall end, which it does after the current step, with
    /// [`Reason::Cancelled`](crate::Reason::Cancelled). False by default.
    fn is_cancelled(&self) -> bool {
        false
    }

    /// Called before the first step with the tolerance of the step size control; not called for fixed steps.
    fn within(&mut self, _tolerance: Tolerance<T>) {}

    /// Called after each step that is needed, or after the part of a step before an event acts. Steps are contiguous
    /// except for jumps and for steps that are left out.
    fn step(&mut self, dense: &Dense<'_, T, N>);

    /// Called when a reset or an impact changes the state at the current time.
    fn jump(&mut self, _t: T, _x: SVector<T, N>) {}

    /// Called when an event has occurred in the last step.
    fn event(&mut self, _event: Occurrence<T, N>) {}

    /// Called when an event may have occurred in the last step without being found.
    fn missed(&mut self, _missed: Missed<T>) {}

    /// Called at a mode switch of a hybrid system; the mode holds from the time `_from`. `_from` lies ahead of the
    /// current time while rebounds too low to resolve would continue. A mode switch before `_from` interrupts these
    /// rebounds.
    fn mode(&mut self, _from: T, _mode: Mode) {}

    /// Called at the end with the statistics; not called if the trajectory cannot start.
    fn finish(&mut self, _statistics: Statistics) {}

    /// Called at an impact.
    fn impact(&mut self, _impact: Impact<T, N>) {}

    /// Called when the last impacts were simultaneous and their unknown order determines the subsequent motion.
    fn ambiguity(&mut self, _ambiguity: Ambiguity<T>) {}
}

impl<O: Observer<T, N> + ?Sized, T, const N: usize> Observer<T, N> for &mut O {
    forward! { self => (**self);
        needs(t0: T, t1: T) -> Need;
        keeps_all() -> bool;
        is_cancelled() -> bool;
        [mut] start(t: T, x: &SVector<T, N>);
        [mut] within(tolerance: Tolerance<T>);
        [mut] step(dense: &Dense<'_, T, N>);
        [mut] jump(t: T, x: SVector<T, N>);
        [mut] event(event: Occurrence<T, N>);
        [mut] missed(missed: Missed<T>);
        [mut] mode(from: T, mode: Mode);
        [mut] finish(statistics: Statistics);
        [mut] impact(impact: Impact<T, N>);
        [mut] ambiguity(ambiguity: Ambiguity<T>);
    }
}

/// Records everything.
impl<T: Float, const N: usize> Observer<T, N> for Solution<T, N> {
    fn keeps_all(&self) -> bool {
        true
    }

    fn step(&mut self, dense: &Dense<'_, T, N>) {
        let step = dense.step();
        self.t.push(step.t1);
        self.x.push(step.x1);
        self.coefficients.extend(dense.terms());
        self.ends.push(self.coefficients.len());
    }

    fn jump(&mut self, t: T, x: SVector<T, N>) {
        self.t.push(t);
        self.x.push(x);
        self.ends.push(self.coefficients.len());
    }

    fn event(&mut self, event: Occurrence<T, N>) {
        self.events.push(event);
    }

    fn within(&mut self, tolerance: Tolerance<T>) {
        self.tolerance = Some(tolerance);
    }

    /// Merges consecutive steps into one interval.
    fn missed(&mut self, missed: Missed<T>) {
        let last = self.missed.iter_mut().rfind(|last| last.index == missed.index);
        match last.filter(|last| last.to == missed.from) {
            Some(last) => last.to = missed.to,
            None => self.missed.push(missed),
        }
    }

    fn mode(&mut self, from: T, mode: Mode) {
        // the new mode interrupts unfinished rebounds
        for (before, _) in self.modes.iter_mut().rev().take_while(|(before, _)| *before > from) {
            *before = from;
        }
        self.modes.push((from, mode));
    }

    fn finish(&mut self, statistics: Statistics) {
        self.statistics = statistics;
    }

    fn impact(&mut self, impact: Impact<T, N>) {
        self.impacts.push(impact);
    }

    fn ambiguity(&mut self, ambiguity: Ambiguity<T>) {
        self.ambiguities.push(ambiguity);
    }
}

/// Records only the events.
impl<T, const N: usize> Observer<T, N> for Vec<Occurrence<T, N>> {
    fn step(&mut self, _dense: &Dense<'_, T, N>) {}

    fn event(&mut self, event: Occurrence<T, N>) {
        self.push(event);
    }
}

/// Abbreviated, since a trajectory may have a million points.
impl<T: fmt::Debug, const N: usize> fmt::Debug for Solution<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let last = self.t.len() - 1;
        f.debug_struct("Solution")
            .field("points", &self.t.len())
            .field("start", &(&self.t[0], &self.x[0]))
            .field("end", &(&self.t[last], &self.x[last]))
            .field("statistics", &self.statistics)
            .finish_non_exhaustive()
    }
}

/// A deserialised solution before validation.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(bound(deserialize = "T: Float + serde::Deserialize<'de>"))]
struct Unchecked<T, const N: usize> {
    t: Vec<T>,
    x: Vec<SVector<T, N>>,
    coefficients: Vec<SVector<T, N>>,
    ends: Vec<usize>,
    events: Vec<Occurrence<T, N>>,
    #[serde(default)]
    modes: Vec<(T, Mode)>,
    #[serde(default)]
    impacts: Vec<Impact<T, N>>,
    #[serde(default)]
    ambiguities: Vec<Ambiguity<T>>,
    statistics: Statistics,
    #[serde(default = "Vec::new")]
    missed: Vec<Missed<T>>,
    #[serde(default)]
    tolerance: Option<Tolerance<T>>,
}

#[cfg(feature = "serde")]
impl<T: Float, const N: usize> TryFrom<Unchecked<T, N>> for Solution<T, N> {
    type Error = &'static str;

    fn try_from(record: Unchecked<T, N>) -> Result<Self, Self::Error> {
        let Some(steps) = record.t.len().checked_sub(1) else {
            return Err("a solution has at least one point");
        };
        let rows = record.ends.len() == steps
            && record.ends.is_sorted()
            && record.ends.last().map_or(0, |&end| end) == record.coefficients.len();
        if record.x.len() != record.t.len() || !rows {
            return Err("a solution has a state for each time and coefficients for each step");
        }
        let forward = record.t[0] <= record.t[steps];
        let ordered = |pair: &[T]| pair[0] == pair[1] || (pair[0] < pair[1]) == forward;
        if !record.t.windows(2).all(ordered) {
            return Err("the times of a solution ascend or descend");
        }
        Ok(Self {
            t: record.t,
            x: record.x,
            coefficients: record.coefficients,
            ends: record.ends,
            events: record.events,
            modes: record.modes,
            impacts: record.impacts,
            ambiguities: record.ambiguities,
            statistics: record.statistics,
            missed: record.missed,
            tolerance: record.tolerance,
        })
    }
}

debug_as_display! { [] OutsideSpan; }

/// A time outside of the span of a solution.
#[derive(Clone, Copy, PartialEq)]
pub struct OutsideSpan {
    /// The requested time.
    pub t: f64,
    /// First time of the solution.
    pub start: f64,
    /// Last time of the solution; before `start` if it was integrated backward.
    pub end: f64,
}

impl fmt::Display for OutsideSpan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "t = {} is outside of the solution, which runs from t = {} to {}; integrate further",
            self.t, self.start, self.end
        )
    }
}

impl Error for OutsideSpan {}
