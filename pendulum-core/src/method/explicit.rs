//! Explicit Runge-Kutta methods with any tableau.

use core::marker::PhantomData;

use nalgebra::SVector;

use crate::cost::Operations;
use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::InMode;
use crate::linear::square;
use crate::method::operations as count;
use crate::method::scheme::{Accepted, OneStep, Scheme, Stalled};
use crate::method::stages::{
    Called, MAX_STAGES, SHORT, combination, is_wide, shift_by_component, shift_by_sum, shifted, shifted_by_sum,
    sum_of_values, sums_wide, weighted_sum,
};
use crate::method::toggle::end_step;
use crate::method::{Adaptive, Fixed};
use crate::real::Real;
use crate::real::lanes::Lanes;
use crate::statistics::Statistics;
use crate::step_size::{Estimates, Tolerance};
use crate::system::System;
use crate::tableau::{Tableau, difference};

/// The explicit Runge-Kutta method of the tableau `B`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Explicit<B, const STAGES: usize>(PhantomData<B>);

impl<B, const STAGES: usize> Explicit<B, STAGES> {
    /// Creates the method.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<B: Tableau<STAGES>, const STAGES: usize> Fixed<Explicit<B, STAGES>> {
    /// Upper bound of the operations of one step, in a system of `n` state components whose right-hand side takes
    /// `rhs`.
    ///
    /// Comparisons and moves of numbers are extra. The choice of the time of a step is included, dense output is not.
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
    /// let step = Rk4::operations(Swing::COST["rhs"].operations, 2 * Swing::DOF);
    /// assert_eq!((step.sincos, step.flops()), (4, 56));
    /// ```
    #[must_use]
    pub const fn operations(rhs: Operations, n: usize) -> Operations {
        stages::<B, STAGES>(rhs, n).and(count::ON_GRID)
    }
}

impl<B: Tableau<STAGES>, const STAGES: usize> Adaptive<Explicit<B, STAGES>> {
    /// Upper bound of the operations of one attempt of a step, in a system of `n` state components whose right-hand
    /// side takes `rhs`. An error above the tolerance takes another attempt.
    ///
    /// Comparisons and moves of numbers are extra. The error and the choice of the next step are included; dense
    /// output, and the choice of the first step with its two evaluations, are not.
    #[must_use]
    pub const fn operations(rhs: Operations, n: usize) -> Operations {
        attempt_within::<B, STAGES>(rhs, n).and(count::CONTROLLED)
    }
}

/// Operations of the stages of a step, including the last one.
const fn stages<B: Tableau<STAGES>, const STAGES: usize>(rhs: Operations, n: usize) -> Operations {
    let mut operations = Operations::ZERO;
    let mut stage = 1;
    while stage < STAGES {
        operations = operations
            .and(count::shifted(&B::TABLEAU.a[stage], n))
            .and(count::TIME)
            .and(rhs);
        stage += 1;
    }
    operations
}

/// Operations of an attempt with its error estimate.
pub(super) const fn attempt_within<B: Tableau<STAGES>, const STAGES: usize>(rhs: Operations, n: usize) -> Operations {
    // the length without its sign
    let length = Operations::new(1, 0, 0, 0, 1, 0);
    let error = count::weighted_sum(&B::TABLEAU.error_weights(), n).and(count::mean_square(n));
    stages::<B, STAGES>(rhs, n).and(length).and(error)
}

/// Operations of [`ExplicitStages::stiffness`] and [`ExplicitStages::error_if_smooth`].
pub(super) const fn stiffness<B: Tableau<STAGES>, const STAGES: usize>(n: usize) -> Operations {
    let apart = count::weighted_sum(&difference(B::TABLEAU.b, B::TABLEAU.a[STAGES - 2]), n).and(count::square(n));
    let change = count::added(n).and(count::square(n));
    let measured = apart.and(change).and(Operations::new(0, 1, 1, 0, 3, 25));
    let off = count::added(n).and(count::multiplied(n)).times(2);
    let off = off.and(Operations::new(0, 0, 0, 0, n, 0));
    let second = off.times(2).and(count::added(n).times(2));
    let ratio = Operations::new(2 * n, 4 * n, 1, 0, 0, 3 * n);
    let if_smooth = second.and(count::mean_square(n)).and(ratio);
    let orders = B::TABLEAU.order_hat - TRAPEZOIDAL;
    measured.and(if_smooth).and(Operations::new(0, 3 + orders, 1, 0, 0, 5))
}

