//! Numbers that record the operations on them.

use core::cell::Cell;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::recording::{Operation, Place, record};
use crate::dual::over;
use crate::real::Real;
use crate::real::lanes::Routine;

/// A value at the start of a series, and the place of the row that computes the other coefficients. Comparisons are
/// those of the values.
#[derive(Clone, Copy, Debug)]
pub(super) struct Recorded<T> {
    pub(super) value: T,
    /// `None` for constants.
    pub(super) place: Option<Place>,
}

impl<T: Real> Recorded<T> {
    #[inline(always)]
    fn constant(value: T) -> Self {
        Self { value, place: None }
    }

    /// A number whose coefficients are set from outside.
    #[inline(always)]
    pub(super) fn given(value: T) -> Self {
        Self::result(Operation::Given, value)
    }

    /// Result of an operation without a factor.
    #[inline(always)]
    fn result(operation: Operation, value: T) -> Self {
        Self::with_factor(operation, value, T::from_f64(1.0))
    }

    #[inline(always)]
    fn with_factor(operation: Operation, value: T, factor: T) -> Self {
        let place = Some(record(operation, &value, &factor));
        Self { value, place }
    }

    /// Result of an operation on one number. `value` is the result at the start, and `rows` records the rest.
    #[inline(always)]
    fn of_one(self, value: T, rows: impl FnOnce(Place) -> Self) -> Self {
        self.place.map_or(Self::constant(value), rows)
    }

    /// Slope of the number in row `a`.
    #[inline(always)]
    fn slope(a: Place) -> Place {
        record(Operation::Slope(a), &T::default(), &T::default())
    }

    /// The number that [`slope`](Self::slope) records.
    #[inline(always)]
    fn of_slope(self) -> Self {
        Self {
            value: T::default(),
            place: self.place.map(Self::slope),
        }
    }

    /// Product with a constant.
    #[inline(always)]
    fn times(self, factor: T) -> Self {
        let value = self.value * factor;
        self.of_one(value, |a| Self::with_factor(Operation::Scale(a), value, factor))
    }

    /// A number of another value, with the other coefficients of the sum of both numbers.
    #[inline(always)]
    fn sum(self, other: Self, value: T) -> Self {
        match (self.place, other.place) {
            (None, None) => Self::constant(value),
            (Some(a), None) | (None, Some(a)) => Self::result(Operation::Shift(a), value),
            (Some(a), Some(b)) => Self::result(Operation::Add(a, b), value),
        }
    }

    /// A function whose derivative is a sum with its square, in one row after that of the square.
    #[inline(always)]
    fn by_its_square(self, value: T, derivative: impl FnOnce(Self) -> Self) -> Self {
        self.of_one(value, |a| {
            let slope = Self::slope(a);
            let result = Self::result(Operation::Chain(slope, slope + 3), value);
            let _ = derivative(result * result);
            result
        })
    }

    /// Power with a whole exponent of at least 1, by products, which are exact where the base is zero.
    fn power(self, exponent: u32) -> Self {
        let (mut power, mut base, mut exponent) = (None, self, exponent);
        loop {
            if exponent % 2 == 1 {
                power = Some(power.map_or(base, |power| power * base));
            }
            exponent /= 2;
            if exponent == 0 {
                return power.unwrap_or(base);
            }
            base *= base;
        }
    }
}

/// A constant exponent, if it is a whole number, in all lanes.
fn whole<T: Real>(exponent: T) -> Option<i32> {
    let found = Cell::new(None);
    let agrees = Cell::new(exponent.is_constant());
    exponent.piecewise(|exponent| {
        let number = exponent as i32;
        let same = found.get().is_none_or(|found| found == number);
        agrees.set(agrees.get() && same && f64::from(number) == exponent);
        found.set(Some(number));
        [0.0]
    });
    found.get().filter(|_| agrees.get())
}

impl<T: Real> Default for Recorded<T> {
    #[inline(always)]
    fn default() -> Self {
        Self::constant(T::default())
    }
}

impl<T: PartialEq> PartialEq for Recorded<T> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<T: Real> Neg for Recorded<T> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        let value = -self.value;
        self.of_one(value, |a| Self::result(Operation::Neg(a), value))
    }
}

impl<T: Real> Add for Recorded<T> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.sum(other, self.value + other.value)
    }
}

impl<T: Real> Sub for Recorded<T> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let value = self.value - other.value;
        match (self.place, other.place) {
            (None, None) => Self::constant(value),
            (Some(a), None) => Self::result(Operation::Shift(a), value),
            (None, Some(b)) => Self::result(Operation::Neg(b), value),
            (Some(a), Some(b)) => Self::result(Operation::Sub(a, b), value),
        }
    }
}

impl<T: Real> Mul for Recorded<T> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        match (self.place, other.place) {
            (None, None) => Self::constant(value),
            (Some(_), None) => self.times(other.value),
            (None, Some(_)) => other.times(self.value),
            (Some(a), Some(b)) if a == b => Self::result(Operation::Square(a), value),
            (Some(a), Some(b)) => Self::result(Operation::Mul(a, b), value),
        }
    }
}

