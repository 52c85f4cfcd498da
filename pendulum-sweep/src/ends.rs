//! Final states of many trajectories at a time.

use std::fmt::{Debug, Display};
use std::iter::repeat_n;

use pendulum_core::nalgebra::SVector;
use pendulum_core::{Cast, Ensemble, EnsembleError, Reason, StateLayout, System};
use serde_json::{Value, json};

use crate::design::Sweep;
use crate::error::SweepError;
use crate::job::{Chunk, Failure, Job, Task};
use crate::table::Column;

/// Number computed from a model, a time and a state.
pub(crate) type Quantity<M, const N: usize> = Box<dyn Fn(&M, f64, &SVector<f64, N>) -> f64 + Send + Sync>;

/// Task of [`Sweep::ends`].
pub struct Ends<X, F, M, const N: usize> {
    method: X,
    span: (f64, f64),
    trial: F,
    values: Vec<(Column, Quantity<M, N>)>,
}

impl<const K: usize> Sweep<K> {
    /// Integrates models from `span.0` to `span.1` in the SIMD lanes. `trial` builds the model and the initial state of
    /// a point.
    ///
    /// The columns are the final time `t`, and the final state by the names of its components.
    pub fn ends<X, F, M, const N: usize>(self, method: X, span: (f64, f64), trial: F) -> Job<Ends<X, F, M, N>, K>
    where
        F: Fn([f64; K]) -> Result<(M, [f64; N]), Failure> + Sync,
        X: Ensemble<M, f64, N> + Debug + Sync,
        M: Cast<N>,
    {
        let values = Vec::new();
        self.job(Ends {
            method,
            span,
            trial,
            values,
        })
    }
}

impl<X, F, M, const K: usize, const N: usize> Job<Ends<X, F, M, N>, K> {
    /// Adds a column computed from the model and its final state.
    pub fn value(
        mut self,
        name: &str,
        unit: &str,
        value: impl Fn(&M, f64, &SVector<f64, N>) -> f64 + Send + Sync + 'static,
    ) -> Self {
        self.task.values.push((Column::new(name, unit), Box::new(value)));
        self
    }
}

impl<X, F, M, const K: usize, const N: usize> Task<K> for Ends<X, F, M, N>
where
    F: Fn([f64; K]) -> Result<(M, [f64; N]), Failure> + Sync,
    X: Ensemble<M, f64, N> + Debug + Sync,
    M: Cast<N>,
{
    fn describe(&self, sweep: &Sweep<K>) -> (Vec<Column>, Value) {
        let first = first_trial(sweep, &self.trial).map(|(model, start)| (model.cast::<f64>(), start));
        let layout = first.as_ref().and_then(|(model, _)| model.layout());
        let columns = of_ends(layout, &self.values);
        let first = of_first(first, self.span.0);
        let declaration = json!({ "ends": format!("{:?}", self.method), "span": self.span, "first": first });
        (columns, declaration)
    }

    fn chunk(&self) -> usize {
        self.method.batch()
    }

    fn run(&self, points: &[[f64; K]]) -> Result<Chunk, SweepError> {
        let (t0, t1) = self.span;
        let trials = Trials::of(points, &self.trial);
        let ends = self.method.ensemble(&trials.models, t0, t1, &trials.starts);
        trials.rows_of(ends, t1, &self.values)
    }
}

/// Models and initial states of the points for which `trial` succeeded.
pub(crate) struct Trials<M, const N: usize> {
    pub(crate) models: Vec<M>,
    pub(crate) starts: Vec<SVector<f64, N>>,
    /// The remaining points, each with the error of `trial`.
    failures: Vec<(usize, Failure)>,
}

impl<M, const N: usize> Trials<M, N> {
    pub(crate) fn of<const K: usize>(
        points: &[[f64; K]],
        mut trial: impl FnMut([f64; K]) -> Result<(M, [f64; N]), Failure>,
    ) -> Self {
        let mut trials = Self {
            models: Vec::with_capacity(points.len()),
            starts: Vec::with_capacity(points.len()),
            failures: Vec::new(),
        };
        for (n, &point) in points.iter().enumerate() {
            match trial(point) {
                Ok((model, start)) => {
                    trials.models.push(model);
                    trials.starts.push(SVector::from(start));
                }
                Err(failure) => trials.failures.push((n, failure)),
            }
        }
        trials
    }

