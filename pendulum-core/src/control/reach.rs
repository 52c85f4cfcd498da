//! Modes that inputs do not reach, or that outputs do not show.

use nalgebra::linalg::balancing::balance_parlett_reinsch;
use nalgebra::{Complex, DMatrix, DVector};

use crate::stability::{Pair, pairs};

/// A mode of `x' = A x` that is not reached, with its left eigenvector `w`: the inputs do not act on `w . x`.
#[derive(Clone, Debug)]
pub(super) struct Mode {
    pub(super) eigenvalue: Complex<f64>,
    /// Components of `w`, the largest of them 1.
    pub(super) direction: DVector<Complex<f64>>,
    /// Error of the eigenvalue by rounding.
    uncertainty: f64,
}

impl Mode {
    fn new(pair: Pair, direction: DVector<Complex<f64>>) -> Self {
        let mut mode = Self {
            eigenvalue: pair.eigenvalue,
            direction,
            uncertainty: pair.uncertainty,
        };
        mode.rescale(&DVector::repeat(mode.direction.len(), 1.0));
        mode
    }

    /// Multiplies the components of the direction by `scales`, and normalizes it.
    pub(super) fn rescale(&mut self, scales: &DVector<f64>) {
        for (component, &scale) in self.direction.iter_mut().zip(scales.iter()) {
            *component *= scale;
        }
        let largest = self.direction[self.direction.map(Complex::norm).imax()];
        self.direction.iter_mut().for_each(|component| *component /= largest);
    }

    /// The mode with its eigenvalue mirrored at the limit of stability.
    pub(super) fn inverse(&self, is_discrete: bool) -> Self {
        let eigenvalue = if is_discrete {
            self.eigenvalue.inv()
        } else {
            -self.eigenvalue
        };
        Self {
            eigenvalue,
            ..self.clone()
        }
    }
}

/// Length below which the part of a vector of unit length outside of a subspace counts as zero.
pub(super) const NEGLIGIBLE: f64 = 1e-10;

/// Entry of a matrix, relative to the largest in its row or column, that is put down to rounding errors.
const NOISE: f64 = 1e-12;
/// Entry, relative to the largest of the matrix, that is put down to rounding errors; also the effect of an input,
/// relative to the largest effect.
const LEAST: f64 = 1e-16;

/// True if a mode of a matrix of norm `size` decays by more than rounding errors.
pub(super) fn decays(mode: &Mode, size: f64, is_discrete: bool) -> bool {
    let margin = if is_discrete {
        1.0 - mode.eigenvalue.norm()
    } else {
        -mode.eigenvalue.re
    };
    margin > mode.uncertainty + ULPS * f64::EPSILON * size
}

/// Bound on the rounding errors of the separation of a subspace, in ulps of the norm of the matrix.
const ULPS: f64 = 100.0;

/// Modes of `A` that the inputs do not reach by `B`: those of the quotient by the controllable subspace.
///
/// A test by eigenvalues alone fails where a mode that is not reached shares its eigenvalue with one that is. `None` if
/// the eigenvalues do not converge.
pub(super) fn unreached(a: &DMatrix<f64>, b: &DMatrix<f64>) -> Option<Vec<Mode>> {
    Separated::new(a, b).modes()
}

/// A matrix and an orthonormal basis whose first vectors span the controllable subspace.
struct Separated {
    /// Factors of the components of the state.
    scales: DVector<f64>,
    /// The matrix for the scaled state.
    a: DMatrix<f64>,
    basis: Vec<DVector<f64>>,
    /// Dimension of the subspace.
    reached: usize,
}

impl Separated {
    /// The subspace grows by `A` times its last directions until nothing new is found, as in the staircase form (P. Van
    /// Dooren, IEEE Trans. Autom. Control 26 (1981) 111). The state is balanced, and each input is scaled to an effect
    /// of 1, since units that differ by many orders of magnitude hide what is reached. Rounding errors are removed
    /// first: they would decide about the balance of a matrix without eigenvalues other than zero.
    fn new(a: &DMatrix<f64>, b: &DMatrix<f64>) -> Self {
        let n = a.nrows();
        let mut a = without_noise(a);
        let scales = balance_parlett_reinsch(&mut a).map(f64::recip);
        let size = a.norm();
        let effects = b.column_iter().map(|column| column.component_mul(&scales));
        let mut columns: Vec<_> = effects
            .filter(|effect| effect.norm() > 0.0)
            .map(|effect| effect.normalize())
            .collect();
        let mut basis = Vec::new();
        while !columns.is_empty() {
            let known = basis.len();
            extend(&mut basis, columns, NEGLIGIBLE);
            let images = basis[known..].iter().map(|direction| &a * direction / size);
            columns = if size > 0.0 { images.collect() } else { Vec::new() };
        }
        let reached = basis.len();
        let axes = DMatrix::identity(n, n);
        let axes = axes.column_iter().map(|axis| axis.into_owned()).collect();
        extend(&mut basis, axes, 0.1 / n as f64);
        Self {
            scales,
            a,
            basis,
            reached,
        }
    }

