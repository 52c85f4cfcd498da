//! Models of a tape for given parameters.

use std::sync::Arc;

use nalgebra::SVector;

use super::code::{Code, Kept};
use super::error::ModelError;
use super::laws::Laws;
use super::source::{Lists, Source};
use super::{Condition, Routine, Tape};
use crate::error::ParameterError;
use crate::inputs::TimeTable;
use crate::real::Real;
use crate::real::lanes::Lanes;
use crate::system::{Cast, CastJacobian, Jacobian, Parametric};

/// Rounding error of a difference relative to its terms, below which a condition counts as met, as in generated code.
const ROUNDING: f64 = 1e-12;

/// Model of a [`Tape`] for given parameters, in the number type `T`; `N` is the length of its state.
///
/// It is a [`System`](crate::System) like a model that [`mechanism!`](crate::mechanism) generates, so that all methods
/// integrate it, in lanes as well. `HYBRID` is true if it may have dry friction, stops or walls: see [`HybridModel`].
/// It is [`Parametric`] in any number of parameters, from its own on: the others are zero and have no names.
///
/// # Panics
/// The functions of [`Jacobian`], [`Energy`](crate::Energy), [`Canonical`](crate::Canonical) and
/// [`TaylorSeries`](crate::TaylorSeries) panic if the `generate` of the declaration does not ask for them;
/// [`Tape::routine`] and [`Tape::has_series`] tell.
#[derive(Clone, Debug)]
pub struct Model<T, const N: usize, const HYBRID: bool = false> {
    pub(super) tape: Arc<Tape>,
    params: Arc<[f64]>,
    constants: Vec<T>,
    kept: Kept<T>,
    /// Index of the routine for each role, if the tape has it.
    places: [Option<usize>; Role::ALL.len()],
    /// Values of the inputs that are constant.
    inputs: Vec<T>,
    /// Laws of the others.
    laws: Option<Arc<Laws>>,
    /// Length of the state without padding.
    pub(super) active: usize,
}

/// [`Model`] of a mechanism that may have dry friction, stops or walls.
pub type HybridModel<T, const N: usize> = Model<T, N, true>;

/// Routines that the traits of a model call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    Rhs,
    Jacobian,
    TimeDerivative,
    InputJacobian,
    Kinetic,
    Potential,
    Outputs,
    LoopMargins,
    LoopGaps,
    LoopCorrections,
    TurnMargins,
    Measures,
    MeasureDerivatives,
    Response,
    ResponseDerivative,
    Canonical,
    CanonicalJacobian,
}

impl Role {
    /// All of them, in order, with their names and the words of `generate` that request them.
    const ALL: [(Self, &'static str, &'static str); 17] = [
        (Self::Rhs, "rhs", "rhs"),
        (Self::Jacobian, "jacobian", "jacobian"),
        (Self::TimeDerivative, "time_derivative", "jacobian"),
        (Self::InputJacobian, "input_jacobian", "jacobian"),
        (Self::Kinetic, "kinetic", "energy"),
        (Self::Potential, "potential", "energy"),
        (Self::Outputs, "outputs", "rhs"),
        (Self::LoopMargins, "loop_margins", "rhs"),
        (Self::LoopGaps, "loop_gaps", "rhs"),
        (Self::LoopCorrections, "loop_corrections", "rhs"),
        (Self::TurnMargins, "turn_margins", "rhs"),
        (Self::Measures, "measures", "rhs"),
        (Self::MeasureDerivatives, "measure_derivatives", "jacobian"),
        (Self::Response, "response", "rhs"),
        (Self::ResponseDerivative, "response_derivative", "jacobian"),
        (Self::Canonical, "canonical", "canonical"),
        (Self::CanonicalJacobian, "canonical_jacobian", "canonical"),
    ];

    /// Number of results.
    fn results(self, tape: &Tape) -> usize {
        let (length, constraints) = (tape.length(), tape.constraints.len());
        let of_response = (1 + constraints) * length + constraints + constraints * (constraints + 1) / 2;
        match self {
            Self::Rhs | Self::TimeDerivative => length,
            Self::Jacobian => length + length * length,
            Self::InputJacobian => length * tape.inputs.len(),
            Self::Kinetic | Self::Potential => 1,
            Self::Outputs => tape.outputs.len(),
            Self::LoopMargins => 2 * tape.loops.len(),
            Self::LoopGaps => 3 * tape.open_loops.len(),
            Self::LoopCorrections => tape.dependents().count(),
            Self::TurnMargins => 2 * tape.uncounted.len(),
            Self::Measures => 2 * constraints,
            Self::MeasureDerivatives => 2 * constraints * (length + 1),
            Self::Response => of_response,
            Self::ResponseDerivative => of_response + (length + 1) * (length + constraints),
            Self::Canonical => 2 * length,
            Self::CanonicalJacobian => 2 * length * length,
        }
    }

