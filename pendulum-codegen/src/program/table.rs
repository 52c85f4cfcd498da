//! The one table of all routines that can be generated.

use std::collections::BTreeSet;

use super::routine::{Argument, Head, Role, Shape};
use crate::form::{self, Chosen, Forms};
use crate::model::Model;

/// A length that depends on the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Length {
    /// The components of the state.
    State,
    /// The degrees of freedom.
    Freedom,
    /// The inputs.
    Inputs,
    /// The parameters.
    Parameters,
    /// The joints that are driven.
    Drives,
    /// The constraints.
    Constraints,
    /// The closed loops.
    Loops,
    /// The closed loops that have no closed form.
    Gaps,
    /// The angles whose turns forces take, and are not counted.
    Uncounted,
    /// The dependent coordinates in the state.
    Dependents,
    /// The components of a wrench.
    Wrench,
}

/// The components of a wrench.
const WRENCH: usize = 6;

/// How much of everything a scene has.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Counts {
    pub(crate) state: usize,
    pub(crate) freedom: usize,
    pub(crate) inputs: usize,
    pub(crate) parameters: usize,
    pub(crate) drives: usize,
    pub(crate) constraints: usize,
    pub(crate) loops: usize,
    pub(crate) gaps: usize,
    pub(crate) uncounted: usize,
    pub(crate) dependents: usize,
}

impl Counts {
    pub(super) fn of(model: &Model<'_>) -> Self {
        Self {
            state: model.state().len(),
            freedom: model.dof(),
            inputs: model.inputs.len(),
            parameters: model.parameters.len(),
            drives: model.drives.len(),
            constraints: model.constraints.len(),
            loops: model.loops.margins.len(),
            gaps: model.loops.gaps.len(),
            uncounted: model.loops.uncounted.len(),
            dependents: model.loops.corrections.len(),
        }
    }

    fn length(&self, of: Length) -> usize {
        match of {
            Length::State => self.state,
            Length::Freedom => self.freedom,
            Length::Inputs => self.inputs,
            Length::Parameters => self.parameters,
            Length::Drives => self.drives,
            Length::Constraints => self.constraints,
            Length::Loops => self.loops,
            Length::Gaps => self.gaps,
            Length::Uncounted => self.uncounted,
            Length::Dependents => self.dependents,
            Length::Wrench => WRENCH,
        }
    }
}

/// What a scene asks for, as far as routines depend on it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Request<'a> {
    /// How much of everything it has.
    pub(crate) counts: Counts,
    /// The words of `generate`.
    pub(crate) words: &'a BTreeSet<&'static str>,
    /// Whether the right-hand side depends on the time.
    pub(crate) time_occurs: bool,
}

impl Request<'_> {
    fn asks(&self, word: &str) -> bool {
        self.words.contains(word)
    }

    fn is_controlled(&self) -> bool {
        self.counts.inputs > 0
    }

    fn is_hybrid(&self) -> bool {
        self.counts.constraints > 0
    }

    /// Whether a scene gets the right-hand side.
    fn rhs(&self) -> bool {
        self.jacobian() || ["rhs", "canonical", "taylor"].iter().any(|word| self.asks(word))
    }

    /// A scene with inputs gets the derivatives by them together with its right-hand side.
    fn jacobian(&self) -> bool {
        self.asks("jacobian") || (self.is_controlled() && self.asks("rhs"))
    }
}

/// A row of the table of routines.
pub(crate) struct Row {
    /// The word of `generate` that asks for it.
    pub(crate) word: &'static str,
    pub(crate) name: &'static str,
    /// What printers make of it.
    pub(crate) role: Role,
    pub(crate) doc: &'static str,
    pub(crate) arguments: &'static [Argument],
    pub(crate) shapes: &'static [Shape<Length>],
    /// Whether a scene gets it; the word is that of the row.
    pub(crate) wanted: fn(&Request<'_>, &str) -> bool,
    /// Its results, in the form that was chosen.
    pub(crate) form: for<'g> fn(&mut Forms<'g>, &Model<'g>) -> Chosen<'g>,
}

impl Row {
    /// Whether it is about constraints.
    pub(super) fn is_of_constraints(&self) -> bool {
        self.shapes.contains(&Vector(Constraints))
    }

