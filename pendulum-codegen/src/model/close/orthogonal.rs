//! Orthogonal columns.

use crate::expr::Expr;

/// A matrix as orthogonal columns `Q` times `R`, an upper triangle with ones on its diagonal.
pub(crate) struct Orthogonal<'g> {
    /// `Q`
    columns: Vec<Vec<Expr<'g>>>,
    /// One over the squared lengths of these.
    inverses: Vec<Expr<'g>>,
    /// `R` above its diagonal: row by row what the columns on the right have of each.
    shares: Vec<Vec<Expr<'g>>>,
}

impl<'g> Orthogonal<'g> {
    pub(crate) fn new(columns: &[Vec<Expr<'g>>]) -> Self {
        let mut rest = columns.to_vec();
        let (mut inverses, mut shares) = (Vec::new(), Vec::new());
        for k in 0..rest.len() {
            let (done, right) = rest.split_at_mut(k + 1);
            let own = &done[k];
            let inverse = dot(own, own).recip();
            shares.push(right.iter_mut().map(|other| take_off(other, own, inverse)).collect());
            inverses.push(inverse);
        }
        Self {
            columns: rest,
            inverses,
            shares,
        }
    }

    /// The `x` for which the columns times `x` come nearest to `b`.
    pub(super) fn solve(&self, mut b: Vec<Expr<'g>>) -> Vec<Expr<'g>> {
        let own = self.columns.iter().zip(&self.inverses);
        let mut x: Vec<Expr<'g>> = own.map(|(own, &inverse)| take_off(&mut b, own, inverse)).collect();
        for k in (0..x.len()).rev() {
            let (before, after) = x.split_at_mut(k + 1);
            for (&share, &known) in self.shares[k].iter().zip(&*after) {
                before[k] -= share * known;
            }
        }
        x
    }

    /// The shortest `x` for which the product of each column and `x` is that entry of `b`.
    pub(crate) fn solve_transposed(&self, mut b: Vec<Expr<'g>>) -> Vec<Expr<'g>> {
        let graph = self.columns[0][0].graph();
        let mut x = vec![graph.zero(); self.columns[0].len()];
        for (k, own) in self.columns.iter().enumerate() {
            let (done, left) = b.split_at_mut(k + 1);
            for (&share, left) in self.shares[k].iter().zip(left) {
                *left -= share * done[k];
            }
            let length = done[k] * self.inverses[k];
            for (x, &part) in x.iter_mut().zip(own) {
                *x += length * part;
            }
        }
        x
    }

    /// The volume of what `columns` span over the product of their lengths: 1 where they are at right angles, 0 where one is a sum of
    /// others.
    pub(super) fn volume(&self, columns: &[Vec<Expr<'g>>]) -> Expr<'g> {
        let squares = columns.iter().map(|column| dot(column, column));
        let ratios = squares.zip(&self.inverses).map(|(square, &inverse)| square * inverse);
        ratios
            .reduce(|product, ratio| product * ratio)
            .map_or_else(|| columns[0][0].graph().one(), |product| product.sqrt().recip())
    }
}

fn dot<'g>(a: &[Expr<'g>], b: &[Expr<'g>]) -> Expr<'g> {
    let products: Vec<Expr<'g>> = a.iter().zip(b).map(|(&a, &b)| a * b).collect();
    a[0].graph().sum(products)
}

/// Takes off a vector what it has of another, and returns how much.
fn take_off<'g>(vector: &mut [Expr<'g>], of: &[Expr<'g>], inverse: Expr<'g>) -> Expr<'g> {
    let share = dot(of, vector) * inverse;
    for (entry, &part) in vector.iter_mut().zip(of) {
        *entry -= share * part;
    }
    share
}
