//! Models.

use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use numpy::{PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use pendulum_runtime::{
    Choice, Declaration, Event, Lyapunov, Method, Options, Quantity, Question, ResultShape, Robot, Simpler, Stability,
    Stopped, simplest_unless,
};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::{OrRaise, exception};
use crate::inputs::{Samples, SamplesOfEach, laws};
use crate::motion::{Motion, rows};
use crate::wait::{Signals, wait};
use crate::{ensemble, fit};

/// A mechanism with values of its parameters and inputs.
#[pyclass(frozen, module = "pendulum_dynamics._native")]
pub(crate) struct Model(pub(crate) pendulum_runtime::Model);

/// A method by name, with the settings that are not its defaults.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Settings {
    method: String,
    h: Option<f64>,
    rtol: Option<f64>,
    atol: Option<f64>,
    h0: Option<f64>,
    h_min: Option<f64>,
    h_max: Option<f64>,
    max_steps: Option<usize>,
}

/// A method with its settings.
pub(crate) fn method(py: Python<'_>, settings: Settings) -> PyResult<Method> {
    let method = Method::new(&settings.method).or_raise(py)?;
    let with = |method, value: Option<f64>, set: fn(Method, f64) -> Method| match value {
        Some(value) => set(method, value),
        None => method,
    };
    let method = with(method, settings.h, Method::h);
    let method = with(method, settings.rtol, Method::rtol);
    let method = with(method, settings.atol, Method::atol);
    let method = with(method, settings.h0, Method::h0);
    let method = with(method, settings.h_min, Method::h_min);
    let method = with(method, settings.h_max, Method::h_max);
    Ok(match settings.max_steps {
        Some(max_steps) => method.max_steps(max_steps),
        None => method,
    })
}

/// A simpler model: changes, declaration, predicted and observed errors, operations of an evaluation and of a motion.
type Row = (Vec<String>, String, Vec<f64>, Vec<f64>, usize, f64);

fn named(values: &[(String, f64)]) -> Vec<(&str, f64)> {
    values.iter().map(|(name, value)| (name.as_str(), *value)).collect()
}

/// Event as it is given: a function, the name of a declared one, or a name with a value.
#[derive(FromPyObject)]
enum What {
    Declared(String),
    Value(String, f64),
    Function(Py<PyAny>),
}

/// Calls functions of the user, and keeps the first exception.
struct Calls {
    signals: Signals,
    raised: Mutex<Option<PyErr>>,
}

impl Calls {
    fn call(&self, function: &Py<PyAny>, t: f64, x: &[f64]) -> f64 {
        if self.signals.cancel.load(Ordering::Relaxed) {
            // neither zero nor a sign
            return f64::NAN;
        }
        let value = Python::attach(|py| {
            let value = function.call1(py, (t, PyArray1::from_slice(py, x)))?;
            value.extract::<f64>(py)
        });
        value.unwrap_or_else(|error| {
            self.signals.cancel.store(true, Ordering::Relaxed);
            let is_signal = Python::attach(|py| error.is_instance_of::<PyKeyboardInterrupt>(py));
            if is_signal {
                // it arrived while the function ran
                self.signals.put(error);
            } else if let Ok(mut raised) = self.raised.lock() {
                raised.get_or_insert(error);
            }
            f64::NAN
        })
    }
}

#[pymethods]
impl Model {
    #[new]
    fn new(py: Python<'_>, text: &str, folder: PathBuf, values: Vec<(String, f64)>) -> PyResult<Self> {
        let declaration = Declaration::new(text).folder(&folder);
        let parse = || pendulum_runtime::Model::declared(&declaration, &named(&values));
        let model = py.detach(parse);
        model.map(Self).or_raise(py)
    }

    /// Declaration of the robot of a file.
    #[staticmethod]
    fn robot(path: PathBuf, gravity: [f64; 3], limits: bool, repair: bool, generate: Option<Vec<String>>) -> String {
        let mut robot = Robot::new(path).gravity(gravity).limits(limits).repair(repair);
        if let Some(words) = &generate {
            robot = robot.generate(words.iter().map(String::as_str));
        }
        robot.declaration()
    }

