//! Explicit Runge-Kutta methods that integrate tangents by the variational equations, in the same steps.

use nalgebra::SVector;

use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::{InMode, ModeSwitch, hold_tangents, saltation};
use crate::linear::{image, square};
use crate::method::explicit::{Explicit, ExplicitStages};
use crate::method::input::require;
use crate::method::scheme::{Accepted, NonFinite, OneStep, Scheme, Stalled};
use crate::method::stages::{shifted, weighted_sum};
use crate::real::Float;
use crate::real::lanes::Lanes;
use crate::statistics::Statistics;
use crate::step_size::{Estimates, Tolerance};
use crate::system::Jacobian;
use crate::tableau::Tableau;

mod in_lanes;

pub(crate) use in_lanes::{Carried, CarriedStages, Carry};

/// The explicit method of the tableau `B`, with `K` tangents `v' = J(t, x) v`.
///
/// A step of the tangents is the derivative of the step of the state: the same tableau, with the Jacobian at each of
/// its stages. Their errors are kept within the tolerance too, relative to the length of each tangent.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tangent<B, const STAGES: usize, const K: usize>(Explicit<B, STAGES>);

impl<B, S, T, const STAGES: usize, const K: usize, const N: usize> OneStep<S, T, N> for Tangent<B, STAGES, K>
where
    B: Tableau<STAGES>,
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    type Scheme = Bundle<B, T, STAGES, K, N>;

    fn scheme(&self, system: &S, tolerance: Option<Tolerance<T>>) -> Result<Self::Scheme, Reason> {
        if system.hybrid().is_some() {
            let rule = "tangents of a hybrid system require `Jacobian::hybrid_jacobian`";
            require(system.hybrid_jacobian().is_some(), "hybrid_jacobian", f64::NAN, rule)?;
        }
        let state = OneStep::<S, T, N>::scheme(&self.0, system, tolerance)?;
        Ok(Bundle::new(state, tolerance))
    }
}

impl<B: Estimates, const STAGES: usize, const K: usize> Estimates for Tangent<B, STAGES, K> {}

/// A state and its tangents.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bundle<B, T, const STAGES: usize, const K: usize, const N: usize> {
    state: ExplicitStages<B, T, STAGES, N>,
    tolerance: Option<Tolerance<T>>,
    /// Tangents at the end of the last accepted step; at first the unit vectors of the first `K` components.
    pub(crate) tangents: [SVector<T, N>; K],
    /// Tangents at its start.
    before: [SVector<T, N>; K],
    /// Tangents at the end of the last attempt.
    tried: [SVector<T, N>; K],
    /// Derivative of each tangent at each stage.
    rates: [[SVector<T, N>; STAGES]; K],
}

impl<B, T, const STAGES: usize, const K: usize, const N: usize> Bundle<B, T, STAGES, K, N>
where
    B: Tableau<STAGES>,
    T: Lanes,
{
    fn new(state: ExplicitStages<B, T, STAGES, N>, tolerance: Option<Tolerance<T>>) -> Self {
        let zero = SVector::from_element(T::default());
        let mut tangents = [zero; K];
        for (k, tangent) in tangents.iter_mut().enumerate() {
            tangent[k] = T::from_f64(1.0);
        }
        Self {
            state,
            tolerance,
            tangents,
            before: tangents,
            tried: tangents,
            rates: [[zero; STAGES]; K],
        }
    }

    /// Attempts the step of the tangents, given the stages of the state, and returns the largest mean square of their
    /// errors.
    #[inline(always)]
    fn attempt_tangents<S>(&mut self, system: &S, (t, x): (T, &SVector<T, N>), h: T) -> T
    where
        S: Jacobian<T, N> + ?Sized,
    {
        let tableau = const { &B::TABLEAU };
        let weights = const { &B::TABLEAU.error_weights() };
        // the last stage has a weight only in the error estimate
        let uses_last = self.tolerance.is_some() && const { B::TABLEAU.error_uses_last_stage() };
        let count = if uses_last { STAGES } else { STAGES - 1 };
        for (i, row) in tableau.a.iter().enumerate().take(count) {
            let x = shifted(x, &weighted_sum(h, row, i, self.state.stages()));
            let jacobian = system.jacobian(t + h * T::from_f64(tableau.c[i]), &x);
            for (tangent, rates) in self.tangents.iter().zip(&mut self.rates) {
                let tangent = shifted(tangent, &weighted_sum(h, row, i, rates));
                rates[i] = image(&jacobian, &tangent);
            }
        }
        let mut largest = T::default();
        for ((tried, tangent), rates) in self.tried.iter_mut().zip(&self.tangents).zip(&self.rates) {
            *tried = shifted(tangent, &weighted_sum(h, &tableau.b, STAGES - 1, rates));
            if let Some(tolerance) = &self.tolerance {
                let error = square(&weighted_sum(h, weights, count, rates));
                let size = larger(square(tangent), square(tried));
                largest = larger(largest, error / (tolerance.rtol * tolerance.rtol * size));
            }
        }
        largest
    }
}

