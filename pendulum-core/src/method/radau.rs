//! The method Radau IIA of order 5.

use nalgebra::{SMatrix, SVector};

use crate::cost::Operations;
use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::InMode;
use crate::linear::{Singular, solving};
use crate::method::Adaptive;
use crate::method::collocation::{self, Pencil};
use crate::method::operations as count;
use crate::method::scheme::{Accepted, OneStep, Scheme, Stalled};
use crate::method::stages::{Called, SHORT, shifted, weighted_sum};
use crate::method::toggle::end_step;
use crate::real::Float;
use crate::statistics::Statistics;
use crate::step_size::{Estimates, Tolerance, exp2, log2};
use crate::system::{Jacobian, System};
use crate::tableau::radau_iia5::{A, C, MODES, MU, POWERS, STAGES};

/// The method Radau IIA with three stages, for systems with a Jacobian: of order 5, stiffly accurate and L-stable.
///
/// A step fits a cubic polynomial to the differential equation at three times, the last of which is the end of the
/// step. Simplified Newton iterations solve for it, with the Jacobian at the start of the step. E. Hairer, G. Wanner,
/// "Solving Ordinary Differential Equations II", 2nd ed. (1996), IV.5 and IV.8; "Stiff differential equations solved by
/// Radau methods", J. Comput. Appl. Math. 111 (1999) 93-111.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RadauIIA;

/// Order of the embedded method.
const ORDER_HAT: usize = 3;

/// Maximum number of iterations of a step within a tolerance: if it needs more, a shorter step takes less work.
const MOST: usize = 7;
/// Maximum number of iterations of a step of fixed length, which cannot be shortened.
const MOST_FIXED: usize = 50;
/// Tolerance of steps of fixed length, in ulps: their equations are solved to the level of rounding.
const ULPS: f64 = 100.0;

impl Adaptive<RadauIIA> {
    /// Upper bound of the operations of one attempt of a step, in a system of `n` state components. `rhs` are the
    /// operations of the right-hand side, `jacobian` those of the right-hand side with the Jacobian. An error above the
    /// tolerance, or an iteration that does not converge, takes another attempt.
    ///
    /// The bound assumes seven iterations, the maximum, and two error estimates. Comparisons and moves of numbers are
    /// extra. The choice of the next step is included; dense output and the choice of the first step are not.
    #[must_use]
    pub const fn operations(rhs: Operations, jacobian: Operations, n: usize) -> Operations {
        let prediction = Operations::new(2 * n + 4, 3 * n + 2, 0, 0, 0, 4).times(STAGES);
        let prediction = prediction.and(Operations::new(0, 0, 1, 0, 0, 4)).with_chain(10);
        let slopes = count::added(n).and(rhs).and(count::TIME).times(STAGES);
        let residuals = combination(n).and(count::added(n)).times(STAGES).with_chain(5);
        let residuals = residuals.and(Operations::new(0, STAGES * STAGES, 0, 0, 0, 1));
        let changes = collocation::changes(&MODES, n);
        let norm = count::added(n)
            .and(count::mean_square(n))
            .and(count::added(1))
            .times(STAGES);
        let norm = norm.and(Operations::new(0, 0, 1, 0, 1, 14));
        let decision = Operations::new(1, 2, 2, 0, 0, 12);
        let iteration = slopes.and(residuals).and(changes).and(norm).and(decision);
        // forecast of the error after the remaining iterations
        let forecasts = count::multiplied(1).times(MOST * (MOST - 1) / 2);
        let error = count::multiplied(2 * n).and(combination(n)).and(count::added(n));
        let error = error.and(solving::<f64>(n)).and(count::mean_square(n));
        let again = count::added(n).and(rhs).and(error);
        let polynomial = combination(n).times(STAGES).with_chain(3);
        collocation::pencil(&MODES, n)
            .and(prediction)
            .and(Operations::new(2, 2, 1, 0, 1, 20))
            .and(iteration.times(MOST))
            .and(forecasts)
            .and(count::added(n))
            .and(error)
            .and(again)
            .and(polynomial)
            .and(jacobian)
            .and(count::CONTROLLED)
    }
}

/// Operations of [`combined`].
const fn combination(n: usize) -> Operations {
    Operations::new((STAGES - 1) * n, STAGES * n, 0, 0, 0, STAGES)
}

impl<S, T, const N: usize> OneStep<S, T, N> for RadauIIA
where
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    type Scheme = RadauStages<T, N>;

    #[inline]
    fn scheme(&self, _system: &S, tolerance: Option<Tolerance<T>>) -> Result<Self::Scheme, Reason> {
        let zero = SVector::from_element(T::default());
        Ok(RadauStages {
            tolerance,
            start: (zero, SMatrix::from_element(T::default())),
            end: (zero, SMatrix::from_element(T::default())),
            rises: [zero; STAGES],
            coefficients: [zero; STAGES],
            h: T::default(),
            eta: T::from_f64(1.0),
            is_doubtful: true,
        })
    }
}