    /// Rows of the final time, the final state and the `values`, from the result of an ensemble.
    pub(crate) fn rows_of(
        &self,
        ends: Result<Vec<SVector<f64, N>>, EnsembleError<f64, N>>,
        t1: f64,
        values: &[(Column, Quantity<M, N>)],
    ) -> Result<Chunk, SweepError> {
        let (ends, stopped) = match ends {
            Ok(ends) => (ends, Vec::new()),
            Err(EnsembleError::InvalidInput(reason)) => return Err(reason.into()),
            Err(EnsembleError::Stopped { stopped, x }) => (x, stopped),
            Err(other) => return Err(SweepError::Invalid(other.to_string())),
        };
        let mut stopped = stopped.iter().peekable();
        let width = 1 + N + values.len();
        let mut chunk = Chunk::with_capacity(ends.len() + self.failures.len(), width);
        self.conclude(&mut chunk, width, |index, numbers| {
            let (model, x) = (&self.models[index], &ends[index]);
            let stopped = stopped.next_if(|stopped| stopped.index == index);
            let t = stopped.map_or(t1, |stopped| stopped.t);
            numbers.push(t);
            numbers.extend_from_slice(x.as_slice());
            numbers.extend(values.iter().map(|(_, value)| value(model, t, x)));
            stopped.map(|stopped| stopped.reason)
        });
        Ok(chunk)
    }

    /// Appends a row for each point. `row` pushes the `width` numbers of a model and returns the reason if it failed;
    /// points without a model get NaN.
    pub(crate) fn conclude<R: Display>(
        &self,
        chunk: &mut Chunk,
        width: usize,
        mut row: impl FnMut(usize, &mut Vec<f64>) -> Option<R>,
    ) {
        let mut failures = self.failures.iter().peekable();
        let mut models = 0..self.models.len();
        for point in 0..self.models.len() + self.failures.len() {
            if let Some((_, failure)) = failures.next_if(|(failed, _)| *failed == point) {
                chunk.fail(repeat_n(f64::NAN, width), failure);
            } else if let Some(index) = models.next() {
                chunk.push_row(|numbers| row(index, numbers));
            }
        }
    }
}

/// Returns the model and the initial state of the first point for which `trial` succeeds.
pub(crate) fn first_trial<M, const K: usize, const N: usize>(
    sweep: &Sweep<K>,
    trial: impl Fn([f64; K]) -> Result<(M, [f64; N]), Failure>,
) -> Option<(M, SVector<f64, N>)> {
    let mut trials = (0..sweep.points()).filter_map(|row| trial(sweep.point(row)).ok());
    trials.next().map(|(model, start)| (model, start.into()))
}

/// The first initial state, and the derivative near it (at the initial state itself it may vanish). They distinguish
/// scenes that differ only in their numbers.
pub(crate) fn of_first<S: System<f64, N>, const N: usize>(first: Option<(S, SVector<f64, N>)>, t0: f64) -> Value {
    first.map_or(Value::Null, |(system, start)| {
        let beside = SVector::from_fn(|n, _| start[n] + 0.1 * (n + 1) as f64);
        let derivative = system.rhs(t0 + 0.1, &beside);
        json!({ "start": start.as_slice(), "derivative beside it": derivative.as_slice() })
    })
}

/// Columns of final times and states, and of `values`.
pub(crate) fn of_ends<M, const N: usize>(
    layout: Option<StateLayout<'_>>,
    values: &[(Column, Quantity<M, N>)],
) -> Vec<Column> {
    let mut columns = vec![Column::new("t", "s")];
    columns.extend(of_state::<N>(layout));
    columns.extend(values.iter().map(|(column, _)| column.clone()));
    columns
}

/// Components of a state, numbered if their names are unknown.
pub(crate) fn of_state<const N: usize>(layout: Option<StateLayout<'_>>) -> Vec<Column> {
    let Some(layout) = layout else {
        return (0..N).map(|n| Column::new(&format!("x{n}"), "1")).collect();
    };
    let mut units = vec!["1"; N];
    for slot in layout.slots {
        slot.positions.clone().for_each(|place| units[place] = slot.unit());
        slot.rates.clone().for_each(|place| units[place] = slot.rate_unit());
    }
    let named = layout.components().into_iter().zip(units);
    named.map(|(name, unit)| Column::new(&name, unit)).collect()
}

/// True if the initial state of a trajectory is at fault, false for a setting.
pub(crate) fn is_of_start(reason: &Reason) -> bool {
    !matches!(reason, Reason::InvalidInput { what, .. } if *what != "x0")
}
