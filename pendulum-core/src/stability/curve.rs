//! Curves of solutions: equations with one more unknown than equations.

use nalgebra::{Complex, DMatrix, DVector};

use super::StabilityError;
use super::least_squares::shortest_step;

/// Equations whose solutions form a curve. The last unknown is the parameter; all unknowns are scaled to the size 1.
pub(super) trait Curve<const N: usize> {
    /// Solution represented by a point of the curve.
    type Solution: Clone;

    /// Evaluates the equations and their derivatives at a point.
    fn linearize(&self, u: &DVector<f64>) -> Result<Linear, StabilityError>;

    /// Solution at a point of the curve.
    fn solution(&self, u: &DVector<f64>) -> Result<Self::Solution, StabilityError>;

    /// Growth of the modes of a solution (eigenvalues or multipliers), in descending order.
    fn growths(&self, solution: &Self::Solution) -> Vec<Growth>;

    /// Bifurcation at which a pair of eigenvalues or multipliers crosses the stability limit.
    fn of_pair(&self, growth: &Growth) -> super::BifurcationKind;

    /// Real eigenvalue or multiplier at a fold or crossing.
    const REAL_LIMIT: f64;

    /// Test function for a multiplier of -1; only for orbits.
    fn doubling(&self, solution: &Self::Solution) -> Option<Test>;

    /// A copy with smaller errors, to estimate the errors of this curve. `None` if only rounding errors remain.
    fn finer(&self) -> Option<Self>
    where
        Self: Sized;

    /// Half-width of central differences with respect to the parameter, as a fraction of the span. Their error is its
    /// square.
    fn reach(&self) -> f64;

    /// Checks that two nearby points may be joined.
    fn joins(&self, from: &DVector<f64>, to: &DVector<f64>) -> Result<(), StabilityError>;

    /// Difference of two points, modulo full turns.
    fn apart(&self, from: &DVector<f64>, to: &DVector<f64>) -> DVector<f64>;

    /// Relative size below which singular values count as zero. A step below its square root leaves errors below it.
    fn noise(&self) -> f64;
}

/// Equations and their derivatives at a point.
pub(super) struct Linear {
    pub(super) residual: DVector<f64>,
    /// Derivative matrix: one row per equation and one column per unknown, so one more column than rows.
    pub(super) derivative: DMatrix<f64>,
    /// Residual attributable to evaluation errors.
    pub(super) resolution: f64,
}

/// Growth of a mode of a solution.
#[derive(Clone, Copy, Debug)]
pub(super) struct Growth {
    /// Distance beyond the stability limit; negative for modes that decay.
    pub(super) excess: f64,
    pub(super) uncertainty: f64,
    /// Part of `uncertainty` due to rounding.
    pub(super) rounding: f64,
    /// Eigenvalue or multiplier.
    pub(super) value: Complex<f64>,
}

impl Growth {
    /// True if `excess` differs from zero by more than its uncertainty.
    pub(super) fn is_certain(&self) -> bool {
        self.excess.abs() > self.uncertainty
    }
}

/// A test function: it changes sign at a bifurcation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Test {
    pub(super) value: f64,
    /// Size of rounding errors of `value`.
    pub(super) noise: f64,
}

impl Test {
    /// Smallest singular value of a matrix, with the sign of its determinant. `noise` is the rounding error of the
    /// matrix.
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

/// A point of a curve with its tangent, test functions and solution.
#[derive(Clone, Debug)]
pub(super) struct CurvePoint<P> {
    pub(super) u: DVector<f64>,
    /// Direction of the curve, of length 1.
    pub(super) tangent: DVector<f64>,
    /// Test function of the derivatives with the tangent as last row. This matrix is singular where curves cross, but
    /// not at a fold (H. B. Keller, in P. H. Rabinowitz (ed.), "Applications of Bifurcation Theory" (1977) 359).
    pub(super) crossing: Test,
    /// Test function of the derivatives without the parameter column. This matrix is singular at folds, and at a
    /// crossing on the curve without a turning point.
    pub(super) turning: Test,
    pub(super) doubling: Option<Test>,
    /// Error of the parameter due to rounding errors of the equations.
    pub(super) blur: f64,
    pub(super) growths: Vec<Growth>,
    pub(super) solution: P,
    /// Number of Newton iterations.
    pub(super) iterations: usize,
}

impl<P> CurvePoint<P> {
    /// Reverses the direction of the curve.
    pub(super) fn reverse(mut self) -> Self {
        self.tangent.neg_mut();
        self.crossing.value = -self.crossing.value;
        self
    }

    /// Derivative of the scaled parameter with respect to arclength.
    pub(super) fn slope(&self) -> f64 {
        self.tangent[self.tangent.len() - 1]
    }

    /// Scaled parameter.
    pub(super) fn parameter(&self) -> f64 {
        self.u[self.u.len() - 1]
    }
}

/// Computes the point of the curve near `guess` in the plane `normal . u = target`. `before` is a tangent at a nearby
/// point.
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
        // The convergence is quadratic: the error after a step is of the order of its square.
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

/// Direction of the curve through `u` along which the parameter does not decrease: the null vector of the derivatives.
pub(super) fn first_tangent<C: Curve<N>, const N: usize>(
    curve: &C,
    u: &DVector<f64>,
) -> Result<DVector<f64>, StabilityError> {
    let derivative = curve.linearize(u)?.derivative;
    if derivative.iter().any(|entry| !entry.is_finite()) {
        return Err(StabilityError::NotFinite);
    }
    // A square matrix yields all right singular vectors, in descending order of singular values.
    let rows = derivative.nrows();
    let svd = derivative.insert_row(rows, 0.0).svd(false, true);
    let Some(right) = svd.v_t else {
        unreachable!("it was asked for")
    };
    let null = right.row(rows).transpose();
    Ok(if null[rows] < 0.0 { -null } else { null })
}

/// Direction of the curve, oriented like `before`.
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

/// Shift of the parameter along the curve caused by a residual of the equations, without the tangent row.
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
/// Relative rounding error of the equations, in units of the norm of their derivatives.
pub(super) const ROUNDING: f64 = 64.0 * f64::EPSILON;
