//! Table of all routines that can be generated.

use std::collections::BTreeSet;

use super::routine::{Argument, Head, Role, Shape};
use super::sizes::{Counts, Length};
use crate::form::{self, Chosen, Forms};
use crate::model::Model;

/// Requests of a scene that decide its routines.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Request<'a> {
    /// Sizes of the scene.
    pub(crate) counts: Counts,
    /// Words of `generate`.
    pub(crate) words: &'a BTreeSet<&'static str>,
    /// True if the right-hand side depends on time.
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

    /// True if a scene has the right-hand side.
    fn rhs(&self) -> bool {
        self.jacobian() || ["rhs", "canonical", "taylor"].iter().any(|word| self.asks(word))
    }

    /// True if a scene has the Jacobian. A scene with inputs has the input Jacobian whenever it has a right-hand side.
    fn jacobian(&self) -> bool {
        self.asks("jacobian") || (self.is_controlled() && self.asks("rhs"))
    }
}

/// Row of the table of routines.
pub(crate) struct Row {
    /// Word of `generate` that requests the routine.
    pub(crate) word: &'static str,
    pub(crate) name: &'static str,
    /// Part of the interface that a printer makes of it.
    pub(crate) role: Role,
    pub(crate) doc: &'static str,
    pub(crate) arguments: &'static [Argument],
    pub(crate) shapes: &'static [Shape<Length>],
    /// Returns true if a scene has the routine, given the word of the row.
    pub(crate) wanted: fn(&Request<'_>, &str) -> bool,
    /// Expressions of its results, in the chosen form.
    pub(crate) form: for<'g> fn(&mut Forms<'g>, &Model<'g>) -> Chosen<'g>,
}

impl Row {
    /// True if the routine concerns constraints.
    pub(super) fn is_of_constraints(&self) -> bool {
        self.shapes.contains(&Vector(Constraints))
    }

    /// Signature of the routine in a scene.
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
                    Argument::Accelerations | Argument::Weights | Argument::Direction => true,
                })
                .collect(),
            shapes: shapes
                .map(|shape| shape.map(|length| counts.length(length)))
                .filter(|shape| !shape.is_empty())
                .collect(),
        }
    }
}

