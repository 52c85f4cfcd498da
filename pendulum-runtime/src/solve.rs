//! Integration of one trajectory.

use std::fmt;

use nalgebra::SVector;
use pendulum_core::dense::Dense;
use pendulum_core::hybrid::{self, Mode};
use pendulum_core::{Direction, Statistics, System};
use pendulum_core::{Event as CoreEvent, Missed, Need, Observer, Occurrence as CoreOccurrence, Reason, Solution};

use crate::error::Error;
use crate::method::{Method, Task};
use crate::padded::{Padded, active, padded};

/// An event: a function of time and state that passes zero.
pub struct Event<'e> {
    kind: Kind<'e>,
    name: String,
    direction: Direction,
    terminal: bool,
}

/// Function of the time and the state.
type Function<'e> = Box<dyn Fn(f64, &[f64]) -> f64 + Send + Sync + 'e>;

enum Kind<'e> {
    Function(Function<'e>),
    Declared,
    Value(f64),
}

impl<'e> Event<'e> {
    /// An event where a function of the time and the state is zero.
    pub fn new(function: impl Fn(f64, &[f64]) -> f64 + Send + Sync + 'e) -> Self {
        Self::of(Kind::Function(Box::new(function)), "")
    }

    /// An event of the declaration.
    #[must_use]
    pub fn declared(name: &str) -> Self {
        Self::of(Kind::Declared, name)
    }

    /// An event where an output or a component of the state has a value.
    #[must_use]
    pub fn value(name: &str, value: f64) -> Self {
        Self::of(Kind::Value(value), name)
    }

    fn of(kind: Kind<'e>, name: &str) -> Self {
        Self {
            kind,
            name: name.to_owned(),
            direction: Direction::Either,
            terminal: false,
        }
    }

    /// Restricts the event to zeros at which the function rises, in the direction of the integration.
    #[must_use]
    pub fn rising(mut self) -> Self {
        self.direction = Direction::Rising;
        self
    }

    /// Restricts the event to zeros at which the function falls.
    #[must_use]
    pub fn falling(mut self) -> Self {
        self.direction = Direction::Falling;
        self
    }

    /// Ends the integration at the event.
    #[must_use]
    pub fn terminal(mut self) -> Self {
        self.terminal = true;
        self
    }

    /// The event as one of a model.
    pub(crate) fn at<'m, const N: usize>(
        &'m self,
        model: &'m Padded<f64, N>,
        length: usize,
    ) -> Result<CoreEvent<'m, f64, N>, Error> {
        let tape = model.tape();
        let mut is_kink = false;
        let event = match &self.kind {
            Kind::Function(function) => {
                CoreEvent::new(move |t, x: &SVector<f64, N>| function(t, &x.as_slice()[..length]))
            }
            Kind::Declared => {
                let events = tape.events().iter().map(|(name, _)| *name);
                is_kink = tape.events()[Error::index_of("event", &self.name, events)?].1;
                let routines = tape.routines().iter().map(|routine| routine.name());
                let routine = Error::index_of("event", &self.name, routines)?;
                CoreEvent::new(move |t, x: &SVector<f64, N>| {
                    let mut value = [f64::NAN];
                    let given = pendulum_core::tape::Given {
                        inputs: model.inputs(),
                        ..Default::default()
                    };
                    model.evaluate(routine, t, x, &given, &mut value);
                    value[0]
                })
            }
            &Kind::Value(value) => {
                let components = tape.layout().components();
                if let Some(n) = components.iter().position(|name| *name == self.name) {
                    CoreEvent::new(move |_, x: &SVector<f64, N>| x[n] - value)
                } else {
                    let names = tape.outputs().iter().copied();
                    let known = names.clone().chain(components.iter().map(String::as_str));
                    let unknown = || Error::unknown("output or component", &self.name, known);
                    let n = names.clone().position(|name| name == self.name).ok_or_else(unknown)?;
                    CoreEvent::new(move |t, x: &SVector<f64, N>| {
                        let (mut next, mut found) = (0, f64::NAN);
                        model.each_output(t, x, &mut |_, output| {
                            if next == n {
                                found = output;
                            }
                            next += 1;
                        });
                        found - value
                    })
                }
            }
        };
        let event = match self.direction {
            Direction::Rising => event.rising(),
            Direction::Falling => event.falling(),
            _ => event,
        };
        let event = if self.terminal { event.terminal() } else { event };
        Ok(if is_kink { event.restart() } else { event })
    }
}

impl fmt::Debug for Event<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Event")
            .field("name", &self.name)
            .field("direction", &self.direction)
            .field("terminal", &self.terminal)
            .finish_non_exhaustive()
    }
}

