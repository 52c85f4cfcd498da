//! Products of small matrices, column by column, so that the compiler puts them into vector registers.

use nalgebra::SMatrix;

use crate::real::Real;

/// `sum + a b`.
#[inline(always)]
pub(super) fn plus_product<T: Real, const R: usize, const S: usize, const C: usize>(
    mut sum: SMatrix<T, R, C>,
    a: &SMatrix<T, R, S>,
    b: &SMatrix<T, S, C>,
) -> SMatrix<T, R, C> {
    for j in 0..C {
        let mut column = sum.data.0[j];
        for k in 0..S {
            let factor = b.data.0[j][k];
            for (i, entry) in column.iter_mut().enumerate() {
                *entry = a.data.0[k][i].mul_add(factor, *entry);
            }
        }
        sum.data.0[j] = column;
    }
    sum
}

/// `a b`.
#[inline(always)]
pub(super) fn product<T: Real, const R: usize, const S: usize, const C: usize>(
    a: &SMatrix<T, R, S>,
    b: &SMatrix<T, S, C>,
) -> SMatrix<T, R, C> {
    plus_product(zeros(), a, b)
}

/// Transpose of a matrix.
#[inline(always)]
pub(super) fn transposed<T: Real, const R: usize, const C: usize>(a: &SMatrix<T, R, C>) -> SMatrix<T, C, R> {
    let mut mirrored = zeros();
    for j in 0..C {
        for i in 0..R {
            mirrored.data.0[i][j] = a.data.0[j][i];
        }
    }
    mirrored
}

#[inline(always)]
pub(super) fn zeros<T: Real, const R: usize, const C: usize>() -> SMatrix<T, R, C> {
    SMatrix::from_array_storage(nalgebra::ArrayStorage([[T::default(); R]; C]))
}

/// `a + b`.
#[inline(always)]
pub(super) fn plus<T: Real, const R: usize, const C: usize>(
    a: &SMatrix<T, R, C>,
    b: &SMatrix<T, R, C>,
) -> SMatrix<T, R, C> {
    let mut sum = *a;
    for j in 0..C {
        for i in 0..R {
            sum.data.0[j][i] += b.data.0[j][i];
        }
    }
    sum
}

/// `factor a`.
#[inline(always)]
pub(super) fn scaled<T: Real, const R: usize, const C: usize>(
    factor: T,
    matrix: &SMatrix<T, R, C>,
) -> SMatrix<T, R, C> {
    let mut result = *matrix;
    for j in 0..C {
        for i in 0..R {
            result.data.0[j][i] = factor * matrix.data.0[j][i];
        }
    }
    result
}