/// Condition met if the scene requests the routine by its word, regardless of anything else.
const ASKED: fn(&Request<'_>, &str) -> bool = |scene, word| scene.asks(word);

use Argument::{Accelerations, Direction, Forces, Inputs, Weights};
use Length::{Constraints, Dependents, Drives, Freedom, Gaps, Loops, Parameters, State, Uncounted};
use Shape::{Matrix, Scalar, Symmetric, Vector};

/// Shapes of the results of a response.
const RESPONSE: &[Shape<Length>] = &[
    Vector(State),
    Vector(Constraints),
    Matrix(State, Constraints),
    Symmetric(Constraints),
];

/// Every routine that can be generated. The code, its documentation and costs, and the stand-in for a scene with errors
/// are all derived from this table.
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
        doc: "Margin of each closed loop from its singularity (toggle), in the order of the declaration: 0 there, and \
              at most 1. Then the rates of the margins.",
        arguments: &[],
        shapes: &[Vector(Loops), Vector(Loops)],
        wanted: |scene, _| scene.rhs() && scene.counts.loops > 0,
        form: form::loop_margins,
    },
    Row {
        word: "rhs",
        name: "loop_corrections",
        role: Role::LoopCorrections,
        doc: "Newton corrections of the dependent coordinates in the state, to close their loops.",
        arguments: &[],
        shapes: &[Vector(Dependents)],
        wanted: |scene, _| scene.rhs() && scene.counts.dependents > 0,
        form: form::loop_corrections,
    },
    Row {
        word: "rhs",
        name: "loop_gaps",
        role: Role::LoopGaps,
        doc: "Closure errors of the loops without a closed form, in the order of the declaration: the distances \
              between their ends in m, the angles between their frames, or axes, in rad, and the sums of the lengths \
              around them in m.",
        arguments: &[],
        shapes: &[Vector(Gaps), Vector(Gaps), Vector(Gaps)],
        wanted: |scene, _| scene.rhs() && scene.counts.gaps > 0,
        form: form::loop_gaps,
    },
    Row {
        word: "rhs",
        name: "turn_margins",
        role: Role::TurnMargins,
        doc: "Margin of each angle whose turns affect a force but do not follow from the state: the cosine of half \
              the angle from its `near`, 0 where the force would jump. Then the rates of the margins.",
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
        doc: "The time derivative of the state, the second derivatives of the constraints, and what a unit of each \
              force along it adds to the first and to the second.",
        arguments: &[Inputs, Forces],
        shapes: RESPONSE,
        wanted: |scene, _| scene.rhs() && scene.is_hybrid(),
        form: form::response,
    },
    Row {
        word: "jacobian",
        name: "jacobian",
        role: Role::Jacobian,
        doc: "The time derivative of the state, and its derivatives with respect to the state.",
        arguments: &[Inputs, Forces],
        shapes: &[Vector(State), Matrix(State, State)],
        wanted: |scene, _| scene.jacobian(),
        form: form::jacobian,
    },
    Row {
        word: "jacobian",
        name: "time_derivative",
        role: Role::TimeDerivative,
        doc: "The derivative of the right-hand side with respect to time.",
        arguments: &[Inputs, Forces],
        shapes: &[Vector(State)],
        wanted: |scene, _| scene.jacobian() && scene.time_occurs,
        form: form::time_derivative,
    },
    Row {
        word: "jacobian",
        name: "input_jacobian",
        role: Role::InputJacobian,
        doc: "The derivatives of the right-hand side with respect to the inputs.",
        arguments: &[Inputs],
        shapes: &[Matrix(State, Length::Inputs)],
        wanted: |scene, _| scene.jacobian() && scene.is_controlled(),
        form: form::input_jacobian,
    },
    Row {
        word: "jacobian",
        name: "response_derivative",
        role: Role::ResponseDerivative,
        doc: "The response with its derivatives at fixed forces: of the right-hand side with respect to the state, of \
              each second derivative with respect to the state, a column for each, and of both with respect to time.",
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
        doc: "The derivatives of the values of the constraints, and of their rates, with respect to the state, a \
              column for each, and to time.",
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
        doc: "The derivatives of coordinates and momenta, and of their rates, with respect to the state.",
        arguments: &[Forces],
        shapes: &[Matrix(State, State), Matrix(State, State)],
        wanted: ASKED,
        form: form::canonical_jacobian,
    },
    Row {
        word: "inverse_dynamics",
        name: "inverse_dynamics",
        role: Role::Function,
        doc: "The generalised forces `A qdd + b - Q` that must act beside gravity and all forces of the declaration \
              for the accelerations `qdd`: zero along a free motion. Inputs count as zero: where each coordinate has \
              one, these are their values.",
        arguments: &[Accelerations],
        shapes: &[Vector(Freedom)],
        wanted: ASKED,
        form: form::inverse_dynamics,
    },
    Row {
        word: "drive_forces",
        name: "drive_forces",
        role: Role::Function,
        doc: "Forces supplied by the drives along their joints, in the order of the declaration: in N m where a joint \
              turns, in N where it slides.",
        arguments: &[Inputs],
        shapes: &[Vector(Drives)],
        wanted: ASKED,
        form: form::drive_forces,
    },
    Row {
        word: "loop_wrenches",
        name: "loop_wrenches",
        role: Role::Function,
        doc: "For each `close a .. to b ..`, in the order of the declaration, the wrench of `a` on `b` about the \
              place on `b`: the moment in N m and the force in N, both in the ground frame.",
        arguments: &[Inputs],
        shapes: &[Matrix(Length::Wrench, Loops)],
        wanted: ASKED,
        form: form::loop_wrenches,
    },
    Row {
        word: "parameter_jacobian",
        name: "parameter_jacobian",
        role: Role::Function,
        doc: "The derivatives of the right-hand side with respect to the parameters at a fixed state: one column for \
              each, in the order of their declaration.",
        arguments: &[Inputs],
        shapes: &[Matrix(State, Parameters)],
        wanted: ASKED,
        form: form::parameter_jacobian,
    },
    Row {
        word: "adjoint",
        name: "adjoint",
        role: Role::Adjoint,
        doc: "The products of weights with the derivatives of the right-hand side (its transposed Jacobians times the \
              weights): with respect to the state, to the parameters, and to the inputs, as far as there are any.",
        arguments: &[Inputs, Weights],
        shapes: &[Vector(State), Vector(Parameters), Vector(Length::Inputs)],
        wanted: ASKED,
        form: form::adjoint,
    },
    Row {
        word: "hessian_product",
        name: "hessian_product",
        role: Role::Function,
        doc: "The second derivatives of the right-hand side, summed with weights of its components, times a \
              direction: a change of the state, followed by one of the inputs. With respect to the state, and to the \
              inputs if there are any.",
        arguments: &[Inputs, Weights, Direction],
        shapes: &[Vector(State), Vector(Length::Inputs)],
        wanted: ASKED,
        form: form::hessian_product,
    },
];

/// Words of `generate`, in the order in which messages list them.
pub(crate) fn words() -> Vec<&'static str> {
    let mut words: Vec<&'static str> = ROUTINES.iter().map(|row| row.word).collect();
    words.dedup();
    words.extend(["taylor", "shapes"]);
    words
}
