//! Costs of least squares: weighted squares of residuals, such as distances of outputs from where they should be.

use nalgebra::{SMatrix, SVector};

use super::matrix::{plus_product, product, transposed, zeros};
use super::{CostDerivatives, IlqrError, Objective};
use crate::dual::{Dual, variables};
use crate::real::{Float, Real};

/// The `P` residuals of a state of length `N`, in any number type: a [`LeastSquares`] cost keeps them small.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not have {P} residuals of a state of {N} components",
    note = "implement `Residuals<{N}, {P}>`, whose function is generic over `Real`, for its derivatives"
)]
pub trait Residuals<const N: usize, const P: usize> {
    /// Computes the residuals at the time `t`, in s.
    fn residuals<T: Real>(&self, t: T, x: &SVector<T, N>) -> [T; P];
}

/// A cost of least squares: the integral of `r . W r + du . R du` with the [`Residuals`] `r` and diagonal weights, plus
/// `r . Wf r` at the end.
///
/// Derivatives are those of [dual numbers](crate::dual), `2 J^T W r` and, by Gauss and Newton, `2 J^T W J` with the
/// Jacobian `J` of the residuals. A weight has the unit of the cost per second over that of its residual squared.
///
/// ```
/// use pendulum_core::control::{Ilqr, LeastSquares, Residuals};
/// use pendulum_core::prelude::*;
/// use pendulum_core::Real;
///
/// mechanism! {
///     pub Arm {
///         input shoulder: N m, input elbow: N m,
///         gravity: [0, -9.81, 0],
///         body upper on ground {
///             solids: [rod(1, [0, 0, 0], [0.5, 0, 0])], joint: revolute(z), coordinate: a,
///             torque: shoulder, friction: 0.1,
///         }
///         body lower on upper {
///             solids: [rod(1, [0, 0, 0], [0.4, 0, 0])], joint: revolute(z) at [0.5, 0, 0], coordinate: b,
///             torque: elbow, friction: 0.1,
///         }
///         point tip on lower at [0.4, 0, 0],
///         output tip: tip,
///     }
/// }
///
/// /// Distance of the tip from a place, and rates.
/// #[derive(Clone, Copy)]
/// struct Reach {
///     arm: Arm,
///     place: [f64; 2],
/// }
///
/// impl Residuals<4, 4> for Reach {
///     fn residuals<T: Real>(&self, t: T, x: &SVector<T, 4>) -> [T; 4] {
///         let tip = self.arm.cast::<T>().tip(t, x);
///         let [right, up] = self.place.map(T::from_f64);
///         [tip[0] - right, tip[1] - up, x[2], x[3]]
///     }
/// }
///
/// let arm = Arm::new(ArmParams {})?;
/// let reach = Reach { arm, place: [0.2, 0.6] };
/// let cost = LeastSquares::new(reach, [10.0, 10.0, 0.01, 0.01], [1e-3; 2]).end([1e3, 1e3, 10.0, 10.0]);
/// let mut ilqr = Ilqr::<_, _, 4, 2, 60>::new(0.02, cost).limits([-20.0; 2], [20.0; 2]);
/// ilqr.solve(&arm, 0.0, [-1.0, 0.5, 0.0, 0.0])?;
/// let tip = arm.tip(1.2, ilqr.end());
/// assert!((tip[0] - 0.2).abs() < 0.01 && (tip[1] - 0.6).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeastSquares<F, T, const M: usize, const P: usize> {
    residuals: F,
    weights: [T; P],
    end: [T; P],
    r: [T; M],
    rest: [T; M],
}

impl<F, T: Float, const M: usize, const P: usize> LeastSquares<F, T, M, P> {
    /// Creates a cost with the diagonals of the weights `W` of the residuals, each at least 0, and `R` of the inputs,
    /// each above 0.
    #[must_use]
    pub fn new(residuals: F, weights: [T; P], r: [T; M]) -> Self {
        let (end, rest) = ([T::default(); P], [T::default(); M]);
        Self {
            residuals,
            weights,
            end,
            r,
            rest,
        }
    }

    /// Sets the diagonal of the weights `Wf` of the residuals at the end. Default: 0.
    #[must_use]
    pub fn end(mut self, weights: [T; P]) -> Self {
        self.end = weights;
        self
    }

