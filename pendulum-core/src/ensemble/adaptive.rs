//! Many trajectories, each with steps of its own lengths.

use nalgebra::SVector;

use super::{Ensemble, EnsembleError, check_models, conclude, leave_alone, model_of};
use crate::control::Tolerance;
use crate::dense::polynomial;
use crate::error::Reason;
use crate::method::{
    Adaptation, Adaptive, Explicit, NonFinite, OneStep, PowerSeries, SHORT, Scheme, TERMS, attempt, check_span,
    check_state, defect, last_terms, length, order_for, weighted_sum,
};
use crate::real::lanes::{Isa, Kernel, LaneElement, Lanes};
use crate::system::{Cast, System};
use crate::tableau::Tableau;
use crate::taylor::{CastTaylor, MAX_ORDER};

/// A family of methods whose steps run in lanes, each with a length of its own.
///
/// What it computes in each lane is what its [`Scheme`] computes for a scalar.
pub trait InLanes<M: Cast<N>, T: LaneElement, const N: usize>: OneStep<M::In<T>, T, N> + Copy {
    /// What a step works with.
    type Memory<V: Lanes<Scalar = T>>;

    /// A memory of nothing.
    fn memory<V: Lanes<Scalar = T>>(&self, tolerance: &Tolerance<T>) -> Self::Memory<V>;

    /// Whether the lanes are few: where a step uses much memory, or the registers have enough to do.
    const NARROW: bool;

    /// Goes to the states `x` at `t`.
    fn begin<V: Lanes<Scalar = T>>(system: &M::In<V>, t: V, x: &SVector<V, N>, memory: &mut Self::Memory<V>);

    /// What the length of the next step follows from, where the method knows that before it tries.
    fn prepare<V: Lanes<Scalar = T>>(
        memory: &Self::Memory<V>,
        x: &SVector<V, N>,
        tolerance: &Tolerance<V>,
    ) -> Option<[V; TERMS]>;

    /// The length, from that of a lane.
    fn propose<V: Lanes<Scalar = T>>(memory: &Self::Memory<V>, tolerance: &Tolerance<T>, prepared: [T; TERMS]) -> T;

    /// Tries a step: the states at its end, and the mean squares of their errors in units of the tolerance.
    fn attempt<V: Lanes<Scalar = T>>(
        system: &M::In<V>,
        start: (V, &SVector<V, N>),
        t_new: V,
        tolerance: &Tolerance<V>,
        memory: &mut Self::Memory<V>,
    ) -> (SVector<V, N>, V);

    /// Accepts the step in all lanes; `false` if the next one must [`begin`](Self::begin).
    fn finish<V: Lanes<Scalar = T>>(system: &M::In<V>, end: (V, &SVector<V, N>), memory: &mut Self::Memory<V>) -> bool;
}

impl<M, B, T, const STAGES: usize, const N: usize> InLanes<M, T, N> for Explicit<B, STAGES>
where
    M: Cast<N>,
    B: Tableau<STAGES> + Copy,
    T: LaneElement,
{
    type Memory<V: Lanes<Scalar = T>> = [SVector<V, N>; STAGES];
    const NARROW: bool = N > SHORT;

    #[inline(always)]
    fn memory<V: Lanes<Scalar = T>>(&self, _tolerance: &Tolerance<T>) -> Self::Memory<V> {
        [SVector::from_element(V::default()); STAGES]
    }

    #[inline(always)]
    fn begin<V: Lanes<Scalar = T>>(system: &M::In<V>, t: V, x: &SVector<V, N>, stages: &mut Self::Memory<V>) {
        stages[0] = system.rhs(t, x);
    }

    #[inline(always)]
    fn prepare<V: Lanes<Scalar = T>>(
        _stages: &Self::Memory<V>,
        _x: &SVector<V, N>,
        _tolerance: &Tolerance<V>,
    ) -> Option<[V; TERMS]> {
        None
    }

    #[inline(always)]
    fn propose<V: Lanes<Scalar = T>>(_stages: &Self::Memory<V>, _tolerance: &Tolerance<T>, _prepared: [T; TERMS]) -> T {
        T::default()
    }

    #[inline(always)]
    fn attempt<V: Lanes<Scalar = T>>(
        system: &M::In<V>,
        (t, x): (V, &SVector<V, N>),
        t_new: V,
        tolerance: &Tolerance<V>,
        stages: &mut Self::Memory<V>,
    ) -> (SVector<V, N>, V) {
        let x_new = attempt::<B, _, V, STAGES, N>(system, (t, x), t_new, stages);
        if const { B::TABLEAU.error_wants_the_last_stage() } {
            stages[STAGES - 1] = system.rhs(t_new, &x_new);
        }
        let weights = const { &B::TABLEAU.error_weights() };
        let error = weighted_sum((t_new - t).abs(), weights, STAGES, stages);
        (x_new, tolerance.mean_square(&error, x, &x_new))
    }

    #[inline(always)]
    fn finish<V: Lanes<Scalar = T>>(
        system: &M::In<V>,
        (t, x): (V, &SVector<V, N>),
        stages: &mut Self::Memory<V>,
    ) -> bool {
        if const { !B::TABLEAU.error_wants_the_last_stage() } {
            stages[STAGES - 1] = system.rhs(t, x);
        }
        stages[0] = stages[STAGES - 1];
        true
    }
}

