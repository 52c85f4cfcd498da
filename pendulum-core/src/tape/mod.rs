//! Models without a compiler: programs as lists of operations, and the loop that runs them.
//!
//! The function `tape` of the crate [`pendulum-codegen`](https://docs.rs/pendulum-codegen) prints a declaration as a
//! tape, which is text. A [`Tape`] is parsed from it, and makes a [`Model`] for given parameters. Results have the bits
//! of the code that [`mechanism!`](crate::mechanism) generates; an evaluation takes some four times as long.
//!
//! ```
//! use std::sync::Arc;
//!
//! use pendulum_core::prelude::*;
//! use pendulum_core::tape::{Model, Tape};
//!
//! // the pendulum `theta'' = -g/l sin(theta)`; fields are separated by tabs
//! let text = "pendulum tape\t1
//! name\tPendulum
//! parameter\tl\tm\t0.5
//! parameter\tg\tm/s^2\t9.81
//! slot\ttheta\tangle\t0 1\t1 2\tperiodic
//! autonomous
//! open_loops\t
//! constant\t-g/l
//! code\tchecked
//! registers\t0
//! result\t
//! code\tconstants
//! registers\t3
//! read\tparameter\t0 1
//! div\t2 1 0
//! neg\t2 2
//! result\t2
//! code\tlaws
//! registers\t0
//! result\t
//! routine\trhs\t\tvector 2
//! registers\t5
//! read\tstate\t0 1
//! read\tconstant\t0
//! sin_cos\t3 4 0
//! mul\t3 2 3
//! result\t1 3
//! ";
//! let tape: Arc<Tape> = Arc::new(text.parse()?);
//! let model: Model<f64, 2> = tape.model(&[0.5, 9.81])?;
//! let end = Rk4::new(0.01).stepper(&model, 0.0, 1.0, [0.1, 0.0])?.run()?;
//! assert!((end[0] + 0.028).abs() < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod chain;
mod code;
mod error;
mod intern;
mod laws;
mod model;
mod plant;
mod read;
mod row;
mod series;
mod source;
mod system;

pub use error::{ModelError, TapeError};
pub use model::{Given, HybridModel, Model};
pub use series::Workspace;

use crate::constraint::Constraint;
use crate::layout::{Slot, StateLayout, StateVariable};
use crate::shapes::Outline;
use code::Code;
use source::Source;

/// Program of a mechanism, parsed from its text.
///
/// The names in it stay in memory until the end of the program, once for all tapes that share them.
#[derive(Clone, Debug, PartialEq)]
pub struct Tape {
    name: String,
    parameters: Vec<Quantity>,
    inputs: Vec<Quantity>,
    slots: Vec<Slot<'static>>,
    /// First components of the quaternion and of the angular velocity of each orientation.
    orientations: Vec<[usize; 2]>,
    states: Vec<StateVariable<'static>>,
    autonomous: bool,
    /// Bodies that close each loop.
    loops: Vec<[&'static str; 2]>,
    open_loops: Vec<usize>,
    /// Names of the angles whose turns are not counted although forces depend on them.
    uncounted: Vec<&'static str>,
    outputs: Vec<&'static str>,
    /// Names of the events, and if they are kinks.
    events: Vec<(&'static str, bool)>,
    constraints: Vec<Constraint<'static>>,
    /// Which of the two limits each constraint has.
    limits: Vec<[bool; 2]>,
    rules: Vec<Rule>,
    constants_text: Vec<&'static str>,
    checked: Code,
    constants: Code,
    laws: Code,
    routines: Vec<Routine>,
    series: Option<Series>,
    outlines: Vec<Outline<'static>>,
    /// Points and radii of the outlines; `None` if the declaration asks for no shapes.
    drawing: Option<Code>,
}

/// Parameter or input.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Name.
    pub name: &'static str,
    /// Unit, as written in the declaration.
    pub unit: String,
    /// Default value of a parameter.
    pub default: Option<f64>,
}

/// Condition on the parameters.
#[derive(Clone, Debug, PartialEq)]
struct Rule {
    condition: Condition,
    /// Checked value, then its scale for [`Condition::NonNegativeWithin`].
    values: Vec<usize>,
    /// Text of the parameter, or of the expression of parameters.
    name: &'static str,
    text: &'static str,
    /// Parameters in the expression.
    parameters: Vec<usize>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Condition {
    Positive,
    NonNegative,
    /// Zero or above, up to the rounding error of a difference of numbers as large as another value.
    NonNegativeWithin,
}

/// Function of time, state and arguments.
#[derive(Clone, Debug, PartialEq)]
pub struct Routine {
    name: String,
    /// Arguments beside time and state.
    arguments: Vec<Source>,
    shapes: Vec<Shape>,
    code: Code,
}

/// Shape of a result. Entries of a matrix are in column-major order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Single number.
    Scalar,
    /// Vector of this length.
    Vector(usize),
    /// Matrix of this many rows and columns.
    Matrix(usize, usize),
    /// Symmetric matrix of this many rows, as its upper triangle, row by row.
    Symmetric(usize),
}

/// Power series of the motion: order 0 from the state, then each order from lower ones.
#[derive(Clone, Debug, PartialEq)]
struct Series {
    products: usize,
    kept: usize,
    /// Order 0: the right-hand side, then the kept values.
    start: Code,
    /// Each order, before the forces along the constraints are known: the second derivatives of the constraints
    /// without them, then values for `order`.
    before: Code,
    /// Each order: the right-hand side, then the left and the right factors of all products.
    order: Code,
}

impl Tape {
    /// Name of the mechanism.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Parameters, in the order of their declaration.
    #[must_use]
    pub fn parameters(&self) -> &[Quantity] {
        &self.parameters
    }

