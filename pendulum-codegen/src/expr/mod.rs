//! Symbolic expressions as a hash-consed graph, and their polynomial normal form.
//!
//! Arithmetic is exact: numbers are rationals of any size, and roots and the sines of constants stay symbolic until
//! code is emitted. Two expressions are the same exactly when they are the same node.
//!
//! An [`Expr`] is a node with its graph: physics, forms and passes compute with it, take it and return it. An
//! [`ExprId`] is the bare index of a node: an operand in the graph, an atom of a polynomial, an item of a pass, a key
//! in the tables of printers.

mod build;
mod derivative;
mod eval;
mod expression;
mod formula;
mod graph;
mod latex;
mod modular;
mod normal;
mod op;
mod operators;
mod poly;
mod precedence;
mod print;
mod rational;
mod smooth;
mod text;

use num_traits::Signed;

pub(crate) use derivative::{Derivative, gradient};
pub(crate) use expression::Expr;
pub use formula::{Definition, Formula, Summand};
pub(crate) use graph::{ExprId, Graph, Level, Node, Symbol, SymbolKind};
pub(crate) use latex::latex_definitions;
pub(crate) use modular::vanishing_pivot;
pub(crate) use normal::{BaseAngles, Normalizer, TooLarge};
pub(crate) use op::CostKind;
pub use op::{Binary, Unary};
pub(crate) use poly::{Monomial, Poly};
pub(crate) use precedence::Precedence;
pub(crate) use print::{LONGEST_CONSTANT, Printer};
pub(crate) use rational::{MOST_BITS, Rational, add, is_short, multiply, ratio};

/// Largest power written as one, and largest exponent to which products are gathered. The code emitted for a power is
/// as long as the product of its factors.
pub(crate) const MOST_POWER: i64 = 64;

/// True if a power with this exponent is written as one power.
fn is_low(exponent: &Rational) -> bool {
    exponent.abs() <= ratio(MOST_POWER, 1) && exponent.denom().bits() <= 12
}
