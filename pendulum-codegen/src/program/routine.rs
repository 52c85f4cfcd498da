//! Routines: what they are called, take and give, and what an evaluation takes.

use rustc_hash::FxHashMap;

use super::block::{Block, Variable};
use super::build::{NotFinite, block};
use crate::expr::ExprId;
use crate::form::{Chosen, Form};
use crate::model::Model;
use crate::pass::Operations;

/// A function of the generated model: of the time and the state, and of its [arguments](Self::arguments).
#[derive(Clone, Debug)]
pub struct Routine {
    /// Its name, also in the list of costs.
    pub name: String,
    /// What printers make of it.
    pub role: Role,
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

/// What printers make of a routine: a part of an interface, or a function by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// A function by itself, and no more.
    Function,
    /// The right-hand side.
    Rhs,
    /// The right-hand side with its derivatives by the state.
    Jacobian,
    /// Its derivative by the time.
    TimeDerivative,
    /// Its derivatives by the inputs.
    InputJacobian,
    /// The values and the rates of the constraints.
    Measures,
    /// Their derivatives.
    MeasureDerivatives,
    /// What forces along the constraints do.
    Response,
    /// Its derivatives.
    ResponseDerivative,
    /// The canonical equations.
    Canonical,
    /// Their derivatives.
    CanonicalJacobian,
    /// Kinetic energy.
    Kinetic,
    /// Potential energy.
    Potential,
    /// A function by itself: how far closed loops are from their toggles.
    LoopMargins,
    /// A function by itself: how far closed loops are from being closed.
    LoopGaps,
    /// A function by itself: what closes them.
    LoopCorrections,
    /// A function by itself: how far angles are from where their turns are not known.
    TurnMargins,
}

impl Role {
    /// Whether the routine is a function by itself.
    pub(crate) fn is_function(self) -> bool {
        matches!(
            self,
            Self::Function | Self::LoopMargins | Self::LoopGaps | Self::LoopCorrections | Self::TurnMargins
        )
    }
}

/// What an evaluation takes.
#[derive(Clone, Debug, Default)]
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

/// What a routine is called, takes and gives.
#[derive(Clone, Debug)]
pub(super) struct Head {
    pub(super) name: String,
    pub(super) role: Role,
    pub(super) doc: String,
    pub(super) arguments: Vec<Argument>,
    pub(super) shapes: Vec<Shape<usize>>,
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
            role: head.role,
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

    /// The routine that computes zeros.
    pub(super) fn blank(head: Head) -> Self {
        Self {
            block: Block::zeros(head.shapes.iter().map(|shape| shape.len()).sum()),
            name: head.name,
            role: head.role,
            doc: head.doc,
            arguments: head.arguments,
            shapes: head.shapes,
            cost: Cost::default(),
        }
    }
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
