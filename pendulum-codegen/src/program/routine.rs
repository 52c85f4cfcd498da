//! Routines: their names, arguments, results and costs.

use rustc_hash::FxHashMap;

use super::block::{Block, Columns, Term, Variable};
use super::build::{NotFinite, block};
use crate::expr::{ExprId, Graph};
use crate::form::{Chosen, Form};
use crate::model::Model;
use crate::pass::Operations;

/// Function of the generated model: of the time, the state and its [arguments](Self::arguments).
#[derive(Clone, Debug)]
pub struct Routine {
    /// Name, also in the list of costs.
    pub name: String,
    /// Part of the interface that a printer makes of the routine.
    pub role: Role,
    /// Documentation of the result.
    pub doc: String,
    /// Arguments beside the time and the state.
    pub arguments: Vec<Argument>,
    /// Shapes of the results, which follow one another in the results of the block.
    pub shapes: Vec<Shape<usize>>,
    /// Code.
    pub block: Block,
    /// Cost of an evaluation.
    pub cost: Cost,
}

/// Part of the interface that a printer makes of a routine, or a function of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Separate function.
    Function,
    /// Right-hand side.
    Rhs,
    /// Right-hand side with its derivatives with respect to the state.
    Jacobian,
    /// Derivative of the right-hand side with respect to time.
    TimeDerivative,
    /// Derivatives of the right-hand side with respect to the inputs.
    InputJacobian,
    /// Values and rates of the constraints.
    Measures,
    /// Derivatives of the constraint values and rates.
    MeasureDerivatives,
    /// Response to forces along the constraints.
    Response,
    /// Derivatives of the response.
    ResponseDerivative,
    /// Canonical equations.
    Canonical,
    /// Derivatives of the canonical equations.
    CanonicalJacobian,
    /// Kinetic energy.
    Kinetic,
    /// Potential energy.
    Potential,
    /// Separate function: products of weights with the derivatives of the right-hand side.
    Adjoint,
    /// Separate function: margins of closed loops from their singularities (toggles).
    LoopMargins,
    /// Separate function: closure errors of loops.
    LoopGaps,
    /// Separate function: Newton corrections that close the loops.
    LoopCorrections,
    /// Separate function: margins of angles from the point where their turns become ambiguous.
    TurnMargins,
}

impl Role {
    /// True if the routine is a separate function.
    pub(crate) fn is_function(self) -> bool {
        matches!(
            self,
            Self::Function
                | Self::Adjoint
                | Self::LoopMargins
                | Self::LoopGaps
                | Self::LoopCorrections
                | Self::TurnMargins
        )
    }
}

/// Cost of an evaluation.
#[derive(Clone, Debug, Default)]
pub struct Cost {
    /// Form of the code, for example "recursion, L^T D L".
    pub form: String,
    /// Number of operations.
    pub operations: Operations,
    /// For a power series, the number of products of series at each order, not included in `operations`.
    pub products: Option<usize>,
    /// Best of each other kind of form, in ascending order of weight.
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

/// Argument of a routine beside the time and the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Argument {
    /// Inputs, if the scene has any.
    Inputs,
    /// Accelerations of the coordinates.
    Accelerations,
    /// Forces along the constraints, if the scene has any.
    Forces,
    /// Weights of the components of the right-hand side.
    Weights,
    /// Direction of the state and the inputs.
    Direction,
}

/// Shape of a result, with lengths of type `N`. Entries of a matrix are in column-major order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape<N> {
    /// Single number.
    Scalar,
    /// Vector of this length.
    Vector(N),
    /// Matrix of this many rows and columns.
    Matrix(N, N),
    /// Symmetric matrix of this many rows, as its upper triangle, row by row.
    Symmetric(N),
}

/// Signature of a routine: name, role, documentation, arguments and results.
#[derive(Clone, Debug)]
pub(super) struct Head {
    pub(super) name: String,
    pub(super) role: Role,
    pub(super) doc: String,
    pub(super) arguments: Vec<Argument>,
    pub(super) shapes: Vec<Shape<usize>>,
}

impl Routine {
    /// Routine in the chosen form. `known` maps expressions to the variables that its code may read.
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
            block: whole(model.graph, &chosen, known)?,
            cost: Cost {
                others: others.collect(),
                ..Cost::new(chosen.form, chosen.operations)
            },
        })
    }

    /// Routine whose results are zeros.
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

/// Block of a function in the chosen form.
fn whole(graph: &Graph, chosen: &Chosen<'_>, known: &FxHashMap<ExprId, Variable>) -> Result<Block, NotFinite> {
    let Some(columns) = &chosen.columns else {
        return block(graph, &chosen.roots, known);
    };
    let solution = block(graph, &columns.solution, known)?;
    let mut all = block(graph, &[&columns.given[..], &chosen.roots].concat(), known)?;
    let results = all.results.split_off(columns.given.len());
    let factors = all.results.split_off(columns.count * columns.solution.len());
    assert!(
        !all.statements_read_solutions(),
        "statements read solutions, which follow them"
    );
    let given = all
        .results
        .chunks(columns.solution.len())
        .map(<[Term]>::to_vec)
        .collect();
    let columns = Columns {
        given,
        factors,
        solution,
    };
    Ok(Block {
        columns: Some(Box::new(columns)),
        results,
        ..all
    })
}

impl<N> Shape<N> {
    /// Applies a function to each length.
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
    /// Number of results of the block that the shape takes.
    pub fn len(self) -> usize {
        match self {
            Self::Scalar => 1,
            Self::Vector(n) => n,
            Self::Matrix(n, m) => n * m,
            Self::Symmetric(n) => n * (n + 1) / 2,
        }
    }

    /// True if the shape takes no results.
    pub fn is_empty(self) -> bool {
        self.len() == 0
    }
}
