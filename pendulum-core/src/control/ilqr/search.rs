//! The search for the best motion: passes and their damping.

use nalgebra::SVector;

use super::backward::{Backward, Promise};
use super::forward::Forward;
use super::kink::Tilt;
use super::line_search::NoShare;
use super::{Ilqr, IlqrError, Objective, StepMap};
use crate::real::lanes::Isa;
use crate::real::{Float, ulps};
use crate::system::IntoState;

/// Factor by which the damping changes, more at each change in the same direction.
const DAMPING_FACTOR: f64 = 2.0;
/// Least damping that is not zero.
const LEAST_DAMPING: f64 = 1e-6;
/// Damping after which the search ends.
const LARGEST_DAMPING: f64 = 1e8;
/// Number of decreases in a row below the tolerance, under damping too, after which a search among kinks ends.
const PATIENCE: usize = 10;
/// Decrease of the cost put down to rounding, in ulps.
const ROUNDING_ULPS: f64 = 64.0;

/// A motion that [`Ilqr::solve`] has found.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Solved<T> {
    /// Cost of the motion.
    pub cost: T,
    /// Number of iterations.
    pub iterations: usize,
}

/// One pass over the motion, [`Ilqr::pass`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Pass<T> {
    /// Cost of the motion after the pass.
    pub cost: T,
    /// Its cost before, with the inputs and gains of the last pass.
    pub cost_before: T,
    /// Share of the change of the inputs that was taken: 1, a half, and so on; 0 if none decreases the cost.
    pub share: T,
}

/// Strength of the damping, which grows after failures and decays after successes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Damping<T> {
    value: T,
    factor: T,
}

impl<T: Float> Damping<T> {
    pub(super) fn none() -> Self {
        Self {
            value: T::default(),
            factor: T::from_f64(1.0),
        }
    }

    fn grow(&mut self) {
        let by = T::from_f64(DAMPING_FACTOR);
        self.factor = by.max(self.factor * by);
        self.value = T::from_f64(LEAST_DAMPING).max(self.value * self.factor);
    }

    fn decay(&mut self) {
        let by = T::from_f64(1.0 / DAMPING_FACTOR);
        self.factor = by.min(self.factor * by);
        self.value *= self.factor;
        if self.value < T::from_f64(LEAST_DAMPING) {
            self.value = T::default();
        }
    }
}

