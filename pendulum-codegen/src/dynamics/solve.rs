//! The solution of `A x = -r`, unrolled.

use std::ops::Range;

use crate::expr::{ExprId, Graph};
use crate::screw::sum;

/// How the system is solved. All give the same value; which is shortest depends on how many right-hand sides there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solver {
    /// Closed form of two unknowns, by the adjugate.
    Adjugate,
    /// Closed form of two unknowns, by the entries of the inverse.
    Inverse,
    /// `L^T D L`, from the last coordinate to the first: the zeros between branches of a tree stay zero (Featherstone
    /// 2008, Sec. 6.5).
    Ldl,
    /// The same with pivots of two coordinates: half the divisions, each of which waits for the one before.
    Pairs,
}

/// A factored matrix.
#[derive(Debug)]
pub struct Factored {
    /// The pivots, from the last coordinate to the first.
    pivots: Vec<Pivot>,
    /// `-L` below the pivots.
    lower: Vec<Vec<ExprId>>,
}

/// Coordinates that are eliminated together, and the negated inverse of their entries: with the minus here no other sign has to change.
#[derive(Debug)]
struct Pivot {
    coordinates: Range<usize>,
    /// The inverse but for a factor that is multiplied last.
    inverse: Vec<Vec<ExprId>>,
    factor: ExprId,
}

impl Factored {
    /// Factors a symmetric matrix. `determinant` is that of a matrix of two rows, where a better form of it is known.
    pub fn new(g: &Graph, solver: Solver, matrix: &[Vec<ExprId>], determinant: Option<ExprId>) -> Self {
        let n = matrix.len();
        let mut a = matrix.to_vec();
        let mut factored = Self {
            pivots: Vec::new(),
            lower: vec![vec![g.zero(); n]; n],
        };
        let mut end = n;
        while end > 0 {
            let paired = match solver {
                Solver::Adjugate | Solver::Inverse => true,
                Solver::Ldl => false,
                Solver::Pairs => end > 1 && !g.is_zero(a[end - 1][end - 2]),
            };
            let determinant = determinant.filter(|_| n == 2);
            let pivot = match determinant {
                _ if paired => Pivot::pair(g, &a, end - 2, determinant, solver == Solver::Adjugate),
                // what is left of a difference of products, taken from where it is known without the difference
                Some(determinant) if end == 1 => {
                    let numerator = g.neg(matrix[1][1]);
                    Pivot::single(g, 0, numerator, determinant)
                }
                _ => {
                    let minus_one = g.integer(-1);
                    Pivot::single(g, end - 1, minus_one, a[end - 1][end - 1])
                }
            };
            end = pivot.coordinates.start;
            factored.eliminate(g, &mut a, pivot);
        }
        factored
    }

    fn eliminate(&mut self, g: &Graph, a: &mut [Vec<ExprId>], pivot: Pivot) {
        let Range { start, end } = pivot.coordinates;
        let columns: Vec<Vec<ExprId>> = (0..start).map(|j| (start..end).map(|k| a[k][j]).collect()).collect();
        for (j, column) in columns.iter().enumerate() {
            for (k, entry) in (start..end).zip(pivot.times(g, column)) {
                self.lower[k][j] = entry;
            }
        }
        let (above, eliminated) = a.split_at_mut(start);
        for (i, row) in above.iter_mut().enumerate() {
            for (j, entry) in row[..=i].iter_mut().enumerate() {
                for (k, of_k) in (start..end).zip(eliminated.iter()) {
                    let change = g.mul(self.lower[k][i], of_k[j]);
                    *entry = g.add(*entry, change);
                }
            }
        }
        self.pivots.push(pivot);
    }

    /// `-A^-1 r`
    pub fn solve_negated(&self, g: &Graph, r: &[ExprId]) -> Vec<ExprId> {
        let mut x = r.to_vec();
        for Pivot { coordinates, .. } in &self.pivots {
            for j in 0..coordinates.start {
                for k in coordinates.clone() {
                    let change = g.mul(self.lower[k][j], x[k]);
                    x[j] = g.add(x[j], change);
                }
            }
        }
        for pivot in self.pivots.iter().rev() {
            let coordinates = &pivot.coordinates;
            let own = pivot.times(g, &x[coordinates.clone()]);
            for (k, own) in coordinates.clone().zip(own) {
                x[k] = own;
                for j in 0..coordinates.start {
                    let change = g.mul(self.lower[k][j], x[j]);
                    x[k] = g.add(x[k], change);
                }
            }
        }
        x
    }
}

impl Pivot {
    fn single(g: &Graph, coordinate: usize, numerator: ExprId, divisor: ExprId) -> Self {
        Self {
            coordinates: coordinate..coordinate + 1,
            inverse: vec![vec![g.div(numerator, divisor)]],
            factor: g.one(),
        }
    }

    /// Two coordinates from `start` on. `late` says that the division is a factor of its own, and not of each entry.
    fn pair(g: &Graph, a: &[Vec<ExprId>], start: usize, determinant: Option<ExprId>, late: bool) -> Self {
        let (first, off, second) = (a[start][start], a[start + 1][start], a[start + 1][start + 1]);
        let determinant = determinant.unwrap_or_else(|| difference(g, first, second, off, off));
        let minus_one = g.integer(-1);
        let reciprocal = g.div(minus_one, determinant);
        let less = g.neg(off);
        let mut inverse = vec![vec![second, less], vec![less, first]];
        let factor = if late {
            reciprocal
        } else {
            for entry in inverse.iter_mut().flatten() {
                *entry = g.mul(*entry, reciprocal);
            }
            g.one()
        };
        Self {
            coordinates: start..start + 2,
            inverse,
            factor,
        }
    }

    /// The negated inverse times a vector.
    fn times(&self, g: &Graph, x: &[ExprId]) -> Vec<ExprId> {
        let row = |row: &Vec<ExprId>| {
            let products: Vec<ExprId> = row.iter().zip(x).map(|(&a, &x)| g.mul(a, x)).collect();
            let sum = sum(g, products);
            g.mul(sum, self.factor)
        };
        self.inverse.iter().map(row).collect()
    }
}

/// `a b - c d`
fn difference(g: &Graph, a: ExprId, b: ExprId, c: ExprId, d: ExprId) -> ExprId {
    let (ab, cd) = (g.mul(a, b), g.mul(c, d));
    g.sub(ab, cd)
}
