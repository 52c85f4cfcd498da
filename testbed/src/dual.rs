//! Dual numbers: a value with one exact derivative. Generated code runs on them like on any `Real`, so its Jacobian can
//! be checked to the last digits without finite differences.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use pendulum_core::real::Real;

/// `value + slope e` with `e^2 = 0`. Dual numbers over dual numbers have a second derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dual<T = f64> {
    pub value: T,
    pub slope: T,
}

impl<T: Real> Dual<T> {
    pub fn new(value: T, slope: T) -> Self {
        Self { value, slope }
    }

    fn chain(self, value: T, derivative: T) -> Self {
        Self::new(value, derivative * self.slope)
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $assign:ident, $assigned:ident, |$a:ident, $b:ident| $value:expr, $slope:expr) => {
        impl<T: Real> $trait for Dual<T> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                let ($a, $b) = (self, other);
                Self::new($value, $slope)
            }
        }
        impl<T: Real> $assign for Dual<T> {
            fn $assigned(&mut self, other: Self) {
                *self = $trait::$method(*self, other);
            }
        }
    };
}

operator!(
    Add,
    add,
    AddAssign,
    add_assign,
    |a, b| a.value + b.value,
    a.slope + b.slope
);
operator!(
    Sub,
    sub,
    SubAssign,
    sub_assign,
    |a, b| a.value - b.value,
    a.slope - b.slope
);
operator!(
    Mul,
    mul,
    MulAssign,
    mul_assign,
    |a, b| a.value * b.value,
    a.slope * b.value + a.value * b.slope
);
operator!(
    Div,
    div,
    DivAssign,
    div_assign,
    |a, b| a.value / b.value,
    (a.slope - a.value / b.value * b.slope) / b.value
);

impl<T: Real> Neg for Dual<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.value, -self.slope)
    }
}

/// Derivative of `max(a, b)` by `a`: 1 if `a` is larger, 0 if `b` is, 1/2 if they are equal.
fn over<T: Real>(a: T, b: T) -> T {
    T::from_f64(0.5) + T::from_f64(0.5) * (a - b).signum()
}

impl<T: Real> Real for Dual<T> {
    fn from_f64(v: f64) -> Self {
        Self::new(T::from_f64(v), T::default())
    }
    fn piecewise<const C: usize>(self, piece: impl Fn(f64) -> [f64; C]) -> [Self; C] {
        self.value
            .piecewise(piece)
            .map(|coefficient| Self::new(coefficient, T::default()))
    }
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.value.sin_cos();
        (self.chain(s, c), self.chain(c, -s))
    }
    fn tan(self) -> Self {
        let t = self.value.tan();
        self.chain(t, T::from_f64(1.0) + t * t)
    }
    fn exp(self) -> Self {
        let e = self.value.exp();
        self.chain(e, e)
    }
    fn ln(self) -> Self {
        self.chain(self.value.ln(), T::from_f64(1.0) / self.value)
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, T::from_f64(0.5) / root)
    }
    fn tanh(self) -> Self {
        let t = self.value.tanh();
        self.chain(t, T::from_f64(1.0) - t * t)
    }
    fn abs(self) -> Self {
        self.chain(self.value.abs(), self.value.signum())
    }
    fn signum(self) -> Self {
        self.chain(self.value.signum(), T::default())
    }
    fn at_least(self, low: Self) -> Self {
        let larger = over(self.value, low.value);
        let slope = larger * self.slope + (T::from_f64(1.0) - larger) * low.slope;
        Self::new(self.value.at_least(low.value), slope)
    }
    fn at_most(self, high: Self) -> Self {
        -(-self).at_least(-high)
    }
    fn atan2(self, x: Self) -> Self {
        let norm2 = self.value * self.value + x.value * x.value;
        Self::new(
            self.value.atan2(x.value),
            (x.value * self.slope - self.value * x.slope) / norm2,
        )
    }
    fn powf(self, exponent: Self) -> Self {
        assert_eq!(exponent.slope, T::default(), "generated code has constant exponents");
        let n = exponent.value;
        self.chain(self.value.powf(n), n * self.value.powf(n - T::from_f64(1.0)))
    }
}
