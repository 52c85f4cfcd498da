//! Operations on series, recorded in rows.

use core::any::Any;
use core::cell::RefCell;

use super::MAX_ORDER;
use crate::real::Real;

/// Index of an operation.
pub(super) type Place = u32;

/// An operation on series. Its operands are other rows.
#[derive(Clone, Copy, Debug)]
pub(super) enum Operation {
    /// Coefficients that are set from outside: those of the state and of time.
    Given,
    /// All but the first coefficient are those of the operand.
    Shift(Place),
    Neg(Place),
    /// Product with the factor of the row.
    Scale(Place),
    Add(Place, Place),
    Sub(Place, Place),
    Mul(Place, Place),
    Square(Place),
    /// Quotient. The factor is the reciprocal of the first coefficient of the divisor.
    Div(Place, Place),
    /// A constant over the operand, with the factor of [`Div`](Self::Div).
    Reciprocal(Place),
    /// Square root. The factor is half the reciprocal of its first coefficient.
    Sqrt(Place),
    /// Coefficients times their orders: the derivative by the logarithm of time.
    Slope(Place),
    /// Inverse of [`Slope`](Self::Slope).
    Integral(Place),
    /// Integral of the product of a slope with a series, times the factor: a function whose derivative by its argument
    /// is this series. Only its lower orders are needed, so that it may be a later row.
    Chain(Place, Place),
}

/// Memory for the power series of [`EquationsSystem`](crate::system::EquationsSystem). It grows with the first series,
/// and is used again by all others.
#[derive(Clone, Debug)]
pub struct Recording<T>(pub(super) Option<Box<Rows<T>>>);

/// The operations of one evaluation of the right-hand side, in their order, each with a factor.
#[derive(Clone, Debug, Default)]
pub(super) struct Rows<T> {
    operations: Vec<(Operation, T)>,
    /// Coefficients of the results. There may be more than operations.
    pub(super) results: Vec<[T; MAX_ORDER + 1]>,
}

std::thread_local! {
    /// The rows being recorded by this thread, as the numbers of a right-hand side are copied and have no place for a
    /// reference to them.
    static RECORDED: RefCell<Option<Box<dyn Any>>> = const { RefCell::new(None) };
}

/// Records in `rows` the operations of an evaluation, in place of those there.
#[inline(always)]
pub(super) fn recorded_in<T: Real, R>(mut rows: Box<Rows<T>>, evaluate: impl FnOnce() -> R) -> (Box<Rows<T>>, R) {
    rows.operations.clear();
    let outer = RECORDED.replace(Some(rows));
    let result = evaluate();
    // an outer recording goes on, whose right-hand side integrates other equations
    let rows = RECORDED.replace(outer).and_then(|rows| rows.downcast().ok());
    (rows.expect("replaced by the same type"), result)
}

/// Adds an operation with the value of its result to the rows being recorded, and returns its place.
#[inline(never)]
pub(super) fn record<T: Real>(operation: Operation, value: &T, factor: &T) -> Place {
    RECORDED.with_borrow_mut(|recorded| {
        let rows = recorded.as_mut().and_then(|rows| rows.downcast_mut::<Rows<T>>());
        rows.expect("equations compute with their own numbers, on one thread")
            .push(operation, value, factor)
    })
}

impl<T: Real> Rows<T> {
    fn push(&mut self, operation: Operation, &value: &T, &factor: &T) -> Place {
        let place = self.operations.len();
        self.operations.push((operation, factor));
        match self.results.get_mut(place) {
            Some(result) => result[0] = value,
            None => self.results.push([value; MAX_ORDER + 1]),
        }
        place as Place
    }

    #[inline(always)]
    pub(super) fn of(&self, place: Place) -> &[T; MAX_ORDER + 1] {
        &self.results[place as usize]
    }

    /// Computes the coefficients of order `k >= 1` of all results that are not given.
    #[inline(always)]
    pub(super) fn advance(&mut self, k: usize) {
        let order = T::from_f64(k as f64);
        let over = T::from_f64(1.0) / order;
        for place in 0..self.operations.len() {
            let (operation, factor) = self.operations[place];
            let coefficient = match operation {
                Operation::Given => continue,
                Operation::Shift(a) => self.of(a)[k],
                Operation::Neg(a) => -self.of(a)[k],
                Operation::Scale(a) => factor * self.of(a)[k],
                Operation::Add(a, b) => self.of(a)[k] + self.of(b)[k],
                Operation::Sub(a, b) => self.of(a)[k] - self.of(b)[k],
                Operation::Mul(a, b) => product(&self.of(a)[..=k], &self.of(b)[..=k]),
                Operation::Square(a) => square(&self.of(a)[..=k]),
                Operation::Div(a, b) => {
                    (self.of(a)[k] - product(&self.of(b)[1..=k], &self.results[place][..k])) * factor
                }
                Operation::Reciprocal(a) => -product(&self.of(a)[1..=k], &self.results[place][..k]) * factor,
                Operation::Sqrt(a) => (self.of(a)[k] - square(&self.results[place][1..k])) * factor,
                Operation::Slope(a) => order * self.of(a)[k],
                Operation::Integral(a) => over * self.of(a)[k],
                Operation::Chain(slope, a) => product(&self.of(slope)[1..=k], &self.of(a)[..k]) * (over * factor),
            };
            self.results[place][k] = coefficient;
        }
    }
}

/// Last coefficient of the product of two series of equal length, in two sums, so that an addition need not wait for
/// the one before.
#[inline(always)]
fn product<T: Real>(left: &[T], right: &[T]) -> T {
    let (mut even, mut odd) = (T::default(), T::default());
    let (pairs_l, rest_l) = left.as_chunks::<2>();
    let (rest_r, pairs_r) = right.as_rchunks::<2>();
    for ([l0, l1], [r1, r0]) in pairs_l.iter().zip(pairs_r.iter().rev()) {
        even = l0.mul_add(*r0, even);
        odd = l1.mul_add(*r1, odd);
    }
    if let ([l], [r]) = (rest_l, rest_r) {
        even = l.mul_add(*r, even);
    }
    even + odd
}

/// Last coefficient of the square of a series: each product of two different coefficients counts twice.
#[inline(always)]
fn square<T: Real>(a: &[T]) -> T {
    let (first, last) = a.split_at(a.len() / 2);
    let half = product(first, &last[a.len() % 2..]);
    let twice = half + half;
    match last {
        [middle, ..] if a.len() % 2 == 1 => middle.mul_add(*middle, twice),
        _ => twice,
    }
}
