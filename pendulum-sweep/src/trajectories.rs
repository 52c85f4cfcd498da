//! Results extracted from whole trajectories.

use std::fmt::Debug;

use pendulum_core::dense::Dense;
use pendulum_core::nalgebra::SVector;
use pendulum_core::{
    Cast, EnsembleError, Event, Method, Need, ObservedEnsemble, Observer, Occurrence, Reason, Solution, System,
};
use serde_json::{Value, json};

use crate::design::Sweep;
use crate::ends::{Quantity, Trials, first_trial, is_of_start, of_first, of_state};
use crate::error::SweepError;
use crate::job::{Chunk, Failure, Job, Task};
use crate::table::Column;

/// Event of a model.
type EventOf<M, const N: usize> = Box<dyn for<'m> Fn(&'m M) -> Event<'m, f64, N> + Send + Sync>;

/// Task of [`Sweep::trajectories`].
pub struct Trajectories<X, F, M, const N: usize> {
    method: X,
    span: (f64, f64),
    trial: F,
    kept: Vec<Kept<M, N>>,
    events: Vec<EventOf<M, N>>,
    follow: Follow<X, M, N>,
    /// Number of trajectories integrated together.
    together: usize,
}

/// Integrates trajectories to their ends, and returns the reason for each one that failed.
type Follow<X, M, const N: usize> = fn(
    &X,
    (f64, f64),
    &[M],
    &[SVector<f64, N>],
    &[Vec<Event<'_, f64, N>>],
    &mut [Seen<'_, N>],
) -> Result<Vec<Option<Reason>>, SweepError>;

/// Results of a trajectory besides its end.
enum Kept<M, const N: usize> {
    /// The states at these times.
    At(Vec<f64>),
    /// A quantity at the end.
    End(Column, Quantity<M, N>),
    /// The extremum of a quantity and its time: the maximum of the quantity times the factor 1, or -1 for the minimum.
    Extremum(Column, f64, Quantity<M, N>),
    /// The number of occurrences of an event, and the time of the first one.
    Event(String, usize),
}

impl<const K: usize> Sweep<K> {
    /// Integrates models from `span.0` to `span.1` with any method, one by one on each core or
    /// [in lanes](Job::in_lanes). `trial` builds the model and the initial state of a point.
    ///
    /// The columns are the final time `t`, which terminal events make earlier, the final state by the names of its
    /// components, and the results requested by the methods of the job.
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    /// use pendulum_sweep::{Draw, Sweep};
    ///
    /// mechanism! {
    ///     pub Swing {
    ///         gravity: [0, -9.81, 0],
    ///         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle }
    ///     }
    /// }
    ///
    /// let table = Sweep::random("throw", [Draw::normal("rate", "rad/s", 5.0, 2.0)], 1000, 42)
    ///     .trajectories(Vern9::new(), (0.0, 5.0), |[rate]| Ok((Swing::new(SwingParams {})?, [0.0, rate])))
    ///     .event("over", |_| Event::new(|_, x: &SVector<f64, 2>| (0.5 * x[0]).cos()))
    ///     .largest("height", "m", |_, _, x| 1.0 - x[0].cos())
    ///     .at([1.0, 2.0])
    ///     .in_lanes()
    ///     .quiet()
    ///     .run()?;
    /// let over = table["over"].iter().filter(|&&count| count > 0.0).count();
    /// assert!(over > 100 && table["height"].iter().all(|&height| height <= 2.0));
    /// assert_eq!(table["angle at 2 s"].len(), 1000);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn trajectories<X, F, M, const N: usize>(
        self,
        method: X,
        span: (f64, f64),
        trial: F,
    ) -> Job<Trajectories<X, F, M, N>, K>
    where
        F: Fn([f64; K]) -> Result<(M, [f64; N]), Failure> + Sync,
        X: Method<M, f64, N> + Debug + Sync,
        M: System<f64, N>,
    {
        self.job(Trajectories {
            method,
            span,
            trial,
            kept: Vec::new(),
            events: Vec::new(),
            follow: one_by_one,
            together: 1,
        })
    }
}

impl<X, F, M, const K: usize, const N: usize> Job<Trajectories<X, F, M, N>, K> {
    /// Integrates many trajectories at a time in the SIMD lanes, for models and methods that support it. The numbers
    /// have the same bits.
    ///
    /// The speedup is largest for ends and states at given times; events and extrema evaluate the dense output of each
    /// step. Trajectories are integrated one by one if they have events that reset the state, for hybrid systems, and
    /// for the methods listed at [`Ensemble`](pendulum_core::Ensemble).
    pub fn in_lanes(mut self) -> Self
    where
        X: ObservedEnsemble<M, f64, N>,
        M: Cast<N>,
    {
        (self.task.follow, self.task.together) = (in_lanes, usize::MAX);
        self
    }

    /// Adds the states at these times, as `angle at 2 s`; NaN after the end.
    pub fn at(self, times: impl Into<Vec<f64>>) -> Self {
        self.keep(Kept::At(times.into()))
    }

    /// Adds a column computed from the model and its final state.
    pub fn value(
        self,
        name: &str,
        unit: &str,
        value: impl Fn(&M, f64, &SVector<f64, N>) -> f64 + Send + Sync + 'static,
    ) -> Self {
        self.keep(Kept::End(Column::new(name, unit), Box::new(value)))
    }

    /// Adds the maximum of a quantity, and its time, as `t of height`. The maximum is sampled at five places in each
    /// step and refined with the dense output.
    pub fn largest(
        self,
        name: &str,
        unit: &str,
        value: impl Fn(&M, f64, &SVector<f64, N>) -> f64 + Send + Sync + 'static,
    ) -> Self {
        self.keep(Kept::Extremum(Column::new(name, unit), 1.0, Box::new(value)))
    }

    /// Adds the minimum of a quantity, like [`largest`](Self::largest).
    pub fn least(
        self,
        name: &str,
        unit: &str,
        value: impl Fn(&M, f64, &SVector<f64, N>) -> f64 + Send + Sync + 'static,
    ) -> Self {
        self.keep(Kept::Extremum(Column::new(name, unit), -1.0, Box::new(value)))
    }

    /// Adds the number of occurrences of an event, and the time of the first one, as `t of over`; NaN if there is none.
    /// Terminal events end the trajectory, and may reset its state.
    pub fn event(
        mut self,
        name: &str,
        event: impl for<'m> Fn(&'m M) -> Event<'m, f64, N> + Send + Sync + 'static,
    ) -> Self {
        let index = self.task.events.len();
        self.task.events.push(Box::new(event));
        self.keep(Kept::Event(name.to_owned(), index))
    }

    fn keep(mut self, kept: Kept<M, N>) -> Self {
        self.task.kept.push(kept);
        self
    }
}

