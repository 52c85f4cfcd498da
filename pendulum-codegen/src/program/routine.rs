//! Routines: what they compute, and the one table of all that can be generated.

use rustc_hash::FxHashMap;

use super::block::{Block, Variable};
use super::build::{NotFinite, block};
use crate::expr::ExprId;
use crate::form::{self, Chosen, Form, Forms};
use crate::model::Model;
use crate::pass::Operations;

/// A function of the generated model: of the time and the state, and of its [arguments](Self::arguments).
#[derive(Clone, Debug)]
pub struct Routine {
    /// Its name, also in the list of costs.
    pub name: String,
    /// What it computes.
    pub doc: String,
    /// What it takes beside the time and the state.
    pub arguments: Vec<Argument>,
    /// The shapes of its results, which stand one after the other in those of the block.
    pub shapes: Vec<Shape<usize>>,
    /// Its code.
    pub block: Block,
    /// What an evaluation takes.
    pub cost: Cost,
}

/// What an evaluation takes.
#[derive(Clone, Debug)]
pub struct Cost {
    /// The form that the code is written in, for example "recursion, L^T D L".
    pub form: String,
    /// Its operations.
    pub operations: Operations,
    /// Of a power series: the number of products of series that each order also takes.
    pub products: Option<usize>,
    /// The best of each other kind of form, from the least weight on.
    pub others: Vec<Self>,
}

impl Cost {
    pub(super) fn new(form: Form, operations: Operations) -> Self {
        Self {
            form: form.to_string(),
            operations,
            products: None,
            others: Vec::new(),
        }
    }
}

/// What a routine takes beside the time and the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Argument {
    /// The inputs, in a scene that has some.
    Inputs,
    /// The accelerations of the coordinates.
    Accelerations,
    /// The forces along the constraints, in a scene that has some.
    Forces,
}

/// The shape of a result, whose lengths are of type `N`. The entries of a matrix are listed column by column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape<N> {
    /// One number.
    Scalar,
    /// A vector of this length.
    Vector(N),
    /// A matrix of this many rows and columns.
    Matrix(N, N),
    /// A symmetric matrix of this many rows, as its upper triangle, row by row.
    Symmetric(N),
}

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

/// What a routine is called, takes and gives.
#[derive(Clone, Debug)]
pub(super) struct Head {
    pub(super) name: String,
    pub(super) doc: String,
    pub(super) arguments: Vec<Argument>,
    pub(super) shapes: Vec<Shape<usize>>,
}

impl Row {
    /// Whether it is about constraints.
    pub(super) fn is_of_constraints(&self) -> bool {
        self.shapes.contains(&Vector(Constraints))
    }

    /// The head of the routine in a scene.
    pub(super) fn head(&self, model: &Model<'_>) -> Head {
        let arguments = self.arguments.iter().copied();
        let shapes = self.shapes.iter();
        Head {
            name: self.name.to_owned(),
            doc: self.doc.to_owned(),
            arguments: arguments
                .filter(|argument| match argument {
                    Argument::Inputs => !model.inputs.is_empty(),
                    Argument::Forces => model.is_hybrid(),
                    Argument::Accelerations => true,
                })
                .collect(),
            shapes: shapes.map(|shape| shape.map(|length| length.of(model))).collect(),
        }
    }
}

impl Routine {
    /// The routine in the form that was chosen; `known` is what it can read.
    pub(super) fn new<'g>(
        model: &Model<'g>,
        head: Head,
        chosen: Chosen<'g>,
        known: &FxHashMap<ExprId, Variable>,
    ) -> Result<Self, NotFinite> {
        let others = chosen
            .others
            .iter()
            .map(|&(form, operations)| Cost::new(form, operations));
        Ok(Self {
            name: head.name,
            doc: head.doc,
            arguments: head.arguments,
            shapes: head.shapes,
            block: block(model.graph, &chosen.roots, known)?,
            cost: Cost {
                others: others.collect(),
                ..Cost::new(chosen.form, chosen.operations)
            },
        })
    }
}

/// The components of a wrench.
pub(crate) const WRENCH: usize = 6;

impl Length {
    fn of(self, model: &Model<'_>) -> usize {
        match self {
            Self::State => model.state().len(),
            Self::Freedom => model.dof(),
            Self::Inputs => model.inputs.len(),
            Self::Parameters => model.parameters.len(),
            Self::Drives => model.drives.len(),
            Self::Constraints => model.constraints.len(),
            Self::Loops => model.margins.len(),
            Self::Gaps => model.gaps.len(),
            Self::Uncounted => model.uncounted.len(),
            Self::Dependents => model.corrections.len(),
            Self::Wrench => WRENCH,
        }
    }
}

