//! Exact numbers.

use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// An exact number.
pub(crate) type Rational = num_rational::BigRational;

/// Maximum size of exact numbers, in bits of numerator and denominator together. Operations on longer numbers stay
/// operations with a value in double precision, like the sine of a number.
pub(crate) const MOST_BITS: u64 = 2048;

/// True if a number is short enough for exact arithmetic.
pub(crate) fn is_short(x: &Rational) -> bool {
    x.numer().bits() + x.denom().bits() <= MOST_BITS
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
    match (small(x), small(y)) {
        (Some([a, b]), Some([c, d])) => {
            let (left, right) = (common_divisor(a, d), common_divisor(c, b));
            quotient((a / left) * (c / right), (b / right) * (d / left))
        }
        _ => x * y,
    }
}

/// Sum of two numbers.
pub(crate) fn add(x: &Rational, y: &Rational) -> Rational {
    match (small(x), small(y)) {
        (Some([a, b]), Some([c, d])) => {
            let common = common_divisor(b, d);
            let sum = a * (d / common) + c * (b / common);
            let left = common_divisor(sum, common);
            quotient(sum / left, (b / common) * (d / left))
        }
        _ => x + y,
    }
}

/// Numerator and denominator, if both are small. Their products and the sums of two products fit an `i128`, and their
/// common divisors are computed much faster than those of numbers of any size.
fn small(x: &Rational) -> Option<[i128; 2]> {
    let part = |part: &BigInt| part.to_i64().map(i128::from);
    Some([part(x.numer())?, part(x.denom())?])
}

/// Greatest common divisor of two numbers, of which the second is positive.
fn common_divisor(a: i128, b: i128) -> i128 {
    let (mut a, mut b) = (b.unsigned_abs(), a.unsigned_abs() % b.unsigned_abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a as i128
}

/// The number with this numerator and denominator, which have no common divisor.
fn quotient(numerator: i128, denominator: i128) -> Rational {
    Rational::new_raw(numerator.into(), denominator.into())
}

#[cfg(test)]
mod tests {
    use super::{Rational, add, multiply, ratio};

    #[test]
    fn small_numbers_give_the_same_results_as_large_ones() {
        let parts = [1, 2, 6, 35, 1_000_000, i64::MAX - 1, i64::MAX];
        let numerators = parts.iter().flat_map(|&n| [n, -n]).chain([0, i64::MIN]);
        let numbers: Vec<Rational> = numerators
            .flat_map(|n| parts.map(|denominator| ratio(n, denominator)))
            .collect();
        for x in &numbers {
            for y in &numbers {
                for (own, expected) in [(multiply(x, y), x * y), (add(x, y), x + y)] {
                    assert_eq!(
                        (own.numer(), own.denom()),
                        (expected.numer(), expected.denom()),
                        "{x} and {y}"
                    );
                }
            }
        }
    }
}