/// Options of an integration.
#[derive(Default)]
pub struct Options<'e> {
    /// Events.
    pub events: Vec<Event<'e>>,
    /// Times at which states are kept, in the direction of the integration; `None` for the ends of all steps, and all
    /// states between them.
    pub times: Option<Vec<f64>>,
    /// Ends the integration with what was reached when it returns true. It is called after each step, on the thread
    /// that integrates.
    pub cancel: Option<&'e (dyn Fn() -> bool + Sync)>,
}

impl fmt::Debug for Options<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Options")
            .field("events", &self.events)
            .field("times", &self.times)
            .finish_non_exhaustive()
    }
}

/// A trajectory.
pub struct Motion {
    t: Vec<f64>,
    /// States, one after the other.
    x: Vec<f64>,
    length: usize,
    end: (f64, Vec<f64>),
    occurrences: Vec<Occurrence>,
    modes: Vec<(f64, String)>,
    impacts: Vec<Impact>,
    warnings: Vec<String>,
    statistics: Statistics,
    ended_by: Option<usize>,
    between: Option<Box<dyn Between>>,
}

/// An event that occurred.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Occurrence {
    /// Index of the event among those given.
    pub index: usize,
    /// Time.
    pub t: f64,
    /// State.
    pub x: Vec<f64>,
}

/// An impact at a stop or a wall.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Impact {
    /// Time.
    pub t: f64,
    /// State before.
    pub before: Vec<f64>,
    /// State after.
    pub after: Vec<f64>,
    /// Names of the constraints that push, and their impulses in N s or N m s.
    pub impulses: Vec<(String, f64)>,
}

/// States between the ends of steps.
trait Between: Send + Sync {
    fn at(&self, t: f64, length: usize) -> Result<Vec<f64>, Error>;
}

impl<const N: usize> Between for Solution<f64, N> {
    fn at(&self, t: f64, length: usize) -> Result<Vec<f64>, Error> {
        Ok(active(Self::at(self, t)?, length))
    }
}

impl Motion {
    /// Times of the states that were kept.
    #[must_use]
    pub fn t(&self) -> &[f64] {
        &self.t
    }

    /// States that were kept, one after the other.
    #[must_use]
    pub fn x(&self) -> &[f64] {
        &self.x
    }

    /// The `n`th state that was kept.
    #[must_use]
    pub fn state(&self, n: usize) -> &[f64] {
        &self.x[n * self.length..(n + 1) * self.length]
    }

    /// Last time and state.
    #[must_use]
    pub fn end(&self) -> (f64, &[f64]) {
        (self.end.0, &self.end.1)
    }

    /// State at a time of the motion.
    ///
    /// # Errors
    /// If the time lies outside of the motion, or if only the states at given times were kept.
    pub fn at(&self, t: f64) -> Result<Vec<f64>, Error> {
        let only = || Error::Setting {
            what: "times".to_owned(),
            rule: "only the states at these times were kept; solve without them for states at any time".to_owned(),
        };
        self.between.as_ref().ok_or_else(only)?.at(t, self.length)
    }

    /// Events that occurred, in order of time.
    #[must_use]
    pub fn occurrences(&self) -> &[Occurrence] {
        &self.occurrences
    }

    /// Mode switches, each with its time and the constraints that stick or touch from then on.
    #[must_use]
    pub fn modes(&self) -> &[(f64, String)] {
        &self.modes
    }

    /// Impacts, in order of time.
    #[must_use]
    pub fn impacts(&self) -> &[Impact] {
        &self.impacts
    }

    /// Reasons to doubt the motion: events that may have been missed, simultaneous impacts whose order is unknown.
    #[must_use]
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Numbers of evaluations, steps and so on.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// Index of the terminal event that ended the motion.
    #[must_use]
    pub fn ended_by(&self) -> Option<usize> {
        self.ended_by
    }
}

impl fmt::Debug for Motion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Motion")
            .field("end", &self.end)
            .field("points", &self.t.len())
            .finish_non_exhaustive()
    }
}

/// Error: an integration did not start, or stopped early.
#[derive(Debug)]
#[non_exhaustive]
pub struct Stopped {
    /// Reason.
    pub error: Box<Error>,
    /// Motion up to there, if it started.
    pub motion: Option<Box<Motion>>,
}

impl<E: Into<Error>> From<E> for Stopped {
    fn from(error: E) -> Self {
        Self {
            error: Box::new(error.into()),
            motion: None,
        }
    }
}

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.motion {
            Some(motion) => write!(f, "stopped at t = {:?}: {}", motion.end.0, self.error),
            None => self.error.fmt(f),
        }
    }
}

