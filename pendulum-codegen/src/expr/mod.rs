//! Symbolic expressions as a hash-consed graph, and their polynomial normal form.
//!
//! Arithmetic is exact: numbers are rationals of any size, roots and the sines of constants stay symbols until code is
//! emitted. Two expressions are the same exactly when they are the same node.
//!
//! An [`Expr`] is a node and its graph: the value that physics, forms and passes compute with, take and return. An
//! [`ExprId`] is the bare number of a node: operands in the graph, atoms of polynomials, items of passes, and what
//! printers look up in tables.

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
mod smooth;
mod text;

use num_traits::{One, Signed, Zero};

pub(crate) use derivative::Derivative;
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

/// An exact number.
pub(crate) type Rational = num_rational::BigRational;

/// The largest power that is written, and that products are gathered to: what is emitted for one is as long as a
/// product of as many factors.
pub(crate) const MOST_POWER: i64 = 64;

/// The most binary digits, of numerator and denominator together, of numbers that are computed exactly. Operations on
/// longer ones stay operations, which have a value in double precision, as the sine of a number has.
pub(crate) const MOST_BITS: u64 = 2048;

/// Whether a number is short enough to be computed with exactly.
pub(crate) fn is_short(x: &Rational) -> bool {
    x.numer().bits() + x.denom().bits() <= MOST_BITS
}

/// Whether a power of a value is written as one power.
fn is_low(exponent: &Rational) -> bool {
    exponent.abs() <= ratio(MOST_POWER, 1) && exponent.denom().bits() <= 12
}

/// The rational `numerator / denominator`; the denominator must not be zero.
pub(crate) fn ratio(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator.into(), denominator.into())
}

/// The product of two numbers. One of them is 0, 1 or -1 most of the time, where no common divisor need be searched.
pub(crate) fn multiply(x: &Rational, y: &Rational) -> Rational {
    for (unit, other) in [(x, y), (y, x)] {
        if unit.is_zero() {
            return Rational::zero();
        }
        if unit.is_integer() && unit.numer().magnitude().is_one() {
            return if unit.is_positive() { other.clone() } else { -other };
        }
    }
    x * y
}
