//! Small symmetric systems restricted to chosen rows and columns.

use super::MAX_CONSTRAINTS;
use super::mode::{bits, set_of};
use super::resolution::{LAWFUL, UNCOUPLED};
use crate::real::{Float, Real, ulps};

/// Pivot, relative to the diagonal, below which a row depends on those before it and gets no force of its own.
const INDEPENDENT: f64 = 1e-10;

/// Factors `L D L^T` of chosen rows and columns of a symmetric matrix.
pub(super) struct Factored<T> {
    chosen: u8,
    /// `L` below the diagonal, `1/D` on it.
    entries: [[T; MAX_CONSTRAINTS]; MAX_CONSTRAINTS],
}

impl<T: Real> Factored<T> {
    /// Factors the chosen rows and columns, which must be independent.
    #[inline(always)]
    pub(super) fn of(matrix: &[[T; MAX_CONSTRAINTS]; MAX_CONSTRAINTS], chosen: u8) -> Self {
        let mut factored = Self::none();
        for row in bits(chosen) {
            factored.push(matrix, row);
        }
        factored
    }

    #[inline(always)]
    pub(super) fn none() -> Self {
        Self {
            chosen: 0,
            entries: [[T::default(); MAX_CONSTRAINTS]; MAX_CONSTRAINTS],
        }
    }

    /// Appends a row and column, and returns its pivot.
    #[inline(always)]
    fn push(&mut self, matrix: &[[T; MAX_CONSTRAINTS]; MAX_CONSTRAINTS], row: usize) -> T {
        let mut pivot = matrix[row][row];
        // u = D l, for each row before
        for j in bits(self.chosen) {
            let mut u = matrix[row][j];
            for k in bits(self.chosen & before(j)) {
                u -= self.entries[j][k] * self.entries[row][k];
            }
            self.entries[row][j] = u;
        }
        for j in bits(self.chosen) {
            let u = self.entries[row][j];
            let l = u * self.entries[j][j];
            pivot -= l * u;
            self.entries[row][j] = l;
        }
        self.entries[row][row] = T::from_f64(1.0) / pivot;
        self.chosen |= 1 << row;
        pivot
    }

    /// Solves for `-A^-1 b` in the chosen rows; 0 in the others.
    #[inline(always)]
    pub(super) fn solve_negated(&self, b: &[T; MAX_CONSTRAINTS]) -> [T; MAX_CONSTRAINTS] {
        let mut x = [T::default(); MAX_CONSTRAINTS];
        for i in bits(self.chosen) {
            let mut sum = -b[i];
            for k in bits(self.chosen & before(i)) {
                sum -= self.entries[i][k] * x[k];
            }
            x[i] = sum;
        }
        let mut left = self.chosen;
        while left != 0 {
            let i = left.ilog2() as usize;
            left &= before(i);
            let mut sum = x[i] * self.entries[i][i];
            for k in bits(self.chosen & !before(i + 1)) {
                sum -= self.entries[k][i] * x[k];
            }
            x[i] = sum;
        }
        x
    }
}

/// Like [`Factored::solve_negated`], for a matrix used only once.
#[inline(always)]
pub(super) fn solve_negated<T: Real>(
    matrix: &[[T; MAX_CONSTRAINTS]; MAX_CONSTRAINTS],
    chosen: u8,
    b: &[T; MAX_CONSTRAINTS],
) -> [T; MAX_CONSTRAINTS] {
    if chosen.count_ones() > 1 {
        return Factored::of(matrix, chosen).solve_negated(b);
    }
    let mut x = [T::default(); MAX_CONSTRAINTS];
    for row in bits(chosen) {
        x[row] = -b[row] * (T::from_f64(1.0) / matrix[row][row]);
    }
    x
}

/// Mask of the bits below an index.
#[inline(always)]
fn before(place: usize) -> u8 {
    ((1_u16 << place) - 1) as u8
}

