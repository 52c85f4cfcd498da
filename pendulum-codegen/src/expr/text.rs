//! Formulas as text in the language of declarations, which can be parsed again.

use std::fmt::{Display, Formatter, Result};

use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive};

use super::{Formula, Precedence, Rational};

impl Display for Formula {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::Number(n) => f.write_str(&number(n)),
            Self::Measured(number, unit) => write!(f, "{number} {unit}"),
            Self::Name(name) => f.write_str(name),
            Self::Entry(name, indices) => write!(f, "{name}[{}]", indices.join(", ")),
            Self::Call(function, arguments) => {
                write!(f, "{function}(")?;
                for (n, argument) in arguments.iter().enumerate() {
                    write!(f, "{}{argument}", if n > 0 { ", " } else { "" })?;
                }
                f.write_str(")")
            }
            Self::Neg(a) => write!(f, "-{}", Within(a, Precedence::Product)),
            Self::Sum(terms) => {
                for (n, term) in terms.iter().enumerate() {
                    f.write_str(match (n, term.negative) {
                        (0, false) => "",
                        (0, true) => "-",
                        (_, false) => " + ",
                        (_, true) => " - ",
                    })?;
                    write!(f, "{}", Within(&term.formula, Precedence::Product))?;
                }
                Ok(())
            }
            Self::Product(factors) => {
                for (n, factor) in factors.iter().enumerate() {
                    write!(
                        f,
                        "{}{}",
                        if n > 0 { "*" } else { "" },
                        Within(factor, Precedence::Product)
                    )?;
                }
                Ok(())
            }
            Self::Quotient(above, below) => {
                let (above, below) = (Within(above, Precedence::Product), Within(below, Precedence::Power));
                write!(f, "{above}/{below}")
            }
            Self::Power(base, exponent) => {
                let (base, exponent) = (Within(base, Precedence::Atom), Within(exponent, Precedence::Atom));
                write!(f, "{base}^{exponent}")
            }
        }
    }
}

impl Formula {
    /// Outermost operation of the text.
    pub fn precedence(&self) -> Precedence {
        match self {
            // brackets keep a unit apart from the text behind it
            Self::Measured(..) => Precedence::Sum,
            Self::Number(n) if n.is_negative() => Precedence::Sum,
            Self::Number(n) if !n.denom().is_one() && decimal(n).is_none() => Precedence::Product,
            Self::Number(_) | Self::Name(_) | Self::Entry(..) | Self::Call(..) => Precedence::Atom,
            Self::Neg(_) | Self::Sum(_) => Precedence::Sum,
            Self::Product(_) | Self::Quotient(..) => Precedence::Product,
            Self::Power(..) => Precedence::Power,
        }
    }
}

/// A formula in a place that requires a least precedence; brackets are added if its own is lower.
struct Within<'f>(&'f Formula, Precedence);

impl Display for Within<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let Self(formula, least) = self;
        if formula.precedence() < *least {
            write!(f, "({formula})")
        } else {
            write!(f, "{formula}")
        }
    }
}

/// Decimal form if it is exact and short, else a fraction.
pub(super) fn number(n: &Rational) -> String {
    decimal(n).unwrap_or_else(|| n.to_string())
}

/// Decimal form, if it is exact and short.
fn decimal(n: &Rational) -> Option<String> {
    /// Maximum number of characters.
    const LONGEST: usize = 18;
    // a denominator that divides a power of ten with fewer digits than that
    let denominator = n.denom().to_u64().filter(|&denominator| denominator > 1)?;
    if !10_u64.pow(LONGEST as u32).is_multiple_of(denominator) {
        return None;
    }
    let decimal = format!("{:?}", super::eval::nearest_f64(n));
    if decimal.len() > LONGEST || decimal.contains('e') {
        return None;
    }
    let (whole, fraction) = decimal.split_once('.')?;
    let digits: BigInt = format!("{whole}{fraction}").parse().ok()?;
    let scale = 10_u64.pow(fraction.len() as u32);
    let is_exact = scale.is_multiple_of(denominator) && n.numer() * (scale / denominator) == digits;
    is_exact.then_some(decimal)
}
