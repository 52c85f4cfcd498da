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
mod smooth;
mod text;

use num_traits::{One, Signed, Zero};

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

/// An exact number.
pub(crate) type Rational = num_rational::BigRational;

/// Largest power written as one, and largest exponent to which products are gathered. The code emitted for a power is
/// as long as the product of its factors.
pub(crate) const MOST_POWER: i64 = 64;

/// Maximum size of exact numbers, in bits of numerator and denominator together. Operations on longer numbers stay
/// operations with a value in double precision, like the sine of a number.
pub(crate) const MOST_BITS: u64 = 2048;

/// True if a number is short enough for exact arithmetic.
pub(crate) fn is_short(x: &Rational) -> bool {
    x.numer().bits() + x.denom().bits() <= MOST_BITS
}

/// True if a power with this exponent is written as one power.
fn is_low(exponent: &Rational) -> bool {
    exponent.abs() <= ratio(MOST_POWER, 1) && exponent.denom().bits() <= 12
}

/// The rational `numerator / denominator`; the denominator must not be zero.
pub(crate) fn ratio(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator.into(), denominator.into())
}

/// Product of two numbers. Most of the time one of them is 0, 1 or -1, and no common divisor need be computed.
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