    /// Inputs, in the order of their declaration.
    #[must_use]
    pub fn inputs(&self) -> &[Quantity] {
        &self.inputs
    }

    /// Length of the state.
    #[must_use]
    pub fn length(&self) -> usize {
        self.layout().length()
    }

    /// Layout of the state.
    #[must_use]
    pub fn layout(&self) -> StateLayout<'_> {
        let layout = StateLayout::new(&self.slots).with_states(&self.states);
        if self.autonomous { layout.autonomous() } else { layout }
    }

    /// Indices of the dependent coordinates in the state, which have no rates there.
    fn dependents(&self) -> impl Iterator<Item = usize> {
        let slots = self.slots.iter().filter(|slot| slot.rates.is_empty());
        slots.map(|slot| slot.positions.start)
    }

    /// Names of the components of all outputs.
    #[must_use]
    pub fn outputs(&self) -> &[&'static str] {
        &self.outputs
    }

    /// True if the tape has power series of the motion.
    #[must_use]
    pub fn has_series(&self) -> bool {
        self.series.is_some()
    }

    /// True if the tape has shapes of the mechanism.
    #[must_use]
    pub fn has_shapes(&self) -> bool {
        self.drawing.is_some()
    }

    /// Names of the events, each of which is zero where the routine of its name is, and whether the motion has a kink
    /// there.
    #[must_use]
    pub fn events(&self) -> &[(&'static str, bool)] {
        &self.events
    }

    /// Constraints: dry friction and stops of joints, and walls.
    #[must_use]
    pub fn constraints(&self) -> &[Constraint<'static>] {
        &self.constraints
    }

    /// Routines, each a function of time, state and arguments.
    #[must_use]
    pub fn routines(&self) -> &[Routine] {
        &self.routines
    }

    /// Routine of this name.
    #[must_use]
    pub fn routine(&self, name: &str) -> Option<&Routine> {
        self.routines.iter().find(|routine| routine.name == name)
    }
}

impl Routine {
    /// Name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Shapes of the results, which follow one another.
    #[must_use]
    pub fn shapes(&self) -> &[Shape] {
        &self.shapes
    }

    /// Number of operations, where those that are joined count once: a sum with a product, two such sums of which only
    /// the second reads the first, sines and cosines of two angles.
    #[must_use]
    pub fn operations(&self) -> usize {
        self.code.len()
    }

    /// Number of registers.
    #[must_use]
    pub fn registers(&self) -> usize {
        self.code.registers
    }
}

impl Shape {
    /// Number of entries; `None` if it exceeds `usize`.
    fn len(self) -> Option<usize> {
        match self {
            Self::Scalar => Some(1),
            Self::Vector(n) => Some(n),
            Self::Matrix(n, m) => n.checked_mul(m),
            Self::Symmetric(n) => Some(n.checked_mul(n.checked_add(1)?)? / 2),
        }
    }
}
