//! Forms of the same equations of motion, and their names.

use std::fmt;

use crate::dynamics::Solver;
use crate::pass::Products;

/// Form of one function.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Form {
    /// Form of the dynamics.
    pub basis: Basis,
    /// True if forces at points act as wrenches on links.
    pub wrenches: bool,
    /// Method that solves for the accelerations, if any.
    pub solver: Option<Solver>,
    /// True if terms of the solution cancelled in symbols.
    pub exact: bool,
    /// Method that differentiates the accelerations, if any.
    pub derivatives: Option<Derivatives>,
}

/// Form of the dynamics.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Basis {
    /// Expanded to normal form.
    Closed(Products),
    /// Graph of A, B and C as built.
    #[default]
    Shared,
    /// Recursive Newton-Euler and composite rigid bodies, on links in base parameters.
    Recursive,
    /// Articulated bodies, on the same links.
    Articulated,
    /// Not part of the dynamics: the expression as declared.
    Declared,
}

/// Method that differentiates inverse dynamics with respect to the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Derivatives {
    /// Expression by expression, in the graph.
    Graph,
    /// In the graph, then expanded to normal form.
    Expanded,
    /// By a separate recursion.
    Recursion,
    /// Through the joints of articulated bodies, without inverse dynamics.
    Links,
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

/// Prints a form, for example "recursion, L^T D L, derived by recursion".
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
            Some(Derivatives::Links) => ", derived link by link",
            None => "",
        })
    }
}
