//! Descriptions of models.

use std::sync::Arc;

use nalgebra::DMatrix;
use pendulum_codegen::program::{self, Program};
use pendulum_core::SlotKind;
use pendulum_core::tape::{Shape as ResultShape, Tape};

use crate::error::Error;

/// Parts that do not depend on the values of parameters.
pub(super) struct About {
    pub(super) tape: Arc<Tape>,
    pub(super) docs: String,
    pub(super) parameters: Vec<Quantity>,
    pub(super) inputs: Vec<Quantity>,
    pub(super) components: Vec<Component>,
    pub(super) functions: Vec<Function>,
    pub(super) equations: String,
    pub(super) latex: String,
    /// Repairs of the file of a robot.
    pub(super) repaired: Vec<String>,
}

/// A parameter or an input.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Quantity {
    /// Name.
    pub name: String,
    /// Unit, as in the declaration.
    pub unit: String,
    /// Default value of a parameter.
    pub default: Option<f64>,
    /// Comment in the declaration.
    pub docs: String,
}

/// A component of the state.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Component {
    /// Name, such as `theta` or `dot(theta)`.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// True if it is an angle with the period 2 pi.
    pub periodic: bool,
}

/// A function that the declaration asks for.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Function {
    /// Name.
    pub name: String,
    /// Its result, in words.
    pub docs: String,
    /// Lists that it takes beside the time and the state: `accelerations`, `weights`, `direction` or `forces`.
    pub arguments: Vec<&'static str>,
    /// Shapes of the results.
    pub shapes: Vec<ResultShape>,
    /// Form of the code, such as `recursion, L^T D L`.
    pub form: String,
    /// Numbers of additions, multiplications, divisions, sines with cosines, and other functions.
    pub operations: [usize; 5],
}

impl About {
    pub(super) fn new(program: &Program, tape: Arc<Tape>) -> Self {
        let quantity = |own: &program::Quantity| Quantity {
            name: own.name.clone(),
            unit: own.unit.clone(),
            default: own.default,
            docs: text(&own.docs),
        };
        Self {
            docs: text(&program.docs),
            parameters: program.parameters.iter().map(quantity).collect(),
            inputs: program.inputs.iter().map(quantity).collect(),
            components: components(&tape),
            functions: program.routines.iter().zip(tape.routines()).map(function).collect(),
            equations: program.equations.to_string(),
            latex: program.equations.latex(),
            repaired: program.repaired.clone(),
            tape,
        }
    }

    /// Values of the parameters, some of which are given by name.
    pub(super) fn values(&self, given: &[(&str, f64)], own: Vec<Option<f64>>) -> Result<Vec<Option<f64>>, Error> {
        let mut values = own;
        for &(name, value) in given {
            let names = self.parameters.iter().map(|own| own.name.as_str());
            values[Error::index_of("parameter", name, names)?] = Some(value);
        }
        Ok(values)
    }
}

/// A comment without the spaces before its lines.
fn text(docs: &[String]) -> String {
    let lines: Vec<&str> = docs.iter().map(|line| line.trim()).collect();
    lines.join("\n")
}

fn components(tape: &Tape) -> Vec<Component> {
    let layout = tape.layout();
    let mut components: Vec<Component> = layout
        .components()
        .into_iter()
        .map(|name| Component {
            name,
            unit: String::new(),
            periodic: false,
        })
        .collect();
    for slot in layout.slots {
        for n in slot.positions.clone() {
            components[n].unit = slot.unit().to_owned();
            components[n].periodic = slot.periodic && slot.kind == SlotKind::Angle;
        }
        for n in slot.rates.clone() {
            components[n].unit = slot.rate_unit().to_owned();
        }
    }
    for state in layout.states {
        components[state.index].unit = state.unit.to_owned();
    }
    components
}

fn function((routine, of_tape): (&program::Routine, &pendulum_core::tape::Routine)) -> Function {
    let arguments = routine.arguments.iter().filter_map(|argument| match argument {
        program::Argument::Inputs => None,
        program::Argument::Accelerations => Some("accelerations"),
        program::Argument::Forces => Some("forces"),
        program::Argument::Weights => Some("weights"),
        program::Argument::Direction => Some("direction"),
    });
    let operations = &routine.cost.operations;
    Function {
        name: routine.name.clone(),
        docs: routine.doc.clone(),
        arguments: arguments.collect(),
        shapes: of_tape.shapes().to_vec(),
        form: routine.cost.form.clone(),
        operations: [
            operations.additions,
            operations.multiplications,
            operations.divisions,
            operations.sincos,
            operations.functions,
        ],
    }
}

/// Results of a function, one after the other, as matrices of these shapes.
pub(super) fn matrices(shapes: &[ResultShape], results: Vec<f64>) -> Vec<DMatrix<f64>> {
    let mut rest = results.into_iter();
    let mut next = |length| rest.by_ref().take(length).collect::<Vec<f64>>();
    let matrix = |shape: &ResultShape| match *shape {
        ResultShape::Scalar => DMatrix::from_vec(1, 1, next(1)),
        ResultShape::Vector(length) => DMatrix::from_vec(length, 1, next(length)),
        ResultShape::Matrix(rows, columns) => DMatrix::from_vec(rows, columns, next(rows * columns)),
        ResultShape::Symmetric(rows) => {
            let triangle = next(rows * (rows + 1) / 2);
            let place = |i: usize, j: usize| i * (2 * rows - i - 1) / 2 + j;
            DMatrix::from_fn(rows, rows, |i, j| triangle[place(i.min(j), i.max(j))])
        }
    };
    shapes.iter().map(matrix).collect()
}