    fn with_parameters(&self, py: Python<'_>, values: Vec<(String, f64)>) -> PyResult<Self> {
        let model = self.0.with(&named(&values));
        model.map(Self).or_raise(py)
    }

    fn with_inputs(&self, py: Python<'_>, values: Vec<(String, f64)>, samples: Vec<Samples<'_>>) -> PyResult<Self> {
        let laws = laws(py, &samples)?;
        let laws: Vec<_> = laws.iter().map(|(name, law)| (name.as_str(), law.clone())).collect();
        let model = self.0.with_inputs(&named(&values)).or_raise(py)?;
        model.with_laws(&laws).map(Self).or_raise(py)
    }

    #[getter]
    fn name(&self) -> &str {
        self.0.name()
    }

    #[getter]
    fn docs(&self) -> &str {
        self.0.docs()
    }

    /// Name, unit, value and comment of each parameter.
    fn parameters(&self) -> Vec<(&str, &str, f64, &str)> {
        let own = self.0.parameters().iter().zip(self.0.values());
        own.map(|(own, value)| (own.name.as_str(), own.unit.as_str(), *value, own.docs.as_str()))
            .collect()
    }

    /// Name, unit, value and comment of each input.
    fn inputs(&self) -> Vec<(&str, &str, f64, &str)> {
        let own = self.0.inputs().iter().zip(self.0.inputs_now());
        own.map(|(own, value)| (own.name.as_str(), own.unit.as_str(), *value, own.docs.as_str()))
            .collect()
    }

    /// Name and unit of each component of the state.
    fn components(&self) -> Vec<(&str, &str)> {
        let own = self.0.components().iter();
        own.map(|own| (own.name.as_str(), own.unit.as_str())).collect()
    }

