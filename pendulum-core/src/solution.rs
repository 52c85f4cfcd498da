//! What an integration returns: the accepted points and the states between them.

use std::error::Error;
use std::fmt;

use nalgebra::SVector;

use crate::dense::{Dense, polynomial};
use crate::error::debug_as_display;
use crate::event::{Missed, Occurrence};
use crate::hybrid::{Ambiguity, Impact, Mode};
use crate::real::Float;
use crate::step_size::Tolerance;

mod below;

pub use crate::statistics::Statistics;
pub use below::BelowTolerance;

/// A trajectory: the accepted points, and dense output between them.
///
/// There is always at least one point, the initial one; it stays alone if the integration was asked to end where it starts.
/// Times ascend, or descend if it went backward in time; where an event reset the state, and at an impact, a time
/// stands twice, with the states before and after.
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
    /// Those of the steps, one after the other: `x(t_i + theta h) = x_i + c_1 theta + c_2 theta^2 + ..`.
    coefficients: Vec<SVector<T, N>>,
    /// Where those of each step end.
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
    /// The solution that consists of its initial point: an [`Observer`] that keeps what follows.
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

    /// The times of the accepted points, the initial one first; the last is the end of the span exactly.
    #[must_use]
    pub fn t(&self) -> &[T] {
        &self.t
    }

    /// The states at the times [`t`](Self::t).
    #[must_use]
    pub fn x(&self) -> &[SVector<T, N>] {
        &self.x
    }

    /// The accepted points: each time with the state there.
    pub fn points(&self) -> impl DoubleEndedIterator<Item = (T, &SVector<T, N>)> + ExactSizeIterator {
        self.t.iter().copied().zip(&self.x)
    }

    /// The last time and the state there.
    #[must_use]
    pub fn last(&self) -> (T, SVector<T, N>) {
        let last = self.t.len() - 1;
        (self.t[last], self.x[last])
    }

    /// The state at the end, which is the last good one if the integration stopped early.
    #[must_use]
    pub fn end(&self) -> SVector<T, N> {
        self.last().1
    }

    /// The events that occurred, in the order in which they did.
    #[must_use]
    pub fn events(&self) -> &[Occurrence<T, N>] {
        &self.events
    }

    /// The modes of a [hybrid](crate::hybrid) system, each with the time at which it begins; empty for other systems.
    ///
    /// An impact begins a mode, even one with the same constraints held as before: in [`t`](Self::t) its time then
    /// stands twice, with the states before and after.
    ///
    /// The times ascend, from the start of the span to its end at most; the last entry is the mode at the end. Rebounds
    /// too low to follow are replaced by lasting contact from the first of them on. The mode of this contact has the time
    /// at which the last rebound would have ended, a little later, or at which the next mode begins.
    #[must_use]
    pub fn modes(&self) -> &[(T, Mode)] {
        &self.modes
    }

    /// The impacts of a [hybrid](crate::hybrid) system, in the order in which they occurred; empty for other systems.
    ///
    /// Impacts at the same time are one. Rebounds too low to follow are left out, and the impact before them is one
    /// without a rebound.
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

    /// The impacts of a [hybrid](crate::hybrid) system at the same time whose order decides how the motion goes on, and
    /// could not be resolved, in the order in which they occurred. What follows one of them is one of several motions
    /// that are equally possible.
    #[must_use]
    pub fn ambiguities(&self) -> &[Ambiguity<T>] {
        &self.ambiguities
    }

    /// The times in which an event may have occurred more often than [`events`](Self::events) shows; empty where all
    /// zeros were found.
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

    /// How much work the integration was.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// The state at the time `t`, by the dense output of the method; at an accepted point, that point exactly, and where
    /// the state was reset, the state after.
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
        // The last point that is not after `t`: inside the span there is one.
        let left = self
            .t
            .partition_point(|&point| if forward { point <= t } else { point >= t })
            - 1;
        if self.t[left] == t {
            return Ok(self.x[left]);
        }
        let right = left + 1;
        let theta = (t - self.t[left]) / (self.t[right] - self.t[left]);
        let first = if left == 0 { 0 } else { self.ends[left - 1] };
        let coefficients = &self.coefficients[first..self.ends[left]];
        Ok(polynomial(&self.x[left], coefficients, theta))
    }

    /// The states at many times, in any order.
    ///
    /// # Errors
    /// If one of them is outside of the span.
    pub fn sample(&self, times: impl IntoIterator<Item = T>) -> Result<Vec<SVector<T, N>>, OutsideSpan> {
        times.into_iter().map(|t| self.at(t)).collect()
    }
}

/// What sees a trajectory on its way, step by step: for [`ObservedEnsemble::observe`](crate::ObservedEnsemble::observe). A [`Solution`]
/// keeps all of it.
pub trait Observer<T, const N: usize> {
    /// Whether the states within a step from `t0` to `t1` are of interest: by default they are.
    ///
    /// Where they are not, [`step`](Self::step) may show its ends alone, which takes less time.
    fn looks_into(&self, _t0: T, _t1: T) -> bool {
        true
    }

    /// Whether every step is kept: then methods with steps of equal length refuse to take more than ten million. By
    /// default it is not so.
    fn keeps_all(&self) -> bool {
        false
    }

    /// The tolerance that the steps will keep, before the first of them; not where their length is given.
    fn within(&mut self, _tolerance: Tolerance<T>) {}

    /// A step, or the part of one after which an event acts. Steps follow each other without gaps, but for jumps.
    fn step(&mut self, dense: &Dense<'_, T, N>);

    /// The state becomes another one at the time that was reached: by a reset, or by an impact.
    fn jump(&mut self, _t: T, _x: SVector<T, N>) {}

    /// An event occurred, in the step that was seen last.
    fn event(&mut self, _event: Occurrence<T, N>) {}

    /// An event may have occurred more often than was found, in the step that was seen last.
    fn missed(&mut self, _missed: Missed<T>) {}

    /// Another mode of a hybrid system holds from this time on. The time lies ahead where rebounds too low to follow would
    /// still last; if another mode begins before it, the rebounds were not at their end.
    fn mode(&mut self, _from: T, _mode: Mode) {}

    /// The end, after so much work; not of a trajectory that cannot begin.
    fn finish(&mut self, _statistics: Statistics) {}

    /// An impact.
    fn impact(&mut self, _impact: Impact<T, N>) {}

    /// The order of the impacts that were seen last decides how the motion goes on, and is not known.
    fn ambiguity(&mut self, _ambiguity: Ambiguity<T>) {}
}

/// All of it.
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

    /// Steps that follow each other are one part.
    fn missed(&mut self, missed: Missed<T>) {
        let last = self.missed.iter_mut().rfind(|last| last.index == missed.index);
        match last.filter(|last| last.to == missed.from) {
            Some(last) => last.to = missed.to,
            None => self.missed.push(missed),
        }
    }

    fn mode(&mut self, from: T, mode: Mode) {
        // rebounds that another mode interrupts were not at their end
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

/// Its events alone.
impl<T, const N: usize> Observer<T, N> for Vec<Occurrence<T, N>> {
    fn step(&mut self, _dense: &Dense<'_, T, N>) {}

    fn event(&mut self, event: Occurrence<T, N>) {
        self.push(event);
    }
}

/// In short: a trajectory may have a million points.
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

/// What is read, before it is known to be a solution.
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

/// A time at which a solution has no state.
#[derive(Clone, Copy, PartialEq)]
pub struct OutsideSpan {
    /// The time asked for.
    pub t: f64,
    /// The first time of the solution.
    pub start: f64,
    /// The last time of the solution; before `start` if it went backward.
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
