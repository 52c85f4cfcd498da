//! Equations of collocation methods: simplified Newton iterations, decoupled by the eigenvalues of the method.

use nalgebra::{SMatrix, SVector};

use crate::cost::Operations;
use crate::linear::{Complex, Field, Lu, Singular, factoring, solving};
use crate::method::operations as count;
use crate::real::Float;
use crate::tableau::{Eigenpair, Eigenpairs};

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
        let mut changes = self.solve_pair(0, &modes.pairs[0], residuals, active);
        for n in 1..PAIRS {
            let more = self.solve_pair(n, &modes.pairs[n], residuals, active);
            for (change, more) in changes.iter_mut().zip(&more) {
                *change += more;
            }
        }
        if let (Some(mode), Some(lu)) = (&modes.real, &self.real) {
            let left = mode.left.map(T::from_f64);
            let along = core::array::from_fn(|k| {
                residuals
                    .iter()
                    .zip(left)
                    .fold(T::default(), |sum, (r, l)| sum + l * r[k])
            });
            let along = SVector::from(lu.solve(&along, active));
            for (change, right) in changes.iter_mut().zip(mode.right) {
                *change += along * T::from_f64(right);
            }
        }
        changes
    }

    /// Part of the solution along a pair of conjugate eigenvectors.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn solve_pair(
        &self,
        n: usize,
        mode: &Eigenpair<nalgebra::Complex<f64>, STAGES>,
        residuals: &[SVector<T, N>; STAGES],
        active: usize,
    ) -> [SVector<T, N>; STAGES] {
        let left = mode.left.map(|l| Complex::new(T::from_f64(l.re), T::from_f64(l.im)));
        // the conjugate eigenvalue adds the conjugate: twice the real part
        let right = mode
            .right
            .map(|r| Complex::new(T::from_f64(2.0 * r.re), T::from_f64(2.0 * r.im)));
        let along = core::array::from_fn(|k| {
            residuals.iter().zip(left).fold(Complex::default(), |sum, (r, l)| {
                sum + Complex::new(l.re * r[k], l.im * r[k])
            })
        });
        let along = self.pairs[n].solve(&along, active);
        right.map(|r| SVector::from_fn(|k, _| r.re * along[k].re - r.im * along[k].im))
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
    let back = Operations::new(terms, 2 * terms, 0, 0, 0, 2);
    let of_pair = there.and(solving::<Complex<f64>>(n)).and(back);
    let of_pairs = of_pair.times(PAIRS).and(count::added(terms).times(PAIRS - 1));
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
