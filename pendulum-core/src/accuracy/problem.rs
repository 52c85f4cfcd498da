//! Test problems for methods.

use std::fmt;

use nalgebra::SVector;

use crate::accuracy::{Errors, Reference};
use crate::solution::Solution;
use crate::system::{Energy, IntoState, System};

/// A system, a time span, an initial condition, and a reference solution.
pub struct Problem<'a, S, const N: usize> {
    pub(super) system: &'a S,
    pub(super) t0: f64,
    pub(super) t1: f64,
    pub(super) x0: SVector<f64, N>,
    pub(super) reference: &'a Reference<'a, N>,
    energy: Option<(EnergyOf<'a, N>, f64)>,
}

/// Energy as a function of time and state.
type EnergyOf<'a, const N: usize> = Box<dyn Fn(f64, &SVector<f64, N>) -> f64 + 'a>;

impl<'a, S: System<f64, N>, const N: usize> Problem<'a, S, N> {
    /// Integration of `system` from the state `x0` at `t0` to `t1`.
    ///
    /// # Panics
    /// If the reference does not cover `t1`.
    pub fn new(system: &'a S, t0: f64, t1: f64, x0: impl IntoState<f64, N>, reference: &'a Reference<'a, N>) -> Self {
        assert!(
            reference.at(t1).is_some(),
            "the reference has no state at the end, t = {t1}"
        );
        Self {
            system,
            t0,
            t1,
            x0: x0.into_state(),
            reference,
            energy: None,
        }
    }

    /// Also measures energy errors, in units of `scale`, in joules; see [`Errors::with_energy`].
    #[must_use]
    pub fn energy(mut self, scale: f64) -> Self
    where
        S: Energy<f64, N>,
    {
        let system = self.system;
        self.energy = Some((Box::new(move |t, x| system.energy(t, x)), scale));
        self
    }

    /// Errors of a solution that reached the end of the span.
    pub(super) fn errors(&self, solution: &Solution<f64, N>) -> Errors {
        let errors = Errors::of(solution, self.reference).expect("the reference knows the end");
        match &self.energy {
            Some((energy, scale)) => errors.with_energy(solution, self.reference, energy, *scale),
            None => errors,
        }
    }
}

impl<S, const N: usize> fmt::Debug for Problem<'_, S, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Problem")
            .field("t0", &self.t0)
            .field("t1", &self.t1)
            .field("x0", &self.x0)
            .field("reference", &self.reference)
            .finish_non_exhaustive()
    }
}
