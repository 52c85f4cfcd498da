//! Truncated power series as a number type: computes the series of a motion from its right-hand side alone.
//!
//! Slow and simple. Functions are composed with their own Taylor series about the first coefficient by Horner's rule,
//! so no formula is shared with the recurrences of generated code.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use nalgebra::SVector;
use pendulum_core::Real;
use pendulum_core::prelude::*;

/// Default number of coefficients.
pub const LENGTH: usize = 22;

/// `sum_k self.0[k] h^k`
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Series<const LENGTH: usize = { self::LENGTH }>(pub [f64; LENGTH]);

impl<const LENGTH: usize> Series<LENGTH> {
    fn from_fn(coefficient: impl FnMut(usize) -> f64) -> Self {
        Self(std::array::from_fn(coefficient))
    }

    /// Series of a function of `self`, given the Taylor coefficients of the function about `self.0[0]`.
    fn compose(self, coefficients: impl Fn(usize) -> f64) -> Self {
        let mut beyond = self;
        beyond.0[0] = 0.0;
        (0..LENGTH)
            .rev()
            .fold(Self::default(), |sum, n| sum * beyond + Self::from_f64(coefficients(n)))
    }

    /// Like [`compose`](Self::compose), but given the values of the derivatives of the function.
    fn derivatives(self, value: impl Fn(usize) -> f64) -> Self {
        self.compose(|n| value(n) / (1..=n).map(|n| n as f64).product::<f64>())
    }
}

/// Coefficients of a motion. Each evaluation of the right-hand side makes one more coefficient correct.
pub fn motion<S: System<Series, N>, const N: usize>(system: &S, t: f64, x: SVector<f64, N>) -> Vec<SVector<f64, N>> {
    let time = Series::from_fn(|k| [t, 1.0].get(k).copied().unwrap_or(0.0));
    let mut state = x.map(Series::from_f64);
    for k in 1..LENGTH {
        let slope = system.rhs(time, &state);
        for (x, slope) in state.iter_mut().zip(&slope) {
            x.0[k] = slope.0[k - 1] / k as f64;
        }
    }
    (0..LENGTH).map(|k| state.map(|x| x.0[k])).collect()
}

impl<const LENGTH: usize> Default for Series<LENGTH> {
    fn default() -> Self {
        Self([0.0; LENGTH])
    }
}

impl<const LENGTH: usize> Add for Series<LENGTH> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::from_fn(|k| self.0[k] + other.0[k])
    }
}

impl<const LENGTH: usize> Sub for Series<LENGTH> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::from_fn(|k| self.0[k] - other.0[k])
    }
}

impl<const LENGTH: usize> Mul for Series<LENGTH> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::from_fn(|k| (0..=k).map(|j| self.0[j] * other.0[k - j]).sum())
    }
}

impl<const LENGTH: usize> Div for Series<LENGTH> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        // Newton's iteration for the inverse doubles the number of correct coefficients
        let (one, mut inverse) = (Self::from_f64(1.0), Self::from_f64(1.0 / other.0[0]));
        for _ in 0..5 {
            inverse += inverse * (one - other * inverse);
        }
        self * inverse
    }
}

impl<const LENGTH: usize> Neg for Series<LENGTH> {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.map(|x| -x))
    }
}

macro_rules! assign {
    ($($trait:ident $method:ident $operator:tt;)*) => { $(
        impl<const LENGTH: usize> $trait for Series<LENGTH> {
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )* };
}

assign! {
    AddAssign add_assign +;
    SubAssign sub_assign -;
    MulAssign mul_assign *;
    DivAssign div_assign /;
}

impl<const LENGTH: usize> Real for Series<LENGTH> {
    fn from_f64(v: f64) -> Self {
        Self::from_fn(|k| if k == 0 { v } else { 0.0 })
    }

    fn piecewise<const C: usize>(self, piece: impl Fn(f64) -> [f64; C]) -> [Self; C] {
        self.0[0].piecewise(piece).map(Self::from_f64)
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.0[0].sin_cos();
        (
            self.derivatives(|n| [sin, cos, -sin, -cos][n % 4]),
            self.derivatives(|n| [cos, -sin, -cos, sin][n % 4]),
        )
    }

    fn tan(self) -> Self {
        let (sin, cos) = Real::sin_cos(self);
        sin / cos
    }

    fn exp(self) -> Self {
        let value = self.0[0].exp();
        self.derivatives(|_| value)
    }

    fn ln(self) -> Self {
        let (u, value) = (self.0[0], self.0[0].ln());
        self.compose(|n| {
            if n == 0 {
                value
            } else {
                -(-1.0 / u).powi(n as i32) / n as f64
            }
        })
    }

    fn sqrt(self) -> Self {
        self.powf(Self::from_f64(0.5))
    }

    fn tanh(self) -> Self {
        let (one, two) = (Self::from_f64(1.0), Self::from_f64(2.0));
        one - two / ((two * self).exp() + one)
    }

    fn abs(self) -> Self {
        self * self.signum()
    }

    fn signum(self) -> Self {
        Self::from_f64(Real::signum(self.0[0]))
    }

    fn at_least(self, low: Self) -> Self {
        if self.0[0] < low.0[0] { low } else { self }
    }

    fn at_most(self, high: Self) -> Self {
        if self.0[0] > high.0[0] { high } else { self }
    }

    /// Computed as the imaginary part of `ln(z)` about `z_0`, with `z = x + iy`.
    fn atan2(self, x: Self) -> Self {
        let (y0, x0) = (self.0[0], x.0[0]);
        let norm = Self::from_f64(x0 * x0 + y0 * y0);
        let (a, b) = (Self::from_f64(x0), Self::from_f64(y0));
        // w = z / z_0 - 1 = u + iv
        let (u, v) = (
            (x * a + self * b) / norm - Self::from_f64(1.0),
            (self * a - x * b) / norm,
        );
        let (mut real, mut imaginary) = (Self::from_f64(1.0), Self::default());
        let mut sum = Self::from_f64(y0.atan2(x0));
        for n in 1..LENGTH {
            (real, imaginary) = (real * u - imaginary * v, real * v + imaginary * u);
            let sign = if n % 2 == 1 { 1.0 } else { -1.0 };
            sum += imaginary * Self::from_f64(sign / n as f64);
        }
        sum
    }

    fn powf(self, exponent: Self) -> Self {
        let (u, n) = (self.0[0], exponent.0[0]);
        let binomial = |k: usize| (0..k).map(|j| (n - j as f64) / (j + 1) as f64).product::<f64>();
        self.compose(|k| binomial(k) * u.powf(n - k as f64))
    }
}

/// Largest difference of two lists of coefficients. Each term is evaluated at the step size at which the largest term
/// equals the state, and measured in units of the largest term there.
pub fn difference<const N: usize>(ours: &[SVector<f64, N>], theirs: &[SVector<f64, N>]) -> f64 {
    let size = |k: usize| theirs[k].amax();
    let last = theirs.len() - 1;
    let reach = (1..=last)
        .map(|k| (size(0) / size(k)).powf(1.0 / k as f64))
        .fold(f64::INFINITY, f64::min);
    let term = |k: usize| reach.powi(k as i32);
    let scale = (0..=last).map(|k| size(k) * term(k)).fold(0.0, f64::max);
    (0..=last)
        .map(|k| (ours[k] - theirs[k]).amax() * term(k) / scale)
        .fold(0.0, f64::max)
}
