//! Fits.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use numpy::PyReadonlyArray1;
use pendulum_runtime::{Experiment, Fit, Loss, Measurement, Method, Model};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::OrRaise;
use crate::inputs::{Samples, laws};
use crate::motion::rows;
use crate::wait::wait;

/// A measured motion: times, then outputs with their values and noise; a first guess of the state, or a known one with
/// its time; samples of inputs.
#[derive(FromPyObject)]
pub(crate) struct Given<'py> {
    #[pyo3(item)]
    t: PyReadonlyArray1<'py, f64>,
    #[pyo3(item)]
    outputs: Vec<(String, PyReadonlyArray1<'py, f64>, Option<f64>)>,
    #[pyo3(item)]
    guess: Option<Vec<f64>>,
    #[pyo3(item)]
    known: Option<(f64, Vec<f64>)>,
    #[pyo3(item)]
    inputs: Vec<Samples<'py>>,
}

/// Settings.
#[derive(FromPyObject)]
pub(crate) struct Options {
    #[pyo3(item)]
    free: Option<Vec<String>>,
    #[pyo3(item)]
    bounds: Vec<(String, f64, f64)>,
    #[pyo3(item)]
    loss: (String, f64),
    #[pyo3(item)]
    windows: Option<f64>,
    #[pyo3(item)]
    separate_windows: Option<f64>,
    #[pyo3(item)]
    max_iterations: usize,
}

pub(crate) fn fit<'py>(
    py: Python<'py>,
    model: &Model,
    method: Method,
    given: Vec<Given<'py>>,
    options: Options,
) -> PyResult<Bound<'py, PyDict>> {
    let experiments = given.into_iter().map(|own| {
        let mut measurement = Measurement::new(own.t.as_slice()?).or_raise(py)?;
        for (name, values, noise) in &own.outputs {
            measurement = match noise {
                Some(noise) => measurement.output_with_noise(name, values.as_slice()?, *noise),
                None => measurement.output(name, values.as_slice()?),
            }
            .or_raise(py)?;
        }
        Ok(Experiment {
            measurement,
            guess: own.guess,
            known: own.known,
            laws: laws(py, &own.inputs)?,
        })
    });
    let experiments: Vec<Experiment> = experiments.collect::<PyResult<_>>()?;
    let loss = match options.loss {
        (name, _) if name == "squares" => Loss::Squares,
        (name, threshold) if name == "huber" => Loss::Huber(threshold),
        (name, threshold) if name == "soft_l1" => Loss::SoftL1(threshold),
        (name, threshold) if name == "cauchy" => Loss::Cauchy(threshold),
        (name, _) => {
            let known = "`squares`, `huber`, `soft_l1` and `cauchy`";
            return Err(PyValueError::new_err(format!(
                "there is no loss `{name}`; there are {known}"
            )));
        }
    };
    let cancel = Arc::new(AtomicBool::new(false));
    let settings = Fit {
        free: options.free,
        bounds: options
            .bounds
            .into_iter()
            .map(|(name, low, high)| (name, [low, high]))
            .collect(),
        loss,
        windows: options.windows,
        separate_windows: options.separate_windows,
        max_iterations: options.max_iterations,
        cancel: Some(cancel.clone()),
        ..Fit::new(method)
    };
    let (fitted, signal) = wait(py, &cancel, || model.fit(&settings, &experiments));
    if let Some(error) = signal {
        return Err(error);
    }
    let fitted = fitted.or_raise(py)?;
    let result = PyDict::new(py);
    result.set_item("parameters", fitted.parameters)?;
    let estimates = fitted.estimates.iter();
    let estimates = estimates.map(|own| (own.name.clone(), own.value, own.deviation, own.interval));
    result.set_item("estimates", estimates.collect::<Vec<_>>())?;
    let free = fitted.covariance.len();
    result.set_item("covariance", rows(py, fitted.covariance.concat(), free)?)?;
    result.set_item("starts", fitted.starts)?;
    result.set_item("residuals", fitted.residuals)?;
    result.set_item("noise", fitted.noise)?;
    result.set_item("warnings", fitted.warnings)?;
    result.set_item("converged", fitted.converged)?;
    result.set_item("iterations", fitted.iterations)?;
    result.set_item("summary", fitted.summary)?;
    Ok(result)
}
