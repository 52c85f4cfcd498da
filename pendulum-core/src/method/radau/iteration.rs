//! Simplified Newton iterations for the stages of a Radau method.

use nalgebra::SVector;

use super::RadauIIA;
use crate::method::collocation::Pencil;
use crate::method::scheme::Stalled;
use crate::method::stages::{shifted, weighted_sum};
use crate::real::Float;
use crate::statistics::Statistics;
use crate::step_size::{Tolerance, exp2, log2};
use crate::system::System;
use crate::tableau::{HasRadauTableau, RadauTableau};

/// Maximum number of iterations of a step within a tolerance, as in Hairer's RADAU: if it needs more, a shorter step
/// takes less work.
pub(super) const fn most<const STAGES: usize>() -> usize {
    7 + 5 * (STAGES - 3) / 2
}

/// Maximum number of iterations of a step of fixed length, which cannot be shortened.
const MOST_FIXED: usize = 50;
/// Tolerance of steps of fixed length, in ulps: their equations are solved to the level of rounding.
const ULPS: f64 = 100.0;

/// Solution for the stages.
#[derive(Clone, Copy, Debug)]
pub(super) struct Iteration<T, const STAGES: usize, const N: usize> {
    /// Differences between the stages and the state at the start.
    pub(super) rises: [SVector<T, N>; STAGES],
    /// Polynomial of the last step.
    pub(super) coefficients: [SVector<T, N>; STAGES],
    /// Length of the last step; 0 if there is none.
    pub(super) h: T,
    /// Ratio of the error of the last iteration to its change.
    pub(super) eta: T,
    /// Ratio of the last two changes in the last attempt; 0 after a single iteration.
    pub(super) rate: T,
}

impl<T: Float, const STAGES: usize, const N: usize> Iteration<T, STAGES, N> {
    /// Extrapolates the polynomial of the last step over a step of length `h`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn predict<const PAIRS: usize>(&mut self, h: T)
    where
        RadauIIA<STAGES, PAIRS>: HasRadauTableau<STAGES, PAIRS>,
    {
        if self.h == T::default() {
            self.rises = [SVector::from_element(T::default()); STAGES];
            return;
        }
        let one = T::from_f64(1.0);
        let ratio = h / self.h;
        let times = const { &RadauIIA::<STAGES, PAIRS>::TABLEAU.c };
        for (rise, &c) in self.rises.iter_mut().zip(times) {
            let excess = ratio * T::from_f64(c);
            let theta = one + excess;
            // theta^k - 1 = (theta - 1) (1 + theta + .. + theta^(k - 1)), without cancellation
            let mut powers = one;
            *rise = self.coefficients[0];
            for coefficient in &self.coefficients[1..] {
                powers = one + theta * powers;
                *rise += coefficient * powers;
            }
            *rise *= excess;
        }
    }

    /// Residuals of the equations of a step.
    #[inline(always)]
    fn residuals<S, const PAIRS: usize>(
        &self,
        system: &S,
        (t, x): (T, &SVector<T, N>),
        t_new: T,
    ) -> [SVector<T, N>; STAGES]
    where
        RadauIIA<STAGES, PAIRS>: HasRadauTableau<STAGES, PAIRS>,
        S: System<T, N> + ?Sized,
    {
        // here and not an argument, so that the coefficients are constants in unrolled loops
        let RadauTableau { a, c, .. } = const { &RadauIIA::<STAGES, PAIRS>::TABLEAU };
        let h = t_new - t;
        // loops, since compilers need not inline closures, which are then compiled for the baseline
        let (mut slopes, mut residuals) = (self.rises, self.rises);
        for i in 0..STAGES {
            let time = if c[i] == 1.0 { t_new } else { t + h * T::from_f64(c[i]) };
            slopes[i] = system.rhs(time, &shifted(x, &self.rises[i]));
        }
        for (residual, row) in residuals.iter_mut().zip(a) {
            *residual -= weighted_sum(h, row, STAGES, &slopes);
        }
        residuals
    }

    /// Solves for the stages, within a tolerance or, without one, to the level of rounding.
    #[inline(always)]
    pub(super) fn solve<S, const PAIRS: usize>(
        &mut self,
        system: &S,
        ((t, x), t_new): ((T, &SVector<T, N>), T),
        tolerance: Option<Tolerance<T>>,
        pencil: &Pencil<T, STAGES, PAIRS, N>,
        work: &mut Statistics,
    ) -> Result<(), Stalled>
    where
        RadauIIA<STAGES, PAIRS>: HasRadauTableau<STAGES, PAIRS>,
        S: System<T, N> + ?Sized,
    {
        let one = T::from_f64(1.0);
        let ulps = T::from_f64(ULPS) * T::EPSILON;
        let (tolerance, most) = match tolerance {
            Some(tolerance) => (tolerance, const { most::<STAGES>() }),
            None => (Tolerance { rtol: ulps, atol: ulps }, MOST_FIXED),
        };
        // factor by which the error of the iteration stays below the tolerance, unless rounding limits it: Hairer and
        // Wanner, IV.8
        let rounding = T::from_f64(10.0) * T::EPSILON / tolerance.rtol;
        let kappa = tolerance.rtol.sqrt().min(T::from_f64(0.03));
        let kappa = kappa.max(rounding * T::from_f64(0.1));
        let mut eta = T::from_f64(exp2(0.8 * log2(self.eta.max(T::EPSILON).to_f64())));
        let mut last = T::default();
        self.rate = T::default();
        for iteration in 1..=most {
            work.iterations += 1;
            work.evaluations += STAGES;
            let modes = const { &RadauIIA::<STAGES, PAIRS>::TABLEAU.modes };
            let residuals = self.residuals::<S, PAIRS>(system, (t, x), t_new);
            let changes = pencil.solve(modes, &residuals, system.active());
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
            if iteration > 1 {
                self.rate = norm / last;
                eta = if self.rate < one {
                    self.rate / (one - self.rate)
                } else {
                    one / T::EPSILON
                };
            }
            if eta * norm <= kappa || norm <= rounding {
                self.eta = eta.min(one);
                return Ok(());
            }
            // stop if the iteration would fail: it diverges, or converges too slowly
            let at_best = (iteration..most).fold(eta * norm, |error, _| error * self.rate);
            if at_best > kappa {
                return Err(Stalled);
            }
            last = norm;
        }
        Err(Stalled)
    }
}
