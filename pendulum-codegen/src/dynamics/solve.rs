//! Unrolled solution of `A x = -r`.

use std::ops::Range;

use crate::expr::Expr;

/// Method of solution. All give the same value; the shortest depends on the number of right-hand sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Solver {
    /// Closed form for two unknowns, by the adjugate.
    Adjugate,
    /// Closed form for two unknowns, by the entries of the inverse.
    Inverse,
    /// `L^T D L`, from the last coordinate to the first: the zeros between branches of a tree stay zero (Featherstone
    /// 2008, Sec. 6.5).
    Ldl,
}

/// A mass matrix in a form that solves equations.
pub(crate) trait Inverse<'g> {
    /// Returns `-A^-1 r`.
    fn solve_negated(&self, r: &[Expr<'g>]) -> Vec<Expr<'g>>;

    /// [`solve_negated`](Self::solve_negated) for each of several vectors.
    fn solve_each_negated(&self, all: &[Vec<Expr<'g>>]) -> Vec<Vec<Expr<'g>>> {
        all.iter().map(|r| self.solve_negated(r)).collect()
    }
}

/// A factored matrix.
#[derive(Clone, Debug)]
pub(crate) struct Factored<'g> {
    /// The pivots, from the last coordinate to the first.
    pivots: Vec<Pivot<'g>>,
    /// `-L` below the pivots.
    lower: Vec<Vec<Expr<'g>>>,
}

/// Coordinates that are eliminated together, with the negated inverse of their block. With the minus here no other sign
/// has to change.
#[derive(Clone, Debug)]
struct Pivot<'g> {
    coordinates: Range<usize>,
    /// Inverse without its common `factor`, which is multiplied last.
    inverse: Vec<Vec<Expr<'g>>>,
    factor: Expr<'g>,
}

impl<'g> Factored<'g> {
    /// The factored matrix with each entry that is not a number replaced.
    pub(crate) fn with_entries(&self, mut replaced: impl FnMut(Expr<'g>) -> Expr<'g>) -> Self {
        let mut entry = |x: Expr<'g>| if x.as_number().is_some() { x } else { replaced(x) };
        let mut rows = |rows: &[Vec<Expr<'g>>]| -> Vec<Vec<Expr<'g>>> {
            rows.iter().map(|row| row.iter().map(|&x| entry(x)).collect()).collect()
        };
        let lower = rows(&self.lower);
        let pivots = self.pivots.iter().map(|pivot| Pivot {
            coordinates: pivot.coordinates.clone(),
            inverse: rows(&pivot.inverse),
            factor: rows(&[vec![pivot.factor]])[0][0],
        });
        Self {
            pivots: pivots.collect(),
            lower,
        }
    }

    /// Factors a symmetric matrix. `determinant` is the determinant of a matrix with two rows, if
    /// a better form of it is known.
    pub(crate) fn new(solver: Solver, matrix: &[Vec<Expr<'g>>], determinant: Option<Expr<'g>>) -> Self {
        let n = matrix.len();
        let mut a = matrix.to_vec();
        let zeros = |row: &Vec<Expr<'g>>| row.iter().map(|entry| entry.graph().zero()).collect();
        let mut factored = Self {
            pivots: Vec::new(),
            lower: matrix.iter().map(zeros).collect(),
        };
        let mut end = n;
        while end > 0 {
            let paired = solver != Solver::Ldl;
            let determinant = determinant.filter(|_| n == 2);
            let pivot = match determinant {
                _ if paired => Pivot::pair(&a, end - 2, determinant, solver == Solver::Adjugate),
                // the last pivot is a difference of products: the known determinant avoids the difference
                Some(determinant) if end == 1 => Pivot::single(0, -matrix[1][1] / determinant),
                _ => Pivot::single(end - 1, -1 / a[end - 1][end - 1]),
            };
            end = pivot.coordinates.start;
            factored.eliminate(&mut a, pivot);
        }
        factored
    }

    /// Eliminates the coordinates of a pivot: `L_kj = A_kk^-1 A_kj` for these coordinates k and the coordinates j
    /// before, and `A_ij -= L_ki^T A_kj`.
    fn eliminate(&mut self, a: &mut [Vec<Expr<'g>>], pivot: Pivot<'g>) {
        let Range { start, end } = pivot.coordinates;
        let columns: Vec<Vec<Expr<'g>>> = (0..start).map(|j| (start..end).map(|k| a[k][j]).collect()).collect();
        for (j, column) in columns.iter().enumerate() {
            for (k, entry) in (start..end).zip(pivot.times(column)) {
                self.lower[k][j] = entry;
            }
        }
        let (above, eliminated) = a.split_at_mut(start);
        for (i, row) in above.iter_mut().enumerate() {
            for (j, entry) in row[..=i].iter_mut().enumerate() {
                for (k, of_k) in (start..end).zip(eliminated.iter()) {
                    *entry += self.lower[k][i] * of_k[j];
                }
            }
        }
        self.pivots.push(pivot);
    }
}

impl<'g> Inverse<'g> for Factored<'g> {
    /// Solves `L^T D L x = -r`: `y = L^-T r` from the last pivot to the first, then the back substitution
    /// `x = -L^-1 D^-1 y`.
    fn solve_negated(&self, r: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let mut x = r.to_vec();
        for Pivot { coordinates, .. } in &self.pivots {
            for j in 0..coordinates.start {
                for k in coordinates.clone() {
                    x[j] = x[j] + self.lower[k][j] * x[k];
                }
            }
        }
        for pivot in self.pivots.iter().rev() {
            let coordinates = &pivot.coordinates;
            let own = pivot.times(&x[coordinates.clone()]);
            for (k, own) in coordinates.clone().zip(own) {
                x[k] = (0..coordinates.start).fold(own, |sum, j| sum + self.lower[k][j] * x[j]);
            }
        }
        x
    }
}

impl<'g> Pivot<'g> {
    fn single(coordinate: usize, negated_inverse: Expr<'g>) -> Self {
        Self {
            coordinates: coordinate..coordinate + 1,
            inverse: vec![vec![negated_inverse]],
            factor: negated_inverse.graph().one(),
        }
    }

    /// Pivot of two coordinates from `start` on. If `late` is set, the division is a common factor instead of a part of
    /// each entry.
    fn pair(a: &[Vec<Expr<'g>>], start: usize, determinant: Option<Expr<'g>>, late: bool) -> Self {
        let (first, off, second) = (a[start][start], a[start + 1][start], a[start + 1][start + 1]);
        let determinant = determinant.unwrap_or_else(|| first * second - off * off);
        let reciprocal = -1 / determinant;
        let adjugate = vec![vec![second, -off], vec![-off, first]];
        let (inverse, factor) = if late {
            (adjugate, reciprocal)
        } else {
            let scaled = |row: Vec<Expr<'g>>| row.into_iter().map(|entry| entry * reciprocal).collect();
            (adjugate.into_iter().map(scaled).collect(), off.graph().one())
        };
        Self {
            coordinates: start..start + 2,
            inverse,
            factor,
        }
    }

    /// Product of the negated inverse and a vector.
    fn times(&self, x: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let row = |row: &Vec<Expr<'g>>| {
            let products: Vec<Expr<'g>> = row.iter().zip(x).map(|(&a, &x)| a * x).collect();
            self.factor.graph().sum(products) * self.factor
        };
        self.inverse.iter().map(row).collect()
    }
}
