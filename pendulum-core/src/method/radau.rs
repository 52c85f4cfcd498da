//! The methods Radau IIA.

mod iteration;
mod matrix;

use nalgebra::{SMatrix, SVector};

use crate::cost::Operations;
use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::InMode;
use crate::linear::solving;
use crate::method::Adaptive;
use crate::method::collocation;
use crate::method::operations as count;
use crate::method::scheme::{Accepted, OneStep, Scheme, Stalled};
use crate::method::stages::{Called, SHORT};
use crate::method::toggle::end_step;
use crate::real::Float;
use crate::statistics::Statistics;
use crate::step_size::{Estimates, Tolerance};
use crate::system::{Jacobian, System};
use crate::tableau::{HasRadauTableau, RADAU_IIA_5, RADAU_IIA_9, RADAU_IIA_13, RadauTableau};
use iteration::{Iteration, most};
use matrix::Matrix;

/// The methods Radau IIA with three, five or seven stages, for systems with a Jacobian: of order 5, 9 or 13, stiffly
/// accurate and L-stable. `PAIRS` is the number of pairs of complex eigenvalues, one, two or three.
///
/// A step fits a polynomial to the differential equation at `STAGES` times, the last of which is the end of the step.
/// Simplified Newton iterations solve for it, with the Jacobian at the start of the step. While they converge fast, the
/// next steps use the same Jacobian, and steps of the same length the same factored matrix. E. Hairer, G. Wanner,
/// "Solving Ordinary Differential Equations II", 2nd ed. (1996), IV.5 and IV.8; "Stiff differential equations solved by
/// Radau methods", J. Comput. Appl. Math. 111 (1999) 93-111.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RadauIIA<const STAGES: usize = 3, const PAIRS: usize = 1>;

impl HasRadauTableau<3, 1> for RadauIIA<3, 1> {
    const TABLEAU: RadauTableau<3, 1> = RADAU_IIA_5;
}

impl HasRadauTableau<5, 2> for RadauIIA<5, 2> {
    const TABLEAU: RadauTableau<5, 2> = RADAU_IIA_9;
}

impl HasRadauTableau<7, 3> for RadauIIA<7, 3> {
    const TABLEAU: RadauTableau<7, 3> = RADAU_IIA_13;
}

