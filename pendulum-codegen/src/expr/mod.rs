//! Symbolic expressions as a hash-consed graph, and their polynomial normal form.
//!
//! Arithmetic is exact: numbers are rationals of any size, roots and the sines of constants stay symbols until code is
//! emitted. Two expressions are the same exactly when they are the same node.
//!
//! An [`Expr`] is a node and its graph: the value that physics, forms and passes compute with, take and return. An [`ExprId`] is
//! the bare number of a node: operands in the graph, atoms of polynomials, items of passes, and what printers look up in tables.

mod build;
mod derivative;
mod eval;
mod expression;
mod formula;
mod graph;
mod latex;
mod normal;
mod op;
mod operators;
mod poly;
mod precedence;
mod print;
mod text;

pub use derivative::Derivative;
pub use expression::Expr;
pub use formula::{Definition, Formula, Term};
pub use graph::{ExprId, Graph, Level, Node, Symbol, SymbolId, SymbolKind};
pub(crate) use latex::latex_definitions;
pub use normal::{BaseAngles, Normalizer, TooLarge};
pub use op::{Binary, CostKind, Unary};
pub use poly::{Monomial, Poly};
pub use precedence::Precedence;
pub use print::Printer;

/// An exact number.
pub type Rational = num_rational::BigRational;

/// The rational `numerator / denominator`; the denominator must not be zero.
pub fn ratio(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator.into(), denominator.into())
}
