//! Models.

mod about;
#[cfg(feature = "full")]
mod analyses;

use std::fmt;
use std::path::Path;
use std::sync::Arc;

use nalgebra::DMatrix;
use pendulum_codegen::program::Program;
use pendulum_core::StateLayout;
use pendulum_core::inputs::TimeTable;
use pendulum_core::shapes::Shape;
use pendulum_core::tape::{Given, Tape};

use self::about::About;
pub use self::about::{Component, Function, Quantity};
use crate::declaration::{Declaration, Robot};
use crate::engine::{self, Engine};
use crate::ensemble::{Ensemble, Members};
use crate::error::Error;
use crate::method::Method;
use crate::motion::{Motion, Stopped};
use crate::solve::Options;
use crate::worker;

/// Length of the states up to which a single motion needs no large stack.
const SHORT: usize = 16;

/// A mechanism with values of its parameters and inputs. Clones share everything.
#[derive(Clone)]
pub struct Model {
    about: Arc<About>,
    pub(crate) engine: Arc<dyn Engine>,
}

impl Model {
    /// Compiles a declaration whose parameters all have defaults. Files of robots are relative to the working
    /// directory.
    ///
    /// # Errors
    /// Those that `mechanism!` reports, with line, column and help; and [`Error::NoValue`].
    pub fn parse(text: &str) -> Result<Self, Error> {
        Self::parse_with(text, &[])
    }

    /// Compiles a declaration, with values of some parameters.
    ///
    /// # Errors
    /// See [`parse`](Self::parse).
    pub fn parse_with(text: &str, values: &[(&str, f64)]) -> Result<Self, Error> {
        Self::declared(&Declaration::new(text), values)
    }

    /// Compiles a declaration that needs more than its text, with values of some parameters.
    ///
    /// # Errors
    /// See [`parse`](Self::parse).
    pub fn declared(declaration: &Declaration, values: &[(&str, f64)]) -> Result<Self, Error> {
        Self::of(&declaration.program()?, values)
    }

    /// Compiles the robot of a URDF file, with gravity against z: see [`Robot`] for more.
    ///
    /// # Errors
    /// See [`parse`](Self::parse).
    pub fn urdf(path: impl AsRef<Path>) -> Result<Self, Error> {
        Self::robot(&Robot::new(path))
    }

    /// Compiles a robot.
    ///
    /// # Errors
    /// See [`parse`](Self::parse).
    pub fn robot(robot: &Robot) -> Result<Self, Error> {
        Self::parse(&robot.declaration())
    }

    fn of(program: &Program, values: &[(&str, f64)]) -> Result<Self, Error> {
        if program.routine("rhs").is_none() {
            let what = "a model".to_owned();
            return Err(Error::NotGenerated { what, word: "rhs" });
        }
        let text = pendulum_codegen::tape(program);
        let tape: Arc<Tape> = Arc::new(text.parse().expect("what is printed can be read"));
        let about = Arc::new(About::new(program, tape.clone()));
        let values = about.values(values, about.parameters.iter().map(|own| own.default).collect())?;
        let missing = values
            .iter()
            .zip(&about.parameters)
            .filter(|(value, _)| value.is_none());
        let missing: Vec<String> = missing.map(|(_, own)| own.name.clone()).collect();
        if !missing.is_empty() {
            return Err(Error::NoValue { parameters: missing });
        }
        let values: Vec<f64> = values.into_iter().flatten().collect();
        let engine = engine::build(&tape, &values)?;
        Ok(Self { about, engine })
    }

    /// Returns the model with other values of some parameters, in microseconds.
    ///
    /// # Errors
    /// If there is no such parameter, or if the values are impossible.
    pub fn with(&self, values: &[(&str, f64)]) -> Result<Self, Error> {
        let own = self.values().iter().map(|&value| Some(value)).collect();
        let values = self.about.values(values, own)?;
        self.with_values(&values.into_iter().flatten().collect::<Vec<_>>())
    }

    /// Returns the model with other values of all parameters, in the order of their declaration.
    ///
    /// # Errors
    /// See [`with`](Self::with).
    pub fn with_values(&self, values: &[f64]) -> Result<Self, Error> {
        Ok(self.with_engine(self.engine.with_params(values)?))
    }