    /// True if the routine may have this argument.
    fn takes(self, argument: Source) -> bool {
        match argument {
            Source::Input => true,
            Source::Force => matches!(
                self,
                Self::Rhs
                    | Self::Jacobian
                    | Self::TimeDerivative
                    | Self::Response
                    | Self::ResponseDerivative
                    | Self::Canonical
                    | Self::CanonicalJacobian
            ),
            _ => false,
        }
    }
}

/// Arguments of a routine beside time and state. Those that the routine does not have may stay empty.
#[derive(Clone, Copy, Debug)]
pub struct Given<'a, T> {
    /// Inputs; empty for those of the model.
    pub inputs: &'a [T],
    /// Forces along the constraints, in N or N m.
    pub forces: &'a [T],
    /// Accelerations of the coordinates.
    pub accelerations: &'a [T],
    /// Weights of the components of the right-hand side.
    pub weights: &'a [T],
    /// Direction of the state, followed by one of the inputs.
    pub direction: &'a [T],
}

impl<T> Default for Given<'_, T> {
    fn default() -> Self {
        Self {
            inputs: &[],
            forces: &[],
            accelerations: &[],
            weights: &[],
            direction: &[],
        }
    }
}

impl Tape {
    /// Builds a model: checks the parameters, and computes the constants that depend on them.
    ///
    /// # Errors
    /// If the length of the state is not `N`, if there are more or fewer parameters, if one of them, or a combination,
    /// is impossible for a rigid body, if routines that the motion takes are missing or have other arguments or results
    /// than their names demand, or if the mechanism has dry friction, stops or walls and no [`HybridModel`] is
    /// requested.
    pub fn model<const N: usize, const HYBRID: bool>(
        self: &Arc<Self>,
        params: &[f64],
    ) -> Result<Model<f64, N, HYBRID>, ModelError> {
        match self.length() {
            length if length != N => Err(ModelError::State { given: N, length }),
            _ => self.padded(params),
        }
    }

    /// Builds a model whose state may have more components than the mechanism: those at the end are padding, so that
    /// few lengths `N` serve all mechanisms. See [`System::active`](crate::System::active).
    ///
    /// # Errors
    /// Those of [`model`](Self::model); the state may be longer than the mechanism needs, not shorter.
    pub fn padded<const N: usize, const HYBRID: bool>(
        self: &Arc<Self>,
        params: &[f64],
    ) -> Result<Model<f64, N, HYBRID>, ModelError> {
        let length = self.length();
        if length > N {
            return Err(ModelError::State { given: N, length });
        }
        if !HYBRID && !self.constraints.is_empty() {
            return Err(ModelError::Hybrid);
        }
        Ok(Model {
            tape: self.clone(),
            params: params.into(),
            constants: self.checked_constants(params)?,
            kept: Kept::of(0),
            places: self.places()?,
            inputs: vec![0.0; self.inputs.len()],
            laws: None,
            active: length,
        })
    }

    /// Index of the routine for each role.
    fn places(&self) -> Result<[Option<usize>; Role::ALL.len()], ModelError> {
        let mut places = [None; Role::ALL.len()];
        for ((role, name, _), place) in Role::ALL.into_iter().zip(&mut places) {
            let named = |(_, routine): &(usize, &Routine)| routine.name == name;
            let Some((n, routine)) = self.routines.iter().enumerate().find(named) else {
                continue;
            };
            let takes_more = routine.arguments.iter().any(|&argument| !role.takes(argument));
            if routine.results() != role.results(self) || takes_more {
                return Err(ModelError::Shape { name: name.to_owned() });
            }
            *place = Some(n);
        }
        let needed = [Role::Rhs, Role::Measures, Role::Response];
        let needed = &needed[..if self.constraints.is_empty() { 1 } else { 3 }];
        match needed.iter().find(|&&role| places[role as usize].is_none()) {
            Some(&role) => Err(ModelError::Missing {
                name: Role::ALL[role as usize].1.to_owned(),
            }),
            None => Ok(places),
        }
    }

