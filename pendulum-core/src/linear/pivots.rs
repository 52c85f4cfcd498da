//! Choice of pivots, for one matrix or for one in each lane.

use super::Field;
use crate::real::Float;
#[cfg(feature = "std")]
use crate::real::lanes::Lanes;

/// Row permutation of a factorisation, and a check of its pivots.
pub trait Pivots<F, const N: usize>: Copy {
    /// The identity permutation.
    fn in_order() -> Self;

    /// Swaps rows `k` and `i` if row `i` has the larger entry in column `k`.
    fn compare(&mut self, columns: &mut [[F; N]; N], k: usize, i: usize);

    /// Records a pivot and its reciprocal.
    fn take(&mut self, pivot: F, over_pivot: F);

    /// True if all pivots have reciprocals. Only for single matrices; lanes report a [`defect`](Self::defect).
    fn are_regular(&self) -> bool;

    /// A number that is not finite in lanes where a pivot has no reciprocal.
    fn defect(&self) -> F;

    /// Applies the permutation to a vector.
    fn sorted(&self, b: &[F; N]) -> [F; N];
}

/// [`Pivots`] of a single matrix.
#[derive(Clone, Copy, Debug)]
pub struct Alone<const N: usize> {
    /// Index of the original row for each row of the factors.
    rows: [usize; N],
    is_regular: bool,
}

impl<F: Field<Size: Float>, const N: usize> Pivots<F, N> for Alone<N> {
    #[inline(always)]
    fn in_order() -> Self {
        Self {
            rows: core::array::from_fn(|i| i),
            is_regular: true,
        }
    }

    #[inline(always)]
    fn compare(&mut self, columns: &mut [[F; N]; N], k: usize, i: usize) {
        if columns[k][i].size() > columns[k][k].size() {
            columns.iter_mut().for_each(|column| column.swap(k, i));
            self.rows.swap(k, i);
        }
    }

    #[inline(always)]
    fn take(&mut self, _pivot: F, over_pivot: F) {
        let size = over_pivot.size();
        self.is_regular &= size.is_finite() && size > F::Size::default();
    }

    #[inline(always)]
    fn are_regular(&self) -> bool {
        self.is_regular
    }

    #[inline(always)]
    fn defect(&self) -> F {
        F::default()
    }

    #[inline(always)]
    fn sorted(&self, b: &[F; N]) -> [F; N] {
        self.rows.map(|row| b[row])
    }
}

/// [`Pivots`] of one matrix per lane, identical to those of [`Alone`] in each lane.
#[cfg(feature = "std")]
#[derive(Clone, Copy, Debug)]
pub struct PerLane<V, const N: usize> {
    /// Entry `[k][i]` is negative where row `i` was swapped with row `k`.
    moved: [[V; N]; N],
    /// Not finite where a pivot has no reciprocal.
    defect: V,
}

#[cfg(feature = "std")]
impl<V: Lanes, const N: usize> Pivots<V, N> for PerLane<V, N> {
    #[inline(always)]
    fn in_order() -> Self {
        Self {
            moved: [[V::default(); N]; N],
            defect: V::default(),
        }
    }

    /// The sign of the difference decides the comparison. By gradual underflow it is zero only for equal numbers.
    #[inline(always)]
    fn compare(&mut self, columns: &mut [[V; N]; N], k: usize, i: usize) {
        let moved = columns[k][k].abs() - columns[k][i].abs();
        for column in columns {
            exchange(moved, column, k, i);
        }
        self.moved[k][i] = moved;
    }

    /// The product is close to one unless the pivot or its reciprocal is zero or not finite.
    #[inline(always)]
    fn take(&mut self, pivot: V, over_pivot: V) {
        self.defect += pivot * over_pivot;
    }

    #[inline(always)]
    fn are_regular(&self) -> bool {
        true
    }

    #[inline(always)]
    fn defect(&self) -> V {
        self.defect
    }

    #[inline(always)]
    fn sorted(&self, b: &[V; N]) -> [V; N] {
        let mut x = *b;
        for k in 0..N {
            for i in k + 1..N {
                exchange(self.moved[k][i], &mut x, k, i);
            }
        }
        x
    }
}

/// Swaps two numbers in the lanes where `moved` is negative.
#[cfg(feature = "std")]
#[inline(always)]
fn exchange<V: Lanes>(moved: V, numbers: &mut [V], k: usize, i: usize) {
    let (upper, lower) = (numbers[k], numbers[i]);
    numbers[k] = moved.select(lower, upper);
    numbers[i] = moved.select(upper, lower);
}
