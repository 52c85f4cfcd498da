//! Rosenbrock methods with any tableau: implicit methods that solve only linear equations.

use core::marker::PhantomData;

use nalgebra::{SMatrix, SVector};

use crate::cost::Operations;
use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::InMode;
use crate::linear::{Alone, Lu, Pivots, Singular, factoring, solving};
use crate::method::Adaptive;
use crate::method::operations as count;
use crate::method::scheme::{Accepted, OneStep, Scheme, Stalled, stall};
use crate::method::stages::{Called, SHORT, combination, shifted_by_sum, weighted_sum};
use crate::method::toggle::end_step;
use crate::real::Float;
use crate::real::lanes::Lanes;
use crate::statistics::Statistics;
use crate::step_size::{Estimates, Tolerance};
use crate::system::{Jacobian, System};
use crate::tableau::{RosenbrockMethod, RosenbrockTableau, difference};

/// The Rosenbrock method of the tableau `B`, for systems with a Jacobian.
///
/// A step evaluates the Jacobian once, factors one matrix, and solves one system of linear equations for each stage.
/// There is no iteration that could fail to converge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rosenbrock<B, const STAGES: usize>(PhantomData<B>);

impl<B: RosenbrockMethod<STAGES>, const STAGES: usize> Adaptive<Rosenbrock<B, STAGES>> {
    /// Upper bound of the operations of one attempt of a step, in a system of `n` state components. `rhs` are the
    /// operations of the right-hand side, `jacobian` those of the right-hand side with the Jacobian and, if time
    /// occurs, the derivative by the time. An error above the tolerance takes another attempt.
    ///
    /// Comparisons and moves of numbers are extra. The error and the choice of the next step are included; dense output
    /// and the choice of the first step are not.
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    ///
    /// # mechanism! {
    /// #     pub Swing {
    /// #         gravity: [0, -9.81, 0],
    /// #         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle }
    /// #     }
    /// # }
    /// let [rhs, jacobian] = ["rhs", "jacobian"].map(|name| Swing::COST[name].operations);
    /// let step = Rodas5P::operations(rhs, jacobian, 2 * Swing::DOF);
    /// assert_eq!(step.sincos, 8);
    /// ```
    #[must_use]
    pub const fn operations(rhs: Operations, jacobian: Operations, n: usize) -> Operations {
        attempt_within::<B, STAGES>(rhs, jacobian, n).and(count::CONTROLLED)
    }
}

/// Operations of an attempt with its error estimate and the Jacobian at its end.
pub(super) const fn attempt_within<B: RosenbrockMethod<STAGES>, const STAGES: usize>(
    rhs: Operations,
    jacobian: Operations,
    n: usize,
) -> Operations {
    // `identity_minus`
    let matrix = Operations::new(n * n + n, n * n + 1, 0, 0, 0, 4);
    let mut operations = matrix.and(factoring::<f64>(n));
    let mut stage = 0;
    while stage < STAGES {
        let row = Row::<STAGES>::of::<B>(stage);
        if stage > 0 {
            operations = operations.and(count::shifted(&row.a, n)).and(count::TIME).and(rhs);
        }
        let slope = count::multiplied(n).and(count::added(n));
        if row.gamma != 0.0 {
            operations = operations.and(slope);
        }
        let right = count::weighted_sum(&row.c, n).and(slope).and(count::multiplied(1));
        operations = operations.and(right).and(solving::<f64>(n));
        stage += 1;
    }
    let error = count::weighted_sum(&difference(B::TABLEAU.b, B::TABLEAU.b_hat), n);
    let error = error.and(count::mean_square(n));
    operations
        .and(count::shifted(&B::TABLEAU.b, n))
        .and(error)
        .and(jacobian)
}

impl<B, S, T, const STAGES: usize, const N: usize> OneStep<S, T, N> for Rosenbrock<B, STAGES>
where
    B: RosenbrockMethod<STAGES>,
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    type Scheme = RosenbrockStages<B, T, STAGES, N>;

    #[inline]
    fn scheme(&self, _system: &S, tolerance: Option<Tolerance<T>>) -> Result<Self::Scheme, Reason> {
        Ok(RosenbrockStages::new(tolerance))
    }
}

impl<B, const STAGES: usize> Estimates for Rosenbrock<B, STAGES> {}

/// Stages of a step of a Rosenbrock method; `P` are the [`Pivots`] of its matrices.
#[derive(Clone, Copy, Debug)]
pub struct RosenbrockStages<B, T, const STAGES: usize, const N: usize, P = Alone<N>> {
    tolerance: Option<Tolerance<T>>,
    /// Linearizations at the start of the next step and at the end of the last attempt.
    points: [Linearisation<T, N>; 2],
    /// True if the second of them is the start.
    swapped: bool,
    /// The `u_i` of the tableau.
    stages: [SVector<T, N>; STAGES],
    coefficients: [SVector<T, N>; MAX_DEGREE],
    tableau: PhantomData<(B, P)>,
}

