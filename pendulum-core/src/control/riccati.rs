//! Algebraic Riccati equations, continuous and discrete.

use nalgebra::{Complex, DMatrix, DVector};

use super::reach::{Mode, decays, unreached};
use super::schur::Schur;

/// An optimal control problem: `x' = A x + B u`, or `x+ = A x + B u`, with the cost `x . Q x + u . R u`.
///
/// `Q` is symmetric and positive semidefinite, `R` symmetric and positive definite.
#[derive(Clone, Debug)]
pub(super) struct Problem {
    pub(super) a: DMatrix<f64>,
    pub(super) b: DMatrix<f64>,
    pub(super) q: DMatrix<f64>,
    pub(super) r: DMatrix<f64>,
    /// True if the equations relate one sample to the next.
    pub(super) is_discrete: bool,
}

/// The stabilizing solution.
#[derive(Clone, Debug)]
pub(super) struct Solution {
    /// The matrix `P` of the cost to go, `x . P x`.
    pub(super) cost: DMatrix<f64>,
    /// The gain `K` of the law `u = -K x`.
    pub(super) gain: DMatrix<f64>,
    /// Eigenvalues of `A - B K`.
    pub(super) eigenvalues: Vec<Complex<f64>>,
}

/// Reason for the lack of a stabilizing solution.
#[derive(Clone, Debug)]
pub(super) enum Obstacle {
    /// Modes that do not decay and that no input acts on.
    Unreached(Vec<Mode>),
    /// Modes on the limit of stability without influence on the cost.
    Unweighted(Vec<Mode>),
    /// The residual is above its bound, relative to the terms of the equation.
    NoConvergence(f64),
}

/// Maximum number of sweeps over the rows of the balance.
const SWEEPS: usize = 50;
/// Maximum number of steps of Newton's method.
const STEPS: usize = 12;
/// Relative residual above which a step of Newton's method may increase it.
const ROUGH: f64 = 1e-6;
/// Relative residual above which the solution is refused.
const REFUSED: f64 = 1e-10;

impl Problem {
    /// Solves the equation for its stabilizing solution.
    ///
    /// The stable subspace of the Hamiltonian matrix, from its ordered Schur form, gives a first solution (A. J. Laub,
    /// IEEE Trans. Autom. Control 24 (1979) 913). The symplectic pencil of the discrete equation is first mapped to a
    /// Hamiltonian matrix by a Cayley transform, which allows a singular `A`. Newton's method then reduces the residual
    /// to rounding errors (D. L. Kleinman, IEEE Trans. Autom. Control 13 (1968) 114; G. A. Hewer, ibid. 16 (1971) 382).
    pub(super) fn solve(&self) -> Result<Solution, Obstacle> {
        let none = || Obstacle::NoConvergence(f64::NAN);
        let factor = self.r.clone().cholesky().ok_or_else(none)?.l();
        // u = L^-T v, so that the cost of v is v . v
        let over = factor.transpose().try_inverse().ok_or_else(none)?;
        let (scaled, scales) = self.normalized(&over);
        // Iterations of nalgebra may not end where squares overflow.
        let squares = [&scaled.a, &scaled.b, &scaled.q].map(|matrix| matrix.norm_squared());
        if !squares.into_iter().all(f64::is_finite) {
            return Err(none());
        }
        scaled.check(&scales)?;
        let mut p = scaled.by_schur().ok_or_else(none)?;
        let (residual, closed) = scaled.refine(&mut p).ok_or_else(none)?;
        // A residual that is NaN is refused, too.
        let is_small = residual <= REFUSED;
        if !is_small || !closed.eigenvalues().iter().all(|&value| self.is_stable(value)) {
            return Err(Obstacle::NoConvergence(residual));
        }
        let gain = scaled.gain(&p).ok_or_else(none)?;
        let unscaled = scales.map(f64::recip);
        Ok(Solution {
            cost: DMatrix::from_fn(p.nrows(), p.ncols(), |i, j| p[(i, j)] * unscaled[i] * unscaled[j]),
            gain: over * gain * DMatrix::from_diagonal(&unscaled),
            eigenvalues: closed.eigenvalues(),
        })
    }

    fn is_stable(&self, eigenvalue: Complex<f64>) -> bool {
        if self.is_discrete {
            eigenvalue.norm() < 1.0
        } else {
            eigenvalue.re < 0.0
        }
    }