    /// The head of the routine in a scene.
    pub(super) fn head(&self, counts: &Counts) -> Head {
        let arguments = self.arguments.iter().copied();
        let shapes = self.shapes.iter();
        Head {
            name: self.name.to_owned(),
            role: self.role,
            doc: self.doc.to_owned(),
            arguments: arguments
                .filter(|argument| match argument {
                    Argument::Inputs => counts.inputs > 0,
                    Argument::Forces => counts.constraints > 0,
                    Argument::Accelerations => true,
                })
                .collect(),
            shapes: shapes.map(|shape| shape.map(|length| counts.length(length))).collect(),
        }
    }
}

/// A scene gets the routine if it asks for it by its word, whatever else it has.
const ASKED: fn(&Request<'_>, &str) -> bool = |scene, word| scene.asks(word);

use Argument::{Accelerations, Forces, Inputs};
use Length::{Constraints, Dependents, Drives, Freedom, Gaps, Loops, Parameters, State, Uncounted};
use Shape::{Matrix, Scalar, Symmetric, Vector};

/// What a response holds.
const RESPONSE: &[Shape<Length>] = &[
    Vector(State),
    Vector(Constraints),
    Matrix(State, Constraints),
    Symmetric(Constraints),
];

/// Every routine that can be generated. What is read from here: the code, its documentation and costs, and the stand-in
/// for a scene with errors.
pub(crate) const ROUTINES: &[Row] = &[
    Row {
        word: "rhs",
        name: "rhs",
        role: Role::Rhs,
        doc: "The time derivative of the state.",
        arguments: &[Inputs, Forces],
        shapes: &[Vector(State)],
        wanted: |scene, _| scene.rhs(),
        form: form::rhs,
    },
    Row {
        word: "rhs",
        name: "loop_margins",
        role: Role::LoopMargins,
        doc: "How far each closed loop is from its toggle, in the order of the declaration: 0 there, and at most 1. And the rates \
              of that.",
        arguments: &[],
        shapes: &[Vector(Loops), Vector(Loops)],
        wanted: |scene, _| scene.rhs() && scene.counts.loops > 0,
        form: form::loop_margins,
    },
    Row {
        word: "rhs",
        name: "loop_corrections",
        role: Role::LoopCorrections,
        doc: "What a step of Newton's method adds to the coordinates that follow and are in the state, to close their loops.",
        arguments: &[],
        shapes: &[Vector(Dependents)],
        wanted: |scene, _| scene.rhs() && scene.counts.dependents > 0,
        form: form::loop_corrections,
    },
    Row {
        word: "rhs",
        name: "loop_gaps",
        role: Role::LoopGaps,
        doc: "How far the loops that have no closed form are from being closed, in the order of the declaration: the distances between \
              their ends in m, the angles between their frames, or axes, in rad, and the sums of the lengths around them in m.",
        arguments: &[],
        shapes: &[Vector(Gaps), Vector(Gaps), Vector(Gaps)],
        wanted: |scene, _| scene.rhs() && scene.counts.gaps > 0,
        form: form::loop_gaps,
    },
    Row {
        word: "rhs",
        name: "turn_margins",
        role: Role::TurnMargins,
        doc: "For each angle whose turns a force takes, but do not follow from the state, the cosine of half the angle from its `near`: \
              0 where the force would jump. And the rates of that.",
        arguments: &[],
        shapes: &[Vector(Uncounted), Vector(Uncounted)],
        wanted: |scene, _| scene.rhs() && scene.counts.uncounted > 0,
        form: form::turn_margins,
    },
    Row {
        word: "rhs",
        name: "measures",
        role: Role::Measures,
        doc: "The values of the constraints, and their rates.",
        arguments: &[],
        shapes: &[Vector(Constraints), Vector(Constraints)],
        wanted: |scene, _| scene.rhs() && scene.is_hybrid(),
        form: form::measures,
    },
    Row {
        word: "rhs",
        name: "response",
        role: Role::Response,
        doc: "The time derivative of the state, the second derivatives of the constraints, \
              and what a unit of each force along it adds to the first and to the second.",
        arguments: &[Inputs, Forces],
        shapes: RESPONSE,
        wanted: |scene, _| scene.rhs() && scene.is_hybrid(),
        form: form::response,
    },
    Row {
        word: "jacobian",
        name: "jacobian",
        role: Role::Jacobian,
        doc: "The time derivative of the state, and its derivatives by the state.",
        arguments: &[Inputs, Forces],
        shapes: &[Vector(State), Matrix(State, State)],
        wanted: |scene, _| scene.jacobian(),
        form: form::jacobian,
    },
    Row {
        word: "jacobian",
        name: "time_derivative",
        role: Role::TimeDerivative,
        doc: "The derivative of the right-hand side by the time.",
        arguments: &[Inputs, Forces],
        shapes: &[Vector(State)],
        wanted: |scene, _| scene.jacobian() && scene.time_occurs,
        form: form::time_derivative,
    },
    Row {
        word: "jacobian",
        name: "input_jacobian",
        role: Role::InputJacobian,
        doc: "The derivatives of the right-hand side by the inputs.",
        arguments: &[Inputs],
        shapes: &[Matrix(State, Length::Inputs)],
        wanted: |scene, _| scene.jacobian() && scene.is_controlled(),
        form: form::input_jacobian,
    },
    Row {
        word: "jacobian",
        name: "response_derivative",
        role: Role::ResponseDerivative,
        doc: "The response with its derivatives at fixed forces: those of the right-hand side by the state, \
              those of each second derivative, a column for each, and those of both by the time.",
        arguments: &[Inputs, Forces],
        shapes: &[
            RESPONSE[0],
            RESPONSE[1],
            RESPONSE[2],
            RESPONSE[3],
            Matrix(State, State),
            Matrix(State, Constraints),
            Vector(State),
            Vector(Constraints),
        ],
        wanted: |scene, _| scene.jacobian() && scene.is_hybrid(),
        form: form::response_derivative,
    },
    Row {
        word: "jacobian",
        name: "measure_derivatives",
        role: Role::MeasureDerivatives,
        doc: "The derivatives of the values of the constraints, and of their rates, by the state, \
              a column for each, and by the time.",
        arguments: &[],
        shapes: &[
            Matrix(State, Constraints),
            Matrix(State, Constraints),
            Vector(Constraints),
            Vector(Constraints),
        ],
        wanted: |scene, _| scene.jacobian() && scene.is_hybrid(),
        form: form::measure_derivatives,
    },
    Row {
        word: "energy",
        name: "kinetic",
        role: Role::Kinetic,
        doc: "Kinetic energy.",
        arguments: &[],
        shapes: &[Scalar],
        wanted: ASKED,
        form: form::kinetic,
    },
    Row {
        word: "energy",
        name: "potential",
        role: Role::Potential,
        doc: "Potential energy.",
        arguments: &[],
        shapes: &[Scalar],
        wanted: ASKED,
        form: form::potential,
    },
    Row {
        word: "mass_matrix",
        name: "mass_matrix",
        role: Role::Function,
        doc: "The mass matrix.",
        arguments: &[],
        shapes: &[Symmetric(Freedom)],
        wanted: ASKED,
        form: form::mass_matrix,
    },
    Row {
        word: "bias",
        name: "bias",
        role: Role::Function,
        doc: "The bias: velocity terms, gravity and the inertia forces of the drives, as generalised forces.",
        arguments: &[],
        shapes: &[Vector(Freedom)],
        wanted: ASKED,
        form: form::bias,
    },
    Row {
        word: "momentum",
        name: "momentum",
        role: Role::Function,
        doc: "The momenta of the coordinates: the mass matrix times their rates.",
        arguments: &[],
        shapes: &[Vector(Freedom)],
        wanted: ASKED,
        form: form::momentum,
    },
    Row {
        word: "canonical",
        name: "canonical",
        role: Role::Canonical,
        doc: "Coordinates and momenta, and the rates of both.",
        arguments: &[Forces],
        shapes: &[Vector(State), Vector(State)],
        wanted: ASKED,
        form: form::canonical,
    },
    Row {
        word: "canonical",
        name: "canonical_jacobian",
        role: Role::CanonicalJacobian,
        doc: "The derivatives of coordinates and momenta, and of their rates, by the state.",
        arguments: &[Forces],
        shapes: &[Matrix(State, State), Matrix(State, State)],
        wanted: ASKED,
        form: form::canonical_jacobian,
    },
    Row {
        word: "inverse_dynamics",
        name: "inverse_dynamics",
        role: Role::Function,
        doc: "The generalised forces `A qdd + b - Q` that must act beside gravity and all forces of the declaration for the accelerations `qdd`: \
              zero along a free motion. Inputs count as zero: where each coordinate has one, these are their values.",
        arguments: &[Accelerations],
        shapes: &[Vector(Freedom)],
        wanted: ASKED,
        form: form::inverse_dynamics,
    },
    Row {
        word: "drive_forces",
        name: "drive_forces",
        role: Role::Function,
        doc: "The forces that the drives supply along their joints, in the order of the declaration: N m where a joint turns, N where it slides.",
        arguments: &[Inputs],
        shapes: &[Vector(Drives)],
        wanted: ASKED,
        form: form::drive_forces,
    },
    Row {
        word: "loop_wrenches",
        name: "loop_wrenches",
        role: Role::Function,
        doc: "For each `close a .. to b ..`, in the order of the declaration, the wrench with which `a` acts on `b`, about the place on `b`: \
              the moment in N m and the force in N, both in the ground frame.",
        arguments: &[Inputs],
        shapes: &[Matrix(Length::Wrench, Loops)],
        wanted: ASKED,
        form: form::loop_wrenches,
    },
    Row {
        word: "parameter_jacobian",
        name: "parameter_jacobian",
        role: Role::Function,
        doc: "The derivatives of the accelerations by the parameters: one column for each, in the order of their declaration.",
        arguments: &[Inputs],
        shapes: &[Matrix(Freedom, Parameters)],
        wanted: ASKED,
        form: form::parameter_jacobian,
    },
];

/// The words of `generate`, in the order in which messages list them.
pub(crate) fn words() -> Vec<&'static str> {
    let mut words: Vec<&'static str> = ROUTINES.iter().map(|row| row.word).collect();
    words.dedup();
    words.extend(["taylor", "shapes"]);
    words
}