/// The series of each lane.
pub struct LaneSeries<W, V, const N: usize> {
    order: usize,
    /// Which of the two series is that of the states reached.
    current: usize,
    x: [[SVector<V, N>; MAX_ORDER + 1]; 2],
    work: W,
}

impl<W, V, const N: usize> LaneSeries<W, V, N> {
    #[inline(always)]
    fn series(&self, which: usize) -> &[SVector<V, N>] {
        &self.x[which][..=self.order]
    }
}

impl<M, T, const N: usize> InLanes<M, T, N> for PowerSeries
where
    M: CastTaylor<N>,
    PowerSeries: OneStep<M::In<T>, T, N>,
    T: LaneElement,
{
    type Memory<V: Lanes<Scalar = T>> = LaneSeries<M::Workspace<V>, V, N>;
    const NARROW: bool = true;

    #[inline(always)]
    fn memory<V: Lanes<Scalar = T>>(&self, tolerance: &Tolerance<T>) -> Self::Memory<V> {
        LaneSeries {
            order: self.order.unwrap_or_else(|| order_for(tolerance)),
            current: 0,
            x: [[SVector::from_element(V::default()); MAX_ORDER + 1]; 2],
            work: M::workspace::<V>(),
        }
    }

    #[inline(always)]
    fn begin<V: Lanes<Scalar = T>>(system: &M::In<V>, t: V, x: &SVector<V, N>, series: &mut Self::Memory<V>) {
        let (current, order) = (series.current, series.order);
        series.x[current][0] = *x;
        M::series(system, t, &mut series.x[current][..=order], &mut series.work);
    }

    #[inline(always)]
    fn prepare<V: Lanes<Scalar = T>>(
        series: &Self::Memory<V>,
        x: &SVector<V, N>,
        tolerance: &Tolerance<V>,
    ) -> Option<[V; TERMS]> {
        Some(tolerance.mean_sizes(last_terms(series.series(series.current)), x))
    }

    #[inline(always)]
    fn propose<V: Lanes<Scalar = T>>(series: &Self::Memory<V>, tolerance: &Tolerance<T>, prepared: [T; TERMS]) -> T {
        length(series.order, tolerance, prepared)
    }

    #[inline(always)]
    fn attempt<V: Lanes<Scalar = T>>(
        system: &M::In<V>,
        (t, x): (V, &SVector<V, N>),
        t_new: V,
        tolerance: &Tolerance<V>,
        series: &mut Self::Memory<V>,
    ) -> (SVector<V, N>, V) {
        let (h, current, order) = (t_new - t, series.current, series.order);
        let x_new = polynomial(x, &series.series(current)[1..], h);
        series.x[1 - current][0] = x_new;
        M::series(system, t_new, &mut series.x[1 - current][..=order], &mut series.work);
        let error = defect(series.series(current), h, &series.x[1 - current][1]);
        (x_new, tolerance.mean_square(&error, x, &x_new))
    }

    #[inline(always)]
    fn finish<V: Lanes<Scalar = T>>(
        _system: &M::In<V>,
        _end: (V, &SVector<V, N>),
        series: &mut Self::Memory<V>,
    ) -> bool {
        series.current = 1 - series.current;
        true
    }
}

