//! Power series of motions, and the products of series in their recurrences.
//!
//! Around a time `t` a motion is `x(tau) = sum_k x_k (tau - t)^k`. The coefficients follow recursively: those of order
//! `k` of all intermediate results of the right-hand side give those of order `k + 1` of the state (Jorba and Zou, "A
//! software package for the numerical integration of ODEs by means of high-order Taylor methods", Experimental
//! Mathematics 2005; Griewank and Walther, "Evaluating Derivatives" 2008, ch. 13). [`mechanism!`](crate::mechanism)
//! generates the recurrences of a scene whose `generate` contains `taylor`.

use nalgebra::SVector;

use crate::constraint::Hold;
use crate::real::Real;
use crate::system::{Cast, System};

/// Maximum order of a series.
pub const MAX_ORDER: usize = 24;

/// A [`System`] with the power series of its motions.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no Taylor series of its motions",
    note = "`mechanism!` generates it for scenes without inputs where `generate` has `taylor`"
)]
pub trait TaylorSeries<T: Real, const N: usize>: System<T, N> {
    /// Memory of the recurrences: some kilobytes, without heap allocation.
    type Workspace: Clone;

    /// Creates a workspace, for any number of series one after the other.
    fn workspace(&self) -> Self::Workspace;

    /// Computes `x[1..]` from `x[0]`, the state at `t`: the motion is `sum_k x[k] (tau - t)^k`, with `x[k]` in the
    /// units of the state over s^k.
    ///
    /// The order is `x.len() - 1`. If the motion has no series, as at the edge of the domain of a square root,
    /// coefficients are not finite. `abs` and `signum` count as smooth continuations of their side at `t`, and as
    /// constant where their argument is zero.
    ///
    /// # Panics
    /// If the order is above [`MAX_ORDER`].
    fn series(&self, t: T, x: &mut [SVector<T, N>], work: &mut Self::Workspace);

    /// Series of a [hybrid](crate::hybrid) system, given its mode. Required of hybrid systems; `None` by default, for
    /// others.
    #[inline(always)]
    fn hybrid_series(&self) -> Option<&dyn HybridSeries<T, N, Workspace = Self::Workspace>> {
        None
    }
}

/// A [hybrid](crate::hybrid) system with the power series of its motions in each mode.
pub trait HybridSeries<T: Real, const N: usize> {
    /// See [`TaylorSeries::Workspace`].
    type Workspace;

    /// Like [`TaylorSeries::series`], but in a mode.
    ///
    /// # Panics
    /// If the order is above [`MAX_ORDER`].
    fn eval_series(&self, hold: &Hold<T>, t: T, x: &mut [SVector<T, N>], work: &mut Self::Workspace);
}

/// A [`Cast`] with power series in every number type, including lanes.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no Taylor series of its motions in other number types",
    note = "`mechanism!` generates it for scenes without inputs where `generate` has `taylor`"
)]
pub trait CastTaylor<const N: usize>: Cast<N> {
    /// The [`TaylorSeries::Workspace`] of the model in a number type.
    type Workspace<T: Real>: Clone;

    /// Returns the model with power series, which is the one of [`Cast::In`] if it has them.
    fn with_series<T: Real>(model: &Self::In<T>) -> &impl TaylorSeries<T, N, Workspace = Self::Workspace<T>>;
}

impl<T: Real, S: TaylorSeries<T, N> + ?Sized, const N: usize> TaylorSeries<T, N> for &S {
    type Workspace = S::Workspace;

    #[inline]
    fn workspace(&self) -> Self::Workspace {
        (**self).workspace()
    }

    #[inline]
    fn series(&self, t: T, x: &mut [SVector<T, N>], work: &mut Self::Workspace) {
        (**self).series(t, x, work);
    }

    #[inline]
    fn hybrid_series(&self) -> Option<&dyn HybridSeries<T, N, Workspace = Self::Workspace>> {
        (**self).hybrid_series()
    }
}

/// Number of products summed side by side: few enough that their sums stay in registers, in lanes as well.
const BLOCK: usize = 4;

/// `M` products of two series each, coefficient by coefficient: the workspace of generated recurrences.
///
/// The coefficients of one order are contiguous, so that the sums of all products are one loop over them, in vector
/// registers.
#[derive(Clone, Debug)]
pub struct Products<T, const M: usize> {
    /// Left factors. Row `k - 1` holds the coefficients of order `k`; interior sums do not contain order 0 nor the
    /// highest order.
    left: [[T; M]; MAX_ORDER - 2],
    /// Right factors.
    right: [[T; M]; MAX_ORDER - 2],
}

impl<T: Real, const M: usize> Products<T, M> {
    /// Creates products without coefficients.
    #[must_use]
    #[inline]
    pub fn new() -> Self {
        let zeros = [[T::default(); M]; MAX_ORDER - 2];
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

    /// Computes the interior sums of order `k`, `sum_(j = 1 .. k - 1) left_j right_(k - j)`, of each product. For
    /// scalars, terms with coefficients of order `k - 1` are missing: [`Newest::add`] adds them.
    ///
    /// # Panics
    /// If `k` is not below [`MAX_ORDER`].
    #[must_use]
    #[inline(always)]
    pub fn sums(&self, k: usize) -> [T; M] {
        assert!(k < MAX_ORDER, "the order of a series is at most {MAX_ORDER}");
        let end = k.saturating_sub(2).max(1);
        let (left, right) = (&self.left[1..end], &self.right[1..end]);
        let mut sums = [T::default(); M];
        let mut at = 0;
        while at + BLOCK <= M {
            block::<T, M, BLOCK>(left, right, at, &mut sums);
            at += BLOCK;
        }
        while at < M {
            block::<T, M, 1>(left, right, at, &mut sums);
            at += 1;
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
/// Coefficients stored one by one cannot be loaded as vectors right away. For scalars, the terms with the newest
/// coefficients are therefore summed last, from these values, and the loop over all other terms need not wait for them.
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
        if const { T::LANES > 1 } {
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
        if const { T::LANES > 1 } {
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