impl<C, T: Float, const N: usize, const M: usize, const K: usize> Ilqr<C, T, N, M, K>
where
    C: Objective<T, N, M>,
{
    /// Searches for the motion of least cost from the state `x0` at `t0`, beginning with the inputs and gains of the
    /// last motion, or the inputs of [`start`](Self::start).
    ///
    /// The motion found is a local minimum: other starts may lead to others. Through mode switches the search also ends
    /// after ten decreases in a row below the tolerance.
    ///
    /// # Errors
    /// Settings out of range, [`IlqrError::Diverged`], [`IlqrError::StepFailed`], [`IlqrError::NotConvex`],
    /// [`IlqrError::NoDecrease`] and [`IlqrError::TooManyIterations`]. In the last two cases the best motion is kept.
    pub fn solve<S>(&mut self, model: &S, t0: T, x0: impl IntoState<T, N>) -> Result<Solved<T>, IlqrError>
    where
        S: StepMap<T, N, M>,
    {
        let x0 = x0.into_state();
        self.check(model, t0, &x0)?;
        self.damping = Damping::none();
        let mut cost = self.forward(model, t0, &x0, T::default())?;
        let ulps = T::from_f64(ROUNDING_ULPS) * T::EPSILON;
        // where the least cost is zero, rounding errors of the motion leave some cost
        let least = ulps * T::EPSILON * cost.abs();
        let mut decrease = T::default();
        let (mut tilt, mut small) = (None, 0);
        for iterations in 1..=self.max_iterations {
            let promise = self.backward(model, t0, tilt.as_ref().map(|tilt: &Tilt<_, _, _>| &tilt.by_inputs))?;
            if iterations == 1 {
                self.plan = self.trial;
            }
            let promised = promise.of(T::from_f64(1.0));
            // a combination of gradients promises nothing within the error of its linear model
            let open = promised + tilt.as_ref().map_or(T::default(), |tilt| tilt.error);
            let is_converged = self.damping.value == T::default() && open <= self.tolerance * cost.abs();
            if is_converged || open <= ulps * cost.abs() + least {
                return Ok(Solved { cost, iterations });
            }
            let mut found = self.line_search(model, t0, &x0, (cost, promise));
            if const { S::HAS_KINKS } && found.is_err() {
                found = self.line_search_without_gains(model, t0, &x0, (cost, promise));
            }
            match found {
                Ok((next, share)) => {
                    decrease = cost - next;
                    cost = next;
                    tilt = None;
                    let is_small = decrease <= self.tolerance * cost.abs();
                    small = if is_small { small + 1 } else { 0 };
                    if const { S::HAS_KINKS } && small == PATIENCE {
                        return Ok(Solved { cost, iterations });
                    }
                    if share == T::from_f64(1.0) {
                        self.damping.decay();
                    }
                }
                Err(NoShare { last: Some(last) })
                    if const { S::HAS_KINKS } && self.tilt(model, t0, &mut tilt, promised, cost - last) => {}
                Err(_) => {
                    self.trial = self.plan;
                    tilt = None;
                    self.damping.grow();
                    if self.damping.value > T::from_f64(LARGEST_DAMPING) {
                        return Err(no_decrease(iterations, cost, promised));
                    }
                }
            }
        }
        Err(IlqrError::TooManyIterations {
            iterations: self.max_iterations,
            cost: cost.to_f64(),
            decrease: decrease.to_f64(),
        })
    }

    /// Improves the motion by one backward and one forward pass, from the state `x0` at `t0`: an iteration of
    /// [`solve`](Self::solve) for the time between two samples.
    ///
    /// The motion before the pass follows the last one by its gains, so that it does not run away where that is
    /// unstable.
    ///
    /// # Errors
    /// Settings out of range, [`IlqrError::Diverged`], [`IlqrError::StepFailed`] and [`IlqrError::NotConvex`]. The last
    /// motion is kept, but after the last two, the gains of nodes behind the one named may be those of this pass.
    pub fn pass<S>(&mut self, model: &S, t0: T, x0: impl IntoState<T, N>) -> Result<Pass<T>, IlqrError>
    where
        S: StepMap<T, N, M>,
    {
        let x0 = x0.into_state();
        self.check(model, t0, &x0)?;
        self.checked_pass(model, t0, &x0)
    }

    /// A [pass](Self::pass) with settings, a time and a state that have been checked.
    pub(super) fn checked_pass<S>(&mut self, model: &S, t0: T, x0: &SVector<T, N>) -> Result<Pass<T>, IlqrError>
    where
        S: StepMap<T, N, M>,
    {
        let cost_before = self.forward(model, t0, x0, T::default())?;
        let promise = self.backward(model, t0, None)?;
        self.plan = self.trial;
        if promise.of(T::from_f64(1.0)) <= ulps(ROUNDING_ULPS, cost_before.abs()) {
            self.damping.decay();
            return Ok(Pass {
                cost: cost_before,
                cost_before,
                share: T::default(),
            });
        }
        let (cost, share) = match self.line_search(model, t0, x0, (cost_before, promise)) {
            Ok((cost, share)) => {
                self.damping.decay();
                (cost, share)
            }
            Err(_) => {
                self.damping.grow();
                (cost_before, T::default())
            }
        };
        Ok(Pass {
            cost,
            cost_before,
            share,
        })
    }

    /// The backward pass along `trial`, which is not yet the plan: a pass that fails leaves that as it was.
    pub(super) fn backward<S>(&mut self, model: &S, t0: T, tilt: Option<&[[T; M]; K]>) -> Result<Promise<T>, IlqrError>
    where
        S: StepMap<T, N, M>,
    {
        let damping = self.damping.value;
        Isa::run_routine(Backward { t0, damping, tilt }, self, model)
    }

    pub(super) fn forward<S>(&mut self, model: &S, t0: T, x0: &SVector<T, N>, share: T) -> Result<T, IlqrError>
    where
        S: StepMap<T, N, M>,
    {
        Isa::run_routine(Forward { t0, x0: *x0, share }, self, model)
    }

    /// Checks the settings for a model and a start.
    pub(super) fn check<S>(&self, model: &S, t0: T, x0: &SVector<T, N>) -> Result<(), IlqrError>
    where
        S: StepMap<T, N, M>,
    {
        model.check(t0, x0)?;
        if !(self.h.is_finite() && self.h > T::default()) {
            return Err(IlqrError::Step(self.h.to_f64()));
        }
        if !(self.tolerance >= T::default() && self.tolerance < T::from_f64(1.0)) {
            return Err(IlqrError::Tolerance(self.tolerance.to_f64()));
        }
        check_start(t0, x0)?;
        for input in 0..M {
            let (low, high) = (self.low[input], self.high[input]);
            let limits = [low, high].map(T::to_f64);
            let are_in_order = low <= high;
            if !are_in_order {
                return Err(IlqrError::Limits { input, limits });
            }
            for node in 0..K {
                let value = self.plan.u[node][input];
                if !(value.is_finite() && low <= value && value <= high) {
                    let value = value.to_f64();
                    return Err(IlqrError::StartBeyondLimits {
                        input,
                        node,
                        value,
                        limits,
                    });
                }
            }
        }
        self.cost.check()
    }
}

fn no_decrease<T: Float>(iterations: usize, cost: T, promised: T) -> IlqrError {
    IlqrError::NoDecrease {
        iterations,
        cost: cost.to_f64(),
        promised: promised.to_f64(),
    }
}

/// Checks that a time and a state are finite.
fn check_start<T: Float, const N: usize>(t: T, x: &SVector<T, N>) -> Result<(), IlqrError> {
    let what = if !t.is_finite() {
        "the time"
    } else if !x.iter().all(|component| component.is_finite()) {
        "the state"
    } else {
        return Ok(());
    };
    Err(IlqrError::NotFinite { what })
}
