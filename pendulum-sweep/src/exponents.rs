//! Lyapunov exponents of many trajectories at a time.

use pendulum_core::stability::Lyapunov;
use pendulum_core::{CastJacobian, Jacobian};
use serde_json::{Value, json};

use crate::design::Sweep;
use crate::ends::{Trials, first_trial, of_first};
use crate::error::SweepError;
use crate::job::{Chunk, Failure, Job, Task};
use crate::table::Column;

/// Task of [`Sweep::exponents`]: the `E` largest exponents of models with `N` states.
pub struct Exponents<F, const E: usize, const N: usize> {
    lyapunov: Lyapunov,
    trial: F,
}

impl<const K: usize> Sweep<K> {
    /// The `E` largest [Lyapunov exponents](pendulum_core::stability::Lyapunov) of models, in the SIMD lanes. `trial`
    /// builds the model and the initial state of a point.
    ///
    /// The columns are `exponent` and `uncertainty`, both in 1/s; if `E` is above 1, `exponent 1`, `exponent 2` and so
    /// on, then `uncertainty 1` and so on.
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    /// use pendulum_core::stability::Lyapunov;
    /// use pendulum_sweep::{Axis, Sweep};
    ///
    /// mechanism! {
    ///     pub Driven {
    ///         params { a: N m }
    ///         gravity: [0, -9.81, 0],
    ///         body bob on ground {
    ///             mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, friction: 0.5,
    ///             torque: a*sin(2 rad/s*t),
    ///         }
    ///     }
    /// }
    ///
    /// let table = Sweep::grid("chaos", [Axis::linear("a", "N m", 5.0, 15.0, 11)])
    ///     .exponents::<1, _, _, _>(Lyapunov::new().duration(20.0), |[a]| {
    ///         Ok((Driven::new(DrivenParams { a })?, [0.1, 0.0]))
    ///     })
    ///     .quiet()
    ///     .run()?;
    /// assert!(table["exponent"].iter().all(|exponent| exponent.is_finite()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn exponents<const E: usize, F, M, const N: usize>(
        self,
        lyapunov: Lyapunov,
        trial: F,
    ) -> Job<Exponents<F, E, N>, K>
    where
        F: Fn([f64; K]) -> Result<(M, [f64; N]), Failure> + Sync,
        M: CastJacobian<N>,
        M::In<f64>: Jacobian<f64, N>,
    {
        self.job(Exponents { lyapunov, trial })
    }
}

impl<F, M, const K: usize, const E: usize, const N: usize> Task<K> for Exponents<F, E, N>
where
    F: Fn([f64; K]) -> Result<(M, [f64; N]), Failure> + Sync,
    M: CastJacobian<N>,
    M::In<f64>: Jacobian<f64, N>,
{
    fn describe(&self, sweep: &Sweep<K>) -> (Vec<Column>, Value) {
        let column = |name: &str, n: usize| match E {
            1 => Column::new(name, "1/s"),
            _ => Column::new(&format!("{name} {n}"), "1/s"),
        };
        let of_each = |name| (1..=E).map(move |n| column(name, n));
        let columns = ["exponent", "uncertainty"].into_iter().flat_map(of_each).collect();
        let first = first_trial(sweep, &self.trial).map(|(model, start)| (model.cast::<f64>(), start));
        let declaration = json!({ "exponents": format!("{:?}", self.lyapunov), "first": of_first(first, 0.0) });
        (columns, declaration)
    }

    fn chunk(&self) -> usize {
        CHUNK
    }

    fn run(&self, points: &[[f64; K]]) -> Result<Chunk, SweepError> {
        let trials = Trials::of(points, &self.trial);
        let found = self.lyapunov.ensemble::<E, M, N>(&trials.models, &trials.starts);
        let found = found.map_err(|error| SweepError::Invalid(error.to_string()))?;
        let mut chunk = Chunk::with_capacity(points.len(), 2 * E);
        trials.conclude(&mut chunk, 2 * E, |index, numbers| {
            match &found[index] {
                Ok(exponents) => numbers.extend(exponents.values.iter().chain(&exponents.uncertainty)),
                Err(_) => numbers.extend([f64::NAN; E].iter().chain(&[f64::NAN; E])),
            }
            found[index].as_ref().err()
        });
        Ok(chunk)
    }
}

/// Trajectories per chunk. When fewer trajectories than lanes remain, some lanes idle, so chunks are long.
const CHUNK: usize = 128;
