//! Orthogonal columns.

use std::ops::Add;

use crate::expr::Expr;
use crate::screw::Scalar;

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

    /// The volume of what `columns` span over the product of their lengths: 1 where they are at right angles, 0 where
    /// one is a sum of others.
    pub(super) fn volume(&self, columns: &[Vec<Expr<'g>>]) -> Expr<'g> {
        let squares = columns.iter().map(|column| dot(column, column));
        let ratios = squares.zip(&self.inverses).map(|(square, &inverse)| square * inverse);
        ratios
            .reduce(|product, ratio| product * ratio)
            .map_or_else(|| columns[0][0].graph().one(), |product| product.sqrt().recip())
    }
}

/// How many of the columns are no sums of others, up to rounding.
pub(super) fn rank(mut columns: Vec<Vec<f64>>) -> usize {
    /// What is left of a column that is a sum of others, of the size of the largest.
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

/// The scalar product of vectors that are not empty.
fn dot<T: Scalar>(a: &[T], b: &[T]) -> T {
    let products: Vec<T> = a.iter().zip(b).map(|(&a, &b)| a * b).collect();
    products.into_iter().reduce(Add::add).expect("an entry")
}

/// Takes off a vector what it has of another, where `inverse` is one over the square of its length, and returns how
/// much.
fn take_off<T: Scalar>(vector: &mut [T], of: &[T], inverse: T) -> T {
    let share = dot(of, vector) * inverse;
    for (entry, &part) in vector.iter_mut().zip(of) {
        *entry = *entry - share * part;
    }
    share
}
