//! Sums of products of series of dual numbers.
//!
//! All derivatives of two products are summed before those of the next two, since these sums fill the vector registers.

use crate::dual::Dual;
use crate::real::lanes::{Lanes, WideKernel};

/// Number of products summed side by side.
const BLOCK: usize = 2;

/// The interior sums of `M` products of series, from the coefficients of order 1 to those of the order before.
pub(crate) struct DualSums<'a, T, const N: usize, const M: usize> {
    pub(crate) left: &'a [[Dual<T, N>; M]],
    pub(crate) right: &'a [[Dual<T, N>; M]],
    pub(crate) sums: &'a mut [Dual<T, N>; M],
}

impl<T: Lanes<Scalar = T>, const N: usize, const M: usize> DualSums<'_, T, N, M> {
    /// Sums `B` products: their derivatives in lanes `V`, then in lanes `Narrow`, the last ones as scalars.
    #[inline(always)]
    fn block<V: Lanes<Scalar = T>, Narrow: Lanes<Scalar = T>, const B: usize>(&mut self, at: usize) {
        let start = self.groups::<V, B>(at, 0);
        let start = self.groups::<Narrow, B>(at, start);
        self.groups::<T, B>(at, start);
    }

    /// Computes the sums of as many derivatives from the number `start` on as fill lanes `V`, and returns the next
    /// number. The values are summed with the first derivatives.
    #[inline(always)]
    fn groups<V: Lanes<Scalar = T>, const B: usize>(&mut self, at: usize, mut start: usize) -> usize {
        while start + V::LANES <= N {
            let parts = sum::<V, B, N, M>(self.left, self.right, (at, start));
            for (sum, part) in self.sums[at..][..B].iter_mut().zip(&parts) {
                for (lane, slope) in sum.slopes[start..][..V::LANES].iter_mut().enumerate() {
                    *slope = part.slopes.lane(lane);
                }
                if start == 0 {
                    sum.value = part.value.lane(0);
                }
            }
            start += V::LANES;
        }
        start
    }
}

impl<T, const N: usize, const M: usize> WideKernel<T> for DualSums<'_, T, N, M> {
    #[inline(always)]
    fn run<V, Narrow>(mut self)
    where
        T: Lanes<Scalar = T>,
        V: Lanes<Scalar = T>,
        Narrow: Lanes<Scalar = T>,
    {
        let mut at = 0;
        while at + BLOCK <= M {
            self.block::<V, Narrow, BLOCK>(at);
            at += BLOCK;
        }
        while at < M {
            self.block::<V, Narrow, 1>(at);
            at += 1;
        }
    }
}

/// Value and some derivatives of a sum. The value is in all lanes, as the factors of derivatives are: a scalar of its
/// own would have to be taken out of these.
#[derive(Clone, Copy)]
struct Part<V: Lanes> {
    value: V,
    slopes: V,
}

impl<V: Lanes> Part<V> {
    /// Adds a product, with the derivatives from the number `start` on.
    #[inline(always)]
    fn add<const N: usize>(&mut self, left: &Dual<V::Scalar, N>, right: &Dual<V::Scalar, N>, start: usize) {
        let [of_left, of_right] = [left, right].map(|number| V::from_fn(|lane| number.slopes[start + lane]));
        let [left, right] = [left, right].map(|number| V::splat(number.value));
        self.value = left.mul_add(right, self.value);
        self.slopes += of_right.mul_add(left, of_left * right);
    }
}

/// Sums `B` products from the number `at` on in the order of [`Products`](super::Products): in two parts, then the
/// terms with the newest coefficients.
#[inline(always)]
fn sum<V: Lanes, const B: usize, const N: usize, const M: usize>(
    left: &[[Dual<V::Scalar, N>; M]],
    right: &[[Dual<V::Scalar, N>; M]],
    (at, start): (usize, usize),
) -> [Part<V>; B] {
    let zero = Part {
        value: V::default(),
        slopes: V::default(),
    };
    let (mut even, mut odd, mut newest) = ([zero; B], [zero; B], [zero; B]);
    let ([first_l, later_l @ ..], [first_r, later_r @ ..]) = (left, right) else {
        return newest;
    };
    let ([inner_l @ .., last_l], [inner_r @ .., last_r]) = (later_l, later_r) else {
        for m in 0..B {
            newest[m].add(&first_l[at + m], &first_r[at + m], start);
        }
        return newest;
    };
    let (pairs_l, rest_l) = inner_l.as_chunks::<2>();
    let (rest_r, pairs_r) = inner_r.as_rchunks::<2>();
    for ([l0, l1], [r1, r0]) in pairs_l.iter().zip(pairs_r.iter().rev()) {
        for m in 0..B {
            even[m].add(&l0[at + m], &r0[at + m], start);
            odd[m].add(&l1[at + m], &r1[at + m], start);
        }
    }
    if let ([l], [r]) = (rest_l, rest_r) {
        for m in 0..B {
            even[m].add(&l[at + m], &r[at + m], start);
        }
    }
    for m in 0..B {
        newest[m].add(&first_l[at + m], &last_r[at + m], start);
        newest[m].add(&last_l[at + m], &first_r[at + m], start);
        even[m].value = (even[m].value + odd[m].value) + newest[m].value;
        even[m].slopes = (even[m].slopes + odd[m].slopes) + newest[m].slopes;
    }
    even
}

#[cfg(test)]
mod tests {
    use crate::dual::Dual;
    use crate::real::{Float, Fused};
    use crate::taylor::{FewProducts, MAX_ORDER, Products};

    #[test]
    fn sums_have_the_bits_of_those_of_few_products() {
        assert_equal::<f64, 1>();
        assert_equal::<f64, 3>();
        assert_equal::<f64, 4>();
        assert_equal::<f64, 10>();
        assert_equal::<Fused<f64>, 10>();
    }

    fn assert_equal<T: Float, const N: usize>() {
        let bits = |number: T| number.to_f64().to_bits();
        let mut products = Products::<Dual<T, N>, 3>::new();
        let mut few = FewProducts::<Dual<T, N>, 3>::new();
        for k in 1..MAX_ORDER {
            for (sum, expected) in products.sums(k).iter().zip(&few.sums(k)) {
                assert_eq!(bits(sum.value), bits(expected.value), "order {k}");
                assert_eq!(sum.slopes.map(bits), expected.slopes.map(bits), "order {k}");
                assert_eq!(sum.value == T::default(), k == 1);
            }
            let number = |seed: usize| T::from_f64((0.3 + 0.7 * seed as f64).sin());
            let side = |shift: usize| {
                core::array::from_fn(|m| Dual {
                    value: number(20 * k + m + shift),
                    slopes: core::array::from_fn(|n| number(20 * k + 3 * m + n + shift + 2)),
                })
            };
            products.set(k, side(0), side(5));
            few.set(k, side(0), side(5));
        }
    }
}
