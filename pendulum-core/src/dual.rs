//! Dual numbers: values with exact derivatives.

use core::cmp::Ordering;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use nalgebra::SVector;

use crate::method::stage_sums::StageSums;
use crate::real::lanes::{Lanes, Pack, Register, Routine, single_lane};
use crate::real::{Float, Fused, Real};
use crate::taylor::{DualKernel, DualSums};

/// A value with its derivatives with respect to `N` variables, propagated through every operation by the chain rule.
///
/// Code generic over [`Real`] accepts it unchanged, and its values are bit by bit the same as without derivatives.
/// Comparisons are those of the values. Where a function has no derivative, such as [`Real::abs`] at 0, the slopes are
/// limits of the derivative, or zero.
///
/// ```
/// use pendulum_core::dual::Dual;
///
/// let [x, y] = [Dual::variable(3.0, 0), Dual::variable(4.0, 1)];
/// let volume: Dual<f64, 2> = x * x * y;
/// assert_eq!((volume.value, volume.slopes), (36.0, [24.0, 9.0]));
/// ```
///
/// A. Griewank, A. Walther, "Evaluating Derivatives", 2nd ed. (2008), chapter 3.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Dual<T, const N: usize> {
    /// The value.
    pub value: T,
    /// Derivative with respect to each variable.
    pub slopes: [T; N],
}

impl<T: Real, const N: usize> Dual<T, N> {
    /// A number independent of the variables.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub fn constant(value: T) -> Self {
        Self {
            value,
            slopes: [T::default(); N],
        }
    }

    /// The variable with the index `place` among the `N`.
    ///
    /// # Panics
    /// If `place` is not below `N`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub fn variable(value: T, place: usize) -> Self {
        let mut variable = Self::constant(value);
        variable.slopes[place] = T::from_f64(1.0);
        variable
    }

    /// Values and slopes of dual numbers, one after the other, as their representation has them.
    #[allow(unsafe_code, reason = "safe code would copy the numbers")]
    #[inline(always)]
    pub(crate) fn flat(numbers: &[Self]) -> &[T] {
        // SAFETY: by its representation, a dual number is an array of `N + 1` numbers.
        unsafe { core::slice::from_raw_parts(numbers.as_ptr().cast(), (N + 1) * numbers.len()) }
    }

    /// Like [`flat`](Self::flat), for changes.
    #[allow(unsafe_code, reason = "safe code would copy the numbers")]
    #[inline(always)]
    pub(crate) fn flat_mut(numbers: &mut [Self]) -> &mut [T] {
        // SAFETY: by its representation, a dual number is an array of `N + 1` numbers.
        unsafe { core::slice::from_raw_parts_mut(numbers.as_mut_ptr().cast(), (N + 1) * numbers.len()) }
    }

    /// Applies a function of one number, given its value and its derivative there.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn chain(self, value: T, derivative: T) -> Self {
        Self {
            value,
            slopes: T::scale_each(self.slopes, derivative),
        }
    }

    /// Applies a function of two numbers, given its value, and its derivatives with respect to both.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn join(self, other: Self, value: T, [by_self, by_other]: [T; 2]) -> Self {
        let own = T::scale_each(self.slopes, by_self);
        Self {
            value,
            slopes: T::mul_add_each(other.slopes, by_other, own),
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn slopes_of_product(self, other: Self) -> [T; N] {
        T::mul_add_each(other.slopes, self.value, T::scale_each(self.slopes, other.value))
    }
}

/// The components of a state, each as a variable.
#[inline(always)]
pub(crate) fn variables<T: Real, const N: usize>(x: &SVector<T, N>) -> SVector<Dual<T, N>, N> {
    SVector::<Dual<T, N>, N>::from_fn(|n, _| Dual::variable(x[n], n))
}

impl<T: Real, const N: usize> Default for Dual<T, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn default() -> Self {
        Self::constant(T::default())
    }
}

macro_rules! operator {
    ($trait:ident::$method:ident, $assign:ident::$assigned:ident, |$a:ident, $b:ident| $slopes:expr) => {
        impl<T: Real, const N: usize> $trait for Dual<T, N> {
            type Output = Self;

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $method(self, other: Self) -> Self {
                let ($a, $b) = (self, other);
                Self {
                    value: $trait::$method(self.value, other.value),
                    slopes: $slopes,
                }
            }
        }

        impl<T: Real, const N: usize> $assign for Dual<T, N> {
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $assigned(&mut self, other: Self) {
                *self = $trait::$method(*self, other);
            }
        }
    };
}

