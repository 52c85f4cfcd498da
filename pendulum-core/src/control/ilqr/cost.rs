//! Costs of motions.

use nalgebra::{SMatrix, SVector};

use super::IlqrError;
use super::boxed::Factor;
use super::matrix::{product, scaled, zeros};
use crate::real::Float;

/// Difference of mirrored entries of a matrix with a unit diagonal that is put down to rounding, in ulps.
const ASYMMETRY_ULPS: f64 = 1e4;
/// Eigenvalue of a matrix with a unit diagonal, per row, that is put down to rounding, in ulps.
const INDEFINITE_ULPS: f64 = 64.0;

/// The cost of a motion: the integral of a running cost, and a cost of the final state. [`Quadratic`] is one, and
/// [`LeastSquares`](super::LeastSquares) another.
///
/// Second derivatives with respect to the state have to be positive semidefinite, and those with respect to the inputs
/// positive definite.
pub trait Objective<T: Float, const N: usize, const M: usize> {
    /// Running cost per second.
    fn running(&self, t: T, x: &SVector<T, N>, u: &[T; M]) -> T;

    /// Derivatives of the running cost.
    fn running_derivatives(&self, t: T, x: &SVector<T, N>, u: &[T; M]) -> CostDerivatives<T, N, M>;

    /// Cost of the final state.
    fn end(&self, t: T, x: &SVector<T, N>) -> T;

    /// Gradient and second derivatives of the cost of the final state.
    fn end_derivatives(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>);

    /// Checks the parameters of the cost before they are used. By default, nothing is wrong.
    ///
    /// # Errors
    /// Those of the cost: [`IlqrError::NotPositive`] and the like.
    fn check(&self) -> Result<(), IlqrError> {
        Ok(())
    }
}

/// Derivatives of a running cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CostDerivatives<T, const N: usize, const M: usize> {
    /// Gradient with respect to the state.
    pub x: SVector<T, N>,
    /// Gradient with respect to the inputs.
    pub u: SVector<T, M>,
    /// Second derivatives with respect to the state.
    pub xx: SMatrix<T, N, N>,
    /// Mixed derivatives: one column per input.
    pub xu: SMatrix<T, N, M>,
    /// Second derivatives with respect to the inputs.
    pub uu: SMatrix<T, M, M>,
}

/// A quadratic cost about a goal: the integral of `dx . Q dx + du . R du`, as for
/// [`StateSpace::lqr`](https://docs.rs/pendulum-core/latest/pendulum_core/control/struct.StateSpace.html#method.lqr),
/// plus `dx . Qf dx` at the end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadratic<T, const N: usize, const M: usize> {
    q: SMatrix<T, N, N>,
    r: SMatrix<T, M, M>,
    end: SMatrix<T, N, N>,
    goal: SVector<T, N>,
    rest: [T; M],
}

impl<T: Float, const N: usize, const M: usize> Quadratic<T, N, M> {
    /// Creates a cost with the weights `Q` of the state and `R` of the inputs. The goal is zero.
    #[must_use]
    pub fn new(q: SMatrix<T, N, N>, r: SMatrix<T, M, M>) -> Self {
        Self {
            q,
            r,
            end: zeros(),
            goal: zeros(),
            rest: [T::default(); M],
        }
    }

    /// Creates a cost with diagonal weights.
    #[must_use]
    pub fn diagonal(q: [T; N], r: [T; M]) -> Self {
        let mut cost = Self::new(zeros(), zeros());
        for (n, weight) in q.into_iter().enumerate() {
            cost.q[(n, n)] = weight;
        }
        for (m, weight) in r.into_iter().enumerate() {
            cost.r[(m, m)] = weight;
        }
        cost
    }

    /// Sets the weights `Qf` of the final state. The cost to go of a regulator that takes over there,
    /// `regulator.cost`, makes a short motion the start of a long one. Default: 0.
    #[must_use]
    pub fn end(mut self, weights: SMatrix<T, N, N>) -> Self {
        self.end = weights;
        self
    }

    /// Sets the goal: a state, and the inputs that hold it. Default: 0.
    #[must_use]
    pub fn goal(mut self, x: impl Into<SVector<T, N>>, u: impl Into<[T; M]>) -> Self {
        (self.goal, self.rest) = (x.into(), u.into());
        self
    }
}

