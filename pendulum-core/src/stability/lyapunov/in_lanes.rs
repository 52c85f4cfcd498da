//! Lyapunov exponents of many trajectories at once.

use std::cell::RefCell;

use nalgebra::SVector;

use super::{Exponents, Lyapunov, TangentGrowth, oblique, orthonormalize};
use crate::ensemble::{Ensemble, EnsembleError, check_models, model_of};
use crate::method::{Carried, Carry, Tangent};
use crate::real::lanes::{Isa, Kernel, Lanes};
use crate::stability::StabilityError;
use crate::stability::directions::dimension;
use crate::stability::transition::flow;
use crate::system::{CastJacobian, Jacobian};
use crate::tableau::Verner9;

impl Lyapunov {
    /// Computes the `K` largest exponents of many models, each from a state at the time 0, in the lanes of vector
    /// registers. Each result is bit-identical to [`exponents`](Self::exponents).
    ///
    /// Pass one model per start, or a single model for all. [Hybrid](crate::hybrid) systems, and those with more
    /// positions than rates, are integrated one by one.
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    /// use pendulum_core::stability::Lyapunov;
    ///
    /// mechanism! {
    ///     pub Swing {
    ///         params { gamma: N m s }
    ///         gravity: [0, -9.81, 0],
    ///         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, friction: gamma }
    ///     }
    /// }
    ///
    /// let swings = [0.1, 0.2, 0.4].map(|gamma| Swing::new(SwingParams { gamma }));
    /// let swings = swings.into_iter().collect::<Result<Vec<_>, _>>()?;
    /// let start = SVector::from([0.01, 0.0]);
    /// let lyapunov = Lyapunov::new().duration(100.0);
    /// let found = lyapunov.ensemble::<1, _, _>(&swings, &[start; 3])?;
    /// for (swing, found) in swings.iter().zip(found) {
    ///     assert_eq!(found?, lyapunov.largest(swing, start)?);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`StabilityError::Integration`] if a setting is out of its range, or if there is neither one model nor one for
    /// each start. Each trajectory has its own error if it stops early.
    #[allow(clippy::type_complexity, reason = "one result for each")]
    pub fn ensemble<const K: usize, M, const N: usize>(
        &self,
        models: &[M],
        starts: &[SVector<f64, N>],
    ) -> Result<Vec<Result<Exponents<K, N>, StabilityError>>, StabilityError>
    where
        M: CastJacobian<N>,
        M::In<f64>: Jacobian<f64, N>,
    {
        self.ensemble_on(Isa::widest(), models, starts)
    }

    /// [`ensemble`](Self::ensemble) on the instruction set `isa`, for comparisons. The results are bit-identical.
    ///
    /// # Errors
    /// See [`ensemble`](Self::ensemble).
    #[allow(clippy::type_complexity, reason = "one result for each")]
    pub fn ensemble_on<const K: usize, M, const N: usize>(
        &self,
        isa: Isa,
        models: &[M],
        starts: &[SVector<f64, N>],
    ) -> Result<Vec<Result<Exponents<K, N>, StabilityError>>, StabilityError>
    where
        M: CastJacobian<N>,
        M::In<f64>: Jacobian<f64, N>,
    {
        check_models(models, starts)?;
        let Some(first) = models.first().map(|model| model.cast::<f64>()) else {
            return Ok(Vec::new());
        };
        self.check::<K, N>(&first)?;
        let flow = flow::<K>(self.tolerance).h_max(self.h_max());
        flow.tolerance::<f64>()?;
        if const { M::HYBRID } || dimension(&first) < N || isa.run(CountLanes) == 1 {
            let alone = |(n, &start)| self.exponents(&model_of(models, n).cast::<f64>(), start);
            return Ok(starts.iter().enumerate().map(alone).collect());
        }
        let growths = vec![TangentGrowth::new(self.transient, self.end()); starts.len()];
        let growths = RefCell::new(growths);
        let carried = Carried::<_, Verner9, 17, K>::new(Tangent::default(), Growing(&growths));
        let (x, stopped) = match flow.by(carried).ensemble_on(isa, models, 0.0, self.end(), starts) {
            Ok(x) => (x, Vec::new()),
            Err(EnsembleError::InvalidInput(reason)) => return Err(reason.into()),
            Err(EnsembleError::Stopped { stopped, x }) => (x, stopped),
        };
        let ends = growths.into_inner().into_iter().zip(x);
        let mut found: Vec<_> = ends.map(|(growth, x)| Ok(growth.exponents(self.end(), x))).collect();
        for stopped in stopped {
            found[stopped.index] = Err(stopped.reason.into());
        }
        Ok(found)
    }
}

/// Orthonormalises the tangents after each step and accumulates their growth.
#[derive(Clone, Copy)]
struct Growing<'g, const K: usize>(&'g RefCell<Vec<TangentGrowth<K>>>);

impl<const K: usize, const N: usize> Carry<f64, K, N> for Growing<'_, K> {
    fn start(self) -> [SVector<f64, N>; K] {
        let mut tangents = oblique(N);
        // as for constraints held from the start
        orthonormalize(&mut tangents, N);
        tangents
    }

    fn step(self, index: usize, step: (f64, f64), tangents: &mut [SVector<f64, N>; K]) {
        let lengths = orthonormalize(tangents, N);
        self.0.borrow_mut()[index].count(step, lengths);
    }
}

/// Number of lanes of the registers of an instruction set.
struct CountLanes;

impl Kernel<f64> for CountLanes {
    type Output = usize;

    fn run<V: Lanes<Scalar = f64>>(self) -> usize {
        V::LANES
    }
}
