//! Equations of collocation methods: simplified Newton iterations, decoupled by the eigenvalues of the method.

use nalgebra::{SMatrix, SVector};

use crate::cost::Operations;
use crate::linear::{Complex, Field, Lu, Singular, factoring, solving};
use crate::method::operations as count;
use crate::real::Float;
use crate::tableau::Eigenpairs;

/// Factored matrix of the iteration, `G d_i - h sum_j a_ij F d_j`. The eigenvectors of `a_ij` decouple the stages,
/// which leaves a complex matrix of the size of the state per pair, and for an odd number of stages a real one
/// (E. Hairer, G. Wanner, "Solving Ordinary Differential Equations II", IV.8).
#[derive(Clone, Copy, Debug)]
pub(super) struct Pencil<T, const STAGES: usize, const PAIRS: usize, const N: usize> {
    real: Option<Lu<T, N>>,
    pairs: [Lu<Complex<T>, N>; PAIRS],
}

impl<T: Float, const STAGES: usize, const PAIRS: usize, const N: usize> Pencil<T, STAGES, PAIRS, N> {
    /// Factors the matrix for a step of length `h`; `g` and `f` are the derivatives of the variables and of their rates
    /// by the state, of which the first `active` components count.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new(
        modes: &Eigenpairs<STAGES, PAIRS>,
        h: T,
        [g, f]: [&SMatrix<T, N, N>; 2],
        active: usize,
    ) -> Result<Self, Singular> {
        let (g, f) = (&g.data.0, &f.data.0);
        let real = match modes.real {
            None => None,
            Some(mode) => {
                let factor = h * T::from_f64(mode.value);
                let entry = |j: usize, i: usize| g[j][i] - factor * f[j][i];
                Some(Lu::new(columns(entry), active)?)
            }
        };
        let mut pairs = [factored(modes.pairs[0].value, h, [g, f], active)?; PAIRS];
        for (pair, mode) in pairs[1..].iter_mut().zip(&modes.pairs[1..]) {
            *pair = factored(mode.value, h, [g, f], active)?;
        }
        Ok(Self { real, pairs })
    }

    /// Solves `G d - h mu F d = r` with the real eigenvalue `mu` for `d`. None if the method has no real eigenvalue.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn solve_real(&self, r: &SVector<T, N>, active: usize) -> Option<SVector<T, N>> {
        let lu = self.real.as_ref()?;
        Some(SVector::from(lu.solve(&r.data.0[0], active)))
    }

    /// Number of factored matrices.
    pub(super) fn factorizations(&self) -> usize {
        PAIRS + usize::from(self.real.is_some())
    }

    /// Solves for the `d_i` that the matrix maps to the residuals `r_i`. `active` is an argument, and not stored, so
    /// that it is a constant to the compiler.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn solve(
        &self,
        modes: &Eigenpairs<STAGES, PAIRS>,
        residuals: &[SVector<T, N>; STAGES],
        active: usize,
    ) -> [SVector<T, N>; STAGES] {
        let zeros = [T::default(); N];
        let mut along = [[Complex::default(); N]; PAIRS];
        for (along, mode) in along.iter_mut().zip(&modes.pairs) {
            let (mut re, mut im) = (zeros, zeros);
            for (residual, left) in residuals.iter().zip(&mode.left) {
                add_scaled(&mut re, T::from_f64(left.re), residual);
                add_scaled(&mut im, T::from_f64(left.im), residual);
            }
            for ((along, re), im) in along.iter_mut().zip(re).zip(im) {
                *along = Complex::new(re, im);
            }
        }
        let along = Lu::solve_each(&self.pairs, &along, active);
        let mut changes = [SVector::from(zeros); STAGES];
        for (along, mode) in along.iter().zip(&modes.pairs) {
            for (change, right) in changes.iter_mut().zip(&mode.right) {
                // the conjugate eigenvalue adds the conjugate: twice the real part
                let (re, im) = (T::from_f64(2.0 * right.re), T::from_f64(2.0 * right.im));
                for (change, along) in change.data.0[0].iter_mut().zip(along) {
                    *change += re * along.re - im * along.im;
                }
            }
        }
        if let (Some(mode), Some(lu)) = (&modes.real, &self.real) {
            let mut along = [T::default(); N];
            for (residual, left) in residuals.iter().zip(mode.left) {
                add_scaled(&mut along, T::from_f64(left), residual);
            }
            let along = SVector::from(lu.solve(&along, active));
            for (change, right) in changes.iter_mut().zip(mode.right) {
                add_scaled(&mut change.data.0[0], T::from_f64(right), &along);
            }
        }
        changes
    }
}

/// Adds `factor * vector` to `sum`, in a loop over the components; see [`weighted_sum`](super::stages::weighted_sum).
#[inline(always)]
pub(super) fn add_scaled<T: Float, const N: usize>(sum: &mut [T; N], factor: T, vector: &SVector<T, N>) {
    for (sum, &component) in sum.iter_mut().zip(&vector.data.0[0]) {
        *sum += factor * component;
    }
}

/// Operations of [`Pencil::new`] for `n` state components.
pub(super) const fn pencil<const STAGES: usize, const PAIRS: usize>(
    modes: &Eigenpairs<STAGES, PAIRS>,
    n: usize,
) -> Operations {
    let of_pair = Operations::new(2 * n * n, 2 * n * n + 2, 0, 0, 0, 3);
    let of_pairs = of_pair.and(factoring::<Complex<f64>>(n)).times(PAIRS);
    if modes.real.is_none() {
        return of_pairs;
    }
    let of_real = Operations::new(n * n, n * n + 1, 0, 0, 0, 3);
    of_pairs.and(of_real).and(factoring::<f64>(n))
}

/// Operations of [`Pencil::solve`].
pub(super) const fn changes<const STAGES: usize, const PAIRS: usize>(
    modes: &Eigenpairs<STAGES, PAIRS>,
    n: usize,
) -> Operations {
    let terms = STAGES * n;
    // projection onto the eigenvector, and back to the stages
    let there = Operations::new(2 * terms, 2 * terms, 0, 0, 0, STAGES + 1);
    let back = Operations::new(2 * terms, 2 * terms, 0, 0, 0, 3);
    let of_pairs = there.and(solving::<Complex<f64>>(n)).and(back).times(PAIRS);
    if modes.real.is_none() {
        return of_pairs;
    }
    let there = Operations::new(terms, terms, 0, 0, 0, STAGES + 1);
    let back = count::multiplied(terms).and(count::added(terms));
    of_pairs.and(there).and(solving::<f64>(n)).and(back)
}

/// Factors `G - h value F`, of which the columns are given.
#[cfg_attr(not(debug_assertions), inline(always))]
fn factored<T: Float, const N: usize>(
    value: nalgebra::Complex<f64>,
    h: T,
    [g, f]: [&[[T; N]; N]; 2],
    active: usize,
) -> Result<Lu<Complex<T>, N>, Singular> {
    let (re, im) = (h * T::from_f64(value.re), h * T::from_f64(value.im));
    let entry = |j: usize, i: usize| Complex::new(g[j][i] - re * f[j][i], -(im * f[j][i]));
    Lu::new(columns(entry), active)
}

/// Collects a matrix by its columns: `entry(j, i)` is the entry in column `j` and row `i`.
#[cfg_attr(not(debug_assertions), inline(always))]
fn columns<F: Field, const N: usize>(entry: impl Fn(usize, usize) -> F) -> [[F; N]; N] {
    core::array::from_fn(|j| core::array::from_fn(|i| entry(j, i)))
}
