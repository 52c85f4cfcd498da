//! Errors as exceptions.

use pendulum_runtime::{Error, StabilityError};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::{create_exception, types::PyList};

create_exception!(
    pendulum_dynamics,
    DeclarationError,
    PyValueError,
    "Errors in a declaration.\n\n`problems` lists them, each a dict with `line`, `column`, `width`, `code`, `message`, \
     `help` and the `source` line; lines and columns begin at 1."
);

/// An error of the library as an exception: `RuntimeError` where a search finds nothing, otherwise `ValueError`.
pub(crate) fn exception(py: Python<'_>, error: Error) -> PyErr {
    let message = error.to_string();
    let Error::Declaration(declaration) = error else {
        return match error {
            Error::NotAssembled(_) | Error::Stability(StabilityError::NoConvergence { .. }) => {
                PyRuntimeError::new_err(message)
            }
            _ => PyValueError::new_err(message),
        };
    };
    let exception = DeclarationError::new_err(message);
    let problems = PyList::empty(py);
    let fill = || -> PyResult<()> {
        for problem in declaration.problems {
            let fields = pyo3::types::PyDict::new(py);
            fields.set_item("line", problem.line)?;
            fields.set_item("column", problem.column)?;
            fields.set_item("width", problem.width)?;
            fields.set_item("code", problem.code)?;
            fields.set_item("message", problem.message)?;
            fields.set_item("help", problem.help)?;
            fields.set_item("source", problem.source)?;
            problems.append(fields)?;
        }
        exception.value(py).setattr("problems", &problems)
    };
    match fill() {
        Ok(()) => exception,
        Err(error) => error,
    }
}

/// Errors of the library raised as exceptions.
pub(crate) trait OrRaise<R> {
    /// Result, or the [`exception`] of its error.
    fn or_raise(self, py: Python<'_>) -> PyResult<R>;
}

impl<R, E: Into<Error>> OrRaise<R> for Result<R, E> {
    fn or_raise(self, py: Python<'_>) -> PyResult<R> {
        self.map_err(|error| exception(py, error.into()))
    }
}