impl<X, F, M, const K: usize, const N: usize> Task<K> for Trajectories<X, F, M, N>
where
    F: Fn([f64; K]) -> Result<(M, [f64; N]), Failure> + Sync,
    X: Debug + Sync,
    M: System<f64, N>,
{
    fn describe(&self, sweep: &Sweep<K>) -> (Vec<Column>, Value) {
        let first = first_trial(sweep, &self.trial);
        let state = of_state::<N>(first.as_ref().and_then(|(model, _)| model.layout()));
        let mut columns = vec![Column::new("t", "s")];
        columns.extend(state.iter().cloned());
        for kept in &self.kept {
            let when = |name: &str| Column::new(&format!("t of {name}"), "s");
            match kept {
                Kept::At(times) => columns.extend(times.iter().flat_map(|t| {
                    let at = move |column: &Column| Column::new(&format!("{} at {t} s", column.name), &column.unit);
                    state.iter().map(at)
                })),
                Kept::End(column, _) => columns.push(column.clone()),
                Kept::Extremum(column, ..) => columns.extend([column.clone(), when(&column.name)]),
                Kept::Event(name, _) => columns.extend([Column::new(name, "1"), when(name)]),
            }
        }
        let first = of_first(first, self.span.0);
        let declaration = json!({ "trajectories": format!("{:?}", self.method), "span": self.span, "first": first });
        (columns, declaration)
    }

    fn run(&self, points: &[[f64; K]]) -> Result<Chunk, SweepError> {
        let samples = self.samples();
        if let Some((t, _)) = samples.iter().find(|(t, _)| !t.is_finite()) {
            return Err(SweepError::Invalid(format!(
                "states are kept at {t}: a time must be finite"
            )));
        }
        let mut chunk = Chunk::default();
        for points in points.chunks(self.together) {
            let trials = Trials::of(points, &self.trial);
            let Trials { models, starts, .. } = &trials;
            let events: Vec<Vec<_>> = models
                .iter()
                .map(|model| self.events.iter().map(|event| event(model)).collect())
                .collect();
            let members = models.iter().zip(starts);
            let seen = members.map(|(model, &start)| Seen {
                extrema: self.extrema(model, start),
                ..Seen::new(self.span, start, &samples, self.events.len())
            });
            let mut seen: Vec<_> = seen.collect();
            let reasons = (self.follow)(&self.method, self.span, models, starts, &events, &mut seen)?;
            trials.conclude(&mut chunk, self.width(), |index, numbers| {
                self.keep_of(&models[index], &seen[index], numbers);
                reasons[index]
            });
        }
        Ok(chunk)
    }
}

