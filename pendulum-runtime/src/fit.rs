//! Fits of parameters to measurements.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use pendulum_core::fit::{self, Estimate, Loss, Measurement};
use pendulum_core::inputs::TimeTable;

use crate::error::Error;
use crate::method::Method;
use crate::padded::{Padded, follow, padded};
use crate::sensitivity::{MOST_PARAMETERS, Tangent, TaskWithDerivatives, check_parameters};

/// A measured motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Experiment {
    /// Measured outputs.
    pub measurement: Measurement,
    /// First guess of the state at the first sample.
    pub guess: Option<Vec<f64>>,
    /// Known state, and its time, from which the motion begins.
    pub known: Option<(f64, Vec<f64>)>,
    /// Inputs during the measurement, such as recorded torques; those of the model where an input is not named.
    pub laws: Vec<(String, TimeTable<1>)>,
}

/// A fit: the method of integration, and settings.
#[derive(Clone, Debug)]
pub struct Fit {
    /// Method.
    pub method: Method,
    /// Names of the free parameters; `None` for all.
    pub free: Option<Vec<String>>,
    /// Bounds of parameters.
    pub bounds: Vec<(String, [f64; 2])>,
    /// Loss of the residuals.
    pub loss: Loss,
    /// Length of windows that are joined in the end, in s: for long or chaotic motions that the model follows. Excludes
    /// [`separate_windows`](Self::separate_windows).
    pub windows: Option<f64>,
    /// Length of windows with starts of their own, in s: for motions with disturbances that the model does not have.
    /// Excludes [`windows`](Self::windows).
    pub separate_windows: Option<f64>,
    /// Maximum number of steps of the search.
    pub max_iterations: usize,
    /// Ends the search with the best parameters so far when it becomes true.
    pub cancel: Option<Arc<AtomicBool>>,
}

impl Fit {
    /// A fit of all parameters by squares of residuals, over whole motions.
    #[must_use]
    pub fn new(method: Method) -> Self {
        Self {
            method,
            free: None,
            bounds: Vec::new(),
            loss: Loss::Squares,
            windows: None,
            separate_windows: None,
            max_iterations: 200,
            cancel: None,
        }
    }
}

/// Result of a fit.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Fitted {
    /// All parameters, in the order of their declaration.
    pub parameters: Vec<f64>,
    /// Estimates of the free ones.
    pub estimates: Vec<Estimate>,
    /// Covariance of the estimates, row by row.
    pub covariance: Vec<Vec<f64>>,
    /// States at the start of each window.
    pub starts: Vec<Vec<f64>>,
    /// Output, measured minus computed values, for each column of each experiment.
    pub residuals: Vec<(String, Vec<f64>)>,
    /// Standard deviation of the noise of each output.
    pub noise: Vec<(String, f64)>,
    /// Reasons to doubt the result.
    pub warnings: Vec<String>,
    /// True if the search converged.
    pub converged: bool,
    /// Number of steps of the search.
    pub iterations: usize,
    /// Table of the estimates, with warnings.
    pub summary: String,
}

struct Run<'a, const N: usize> {
    model: &'a Padded<f64, N>,
    /// The model with the inputs of each experiment.
    driven: &'a [Padded<f64, N>],
    fit: &'a Fit,
    experiments: &'a [Experiment],
}