impl<B, S, T, const STAGES: usize, const N: usize> OneStep<S, T, N> for Explicit<B, STAGES>
where
    B: Tableau<STAGES>,
    S: System<T, N> + ?Sized,
    T: Lanes,
{
    type Scheme = ExplicitStages<B, T, STAGES, N>;

    #[inline(always)]
    fn scheme(&self, _system: &S, tolerance: Option<Tolerance<T::Scalar>>) -> Result<Self::Scheme, Reason> {
        let zero = SVector::from_element(T::default());
        Ok(ExplicitStages {
            tolerance: tolerance.map(Tolerance::in_lanes),
            goes_on_at_once: T::LANES > 1 && tolerance.is_none(),
            slope: zero,
            stages: [zero; STAGES],
            coefficients: [zero; MAX_DEGREE],
            tableau: PhantomData,
        })
    }
}

impl<B: Estimates, const STAGES: usize> Estimates for Explicit<B, STAGES> {}

/// Order of the trapezoidal rule.
const TRAPEZOIDAL: usize = 2;

/// Index of the stage whose time is nearest to `c`, as a fraction of the step.
const fn nearest_to<B: Tableau<STAGES>, const STAGES: usize>(c: f64) -> usize {
    let (mut nearest, mut i) = (1, 2);
    while i < STAGES - 2 {
        if (B::TABLEAU.c[i] - c).abs() < (B::TABLEAU.c[nearest] - c).abs() {
            nearest = i;
        }
        i += 1;
    }
    nearest
}

/// Stages of a step of an explicit method.
#[derive(Clone, Copy, Debug)]
pub struct ExplicitStages<B, T, const STAGES: usize, const N: usize> {
    tolerance: Option<Tolerance<T>>,
    /// True if every attempt is accepted, as without a tolerance, and the derivative at its end overwrites the slope:
    /// in lanes, where nothing else reads the last stage.
    goes_on_at_once: bool,
    /// See [`slope`](Self::slope).
    slope: SVector<T, N>,
    stages: [SVector<T, N>; STAGES],
    coefficients: [SVector<T, N>; MAX_DEGREE],
    tableau: PhantomData<B>,
}

impl<B, T: Lanes, const STAGES: usize, const N: usize> ExplicitStages<B, T, STAGES, N> {
    /// Derivative at the start of the next step. It is separate from the stages of the last step, since dense output
    /// needs the first of them. Lanes compute dense output before a step is accepted, and save the copy.
    #[inline(always)]
    fn slope(&mut self) -> &mut SVector<T, N> {
        if const { T::LANES == 1 } {
            &mut self.slope
        } else {
            &mut self.stages[0]
        }
    }

    /// Keeps all stages of a step if dense output is requested.
    #[cfg(feature = "std")]
    pub(crate) fn keep_stages(&mut self, is_dense: bool) {
        self.goes_on_at_once &= !is_dense;
    }
}

