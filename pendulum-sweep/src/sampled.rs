//! Final states under sampled controllers.

use std::fmt::Debug;

use pendulum_core::control::{Controller, Outputs, Sampled, SampledMethod};
use pendulum_core::inputs::{CastControlled, Controlled};
use pendulum_core::nalgebra::SVector;
use serde_json::{Value, json};

use crate::design::Sweep;
use crate::ends::{Quantity, Trials, first_trial, of_ends};
use crate::error::SweepError;
use crate::job::{Chunk, Failure, Job, Task};
use crate::table::Column;

/// Task of [`Sweep::sampled`].
pub struct SampledEnds<X, F, S, const N: usize> {
    method: X,
    span: (f64, f64),
    trial: F,
    values: Vec<(Column, Quantity<S, N>)>,
}

impl<const K: usize> Sweep<K> {
    /// Integrates models from `span.0` to `span.1` under [`Sampled`] controllers, in the SIMD lanes: see
    /// [`Sampled::ensemble_of`]. `trial` builds the controller, the model and the initial state of a point. Noise is
    /// the same at all points, unless `trial` gives their controllers [members](Sampled::member) that differ.
    ///
    /// The columns are those of [`ends`](Self::ends): the final time `t`, and the final state by the names of its
    /// components. Points whose controllers have different periods or delays run one after the other: let the axes of
    /// these vary least, which are then the first of a grid.
    ///
    /// ```
    /// use pendulum_core::control::{Pid, Sampled};
    /// use pendulum_core::prelude::*;
    /// use pendulum_sweep::{Axis, Sweep};
    ///
    /// mechanism! {
    ///     pub Cart {
    ///         params { m: kg = 2 }
    ///         input push: N,
    ///         body cart on ground { mass: m, joint: prismatic(x), coordinate: s, torque: push }
    ///     }
    /// }
    ///
    /// let axes = [Axis::linear("gain", "N/m", 4.0, 16.0, 4), Axis::linear("damping", "N s/m", 2.0, 10.0, 5)];
    /// let table = Sweep::grid("gains", axes)
    ///     .sampled(Tsit5::new(), (0.0, 10.0), |[gain, damping]| {
    ///         let pid = Pid::new(gain, 0.0, damping).set_point(1.0);
    ///         let sampled = Sampled::of_components(pid, 0.01, [Cart::S]).limits([-5.0], [5.0]).noise([1e-3]);
    ///         Ok((sampled, Cart::new(CartParams::default())?, [0.0, 0.0]))
    ///     })
    ///     .value("error", "m", |_, _, x| (x[Cart::S] - 1.0).abs())
    ///     .quiet()
    ///     .run()?;
    /// assert!(table["error"].iter().all(|error| *error < 0.2));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn sampled<X, F, C, W, S, const N: usize, const P: usize, const M: usize>(
        self,
        method: X,
        span: (f64, f64),
        trial: F,
    ) -> Job<SampledEnds<X, F, S, N>, K>
    where
        F: Fn([f64; K]) -> Result<(Sampled<C, W, P, M>, S, [f64; N]), Failure> + Sync,
        X: SampledMethod<S, f64, N, M> + Debug + Sync,
        C: Controller<f64, P, M> + Clone,
        W: Outputs<f64, N, P> + Clone,
        S: CastControlled<N, M, In<f64>: Clone> + Clone,
    {
        let values = Vec::new();
        self.job(SampledEnds {
            method,
            span,
            trial,
            values,
        })
    }
}

impl<X, F, S, const K: usize, const N: usize> Job<SampledEnds<X, F, S, N>, K> {
    /// Adds a column computed from the model and its final state.
    pub fn value(
        mut self,
        name: &str,
        unit: &str,
        value: impl Fn(&S, f64, &SVector<f64, N>) -> f64 + Send + Sync + 'static,
    ) -> Self {
        self.task.values.push((Column::new(name, unit), Box::new(value)));
        self
    }
}

impl<X, F, C, W, S, const K: usize, const N: usize, const P: usize, const M: usize> Task<K> for SampledEnds<X, F, S, N>
where
    F: Fn([f64; K]) -> Result<(Sampled<C, W, P, M>, S, [f64; N]), Failure> + Sync,
    X: SampledMethod<S, f64, N, M> + Debug + Sync,
    C: Controller<f64, P, M> + Clone,
    W: Outputs<f64, N, P> + Clone,
    S: CastControlled<N, M, In<f64>: Clone> + Clone,
{
    /// The end of the first motion stands for the numbers of its controller, which may not have a text.
    fn describe(&self, sweep: &Sweep<K>) -> (Vec<Column>, Value) {
        let (t0, t1) = self.span;
        let first = first_trial(sweep, |point| {
            (self.trial)(point).map(|(controller, model, start)| ((controller, model.cast::<f64>()), start))
        });
        let layout = first.as_ref().and_then(|((_, model), _)| model.layout());
        let columns = of_ends(layout, &self.values);
        let first = first.as_ref().map_or(Value::Null, |((controller, model), start)| {
            let end = match controller.end(&self.method, model, t0, t1, *start) {
                Ok(end) => json!(end.as_slice()),
                Err(reason) => json!(reason.to_string()),
            };
            json!({ "start": start.as_slice(), "end": end })
        });
        let declaration = json!({ "sampled": format!("{:?}", self.method), "span": self.span, "first": first });
        (columns, declaration)
    }

    fn run(&self, points: &[[f64; K]]) -> Result<Chunk, SweepError> {
        let (t0, t1) = self.span;
        let mut controllers = Vec::with_capacity(points.len());
        let trials = Trials::of(points, |point| {
            let (controller, model, start) = (self.trial)(point)?;
            controllers.push(controller);
            Ok((model, start))
        });
        let ends = Sampled::ensemble_of(&controllers, &self.method, &trials.models, t0, t1, &trials.starts);
        trials.rows_of(ends, t1, &self.values)
    }
}