    /// Constants of the model, after the checks of its parameters.
    fn checked_constants(&self, params: &[f64]) -> Result<Vec<f64>, ModelError> {
        if params.len() != self.parameters.len() {
            return Err(ModelError::Parameters {
                given: params.len(),
                names: self
                    .parameters
                    .iter()
                    .map(|parameter| parameter.name.to_owned())
                    .collect(),
            });
        }
        let names = self.parameters.iter().map(|parameter| parameter.name);
        let named: Vec<(&'static str, f64)> = names.zip(params.iter().copied()).collect();
        let error =
            |name, value, rule, given: &[_]| Err(ModelError::Parameter(ParameterError::new(name, value, rule, given)));
        if let Some(&(name, value)) = named.iter().find(|(_, value)| !value.is_finite()) {
            return error(name, value, "a parameter must be finite", &[]);
        }
        let checked = compute(&self.checked, params);
        for rule in &self.rules {
            let value = checked[rule.values[0]];
            let holds = match rule.condition {
                Condition::Positive => value > 0.0,
                Condition::NonNegative => value >= 0.0,
                Condition::NonNegativeWithin => value >= -ROUNDING * checked[rule.values[1]].abs(),
            };
            if !holds {
                let given: Vec<_> = rule.parameters.iter().map(|&n| named[n]).collect();
                return error(rule.name, value, rule.text, &given);
            }
        }
        let constants = compute(&self.constants, params);
        let rule = "a constant of the equations is not finite: a coordinate has no inertia, a divisor is zero, or a \
                    number is too large";
        match self
            .constants_text
            .iter()
            .zip(&constants)
            .find(|(_, value)| !value.is_finite())
        {
            Some((text, &value)) => error(text, value, rule, &named),
            None => Ok(constants),
        }
    }
}

/// Receiver of results, as of [`Code::each`], that writes them to places, one after the other.
pub(super) fn into_places<'r, T: 'r>(mut places: impl Iterator<Item = &'r mut T>) -> impl FnMut(usize, T) {
    move |_, value| {
        if let Some(place) = places.next() {
            *place = value;
        }
    }
}

/// Results of code that reads parameters only.
fn compute<T: Real>(code: &Code, params: &[T]) -> Vec<T> {
    let others = [(Source::Parameter, params)];
    let lists = Lists::new().and(&others);
    let mut results = vec![T::default(); code.results.len()];
    code.run(&[], &lists, &mut [&mut results]);
    results
}

impl<T: Real, const N: usize, const HYBRID: bool> Model<T, N, HYBRID> {
    /// The tape.
    #[must_use]
    pub fn tape(&self) -> &Tape {
        &self.tape
    }

    /// Parameters, in the order of their declaration.
    #[must_use]
    pub fn params(&self) -> &[f64] {
        &self.params
    }

    /// Values of the inputs, which are zero at first; those that have [laws](Self::input_laws) do not count.
    #[must_use]
    pub fn inputs(&self) -> &[T] {
        &self.inputs
    }

    /// Sets the inputs to values that the equations of motion use from now on, unless they have
    /// [laws](Self::input_laws).
    ///
    /// # Panics
    /// If there are more or fewer values than inputs.
    pub fn set_inputs(&mut self, inputs: &[T]) {
        self.inputs.copy_from_slice(inputs);
    }

    /// Inputs that follow samples, by their indices; none at first. In lanes, those of the first lane.
    pub fn input_laws(&self) -> impl Iterator<Item = (usize, &TimeTable<1>)> {
        self.laws.iter().flat_map(|laws| laws.each())
    }

    /// Inputs that have laws, in ascending order.
    fn driven(&self) -> &[usize] {
        self.laws.as_ref().map_or(&[], |laws| &laws.inputs)
    }

    /// Index of the routine for a role, if the tape has it.
    #[inline(always)]
    pub(super) fn place(&self, role: Role) -> Option<usize> {
        self.places[role as usize]
    }

    /// Index of the routine for a role that the caller needs.
    #[inline(always)]
    pub(super) fn needed(&self, role: Role) -> usize {
        #[cold]
        fn missing(tape: &Tape, role: Role) -> ! {
            let (_, name, word) = Role::ALL[role as usize];
            panic!(
                "the tape of `{}` has no routine `{name}`: add `{word}` to its `generate`",
                tape.name
            )
        }
        self.place(role).unwrap_or_else(|| missing(&self.tape, role))
    }