impl<M, F, T, const N: usize> Ensemble<M, T, N> for Adaptive<F>
where
    M: Cast<N>,
    F: InLanes<M, T, N>,
    T: LaneElement,
{
    fn ensemble_on(
        &self,
        isa: Isa,
        models: &[M],
        t0: T,
        t1: T,
        starts: &[SVector<T, N>],
    ) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>> {
        check_span(t0, t1)?;
        check_models(models, starts)?;
        let mut x = starts.to_vec();
        let tolerance = self.tolerance()?;
        if let Some(model) = models.first() {
            let scheme = self.family.scheme(&model.cast(), Some(tolerance))?;
            let pace = self.pace(tolerance, scheme.error_order(), (t0, t1))?;
            isa.run(March {
                family: self.family,
                models,
                pace,
                span: (t0, t1),
                x: &mut x,
            });
        }
        conclude(self, models, (t0, t1), starts, x)
    }
}

/// Trajectories on their way from the states `x`, which are replaced: by NaN where they are stopped.
struct March<'a, F, M, T, const N: usize> {
    family: F,
    models: &'a [M],
    pace: Adaptation<T>,
    span: (T, T),
    x: &'a mut [SVector<T, N>],
}

impl<F, M, T, const N: usize> Kernel<T> for March<'_, F, M, T, N>
where
    F: InLanes<M, T, N>,
    M: Cast<N>,
    T: LaneElement,
{
    type Output = ();

    #[inline(always)]
    fn run<V: Lanes<Scalar = T>>(self) {
        if const { !F::NARROW } {
            self.in_lanes::<V::Double>();
        } else if const { V::LANES > 1 } {
            self.in_lanes::<V>();
        } else {
            leave_alone(self.x);
        }
    }
}

/// The most lanes that there are: those of `f32`, twice.
const MOST_LANES: usize = 64;

/// A trajectory in a lane.
#[derive(Clone, Copy)]
struct Member<T> {
    /// Which, or none that is still to go.
    index: Option<usize>,
    t: T,
    t_new: T,
    pace: Adaptation<T>,
    steps: usize,
    /// Whether the last step was rejected: then the length of the next one is known.
    rejected: bool,
}