    /// Returns the model with other values of some inputs, which are zero at first. They are constant in time.
    ///
    /// # Errors
    /// If there is no such input, or if a value is not finite.
    pub fn with_inputs(&self, values: &[(&str, f64)]) -> Result<Self, Error> {
        let (mut inputs, mut laws) = (self.inputs_now().to_vec(), self.engine.laws());
        for &(name, value) in values {
            let n = self.input(name)?;
            inputs[n] = value;
            laws.retain(|(own, _)| *own != n);
            if !value.is_finite() {
                return Err(Error::setting(name, format!("an input must be finite, not {value}")));
            }
        }
        Ok(self.with_engine(self.engine.with_inputs(&inputs, laws)))
    }

    /// Returns the model with some inputs that follow samples over time, such as recorded torques, until
    /// [`with_inputs`](Self::with_inputs) sets them to constants. All functions of the model use their values at the
    /// time in question.
    ///
    /// Methods with a tolerance shorten their steps at the jumps of held inputs and at the kinks of linear ones. Where
    /// samples are dense, `Rk4` with steps about as long as their intervals takes less time.
    ///
    /// ```
    /// use pendulum_runtime::{Method, Model, TimeTable};
    ///
    /// let model = Model::parse("pub Cart {
    ///     input push: N,
    ///     body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, torque: push }
    /// }")?;
    /// let push = TimeTable::linear(&[0.0, 1.0, 2.0], [&[0.0, 4.0, 0.0]])?;
    /// let pushed = model.with_laws(&[("push", push)])?;
    /// let motion = pushed.solve(&Method::new("Rk4")?.h(0.1), [0.0, 3.0], &[0.0, 0.0])?;
    /// assert!((motion.end().1[1] - 2.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If there is no such input.
    pub fn with_laws(&self, laws: &[(&str, TimeTable<1>)]) -> Result<Self, Error> {
        let mut all = self.engine.laws();
        let mut inputs = self.inputs_now().to_vec();
        for (name, law) in laws {
            let n = self.input(name)?;
            all.retain(|(own, _)| *own != n);
            all.push((n, law.clone()));
            inputs[n] = 0.0;
        }
        Ok(self.with_engine(self.engine.with_inputs(&inputs, all)))
    }

    /// Index of an input.
    pub(crate) fn input(&self, name: &str) -> Result<usize, Error> {
        Error::index_of("input", name, self.about.inputs.iter().map(|own| own.name.as_str()))
    }

    fn with_engine(&self, engine: Arc<dyn Engine>) -> Self {
        let about = self.about.clone();
        Self { about, engine }
    }

    /// Name of the mechanism.
    #[must_use]
    pub fn name(&self) -> &str {
        self.about.tape.name()
    }

    /// Comment above the declaration.
    #[must_use]
    pub fn docs(&self) -> &str {
        &self.about.docs
    }

    /// Parameters, in the order of their declaration.
    #[must_use]
    pub fn parameters(&self) -> &[Quantity] {
        &self.about.parameters
    }