    /// Evaluates a routine of the tape, given by its index there, into `results`, which follow one another.
    ///
    /// # Panics
    /// If there is no such routine, or if one of its arguments is too short.
    pub fn evaluate(&self, routine: usize, t: T, x: &SVector<T, N>, given: &Given<'_, T>, results: &mut [T]) {
        let others = [
            (Source::Acceleration, given.accelerations),
            (Source::Weight, given.weights),
            (Source::Direction, given.direction),
        ];
        let mut lists = self.lists(&t, x, given.forces).and(&others);
        if !given.inputs.is_empty() {
            lists = lists.with(Source::Input, given.inputs).following(None);
        }
        self.evaluate_into(routine, &lists, &mut [results]);
    }

    /// Lists that a routine reads, with the inputs of the model, under forces along the constraints.
    #[inline(always)]
    pub(super) fn lists<'a>(&'a self, t: &'a T, x: &'a SVector<T, N>, forces: &'a [T]) -> Lists<'a, T> {
        Lists::new()
            .with(Source::Time, core::slice::from_ref(t))
            .with(Source::State, x.as_slice())
            .with(Source::Input, &self.inputs)
            .with(Source::Force, forces)
            .following(self.laws.as_deref())
    }

    /// Like [`evaluate`](Self::evaluate) with these lists, but fills one slice after the other with the results.
    #[inline]
    pub(super) fn evaluate_into(&self, routine: usize, lists: &Lists<'_, T>, results: &mut [&mut [T]]) {
        let code = &self.tape.routines[routine].code;
        if const { T::LANES > 1 }
            && let Some(mut registers) = self.kept.registers(routine)
        {
            return code.run_again(&mut registers, &self.constants, lists, results);
        }
        code.run(&self.constants, lists, results);
    }

    /// Like [`evaluate_into`](Self::evaluate_into), on registers that the caller keeps for this routine.
    pub(super) fn evaluate_with(
        &self,
        registers: &mut Vec<T>,
        routine: usize,
        t: T,
        x: &SVector<T, N>,
        results: &mut [&mut [T]],
    ) {
        let code = &self.tape.routines[routine].code;
        code.run_again(registers, &self.constants, &self.lists(&t, x, &[]), results);
    }

    /// Like [`evaluate`](Self::evaluate) with these lists, but passes each result on, with its number.
    pub(super) fn each(&self, routine: usize, lists: &Lists<'_, T>, pass: &mut dyn FnMut(usize, T)) {
        let code = &self.tape.routines[routine].code;
        if const { T::LANES > 1 }
            && let Some(mut registers) = self.kept.registers(routine)
        {
            code.run_again(&mut registers, &self.constants, lists, &mut []);
            return code.pass(&registers, pass);
        }
        code.each(&self.constants, lists, pass);
    }

    /// Rates of the inputs that have laws, each with the derivatives of the right-hand side by the input.
    pub(super) fn input_rates(&self, t: T, x: &SVector<T, N>) -> impl Iterator<Item = (T, SVector<T, N>)> {
        let rates = self.laws.iter().flat_map(move |laws| laws.rates(t));
        rates.map(move |(input, rate)| {
            let mut column = SVector::from([T::default(); N]);
            self.each(
                self.needed(Role::InputJacobian),
                &self.lists(&t, x, &[]),
                &mut |n, value| {
                    if n / self.active == input {
                        column[n % self.active] = value;
                    }
                },
            );
            (rate, column)
        })
    }

    /// Writes the results of a code to places, one after the other.
    pub(super) fn write<'r>(&self, code: &Code, lists: &Lists<'_, T>, places: impl Iterator<Item = &'r mut T>)
    where
        T: 'r,
    {
        code.each(&self.constants, lists, &mut into_places(places));
    }

    /// The model as one without mode switches, whose ensembles are faster; `None` if it has dry friction, stops or
    /// walls.
    #[must_use]
    pub fn smooth(&self) -> Option<Model<T, N>> {
        let is_smooth = self.tape.constraints.is_empty();
        is_smooth.then(|| Model {
            tape: self.tape.clone(),
            params: self.params.clone(),
            constants: self.constants.clone(),
            kept: self.kept.clone(),
            places: self.places,
            inputs: self.inputs.clone(),
            laws: self.laws.clone(),
            active: self.active,
        })
    }