impl<B, T, const STAGES: usize, const N: usize> ExplicitStages<B, T, STAGES, N>
where
    B: Tableau<STAGES>,
    T: Lanes,
{
    /// [`Scheme::begin`] with any system.
    #[inline(always)]
    pub(super) fn begin_with(
        &mut self,
        system: &impl System<T, N>,
        t: T,
        x: &SVector<T, N>,
        work: &mut Statistics,
    ) -> SVector<T, N> {
        work.evaluations += 1;
        *self.slope() = system.rhs(t, x);
        *self.slope()
    }

    /// [`Scheme::arrive`] with any system.
    #[inline(always)]
    pub(super) fn arrive_with(
        &mut self,
        system: &impl System<T, N>,
        (t, x): (T, &SVector<T, N>),
        work: &mut Statistics,
    ) -> &SVector<T, N> {
        if T::LANES > 1 && self.goes_on_at_once {
            work.evaluations += 1;
            system.rhs_into(t, x, self.slope());
            return self.slope();
        }
        if self.tolerance.is_none() || const { !B::TABLEAU.error_uses_last_stage() } {
            work.evaluations += 1;
            system.rhs_into(t, x, &mut self.stages[STAGES - 1]);
        }
        &self.stages[STAGES - 1]
    }

    /// [`Scheme::attempt`], with another system for the evaluations. Inlining is not forced without optimisation, where
    /// it would take much of the stack in lanes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn attempt_with<S>(
        &mut self,
        inner: &impl System<T, N>,
        system: &InMode<'_, S, T>,
        (t, x): (T, &SVector<T, N>),
        (t_new, x_new): (T, &mut SVector<T, N>),
        work: &mut Statistics,
    ) -> T
    where
        S: System<T, N> + ?Sized,
    {
        if const { T::LANES == 1 } {
            self.stages[0] = self.slope;
        }
        // Short right-hand sides of generated models are inlined, long ones are calls. Calls are faster than many
        // copies, as of several derivatives. In lanes a function would not use their instructions.
        if const { N <= SHORT && size_of::<T>() <= 2 * size_of::<f64>() || T::LANES > 1 } {
            inner_stages::<B, _, _, _, _>(inner, (t, x), (t_new, x_new), &mut self.stages);
        } else {
            inner_stages::<B, _, _, _, _>(&Called(inner), (t, x), (t_new, x_new), &mut self.stages);
        }
        work.evaluations += STAGES - 2;
        end_step(system, (t, x), (t_new, x_new));
        match &self.tolerance {
            None => T::default(),
            Some(tolerance) => {
                if const { B::TABLEAU.error_uses_last_stage() } {
                    work.evaluations += 1;
                    inner.rhs_into(t_new, x_new, &mut self.stages[STAGES - 1]);
                }
                let weights = const { &B::TABLEAU.error_weights() };
                let h = (t_new - t).abs();
                let error = if tolerance.is_of_values() {
                    sum_of_values(h, weights, &self.stages)
                } else {
                    weighted_sum(h, weights, STAGES, &self.stages)
                };
                tolerance.mean_square(&error, [x, x_new], system.active())
            }
        }
    }

    /// Estimates `|h lambda|` of the last attempt, of length `h`, with the fastest rate `lambda` of the system. The
    /// last two stages are derivatives at two states at the same time; 0 if the states are equal.
    #[inline(always)]
    pub(super) fn stiffness(&self, h: T) -> T {
        let weights = const {
            assert!(
                B::TABLEAU.c[STAGES - 2] == 1.0,
                "the last but one stage is not at the end of the step"
            );
            &difference(B::TABLEAU.b, B::TABLEAU.a[STAGES - 2])
        };
        let apart = square(&weighted_sum(h, weights, STAGES, &self.stages)).sqrt();
        let change = square(&(self.stages[STAGES - 1] - self.stages[STAGES - 2])).sqrt();
        T::from_fn(|lane| {
            let [h, change, apart] = [h, change, apart].map(|length| length.lane(lane));
            if apart > T::Scalar::default() {
                h.abs() * change / apart
            } else {
                T::Scalar::default()
            }
        })
    }

    /// Mean square of the error of the trapezoidal rule over a step, the last attempt, times that of the bend for each
    /// order that the error estimate has more. Along smooth solutions the estimate is much smaller. The bend of a
    /// component is twice the deviation of its derivative from a straight line, relative to the change, and at most 1:
    /// the length of the step times the rate of the solution. Components count by their parts of the error, so that one
    /// whose derivative grows steadily does not hide the others. NaN if all derivatives are straight lines, and 0
    /// without a tolerance.
    #[inline(always)]
    pub(super) fn error_if_smooth(&self, step: &Step<T, N>, active: usize) -> T {
        let Some(tolerance) = &self.tolerance else {
            return T::default();
        };
        let (first, last) = (&self.stages[0], &self.stages[STAGES - 1]);
        let change = last - first;
        // two stages, near the thirds if possible, since a point of inflection may be near one
        let off = |i: usize| {
            let c = B::TABLEAU.c[i];
            let off = self.stages[i] - first - change * T::from_f64(c);
            off.map(|off| (off * T::from_f64(1.0 / (c * (c - 1.0)))).abs())
        };
        let second = const { nearest_to::<B, STAGES>(1.0 / 3.0) };
        let second = off(second) + off(const { nearest_to::<B, STAGES>(2.0 / 3.0) });
        let states = [&step.x0, &step.x1];
        let [size, bend] = tolerance.mean_square_and_ratio([&second, &change], states, active);
        let h = step.h * T::from_f64(1.0 / 12.0);
        let mut error = size * (h * h);
        for _ in TRAPEZOIDAL..B::TABLEAU.order_hat {
            error *= bend;
        }
        error
    }
}

