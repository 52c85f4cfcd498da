//! Whole trajectories, of which some numbers are kept.

use std::fmt::Debug;

use pendulum_core::nalgebra::SVector;
use pendulum_core::{Event, Method, Solution, SolveError, System};
use serde_json::{Value, json};

use crate::design::Sweep;
use crate::ends::{Quantity, first_layout, of_state};
use crate::error::SweepError;
use crate::job::{Chunk, Failure, Job, Task};
use crate::table::Column;

/// An event of a model.
type EventOf<M, const N: usize> = Box<dyn for<'m> Fn(&'m M) -> Event<'m, f64, N> + Send + Sync>;

/// What [`Sweep::trajectories`] does.
pub struct Trajectories<X, F, M, const N: usize> {
    method: X,
    span: (f64, f64),
    trial: F,
    kept: Vec<Kept<M, N>>,
    events: Vec<EventOf<M, N>>,
}

/// What is kept of a trajectory besides its end.
enum Kept<M, const N: usize> {
    /// The states at these times.
    At(Vec<f64>),
    /// A quantity at the end.
    End(Column, Quantity<M, N>),
    /// The extremum of a quantity, times 1 the largest and times -1 the least, and when it is reached.
    Extremum(Column, f64, Quantity<M, N>),
    /// How often an event occurred, and when first.
    Event(String, usize),
}

impl<const K: usize> Sweep<K> {
    /// The trajectories of models from `span.0` to `span.1`, by any method, one by one on each core. `trial` makes the
    /// model and the start of a point.
    ///
    /// Kept are the time `t` of the end, which terminal events make earlier, the state there by the names of its
    /// components, and what is asked for.
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
        })
    }
}

impl<X, F, M, const K: usize, const N: usize> Job<Trajectories<X, F, M, N>, K> {
    /// Keeps the states at these times, as `angle at 2 s`; NaN after the end.
    pub fn at(self, times: impl Into<Vec<f64>>) -> Self {
        self.keep(Kept::At(times.into()))
    }

    /// Keeps a number that the model and its final state determine.
    pub fn value(
        self,
        name: &str,
        unit: &str,
        value: impl Fn(&M, f64, &SVector<f64, N>) -> f64 + Send + Sync + 'static,
    ) -> Self {
        self.keep(Kept::End(Column::new(name, unit), Box::new(value)))
    }

    /// Keeps the largest value of a quantity, and when it is reached, as `t of height`: the largest of five places in
    /// each step, sharpened to the dense output.
    pub fn largest(
        self,
        name: &str,
        unit: &str,
        value: impl Fn(&M, f64, &SVector<f64, N>) -> f64 + Send + Sync + 'static,
    ) -> Self {
        self.keep(Kept::Extremum(Column::new(name, unit), 1.0, Box::new(value)))
    }

    /// Keeps the least value in the same way.
    pub fn least(
        self,
        name: &str,
        unit: &str,
        value: impl Fn(&M, f64, &SVector<f64, N>) -> f64 + Send + Sync + 'static,
    ) -> Self {
        self.keep(Kept::Extremum(Column::new(name, unit), -1.0, Box::new(value)))
    }

    /// Keeps how often an event occurred, and when first, as `t of over`; NaN where it did not. Terminal ones end the
    /// trajectory, and may reset it.
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
    X: Method<M, f64, N> + Debug + Sync,
    M: System<f64, N>,
{
    fn columns(&self, sweep: &Sweep<K>) -> Vec<Column> {
        let layout = first_layout(sweep, |point| Some((self.trial)(point).ok()?.0.layout()));
        let state = of_state::<N>(layout);
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
        columns
    }

    fn declaration(&self) -> Value {
        json!({ "trajectories": format!("{:?}", self.method), "span": self.span })
    }

    fn run(&self, points: &[[f64; K]]) -> Result<Chunk, SweepError> {
        let mut chunk = Chunk::default();
        for &point in points {
            match (self.trial)(point) {
                Ok((model, start)) => self.follow(&model, start, &mut chunk),
                Err(reason) => chunk.fail(vec![f64::NAN; self.width()], reason),
            }
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

    fn follow(&self, model: &M, start: [f64; N], chunk: &mut Chunk)
    where
        X: Method<M, f64, N>,
        M: System<f64, N>,
    {
        let events: Vec<Event<'_, f64, N>> = self.events.iter().map(|event| event(model)).collect();
        match self.method.solve_with(model, self.span.0, self.span.1, start, &events) {
            Ok(solution) => chunk.push(self.numbers(model, &solution)),
            Err(SolveError { reason, solution, .. }) => chunk.fail(self.numbers(model, &solution), reason),
        }
    }

    fn numbers(&self, model: &M, solution: &Solution<f64, N>) -> Vec<f64> {
        let (t_end, end) = solution.last();
        let mut numbers = vec![t_end];
        numbers.extend(&end);
        for kept in &self.kept {
            match kept {
                Kept::At(times) => numbers.extend(times.iter().flat_map(|&t| match solution.at(t) {
                    Ok(x) => <[f64; N]>::from(x),
                    Err(_) => [f64::NAN; N],
                })),
                Kept::End(_, value) => numbers.push(value(model, t_end, &end)),
                Kept::Extremum(_, sign, value) => {
                    let (t, most) = extremum(solution, |t, x| sign * value(model, t, x));
                    numbers.extend([sign * most, t]);
                }
                Kept::Event(_, index) => {
                    let occurred = || solution.events().iter().filter(|event| event.index == *index);
                    let first = occurred().next().map_or(f64::NAN, |event| event.t);
                    numbers.extend([occurred().count() as f64, first]);
                }
            }
        }
        numbers
    }
}

/// Where a quantity is largest along a solution, and the value there.
fn extremum<const N: usize>(solution: &Solution<f64, N>, value: impl Fn(f64, &SVector<f64, N>) -> f64) -> (f64, f64) {
    let at = |t: f64| solution.at(t).map_or(f64::NAN, |x| value(t, &x));
    let (t0, x0) = (solution.t()[0], solution.x()[0]);
    let mut best = (t0, value(t0, &x0), 0.0);
    let better = |best: &mut (f64, f64, f64), (t, width): (f64, f64), value: f64| {
        if value > best.1 {
            *best = (t, value, width);
        }
    };
    for (pair, x) in solution.t().windows(2).zip(&solution.x()[1..]) {
        let width = 0.25 * (pair[1] - pair[0]);
        for n in 1..4 {
            let t = pair[0] + f64::from(n) * width;
            better(&mut best, (t, width), at(t));
        }
        // the end as it is, before a reset
        better(&mut best, (pair[1], width), value(pair[1], x));
    }
    // the golden section about it
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut t, mut most, mut width) = best;
    while width > 1e-9 * t.abs().max(1.0) {
        width *= golden;
        for place in [t - width, t + width] {
            let value = at(place);
            if value > most {
                (t, most) = (place, value);
                break;
            }
        }
    }
    (t, most)
}