impl<X, F, M, const N: usize> Trajectories<X, F, M, N> {
    fn width(&self) -> usize {
        let width = |kept: &Kept<M, N>| match kept {
            Kept::At(times) => times.len() * N,
            Kept::End(..) => 1,
            Kept::Extremum(..) | Kept::Event(..) => 2,
        };
        1 + N + self.kept.iter().map(width).sum::<usize>()
    }

    /// Sample times in the order in which they are reached, each with its index in the order of declaration.
    fn samples(&self) -> Vec<(f64, usize)> {
        let times = self.kept.iter().flat_map(|kept| match kept {
            Kept::At(times) => times.as_slice(),
            _ => &[],
        });
        let (t0, t1) = self.span;
        let mut samples: Vec<_> = times.copied().zip(0..).collect();
        samples.sort_by(|(a, _), (b, _)| if t0 <= t1 { a.total_cmp(b) } else { b.total_cmp(a) });
        samples
    }

    /// Trackers of the extrema of a trajectory that starts here.
    fn extrema<'s>(&'s self, model: &'s M, start: SVector<f64, N>) -> Vec<Extremum<'s, N>> {
        let of_kept = self.kept.iter().filter_map(|kept| match kept {
            Kept::Extremum(_, sign, value) => {
                let value = Box::new(move |t: f64, x: &SVector<f64, N>| sign * value(model, t, x));
                Some(Extremum::new(value, self.span.0, start))
            }
            _ => None,
        });
        of_kept.collect()
    }

    /// Appends the results of a trajectory.
    fn keep_of(&self, model: &M, seen: &Seen<'_, N>, numbers: &mut Vec<f64>) {
        numbers.push(seen.t);
        numbers.extend(&seen.x);
        let (mut states, mut extrema) = (seen.states().into_iter(), seen.extrema.iter());
        for kept in &self.kept {
            match kept {
                Kept::At(times) => numbers.extend(states.by_ref().take(times.len()).flatten()),
                Kept::End(_, value) => numbers.push(value(model, seen.t, &seen.x)),
                Kept::Extremum(_, sign, _) => {
                    let (t, most) = extrema.next().map_or((f64::NAN, f64::NAN), Extremum::found);
                    numbers.extend([sign * most, t]);
                }
                Kept::Event(_, index) => {
                    let (count, first) = seen.events[*index];
                    numbers.extend([count as f64, first]);
                }
            }
        }
    }
}