    fn outputs(&self) -> Vec<&'static str> {
        self.0.outputs().to_vec()
    }

    fn events(&self) -> Vec<&str> {
        self.0.events().collect()
    }

    fn constraints(&self) -> Vec<&str> {
        self.0.constraints().collect()
    }

    fn repaired(&self) -> Vec<String> {
        self.0.repaired().to_vec()
    }

    /// Name, comment, arguments, form and operations of each function.
    #[allow(clippy::type_complexity, reason = "the fields of a function")]
    fn functions(&self) -> Vec<(&str, &str, Vec<&'static str>, &str, [usize; 5])> {
        let own = self.0.functions().iter();
        own.map(|own| {
            let (name, docs, form) = (own.name.as_str(), own.docs.as_str(), own.form.as_str());
            (name, docs, own.arguments.clone(), form, own.operations)
        })
        .collect()
    }

    #[getter]
    fn equations(&self) -> &str {
        self.0.equations()
    }

    #[getter]
    fn latex(&self) -> &str {
        self.0.latex()
    }

    fn state<'py>(&self, py: Python<'py>, values: Vec<(String, f64)>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let x = self.0.state(&named(&values)).or_raise(py)?;
        Ok(PyArray1::from_vec(py, x))
    }

    fn rhs<'py>(&self, py: Python<'py>, t: f64, x: PyReadonlyArray1<'py, f64>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let rates = self.0.rhs(t, x.as_slice()?).or_raise(py)?;
        Ok(PyArray1::from_vec(py, rates))
    }

    fn jacobian<'py>(
        &self,
        py: Python<'py>,
        t: f64,
        x: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let jacobian = self.0.jacobian(t, x.as_slice()?).or_raise(py)?;
        rows(py, jacobian.transpose().as_slice().to_vec(), jacobian.ncols())
    }

    fn energy(&self, py: Python<'_>, t: f64, x: PyReadonlyArray1<'_, f64>) -> PyResult<[f64; 2]> {
        self.0.energy(t, x.as_slice()?).or_raise(py)
    }

    fn outputs_at<'py>(
        &self,
        py: Python<'py>,
        t: f64,
        x: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let outputs = self.0.outputs_at(t, x.as_slice()?).or_raise(py)?;
        Ok(PyArray1::from_vec(py, outputs))
    }

    /// Results of a function, each as rows, and its number of dimensions.
    #[allow(clippy::type_complexity, reason = "a list of pairs")]
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        t: f64,
        x: PyReadonlyArray1<'py, f64>,
        lists: Vec<PyReadonlyArray1<'py, f64>>,
    ) -> PyResult<Vec<(Bound<'py, PyArray2<f64>>, u8)>> {
        let lists: Vec<&[f64]> = lists.iter().map(|list| list.as_slice()).collect::<Result<_, _>>()?;
        let results = self.0.evaluate(name, t, x.as_slice()?, &lists);
        let results = results.or_raise(py)?;
        let function = self.0.functions().iter().find(|function| function.name == name);
        let shapes = function.map_or(&[][..], |function| &function.shapes);
        let arrays = results.iter().zip(shapes).map(|(own, shape)| {
            let dimensions = match shape {
                ResultShape::Scalar => 0,
                ResultShape::Vector(_) => 1,
                _ => 2,
            };
            Ok((rows(py, own.transpose().as_slice().to_vec(), own.ncols())?, dimensions))
        });
        arrays.collect()
    }

    /// Name, body, kind, points as rows, and radius of each shape.
    #[allow(clippy::type_complexity, reason = "the fields of a shape")]
    fn shapes<'py>(
        &self,
        py: Python<'py>,
        t: f64,
        x: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Vec<(String, String, String, Bound<'py, PyArray2<f64>>, f64)>> {
        let shapes = self.0.shapes(t, x.as_slice()?).or_raise(py)?;
        let shapes = shapes.into_iter().map(|shape| {
            let points = shape
                .points
                .iter()
                .flat_map(|point| [point.x, point.y, point.z])
                .collect();
            let kind = format!("{:?}", shape.kind);
            Ok((
                shape.name.to_owned(),
                shape.body.to_owned(),
                kind,
                rows(py, points, 3)?,
                shape.radius,
            ))
        });
        shapes.collect()
    }

    fn assemble<'py>(
        &self,
        py: Python<'py>,
        t: f64,
        x: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let x = self.0.assemble(t, x.as_slice()?).or_raise(py)?;
        Ok(PyArray1::from_vec(py, x))
    }

    /// Integrates. Events are given with their directions, -1, 0 or 1, and whether they are terminal.
    fn solve(
        &self,
        py: Python<'_>,
        settings: Settings,
        span: [f64; 2],
        x0: PyReadonlyArray1<'_, f64>,
        times: Option<PyReadonlyArray1<'_, f64>>,
        events: Vec<(What, i8, bool)>,
    ) -> PyResult<Motion> {
        let method = method(py, settings)?;
        let calls = Calls {
            signals: Signals::new(),
            raised: Mutex::new(None),
        };
        let events = events.into_iter().map(|(what, direction, terminal)| {
            let calls = &calls;
            let event = match what {
                What::Declared(name) => Event::declared(&name),
                What::Value(name, value) => Event::value(&name, value),
                What::Function(function) => Event::new(move |t, x| calls.call(&function, t, x)),
            };
            let event = match direction {
                1 => event.rising(),
                -1 => event.falling(),
                _ => event,
            };
            if terminal { event.terminal() } else { event }
        });
        let is_cancelled = || calls.signals.is_cancelled();
        let options = Options {
            events: events.collect(),
            times: times.map(|times| times.as_slice().map(<[f64]>::to_vec)).transpose()?,
            cancel: Some(&is_cancelled),
        };
        let x0 = x0.as_slice()?.to_vec();
        let ended = calls
            .signals
            .run(py, &self.0, || self.0.solve_with(&method, span, &x0, &options));
        drop(options);
        let (raised, signal) = (calls.raised.into_inner().unwrap_or(None), calls.signals.signal());
        if let Some(error) = raised {
            return Err(error);
        }
        let interrupted = match signal {
            Some(error) if !error.is_instance_of::<PyKeyboardInterrupt>(py) => return Err(error),
            signal => signal,
        };
        let (motion, status, message) = match (ended, interrupted) {
            (Ok(motion), None) => match motion.ended_by() {
                Some(event) => (motion, 1, format!("terminal event {event} occurred")),
                None => (motion, 0, "the end of the span was reached".to_owned()),
            },
            (Ok(motion), Some(_)) => (motion, -1, "interrupted".to_owned()),
            (
                Err(Stopped {
                    motion: Some(motion), ..
                }),
                Some(_),
            ) => (*motion, -1, "interrupted".to_owned()),
            (Err(Stopped { motion: None, .. }), Some(signal)) => return Err(signal),
            (
                Err(Stopped {
                    error,
                    motion: Some(motion),
                    ..
                }),
                None,
            ) => (*motion, -1, error.to_string()),
            (Err(Stopped { error, .. }), None) => return Err(exception(py, *error)),
        };
        Ok(Motion {
            motion,
            status,
            message,
            length: x0.len(),
        })
    }

    #[allow(clippy::too_many_arguments, reason = "those of Python")]
    fn ensemble<'py>(
        &self,
        py: Python<'py>,
        settings: Settings,
        span: [f64; 2],
        starts: PyReadonlyArray2<'py, f64>,
        parameters: Option<PyReadonlyArray2<'py, f64>>,
        inputs: Vec<SamplesOfEach<'py>>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<ensemble::Results<'py>> {
        let method = method(py, settings)?;
        ensemble::ensemble(py, &self.0, &method, span, starts, parameters, inputs, times)
    }

    /// State, stability and eigenvalues of each equilibrium; and the coordinates that were not searched completely.
    #[allow(clippy::type_complexity, reason = "the fields of an equilibrium")]
    fn equilibria<'py>(
        &self,
        py: Python<'py>,
        seeds: Vec<Vec<f64>>,
    ) -> PyResult<(
        Vec<(Bound<'py, PyArray1<f64>>, &'static str, Vec<(f64, f64)>)>,
        Vec<String>,
    )> {
        let found = py.detach(|| self.0.equilibria(&seeds));
        let (found, unsearched) = found.or_raise(py)?;
        let found = found.into_iter().map(|own| {
            let stability = match own.stability {
                Stability::AsymptoticallyStable => "asymptotically stable",
                Stability::Unstable => "unstable",
                Stability::Undecided => "undecided",
            };
            let eigenvalues = own.eigenvalues.iter().map(|value| (value.re, value.im)).collect();
            (PyArray1::from_vec(py, own.x), stability, eigenvalues)
        });
        Ok((found.collect(), unsearched))
    }

    /// State of rest, the constraints that hold it, and the reserve of friction.
    fn resting<'py>(
        &self,
        py: Python<'py>,
        seed: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<(Bound<'py, PyArray1<f64>>, String, f64)> {
        let seed = seed.as_slice()?.to_vec();
        let found = py.detach(|| self.0.resting(&seed)).or_raise(py)?;
        Ok((PyArray1::from_vec(py, found.x), found.mode, found.margin))
    }

    /// Exponents and their standard errors.
    fn lyapunov(
        &self,
        py: Python<'_>,
        x0: PyReadonlyArray1<'_, f64>,
        count: usize,
        duration: f64,
        transient: f64,
        tolerance: f64,
    ) -> PyResult<(Vec<f64>, Vec<f64>)> {
        let x0 = x0.as_slice()?.to_vec();
        let settings = Lyapunov {
            count,
            duration,
            transient,
            tolerance,
        };
        let signals = Signals::new();
        let found = signals.run(py, &self.0, || {
            let cancel = || signals.is_cancelled();
            self.0.lyapunov_unless(&x0, &settings, &cancel)
        });
        let found = signals.instead_of(py, found)?;
        Ok((found.values, found.uncertainty))
    }

    /// Methods that keep within an error, the fastest first: name, settings, error, evaluations, time.
    #[allow(clippy::type_complexity, reason = "a row")]
    fn tune(
        &self,
        py: Python<'_>,
        span: [f64; 2],
        starts: Vec<Vec<f64>>,
        error: f64,
        scale: f64,
    ) -> PyResult<Vec<(&'static str, [Option<f64>; 3], f64, f64, f64)>> {
        let signals = Signals::new();
        let found = signals.run(py, &self.0, || {
            let cancel = || signals.is_cancelled();
            self.0.tune_unless(span, &starts, error, scale, &cancel)
        });
        let found = signals.instead_of(py, found)?;
        let row = |choice: Choice| {
            let Choice {
                method,
                error,
                evaluations,
                time,
                ..
            } = choice;
            (method.name(), method.settings(), error, evaluations, time)
        };
        Ok(found.into_iter().map(row).collect())
    }

    /// Outputs that are compared, simpler models, changes that lead to none, the simplest one, and a table.
    #[allow(clippy::type_complexity, reason = "rows")]
    fn simplest(
        &self,
        py: Python<'_>,
        text: &str,
        folder: PathBuf,
        horizon_and_error: (f64, f64),
        starts: Vec<Vec<f64>>,
        outputs: Vec<String>,
    ) -> PyResult<(Vec<String>, Vec<Row>, Vec<(Vec<String>, String)>, Option<usize>, String)> {
        let (horizon, error) = horizon_and_error;
        let own = |names: &[Quantity], values: &[f64]| -> Vec<(String, f64)> {
            let names = names.iter().map(|own| own.name.clone());
            names.zip(values.iter().copied()).collect()
        };
        let question = Question {
            starts,
            horizon,
            outputs,
            error,
            values: own(self.0.parameters(), self.0.values()),
            inputs: own(self.0.inputs(), self.0.inputs_now()),
            laws: self
                .0
                .laws()
                .into_iter()
                .map(|(name, law)| (name.to_owned(), law))
                .collect(),
        };
        let declaration = Declaration::new(text).folder(&folder);
        let cancel = AtomicBool::new(false);
        let (found, signal) = wait(py, &cancel, || {
            simplest_unless(&declaration, &question, &|| cancel.load(Ordering::Relaxed))
        });
        let found = match signal {
            Some(signal) => return Err(signal),
            None => found.or_raise(py)?,
        };
        let chosen = found
            .simplest()
            .and_then(|own| found.simpler.iter().position(|one| std::ptr::eq(one, own)));
        let table = found.to_string();
        let row = |one: Simpler| {
            (
                one.changes,
                one.declaration,
                one.predicted,
                one.observed,
                one.cost.operations,
                one.cost.total,
            )
        };
        let refused = found.refused.into_iter().map(|one| (one.changes, one.reason));
        Ok((
            found.outputs,
            found.simpler.into_iter().map(row).collect(),
            refused.collect(),
            chosen,
            table,
        ))
    }

    /// States as rows, and derivatives as a list of matrices.
    #[allow(clippy::type_complexity, reason = "two arrays")]
    fn sensitivity<'py>(
        &self,
        py: Python<'py>,
        settings: Settings,
        times: PyReadonlyArray1<'py, f64>,
        x0: PyReadonlyArray1<'py, f64>,
        by: Vec<String>,
    ) -> PyResult<(Bound<'py, PyArray2<f64>>, Vec<Bound<'py, PyArray2<f64>>>)> {
        let method = method(py, settings)?;
        let (times, x0) = (times.as_slice()?.to_vec(), x0.as_slice()?.to_vec());
        let by: Vec<&str> = by.iter().map(String::as_str).collect();
        let signals = Signals::new();
        let found = signals.run(py, &self.0, || {
            let cancel = || signals.is_cancelled();
            self.0.sensitivity_unless(&method, &times, &x0, &by, &cancel)
        });
        let found = signals.instead_of(py, found)?;
        let matrices = found.derivatives.iter();
        let matrices = matrices.map(|own| rows(py, own.transpose().as_slice().to_vec(), own.ncols()));
        Ok((
            rows(py, found.x.concat(), x0.len())?,
            matrices.collect::<PyResult<_>>()?,
        ))
    }

    fn fit<'py>(
        &self,
        py: Python<'py>,
        settings: Settings,
        experiments: Vec<fit::Given<'py>>,
        options: fit::Options,
    ) -> PyResult<Bound<'py, PyDict>> {
        fit::fit(py, &self.0, method(py, settings)?, experiments, options)
    }
}