impl<T: Real> Div for Recorded<T> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let over = T::from_f64(1.0) / other.value;
        match (self.place, other.place) {
            (None, None) => Self::constant(value),
            (Some(a), None) => Self::with_factor(Operation::Scale(a), value, over),
            (None, Some(b)) => Self::with_factor(Operation::Reciprocal(b), value, over),
            (Some(a), Some(b)) => Self::with_factor(Operation::Div(a, b), value, over),
        }
    }
}

macro_rules! assign {
    ($($trait:ident::$assigned:ident = $method:ident;)*) => {$(
        impl<T: Real> $trait for Recorded<T> {
            #[inline(always)]
            fn $assigned(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    )*};
}

assign! {
    AddAssign::add_assign = add;
    SubAssign::sub_assign = sub;
    MulAssign::mul_assign = mul;
    DivAssign::div_assign = div;
}

impl<T: Real> Real for Recorded<T> {
    const LANES: usize = T::LANES;
    const HAS_SLOPES: bool = T::HAS_SLOPES;

    #[inline(always)]
    fn call<A: ?Sized, B: ?Sized, R: Routine<A, B>>(routine: R, changed: &mut A, read: &B) -> R::Output {
        T::call(routine, changed, read)
    }

    #[inline(always)]
    fn from_f64(v: f64) -> Self {
        Self::constant(T::from_f64(v))
    }

    #[inline(always)]
    fn is_constant(&self) -> bool {
        self.place.is_none() && self.value.is_constant()
    }

    #[inline(always)]
    fn is_zero(self) -> bool {
        self.place.is_none() && self.value.is_zero()
    }

    #[inline]
    fn piecewise<const C: usize>(self, piece: impl Fn(f64) -> [f64; C]) -> [Self; C] {
        self.value.piecewise(piece).map(Self::constant)
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        let Some(a) = self.place else {
            return (Self::constant(sin), Self::constant(cos));
        };
        let slope = Self::slope(a);
        // the row of the cosine follows the one of the sine
        let row_of_cos = slope + 2;
        let sine = Self::result(Operation::Chain(slope, row_of_cos), sin);
        let cosine = Self::with_factor(Operation::Chain(slope, slope + 1), cos, T::from_f64(-1.0));
        (sine, cosine)
    }

    #[inline(always)]
    fn tan(self) -> Self {
        self.by_its_square(self.value.tan(), |square| square + Self::from_f64(1.0))
    }

    #[inline(always)]
    fn exp(self) -> Self {
        let value = self.value.exp();
        self.of_one(value, |a| {
            let slope = Self::slope(a);
            Self::result(Operation::Chain(slope, slope + 1), value)
        })
    }

    #[inline(always)]
    fn ln(self) -> Self {
        let value = self.value.ln();
        self.of_one(value, |a| {
            let over = T::from_f64(1.0) / self.value;
            let quotient = record(Operation::Div(Self::slope(a), a), &T::default(), &over);
            Self::result(Operation::Integral(quotient), value)
        })
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        self.of_one(value, |a| {
            Self::with_factor(Operation::Sqrt(a), value, T::from_f64(0.5) / value)
        })
    }

    #[inline(always)]
    fn tanh(self) -> Self {
        self.by_its_square(self.value.tanh(), |square| Self::from_f64(1.0) - square)
    }

    /// Continued smoothly from the start on, and constant where it is zero there.
    #[inline(always)]
    fn abs(self) -> Self {
        let (value, sign) = (self.value.abs(), self.value.signum());
        self.of_one(value, |a| Self::with_factor(Operation::Scale(a), value, sign))
    }

    #[inline(always)]
    fn signum(self) -> Self {
        Self::constant(self.value.signum())
    }

    /// Continued by the number that is larger at the start; by the mean of both where they are equal.
    #[inline(always)]
    fn at_least(self, low: Self) -> Self {
        let larger = over(self.value, low.value);
        let sides = [self.times(larger), low.times(T::from_f64(1.0) - larger)];
        sides[0].sum(sides[1], self.value.at_least(low.value))
    }

    #[inline(always)]
    fn at_most(self, high: Self) -> Self {
        let smaller = over(high.value, self.value);
        let sides = [self.times(smaller), high.times(T::from_f64(1.0) - smaller)];
        sides[0].sum(sides[1], self.value.at_most(high.value))
    }

    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        let value = self.value.atan2(x.value);
        let turn = x * self.of_slope() - self * x.of_slope();
        let slope = turn / (self * self + x * x);
        slope.of_one(value, |slope| Self::result(Operation::Integral(slope), value))
    }

    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        let value = self.value.powf(exponent.value);
        match (self.place, exponent.place) {
            (None, None) => Self::constant(value),
            (Some(a), None) => match whole(exponent.value) {
                Some(0) => Self::constant(value),
                Some(n @ 1..) => self.power(n.unsigned_abs()),
                Some(n) => Self::from_f64(1.0) / self.power(n.unsigned_abs()),
                None => {
                    let slope = Self::slope(a);
                    let power = Self::with_factor(Operation::Chain(slope, slope + 2), value, exponent.value);
                    // its derivative over the exponent, in the second row after the slope
                    let _ = power / self;
                    power
                }
            },
            (_, Some(_)) => {
                let logarithm = exponent * self.ln();
                logarithm.of_one(value, |a| {
                    let slope = Self::slope(a);
                    Self::result(Operation::Chain(slope, slope + 1), value)
                })
            }
        }
    }
}