fn one_by_one<X, M, const N: usize>(
    method: &X,
    (t0, t1): (f64, f64),
    models: &[M],
    starts: &[SVector<f64, N>],
    events: &[Vec<Event<'_, f64, N>>],
    seen: &mut [Seen<'_, N>],
) -> Result<Vec<Option<Reason>>, SweepError>
where
    X: Method<M, f64, N>,
    M: System<f64, N>,
{
    let members = models.iter().zip(starts).zip(events).zip(seen);
    let ended = members.map(
        |(((model, &x), events), seen)| match method.follow(model, t0, t1, x, events, seen) {
            Ok(_) => Ok(None),
            Err(reason) if is_of_start(&reason) => Ok(Some(reason)),
            Err(reason) => Err(reason.into()),
        },
    );
    ended.collect()
}

fn in_lanes<X, M, const N: usize>(
    method: &X,
    span: (f64, f64),
    models: &[M],
    starts: &[SVector<f64, N>],
    events: &[Vec<Event<'_, f64, N>>],
    seen: &mut [Seen<'_, N>],
) -> Result<Vec<Option<Reason>>, SweepError>
where
    X: ObservedEnsemble<M, f64, N>,
    M: Cast<N>,
{
    let mut reasons = vec![None; starts.len()];
    if starts.is_empty() {
        return Ok(reasons);
    }
    match method.observe(models, span, starts, |index| &events[index], seen) {
        Ok(_) => {}
        Err(EnsembleError::InvalidInput(reason)) => return Err(reason.into()),
        Err(EnsembleError::Stopped { stopped, .. }) => {
            stopped
                .iter()
                .for_each(|stopped| reasons[stopped.index] = Some(stopped.reason));
        }
        Err(other) => return Err(SweepError::Invalid(other.to_string())),
    }
    Ok(reasons)
}

/// Observer that records a trajectory.
struct Seen<'s, const N: usize> {
    /// Current time.
    t: f64,
    x: SVector<f64, N>,
    is_forward: bool,
    /// Sample times with their indices; `states` holds the samples so far.
    samples: &'s [(f64, usize)],
    states: Vec<[f64; N]>,
    /// Number of occurrences of each event, and the time of the first one.
    events: Vec<(usize, f64)>,
    extrema: Vec<Extremum<'s, N>>,
}

impl<'s, const N: usize> Seen<'s, N> {
    fn new((t0, t1): (f64, f64), x: SVector<f64, N>, samples: &'s [(f64, usize)], events: usize) -> Self {
        let is_forward = t0 <= t1;
        let early = samples.iter().take_while(|&&(t, _)| t != t0 && (t < t0) == is_forward);
        Self {
            t: t0,
            x,
            is_forward,
            samples,
            states: early.map(|_| [f64::NAN; N]).collect(),
            events: vec![(0, f64::NAN); events],
            extrema: Vec::new(),
        }
    }

    /// The next sample time, if it is before `end`.
    fn sample_before(&self, end: f64) -> Option<f64> {
        let &(t, _) = self.samples.get(self.states.len())?;
        (if self.is_forward { t < end } else { t > end }).then_some(t)
    }

    /// States at all samples, in the order of declaration; NaN before the start and after the end.
    fn states(&self) -> Vec<[f64; N]> {
        let mut states = vec![[f64::NAN; N]; self.samples.len()];
        for (n, &(t, place)) in self.samples.iter().enumerate() {
            states[place] = match self.states.get(n) {
                Some(&state) => state,
                None if t == self.t => self.x.into(),
                None => [f64::NAN; N],
            };
        }
        states
    }
}

impl<const N: usize> Observer<f64, N> for Seen<'_, N> {
    fn needs(&self, _t0: f64, t1: f64) -> Need {
        match self.extrema.is_empty() && self.sample_before(t1).is_none() {
            true => Need::Ends,
            false => Need::Inside,
        }
    }

    fn step(&mut self, dense: &Dense<'_, f64, N>) {
        let step = dense.step();
        while let Some(t) = self.sample_before(step.t1) {
            let x = if t == step.t0 { step.x0 } else { dense.at(t) };
            self.states.push(x.into());
        }
        (self.t, self.x) = (step.t1, step.x1);
        for extremum in &mut self.extrema {
            extremum.step(dense);
        }
    }

    fn jump(&mut self, t: f64, x: SVector<f64, N>) {
        self.x = x;
        for extremum in &mut self.extrema {
            extremum.jump(t, x);
        }
    }

    fn event(&mut self, event: Occurrence<f64, N>) {
        let (count, first) = &mut self.events[event.index];
        if *count == 0 {
            *first = event.t;
        }
        *count += 1;
    }
}

/// Quantity along a trajectory.
type Along<'s, const N: usize> = Box<dyn Fn(f64, &SVector<f64, N>) -> f64 + 's>;

/// Running maximum of a quantity.
struct Extremum<'s, const N: usize> {
    value: Along<'s, N>,
    t: f64,
    most: f64,
    /// Distance in time between the maximum and the samples beside it.
    width: f64,
    /// Dense output of the steps adjacent to the maximum.
    about: Solution<f64, N>,
    /// True if the maximum is at the end of the last step, so that the next step is adjacent too.
    is_open: bool,
}

impl<'s, const N: usize> Extremum<'s, N> {
    fn new(value: Along<'s, N>, t: f64, x: SVector<f64, N>) -> Self {
        let (most, about) = (value(t, &x), Solution::start(t, x));
        Self {
            value,
            t,
            most,
            width: 0.0,
            about,
            is_open: true,
        }
    }

    /// True if `value` exceeds the maximum so far, or is the first one that is not NaN.
    fn is_more(&self, value: f64) -> bool {
        value > self.most || self.most.is_nan() && !value.is_nan()
    }

    fn jump(&mut self, t: f64, x: SVector<f64, N>) {
        let value = (self.value)(t, &x);
        self.is_open = self.is_more(value);
        if self.is_open {
            (self.t, self.most, self.width) = (t, value, 0.0);
            self.about = Solution::start(t, x);
        }
    }

    fn step(&mut self, dense: &Dense<'_, f64, N>) {
        let step = dense.step();
        let width = 0.25 * (step.t1 - step.t0);
        let mut is_here = false;
        for n in 1..=4 {
            // the end of the step itself, before any reset
            let (t, x) = match n {
                4 => (step.t1, step.x1),
                _ => {
                    let t = step.t0 + f64::from(n) * width;
                    (t, dense.at(t))
                }
            };
            let value = (self.value)(t, &x);
            if self.is_more(value) {
                (self.t, self.most, self.width) = (t, value, width.abs());
                is_here = true;
            }
        }
        if is_here {
            self.about = Solution::start(step.t0, step.x0);
        } else if self.is_open {
            self.width = self.width.max(width.abs());
        } else {
            return;
        }
        self.about.step(dense);
        self.is_open = is_here && self.t == step.t1;
    }

    /// Refines the maximum by golden-section search; returns its time and value.
    fn found(&self) -> (f64, f64) {
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        let (mut t, mut most, mut width) = (self.t, self.most, self.width);
        while width > 1e-9 * t.abs().max(1.0) {
            width *= golden;
            for place in [t - width, t + width] {
                let value = self.about.at(place).map_or(f64::NAN, |x| (self.value)(place, &x));
                if value > most {
                    (t, most) = (place, value);
                    break;
                }
            }
        }
        (t, most)
    }
}
