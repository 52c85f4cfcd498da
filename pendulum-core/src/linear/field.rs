//! Number types of linear systems.

use core::ops::{Add, Mul, Neg, Sub};

use crate::cost::Operations;
use crate::real::Float;
use crate::real::lanes::Lanes;

/// Number type of a linear system: a [`Float`], [`Lanes`], or a [`Complex`] number.
pub(crate) trait Field:
    Copy + Default + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// Type of [`size`](Self::size).
    type Size: Lanes;

    /// Operations of a sum or difference.
    const SUM: Operations;

    /// Operations of a product.
    const PRODUCT: Operations;

    /// Operations of [`size`](Self::size).
    const SIZE: Operations;

    /// Operations of [`reciprocal`](Self::reciprocal).
    const RECIPROCAL: Operations;

    /// Magnitude for the choice of a pivot. For complex numbers `|re| + |im|`, which needs no square root.
    fn size(self) -> Self::Size;

    /// Reciprocal; zero or not finite if it is out of the range of the type.
    fn reciprocal(self) -> Self;

    /// `self - a * b`.
    #[inline(always)]
    fn minus_product(self, a: Self, b: Self) -> Self {
        self - a * b
    }
}

impl<T: Lanes> Field for T {
    type Size = T;
    const SUM: Operations = Operations::new(1, 0, 0, 0, 0, 1);
    const PRODUCT: Operations = Operations::new(0, 1, 0, 0, 0, 1);
    const SIZE: Operations = Operations::new(0, 0, 0, 0, 1, 10);
    const RECIPROCAL: Operations = Operations::new(0, 0, 1, 0, 0, 4);

    #[inline]
    fn size(self) -> T {
        self.abs()
    }

    #[inline]
    fn reciprocal(self) -> T {
        T::from_f64(1.0) / self
    }

    #[inline(always)]
    fn minus_product(self, a: T, b: T) -> T {
        a.mul_neg_add(b, self)
    }
}

/// A complex number over any [`Float`]. The type of nalgebra requires more traits of its components.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Complex<T> {
    /// The real part.
    pub(crate) re: T,
    /// The imaginary part.
    pub(crate) im: T,
}

impl<T> Complex<T> {
    /// `re + i im`.
    #[inline]
    pub(crate) const fn new(re: T, im: T) -> Self {
        Self { re, im }
    }
}

impl<T: Float> Add for Complex<T> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl<T: Float> Sub for Complex<T> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl<T: Float> Mul for Complex<T> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.re * other.re - self.im * other.im,
            self.re * other.im + self.im * other.re,
        )
    }
}

impl<T: Float> Neg for Complex<T> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.re, -self.im)
    }
}

impl<T: Float> Field for Complex<T> {
    type Size = T;
    const SUM: Operations = Operations::new(2, 0, 0, 0, 0, 1);
    const PRODUCT: Operations = Operations::new(2, 4, 0, 0, 0, 2);
    const SIZE: Operations = Operations::new(1, 0, 0, 0, 2, 11);
    const RECIPROCAL: Operations = Operations::new(2, 4, 1, 0, 0, 7);

    #[inline]
    fn size(self) -> T {
        self.re.abs() + self.im.abs()
    }

    #[inline]
    fn reciprocal(self) -> Self {
        let over_square = T::from_f64(1.0) / (self.re * self.re + self.im * self.im);
        Self::new(self.re * over_square, -self.im * over_square)
    }
}
