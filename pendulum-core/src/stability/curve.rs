//! Curves of solutions: one equation fewer than there are unknowns.

use nalgebra::{Complex, DMatrix, DVector};

use super::StabilityError;
use super::least_squares::shortest_step;

/// Equations whose solutions form a curve. The last of the unknowns is the parameter, and all are scaled to have the
/// size of 1.
pub(super) trait Curve<const N: usize> {
    /// What a point of the curve stands for.
    type Solution: Clone;

    /// The equations at a point, and their derivatives.
    fn linearize(&self, u: &DVector<f64>) -> Result<Linear, StabilityError>;

    /// The solution at a point of the curve.
    fn solution(&self, u: &DVector<f64>) -> Result<Self::Solution, StabilityError>;

    /// The rates or multipliers at which small motions about a solution grow, by falling growth.
    fn growths(&self, solution: &Self::Solution) -> Vec<Growth>;

    /// The bifurcation where a pair of these passes the limit of stability.
    fn of_pair(&self, growth: &Growth) -> super::BifurcationKind;

    /// The real eigenvalue or multiplier at the limit of stability where solutions meet.
    const REAL_LIMIT: f64;

    /// Zero where a multiplier is -1; for orbits.
    fn doubling(&self, solution: &Self::Solution) -> Option<Test>;

    /// A copy with smaller errors, to measure those of this one; none where only rounding makes any.
    fn finer(&self) -> Option<Self>
    where
        Self: Sized;

    /// The part of its span to either side over which central differences by the parameter are taken; its square is
    /// their error.
    fn reach(&self) -> f64;

    /// Whether the curve may go on from one point to another close by.
    fn joins(&self, from: &DVector<f64>, to: &DVector<f64>) -> Result<(), StabilityError>;

    /// The difference of two points without full turns.
    fn apart(&self, from: &DVector<f64>, to: &DVector<f64>) -> DVector<f64>;

    /// Singular values below so much of the largest are zero, and steps below its root leave errors below it.
    fn noise(&self) -> f64;
}

/// Equations and their derivatives at a point.
pub(super) struct Linear {
    pub(super) residual: DVector<f64>,
    /// One row for each equation, one column for each unknown: one more.
    pub(super) derivative: DMatrix<f64>,
    /// A residual that errors of the evaluation may make.
    pub(super) resolution: f64,
}

/// How a small motion about a solution grows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Growth {
    /// How far beyond the limit of stability; negative for motions that decay.
    pub(super) excess: f64,
    pub(super) uncertainty: f64,
    /// The part of it that is due to rounding.
    pub(super) rounding: f64,
    /// The eigenvalue or multiplier.
    pub(super) value: Complex<f64>,
}

impl Growth {
    /// True if it is beyond the limit, or within, by more than its uncertainty.
    pub(super) fn is_certain(&self) -> bool {
        self.excess.abs() > self.uncertainty
    }
}

/// A number that passes zero at a bifurcation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Test {
    pub(super) value: f64,
    /// The size of rounding errors of the value.
    pub(super) noise: f64,
}

impl Test {
    /// The least singular value of a matrix with the sign of its determinant; `noise` is that of the matrix.
    pub(super) fn singular(matrix: DMatrix<f64>, noise: f64) -> Self {
        let sign = matrix.determinant().signum();
        let value = sign * matrix.singular_values().min();
        Self { value, noise }
    }

    pub(super) fn is_negative(&self) -> bool {
        self.value < 0.0
    }

    pub(super) fn is_certain(&self) -> bool {
        self.value.abs() > self.noise
    }
}

/// A point of a curve with all that is known there.
#[derive(Clone, Debug)]
pub(super) struct CurvePoint<P> {
    pub(super) u: DVector<f64>,
    /// The direction of the curve, of length 1.
    pub(super) tangent: DVector<f64>,
    /// Of the derivatives with the tangent as a last row, which are singular where curves cross, and not at a fold (H.
    /// B. Keller, in P. H. Rabinowitz (ed.), "Applications of Bifurcation Theory" (1977) 359).
    pub(super) crossing: Test,
    /// Of the derivatives by all but the parameter: singular at folds, and where curves cross on that which does not
    /// turn back.
    pub(super) turning: Test,
    pub(super) doubling: Option<Test>,
    /// How far rounding errors of the equations may move the parameter.
    pub(super) blur: f64,
    pub(super) growths: Vec<Growth>,
    pub(super) solution: P,
    /// The steps of Newton's method that it took.
    pub(super) iterations: usize,
}

impl<P> CurvePoint<P> {
    /// The curve in the other direction.
    pub(super) fn reverse(mut self) -> Self {
        self.tangent.neg_mut();
        self.crossing.value = -self.crossing.value;
        self
    }

