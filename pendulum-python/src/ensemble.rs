//! Ensembles.

use std::sync::atomic::AtomicBool;

use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pendulum_runtime::{Members, Method, Model, TimeTable};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;

use crate::error::OrRaise;
use crate::inputs::{SamplesOfEach, law};
use crate::motion::rows;
use crate::wait::wait;

/// Final states as rows; states by member, time and component; index, time and reason of each member that stopped.
pub(crate) type Results<'py> = (
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray3<f64>>,
    Vec<(usize, f64, String)>,
);

#[allow(clippy::too_many_arguments, reason = "those of Python")]
pub(crate) fn ensemble<'py>(
    py: Python<'py>,
    model: &Model,
    method: &Method,
    span: [f64; 2],
    starts: PyReadonlyArray2<'py, f64>,
    parameters: Option<PyReadonlyArray2<'py, f64>>,
    inputs: Vec<SamplesOfEach<'py>>,
    times: PyReadonlyArray1<'py, f64>,
) -> PyResult<Results<'py>> {
    let (count, length) = (starts.shape()[0], model.components().len());
    let (starts, times) = (starts.as_slice()?.to_vec(), times.as_slice()?.to_vec());
    let parameters = parameters.map(|own| own.as_slice().map(<[f64]>::to_vec)).transpose()?;
    let laws = inputs.iter().map(|(name, times, values, interpolation)| {
        let (times, rows) = (times.as_slice()?, values.as_slice()?.chunks(values.shape()[1].max(1)));
        let laws = rows.map(|values| law(py, name, times, values, interpolation));
        Ok((name.as_str(), laws.collect::<PyResult<_>>()?))
    });
    let laws: Vec<(&str, Vec<TimeTable<1>>)> = laws.collect::<PyResult<_>>()?;
    let cancel = AtomicBool::new(false);
    let (found, signal) = wait(py, &cancel, || {
        let members = Members {
            starts: &starts,
            parameters: parameters.as_deref(),
            laws: &laws,
            times: &times,
            cancel: Some(&cancel),
        };
        model.ensemble(method, span, &members)
    });
    if let Some(error) = &signal
        && !error.is_instance_of::<PyKeyboardInterrupt>(py)
    {
        return Err(error.clone_ref(py));
    }
    let found = found.or_raise(py)?;
    let stopped = found.stopped.iter().map(|(n, t, reason)| {
        let reason = match signal {
            Some(_) => "interrupted".to_owned(),
            None => reason.to_string(),
        };
        (*n, *t, reason)
    });
    let samples = PyArray1::from_vec(py, found.samples).reshape([count, times.len(), length])?;
    Ok((rows(py, found.ends, length)?, samples, stopped.collect()))
}
