//! Controllers: a step of the model with held inputs, linear feedback, and iterative LQR.

mod error;
mod print;
mod weights;

pub use error::NoController;

use super::names::snake_case;
use super::{Scene, Sources, sources};
use crate::program::{Program, Role};

/// Controller as C: the model, a step of `Rk4` with held inputs, and if they are given, the laws of `LinearLaw` and
/// `Ilqr` of `pendulum_core::control`.
///
/// Weights and gains are numbers in the memory layout of nalgebra, column by column: pass `matrix.as_slice()`.
///
/// ```
/// use pendulum_codegen::{Controller, Ilqr};
///
/// let declaration = "pub Arm {
///     input motor: N m,
///     body rod on ground { mass: 1, com: [0, 1, 0], joint: revolute(z), coordinate: angle, torque: motor }
/// }";
/// let program = pendulum_codegen::program(declaration.parse()?)?;
/// let plan = Ilqr::new(0.02, 50, &[1.0, 0.0, 0.0, 0.1], &[0.1]);
/// let controller = Controller::new().limits(&[-2.0], &[2.0]).linear_law(&[3.0, 2.0], &[0.0; 2], &[0.0]).ilqr(plan);
/// let sources = controller.print(&program)?;
/// assert!(sources.header.contains("void arm_linear_law(const double x[2], arm_inputs *u);"));
/// let sources = controller.single().print(&program)?;
/// assert!(sources.header.contains("void arm_linear_law(const float x[2], arm_inputs *u);"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Controller {
    limits: Option<[Vec<f64>; 2]>,
    linear: Option<LinearLaw>,
    ilqr: Option<Ilqr>,
    is_single: bool,
}

/// The law `u0 - K (x - x0)`.
#[derive(Clone, Debug, PartialEq)]
struct LinearLaw {
    gain: Vec<f64>,
    x0: Vec<f64>,
    u0: Vec<f64>,
}

/// Iterative LQR with the cost `Quadratic`, as for `pendulum_core::control::Ilqr`.
#[derive(Clone, Debug, PartialEq)]
pub struct Ilqr {
    h: f64,
    steps: usize,
    q: Vec<f64>,
    r: Vec<f64>,
    end: Option<Vec<f64>>,
    goal: Option<[Vec<f64>; 2]>,
    start: Option<Vec<f64>>,
}

impl Ilqr {
    /// Plans of the given number of steps of length `h` in s, with the weights `Q` of the state, which are positive
    /// semidefinite, and `R` of the inputs, which are positive definite.
    pub fn new(h: f64, steps: usize, q: &[f64], r: &[f64]) -> Self {
        Self {
            h,
            steps,
            q: q.to_vec(),
            r: r.to_vec(),
            end: None,
            goal: None,
            start: None,
        }
    }

    /// Sets the weights `Qf` of the final state, which are positive semidefinite. Default: 0.
    #[must_use]
    pub fn end(mut self, weights: &[f64]) -> Self {
        self.end = Some(weights.to_vec());
        self
    }

    /// Sets the goal: a state, and the inputs that hold it. Default: 0.
    #[must_use]
    pub fn goal(mut self, x: &[f64], u: &[f64]) -> Self {
        self.goal = Some([x.to_vec(), u.to_vec()]);
        self
    }

    /// Sets the inputs of the first plan, step by step, such as `ilqr.inputs().as_flattened()` after a search in Rust.
    /// Default: 0.
    #[must_use]
    pub fn start_from(mut self, inputs: &[f64]) -> Self {
        self.start = Some(inputs.to_vec());
        self
    }
}

impl Controller {
    /// Creates a controller with a step of the model only.
    pub fn new() -> Self {
        Self::default()
    }

    /// Limits each input to the range from `low` to `high`, for all laws. Default: no limits.
    #[must_use]
    pub fn limits(mut self, low: &[f64], high: &[f64]) -> Self {
        self.limits = Some([low, high].map(<[f64]>::to_vec));
        self
    }

    /// Adds the law `u = u0 - K (x - x0)`, with the gain `K`: one row per input, stored column by column.
    #[must_use]
    pub fn linear_law(mut self, gain: &[f64], x0: &[f64], u0: &[f64]) -> Self {
        let [gain, x0, u0] = [gain, x0, u0].map(<[f64]>::to_vec);
        self.linear = Some(LinearLaw { gain, x0, u0 });
        self
    }

    /// Adds iterative LQR.
    #[must_use]
    pub fn ilqr(mut self, ilqr: Ilqr) -> Self {
        self.ilqr = Some(ilqr);
        self
    }

    /// Computes in single precision, `float`: all but the constants of the model, which are computed once, from its
    /// parameters.
    #[must_use]
    pub fn single(mut self) -> Self {
        self.is_single = true;
        self
    }

    pub(super) fn is_single(&self) -> bool {
        self.is_single
    }