    /// The problem for inputs of unit cost and for a scaled state `D^-1 x`, and the diagonal of `D`.
    ///
    /// The scales, powers of 2, bring rows and columns of the Hamiltonian matrix to similar norms (B. N. Parlett, C.
    /// Reinsch, Numer. Math. 13 (1969) 293) and keep its structure (P. Benner, SIAM J. Matrix Anal. Appl. 22 (2001)
    /// 885).
    fn normalized(&self, over: &DMatrix<f64>) -> (Self, DVector<f64>) {
        let n = self.a.nrows();
        let (mut a, mut b, mut q) = (self.a.clone(), &self.b * over, self.q.clone());
        let mut scales = DVector::repeat(n, 1.0);
        for _ in 0..SWEEPS {
            let mut is_balanced = true;
            for i in 0..n {
                let (row, column) = hamiltonian_norms(&a, &b, &q, i);
                if !(column > 0.0 && row > 0.0 && column.is_finite() && row.is_finite()) {
                    continue;
                }
                let power = libm::round(0.25 * libm::log2(row / column));
                if power != 0.0 {
                    let scale = libm::exp2(power);
                    is_balanced = false;
                    scales[i] *= scale;
                    a.column_mut(i).scale_mut(scale);
                    a.row_mut(i).unscale_mut(scale);
                    q.column_mut(i).scale_mut(scale);
                    q.row_mut(i).scale_mut(scale);
                    b.row_mut(i).unscale_mut(scale);
                }
            }
            if is_balanced {
                break;
            }
        }
        let r = DMatrix::identity(b.ncols(), b.ncols());
        let is_discrete = self.is_discrete;
        (
            Self {
                a,
                b,
                q,
                r,
                is_discrete,
            },
            scales,
        )
    }

    /// Rejects a problem without a stabilizing solution (W. M. Wonham, SIAM J. Control 6 (1968) 681).
    fn check(&self, scales: &DVector<f64>) -> Result<(), Obstacle> {
        let size = self.a.norm();
        let lost = |a: &DMatrix<f64>, b: &DMatrix<f64>| unreached(a, b).ok_or(Obstacle::NoConvergence(f64::NAN));
        let rescaled = |mut modes: Vec<Mode>, scales: &DVector<f64>| {
            for mode in &mut modes {
                mode.rescale(scales);
            }
            modes
        };
        let mut modes = lost(&self.a, &self.b)?;
        modes.retain(|mode| !decays(mode, size, self.is_discrete));
        if !modes.is_empty() {
            return Err(Obstacle::Unreached(rescaled(modes, &scales.map(f64::recip))));
        }
        let mut modes = lost(&self.a.transpose(), &range(&self.q))?;
        modes.retain(|mode| {
            !decays(mode, size, self.is_discrete) && !decays(&mode.inverse(self.is_discrete), size, self.is_discrete)
        });
        if !modes.is_empty() {
            return Err(Obstacle::Unweighted(rescaled(modes, scales)));
        }
        Ok(())
    }

    /// Solution from the stable subspace of the Hamiltonian matrix `[A, -B B^T; -Q, -A^T]`, or of its counterpart for
    /// the pencil `[A, 0; -Q, I] - lambda [I, B B^T; 0, A^T]`.
    fn by_schur(&self) -> Option<DMatrix<f64>> {
        let n = self.a.nrows();
        let g = &self.b * self.b.transpose();
        let blocks = |a: &DMatrix<f64>, g: &DMatrix<f64>, q: &DMatrix<f64>, d: &DMatrix<f64>| {
            let mut matrix = DMatrix::zeros(2 * n, 2 * n);
            matrix.view_mut((0, 0), (n, n)).copy_from(a);
            matrix.view_mut((0, n), (n, n)).copy_from(g);
            matrix.view_mut((n, 0), (n, n)).copy_from(q);
            matrix.view_mut((n, n), (n, n)).copy_from(d);
            matrix
        };
        let (transposed, one) = (self.a.transpose(), DMatrix::identity(n, n));
        let hamiltonian = if self.is_discrete {
            // With lambda = (1 + s) / (1 - s), the unit circle becomes the imaginary axis, and lambda = 0 is s = -1.
            let sum = blocks(&(&self.a + &one), &g, &-&self.q, &(&transposed + &one));
            let difference = blocks(&(&self.a - &one), &-g, &-&self.q, &(one - transposed));
            sum.lu().solve(&difference)?
        } else {
            blocks(&self.a, &-g, &-&self.q, &-transposed)
        };
        let mut schur = Schur::of(&hamiltonian)?;
        schur.sort_by(|eigenvalue| eigenvalue.re);
        let upper = schur.vectors.view((0, 0), (n, n)).transpose();
        let lower = schur.vectors.view((n, 0), (n, n)).transpose();
        let p = upper.lu().solve(&lower)?.map(|entry| entry.re);
        Some((&p + p.transpose()) * 0.5)
    }