    /// Values of the parameters.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        self.engine.params()
    }

    /// Inputs, in the order of their declaration.
    #[must_use]
    pub fn inputs(&self) -> &[Quantity] {
        &self.about.inputs
    }

    /// Values of the inputs; those that have [laws](Self::with_laws) do not count.
    #[must_use]
    pub fn inputs_now(&self) -> &[f64] {
        self.engine.inputs()
    }

    /// Inputs that follow samples, by name.
    #[must_use]
    pub fn laws(&self) -> Vec<(&str, TimeTable<1>)> {
        let named = |(n, law): (usize, _)| (self.about.inputs[n].name.as_str(), law);
        self.engine.laws().into_iter().map(named).collect()
    }

    /// Components of the state: coordinates, then their rates, then first-order states.
    #[must_use]
    pub fn components(&self) -> &[Component] {
        &self.about.components
    }

    /// Places of the coordinates and rates in the state.
    #[must_use]
    pub fn layout(&self) -> StateLayout<'_> {
        self.about.tape.layout()
    }

    /// Names of the components of all outputs.
    #[must_use]
    pub fn outputs(&self) -> &[&'static str] {
        self.about.tape.outputs()
    }

    /// Names of the events in the declaration.
    pub fn events(&self) -> impl ExactSizeIterator<Item = &str> {
        self.about.tape.events().iter().map(|(name, _)| *name)
    }

    /// Names of the constraints: joints with dry friction or stops, and walls.
    pub fn constraints(&self) -> impl ExactSizeIterator<Item = &str> {
        self.about.tape.constraints().iter().map(|constraint| constraint.name)
    }

    /// Functions that the declaration asks for.
    #[must_use]
    pub fn functions(&self) -> &[Function] {
        &self.about.functions
    }

    /// Repairs that `repair` made to the file of a robot.
    #[must_use]
    pub fn repaired(&self) -> &[String] {
        &self.about.repaired
    }

    /// Equations of motion as text, in the language of declarations.
    #[must_use]
    pub fn equations(&self) -> &str {
        &self.about.equations
    }

    /// Equations of motion in LaTeX, for display.
    #[must_use]
    pub fn latex(&self) -> &str {
        &self.about.latex
    }

    /// State with these components and zeros elsewhere; orientations without components are those of the declaration.
    ///
    /// # Errors
    /// If there is no such component.
    pub fn state(&self, values: &[(&str, f64)]) -> Result<Vec<f64>, Error> {
        let components = &self.about.components;
        let mut x = vec![0.0; components.len()];
        let layout = self.about.tape.layout();
        layout.quaternions().for_each(|places| x[places.start] = 1.0);
        for &(name, value) in values {
            let names = components.iter().map(|own| own.name.as_str());
            x[Error::index_of("component", name, names)?] = value;
        }
        Ok(x)
    }

    /// Derivative of the state.
    ///
    /// # Errors
    /// If the state has another length.
    pub fn rhs(&self, t: f64, x: &[f64]) -> Result<Vec<f64>, Error> {
        self.check_state(x)?;
        Ok(self.engine.rhs(t, x))
    }

    /// Derivative of the right-hand side by the state: a row for each rate, a column for each component.
    ///
    /// # Errors
    /// If the state has another length, or if `generate` does not have `jacobian`.
    pub fn jacobian(&self, t: f64, x: &[f64]) -> Result<DMatrix<f64>, Error> {
        self.check_state(x)?;
        self.needs("the Jacobian", "jacobian", "jacobian")?;
        Ok(self.engine.jacobian(t, x))
    }

    /// Kinetic and potential energy, in J.
    ///
    /// # Errors
    /// If the state has another length, or if `generate` does not have `energy`.
    pub fn energy(&self, t: f64, x: &[f64]) -> Result<[f64; 2], Error> {
        self.check_state(x)?;
        self.needs("the energy", "kinetic", "energy")?;
        Ok(self.engine.energy(t, x))
    }

    /// Components of all outputs, in the order of [`outputs`](Self::outputs).
    ///
    /// # Errors
    /// If the state has another length.
    pub fn outputs_at(&self, t: f64, x: &[f64]) -> Result<Vec<f64>, Error> {
        self.check_state(x)?;
        Ok(self.engine.outputs(t, x))
    }

    /// Evaluates a function, such as `mass_matrix`, with the lists that it takes beside the time and the state. Returns
    /// its results as matrices; vectors have one column, numbers one entry.
    ///
    /// # Errors
    /// If there is no such function, or if a list has another length.
    pub fn evaluate(&self, name: &str, t: f64, x: &[f64], lists: &[&[f64]]) -> Result<Vec<DMatrix<f64>>, Error> {
        self.check_state(x)?;
        let names = self.about.functions.iter().map(|function| function.name.as_str());
        let n = Error::index_of("function", name, names)?;
        let function = &self.about.functions[n];
        Error::check_length(
            &format!("the list of arguments of `{name}`"),
            lists.len(),
            function.arguments.len(),
        )?;
        let rates = self.about.tape.layout().rates();
        let mut given = Given::default();
        for (&what, &list) in function.arguments.iter().zip(lists) {
            let (place, needed) = match what {
                "accelerations" => (&mut given.accelerations, rates),
                "weights" => (&mut given.weights, x.len()),
                "direction" => (&mut given.direction, x.len() + self.about.inputs.len()),
                _ => (&mut given.forces, self.about.tape.constraints().len()),
            };
            Error::check_length(&format!("`{what}`"), list.len(), needed)?;
            *place = list;
        }
        let results = self.engine.evaluate(n, t, x, &given);
        Ok(about::matrices(&function.shapes, results))
    }

    /// Shapes for drawing.
    ///
    /// # Errors
    /// If the state has another length, or if `generate` does not have `shapes`.
    pub fn shapes(&self, t: f64, x: &[f64]) -> Result<Vec<Shape<'_>>, Error> {
        self.check_state(x)?;
        if !self.about.tape.has_shapes() {
            let what = "a drawing".to_owned();
            return Err(Error::NotGenerated { what, word: "shapes" });
        }
        Ok(self.engine.shapes(t, x))
    }

    /// Closes the loops of a state in which the dependent coordinates are guesses.
    ///
    /// # Errors
    /// If the state has another length, or if the loops do not close near it.
    pub fn assemble(&self, t: f64, x: &[f64]) -> Result<Vec<f64>, Error> {
        self.check_state(x)?;
        self.engine.assemble(t, x)
    }

    /// Integrates from the state `x0` over a span, which may run backward.
    ///
    /// # Errors
    /// If a setting or the state is invalid, or if the integration stops early; the error then has the motion so far.
    pub fn solve(&self, method: &Method, span: [f64; 2], x0: &[f64]) -> Result<Motion, Stopped> {
        self.solve_with(method, span, x0, &Options::default())
    }

    /// Integrates like [`solve`](Self::solve), with options.
    ///
    /// # Errors
    /// See [`solve`](Self::solve).
    pub fn solve_with(
        &self,
        method: &Method,
        span: [f64; 2],
        x0: &[f64],
        options: &Options<'_>,
    ) -> Result<Motion, Stopped> {
        self.check_state(x0)?;
        self.check_method(method)?;
        self.run(|| self.engine.solve(method, span, x0, options))
    }

    /// Integrates many trajectories on all processors, in lanes of vector registers. Their states are those of
    /// [`solve`](Self::solve), bit for bit.
    ///
    /// # Errors
    /// If a setting, a list or parameters are invalid. Trajectories that stop early are listed in the result.
    pub fn ensemble(&self, method: &Method, span: [f64; 2], members: &Members<'_>) -> Result<Ensemble, Error> {
        self.check_method(method)?;
        worker::on_all(|| self.engine.ensemble(method, span, members))
    }

    /// True if a single motion is integrated on the thread of the caller, since its state is short; others need a
    /// larger stack.
    #[must_use]
    pub fn is_short(&self) -> bool {
        self.components().len() <= SHORT
    }

    /// Runs work on a thread with a large stack, if the state needs it: a thread costs more than a short motion.
    pub(crate) fn run<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        if self.is_short() { work() } else { worker::run(work) }
    }

    pub(crate) fn check_state(&self, x: &[f64]) -> Result<(), Error> {
        Error::check_length("the state", x.len(), self.about.components.len())
    }

    /// Checks that the declaration asks for a routine.
    pub(crate) fn needs(&self, what: &str, routine: &str, word: &'static str) -> Result<(), Error> {
        let what = what.to_owned();
        let routine = self.about.tape.routine(routine);
        routine.map(|_| ()).ok_or(Error::NotGenerated { what, word })
    }

    pub(crate) fn check_method(&self, method: &Method) -> Result<(), Error> {
        method.check()?;
        let what = format!("the method `{}`", method.name());
        match method.word() {
            Some("taylor") if !self.about.tape.has_series() => Err(Error::NotGenerated { what, word: "taylor" }),
            Some(word) if word != "taylor" => self.needs(&what, word, word),
            _ => Ok(()),
        }
    }
}

impl fmt::Debug for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = self.about.parameters.iter().map(|own| &own.name);
        f.debug_struct("Model")
            .field("name", &self.name())
            .field("parameters", &names.zip(self.values()).collect::<Vec<_>>())
            .finish_non_exhaustive()
    }
}