/// Rate of convergence up to which the Jacobian is kept for the next step: the default of Hairer's RADAU5.
const KEEPS_JACOBIAN: f64 = 1e-3;
/// Change of a step within which its length, and with it the factored matrix, is kept.
const KEEPS_LENGTH: (f64, f64) = (0.95, 1.2);
impl<const STAGES: usize, const PAIRS: usize> Adaptive<RadauIIA<STAGES, PAIRS>>
where
    RadauIIA<STAGES, PAIRS>: HasRadauTableau<STAGES, PAIRS>,
{
    /// Upper bound of the operations of one attempt of a step, in a system of `n` state components. `rhs` are the
    /// operations of the right-hand side, `jacobian` those of the right-hand side with the Jacobian. An error above the
    /// tolerance, or an iteration that does not converge, takes another attempt; if the Jacobian was that of an earlier
    /// step, one of the same length.
    ///
    /// The bound assumes the maximum number of iterations, 7, 12 or 17, a new Jacobian and matrix, and two error
    /// estimates. Comparisons and moves of numbers are extra. The choice of the next step is included; dense output and
    /// the choice of the first step are not.
    #[must_use]
    pub const fn operations(rhs: Operations, jacobian: Operations, n: usize) -> Operations {
        let modes = &RadauIIA::<STAGES, PAIRS>::TABLEAU.modes;
        let most = most::<STAGES>();
        let terms = (STAGES - 1) * (n + 1);
        let prediction = Operations::new(terms + 1, terms + n + 1, 0, 0, 0, STAGES + 1).times(STAGES);
        let prediction = prediction
            .and(Operations::new(0, 0, 1, 0, 0, 4))
            .with_chain(3 * STAGES + 1);
        let slopes = count::added(n).and(rhs).and(count::TIME).times(STAGES);
        let residuals = combination::<STAGES>(n).and(count::added(n)).times(STAGES);
        let residuals = residuals.with_chain(STAGES + 2);
        let residuals = residuals.and(Operations::new(0, STAGES * STAGES, 0, 0, 0, 1));
        let changes = collocation::changes(modes, n);
        let norm = count::added(n)
            .and(count::mean_square(n))
            .and(count::added(1))
            .times(STAGES);
        let norm = norm.and(Operations::new(0, 0, 1, 0, 1, 14));
        let decision = Operations::new(1, 2, 2, 0, 0, 12);
        let iteration = slopes.and(residuals).and(changes).and(norm).and(decision);
        // forecast of the error after the remaining iterations
        let forecasts = count::multiplied(1).times(most * (most - 1) / 2);
        let error = count::multiplied(2 * n)
            .and(combination::<STAGES>(n))
            .and(count::added(n));
        let error = error.and(solving::<f64>(n)).and(count::mean_square(n));
        let again = count::added(n).and(rhs).and(error);
        let polynomial = combination::<STAGES>(n).times(STAGES).with_chain(STAGES);
        collocation::pencil(modes, n)
            .and(prediction)
            .and(Operations::new(2, 2, 1, 0, 1, 20))
            .and(iteration.times(most))
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
const fn combination<const STAGES: usize>(n: usize) -> Operations {
    Operations::new((STAGES - 1) * n, STAGES * n, 0, 0, 0, STAGES)
}

impl<S, T, const STAGES: usize, const PAIRS: usize, const N: usize> OneStep<S, T, N> for RadauIIA<STAGES, PAIRS>
where
    Self: HasRadauTableau<STAGES, PAIRS>,
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    type Scheme = RadauStages<T, STAGES, PAIRS, N>;

    #[inline]
    fn scheme(&self, _system: &S, tolerance: Option<Tolerance<T>>) -> Result<Self::Scheme, Reason> {
        let zero = SVector::from_element(T::default());
        Ok(RadauStages {
            tolerance,
            start: zero,
            end: zero,
            next: None,
            matrix: Matrix {
                jacobian: SMatrix::from_element(T::default()),
                is_current: false,
                factored: None,
            },
            iteration: Iteration {
                rises: [zero; STAGES],
                coefficients: [zero; STAGES],
                h: T::default(),
                eta: T::from_f64(1.0),
                rate: T::default(),
            },
            is_doubtful: true,
        })
    }
}

impl<const STAGES: usize, const PAIRS: usize> Estimates for RadauIIA<STAGES, PAIRS> {}

/// Stages of a step of a Radau method.
#[derive(Clone, Copy, Debug)]
pub struct RadauStages<T, const STAGES: usize, const PAIRS: usize, const N: usize> {
    tolerance: Option<Tolerance<T>>,
    /// Derivative at the start of the next step.
    start: SVector<T, N>,
    /// Derivative at the end of the last attempt.
    end: SVector<T, N>,
    /// Jacobian at the end of the last attempt, unless the present one serves the next step as well.
    next: Option<SMatrix<T, N, N>>,
    matrix: Matrix<T, STAGES, PAIRS, N>,
    iteration: Iteration<T, STAGES, N>,
    /// True for the first step, and after a rejected one.
    is_doubtful: bool,
}

impl<T: Float, const STAGES: usize, const PAIRS: usize, const N: usize> RadauStages<T, STAGES, PAIRS, N>
where
    RadauIIA<STAGES, PAIRS>: HasRadauTableau<STAGES, PAIRS>,
{
    const TABLEAU: RadauTableau<STAGES, PAIRS> = RadauIIA::<STAGES, PAIRS>::TABLEAU;

    /// Jacobian of the next step, which may be that at the start of an earlier one.
    pub(super) fn jacobian(&self) -> &SMatrix<T, N, N> {
        &self.matrix.jacobian
    }

    /// Derivative at the end of the last attempt.
    pub(super) fn end(&self) -> &SVector<T, N> {
        &self.end
    }

    /// Error of a step of length `h`: the difference between the slope of its polynomial at the start and the given
    /// `slope` of the system, filtered by the matrix of the iteration. Hairer and Wanner, IV.8, Eq. 8.19.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn error(&self, slope: &SVector<T, N>, h: T, active: usize) -> SVector<T, N> {
        let RadauTableau { modes, powers, .. } = const { &Self::TABLEAU };
        let difference = slope * h - combined(&powers[0], &self.iteration.rises);
        let filtered = match (&modes.real, &self.matrix.factored) {
            (Some(mode), Some((_, pencil))) => pencil.solve_real(&(difference * T::from_f64(mode.value)), active),
            _ => None,
        };
        filtered.unwrap_or(difference)
    }

    /// Mean square error of the solved step, in units of the tolerance.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn estimate<S>(
        &self,
        system: &S,
        (t, x): (T, &SVector<T, N>),
        (h, x_new): (T, &SVector<T, N>),
        work: &mut Statistics,
    ) -> T
    where
        S: System<T, N> + ?Sized,
    {
        let Some(tolerance) = &self.tolerance else {
            return T::default();
        };
        let error = self.error(&self.start, h, system.active());
        let mean_square = tolerance.mean_square(&error, [x, x_new], system.active());
        if mean_square <= T::from_f64(1.0) || !self.is_doubtful {
            return mean_square;
        }
        // the estimate is far too large for components that decay within the step, unless it is filtered once more: Eq.
        // 8.20
        work.evaluations += 1;
        let error = self.error(&system.rhs(t, &(x + error)), h, system.active());
        tolerance.mean_square(&error, [x, x_new], system.active())
    }
}

