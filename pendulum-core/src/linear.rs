//! Small systems of linear equations, real and complex, solved on the stack.

use core::ops::{Add, Mul, Neg, Sub};

use nalgebra::{SMatrix, SVector};

use crate::cost::Operations;
use crate::real::Float;

/// The numbers of a linear system: a [`Float`], or a [`Complex`] over it.
pub(crate) trait Field:
    Copy + Default + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// The type of sizes.
    type Size: Float;

    /// The operations of a sum or difference.
    const SUM: Operations;

    /// Those of a product.
    const PRODUCT: Operations;

    /// Those of [`size`](Self::size).
    const SIZE: Operations;

    /// Those of [`reciprocal`](Self::reciprocal).
    const RECIPROCAL: Operations;

    /// How large the number is, for the choice of a pivot: `|re| + |im|`, which takes no root.
    fn size(self) -> Self::Size;

    /// One over the number; not finite or zero where that is beyond the range of the type.
    fn reciprocal(self) -> Self;
}

impl<T: Float> Field for T {
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
}

/// A complex number over any [`Float`]: that of nalgebra, which is public elsewhere, needs more of its numbers.
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

/// A matrix in triangular factors, `P A = L U`.
///
/// Gaussian elimination with partial pivoting (G. H. Golub, C. F. Van Loan, "Matrix Computations", 4th ed., 3.4), made
/// for the few rows that the state of a mechanism has: all of it is in arrays whose length the compiler knows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lu<F, const N: usize> {
    /// By columns: `L` below the diagonal, whose ones are left out, the reciprocals of the pivots on it, and `U` above.
    factors: [[F; N]; N],
    /// The row of the matrix that each row of the factors was.
    rows: [usize; N],
}

/// The matrix has no inverse that numbers of its type can hold, or an entry that is not finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Singular;

impl<F: Field, const N: usize> Lu<F, N> {
    /// Factors a matrix, which is given by its columns.
    ///
    /// # Errors
    /// If a pivot is zero, not finite, or so small or large that its reciprocal is beyond the range of the type.
    #[inline(always)]
    pub(crate) fn new(columns: [[F; N]; N]) -> Result<Self, Singular> {
        let mut a = columns;
        let mut rows = core::array::from_fn(|i| i);
        let mut is_regular = true;
        for k in 0..N {
            // One row after the other moves up if it is larger. The indices are constants where the loops are short
            // enough to be unrolled; the factors then stay in registers.
            for i in k + 1..N {
                if a[k][i].size() > a[k][k].size() {
                    a.iter_mut().for_each(|column| column.swap(k, i));
                    rows.swap(k, i);
                }
            }
            let over_pivot = a[k][k].reciprocal();
            let size = over_pivot.size();
            is_regular &= size.is_finite() && size > F::Size::default();
            a[k][k] = over_pivot;
            for entry in &mut a[k][k + 1..] {
                *entry = *entry * over_pivot;
            }
            for j in k + 1..N {
                for i in k + 1..N {
                    a[j][i] = a[j][i] - a[k][i] * a[j][k];
                }
            }
        }
        // A number that is not finite spreads to a pivot of a later column at the latest.
        if is_regular {
            Ok(Self { factors: a, rows })
        } else {
            Err(Singular)
        }
    }

    /// The `x` of `A x = b`.
    #[inline]
    #[must_use]
    pub(crate) fn solve(&self, b: &[F; N]) -> [F; N] {
        let mut x = self.rows.map(|row| b[row]);
        for k in 0..N {
            for i in k + 1..N {
                x[i] = x[i] - self.factors[k][i] * x[k];
            }
        }
        for k in (0..N).rev() {
            x[k] = x[k] * self.factors[k][k];
            for i in 0..k {
                x[i] = x[i] - self.factors[k][i] * x[k];
            }
        }
        x
    }
}

/// The operations of [`Lu::new`] for `n` rows.
pub(crate) const fn factoring<F: Field>(n: usize) -> Operations {
    let mut operations = Operations::ZERO;
    let mut below = n;
    while below > 0 {
        below -= 1;
        let pivot = F::SIZE.times(2 * below + 1).and(F::RECIPROCAL);
        let multipliers = F::PRODUCT.times(below).with_chain(F::PRODUCT.chain);
        let term = F::PRODUCT.and(F::SUM);
        let rest = term.times(below * below).with_chain(term.chain);
        operations = operations.and(pivot).and(multipliers).and(rest);
    }
    operations
}

/// The operations of [`Lu::solve`] for `n` rows.
pub(crate) const fn solving<F: Field>(n: usize) -> Operations {
    let term = F::PRODUCT.and(F::SUM);
    let operations = term.times(n * n.saturating_sub(1)).and(F::PRODUCT.times(n));
    operations.with_chain((2 * term.chain + F::PRODUCT.chain) * n)
}

