//! The forms in which the same motion can be written, and what they are called.

use std::fmt;

use crate::dynamics::Solver;
use crate::pass::Products;

/// A form of one function.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Form {
    /// How the dynamics are written.
    pub basis: Basis,
    /// Whether forces at points act as wrenches on links.
    pub wrenches: bool,
    /// How the accelerations are solved from them, where they are.
    pub solver: Option<Solver>,
    /// Whether what cancels in the solution did so in symbols.
    pub exact: bool,
    /// How they are derived, where they are.
    pub derivatives: Option<Derivatives>,
}

/// How the dynamics are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Basis {
    /// Expanded to normal form.
    Closed(Products),
    /// The graph of A, B and C as it was built.
    #[default]
    Shared,
    /// Newton and Euler's recursion and composite bodies, on links in base parameters.
    Recursive,
    /// Articulated bodies, on the same links.
    Articulated,
    /// No part of the dynamics: as it was declared.
    Declared,
}

/// How inverse dynamics are derived by the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Derivatives {
    /// Expression by expression, in the graph.
    Graph,
    /// In the graph, and then expanded to normal form.
    Expanded,
    /// By a recursion of their own.
    Recursion,
}

impl Form {
    pub(super) fn of(basis: Basis) -> Self {
        Self {
            basis,
            ..Self::default()
        }
    }

    pub(super) fn with_wrenches(self, wrenches: bool) -> Self {
        Self { wrenches, ..self }
    }

    pub(super) fn solved_by(self, solver: Solver) -> Self {
        Self {
            solver: Some(solver),
            ..self
        }
    }

    pub(super) fn exactly(self) -> Self {
        Self { exact: true, ..self }
    }

    pub(super) fn derived_by(self, derivatives: Derivatives) -> Self {
        Self {
            derivatives: Some(derivatives),
            ..self
        }
    }
}

/// For example "recursion, L^T D L, derived by recursion".
impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.basis {
            Basis::Closed(Products::Factored) => "closed form, factored",
            Basis::Closed(Products::Expanded) => "closed form, expanded",
            Basis::Shared => "A, B and C",
            Basis::Recursive => "recursion",
            Basis::Articulated => "articulated bodies",
            Basis::Declared => "as declared",
        })?;
        if self.wrenches {
            f.write_str(" with wrenches on links")?;
        }
        f.write_str(match self.solver {
            Some(Solver::Adjugate) => ", adjugate",
            Some(Solver::Inverse) => ", inverse",
            Some(Solver::Ldl) => ", L^T D L",
            None => "",
        })?;
        if self.exact {
            f.write_str(", exact quotient")?;
        }
        f.write_str(match self.derivatives {
            Some(Derivatives::Graph) => ", derived in the graph",
            Some(Derivatives::Expanded) => ", derived and expanded",
            Some(Derivatives::Recursion) => ", derived by recursion",
            None => "",
        })
    }
}