impl<T: Float, const N: usize, const M: usize> Objective<T, N, M> for Quadratic<T, N, M> {
    #[inline(always)]
    fn running(&self, _t: T, x: &SVector<T, N>, u: &[T; M]) -> T {
        let (dx, du) = (minus(x, &self.goal), minus(&(*u).into(), &self.rest.into()));
        dot(&dx, &product(&self.q, &dx)) + dot(&du, &product(&self.r, &du))
    }

    #[inline(always)]
    fn running_derivatives(&self, _t: T, x: &SVector<T, N>, u: &[T; M]) -> CostDerivatives<T, N, M> {
        let (dx, du) = (minus(x, &self.goal), minus(&(*u).into(), &self.rest.into()));
        let two = T::from_f64(2.0);
        let (xx, uu) = (scaled(two, &self.q), scaled(two, &self.r));
        CostDerivatives {
            x: product(&xx, &dx),
            u: product(&uu, &du),
            xx,
            xu: zeros(),
            uu,
        }
    }

    #[inline(always)]
    fn end(&self, _t: T, x: &SVector<T, N>) -> T {
        let dx = minus(x, &self.goal);
        dot(&dx, &product(&self.end, &dx))
    }

    #[inline(always)]
    fn end_derivatives(&self, _t: T, x: &SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>) {
        let xx = scaled(T::from_f64(2.0), &self.end);
        (product(&xx, &minus(x, &self.goal)), xx)
    }

    fn check(&self) -> Result<(), IlqrError> {
        let is_finite = self.goal.iter().chain(&self.rest).all(|number| number.is_finite());
        if !is_finite {
            return Err(IlqrError::NotFinite { what: "the goal" });
        }
        check_weights("Q", &self.q, false)?;
        check_weights("R", &self.r, true)?;
        check_weights("Qf", &self.end, false)
    }
}

/// Checks that a matrix is symmetric and positive semidefinite, or definite.
///
/// The matrix is judged after scaling to a unit diagonal, so that the units of its components do not matter.
fn check_weights<T: Float, const K: usize>(
    what: &'static str,
    matrix: &SMatrix<T, K, K>,
    strictly: bool,
) -> Result<(), IlqrError> {
    if matrix.iter().any(|entry| !entry.is_finite()) {
        return Err(IlqrError::NotFinite { what });
    }
    let (zero, one) = (T::default(), T::from_f64(1.0));
    let mut scales = [one; K];
    for i in 0..K {
        let entry = matrix[(i, i)];
        if entry < zero || strictly && entry == zero {
            return Err(IlqrError::NotPositive { what, strictly });
        }
        if entry > zero {
            scales[i] = entry.sqrt();
        }
    }
    let mut unit = *matrix;
    for i in 0..K {
        for j in 0..K {
            unit[(i, j)] = matrix[(i, j)] / scales[i] / scales[j];
        }
    }
    for i in 0..K {
        for j in 0..i {
            let values = [matrix[(i, j)], matrix[(j, i)]].map(T::to_f64);
            if (unit[(i, j)] - unit[(j, i)]).abs() > T::from_f64(ASYMMETRY_ULPS) * T::EPSILON {
                let entry = [i, j];
                return Err(IlqrError::NotSymmetric { what, entry, values });
            }
        }
    }
    let rounding = T::from_f64(INDEFINITE_ULPS * K as f64) * T::EPSILON;
    for i in 0..K {
        unit[(i, i)] += if strictly { -rounding } else { rounding };
    }
    match Factor::new(&unit, [true; K]) {
        Some(_) => Ok(()),
        None => Err(IlqrError::NotPositive { what, strictly }),
    }
}

#[inline(always)]
fn minus<T: Float, const N: usize>(a: &SVector<T, N>, b: &SVector<T, N>) -> SVector<T, N> {
    SVector::from(T::subtract_each(a.data.0[0], b.data.0[0]))
}

#[inline(always)]
pub(super) fn dot<T: Float, const N: usize>(a: &SVector<T, N>, b: &SVector<T, N>) -> T {
    let mut sum = T::default();
    for n in 0..N {
        sum = a.data.0[0][n].mul_add(b.data.0[0][n], sum);
    }
    sum
}