/// First-order expansion of a system about a point.
#[derive(Clone, Copy, Debug)]
struct Linearisation<T, const N: usize> {
    slope: SVector<T, N>,
    /// Derivative of the slope by the state.
    jacobian: SMatrix<T, N, N>,
    /// Derivative of the slope by the time.
    drift: SVector<T, N>,
}

impl<T: Lanes, const N: usize> Linearisation<T, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn new<S>(system: &S, t: T, x: &SVector<T, N>, work: &mut Statistics) -> Self
    where
        S: Jacobian<T, N> + ?Sized,
    {
        work.evaluations += 1;
        work.jacobians += 1;
        let (slope, jacobian) = system.rhs_and_jacobian(t, x);
        let drift = system.time_derivative(t, x);
        Self { slope, jacobian, drift }
    }
}

impl<B, T, P, const STAGES: usize, const N: usize> RosenbrockStages<B, T, STAGES, N, P>
where
    B: RosenbrockMethod<STAGES>,
    T: Lanes,
    P: Pivots<T, N>,
{
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn new(tolerance: Option<Tolerance<T::Scalar>>) -> Self {
        let zero = SVector::from_element(T::default());
        let nothing = Linearisation {
            slope: zero,
            jacobian: SMatrix::from_element(T::default()),
            drift: zero,
        };
        Self {
            tolerance: tolerance.map(Tolerance::in_lanes),
            swapped: false,
            points: [nothing; 2],
            stages: [zero; STAGES],
            coefficients: [zero; MAX_DEGREE],
            tableau: PhantomData,
        }
    }

    /// Jacobian at the start of the next step.
    pub(super) fn jacobian(&self) -> &SMatrix<T, N, N> {
        &self.start().jacobian
    }

    /// Derivative at the end of the last attempt.
    pub(super) fn end(&self) -> &SVector<T, N> {
        &self.points[usize::from(!self.swapped)].slope
    }

    /// Linearization at the start of the next step.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn start(&self) -> &Linearisation<T, N> {
        &self.points[usize::from(self.swapped)]
    }

    /// Solves for the stages, which are unrolled for the same reasons as in explicit methods. Returns the state at the
    /// end, and the [defect](Pivots::defect) of the matrix.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn solve_stages<S>(
        &mut self,
        system: &S,
        (t, x): (T, &SVector<T, N>),
        t_new: T,
    ) -> Result<(SVector<T, N>, T), Singular>
    where
        S: System<T, N> + ?Sized,
    {
        const { assert!(STAGES >= 1 && STAGES <= MAX_STAGES && B::TABLEAU.dense.len() <= MAX_DEGREE) };
        let (one, h, active) = (T::from_f64(1.0), t_new - t, system.active());
        let h_gamma = h * T::from_f64(const { B::TABLEAU.gamma });
        let lu = Lu::<T, N, P>::of(identity_minus(h_gamma, &self.start().jacobian), active)?;
        macro_rules! stages {
            ($($i:literal)*) => { $(
                if $i < STAGES {
                    let row = const { &Row::of::<B>($i) };
                    let slope = if $i == 0 {
                        self.start().slope
                    } else {
                        let x = shifted_by_sum((x, one), (&row.a, $i), &self.stages);
                        // not t + h, which may differ in the last bit
                        let time = if row.alpha == 1.0 { t_new } else { t + h * T::from_f64(row.alpha) };
                        system.rhs(time, &x)
                    };
                    let mut right = weighted_sum(one, &row.c, $i, &self.stages);
                    let of_time = h * T::from_f64(row.gamma);
                    for (i, right) in right.data.0[0].iter_mut().enumerate() {
                        let mut slope = slope.data.0[0][i];
                        if row.gamma != 0.0 {
                            slope = of_time.mul_add(self.start().drift.data.0[0][i], slope);
                        }
                        *right = h_gamma.mul_add(slope, *right);
                    }
                    let right = &right.data.0[0];
                    self.stages[$i] = SVector::from(lu.solve(right, active));
                }
            )* };
        }
        stages!(0 1 2 3 4 5 6 7);
        let weights = const { &B::TABLEAU.b };
        let x_new = shifted_by_sum((x, one), (weights, STAGES), &self.stages);
        Ok((x_new, lu.defect()))
    }
}

