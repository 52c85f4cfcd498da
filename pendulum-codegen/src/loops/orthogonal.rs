//! Orthogonal factorisation.

use std::ops::Add;

use crate::expr::Expr;
use crate::screw::Scalar;

/// A matrix factored into orthogonal columns `Q` times an upper triangle `R` with ones on its diagonal.
pub(crate) struct Orthogonal<'g> {
    /// Orthogonal columns `Q`.
    columns: Vec<Vec<Expr<'g>>>,
    /// Reciprocals of the squared lengths of the columns.
    inverses: Vec<Expr<'g>>,
    /// `R` above its diagonal, row by row: the components of the columns on the right along each column.
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

    /// Least-squares solution `x`, for which the columns times `x` come nearest to `b`.
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

    /// Minimum-norm solution `x`, for which the product of each column and `x` is the entry of `b`.
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

    /// Volume spanned by `columns` over the product of their lengths: 1 if they are orthogonal, 0 if they are linearly
    /// dependent.
    pub(super) fn volume(&self, columns: &[Vec<Expr<'g>>]) -> Expr<'g> {
        let squares = columns.iter().map(|column| dot(column, column));
        let ratios = squares.zip(&self.inverses).map(|(square, &inverse)| square * inverse);
        ratios
            .reduce(|product, ratio| product * ratio)
            .map_or_else(|| columns[0][0].graph().one(), |product| product.sqrt().recip())
    }
}

/// Number of linearly independent columns, up to rounding.
pub(super) fn rank(mut columns: Vec<Vec<f64>>) -> usize {
    /// Remaining length of a linearly dependent column, relative to the largest column.
    const ROUNDING: f64 = 1e-9;
    let square = |column: &[f64]| dot(column, column);
    let largest = columns.iter().map(|column| square(column)).fold(0.0, f64::max);
    let mut rank = 0;
    while let Some(at) = (0..columns.len()).max_by(|&a, &b| square(&columns[a]).total_cmp(&square(&columns[b]))) {
        let own = columns.swap_remove(at);
        let size = square(&own);
        if size <= ROUNDING * ROUNDING * largest || size == 0.0 {
            break;
        }
        rank += 1;
        for column in &mut columns {
            take_off(column, &own, size.recip());
        }
    }
    rank
}

/// Dot product of non-empty vectors.
fn dot<T: Scalar>(a: &[T], b: &[T]) -> T {
    let products: Vec<T> = a.iter().zip(b).map(|(&a, &b)| a * b).collect();
    products.into_iter().reduce(Add::add).expect("an entry")
}

/// Subtracts from a vector its projection on another, where `inverse` is the reciprocal of the squared length of the
/// other. Returns the coefficient of the projection.
fn take_off<T: Scalar>(vector: &mut [T], of: &[T], inverse: T) -> T {
    let share = dot(of, vector) * inverse;
    for (entry, &part) in vector.iter_mut().zip(of) {
        *entry = *entry - share * part;
    }
    share
}