    /// Model with these constants and inputs, and the same laws.
    fn with_numbers<U: Real>(&self, constants: Vec<U>, inputs: Vec<U>) -> Model<U, N, HYBRID> {
        Model {
            tape: self.tape.clone(),
            params: self.params.clone(),
            constants,
            kept: Kept::of(if U::LANES > 1 { self.tape.routines.len() } else { 0 }),
            places: self.places,
            inputs,
            laws: self.laws.clone(),
            active: self.active,
        }
    }
}

impl<const N: usize, const HYBRID: bool> Model<f64, N, HYBRID> {
    /// Lets the inputs of these indices follow samples from now on, and no others.
    ///
    /// Results have the bits of generated code under a [`TimeTable`] of all inputs.
    ///
    /// # Panics
    /// If there is no such input, or if one is given twice.
    pub fn set_laws(&mut self, laws: Vec<(usize, TimeTable<1>)>) {
        self.laws = Laws::new(laws);
        let (driven, count) = (self.driven(), self.inputs.len());
        let fits = driven.is_sorted_by(|a, b| a < b) && driven.iter().all(|&input| input < count);
        assert!(fits, "laws of the inputs {driven:?} of {count}");
    }

    /// Returns the model with other parameters, and the same inputs.
    ///
    /// # Errors
    /// See [`Tape::model`].
    pub fn with_params(&self, params: &[f64]) -> Result<Self, ModelError> {
        Ok(Self {
            inputs: self.inputs.clone(),
            laws: self.laws.clone(),
            ..self.tape.padded(params)?
        })
    }
}

impl<const N: usize, const HYBRID: bool> Cast<N> for Model<f64, N, HYBRID> {
    const HYBRID: bool = HYBRID;
    const WIDE: bool = true;

    type In<T: Real> = Model<T, N, HYBRID>;

    fn cast<T: Real>(&self) -> Model<T, N, HYBRID> {
        let [constants, inputs] =
            [&self.constants, &self.inputs].map(|numbers| numbers.iter().map(|&number| T::from_f64(number)).collect());
        self.with_numbers(constants, inputs)
    }

    fn gather<'m, V: Lanes>(models: impl Fn(usize) -> &'m Self) -> Model<V, N, HYBRID>
    where
        Self: 'm,
    {
        let first = models(0);
        let gathered = |numbers: fn(&Self) -> &[f64]| {
            let lanes = |k| V::from_fn(|lane| <V::Scalar as Real>::from_f64(numbers(models(lane))[k]));
            (0..numbers(first).len()).map(lanes).collect()
        };
        Model {
            laws: Laws::gather(V::LANES, |lane| models(lane).laws.as_ref()),
            ..first.with_numbers(gathered(|model| &model.constants), gathered(|model| &model.inputs))
        }
    }

    fn shares_lanes(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.tape, &other.tape) && self.driven() == other.driven()
    }
}

/// # Panics
/// If there are more parameters than `P`.
impl<const N: usize, const P: usize, const HYBRID: bool> Parametric<N, P> for Model<f64, N, HYBRID> {
    fn parameters(&self) -> [f64; P] {
        let mut parameters = [0.0; P];
        parameters[..self.params.len()].copy_from_slice(&self.params);
        parameters
    }

    fn parameter_names(&self) -> [&str; P] {
        let mut names = [""; P];
        for (name, parameter) in names[..self.params.len()].iter_mut().zip(&self.tape.parameters) {
            *name = parameter.name;
        }
        names
    }

    fn check_parameters(&self, parameters: &[f64; P]) -> Result<(), ParameterError> {
        match self.tape.checked_constants(&parameters[..self.params.len()]) {
            Err(ModelError::Parameter(error)) => Err(error),
            _ => Ok(()),
        }
    }

    fn with_parameters<T: Real>(&self, parameters: [T; P]) -> Model<T, N, HYBRID> {
        let constants = compute(&self.tape.constants, &parameters[..self.params.len()]);
        let inputs = self.inputs.iter().map(|&input| T::from_f64(input)).collect();
        self.with_numbers(constants, inputs)
    }

    fn differs_in_parameters(&self, other: &Self) -> bool {
        self.inputs == other.inputs && self.input_laws().eq(other.input_laws())
    }
}

impl<const N: usize, const HYBRID: bool> CastJacobian<N> for Model<f64, N, HYBRID> {
    #[inline]
    fn with_jacobian<T: Real>(model: &Model<T, N, HYBRID>) -> &impl Jacobian<T, N> {
        model
    }
}

impl Routine {
    /// Number of results.
    #[must_use]
    pub fn results(&self) -> usize {
        self.code.results.len()
    }
}