/// The words of `generate`, in the order in which messages list them.
pub(crate) fn words() -> Vec<&'static str> {
    let mut words: Vec<&'static str> = ROUTINES.iter().map(|row| row.word).collect();
    words.dedup();
    words.extend(["taylor", "shapes"]);
    words
}

impl<N> Shape<N> {
    /// The same shape over other lengths.
    pub(crate) fn map<M>(self, mut length: impl FnMut(N) -> M) -> Shape<M> {
        match self {
            Self::Scalar => Shape::Scalar,
            Self::Vector(n) => Shape::Vector(length(n)),
            Self::Matrix(n, m) => Shape::Matrix(length(n), length(m)),
            Self::Symmetric(n) => Shape::Symmetric(length(n)),
        }
    }
}

impl Shape<usize> {
    /// How many results of the block it takes.
    pub fn len(self) -> usize {
        match self {
            Self::Scalar => 1,
            Self::Vector(n) => n,
            Self::Matrix(n, m) => n * m,
            Self::Symmetric(n) => n * (n + 1) / 2,
        }
    }

    /// Whether it takes none.
    pub fn is_empty(self) -> bool {
        self.len() == 0
    }
}

/// What a scene asks for, as far as routines depend on it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Request<'a> {
    /// The scene.
    pub(crate) model: &'a Model<'a>,
    /// Whether the right-hand side depends on the time.
    pub(crate) time_occurs: bool,
}