operator! { Add::add, AddAssign::add_assign, |a, b| T::add_each(a.slopes, b.slopes) }
operator! { Sub::sub, SubAssign::sub_assign, |a, b| T::subtract_each(a.slopes, b.slopes) }
operator! { Mul::mul, MulAssign::mul_assign, |a, b| a.slopes_of_product(b) }

impl<T: Real, const N: usize> Div for Dual<T, N> {
    type Output = Self;

    /// One more division in place of one for each variable.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn div(self, other: Self) -> Self {
        let (value, over) = (self.value / other.value, T::from_f64(1.0) / other.value);
        let change = T::subtract_each(self.slopes, T::scale_each(other.slopes, value));
        Self {
            value,
            slopes: T::scale_each(change, over),
        }
    }
}

impl<T: Real, const N: usize> DivAssign for Dual<T, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn div_assign(&mut self, other: Self) {
        *self = *self / other;
    }
}

impl<T: Real, const N: usize> Neg for Dual<T, N> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn neg(mut self) -> Self {
        self.value = -self.value;
        for slope in &mut self.slopes {
            *slope = -*slope;
        }
        self
    }
}

impl<T: Real, const N: usize> Real for Dual<T, N> {
    const LANES: usize = T::LANES;
    const HAS_SLOPES: bool = true;
    const SUMS_WIDE: bool = Self::TAKEN_APART && T::LANES == 1;
    const TAKEN_APART: bool = N > 0 && T::IS_PLAIN;

