//! Explicit Runge-Kutta methods that integrate tangents by the variational equations, in the same steps.

use core::cell::Cell;

use nalgebra::{SMatrix, SVector};

use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::{InMode, ModeSwitch, hold_tangents, saltation};
use crate::linear::{image, square};
use crate::method::explicit::{Explicit, ExplicitStages};
use crate::method::input::require;
use crate::method::scheme::{Accepted, NonFinite, OneStep, Scheme, Stalled};
use crate::method::stages::{shifted_by_sum, weighted_sum};
use crate::real::Float;
use crate::real::lanes::Lanes;
use crate::statistics::Statistics;
use crate::step_size::{Estimates, Tolerance};
use crate::system::{Jacobian, System};
use crate::tableau::Tableau;

mod in_lanes;

pub(crate) use in_lanes::{Carried, CarriedStages, Carry};

/// The explicit method of the tableau `B`, with `K` tangents `v' = J(t, x) v`.
///
/// A step of the tangents is the derivative of the step of the state: the same tableau, with the Jacobian at each of
/// its stages, which is evaluated once with the right-hand side. Their errors are kept within the tolerance too,
/// relative to the length of each tangent.
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
    /// Jacobian at each stage.
    jacobians: [SMatrix<T, N, N>; STAGES],
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
            jacobians: [SMatrix::from_element(T::default()); STAGES],
        }
    }

    /// See [`Scheme::begin`].
    #[inline(always)]
    fn begin_both<S>(
        &mut self,
        system: &InMode<'_, S, T>,
        t: T,
        x: &SVector<T, N>,
        work: &mut Statistics,
    ) -> SVector<T, N>
    where
        S: Jacobian<T, N> + ?Sized,
    {
        work.jacobians += 1;
        self.state
            .begin_with(&Recorder::new(system, &mut self.jacobians[..1]), t, x, work)
    }

    /// See [`Scheme::attempt`].
    #[inline(always)]
    fn attempt_both<S>(
        &mut self,
        system: &InMode<'_, S, T>,
        (t, x): (T, &SVector<T, N>),
        (t_new, x_new): (T, &mut SVector<T, N>),
        work: &mut Statistics,
    ) -> T
    where
        S: Jacobian<T, N> + ?Sized,
    {
        let recorder = Recorder::new(system, &mut self.jacobians[1..]);
        let mut largest = self.state.attempt_with(&recorder, system, (t, x), (t_new, x_new), work);
        // the last stage has a weight only in the error estimate
        let uses_last = self.tolerance.is_some() && const { B::TABLEAU.error_uses_last_stage() };
        let count = if uses_last { STAGES } else { STAGES - 1 };
        work.jacobians += count - 1;
        let (tableau, h) = (const { &B::TABLEAU }, t_new - t);
        let weights = const { &B::TABLEAU.error_weights() };
        let tangents = self.tangents.iter().zip(&mut self.tried).zip(&mut self.rates);
        for ((tangent, tried), rates) in tangents {
            for (i, (row, jacobian)) in tableau.a.iter().zip(&self.jacobians).enumerate().take(count) {
                let tangent = shifted_by_sum((tangent, h), (row, i), rates);
                rates[i] = image(jacobian, &tangent);
            }
            *tried = shifted_by_sum((tangent, h), (&tableau.b, STAGES - 1), rates);
            if let Some(tolerance) = &self.tolerance {
                let error = square(&weighted_sum(h, weights, count, rates));
                let size = larger(square(tangent), square(tried));
                largest = larger(largest, error / (tolerance.rtol * tolerance.rtol * size));
            }
        }
        largest
    }

    /// See [`Scheme::arrive`].
    #[inline(always)]
    fn arrive_both<S>(
        &mut self,
        system: &InMode<'_, S, T>,
        end: (T, &SVector<T, N>),
        work: &mut Statistics,
    ) -> &SVector<T, N>
    where
        S: Jacobian<T, N> + ?Sized,
    {
        work.jacobians += 1;
        let recorder = Recorder::new(system, &mut self.jacobians[STAGES - 1..]);
        self.state.arrive_with(&recorder, end, work)
    }

    /// See [`Scheme::accept`].
    #[inline(always)]
    fn accept_both<S>(
        &mut self,
        system: &InMode<'_, S, T>,
        step: &Step<T, N>,
        lanes: Accepted<T>,
        work: &mut Statistics,
    ) where
        S: Jacobian<T, N> + ?Sized,
    {
        self.state.accept(system, step, lanes, work);
        self.before = self.tangents;
        for (tangent, tried) in self.tangents.iter_mut().zip(&self.tried) {
            *tangent = lanes.select(tried, tangent);
        }
        let last = self.jacobians[STAGES - 1];
        self.jacobians[0] = lanes.select(&last, &self.jacobians[0]);
    }
}

/// A system whose evaluations also fill a list of Jacobians.
struct Recorder<'a, S: ?Sized, T, const N: usize> {
    system: &'a InMode<'a, S, T>,
    jacobians: &'a [Cell<SMatrix<T, N, N>>],
    next: Cell<usize>,
}

impl<'a, S: ?Sized, T, const N: usize> Recorder<'a, S, T, N> {
    #[inline(always)]
    fn new(system: &'a InMode<'a, S, T>, jacobians: &'a mut [SMatrix<T, N, N>]) -> Self {
        Self {
            system,
            jacobians: Cell::from_mut(jacobians).as_slice_of_cells(),
            next: Cell::new(0),
        }
    }
}

impl<S, T, const N: usize> System<T, N> for Recorder<'_, S, T, N>
where
    S: Jacobian<T, N> + ?Sized,
    T: Lanes,
{
    #[inline(always)]
    fn rhs(&self, t: T, x: &SVector<T, N>) -> SVector<T, N> {
        let (rate, jacobian) = self.system.rhs_and_jacobian(t, x);
        let next = self.next.get();
        self.jacobians[next].set(jacobian);
        self.next.set(next + 1);
        rate
    }

    #[inline(always)]
    fn active(&self) -> usize {
        self.system.active()
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
        self.begin_both(system, t, x, work)
    }

    fn attempt(
        &mut self,
        system: &InMode<'_, S, T>,
        (t, x): (T, &SVector<T, N>),
        (t_new, x_new): (T, &mut SVector<T, N>),
        work: &mut Statistics,
    ) -> Result<T, Stalled> {
        let mean_square = self.attempt_both(system, (t, x), (t_new, x_new), work);
        // a tangent that is not finite fails the step: the maximum ignores NaN
        let is_finite = self.tried.iter().all(|tangent| NonFinite::check(tangent).is_ok());
        if !is_finite {
            return Err(Stalled);
        }
        Ok(mean_square)
    }

    fn arrive(
        &mut self,
        system: &InMode<'_, S, T>,
        end: (T, &SVector<T, N>),
        work: &mut Statistics,
    ) -> Option<&SVector<T, N>> {
        Some(self.arrive_both(system, end, work))
    }

    fn accept(&mut self, system: &InMode<'_, S, T>, step: &Step<T, N>, lanes: Accepted<T>, work: &mut Statistics) {
        self.accept_both(system, step, lanes, work);
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