impl<S, T, const STAGES: usize, const PAIRS: usize, const N: usize> Scheme<S, T, N> for RadauStages<T, STAGES, PAIRS, N>
where
    RadauIIA<STAGES, PAIRS>: HasRadauTableau<STAGES, PAIRS>,
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    #[inline]
    fn error_order(&self) -> usize {
        STAGES
    }

    fn keeps_length(&self) -> (f64, f64) {
        if self.matrix.factored.is_some() {
            KEEPS_LENGTH
        } else {
            (1.0, 1.0)
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn begin(&mut self, system: &InMode<'_, S, T>, t: T, x: &SVector<T, N>, work: &mut Statistics) -> SVector<T, N> {
        self.start = self.matrix.renew(system, t, x, work);
        (self.iteration.h, self.iteration.eta) = (T::default(), T::from_f64(1.0));
        self.is_doubtful = true;
        self.start
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn attempt(
        &mut self,
        system: &InMode<'_, S, T>,
        (t, x): (T, &SVector<T, N>),
        (t_new, x_new): (T, &mut SVector<T, N>),
        work: &mut Statistics,
    ) -> Result<T, Stalled> {
        let Self {
            matrix,
            iteration,
            tolerance,
            ..
        } = self;
        let h = t_new - t;
        let solved = loop {
            let solved = match matrix.factor(h, system.active(), work) {
                Ok(pencil) => {
                    iteration.predict::<PAIRS>(h);
                    let step = ((t, x), t_new);
                    if const { N <= SHORT } {
                        iteration.solve(system, step, *tolerance, pencil, work)
                    } else {
                        iteration.solve(&Called(system), step, *tolerance, pencil, work)
                    }
                }
                Err(stalled) => Err(stalled),
            };
            if solved.is_ok() || matrix.is_current {
                break solved;
            }
            matrix.renew(system, t, x, work);
        };
        *x_new = x + iteration.rises[STAGES - 1];
        end_step(system, (t, x), (t_new, x_new));
        let mean_square = match solved {
            Ok(()) => Ok(self.estimate(system, (t, x), (h, x_new), work)),
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
        // steps of fixed length are solved to the level of rounding, where slow convergence would leave an error
        let is_slow = self.tolerance.is_none() || self.iteration.rate > T::from_f64(KEEPS_JACOBIAN);
        work.evaluations += 1;
        if is_slow {
            work.jacobians += 1;
            let (slope, jacobian) = system.rhs_and_jacobian(t, x);
            (self.end, self.next) = (slope, Some(jacobian));
        } else {
            (self.end, self.next) = (system.rhs(t, x), None);
        }
        Some(&self.end)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn accept(&mut self, _system: &InMode<'_, S, T>, step: &Step<T, N>, _lanes: Accepted<T>, _work: &mut Statistics) {
        let Iteration {
            rises, coefficients, h, ..
        } = &mut self.iteration;
        let powers = const { &Self::TABLEAU.powers };
        *coefficients = core::array::from_fn(|power| combined(&powers[power], rises));
        *h = step.h;
        match self.next {
            Some(jacobian) => self.matrix.set(jacobian),
            None => self.matrix.is_current = false,
        }
        (self.start, self.is_doubtful) = (self.end, false);
    }

    fn dense(&mut self, _system: &InMode<'_, S, T>, _step: &Step<T, N>, _work: &mut Statistics) -> &[SVector<T, N>] {
        &self.iteration.coefficients
    }

    fn coefficients(&self) -> &[SVector<T, N>] {
        &self.iteration.coefficients
    }
}

/// `sum_i weights_i vectors_i`.
#[cfg_attr(not(debug_assertions), inline(always))]
fn combined<T: Float, const STAGES: usize, const N: usize>(
    weights: &[f64; STAGES],
    vectors: &[SVector<T, N>; STAGES],
) -> SVector<T, N> {
    let mut sum = vectors[0] * T::from_f64(weights[0]);
    for i in 1..STAGES {
        sum += vectors[i] * T::from_f64(weights[i]);
    }
    sum
}