impl Estimates for RadauIIA {}

/// Stages of a step of a Radau method.
#[derive(Clone, Copy, Debug)]
pub struct RadauStages<T, const N: usize> {
    tolerance: Option<Tolerance<T>>,
    /// Derivative at the start of the next step, and its derivative by the state.
    start: (SVector<T, N>, SMatrix<T, N, N>),
    /// Derivative at the end of the last attempt, and its derivative by the state.
    end: (SVector<T, N>, SMatrix<T, N, N>),
    /// Differences between the stages and the state at the start.
    rises: [SVector<T, N>; STAGES],
    /// Polynomial of the last step.
    coefficients: [SVector<T, N>; STAGES],
    /// Length of the last step; 0 if there is none.
    h: T,
    /// Ratio of the error of the last iteration to its change.
    eta: T,
    /// True for the first step, and after a rejected one.
    is_doubtful: bool,
}

impl<T: Float, const N: usize> RadauStages<T, N> {
    /// Extrapolates the polynomial of the last step over a step of length `h`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn predict(&mut self, h: T) {
        if self.h == T::default() {
            self.rises = [SVector::from_element(T::default()); STAGES];
            return;
        }
        let one = T::from_f64(1.0);
        let ratio = h / self.h;
        let [c1, c2, c3] = &self.coefficients;
        for (rise, c) in self.rises.iter_mut().zip(C) {
            let excess = ratio * T::from_f64(c);
            let theta = one + excess;
            // theta^k - 1 without cancellation
            let (second, third) = (theta + one, theta * theta + theta + one);
            *rise = (c1 + c2 * second + c3 * third) * excess;
        }
    }

    /// Residuals of the equations of a step.
    #[inline(always)]
    fn residuals<S>(&self, system: &S, (t, x): (T, &SVector<T, N>), t_new: T) -> [SVector<T, N>; STAGES]
    where
        S: System<T, N> + ?Sized,
    {
        let h = t_new - t;
        // loops, since compilers need not inline closures, which are then compiled for the baseline
        let (mut slopes, mut residuals) = (self.rises, self.rises);
        for i in 0..STAGES {
            let time = if C[i] == 1.0 { t_new } else { t + h * T::from_f64(C[i]) };
            slopes[i] = system.rhs(time, &shifted(x, &self.rises[i]));
        }
        for (residual, row) in residuals.iter_mut().zip(&A) {
            *residual -= weighted_sum(h, row, STAGES, &slopes);
        }
        residuals
    }

    /// Solves for the stages.
    #[inline(always)]
    fn iterate<S>(
        &mut self,
        system: &S,
        (t, x): (T, &SVector<T, N>),
        t_new: T,
        pencil: &Pencil<T, STAGES, N>,
        work: &mut Statistics,
    ) -> Result<(), Stalled>
    where
        S: System<T, N> + ?Sized,
    {
        let one = T::from_f64(1.0);
        let ulps = T::from_f64(ULPS) * T::EPSILON;
        let (tolerance, most) = match self.tolerance {
            Some(tolerance) => (tolerance, MOST),
            None => (Tolerance { rtol: ulps, atol: ulps }, MOST_FIXED),
        };
        // factor by which the error of the iteration stays below the tolerance, unless rounding limits it: Hairer and
        // Wanner, IV.8
        let rounding = T::from_f64(10.0) * T::EPSILON / tolerance.rtol;
        let kappa = tolerance.rtol.sqrt().min(T::from_f64(0.03)).max(rounding);
        let mut eta = T::from_f64(exp2(0.8 * log2(self.eta.max(T::EPSILON).to_f64())));
        let mut last = T::default();
        for iteration in 1..=most {
            work.iterations += 1;
            work.evaluations += STAGES;
            let changes = pencil.solve(&self.residuals(system, (t, x), t_new));
            let mut sum = T::default();
            for (rise, change) in self.rises.iter_mut().zip(&changes) {
                *rise -= change;
                sum += tolerance.mean_square(change, [x, x], system.active());
            }
            let norm = (sum / T::from_f64(STAGES as f64)).sqrt();
            if !norm.is_finite() {
                // the state at the end is then not finite either
                return Ok(());
            }
            let mut rate = T::default();
            if iteration > 1 {
                rate = norm / last;
                eta = if rate < one {
                    rate / (one - rate)
                } else {
                    one / T::EPSILON
                };
            }
            if eta * norm <= kappa || norm <= rounding {
                self.eta = eta.min(one);
                return Ok(());
            }
            // stop if the iteration would fail: it diverges, or converges too slowly
            let at_best = (iteration..most).fold(eta * norm, |error, _| error * rate);
            if at_best > kappa {
                return Err(Stalled);
            }
            last = norm;
        }
        Err(Stalled)
    }

    /// Error of a step of length `h`: the difference between the slope of its polynomial at the start and the given
    /// `slope` of the system, filtered by the matrix of the iteration. Hairer and Wanner, IV.8, Eq. 8.19.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn error(&self, slope: &SVector<T, N>, h: T, pencil: &Pencil<T, STAGES, N>) -> SVector<T, N> {
        let difference = (slope * h - combined(&POWERS[0], &self.rises)) * T::from_f64(MU);
        pencil.solve_real(&difference).unwrap_or(difference)
    }

    /// Mean square error of the solved step, in units of the tolerance.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn estimate<S>(
        &self,
        system: &S,
        (t, x): (T, &SVector<T, N>),
        (h, x_new): (T, &SVector<T, N>),
        pencil: &Pencil<T, STAGES, N>,
        work: &mut Statistics,
    ) -> T
    where
        S: System<T, N> + ?Sized,
    {
        let Some(tolerance) = &self.tolerance else {
            return T::default();
        };
        let error = self.error(&self.start.0, h, pencil);
        let mean_square = tolerance.mean_square(&error, [x, x_new], system.active());
        if mean_square <= T::from_f64(1.0) || !self.is_doubtful {
            return mean_square;
        }
        // the estimate is far too large for components that decay within the step, unless it is filtered once more: Eq.
        // 8.20
        work.evaluations += 1;
        let error = self.error(&system.rhs(t, &(x + error)), h, pencil);
        tolerance.mean_square(&error, [x, x_new], system.active())
    }
}

