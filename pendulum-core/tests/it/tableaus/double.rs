//! Numbers of twice the precision.

use std::ops::{Add, Mul, Sub};

/// The unevaluated sum of two `f64`, the second below the rounding error of the first: about 106 bits.
///
/// T. J. Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18 (1971) 224-242.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Double {
    high: f64,
    low: f64,
}

impl Double {
    /// Rounds to the nearest `f64`.
    pub(crate) fn round(self) -> f64 {
        self.high + self.low
    }

    /// Normalised `high + low`, with `low` the smaller one.
    fn normal(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self {
            high: sum,
            low: low - (sum - high),
        }
    }
}

impl From<f64> for Double {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let sum = self.high + other.high;
        let part = sum - self.high;
        let rest = (self.high - (sum - part)) + (other.high - part);
        Self::normal(sum, rest + (self.low + other.low))
    }
}

impl Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + other * Self::from(-1.0)
    }
}

impl Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = self.high * other.high;
        let rest = self.high.mul_add(other.high, -product);
        Self::normal(product, rest + (self.high * other.low + self.low * other.high))
    }
}