    /// Prints a model and its controller as C99, without heap.
    ///
    /// Results equal those of Rust bit for bit on the conditions of [`c`](crate::c()), in single precision those of
    /// `model.cast::<f32>()`.
    ///
    /// # Errors
    /// [`NoController`] if the model or a number does not make a controller.
    pub fn print(&self, program: &Program) -> Result<Sources, NoController> {
        self.check(program)?;
        let scene = Scene::new(program, snake_case(&program.name));
        Ok(sources(Scene {
            controller: Some(self),
            ..scene
        }))
    }

    fn check(&self, program: &Program) -> Result<(), NoController> {
        if program.inputs.is_empty() {
            return Err(NoController::NoInputs);
        }
        if !program.constraints.is_empty() {
            let names = program.constraints.iter().map(|constraint| constraint.name.clone());
            return Err(NoController::SwitchesModes(names.collect()));
        }
        if program.with_role(Role::Rhs).is_none() {
            return Err(NoController::NoRightHandSide);
        }
        let (n, m) = (program.layout.len(), program.inputs.len());
        let limits = self.limits_of(m);
        for list in &limits {
            length("a list of limits", list, m)?;
        }
        for (input, name) in program.inputs.iter().map(|input| &input.name).enumerate() {
            let [low, high] = [0, 1].map(|side| limits[side][input]);
            let are_in_order = low <= high && low < f64::INFINITY && high > f64::NEG_INFINITY;
            if !are_in_order {
                let (input, limits) = (name.clone(), [low, high]);
                return Err(NoController::Limits { input, limits });
            }
        }
        if let Some(LinearLaw { gain, x0, u0 }) = &self.linear {
            self.finite("the gain", gain, n * m)?;
            self.finite("the state of the law", x0, n)?;
            self.finite("the inputs of the law", u0, m)?;
        }
        self.ilqr
            .as_ref()
            .map_or(Ok(()), |ilqr| self.check_ilqr(program, ilqr, &limits))
    }

    fn check_ilqr(&self, program: &Program, ilqr: &Ilqr, limits: &[Vec<f64>; 2]) -> Result<(), NoController> {
        if let Some(&open) = program.open_loops.first() {
            return Err(NoController::ClosedLoop(program.loops[open].clone()));
        }
        let h = if self.is_single {
            f64::from(ilqr.h as f32)
        } else {
            ilqr.h
        };
        if !(h.is_finite() && h > 0.0) {
            return Err(NoController::Step(ilqr.h));
        }
        if ilqr.steps == 0 {
            return Err(NoController::NoSteps);
        }
        let (n, m) = (program.layout.len(), program.inputs.len());
        let Weights { end, goal, start } = ilqr.weights(n, m);
        for (what, list, rows, strictly) in [
            ("Q", &ilqr.q, n, false),
            ("R", &ilqr.r, m, true),
            ("Qf", &end, n, false),
        ] {
            self.finite(what, list, rows * rows)?;
            weights::check(what, list, rows, strictly, self.is_single)?;
        }
        self.finite("the goal", &goal[0], n)?;
        self.finite("the inputs of the goal", &goal[1], m)?;
        self.finite("the first plan", &start, m * ilqr.steps)?;
        for (at, &value) in start.iter().enumerate() {
            let (step, input) = (at / m, at % m);
            let limits = [0, 1].map(|side| limits[side][input]);
            if !(limits[0] <= value && value <= limits[1]) {
                let input = program.inputs[input].name.clone();
                return Err(NoController::StartBeyondLimits {
                    input,
                    step,
                    value,
                    limits,
                });
            }
        }
        Ok(())
    }

    /// Checks the length of a list, and that its numbers are finite in the precision.
    fn finite(&self, what: &'static str, list: &[f64], expected: usize) -> Result<(), NoController> {
        length(what, list, expected)?;
        let most = if self.is_single { f64::from(f32::MAX) } else { f64::MAX };
        match list.iter().all(|number| number.abs() <= most) {
            true => Ok(()),
            false => Err(NoController::NotFinite { what }),
        }
    }

    fn limits_of(&self, inputs: usize) -> [Vec<f64>; 2] {
        let none = || [f64::NEG_INFINITY, f64::INFINITY].map(|limit| vec![limit; inputs]);
        self.limits.clone().unwrap_or_else(none)
    }
}

/// Settings with their defaults.
struct Weights {
    end: Vec<f64>,
    goal: [Vec<f64>; 2],
    start: Vec<f64>,
}

impl Ilqr {
    fn weights(&self, n: usize, m: usize) -> Weights {
        let zeros = |length| vec![0.0; length];
        Weights {
            end: self.end.clone().unwrap_or_else(|| zeros(n * n)),
            goal: self.goal.clone().unwrap_or_else(|| [zeros(n), zeros(m)]),
            start: self.start.clone().unwrap_or_else(|| zeros(m * self.steps)),
        }
    }
}

fn length(what: &'static str, list: &[f64], expected: usize) -> Result<(), NoController> {
    match list.len() {
        length if length == expected => Ok(()),
        length => Err(NoController::Length { what, length, expected }),
    }
}