/// Chosen rows that are independent of the chosen rows before them.
pub(crate) fn independent<T: Float>(matrix: &[[T; MAX_CONSTRAINTS]; MAX_CONSTRAINTS], chosen: u8) -> u8 {
    if chosen.count_ones() <= 1 {
        let is_independent = |&row: &usize| matrix[row][row] > T::from_f64(INDEPENDENT) * matrix[row][row];
        return set_of(bits(chosen).filter(is_independent));
    }
    let mut factored = Factored::none();
    for row in bits(chosen) {
        let is_independent = factored.push(matrix, row) > T::from_f64(INDEPENDENT) * matrix[row][row];
        if !is_independent {
            factored.chosen &= !(1 << row);
        }
    }
    factored.chosen
}

/// True if a row depends on others, which are independent.
pub(super) fn depends<T: Float>(matrix: &[[T; MAX_CONSTRAINTS]; MAX_CONSTRAINTS], row: usize, others: u8) -> bool {
    independent(matrix, others | 1 << row).count_ones() == others.count_ones()
}

/// Splits a set into groups of rows that are uncoupled to rounding.
pub(super) fn groups<T: Float>(matrix: &[[T; MAX_CONSTRAINTS]; MAX_CONSTRAINTS], set: u8) -> impl Iterator<Item = u8> {
    let acts_on = |n: usize, m: usize| {
        let least = ulps(UNCOUPLED, T::from_f64(1.0));
        matrix[n][m] * matrix[n][m] > least * least * matrix[n][n] * matrix[m][m]
    };
    let mut left = set;
    core::iter::from_fn(move || {
        let mut group = left & left.wrapping_neg();
        loop {
            let more = bits(left & !group).filter(|&n| bits(group).any(|m| acts_on(n, m)));
            let more = set_of(more);
            if more == 0 {
                break;
            }
            group |= more;
        }
        left &= !group;
        (group != 0).then_some(group)
    })
}

/// Impulses `p >= 0` under which rates `w` become `w + A p >= -e w`, with equality in one of the two for each row:
/// Newton's law with one restitution `e`. Only chosen rows take part; `A` is symmetric and positive semidefinite.
pub(super) fn impulses<T: Float>(
    matrix: &[[T; MAX_CONSTRAINTS]; MAX_CONSTRAINTS],
    chosen: u8,
    w: &[T; MAX_CONSTRAINTS],
    e: T,
) -> [T; MAX_CONSTRAINTS] {
    let (zero, one) = (T::default(), T::from_f64(1.0));
    let target: [T; MAX_CONSTRAINTS] = core::array::from_fn(|n| (one + e) * w[n]);
    let size = bits(chosen).fold(zero, |size: T, n| size.max(w[n].abs()));
    let mut best = ([zero; MAX_CONSTRAINTS], T::from_f64(f64::INFINITY));
    // all push in most cases: try that first
    for set in subsets(chosen) {
        let p = solve_negated(matrix, independent(matrix, set), &target);
        let mut violation = zero;
        for n in bits(chosen) {
            let changes = bits(chosen).map(|k| matrix[n][k] * p[k]);
            let (rate, size) = changes.fold((target[n], size), |(rate, size), change| {
                (rate + change, size + change.abs())
            });
            violation = violation.max(-rate / size).max(-p[n] * matrix[n][n] / size);
        }
        if violation < best.1 {
            best = (p, violation);
        }
        if violation <= ulps(LAWFUL, T::from_f64(1.0)) {
            break;
        }
    }
    best.0
}

/// All subsets of a set, larger ones first.
pub(super) fn subsets(set: u8) -> impl Iterator<Item = u8> {
    let parts = move || {
        core::iter::successors(Some(0_u8), move |part| {
            Some(part.wrapping_sub(set) & set).filter(|&part| part != 0)
        })
    };
    (0..=set.count_ones())
        .rev()
        .flat_map(move |count| parts().filter(move |part| part.count_ones() == count))
}