impl std::error::Error for Stopped {}

/// Checks that times are finite and ascend, or descend if the integration is backward, within the span.
pub(crate) fn check_times(times: &[f64], [t0, t1]: [f64; 2]) -> Result<(), Error> {
    let direction = if t1 < t0 { -1.0 } else { 1.0 };
    let wrong = |rule: &str| {
        let what = "times".to_owned();
        let rule = rule.to_owned();
        Err(Error::Setting { what, rule })
    };
    if times.iter().any(|t| !t.is_finite()) {
        return wrong("they must be finite");
    }
    if times.windows(2).any(|pair| (pair[1] - pair[0]) * direction < 0.0) {
        return wrong("they must be sorted in the direction of the integration");
    }
    let outside = |t: &f64| (t - t0) * direction < 0.0 || (t - t1) * direction > 0.0;
    if times.iter().any(outside) {
        return wrong("they must lie within the span of the integration");
    }
    Ok(())
}

/// Samples of a trajectory at given times.
pub(crate) struct Sampler<'t> {
    times: &'t [f64],
    forward: bool,
    pub(crate) taken: usize,
    length: usize,
    pub(crate) x: Vec<f64>,
}

impl<'t> Sampler<'t> {
    pub(crate) fn new(times: &'t [f64], [t0, t1]: [f64; 2], length: usize) -> Self {
        Self {
            times,
            forward: t1 >= t0,
            taken: 0,
            length,
            x: Vec::with_capacity(times.len() * length),
        }
    }

    /// Takes the samples at the start.
    pub(crate) fn start<const N: usize>(&mut self, t0: f64, x0: &SVector<f64, N>) {
        while self.next().is_some_and(|t| t == t0) {
            self.take(x0);
        }
    }

    fn next(&self) -> Option<f64> {
        self.times.get(self.taken).copied()
    }

    fn take<const N: usize>(&mut self, x: &SVector<f64, N>) {
        self.x.extend_from_slice(&x.as_slice()[..self.length]);
        self.taken += 1;
    }

    /// True if there are samples in a step to this time.
    pub(crate) fn has_any_until(&self, t1: f64) -> bool {
        self.next()
            .is_some_and(|t| if self.forward { t <= t1 } else { t >= t1 })
    }

    pub(crate) fn step<const N: usize>(&mut self, dense: &Dense<'_, f64, N>) {
        let step = dense.step();
        while self.has_any_until(step.t1) {
            let Some(t) = self.next() else { return };
            let x = if t == step.t1 { step.x1 } else { dense.at(t) };
            self.take(&x);
        }
    }
}

/// Records a trajectory, whole or at given times.
struct Recorder<'t, const N: usize> {
    solution: Solution<f64, N>,
    sampler: Option<Sampler<'t>>,
    /// True for each event that is terminal.
    terminal: &'t [bool],
    /// Index of the terminal event that occurred.
    ended_by: Option<usize>,
    last: (f64, SVector<f64, N>),
    cancel: Option<&'t (dyn Fn() -> bool + Sync)>,
}

impl<const N: usize> Observer<f64, N> for Recorder<'_, N> {
    fn start(&mut self, t: f64, x: &SVector<f64, N>) {
        self.solution = Solution::start(t, *x);
        self.last = (t, *x);
        if let Some(sampler) = &mut self.sampler {
            sampler.start(t, x);
        }
    }

    fn needs(&self, _t0: f64, t1: f64) -> Need {
        match &self.sampler {
            Some(sampler) if !sampler.has_any_until(t1) => Need::Ends,
            _ => Need::Inside,
        }
    }

    fn keeps_all(&self) -> bool {
        self.sampler.is_none()
    }

    fn is_cancelled(&self) -> bool {
        self.cancel.is_some_and(|cancel| cancel())
    }

    fn step(&mut self, dense: &Dense<'_, f64, N>) {
        self.last = (dense.step().t1, dense.step().x1);
        match &mut self.sampler {
            Some(sampler) => sampler.step(dense),
            None => self.solution.step(dense),
        }
    }

    fn jump(&mut self, t: f64, x: SVector<f64, N>) {
        self.last = (t, x);
        if self.sampler.is_none() {
            self.solution.jump(t, x);
        }
    }

    fn event(&mut self, event: CoreOccurrence<f64, N>) {
        if self.terminal[event.index] {
            self.ended_by.get_or_insert(event.index);
        }
        self.solution.event(event);
    }

    fn missed(&mut self, missed: Missed<f64>) {
        Observer::missed(&mut self.solution, missed);
    }

    fn mode(&mut self, from: f64, mode: Mode) {
        self.solution.mode(from, mode);
    }

    fn finish(&mut self, statistics: Statistics) {
        self.solution.finish(statistics);
    }

    fn impact(&mut self, impact: hybrid::Impact<f64, N>) {
        self.solution.impact(impact);
    }

    fn ambiguity(&mut self, ambiguity: hybrid::Ambiguity<f64>) {
        self.solution.ambiguity(ambiguity);
    }
}

