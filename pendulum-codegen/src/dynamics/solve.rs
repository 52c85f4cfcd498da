//! The solution of `A x = -r`, unrolled.

use crate::expr::{ExprId, Graph};

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
}

/// A factored matrix.
#[derive(Debug)]
pub struct Factored {
    solver: Solver,
    matrix: Vec<Vec<ExprId>>,
    /// The negated reciprocal of the determinant, or of each pivot: with the minus here no other sign has to change.
    pivots: Vec<ExprId>,
    /// `-L` below the diagonal.
    lower: Vec<Vec<ExprId>>,
}

impl Factored {
    /// Factors a symmetric matrix. `determinant` is that of a matrix of two rows, where a better form of it is known.
    pub fn new(g: &mut Graph, solver: Solver, matrix: &[Vec<ExprId>], determinant: Option<ExprId>) -> Self {
        let (n, minus_one) = (matrix.len(), g.integer(-1));
        let mut a = matrix.to_vec();
        let mut pivots = Vec::new();
        let mut lower = vec![vec![g.zero(); n]; n];
        if solver != Solver::Ldl {
            let determinant = determinant.unwrap_or_else(|| difference(g, a[0][0], a[1][1], a[0][1], a[0][1]));
            pivots.push(g.div(minus_one, determinant));
            return Self {
                solver,
                matrix: a,
                pivots,
                lower,
            };
        }
        for k in (0..n).rev() {
            let pivot = match determinant {
                // what is left of a difference of products, taken from where it is known without the difference
                Some(determinant) if k == 0 => {
                    let numerator = g.neg(matrix[1][1]);
                    g.div(numerator, determinant)
                }
                _ => g.div(minus_one, a[k][k]),
            };
            for j in 0..k {
                lower[k][j] = g.mul(a[k][j], pivot);
            }
            let (above, from_k) = a.split_at_mut(k);
            for (i, row) in above.iter_mut().enumerate() {
                for (entry, &of_k) in row[..=i].iter_mut().zip(&from_k[0]) {
                    let change = g.mul(lower[k][i], of_k);
                    *entry = g.add(*entry, change);
                }
            }
            pivots.insert(0, pivot);
        }
        Self {
            solver,
            matrix: a,
            pivots,
            lower,
        }
    }

    /// `-A^-1 r`
    pub fn solve_negated(&self, g: &mut Graph, r: &[ExprId]) -> Vec<ExprId> {
        let n = r.len();
        match self.solver {
            Solver::Adjugate => {
                let a = &self.matrix;
                let first = difference(g, a[1][1], r[0], a[0][1], r[1]);
                let second = difference(g, a[0][0], r[1], a[0][1], r[0]);
                [first, second].map(|x| g.mul(x, self.pivots[0])).to_vec()
            }
            Solver::Inverse => {
                let [first, off, second] =
                    [(1, 1), (0, 1), (0, 0)].map(|(i, j)| g.mul(self.matrix[i][j], self.pivots[0]));
                vec![
                    difference(g, first, r[0], off, r[1]),
                    difference(g, second, r[1], off, r[0]),
                ]
            }
            Solver::Ldl => {
                let mut x = r.to_vec();
                for k in (0..n).rev() {
                    for j in 0..k {
                        let change = g.mul(self.lower[k][j], x[k]);
                        x[j] = g.add(x[j], change);
                    }
                }
                for k in 0..n {
                    x[k] = g.mul(x[k], self.pivots[k]);
                    for j in 0..k {
                        let change = g.mul(self.lower[k][j], x[j]);
                        x[k] = g.add(x[k], change);
                    }
                }
                x
            }
        }
    }
}

/// `a b - c d`
fn difference(g: &mut Graph, a: ExprId, b: ExprId, c: ExprId, d: ExprId) -> ExprId {
    let (ab, cd) = (g.mul(a, b), g.mul(c, d));
    g.sub(ab, cd)
}