impl<B, S, T, const STAGES: usize, const N: usize> Scheme<S, T, N> for ExplicitStages<B, T, STAGES, N>
where
    B: Tableau<STAGES>,
    S: System<T, N> + ?Sized,
    T: Lanes,
{
    const LEAVES_END: bool = true;

    #[inline(always)]
    fn error_order(&self) -> usize {
        B::TABLEAU.order_hat
    }

    #[inline(always)]
    fn begin(&mut self, system: &InMode<'_, S, T>, t: T, x: &SVector<T, N>, work: &mut Statistics) -> SVector<T, N> {
        self.begin_with(system, t, x, work)
    }

    #[inline(always)]
    fn slope_at_start(&mut self) -> Option<&mut SVector<T, N>> {
        Some(self.slope())
    }

    #[inline(always)]
    fn attempt(
        &mut self,
        system: &InMode<'_, S, T>,
        (t, x): (T, &SVector<T, N>),
        (t_new, x_new): (T, &mut SVector<T, N>),
        work: &mut Statistics,
    ) -> Result<T, Stalled> {
        Ok(self.attempt_with(system, system, (t, x), (t_new, x_new), work))
    }

    #[inline(always)]
    fn arrive(
        &mut self,
        system: &InMode<'_, S, T>,
        end: (T, &SVector<T, N>),
        work: &mut Statistics,
    ) -> Option<&SVector<T, N>> {
        Some(self.arrive_with(system, end, work))
    }

    #[inline(always)]
    fn accept(&mut self, _system: &InMode<'_, S, T>, _step: &Step<T, N>, lanes: Accepted<T>, _work: &mut Statistics) {
        if !(T::LANES > 1 && self.goes_on_at_once) {
            let (others, last) = self.stages.split_at_mut(STAGES - 1);
            let slope = if const { T::LANES == 1 } {
                &mut self.slope
            } else {
                &mut others[0]
            };
            lanes.replace(slope, &last[0]);
        }
    }

    #[inline(always)]
    fn dense(&mut self, system: &InMode<'_, S, T>, step: &Step<T, N>, work: &mut Statistics) -> &[SVector<T, N>] {
        let tableau = const { &B::TABLEAU };
        let mut extra = [SVector::from_element(T::default()); MAX_EXTRA];
        for (i, row) in tableau.extra.iter().enumerate() {
            let change = combination(row.a, (&self.stages, &extra[..i]), step.h);
            extra[i] = system.rhs(step.t0 + step.h * T::from_f64(row.c), &shifted(&step.x0, &change));
        }
        work.evaluations += tableau.extra.len();
        for (coefficient, row) in self.coefficients.iter_mut().zip(tableau.dense) {
            *coefficient = combination(row, (&self.stages, &extra[..tableau.extra.len()]), step.h);
        }
        &self.coefficients[..tableau.dense.len()]
    }

    fn coefficients(&self) -> &[SVector<T, N>] {
        &self.coefficients[..const { B::TABLEAU.dense.len() }]
    }
}