impl<S, T, const N: usize> Scheme<S, T, N> for RadauStages<T, N>
where
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    #[inline]
    fn error_order(&self) -> usize {
        ORDER_HAT
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn begin(&mut self, system: &InMode<'_, S, T>, t: T, x: &SVector<T, N>, work: &mut Statistics) -> SVector<T, N> {
        work.evaluations += 1;
        work.jacobians += 1;
        self.start = system.rhs_and_jacobian(t, x);
        (self.h, self.eta, self.is_doubtful) = (T::default(), T::from_f64(1.0), true);
        self.start.0
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn attempt(
        &mut self,
        system: &InMode<'_, S, T>,
        (t, x): (T, &SVector<T, N>),
        (t_new, x_new): (T, &mut SVector<T, N>),
        work: &mut Statistics,
    ) -> Result<T, Stalled> {
        let h = t_new - t;
        let identity = SMatrix::from_fn(|i, j| T::from_f64(if i == j { 1.0 } else { 0.0 }));
        let pencil = Pencil::new(&MODES, h, [&identity, &self.start.1], system.active()).map_err(|Singular| Stalled)?;
        work.factorizations += pencil.factorizations();
        self.predict(h);
        let solved = if const { N <= SHORT } {
            self.iterate(system, (t, x), t_new, &pencil, work)
        } else {
            self.iterate(&Called(system), (t, x), t_new, &pencil, work)
        };
        *x_new = x + self.rises[STAGES - 1];
        end_step(system, (t, x), (t_new, x_new));
        let mean_square = match solved {
            Ok(()) => Ok(self.estimate(system, (t, x), (h, x_new), &pencil, work)),
            Err(stalled) => Err(stalled),
        };
        self.is_doubtful = true;
        mean_square
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn arrive(
        &mut self,
        system: &InMode<'_, S, T>,
        (t, x): (T, &SVector<T, N>),
        work: &mut Statistics,
    ) -> Option<&SVector<T, N>> {
        work.evaluations += 1;
        work.jacobians += 1;
        self.end = system.rhs_and_jacobian(t, x);
        Some(&self.end.0)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn accept(&mut self, _system: &InMode<'_, S, T>, step: &Step<T, N>, _lanes: Accepted<T>, _work: &mut Statistics) {
        self.start = self.end;
        self.coefficients = core::array::from_fn(|power| combined(&POWERS[power], &self.rises));
        (self.h, self.is_doubtful) = (step.h, false);
    }

    fn dense(&mut self, _system: &InMode<'_, S, T>, _step: &Step<T, N>, _work: &mut Statistics) -> &[SVector<T, N>] {
        &self.coefficients
    }

    fn coefficients(&self) -> &[SVector<T, N>] {
        &self.coefficients
    }
}

/// `sum_i weights_i vectors_i`.
#[cfg_attr(not(debug_assertions), inline(always))]
fn combined<T: Float, const N: usize>(weights: &[f64; STAGES], vectors: &[SVector<T, N>; STAGES]) -> SVector<T, N> {
    let [a, b, c] = weights.map(T::from_f64);
    vectors[0] * a + vectors[1] * b + vectors[2] * c
}