/// The larger of two numbers; the first if the second is NaN.
#[inline(always)]
fn larger<T: Lanes>(a: T, b: T) -> T {
    T::from_fn(|lane| a.lane(lane).max(b.lane(lane)))
}

impl<B, T, const STAGES: usize, const K: usize, const N: usize> Bundle<B, T, STAGES, K, N>
where
    T: Float,
{
    /// Removes the components of tangents that the mode of a hybrid system holds.
    fn hold<S>(&mut self, system: &InMode<'_, S, T>, at: (T, &SVector<T, N>))
    where
        S: Jacobian<T, N> + ?Sized,
    {
        let (system, hold) = system.parts();
        if let Some(hybrid) = system.hybrid_jacobian()
            && hold.held != 0
        {
            hold_tangents(hybrid, hold, at, &mut self.tangents);
        }
    }
}

impl<B, S, T, const STAGES: usize, const K: usize, const N: usize> Scheme<S, T, N> for Bundle<B, T, STAGES, K, N>
where
    B: Tableau<STAGES>,
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    fn error_order(&self) -> usize {
        Scheme::<S, T, N>::error_order(&self.state)
    }

    fn begin(&mut self, system: &InMode<'_, S, T>, t: T, x: &SVector<T, N>, work: &mut Statistics) -> SVector<T, N> {
        self.hold(system, (t, x));
        self.state.begin(system, t, x, work)
    }

    fn attempt(
        &mut self,
        system: &InMode<'_, S, T>,
        (t, x): (T, &SVector<T, N>),
        (t_new, x_new): (T, &mut SVector<T, N>),
        work: &mut Statistics,
    ) -> Result<T, Stalled> {
        let mean_square = self.state.attempt(system, (t, x), (t_new, x_new), work)?;
        let of_tangents = self.attempt_tangents(system, (t, x), t_new - t);
        work.jacobians += STAGES - 1;
        // a tangent that is not finite fails the step: the maximum ignores NaN
        let is_finite = self.tried.iter().all(|tangent| NonFinite::check(tangent).is_ok());
        if !is_finite {
            return Err(Stalled);
        }
        Ok(larger(mean_square, of_tangents))
    }

    fn arrive(
        &mut self,
        system: &InMode<'_, S, T>,
        end: (T, &SVector<T, N>),
        work: &mut Statistics,
    ) -> Option<&SVector<T, N>> {
        self.state.arrive(system, end, work)
    }

    fn accept(&mut self, system: &InMode<'_, S, T>, step: &Step<T, N>, lanes: Accepted<T>, work: &mut Statistics) {
        self.state.accept(system, step, lanes, work);
        (self.before, self.tangents) = (self.tangents, self.tried);
        self.hold(system, (step.t1, &step.x1));
    }

    fn go_back(&mut self) {
        self.tangents = self.before;
    }

    fn dense(&mut self, system: &InMode<'_, S, T>, step: &Step<T, N>, work: &mut Statistics) -> &[SVector<T, N>] {
        self.state.dense(system, step, work)
    }

    fn pass(&mut self, system: &S, passage: &ModeSwitch<T, N>) {
        let Some(hybrid) = system.hybrid_jacobian() else { return };
        let matrix = saltation(hybrid, passage);
        for tangent in &mut self.tangents {
            *tangent = image(&matrix, tangent);
        }
    }

    fn coefficients(&self) -> &[SVector<T, N>] {
        Scheme::<S, T, N>::coefficients(&self.state)
    }
}