    /// Sets the inputs that cost nothing, such as the torques that hold the goal. Default: 0.
    #[must_use]
    pub fn rest(mut self, inputs: impl Into<[T; M]>) -> Self {
        self.rest = inputs.into();
        self
    }

    /// The residuals, to change their goal before the next pass.
    pub fn residuals_mut(&mut self) -> &mut F {
        &mut self.residuals
    }

    /// Weighted sum of the squares of the residuals.
    #[inline(always)]
    fn squares<const N: usize>(&self, weights: &[T; P], t: T, x: &SVector<T, N>) -> T
    where
        F: Residuals<N, P>,
    {
        let residuals = self.residuals.residuals(t, x);
        let squares = residuals.into_iter().zip(weights);
        let weighted = squares.filter(|(_, weight)| **weight != T::default());
        weighted.fold(T::default(), |sum, (r, &weight)| (weight * r).mul_add(r, sum))
    }

    /// Gradient of [`squares`](Self::squares), and its second derivatives without those of the residuals.
    #[inline(always)]
    fn derivatives<const N: usize>(
        &self,
        weights: &[T; P],
        t: T,
        x: &SVector<T, N>,
    ) -> (SVector<T, N>, SMatrix<T, N, N>)
    where
        F: Residuals<N, P>,
    {
        let residuals = self.residuals.residuals(Dual::constant(t), &variables(x));
        let (mut jacobian, mut weighted) = (zeros::<T, P, N>(), zeros::<T, P, N>());
        let mut values = zeros::<T, P, 1>();
        for (p, residual) in residuals.into_iter().enumerate() {
            // one without a weight may have an infinite slope, such as a distance at its zero
            if weights[p] == T::default() {
                continue;
            }
            values[p] = residual.value;
            for n in 0..N {
                jacobian[(p, n)] = residual.slopes[n];
                weighted[(p, n)] = T::from_f64(2.0) * weights[p] * residual.slopes[n];
            }
        }
        let weighted = transposed(&weighted);
        (plus_product(zeros(), &weighted, &values), product(&weighted, &jacobian))
    }
}

impl<F, T: Float, const N: usize, const M: usize, const P: usize> Objective<T, N, M> for LeastSquares<F, T, M, P>
where
    F: Residuals<N, P>,
{
    #[inline(always)]
    fn running(&self, t: T, x: &SVector<T, N>, u: &[T; M]) -> T {
        let mut cost = self.squares(&self.weights, t, x);
        for ((&u, &rest), &weight) in u.iter().zip(&self.rest).zip(&self.r) {
            let du = u - rest;
            cost = (weight * du).mul_add(du, cost);
        }
        cost
    }

    #[inline(always)]
    fn running_derivatives(&self, t: T, x: &SVector<T, N>, u: &[T; M]) -> CostDerivatives<T, N, M> {
        let (by_state, xx) = self.derivatives(&self.weights, t, x);
        let (mut by_inputs, mut uu) = (zeros::<T, M, 1>(), zeros());
        for m in 0..M {
            let weight = T::from_f64(2.0) * self.r[m];
            (by_inputs[m], uu[(m, m)]) = (weight * (u[m] - self.rest[m]), weight);
        }
        CostDerivatives {
            x: by_state,
            u: by_inputs,
            xx,
            xu: zeros(),
            uu,
        }
    }

    #[inline(always)]
    fn end(&self, t: T, x: &SVector<T, N>) -> T {
        self.squares(&self.end, t, x)
    }

    #[inline(always)]
    fn end_derivatives(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>) {
        self.derivatives(&self.end, t, x)
    }

    fn check(&self) -> Result<(), IlqrError> {
        check("W", &self.weights, false)?;
        check("Wf", &self.end, false)?;
        check("R", &self.r, true)?;
        match self.rest.iter().all(|number| number.is_finite()) {
            true => Ok(()),
            false => Err(IlqrError::NotFinite { what: "the goal" }),
        }
    }
}

/// Checks the diagonal of a matrix of weights.
fn check<T: Float>(what: &'static str, weights: &[T], strictly: bool) -> Result<(), IlqrError> {
    let zero = T::default();
    if !weights.iter().all(|weight| weight.is_finite()) {
        return Err(IlqrError::NotFinite { what });
    }
    match weights
        .iter()
        .all(|&weight| weight > zero || !strictly && weight == zero)
    {
        true => Ok(()),
        false => Err(IlqrError::NotPositive { what, strictly }),
    }
}