    fn modes(&self) -> Option<Vec<Mode>> {
        if self.reached == self.basis.len() {
            return Some(Vec::new());
        }
        let rest = DMatrix::from_columns(&self.basis[self.reached..]);
        let quotient = rest.transpose() * &self.a * &rest;
        let lifted = rest.map(Complex::from);
        let placed = |pair: Pair| {
            let direction = &lifted * &pair.shape;
            let mut mode = Mode::new(pair, direction);
            mode.rescale(&self.scales);
            mode
        };
        Some(pairs(&quotient.transpose()).ok()?.into_iter().map(placed).collect())
    }
}

/// Replaces entries by zero that are as small as rounding errors.
fn without_noise(a: &DMatrix<f64>) -> DMatrix<f64> {
    let rows: Vec<f64> = a.row_iter().map(|row| row.amax()).collect();
    let columns: Vec<f64> = a.column_iter().map(|column| column.amax()).collect();
    let least = LEAST * a.amax();
    DMatrix::from_fn(a.nrows(), a.ncols(), |i, j| {
        let noise = NOISE * rows[i].max(columns[j]);
        if a[(i, j)].abs() > noise.max(least) {
            a[(i, j)]
        } else {
            0.0
        }
    })
}

/// Replaces columns of `B` by zero whose effect on the balanced state is a rounding error beside the largest one, as
/// the size of torques that cancel.
pub(super) fn without_idle(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    let scales = balance_parlett_reinsch(&mut without_noise(a)).map(f64::recip);
    let effects: Vec<f64> = b
        .column_iter()
        .map(|column| column.component_mul(&scales).norm())
        .collect();
    let least = LEAST * effects.iter().copied().fold(0.0, f64::max);
    DMatrix::from_fn(
        b.nrows(),
        b.ncols(),
        |i, j| if effects[j] > least { b[(i, j)] } else { 0.0 },
    )
}

/// Extends an orthonormal basis by vectors, the longest remainder first, until all remainders are shorter than `least`.
fn extend(basis: &mut Vec<DVector<f64>>, mut vectors: Vec<DVector<f64>>, least: f64) {
    // Twice is enough (L. Giraud, J. Langou, M. Rozloznik, Comput. Math. Appl. 50 (2005) 1069).
    for vector in &mut vectors {
        for _ in 0..2 {
            basis.iter().for_each(|known| remove(known, vector));
        }
    }
    loop {
        let longest = (0..vectors.len()).max_by(|&i, &j| vectors[i].norm().total_cmp(&vectors[j].norm()));
        let Some(longest) = longest.filter(|&longest| vectors[longest].norm() > least) else {
            return;
        };
        let mut next = vectors.swap_remove(longest).normalize();
        basis.iter().for_each(|known| remove(known, &mut next));
        next.normalize_mut();
        vectors.iter_mut().for_each(|vector| remove(&next, vector));
        basis.push(next);
    }
}

/// Removes the part of a vector along a direction of unit length.
fn remove(direction: &DVector<f64>, vector: &mut DVector<f64>) {
    vector.axpy(-direction.dot(vector), direction, 1.0);
}

/// Smallest singular value of `[A - lambda I, B]` for each eigenvalue of `A`: the norm of the smallest change of `A`
/// and `B` after which the inputs do not reach a mode with this eigenvalue.
pub(super) fn margins(a: &DMatrix<f64>, b: &DMatrix<f64>) -> Option<Vec<(Complex<f64>, f64)>> {
    let n = a.nrows();
    let margin = |pair: Pair| {
        let pencil = DMatrix::from_fn(n, n + b.ncols(), |i, j| match j.checked_sub(n) {
            Some(j) => Complex::from(b[(i, j)]),
            None if i == j => a[(i, j)] - pair.eigenvalue,
            None => Complex::from(a[(i, j)]),
        });
        (pair.eigenvalue, pencil.singular_values().min())
    };
    Some(pairs(a).ok()?.into_iter().map(margin).collect())
}