/// Maximum number of extra stages of a dense output.
const MAX_EXTRA: usize = 10;
/// Maximum degree of a dense output, of other methods as well.
pub(crate) const MAX_DEGREE: usize = 9;

/// Evaluates the stages of a step from `(t, x)` to `t_new`, except the first and the last, and sets `x_new` to the
/// state at the end.
///
/// `stages[0]`, the derivative at the start, is given. The last stage is the derivative at the end: `rhs(t_new,
/// x_new)`.
///
/// The stages are unrolled up to `MAX_STAGES` by a macro, since compilers do not unroll a loop over calls of the
/// right-hand side: each stage then has its row of the tableau as constants, and zero coefficients vanish.
#[inline(always)]
fn inner_stages<B, S, T, const STAGES: usize, const N: usize>(
    system: &S,
    (t, x): (T, &SVector<T, N>),
    (t_new, x_new): (T, &mut SVector<T, N>),
    stages: &mut [SVector<T, N>; STAGES],
) where
    B: Tableau<STAGES>,
    S: System<T, N> + ?Sized,
    T: Real,
{
    const {
        assert!(STAGES >= 2 && STAGES <= MAX_STAGES);
        assert!(B::TABLEAU.extra.len() <= MAX_EXTRA && B::TABLEAU.dense.len() <= MAX_DEGREE);
        assert!(
            B::TABLEAU.ends_in_the_next_first_stage(),
            "add the derivative at the end of the step as a last stage of weight 0"
        );
    }
    let h = t_new - t;
    let active = system.active().min(N);
    if const { is_wide::<T, N>() } {
        x_new.data.0[0][active..].copy_from_slice(&x.data.0[0][active..]);
    }
    macro_rules! stages {
        ($($i:literal)*) => { $(
            if $i + 1 < STAGES {
                let row = const { &Row::of::<B>($i) };
                // not t + h, which may differ in the last bit
                let time = if row.c == 1.0 { t_new } else { t + h * T::from_f64(row.c) };
                if const { is_wide::<T, N>() } {
                    // `x_new` has the states of the stages in turn, which saves memory
                    shift_by_component((x, h), (&row.a, $i), stages, (x_new, active));
                    system.rhs_into(time, x_new, &mut stages[$i]);
                } else if const { sums_wide::<T, N>() } {
                    shift_by_sum((x, h), (&row.a, $i), stages, x_new);
                    system.rhs_into(time, x_new, &mut stages[$i]);
                } else {
                    let x = shifted_by_sum((x, h), (&row.a, $i), stages);
                    system.rhs_into(time, &x, &mut stages[$i]);
                }
            }
        )* };
    }
    stages!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18);
    let weights = const { &B::TABLEAU.b };
    if const { is_wide::<T, N>() } {
        shift_by_component((x, h), (weights, STAGES - 1), stages, (x_new, active));
    } else {
        shift_by_sum((x, h), (weights, STAGES - 1), stages, x_new);
    }
}

/// A row of a tableau.
struct Row<const STAGES: usize> {
    a: [f64; STAGES],
    c: f64,
}

impl<const STAGES: usize> Row<STAGES> {
    /// Row `i`; a row of zeros beyond the last one, for unreachable code that is compiled nonetheless.
    const fn of<B: Tableau<STAGES>>(i: usize) -> Self {
        if i < STAGES {
            Self {
                a: B::TABLEAU.a[i],
                c: B::TABLEAU.c[i],
            }
        } else {
            Self {
                a: [0.0; STAGES],
                c: 0.0,
            }
        }
    }
}