/// The product of a matrix and a vector; nalgebra's requires more of its numbers than a [`Float`] has.
#[inline]
pub(crate) fn image<T: Float, const N: usize>(matrix: &SMatrix<T, N, N>, vector: &SVector<T, N>) -> SVector<T, N> {
    let mut image = [T::default(); N];
    for (column, &factor) in matrix.data.0.iter().zip(vector.iter()) {
        for (image, &entry) in image.iter_mut().zip(column) {
            *image += entry * factor;
        }
    }
    SVector::from(image)
}

/// The square of the length of a vector.
#[inline]
pub(crate) fn square<T: Float, const N: usize>(vector: &SVector<T, N>) -> T {
    vector.iter().fold(T::default(), |sum, &v| sum + v * v)
}

#[cfg(test)]
mod tests {
    use super::{Complex, Field, Lu, Singular};
    use crate::real::Float;

    /// Numbers between -1 and 1 without a pattern.
    fn noise(seed: &mut u64) -> f64 {
        *seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn product<F: Field, const N: usize>(columns: &[[F; N]; N], x: &[F; N]) -> [F; N] {
        let term = |i: usize, j: usize| columns[j][i] * x[j];
        core::array::from_fn(|i| (0..N).fold(F::default(), |sum, j| sum + term(i, j)))
    }

    /// The largest error of `solve(A x)` in ulps, over a number of random matrices.
    fn error<F: Field, const N: usize>(mut entry: impl FnMut() -> F) -> f64 {
        let mut worst = 0.0_f64;
        for _ in 0..200 {
            let columns: [[F; N]; N] = core::array::from_fn(|_| core::array::from_fn(|_| entry()));
            let x = core::array::from_fn(|_| entry());
            let lu = Lu::new(columns).expect("regular");
            // A residual, since an error of x grows with the condition of the matrix and this one does not.
            let residual = product(&columns, &lu.solve(&product(&columns, &x)));
            let error = |(a, b): (F, F)| (a - b).size().to_f64() / F::Size::EPSILON.to_f64();
            worst = core::iter::zip(residual, product(&columns, &x))
                .map(error)
                .fold(worst, f64::max);
        }
        worst
    }

    #[test]
    fn a_solution_fulfils_its_equations() {
        let mut seed = 1;
        let mut real = || noise(&mut seed);
        assert!(error::<f64, 1>(&mut real) < 2.0);
        assert!(error::<f64, 4>(&mut real) < 200.0);
        assert!(error::<f64, 14>(&mut real) < 2000.0);
        assert!(error::<f32, 6>(|| real() as f32) < 500.0);
        assert!(error::<Complex<f64>, 4>(|| Complex::new(real(), real())) < 500.0);
        assert!(error::<Complex<f64>, 12>(|| Complex::new(real(), real())) < 2000.0);
    }

    #[test]
    fn a_zero_on_the_diagonal_is_no_obstacle() {
        let lu = Lu::new([[0.0, 0.0, 2.0], [1.0, 0.0, 0.0], [0.0, 4.0, 0.0]]).expect("a permutation");
        assert_eq!(lu.solve(&[1.0, 2.0, 3.0]), [1.5, 1.0, 0.5]);
    }

    #[test]
    fn the_largest_pivot_is_taken() {
        // With the small pivot x_0 would be 0, not 1: Golub and Van Loan, 3.3.
        let lu = Lu::new([[1e-20, 1.0], [1.0, 1.0]]).expect("regular");
        assert_eq!(lu.solve(&[1.0, 2.0]), [1.0, 1.0]);
        let i = Complex::new(0.0, 1.0);
        let one = Complex::new(1.0, 0.0);
        let lu = Lu::new([[Complex::new(1e-20, 0.0), i], [one, one]]).expect("regular");
        // x = (1, 1) to 20 digits: b = A (1, 1)
        assert_eq!(lu.solve(&[one, one + i]), [one, one]);
    }

    #[test]
    fn singular_matrices_are_refused() {
        assert_eq!(Lu::new([[1.0, 2.0], [2.0, 4.0]]).err(), Some(Singular));
        assert_eq!(Lu::new([[0.0]]).err(), Some(Singular));
        let (one, i) = (Complex::new(1.0, 0.0), Complex::new(0.0, 1.0));
        assert_eq!(Lu::new([[one, i], [i, -one]]).err(), Some(Singular));
    }

    #[test]
    fn entries_that_are_not_finite_are_refused_wherever_they_are() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for place in 0..9 {
                let mut columns = [[4.0, 1.0, 0.0], [0.0, 3.0, 1.0], [2.0, 0.0, 5.0]];
                columns[place / 3][place % 3] = bad;
                assert_eq!(Lu::new(columns).err(), Some(Singular), "{bad} at {place}");
            }
        }
    }
}
