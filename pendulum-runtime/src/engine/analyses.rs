//! Analyses of padded models.

use nalgebra::DMatrix;
use pendulum_core::sensitivity::Variable;

use crate::error::Error;
use crate::fit::{self, Experiment, Fit, Fitted};
use crate::method::Method;
use crate::padded::Padded;
use crate::sensitivity::{self, Sensitivity};
use crate::stability::{self, Equilibrium, Exponents, Lyapunov, Resting};
use crate::tune::{self, Choice, Kinds};
use crate::worker::Cancel;

/// Analyses of a padded model of any length.
pub(crate) trait Analyses {
    fn equilibria(&self, seeds: &[Vec<f64>]) -> Result<(Vec<Equilibrium>, Vec<String>), Error>;
    fn resting(&self, seed: &[f64]) -> Result<Resting, Error>;
    fn lyapunov(&self, x0: &[f64], settings: &Lyapunov, cancel: &Cancel<'_>) -> Result<Exponents, Error>;
    fn sensitivity(
        &self,
        method: &Method,
        times: &[f64],
        x0: &[f64],
        by: &[Variable],
        cancel: &Cancel<'_>,
    ) -> Result<Sensitivity, Error>;
    fn output_slopes(&self, x: &[f64]) -> DMatrix<f64>;
    fn fit(&self, fit: &Fit, experiments: &[Experiment]) -> Result<Fitted, Error>;
    fn tune(
        &self,
        span: [f64; 2],
        starts: &[Vec<f64>],
        error: f64,
        scale: f64,
        kinds: Kinds,
        cancel: &Cancel<'_>,
    ) -> Result<Vec<Choice>, Error>;
}

impl<const N: usize> Analyses for Padded<f64, N> {
    fn equilibria(&self, seeds: &[Vec<f64>]) -> Result<(Vec<Equilibrium>, Vec<String>), Error> {
        stability::equilibria(self, seeds)
    }

    fn resting(&self, seed: &[f64]) -> Result<Resting, Error> {
        stability::resting(self, seed)
    }

    fn lyapunov(&self, x0: &[f64], settings: &Lyapunov, cancel: &Cancel<'_>) -> Result<Exponents, Error> {
        stability::lyapunov(self, x0, settings, cancel)
    }

    fn sensitivity(
        &self,
        method: &Method,
        times: &[f64],
        x0: &[f64],
        by: &[Variable],
        cancel: &Cancel<'_>,
    ) -> Result<Sensitivity, Error> {
        sensitivity::sensitivity(self, method, times, x0, (by, cancel))
    }

    fn output_slopes(&self, x: &[f64]) -> DMatrix<f64> {
        sensitivity::output_slopes(self, x)
    }

    fn fit(&self, fit: &Fit, experiments: &[Experiment]) -> Result<Fitted, Error> {
        fit::fit(self, fit, experiments)
    }

    fn tune(
        &self,
        span: [f64; 2],
        starts: &[Vec<f64>],
        error: f64,
        scale: f64,
        kinds: Kinds,
        cancel: &Cancel<'_>,
    ) -> Result<Vec<Choice>, Error> {
        tune::tune(self, span, starts, error, scale, kinds, cancel)
    }
}
