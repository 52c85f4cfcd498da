//! Integration of one trajectory.

use std::fmt;

use nalgebra::SVector;
use pendulum_core::dense::Dense;
use pendulum_core::hybrid::{self, Mode};
use pendulum_core::{
    Event as CoreEvent, Missed, Need, Observer, Occurrence as CoreOccurrence, Reason, Solution, Statistics, System,
};

use crate::event::Event;
use crate::method::{Method, Task};
use crate::motion::{Impact, Motion, Occurrence, Stopped};
use crate::padded::{Padded, active, padded};
use crate::sampler::{Sampler, check_times};
use crate::worker::Cancel;

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

/// Records a trajectory, whole or at given times.
struct Recorder<'t, const N: usize> {
    solution: Solution<f64, N>,
    sampler: Option<Sampler<'t>>,
    /// True for each event that is terminal.
    terminal: &'t [bool],
    /// Index of the terminal event that occurred.
    ended_by: Option<usize>,
    last: (f64, SVector<f64, N>),
    cancel: Option<&'t Cancel<'t>>,
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