impl<const N: usize> TaskWithDerivatives<N> for Run<'_, N> {
    type Output = Result<Fitted, Error>;

    fn by(self, method: impl pendulum_core::Method<Padded<Tangent, N>, Tangent, N> + Sync) -> Self::Output {
        let own = self.fit;
        let names = || self.model.tape().parameters().iter().map(|parameter| parameter.name);
        let mut fit = fit::Fit::new(method).loss(own.loss).max_iterations(own.max_iterations);
        fit = match &own.free {
            Some(free) => fit.free(free.iter().map(String::as_str)),
            None => fit.free(names()),
        };
        for (name, [low, high]) in &own.bounds {
            fit = fit.bounds(name, *low, *high);
        }
        if let Some(length) = own.windows {
            fit = fit.windows(length);
        }
        if let Some(length) = own.separate_windows {
            fit = fit.separate_windows(length);
        }
        let experiments = self.driven.iter().zip(self.experiments).map(|(model, experiment)| {
            let mut of = fit::Experiment::new(model, &experiment.measurement);
            if let Some(guess) = &experiment.guess {
                of = of.from_guess(padded::<N>(guess));
            }
            if let Some((t0, known)) = &experiment.known {
                of = of.from_known(*t0, padded::<N>(known));
            }
            of
        });
        let experiments: Vec<_> = experiments.collect();
        let cancel = own.cancel.as_deref();
        let fitted = fit.run_with::<_, N, MOST_PARAMETERS>(&experiments, |_| match cancel {
            Some(cancel) if cancel.load(Ordering::Relaxed) => ControlFlow::Break(()),
            _ => ControlFlow::Continue(()),
        })?;
        let length = self.model.tape().length();
        let covariance = fitted.covariance.row_iter().map(|row| row.iter().copied().collect());
        Ok(Fitted {
            summary: fitted.to_string(),
            parameters: fitted.parameters[..self.model.params().len()].to_vec(),
            covariance: covariance.collect(),
            starts: fitted
                .windows
                .iter()
                .map(|window| window.start.as_slice()[..length].to_vec())
                .collect(),
            residuals: fitted
                .residuals
                .into_iter()
                .map(|residuals| (residuals.output, residuals.values))
                .collect(),
            noise: fitted.noise,
            warnings: fitted.warnings.iter().map(ToString::to_string).collect(),
            converged: fitted.status == fit::Status::Converged,
            iterations: fitted.iterations,
            estimates: fitted.estimates,
        })
    }
}

pub(crate) fn fit<const N: usize>(
    model: &Padded<f64, N>,
    fit: &Fit,
    experiments: &[Experiment],
) -> Result<Fitted, Error> {
    check_parameters(model)?;
    if fit.windows.is_some() && fit.separate_windows.is_some() {
        let (what, rule) = (
            "`windows` and `separate_windows`",
            "only one of them can be set: windows are joined in the end, or stay separate",
        );
        return Err(Error::setting(what, rule));
    }
    let known = model.tape().parameters().iter().map(|parameter| parameter.name);
    let bounded = fit.bounds.iter().map(|(name, _)| name);
    for name in fit.free.iter().flatten().chain(bounded) {
        Error::index_of("parameter", name, known.clone())?;
    }
    let is_driven = experiments.iter().any(|experiment| !experiment.laws.is_empty());
    let driven = experiments.iter().enumerate().map(|(n, experiment)| {
        let driven = driven(model, experiment)?;
        check_inputs(&driven, n, experiment, is_driven)?;
        Ok(driven)
    });
    let driven: Vec<_> = driven.collect::<Result<_, Error>>()?;
    fit.method.run_with_derivatives(Run {
        model,
        driven: &driven,
        fit,
        experiments,
    })?
}

/// The model with the inputs of an experiment.
fn driven<const N: usize>(model: &Padded<f64, N>, experiment: &Experiment) -> Result<Padded<f64, N>, Error> {
    let names = model.tape().inputs().iter().map(|input| input.name);
    let laws = experiment.laws.iter().map(|(name, law)| {
        let input = Error::index_of("input", name, names.clone())?;
        Ok((input, law.clone()))
    });
    let laws: Vec<_> = laws.collect::<Result<_, Error>>()?;
    let mut model = model.clone();
    follow(&mut model, laws);
    Ok(model)
}

/// Checks that the samples of each input cover an experiment, and that no input was forgotten: where some have laws,
/// one without would be zero.
fn check_inputs<const N: usize>(
    driven: &Padded<f64, N>,
    number: usize,
    experiment: &Experiment,
    is_driven: bool,
) -> Result<(), Error> {
    let &[first, ..] = experiment.measurement.times() else {
        // which the fit itself refuses
        return Ok(());
    };
    let from = experiment.known.as_ref().map_or(first, |(t, _)| t.min(first));
    let to = experiment.measurement.times().last().map_or(first, |last| *last);
    for (n, (input, value)) in driven.tape().inputs().iter().zip(driven.inputs()).enumerate() {
        let what = format!("the input `{}` of experiment {number}", input.name);
        match driven.input_laws().find(|(own, _)| *own == n) {
            Some((_, law)) if !law.covers(from, to) => {
                let own = law.times();
                let (first, last) = (own[0], own[own.len() - 1]);
                let rule = format!(
                    "its samples are of {first:?} to {last:?} s, and the motion is of {from:?} to {to:?} s; \
                     give samples of the whole motion, or leave out measured values outside of them"
                );
                return Err(Error::setting(&what, rule));
            }
            None if is_driven && *value == 0.0 => {
                let rule = "others have samples: give those of this one as well, or a single 0 if nothing acts";
                return Err(Error::setting(&what, rule));
            }
            _ => {}
        }
    }
    Ok(())
}