    #[inline(always)]
    fn call<A: ?Sized, B: ?Sized, R: Routine<A, B>>(routine: R, changed: &mut A, read: &B) -> R::Output {
        T::call(routine, changed, read)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn from_f64(v: f64) -> Self {
        Self::constant(T::from_f64(v))
    }

    #[inline]
    fn piecewise<const C: usize>(self, piece: impl Fn(f64) -> [f64; C]) -> [Self; C] {
        self.value.piecewise(piece).map(Self::constant)
    }

    #[inline]
    fn piecewise_by_lane<const C: usize>(self, piece: impl Fn(usize, f64) -> [f64; C]) -> [Self; C] {
        self.value.piecewise_by_lane(piece).map(Self::constant)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn as_variable(mut self, place: usize) -> Self {
        self.slopes[place] = T::from_f64(1.0);
        self
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn ratio_of_slopes<const M: usize>(
        [rtol, atol]: [Self; 2],
        v: &[Self; M],
        [x0, x1]: [&[Self; M]; 2],
    ) -> Option<Self> {
        if rtol.is_constant() {
            return None;
        }
        let mut largest = T::default();
        for n in 0..N {
            let mut sizes = [T::default(); 3];
            for (size, vector) in sizes.iter_mut().zip([v, x0, x1]) {
                for component in vector {
                    *size += component.slopes[n].abs();
                }
            }
            let [change, before, after] = sizes;
            largest = largest.at_least(change / (atol.value + rtol.slopes[n] * before.at_least(after)));
        }
        Some(Self::constant(largest))
    }

    #[inline]
    fn with_own_slopes(self) -> Self {
        Self {
            value: self.value,
            slopes: [self.value; N],
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_constant(&self) -> bool {
        let mut sum = T::default();
        for slope in self.slopes {
            sum += slope.abs();
        }
        sum.is_zero()
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_zero(self) -> bool {
        self.value.is_zero() && self.is_constant()
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn mul_add(self, a: Self, b: Self) -> Self {
        Self {
            value: self.value.mul_add(a.value, b.value),
            slopes: T::add_each(self.slopes_of_product(a), b.slopes),
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn mul_sub(self, a: Self, b: Self) -> Self {
        Self {
            value: self.value.mul_sub(a.value, b.value),
            slopes: T::subtract_each(self.slopes_of_product(a), b.slopes),
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn mul_neg_add(self, a: Self, b: Self) -> Self {
        Self {
            value: self.value.mul_neg_add(a.value, b.value),
            slopes: T::subtract_each(b.slopes, self.slopes_of_product(a)),
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn scaled(self, factor: Self) -> Self {
        self.chain(factor.value * self.value, factor.value)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn scaled_onto(self, factor: Self, sum: Self) -> Self {
        Self {
            value: self.value.mul_add(factor.value, sum.value),
            slopes: T::mul_add_each(self.slopes, factor.value, sum.slopes),
        }
    }

    #[inline(always)]
    fn sum_products<const M: usize>(left: &[[Self; M]], right: &[[Self; M]], sums: &mut [Self; M]) {
        T::run_wide(DualSums { left, right, sums });
    }

    #[inline(always)]
    fn sum_stages<const M: usize>(
        (h, weights): (Self, &[f64]),
        stages: &[SVector<Self, M>],
        start: Option<&SVector<Self, M>>,
        sums: &mut SVector<Self, M>,
    ) {
        T::run_wide(StageSums {
            h: h.value,
            weights,
            stages,
            start,
            sums,
        });
    }

    #[inline(always)]
    fn take_apart<K: DualKernel<Self>>(kernel: K) {
        if const { Self::TAKEN_APART } {
            kernel.run(|number| number, |number| number);
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn without_slopes(self) -> Self {
        Self::constant(self.value)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sin_cos_pair(self, other: Self) -> [(Self, Self); 2] {
        let [(s, c), (other_s, other_c)] = self.value.sin_cos_pair(other.value);
        [
            (self.chain(s, c), self.chain(c, -s)),
            (other.chain(other_s, other_c), other.chain(other_c, -other_s)),
        ]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn tan(self) -> Self {
        let tan = self.value.tan();
        self.chain(tan, T::from_f64(1.0) + tan * tan)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn exp(self) -> Self {
        let exp = self.value.exp();
        self.chain(exp, exp)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn ln(self) -> Self {
        self.chain(self.value.ln(), T::from_f64(1.0) / self.value)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sqrt(self) -> Self {
        let (one, half, sqrt) = (T::from_f64(1.0), T::from_f64(0.5), self.value.sqrt());
        let mut root = Self::constant(sqrt);
        for (slope, own) in root.slopes.iter_mut().zip(self.slopes) {
            // where the root is zero, what does not vary must not be multiplied by infinity
            let varies = own.signum() * own.signum();
            *slope = half / (sqrt + (one - varies)) * own;
        }
        root
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn tanh(self) -> Self {
        let tanh = self.value.tanh();
        self.chain(tanh, T::from_f64(1.0) - tanh * tanh)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn abs(self) -> Self {
        self.chain(self.value.abs(), self.value.signum())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn signum(self) -> Self {
        Self::constant(self.value.signum())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn at_least(self, low: Self) -> Self {
        let larger = over(self.value, low.value);
        let other = T::from_f64(1.0) - larger;
        self.join(low, self.value.at_least(low.value), [larger, other])
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn at_most(self, high: Self) -> Self {
        let smaller = over(high.value, self.value);
        let other = T::from_f64(1.0) - smaller;
        self.join(high, self.value.at_most(high.value), [smaller, other])
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn atan2(self, x: Self) -> Self {
        let (a, b) = (self.value, x.value);
        let over = T::from_f64(1.0) / (a * a + b * b);
        self.join(x, a.atan2(b), [b * over, -a * over])
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn powf(self, exponent: Self) -> Self {
        let (a, b) = (self.value, exponent.value);
        let by_base = b * a.powf(b - T::from_f64(1.0));
        let value = a.powf(b);
        Self {
            value,
            slopes: core::array::from_fn(|n| {
                let [da, db] = [self.slopes[n], exponent.slopes[n]];
                // a constant exponent must not multiply the logarithm of a negative base: use that of a^0 = 1 instead
                let varies = db.signum() * db.signum();
                by_base * da + value * a.powf(varies).ln() * db
            }),
        }
    }
}

impl<T: PartialEq, const N: usize> PartialEq for Dual<T, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<T: PartialOrd, const N: usize> PartialOrd for Dual<T, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

/// Points, in fractions of the reach, of a difference of fourth order, and their weights.
const STENCIL: [(f64, f64); 4] = [(-2.0, 1.0), (-1.0, -8.0), (1.0, 8.0), (2.0, -1.0)];
/// Spacing of the points relative to the reach.
const SPACING: f64 = 1e-3;
/// Least change of a function from point to point, relative to its largest value there, for which it passes its zero
/// instead of touching it.
const TOUCHING: f64 = 1e-6;

macro_rules! float {
    ($float:ty, $zero:expr) => {
        /// A single lane.
        impl<const N: usize> Lanes for Dual<$float, N> {
            single_lane!();
            type Double = Self;

            #[inline]
            fn all_finite(self) -> bool {
                Float::is_finite(self)
            }

            #[inline]
            fn select(self, negative: Self, otherwise: Self) -> Self {
                if self.value.to_f64().is_sign_negative() {
                    negative
                } else {
                    otherwise
                }
            }
        }

        /// Decisions depend on the values alone, so that an integration takes the same steps as without derivatives.
        impl<const N: usize> Float for Dual<$float, N> {
            const EPSILON: Self = Self {
                value: <$float as Float>::EPSILON,
                slopes: [$zero; N],
            };
            const MIN_POSITIVE: Self = Self {
                value: <$float as Float>::MIN_POSITIVE,
                slopes: [$zero; N],
            };

            #[inline]
            fn to_f64(self) -> f64 {
                self.value.to_f64()
            }

            /// True if the value and all derivatives are finite.
            #[inline]
            fn is_finite(self) -> bool {
                Float::is_finite(self.value) && self.slopes.iter().all(|slope| Float::is_finite(*slope))
            }

            #[inline]
            fn max(self, other: Self) -> Self {
                if self.value >= other.value || other.value.to_f64().is_nan() {
                    self
                } else {
                    other
                }
            }

            #[inline]
            fn min(self, other: Self) -> Self {
                if self.value <= other.value || other.value.to_f64().is_nan() {
                    self
                } else {
                    other
                }
            }

            /// The zero follows its function: `dz = -df / f'`, with `f'` by a difference of fourth order. Where the
            /// function only touches zero, the derivatives do not exist: NaN.
            fn zero_of(self, reach: Self, function: impl Fn(Self) -> Self) -> Self {
                let spacing = <$float>::from_f64(SPACING) * reach.value;
                let at = |steps: f64| Self::constant(self.value + <$float>::from_f64(steps) * spacing);
                let (mut change, mut largest) = ($zero, $zero);
                for (steps, weight) in STENCIL {
                    let value = function(at(steps)).value;
                    change += <$float>::from_f64(weight / 12.0) * value;
                    largest = Float::max(largest, Real::abs(value));
                }
                let touches = Real::abs(change) <= <$float>::from_f64(TOUCHING) * largest;
                let slope = if touches {
                    <$float>::from_f64(f64::NAN)
                } else {
                    change / spacing
                };
                let residual = function(at(0.0));
                Self {
                    value: self.value,
                    slopes: residual.slopes.map(|own| -own / slope),
                }
            }

            #[inline]
            fn largest_slope(&self) -> f64 {
                let slopes = self.slopes.iter().map(|slope| Real::abs(*slope).to_f64());
                slopes.fold(0.0, |largest, slope| {
                    if slope > largest || slope.is_nan() {
                        slope
                    } else {
                        largest
                    }
                })
            }

            #[inline]
            fn has_same_slopes(&self, other: &Self) -> bool {
                self.slopes == other.slopes
            }
        }
    };
}

float!(f64, 0.0);
float!(f32, 0.0);
float!(Fused<f64>, Fused(0.0));

/// The lanes of the values and of the derivatives.
impl<R: Register, const N: usize> Lanes for Dual<Pack<R>, N>
where
    Dual<R::Scalar, N>: Float,
{
    type Scalar = Dual<R::Scalar, N>;
    /// Registers are full without interleaving.
    type Double = Self;

    #[inline(always)]
    fn splat(v: Self::Scalar) -> Self {
        let mut splat = Self::constant(Pack::splat(v.value));
        for (splat, slope) in splat.slopes.iter_mut().zip(v.slopes) {
            *splat = Pack::splat(slope);
        }
        splat
    }

    #[inline(always)]
    fn from_fn(mut f: impl FnMut(usize) -> Self::Scalar) -> Self {
        let mut lanes = Self::constant(Pack::from_fn(|lane| f(lane).value));
        for (n, slope) in lanes.slopes.iter_mut().enumerate() {
            *slope = Pack::from_fn(|lane| f(lane).slopes[n]);
        }
        lanes
    }

    #[inline(always)]
    fn lane(&self, i: usize) -> Self::Scalar {
        let mut lane = Dual {
            value: self.value.lane(i),
            slopes: [R::Scalar::default(); N],
        };
        for (lane, slope) in lane.slopes.iter_mut().zip(&self.slopes) {
            *lane = slope.lane(i);
        }
        lane
    }

    #[inline(always)]
    fn all_finite(self) -> bool {
        let mut sum = self.value;
        for slope in self.slopes {
            sum += slope;
        }
        sum.all_finite()
    }

    #[inline(always)]
    fn select(self, negative: Self, otherwise: Self) -> Self {
        let mut selected = Self::constant(self.value.select(negative.value, otherwise.value));
        for n in 0..N {
            selected.slopes[n] = self.value.select(negative.slopes[n], otherwise.slopes[n]);
        }
        selected
    }
}

/// 1 if `a` is larger, 0 if `b` is, and 1/2 if they are equal.
pub(crate) fn over<T: Real>(a: T, b: T) -> T {
    T::from_f64(0.5) + T::from_f64(0.5) * (a - b).signum()
}

#[cfg(test)]
mod tests {
    use super::Dual;
    use crate::real::Real;

    /// A function in two number types, since closures cannot be generic.
    struct Function {
        name: &'static str,
        of_floats: fn(f64, f64) -> f64,
        of_duals: fn(Dual<f64, 2>, Dual<f64, 2>) -> Dual<f64, 2>,
    }

    macro_rules! functions {
        ($(|$x:ident, $y:ident| $f:expr),* $(,)?) => {
            [$(Function { name: stringify!($f), of_floats: |$x, $y| $f, of_duals: |$x, $y| $f }),*]
        };
    }

    #[test]
    fn slopes_are_the_derivatives_and_values_the_same_bits() {
        let functions = functions![
            |x, y| x + y,
            |x, y| x - y,
            |x, y| x * y,
            |x, y| x / y,
            |x, y| -x * y,
            |x, y| Real::sin_cos(x * y).0,
            |x, y| Real::sin_cos(x * y).1,
            |x, y| Real::tan(x * y),
            |x, y| Real::exp(x * y),
            |x, y| Real::ln(x * y),
            |x, y| Real::sqrt(x * y),
            |x, y| Real::tanh(x * y),
            |x, y| Real::abs(-x * y),
            |x, y| Real::signum(x * y),
            |x, y| Real::at_least(x, y),
            |x, y| Real::at_least(y, x),
            |x, y| Real::at_most(x, y),
            |x, y| Real::at_most(y, x),
            |x, y| Real::atan2(x, y),
            |x, y| Real::atan2(-x, -y),
            |x, y| Real::powf(x, y),
        ];
        let (x, y, reach) = (0.6, 0.9, 1e-5);
        for Function {
            name,
            of_floats,
            of_duals,
        } in functions
        {
            let dual = of_duals(Dual::variable(x, 0), Dual::variable(y, 1));
            assert_eq!(dual.value, of_floats(x, y), "{name}");
            let differences = [
                of_floats(x + reach, y) - of_floats(x - reach, y),
                of_floats(x, y + reach) - of_floats(x, y - reach),
            ];
            for (slope, difference) in dual.slopes.into_iter().zip(differences) {
                assert!((slope - difference / (2.0 * reach)).abs() < 1e-9, "{name}: {slope}");
            }
        }
    }

    #[test]
    fn assignments_are_the_operators() {
        let (x, y): (Dual<f64, 2>, _) = (Dual::variable(0.7, 0), Dual::variable(1.3, 1));
        let mut z = x;
        z += y;
        z *= y;
        z -= x;
        z /= y;
        assert_eq!(z, ((x + y) * y - x) / y);
    }

    #[test]
    fn a_negative_base_has_a_slope_by_whole_exponents() {
        let cube = Dual::<f64, 1>::variable(-2.0, 0).powf(Dual::from_f64(3.0));
        assert_eq!((cube.value, cube.slopes), (-8.0, [12.0]));
    }
}