impl<F, M, T, const N: usize> March<'_, F, M, T, N>
where
    F: InLanes<M, T, N>,
    M: Cast<N>,
    T: LaneElement,
{
    #[inline(always)]
    fn in_lanes<V: Lanes<Scalar = T>>(mut self) {
        let (t0, t1) = self.span;
        if t0 == t1 || self.x.is_empty() {
            return;
        }
        let tolerance = self.pace.tolerance;
        let wide = Tolerance {
            rtol: V::splat(tolerance.rtol),
            atol: V::splat(tolerance.atol),
        };
        let mut members = [Member {
            index: None,
            t: t1,
            t_new: t1,
            pace: self.pace,
            steps: 0,
            rejected: false,
        }; MOST_LANES];
        let members = &mut members[..V::LANES];
        // Lanes that are left over go on in the first state, without a step.
        let mut x = self.x[0].map(V::splat);
        let mut memory = self.family.memory::<V>(&tolerance);
        let mut system = M::gather::<V>(|_| model_of(self.models, 0));
        let mut next = 0;
        let mut known = false;
        loop {
            for lane in 0..V::LANES {
                if members[lane].index.is_some() || next == self.x.len() {
                    continue;
                }
                while next < self.x.len() && members[lane].index.is_none() {
                    if let Ok(pace) = self.enter(next) {
                        members[lane] = Member {
                            index: Some(next),
                            t: t0,
                            t_new: t0,
                            pace,
                            steps: 0,
                            rejected: false,
                        };
                        set_lane(&mut x, lane, &self.x[next]);
                    } else {
                        self.x[next].fill(T::from_f64(f64::NAN));
                    }
                    next += 1;
                }
                known = false;
                if self.models.len() > 1 {
                    system = M::gather::<V>(|lane| model_of(self.models, members[lane].index.unwrap_or(0)));
                }
            }
            if members.iter().all(|member| member.index.is_none()) {
                return;
            }
            let t = V::from_fn(|lane| members[lane].t);
            if !known {
                F::begin(&system, t, &x, &mut memory);
            }
            let prepared = F::prepare(&memory, &x, &wide);
            for (lane, member) in members.iter_mut().enumerate() {
                if member.index.is_none() {
                    continue;
                }
                let of_lane = |prepared: [V; TERMS]| {
                    F::propose(&memory, &tolerance, prepared.map(|prepared| prepared.lane(lane)))
                };
                if self.plan(member, prepared.map(of_lane)).is_err() {
                    self.leave(member, None);
                }
            }
            let t_new = V::from_fn(|lane| members[lane].t_new);
            let (x_new, mean_square) = F::attempt(&system, (t, &x), t_new, &wide, &mut memory);
            // Zero where the state is finite.
            let mut check = V::default();
            for &x in &x_new.data.0[0] {
                check += x * V::default();
            }
            let mut accepted = [true; MOST_LANES];
            for (lane, member) in members.iter_mut().enumerate() {
                if member.index.is_some() {
                    let is_finite = check.lane(lane) == T::default();
                    accepted[lane] = self.judge(member, is_finite.then_some(mean_square.lane(lane)));
                }
            }
            if accepted.iter().all(|&accepted| accepted) {
                x = x_new;
                known = F::finish(&system, (t_new, &x), &mut memory);
            } else {
                for (x, new) in x.iter_mut().zip(x_new.iter()) {
                    *x = V::from_fn(|lane| if accepted[lane] { new.lane(lane) } else { x.lane(lane) });
                }
                known = false;
            }
            for (lane, member) in members.iter_mut().enumerate() {
                if member.index.is_some() && member.t == t1 {
                    let state = x.map(|x| x.lane(lane));
                    self.leave(member, Some(state));
                }
            }
        }
    }

    /// The pace of the trajectory `index` at its start.
    fn enter(&self, index: usize) -> Result<Adaptation<T>, Reason> {
        let (t0, t1) = self.span;
        let (model, x) = (model_of(self.models, index).cast::<T>(), self.x[index]);
        check_state(&x)?;
        let mut pace = self.pace;
        if pace.h == T::default() && const { !<F::Scheme as Scheme<M::In<T>, T, N>>::PROPOSES } {
            let slope = model.rhs(t0, &x);
            NonFinite::check(&slope).map_err(NonFinite::at_start)?;
            pace.h = pace.first_step(&model, (t0, &x, &slope), t1);
        }
        Ok(pace)
    }

    /// Plans the next step of a trajectory.
    #[inline(always)]
    fn plan(&self, member: &mut Member<T>, proposed: Option<T>) -> Result<(), Reason> {
        let t1 = self.span.1;
        if let (false, Some(h)) = (member.rejected, proposed) {
            member.pace.propose(h, member.t, (t1 - member.t).abs())?;
        }
        member.pace.check_steps(member.steps)?;
        member.pace.h = member.pace.h.max(member.pace.least(member.t));
        member.t_new = member.pace.end_of_step(member.t, t1);
        Ok(())
    }

    /// Whether a trajectory takes the step that was tried, given the mean square of its error, or none if it arrived nowhere; if it does
    /// not and cannot take a shorter one, it leaves.
    #[inline(always)]
    fn judge(&mut self, member: &mut Member<T>, mean_square: Option<T>) -> bool {
        let h = (member.t_new - member.t).abs();
        member.steps += 1;
        if let Some(mean_square) = mean_square
            && mean_square <= T::from_f64(1.0)
        {
            if const { !<F::Scheme as Scheme<M::In<T>, T, N>>::PROPOSES } {
                member.pace.accept(h, mean_square);
            }
            member.t = member.t_new;
            member.rejected = false;
            return true;
        }
        let least = member.pace.least(member.t);
        member.pace.reject(h, mean_square);
        member.rejected = true;
        if member.pace.h < least {
            self.leave(member, None);
        }
        false
    }

    /// Ends a trajectory in a state, or in none.
    #[inline(always)]
    fn leave(&mut self, member: &mut Member<T>, state: Option<SVector<T, N>>) {
        if let Some(index) = member.index.take() {
            self.x[index] = state.unwrap_or_else(|| SVector::from_element(T::from_f64(f64::NAN)));
        }
        member.t_new = member.t;
    }
}

/// Replaces the state of a lane.
fn set_lane<V: Lanes, const N: usize>(x: &mut SVector<V, N>, lane: usize, state: &SVector<V::Scalar, N>) {
    for (x, state) in x.iter_mut().zip(state.iter()) {
        *x = V::from_fn(|other| if other == lane { *state } else { x.lane(other) });
    }
}
