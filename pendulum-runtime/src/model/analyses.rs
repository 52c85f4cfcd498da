//! Analyses of models: equilibria, exponents, derivatives and fits.

use pendulum_core::sensitivity::Variable;

use super::Model;
use crate::error::Error;
use crate::fit::{Experiment, Fit, Fitted};
use crate::method::Method;
use crate::sensitivity::Sensitivity;
use crate::stability::{Equilibrium, Exponents, Lyapunov, Resting};
use crate::tune::{Choice, Kinds};
use crate::worker;

impl Model {
    /// Searches for equilibria from some states. Also returns the coordinates that were not searched completely.
    ///
    /// # Errors
    /// If a state has another length, if `generate` does not have `jacobian`, or if the mechanism depends on time.
    pub fn equilibria(&self, seeds: &[Vec<f64>]) -> Result<(Vec<Equilibrium>, Vec<String>), Error> {
        seeds.iter().try_for_each(|seed| self.check_state(seed))?;
        if !seeds.iter().flatten().all(|x| x.is_finite()) {
            return Err(Error::setting("seed", "its components must be finite"));
        }
        self.needs("the search for equilibria", "jacobian", "jacobian")?;
        self.run(|| self.engine.equilibria(seeds))
    }

    /// Finds a state of rest near a state, held by dry friction and contacts.
    ///
    /// # Errors
    /// As for [`equilibria`](Self::equilibria), and if the mechanism has no constraints.
    pub fn resting(&self, seed: &[f64]) -> Result<Resting, Error> {
        self.check_state(seed)?;
        self.needs("the search for a state of rest", "jacobian", "jacobian")?;
        self.run(|| self.engine.resting(seed))
    }

    /// Computes the largest Lyapunov exponents of a trajectory, by the settings given.
    ///
    /// # Errors
    /// If a setting or the state is invalid, if `generate` does not have `jacobian`, or if the trajectory stops early.
    pub fn lyapunov(&self, x0: &[f64], settings: &Lyapunov) -> Result<Exponents, Error> {
        self.lyapunov_unless(x0, settings, &|| false)
    }

    /// Like [`lyapunov`](Self::lyapunov), but ends with an error when `cancel` returns true, which is called after each
    /// step.
    ///
    /// # Errors
    /// See [`lyapunov`](Self::lyapunov).
    pub fn lyapunov_unless(
        &self,
        x0: &[f64],
        settings: &Lyapunov,
        cancel: &(dyn Fn() -> bool + Sync),
    ) -> Result<Exponents, Error> {
        self.check_state(x0)?;
        self.needs("the computation of exponents", "jacobian", "jacobian")?;
        if settings.count > self.components().len() {
            let (count, length) = (settings.count, self.components().len());
            let rule = format!("there are {count}, and a state of this length has at most {length} exponents");
            return Err(Error::setting("count", rule));
        }
        self.run(|| self.engine.lyapunov(x0, settings, cancel))
    }

    /// Integrates from the first of the times to the last, with the derivatives of the states by components of the
    /// initial state and by parameters, given by name. Steps end where a `clamp` saturates.
    ///
    /// # Errors
    /// If a name, a setting or the state is invalid, or if the trajectory stops early.
    pub fn sensitivity(&self, method: &Method, times: &[f64], x0: &[f64], by: &[&str]) -> Result<Sensitivity, Error> {
        self.sensitivity_unless(method, times, x0, by, &|| false)
    }

    /// Like [`sensitivity`](Self::sensitivity), but ends with an error when `cancel` returns true, which is called
    /// after each step.
    ///
    /// # Errors
    /// See [`sensitivity`](Self::sensitivity).
    pub fn sensitivity_unless(
        &self,
        method: &Method,
        times: &[f64],
        x0: &[f64],
        by: &[&str],
        cancel: &(dyn Fn() -> bool + Sync),
    ) -> Result<Sensitivity, Error> {
        self.check_state(x0)?;
        self.check_method(method)?;
        let components = || self.components().iter().map(|own| own.name.as_str());
        let parameters = || self.parameters().iter().map(|own| own.name.as_str());
        let variable = |name: &&str| {
            let parameter = parameters().position(|own| own == *name).map(Variable::Parameter);
            let start = || components().position(|own| own == *name).map(Variable::Start);
            let unknown = || Error::unknown("parameter or component", name, parameters().chain(components()));
            parameter.or_else(start).ok_or_else(unknown)
        };
        let by: Vec<Variable> = by.iter().map(variable).collect::<Result<_, _>>()?;
        self.run(|| self.engine.sensitivity(method, times, x0, &by, cancel))
    }

    /// Fits parameters to measurements.
    ///
    /// # Errors
    /// If names, settings or measurements are invalid, or if the model cannot be integrated at its own parameters.
    pub fn fit(&self, fit: &Fit, experiments: &[Experiment]) -> Result<Fitted, Error> {
        self.check_method(&fit.method)?;
        for experiment in experiments {
            let known = experiment.known.as_ref().map(|(_, x)| x);
            known
                .into_iter()
                .chain(&experiment.guess)
                .try_for_each(|x| self.check_state(x))?;
        }
        worker::on_all(|| self.engine.fit(fit, experiments))
    }

    /// Finds the methods and settings with which trajectories from the starts end with at most this `error`, the
    /// fastest first. It takes as long as some thousand trajectories. Errors are relative to the larger of the size of
    /// each component and `scale`, which is usually 1. Methods take part for which `generate` has the functions:
    /// `jacobian`, `taylor`, `canonical`.
    ///
    /// # Errors
    /// If a start has another length, and those of [`Tuning::run`](pendulum_core::accuracy::Tuning::run).
    pub fn tune(&self, span: [f64; 2], starts: &[Vec<f64>], error: f64, scale: f64) -> Result<Vec<Choice>, Error> {
        self.tune_unless(span, starts, error, scale, &|| false)
    }

    /// Like [`tune`](Self::tune), unless `cancel` becomes true.
    ///
    /// # Errors
    /// See [`tune`](Self::tune).
    pub fn tune_unless(
        &self,
        span: [f64; 2],
        starts: &[Vec<f64>],
        error: f64,
        scale: f64,
        cancel: &(dyn Fn() -> bool + Sync),
    ) -> Result<Vec<Choice>, Error> {
        starts.iter().try_for_each(|start| self.check_state(start))?;
        let has = |routine| self.needs("a method", routine, routine).is_ok();
        let kinds = Kinds {
            implicit: has("jacobian"),
            series: self.check_method(&Method::new("Taylor")?).is_ok(),
            canonical: has("canonical"),
        };
        self.run(|| self.engine.tune(span, starts, error, scale, kinds, cancel))
    }
}
