//! Products of series, coefficient by coefficient: the memory of generated recurrences.

use super::MAX_ORDER;
use crate::real::Real;

/// Number of products summed side by side: few enough that their sums stay in registers, in lanes as well.
const BLOCK: usize = 4;

/// `M` products of two series each: the workspace of generated recurrences.
///
/// The coefficients of one order are contiguous, so that the sums of all products are one loop over them, in vector
/// registers.
#[derive(Clone, Debug)]
pub struct Products<T, const M: usize> {
    /// Left factors. Row `k - 1` holds the coefficients of order `k`, without order 0 and the highest order, which no
    /// interior sum contains.
    left: [[T; M]; MAX_ORDER - 1],
    /// Right factors.
    right: [[T; M]; MAX_ORDER - 1],
}

impl<T: Real, const M: usize> Products<T, M> {
    /// Creates products without coefficients.
    #[must_use]
    #[inline]
    pub fn new() -> Self {
        let zeros = [[T::default(); M]; MAX_ORDER - 1];
        Self {
            left: zeros,
            right: zeros,
        }
    }

    /// Sets the coefficients of order `k >= 1` of both sides of all products.
    #[inline(always)]
    pub fn set(&mut self, k: usize, left: [T; M], right: [T; M]) {
        if let (Some(l), Some(r)) = (self.left.get_mut(k - 1), self.right.get_mut(k - 1)) {
            *l = left;
            *r = right;
        }
    }

    /// Returns the coefficients of order `k` of the left factors, and of the right ones.
    ///
    /// # Panics
    /// If `k` is 0, or not below [`MAX_ORDER`].
    #[must_use]
    #[inline(always)]
    pub fn factors(&self, k: usize) -> [&[T; M]; 2] {
        [&self.left[k - 1], &self.right[k - 1]]
    }

    /// Computes the interior sums of order `k`, `sum_(j = 1 .. k - 1) left_j right_(k - j)`, of each product. For
    /// `f64` and `f32`, terms with coefficients of order `k - 1` are missing: [`Newest::add`] adds them.
    ///
    /// # Panics
    /// If `k` is not below [`MAX_ORDER`].
    #[must_use]
    #[inline(always)]
    pub fn sums(&self, k: usize) -> [T; M] {
        assert!(k < MAX_ORDER, "the order of a series is at most {MAX_ORDER}");
        if const { T::SUMS_WIDE } {
            let mut sums = [T::default(); M];
            let before = k.saturating_sub(1);
            T::sum_products(&self.left[..before], &self.right[..before], &mut sums);
            return sums;
        }
        let end = k.saturating_sub(2).max(1);
        let (left, right) = (&self.left[1..end], &self.right[1..end]);
        let mut sums = [T::default(); M];
        let mut at = 0;
        while at + BLOCK <= M {
            block::<T, M, BLOCK>(left, right, at, &mut sums);
            at += BLOCK;
        }
        match M % BLOCK {
            1 => block::<T, M, 1>(left, right, at, &mut sums),
            2 => block::<T, M, 2>(left, right, at, &mut sums),
            3 => block::<T, M, 3>(left, right, at, &mut sums),
            _ => {}
        }
        if const { T::LANES == 1 } {
            // Pass the sums through memory once. Otherwise compilers pair the products in the order in which the code
            // after this pairs their sums, and load each number separately.
            core::hint::black_box(&mut sums);
        } else if k > 1 {
            let (newest_l, newest_r) = (&self.left[k - 2], &self.right[k - 2]);
            for m in 0..M {
                let mut newest = self.left[0][m] * newest_r[m];
                if k > 2 {
                    newest = newest_l[m].mul_add(self.right[0][m], newest);
                }
                sums[m] += newest;
            }
        }
        sums
    }
}

/// Sums `B` products side by side, in two parts each, so that an addition need not wait for the one before.
#[inline(always)]
fn block<T: Real, const M: usize, const B: usize>(left: &[[T; M]], right: &[[T; M]], at: usize, sums: &mut [T; M]) {
    let (mut even, mut odd) = ([T::default(); B], [T::default(); B]);
    let (pairs_l, rest_l) = left.as_chunks::<2>();
    let (rest_r, pairs_r) = right.as_rchunks::<2>();
    for ([l0, l1], [r1, r0]) in pairs_l.iter().zip(pairs_r.iter().rev()) {
        for m in 0..B {
            even[m] = l0[at + m].mul_add(r0[at + m], even[m]);
            odd[m] = l1[at + m].mul_add(r1[at + m], odd[m]);
        }
    }
    if let ([l0], [r0]) = (rest_l, rest_r) {
        for m in 0..B {
            even[m] = l0[at + m].mul_add(r0[at + m], even[m]);
        }
    }
    for m in 0..B {
        sums[at + m] = even[m] + odd[m];
    }
}

/// The newest coefficients of [`Products`], by value.
///
/// Coefficients stored one by one cannot be loaded as vectors right away. For `f64` and `f32`, the terms with the
/// newest coefficients are therefore summed last, from these values, and the loop over all other terms need not wait
/// for them.
#[derive(Clone, Copy, Debug)]
pub struct Newest<T, const M: usize> {
    /// Left and right coefficients of order 1. The right ones are set from order 3 on, since the sum of order 2 has one
    /// term, not two.
    first: [[T; M]; 2],
    /// Left and right coefficients of the order before.
    last: [[T; M]; 2],
}

impl<T: Real, const M: usize> Newest<T, M> {
    /// Creates it without coefficients.
    #[inline(always)]
    pub fn new() -> Self {
        let zero = [[T::default(); M]; 2];
        Self {
            first: zero,
            last: zero,
        }
    }