impl Request<'_> {
    fn asks(&self, word: &str) -> bool {
        self.model.generate.contains(word)
    }

    fn is_controlled(&self) -> bool {
        !self.model.inputs.is_empty()
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
    pub(crate) doc: &'static str,
    pub(crate) arguments: &'static [Argument],
    pub(crate) shapes: &'static [Shape<Length>],
    /// Whether a scene gets it; the word is that of the row.
    pub(crate) wanted: fn(&Request<'_>, &str) -> bool,
    /// Its results, in the form that was chosen.
    pub(crate) form: for<'g> fn(&mut Forms<'g>, &Model<'g>) -> Chosen<'g>,
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
        doc: "The time derivative of the state.",
        arguments: &[Inputs, Forces],
        shapes: &[Vector(State)],
        wanted: |scene, _| scene.rhs(),
        form: form::rhs,
    },
    Row {
        word: "rhs",
        name: "loop_margins",
        doc: "How far each closed loop is from its toggle, in the order of the declaration: 0 there, and at most 1. And the rates \
              of that.",
        arguments: &[],
        shapes: &[Vector(Loops), Vector(Loops)],
        wanted: |scene, _| scene.rhs() && !scene.model.margins.is_empty(),
        form: form::loop_margins,
    },
    Row {
        word: "rhs",
        name: "loop_corrections",
        doc: "What a step of Newton's method adds to the coordinates that follow and are in the state, to close their loops.",
        arguments: &[],
        shapes: &[Vector(Dependents)],
        wanted: |scene, _| scene.rhs() && !scene.model.corrections.is_empty(),
        form: form::loop_corrections,
    },
    Row {
        word: "rhs",
        name: "loop_gaps",
        doc: "How far the loops that have no closed form are from being closed, in the order of the declaration: the distances between \
              their ends in m, the angles between their frames, or axes, in rad, and the sums of the lengths around them in m.",
        arguments: &[],
        shapes: &[Vector(Gaps), Vector(Gaps), Vector(Gaps)],
        wanted: |scene, _| scene.rhs() && !scene.model.gaps.is_empty(),
        form: form::loop_gaps,
    },
    Row {
        word: "rhs",
        name: "turn_margins",
        doc: "For each angle whose turns a force takes, but do not follow from the state, the cosine of half the angle from its `near`: \
              0 where the force would jump. And the rates of that.",
        arguments: &[],
        shapes: &[Vector(Uncounted), Vector(Uncounted)],
        wanted: |scene, _| scene.rhs() && !scene.model.uncounted.is_empty(),
        form: form::turn_margins,
    },
    Row {
        word: "rhs",
        name: "measures",
        doc: "The values of the constraints, and their rates.",
        arguments: &[],
        shapes: &[Vector(Constraints), Vector(Constraints)],
        wanted: |scene, _| scene.rhs() && scene.model.is_hybrid(),
        form: form::measures,
    },
    Row {
        word: "rhs",
        name: "response",
        doc: "The time derivative of the state, the second derivatives of the constraints, \
              and what a unit of each force along it adds to the first and to the second.",
        arguments: &[Inputs, Forces],
        shapes: RESPONSE,
        wanted: |scene, _| scene.rhs() && scene.model.is_hybrid(),
        form: form::response,
    },
    Row {
        word: "jacobian",
        name: "jacobian",
        doc: "The time derivative of the state, and its derivatives by the state.",
        arguments: &[Inputs, Forces],
        shapes: &[Vector(State), Matrix(State, State)],
        wanted: |scene, _| scene.jacobian(),
        form: form::jacobian,
    },
    Row {
        word: "jacobian",
        name: "time_derivative",
        doc: "The derivative of the right-hand side by the time.",
        arguments: &[Inputs, Forces],
        shapes: &[Vector(State)],
        wanted: |scene, _| scene.jacobian() && scene.time_occurs,
        form: form::time_derivative,
    },
    Row {
        word: "jacobian",
        name: "input_jacobian",
        doc: "The derivatives of the right-hand side by the inputs.",
        arguments: &[Inputs],
        shapes: &[Matrix(State, Length::Inputs)],
        wanted: |scene, _| scene.jacobian() && scene.is_controlled(),
        form: form::input_jacobian,
    },
    Row {
        word: "jacobian",
        name: "response_derivative",
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
        wanted: |scene, _| scene.jacobian() && scene.model.is_hybrid(),
        form: form::response_derivative,
    },
    Row {
        word: "jacobian",
        name: "measure_derivatives",
        doc: "The derivatives of the values of the constraints, and of their rates, by the state, \
              a column for each, and by the time.",
        arguments: &[],
        shapes: &[
            Matrix(State, Constraints),
            Matrix(State, Constraints),
            Vector(Constraints),
            Vector(Constraints),
        ],
        wanted: |scene, _| scene.jacobian() && scene.model.is_hybrid(),
        form: form::measure_derivatives,
    },
    Row {
        word: "energy",
        name: "kinetic",
        doc: "Kinetic energy.",
        arguments: &[],
        shapes: &[Scalar],
        wanted: ASKED,
        form: form::kinetic,
    },
    Row {
        word: "energy",
        name: "potential",
        doc: "Potential energy.",
        arguments: &[],
        shapes: &[Scalar],
        wanted: ASKED,
        form: form::potential,
    },
    Row {
        word: "mass_matrix",
        name: "mass_matrix",
        doc: "The mass matrix.",
        arguments: &[],
        shapes: &[Symmetric(Freedom)],
        wanted: ASKED,
        form: form::mass_matrix,
    },
    Row {
        word: "bias",
        name: "bias",
        doc: "The bias: velocity terms, gravity and the inertia forces of the drives, as generalised forces.",
        arguments: &[],
        shapes: &[Vector(Freedom)],
        wanted: ASKED,
        form: form::bias,
    },
    Row {
        word: "momentum",
        name: "momentum",
        doc: "The momenta of the coordinates: the mass matrix times their rates.",
        arguments: &[],
        shapes: &[Vector(Freedom)],
        wanted: ASKED,
        form: form::momentum,
    },
    Row {
        word: "canonical",
        name: "canonical",
        doc: "Coordinates and momenta, and the rates of both.",
        arguments: &[Forces],
        shapes: &[Vector(State), Vector(State)],
        wanted: ASKED,
        form: form::canonical,
    },
    Row {
        word: "canonical",
        name: "canonical_jacobian",
        doc: "The derivatives of coordinates and momenta, and of their rates, by the state.",
        arguments: &[Forces],
        shapes: &[Matrix(State, State), Matrix(State, State)],
        wanted: ASKED,
        form: form::canonical_jacobian,
    },
    Row {
        word: "inverse_dynamics",
        name: "inverse_dynamics",
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
        doc: "The forces that the drives supply along their joints, in the order of the declaration: N m where a joint turns, N where it slides.",
        arguments: &[Inputs],
        shapes: &[Vector(Drives)],
        wanted: ASKED,
        form: form::drive_forces,
    },
    Row {
        word: "loop_wrenches",
        name: "loop_wrenches",
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
        doc: "The derivatives of the accelerations by the parameters: one column for each, in the order of their declaration.",
        arguments: &[Inputs],
        shapes: &[Matrix(Freedom, Parameters)],
        wanted: ASKED,
        form: form::parameter_jacobian,
    },
];