/// Integration by a method.
struct Follow<'m, 't, const N: usize> {
    model: &'m Padded<f64, N>,
    span: [f64; 2],
    x0: SVector<f64, N>,
    events: &'m [CoreEvent<'m, f64, N>],
    recorder: &'m mut Recorder<'t, N>,
}

impl<const N: usize> Task<N> for Follow<'_, '_, N> {
    type Output = Result<SVector<f64, N>, Reason>;

    fn by(self, method: impl pendulum_core::Method<Padded<f64, N>, f64, N>) -> Self::Output {
        let [t0, t1] = self.span;
        method.follow(self.model, t0, t1, self.x0, self.events, self.recorder)
    }
}

pub(crate) fn solve<const N: usize>(
    model: &Padded<f64, N>,
    method: &Method,
    span: [f64; 2],
    x0: &[f64],
    options: &Options<'_>,
) -> Result<Motion, Stopped> {
    let (length, x0) = (x0.len(), padded(x0));
    let events = options.events.iter().map(|event| event.at(model, length));
    let events: Vec<CoreEvent<'_, f64, N>> = events.collect::<Result<_, _>>()?;
    if let Some(times) = &options.times {
        check_times(times, span)?;
    }
    let sampler = options.times.as_ref().map(|times| Sampler::new(times, span, length));
    let terminal: Vec<bool> = options.events.iter().map(|event| event.terminal).collect();
    let mut recorder = Recorder {
        solution: Solution::start(span[0], x0),
        sampler,
        terminal: &terminal,
        ended_by: None,
        last: (span[0], x0),
        cancel: options.cancel,
    };
    let task = Follow {
        model,
        span,
        x0,
        events: &events,
        recorder: &mut recorder,
    };
    let ended = method.run(task);
    let end = *ended.as_ref().unwrap_or(&recorder.last.1);
    let motion = motion(model, recorder, end, length);
    match ended {
        Ok(_) => Ok(motion),
        Err(reason @ Reason::InvalidInput { .. }) => Err(reason.into()),
        Err(reason) => Err(Stopped {
            error: Box::new(reason.into()),
            motion: Some(Box::new(motion)),
        }),
    }
}

/// Converts what was recorded.
fn motion<const N: usize>(
    model: &Padded<f64, N>,
    recorder: Recorder<'_, N>,
    end: SVector<f64, N>,
    length: usize,
) -> Motion {
    let solution = recorder.solution;
    let constraints = model.hybrid().map_or(&[][..], |hybrid| hybrid.constraints());
    let occurrences = solution.events().iter().map(|event| Occurrence {
        index: event.index,
        t: event.t,
        x: active(event.x, length),
    });
    let modes = solution.modes().iter();
    let impacts = solution.impacts().iter().map(|impact| Impact {
        t: impact.t,
        before: active(impact.before, length),
        after: active(impact.after, length),
        impulses: impact
            .pushes()
            .map(|(n, impulse)| (constraints[n].name.to_owned(), impulse))
            .collect(),
    });
    let missed = solution.missed().iter().map(ToString::to_string);
    let ambiguities = solution.ambiguities().iter().map(|ambiguity| {
        let names: Vec<_> = ambiguity.constraints().map(|n| constraints[n].name).collect();
        format!(
            "`{}` are reached at the same time, t = {:?}; the order of these impacts is unknown, and changes a rate by \
             {:.3e}",
            names.join("`, `"),
            ambiguity.t,
            ambiguity.difference
        )
    });
    let (t, x) = match &recorder.sampler {
        Some(sampler) => (sampler.times[..sampler.taken].to_vec(), sampler.x.clone()),
        None => (
            solution.t().to_vec(),
            solution.x().iter().flat_map(|x| active(*x, length)).collect(),
        ),
    };
    Motion {
        t,
        x,
        length,
        end: (recorder.last.0, active(end, length)),
        occurrences: occurrences.collect(),
        modes: modes
            .map(|(t, mode)| (*t, mode.describe(constraints).to_string()))
            .collect(),
        impacts: impacts.collect(),
        warnings: missed.chain(ambiguities).collect(),
        statistics: solution.statistics(),
        ended_by: recorder.ended_by,
        between: match recorder.sampler {
            Some(_) => None,
            None => Some(Box::new(solution)),
        },
    }
}