    /// Gain of the law `u = -K x` for the cost to go `x . P x`, with `R = I`.
    fn gain(&self, p: &DMatrix<f64>) -> Option<DMatrix<f64>> {
        let by_input = self.b.transpose() * p;
        if self.is_discrete {
            Some((&self.r + &by_input * &self.b).cholesky()?.solve(&(by_input * &self.a)))
        } else {
            Some(by_input)
        }
    }

    /// Bound on the terms of the equation for a solution with this norm.
    fn terms(&self, p: f64) -> f64 {
        let [a, b, q] = [&self.a, &self.b, &self.q].map(|matrix| matrix.norm());
        if self.is_discrete {
            q + p * (1.0 + a * a)
        } else {
            q + p * (2.0 * a + p * b * b)
        }
    }

    /// Reduces the residual by Newton's method until rounding errors are left. Returns it relative to the terms of the
    /// equation, and the Schur form of `A - B K`.
    fn refine(&self, p: &mut DMatrix<f64>) -> Option<(f64, Schur)> {
        let mut best: Option<(f64, Schur)> = None;
        let mut next = p.clone();
        for _ in 0..STEPS {
            let gain = self.gain(&next)?;
            let closed = &self.a - &self.b * &gain;
            let fixed = &self.q + gain.transpose() * &gain;
            let image = closed.transpose() * &next;
            let residual = if self.is_discrete {
                image * &closed + fixed - &next
            } else {
                &image + image.transpose() + fixed
            };
            let terms = self.terms(next.norm());
            if !terms.is_finite() {
                break;
            }
            let relative = if terms > 0.0 { residual.norm() / terms } else { 0.0 };
            let schur = Schur::of(&closed)?;
            let is_stable = schur.eigenvalues().iter().all(|&value| self.is_stable(value));
            let improves = |least: f64| relative < 0.5 * least;
            if best
                .as_ref()
                .is_some_and(|&(least, _)| least < ROUGH && !improves(least))
            {
                break;
            }
            if best.as_ref().is_none_or(|(least, _)| relative < *least) {
                p.copy_from(&next);
                best = Some((relative, schur.clone()));
            }
            if relative == 0.0 || !is_stable {
                break;
            }
            let residual = (&residual + residual.transpose()) * 0.5;
            next += if self.is_discrete {
                schur.stein(&residual)
            } else {
                schur.lyapunov(&residual)
            };
        }
        best
    }
}

/// Norms of row and column `i` of the Hamiltonian matrix, without the diagonal of `A`, which scales do not change.
///
/// The row of `G = B B^T` is bounded by its diagonal, as `g_ik^2 <= g_ii g_kk`: the whole of `G` would have to be
/// computed after each change of a scale.
fn hamiltonian_norms(a: &DMatrix<f64>, b: &DMatrix<f64>, q: &DMatrix<f64>, i: usize) -> (f64, f64) {
    let others = || (0..a.nrows()).filter(|&k| k != i);
    let row = others().map(|k| a[(i, k)] * a[(i, k)]).sum::<f64>();
    let column = others().map(|k| a[(k, i)] * a[(k, i)]).sum::<f64>();
    let row = row + b.row(i).norm_squared() * b.norm_squared();
    let column = column + q.column(i).norm_squared();
    (row.sqrt(), column.sqrt())
}

/// Directions that a positive semidefinite matrix weights, as columns of unit length.
fn range(q: &DMatrix<f64>) -> DMatrix<f64> {
    // Scaled to a unit diagonal, so that weights in different units are not compared.
    let scales = q.diagonal().map(|entry| if entry > 0.0 { entry.sqrt() } else { 1.0 });
    let scaled = DMatrix::from_fn(q.nrows(), q.ncols(), |i, j| q[(i, j)] / (scales[i] * scales[j]));
    let eigen = scaled.symmetric_eigen();
    let least = 1e-13 * eigen.eigenvalues.amax();
    let columns: Vec<_> = (0..q.nrows())
        .filter(|&k| eigen.eigenvalues[k] > least)
        .map(|k| eigen.eigenvectors.column(k).component_mul(&scales))
        .collect();
    match columns.len() {
        0 => DMatrix::zeros(q.nrows(), 0),
        _ => DMatrix::from_columns(&columns),
    }
}