    /// How the parameter grows along the curve.
    pub(super) fn slope(&self) -> f64 {
        self.tangent[self.tangent.len() - 1]
    }

    /// The parameter, scaled.
    pub(super) fn parameter(&self) -> f64 {
        self.u[self.u.len() - 1]
    }
}

/// The point of the curve, near `guess`, in the plane `normal . u = target`; `before` is the tangent there or close by.
pub(super) fn correct<C: Curve<N>, const N: usize>(
    curve: &C,
    guess: DVector<f64>,
    (normal, target): (&DVector<f64>, f64),
    before: &DVector<f64>,
) -> Result<CurvePoint<C::Solution>, StabilityError> {
    let mut u = guess;
    let mut linear = curve.linearize(&u)?;
    let mut iterations = 0;
    let mut settled = false;
    while !settled {
        if iterations == ITERATIONS {
            return Err(no_convergence(&linear));
        }
        let mut residual = linear.residual.clone();
        residual = residual.push(normal.dot(&u) - target);
        let step = shortest_step(bordered(&linear.derivative, normal), &residual, curve.noise())?;
        // The error that a step leaves is of the order of its square.
        settled = step.norm() <= 0.01 * curve.noise().sqrt() * (1.0 + u.norm());
        u += step;
        linear = curve.linearize(&u)?;
        iterations += 1;
    }
    if linear.residual.norm() > linear.resolution {
        return Err(no_convergence(&linear));
    }
    let tangent = tangent(curve, &linear, before)?;
    let matrix = bordered(&linear.derivative, &tangent);
    let (rows, rounding) = (linear.derivative.nrows(), ROUNDING * matrix.norm());
    let reach = curve.reach();
    let by_parameter = reach * reach * linear.derivative.column(rows).norm();
    let solution = curve.solution(&u)?;
    Ok(CurvePoint {
        blur: blur(&matrix, rounding * (1.0 + u.norm())),
        crossing: Test::singular(matrix, rounding + by_parameter),
        turning: Test::singular(linear.derivative.columns(0, rows).into_owned(), rounding),
        tangent,
        doubling: curve.doubling(&solution),
        growths: curve.growths(&solution),
        solution,
        u,
        iterations,
    })
}

/// The direction of the curve through `u`, on which the parameter does not fall: the null vector of the derivatives.
pub(super) fn first_tangent<C: Curve<N>, const N: usize>(
    curve: &C,
    u: &DVector<f64>,
) -> Result<DVector<f64>, StabilityError> {
    let derivative = curve.linearize(u)?.derivative;
    if derivative.iter().any(|entry| !entry.is_finite()) {
        return Err(StabilityError::NotFinite);
    }
    // Square, for all of the vectors; they belong to falling singular values.
    let rows = derivative.nrows();
    let svd = derivative.insert_row(rows, 0.0).svd(false, true);
    let Some(right) = svd.v_t else {
        unreachable!("it was asked for")
    };
    let null = right.row(rows).transpose();
    Ok(if null[rows] < 0.0 { -null } else { null })
}

/// The direction of the curve, on the side of `before`.
fn tangent<C: Curve<N>, const N: usize>(
    curve: &C,
    linear: &Linear,
    before: &DVector<f64>,
) -> Result<DVector<f64>, StabilityError> {
    let rows = linear.derivative.nrows();
    let mut ahead = DVector::zeros(rows + 1);
    ahead[rows] = -1.0;
    let tangent = shortest_step(bordered(&linear.derivative, before), &ahead, curve.noise())?;
    let length = tangent.norm();
    Ok(tangent / length)
}

/// How far the parameter moves along the curve by a residual: what the equations alone do, without the tangent's row.
fn blur(bordered: &DMatrix<f64>, residual: f64) -> f64 {
    let last = bordered.nrows() - 1;
    let mut parameter = DVector::zeros(last + 1);
    parameter[last] = 1.0;
    let row = bordered.transpose().lu().solve(&parameter);
    row.map_or(0.0, |row| row.rows(0, last).norm() * residual)
}

fn bordered(derivative: &DMatrix<f64>, row: &DVector<f64>) -> DMatrix<f64> {
    let rows = derivative.nrows();
    let mut matrix = derivative.clone().insert_row(rows, 0.0);
    matrix.row_mut(rows).tr_copy_from(row);
    matrix
}

fn no_convergence(linear: &Linear) -> StabilityError {
    StabilityError::NoConvergence {
        iterations: ITERATIONS,
        residual: linear.residual.amax(),
    }
}

const ITERATIONS: usize = 8;
/// Rounding errors of the equations, in parts of the size of their derivatives.
pub(super) const ROUNDING: f64 = 64.0 * f64::EPSILON;
