//! Inputs that follow samples.

use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pendulum_runtime::{Error, SampleError, TimeTable};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::error::OrRaise;

/// An input: name, times, values, and the interpolation between them.
pub(crate) type Samples<'py> = (String, PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>, String);

/// An input in an ensemble: name, times, values with a row for each trajectory, and the interpolation.
pub(crate) type SamplesOfEach<'py> = (String, PyReadonlyArray1<'py, f64>, PyReadonlyArray2<'py, f64>, String);

/// Law of an input.
pub(crate) fn law(
    py: Python<'_>,
    name: &str,
    times: &[f64],
    values: &[f64],
    interpolation: &str,
) -> PyResult<TimeTable<1>> {
    let law = match interpolation {
        "hold" => TimeTable::hold(times, [values]),
        "linear" => TimeTable::linear(times, [values]),
        "cubic" => TimeTable::cubic(times, [values]),
        _ => {
            let known = "\"hold\", \"linear\" and \"cubic\"";
            return Err(PyValueError::new_err(format!(
                "the input `{name}`: there is no interpolation `{interpolation}`; there are {known}"
            )));
        }
    };
    let named = law.map_err(|mut error| {
        if let SampleError::Length { name, .. } | SampleError::Value { name, .. } = &mut error {
            "values".clone_into(name);
        }
        Error::Setting {
            what: format!("the input `{name}`"),
            rule: error.to_string(),
        }
    });
    named.or_raise(py)
}

/// Laws of inputs, by name.
pub(crate) fn laws(py: Python<'_>, inputs: &[Samples<'_>]) -> PyResult<Vec<(String, TimeTable<1>)>> {
    let laws = inputs.iter().map(|(name, times, values, interpolation)| {
        let law = law(py, name, times.as_slice()?, values.as_slice()?, interpolation)?;
        Ok((name.clone(), law))
    });
    laws.collect()
}