impl<B, S, T, P, const STAGES: usize, const N: usize> Scheme<S, T, N> for RosenbrockStages<B, T, STAGES, N, P>
where
    B: RosenbrockMethod<STAGES>,
    S: Jacobian<T, N> + ?Sized,
    T: Lanes,
    P: Pivots<T, N>,
{
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn error_order(&self) -> usize {
        B::TABLEAU.order_hat
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn begin(&mut self, system: &InMode<'_, S, T>, t: T, x: &SVector<T, N>, work: &mut Statistics) -> SVector<T, N> {
        self.points[usize::from(self.swapped)] = Linearisation::new(system, t, x, work);
        self.start().slope
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn attempt(
        &mut self,
        system: &InMode<'_, S, T>,
        (t, x): (T, &SVector<T, N>),
        (t_new, x_new): (T, &mut SVector<T, N>),
        work: &mut Statistics,
    ) -> Result<T, Stalled> {
        work.factorizations += 1;
        work.evaluations += STAGES - 1;
        let solved = if const { N <= SHORT || T::LANES > 1 } {
            self.solve_stages(system, (t, x), t_new)
        } else {
            self.solve_stages(&Called(system), (t, x), t_new)
        };
        let (solved, defect) = solved.map_err(|Singular| Stalled)?;
        *x_new = solved;
        end_step(system, (t, x), (t_new, x_new));
        let mean_square = match &self.tolerance {
            None => T::default(),
            Some(tolerance) => {
                let weights = const { &difference(B::TABLEAU.b, B::TABLEAU.b_hat) };
                let error = weighted_sum(T::from_f64(1.0), weights, STAGES, &self.stages);
                tolerance.mean_square(&error, [x, x_new], system.active())
            }
        };
        if const { T::LANES > 1 } && !defect.all_finite() {
            return Ok(stall(defect, x_new, mean_square));
        }
        Ok(mean_square)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn arrive(
        &mut self,
        system: &InMode<'_, S, T>,
        (t, x): (T, &SVector<T, N>),
        work: &mut Statistics,
    ) -> Option<&SVector<T, N>> {
        let end = &mut self.points[usize::from(!self.swapped)];
        *end = Linearisation::new(system, t, x, work);
        Some(&end.slope)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn accept(&mut self, _system: &InMode<'_, S, T>, _step: &Step<T, N>, lanes: Accepted<T>, _work: &mut Statistics) {
        if let Accepted::Negative(_) = lanes {
            // the other lanes restart from their present points
            let (start, end) = (*self.start(), &mut self.points[usize::from(!self.swapped)]);
            end.slope = lanes.select(&end.slope, &start.slope);
            end.drift = lanes.select(&end.drift, &start.drift);
            for (new, old) in end.jacobian.data.0.iter_mut().zip(start.jacobian.data.0) {
                *new = lanes.select(&(*new).into(), &old.into()).data.0[0];
            }
        }
        self.swapped = !self.swapped;
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn dense(&mut self, _system: &InMode<'_, S, T>, _step: &Step<T, N>, _work: &mut Statistics) -> &[SVector<T, N>] {
        let rows = const { B::TABLEAU.dense };
        for (coefficient, row) in self.coefficients.iter_mut().zip(rows) {
            *coefficient = combination(row, (&self.stages, &[]), T::from_f64(1.0));
        }
        &self.coefficients[..rows.len()]
    }

    fn coefficients(&self) -> &[SVector<T, N>] {
        &self.coefficients[..const { B::TABLEAU.dense.len() }]
    }
}

/// Maximum number of unrolled stages.
const MAX_STAGES: usize = 8;
/// Maximum degree of a dense output.
const MAX_DEGREE: usize = 4;

/// `1 - h J`, by columns.
#[cfg_attr(not(debug_assertions), inline(always))]
fn identity_minus<T: Lanes, const N: usize>(h: T, jacobian: &SMatrix<T, N, N>) -> [[T; N]; N] {
    let mut columns = jacobian.data.0;
    for (k, column) in columns.iter_mut().enumerate() {
        for entry in column.iter_mut() {
            *entry = -(h * *entry);
        }
        column[k] += T::from_f64(1.0);
    }
    columns
}

/// A row of a tableau in the form used by the solver: multiplied by `h gamma`, so that entries of the matrix stay
/// bounded for small `h`.
struct Row<const STAGES: usize> {
    a: [f64; STAGES],
    c: [f64; STAGES],
    alpha: f64,
    gamma: f64,
}

impl<const STAGES: usize> Row<STAGES> {
    /// Row `i`; a row of zeros beyond the last one, for unreachable code that is compiled nonetheless.
    const fn of<B: RosenbrockMethod<STAGES>>(i: usize) -> Self {
        let mut row = Self {
            a: [0.0; STAGES],
            c: [0.0; STAGES],
            alpha: 0.0,
            gamma: 0.0,
        };
        if i < STAGES {
            let tableau: RosenbrockTableau<STAGES> = B::TABLEAU;
            row.a = tableau.a[i];
            row.alpha = tableau.alpha[i];
            row.gamma = tableau.gamma_sums[i];
            let mut j = 0;
            while j < STAGES {
                row.c[j] = tableau.gamma * tableau.c[i][j];
                j += 1;
            }
        }
        row
    }
}