    /// Adds the terms with the coefficients of order `k - 1` to the sums of order `k`.
    #[inline(always)]
    pub fn add(&self, mut sums: [T; M]) -> [T; M] {
        if const { T::LANES > 1 || T::SUMS_WIDE } {
            return sums;
        }
        let (first, last) = (&self.first, &self.last);
        for (m, sum) in sums.iter_mut().enumerate() {
            *sum += last[0][m].mul_add(first[1][m], first[0][m] * last[1][m]);
        }
        sums
    }

    /// Stores the coefficients of order `k`.
    #[inline(always)]
    pub fn push(&mut self, k: usize, left: [T; M], right: [T; M]) {
        if const { T::LANES > 1 || T::SUMS_WIDE } {
            return;
        }
        if k == 1 {
            self.first[0] = left;
        }
        if k == 2 {
            self.first[1] = self.last[1];
        }
        self.last = [left, right];
    }
}

impl<T: Real, const M: usize> Default for Newest<T, M> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Real, const M: usize> Default for Products<T, M> {
    fn default() -> Self {
        Self::new()
    }
}

/// A few products of two series each, for recurrences whose code is written out for each order, with a constant `k`:
/// the coefficients then stay in registers.
///
/// Loops over the lower orders of a few products take longer than what they compute. The sums have the bits of those of
/// [`Products`] with [`Newest`].
#[derive(Clone, Debug)]
pub struct FewProducts<T, const M: usize> {
    /// Coefficients of the left factors, by order.
    left: [[T; M]; MAX_ORDER + 1],
    /// Coefficients of the right factors.
    right: [[T; M]; MAX_ORDER + 1],
}

impl<T: Real, const M: usize> FewProducts<T, M> {
    /// Creates products without coefficients.
    #[must_use]
    #[inline(always)]
    pub fn new() -> Self {
        let zeros = [[T::default(); M]; MAX_ORDER + 1];
        Self {
            left: zeros,
            right: zeros,
        }
    }

    /// Sets the coefficients of order `k >= 1` of both sides of all products.
    ///
    /// # Panics
    /// If `k` is above [`MAX_ORDER`].
    #[inline(always)]
    pub fn set(&mut self, k: usize, left: [T; M], right: [T; M]) {
        (self.left[k], self.right[k]) = (left, right);
    }

    /// Computes the interior sums of order `k`, `sum_(j = 1 .. k - 1) left_j right_(k - j)`, of each product.
    ///
    /// # Panics
    /// If `k` is above [`MAX_ORDER`].
    #[must_use]
    #[inline(always)]
    pub fn sums(&self, k: usize) -> [T; M] {
        let (left, right) = (&self.left, &self.right);
        let mut sums = [[T::default(); M]; 2];
        let end = k.saturating_sub(2);
        crate::for_each_order!(n in 1..end {
            let j = n + 1;
            for m in 0..M {
                sums[j % 2][m] = left[j][m].mul_add(right[k - j][m], sums[j % 2][m]);
            }
        });
        let [even, odd] = sums;
        let mut sums = even;
        for m in 0..M {
            sums[m] = even[m] + odd[m];
            if k > 1 {
                let mut newest = left[1][m] * right[k - 1][m];
                if k > 2 {
                    newest = left[k - 1][m].mul_add(right[1][m], newest);
                }
                sums[m] += newest;
            }
        }
        sums
    }
}

impl<T: Real, const M: usize> Default for FewProducts<T, M> {
    fn default() -> Self {
        Self::new()
    }
}

const _: () = assert!(
    MAX_ORDER == 24,
    "as many orders as `for_each_order` writes out, and one more"
);

/// Writes out a block for each order `k` in `1..end`, as a constant. `end` is at most [`MAX_ORDER`].
#[doc(hidden)]
#[macro_export]
macro_rules! for_each_order {
    ($k:ident in 1..$end:ident $block:block) => {
        $crate::for_each_order!($k $end $block 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23)
    };
    ($k:ident $end:ident $block:block $($order:literal)*) => {
        '_orders: {
            $(
                if $end <= $order {
                    break '_orders;
                }
                let $k: usize = $order;
                $block
            )*
        }
    };
}

#[cfg(test)]
mod tests {
    use super::{FewProducts, MAX_ORDER, Newest, Products};
    use crate::real::lanes::{F64x4, Lanes};

    #[test]
    fn sums_of_few_products_have_the_bits_of_those_of_many() {
        assert_equal::<f64, 1>();
        assert_equal::<f64, 2>();
        assert_equal::<f64, 3>();
        assert_equal::<F64x4, 3>();
    }

    fn assert_equal<T: Lanes<Scalar = f64>, const M: usize>() {
        let (mut products, mut newest, mut few) = (Products::<T, M>::new(), Newest::new(), FewProducts::<T, M>::new());
        for k in 1..MAX_ORDER {
            let (of_many, of_few) = (newest.add(products.sums(k)), few.sums(k));
            for (many, few) in of_many.iter().zip(&of_few) {
                for lane in 0..T::LANES {
                    let (many, few): (f64, f64) = (many.lane(lane), few.lane(lane));
                    assert_eq!(many.to_bits(), few.to_bits(), "order {k}");
                    assert_eq!(few.to_bits() == 0, k == 1);
                }
            }
            let number = |m: usize, lane: usize| (0.3 + 0.2 * m as f64 + 0.7 * lane as f64 + k as f64).sin();
            let side = |shift: usize| std::array::from_fn(|m| T::from_fn(|lane| number(m + shift, lane)));
            let (left, right) = (side(1), side(2));
            products.set(k, left, right);
            newest.push(k, left, right);
            few.set(k, left, right);
        }
    }
}
