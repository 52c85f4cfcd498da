//! Trajectories.

use numpy::{PyArray1, PyArray2, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::OrRaise;

/// A trajectory, and the way in which it ended.
#[pyclass(frozen, module = "pendulum_dynamics._native")]
pub(crate) struct Motion {
    pub(crate) motion: pendulum_runtime::Motion,
    /// -1 if it stopped early, 0 at the end of the span, 1 at a terminal event.
    pub(crate) status: i8,
    pub(crate) message: String,
    pub(crate) length: usize,
}

/// Rows of an array, one after the other.
pub(crate) fn rows<'py>(py: Python<'py>, numbers: Vec<f64>, length: usize) -> PyResult<Bound<'py, PyArray2<f64>>> {
    use numpy::PyArrayMethods;
    let count = numbers.len().checked_div(length).unwrap_or(0);
    PyArray1::from_vec(py, numbers).reshape([count, length])
}

#[pymethods]
impl Motion {
    #[getter]
    fn status(&self) -> i8 {
        self.status
    }

    #[getter]
    fn message(&self) -> &str {
        &self.message
    }

    /// Times of the states that were kept.
    fn t<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.motion.t())
    }

    /// States that were kept, a row for each.
    fn x<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rows(py, self.motion.x().to_vec(), self.length)
    }

    /// Last time and state.
    fn end<'py>(&self, py: Python<'py>) -> (f64, Bound<'py, PyArray1<f64>>) {
        let (t, x) = self.motion.end();
        (t, PyArray1::from_slice(py, x))
    }

    /// States at times, a row for each.
    fn at<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let mut numbers = Vec::new();
        for &t in times.as_slice()? {
            numbers.extend(self.motion.at(t).or_raise(py)?);
        }
        rows(py, numbers, self.length)
    }

    /// Times and states of an event.
    #[allow(clippy::type_complexity, reason = "two arrays")]
    fn event<'py>(
        &self,
        py: Python<'py>,
        index: usize,
    ) -> PyResult<(Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>)> {
        let own = || self.motion.occurrences().iter().filter(|event| event.index == index);
        let times = PyArray1::from_iter(py, own().map(|event| event.t));
        Ok((
            times,
            rows(py, own().flat_map(|event| event.x.clone()).collect(), self.length)?,
        ))
    }

    /// Mode switches: the time, and the constraints that stick or touch from then on.
    fn modes(&self) -> Vec<(f64, String)> {
        self.motion.modes().to_vec()
    }

    /// Impacts: the time, the states before and after, and the impulses by name.
    #[allow(clippy::type_complexity, reason = "the fields of an impact")]
    fn impacts<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<
        Vec<(
            f64,
            Bound<'py, PyArray1<f64>>,
            Bound<'py, PyArray1<f64>>,
            Bound<'py, PyDict>,
        )>,
    > {
        let impacts = self.motion.impacts().iter().map(|impact| {
            let impulses = PyDict::new(py);
            for (name, impulse) in &impact.impulses {
                impulses.set_item(name, impulse)?;
            }
            let states = [&impact.before, &impact.after].map(|x| PyArray1::from_slice(py, x));
            let [before, after] = states;
            Ok((impact.t, before, after, impulses))
        });
        impacts.collect()
    }

    fn warnings(&self) -> Vec<String> {
        self.motion.warnings().to_vec()
    }

    /// Numbers of evaluations, Jacobians, factorisations, accepted and rejected steps.
    fn statistics(&self) -> [usize; 5] {
        let own = self.motion.statistics();
        [
            own.evaluations,
            own.jacobians,
            own.factorizations,
            own.accepted,
            own.rejected,
        ]
    }
}
