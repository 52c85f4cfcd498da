//! Trajectories in lanes, some of which are stiff.

use std::marker::PhantomData;

use nalgebra::SVector;

use super::stiffness::{Stiffness, even, fastest_rate};
use super::{BARELY_TOO_LARGE, Bounded, MethodPair, Switch, Switching};
use crate::dense::Step;
use crate::ensemble::{MOST_LANES, in_lane, set_lane};
use crate::error::Reason;
use crate::hybrid::InMode;
use crate::linear::PerLane;
use crate::method::Explicit;
use crate::method::explicit::ExplicitStages;
use crate::method::rosenbrock::RosenbrockStages;
use crate::method::scheme::{Accepted, OneStep, Scheme, Stalled};
use crate::method::step_control::is_within_tolerance;
use crate::real::lanes::Lanes;
use crate::real::{Float, Real};
use crate::statistics::Statistics;
use crate::step_size::{Estimates, Tolerance};
use crate::system::{Jacobian, System};
use crate::tableau::RosenbrockMethod;

/// [`Switching`] with the tableaus of its methods as type parameters: the code of all of them would exceed the stack of
/// a thread in unoptimised builds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SwitchingFrom<B, I, const STAGES: usize, const STIFF: usize>(PhantomData<(B, I)>);

impl<B, I, const STAGES: usize, const STIFF: usize> SwitchingFrom<B, I, STAGES, STIFF>
where
    B: Bounded<STAGES>,
    I: RosenbrockMethod<STIFF>,
{
    pub(crate) fn new() -> Self {
        Self(PhantomData)
    }

    /// Scheme of a trajectory that turns stiff.
    pub(crate) fn stiff<S, T, const N: usize>(
        system: &S,
        tolerance: Option<Tolerance<T>>,
    ) -> Result<Switch<T, N>, Reason>
    where
        S: Jacobian<T, N> + ?Sized,
        T: Float,
    {
        let mut switch: Switch<T, N> = Switching.scheme(system, tolerance)?;
        switch.stiffness.is_stiff = true;
        Ok(switch)
    }
}

impl<B, I, S, T, const STAGES: usize, const STIFF: usize, const N: usize> OneStep<S, T, N>
    for SwitchingFrom<B, I, STAGES, STIFF>
where
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    type Scheme = Switch<T, N>;

    fn scheme(&self, system: &S, tolerance: Option<Tolerance<T>>) -> Result<Self::Scheme, Reason> {
        Switching.scheme(system, tolerance)
    }
}

impl<B, I, const STAGES: usize, const STIFF: usize> Estimates for SwitchingFrom<B, I, STAGES, STIFF> {}

/// Both methods in lanes, one of which is active in each lane. If lanes differ, both take a step in all of them.
#[derive(Clone, Debug)]
pub(crate) struct SwitchInLanes<B, I, V: Lanes, const STAGES: usize, const STIFF: usize, const N: usize> {
    explicit: ExplicitStages<B, V, STAGES, N>,
    implicit: RosenbrockStages<I, V, STIFF, N, PerLane<V, N>>,
    pair: MethodPair,
    stiffness: [Stiffness; MOST_LANES],
    /// Directions of the fastest change, for power iteration.
    fastest: SVector<V, N>,
    /// Mean square of the errors of the last explicit attempt.
    error: V,
    /// Number of components that are not padding.
    active: usize,
    /// Derivatives at the ends of the steps of both methods.
    slope: SVector<V, N>,
    work: Work,
}

/// Work of both methods counted last.
#[derive(Clone, Copy, Debug, Default)]
struct Work {
    explicit: Statistics,
    implicit: Statistics,
    /// Work of switches to each method before.
    of_change: [Statistics; 2],
    /// Bit set of the lanes that switched.
    changed: u64,
}

impl<B, I, V, const STAGES: usize, const STIFF: usize, const N: usize> SwitchInLanes<B, I, V, STAGES, STIFF, N>
where
    B: Bounded<STAGES>,
    I: RosenbrockMethod<STIFF>,
    V: Lanes,
{
    pub(crate) fn new<S>(system: &S, tolerance: Option<Tolerance<V::Scalar>>) -> Result<Self, Reason>
    where
        S: System<V, N> + ?Sized,
    {
        let pair = MethodPair::within(tolerance.as_ref());
        Ok(Self {
            explicit: Explicit::new().scheme(system, tolerance)?,
            implicit: RosenbrockStages::new(tolerance),
            pair,
            stiffness: [pair.stiffness(); MOST_LANES],
            fastest: even(system.active()),
            error: V::default(),
            active: system.active(),
            slope: SVector::from_element(V::default()),
            work: Work::default(),
        })
    }

    /// True if the trajectory in a lane turns stiff and must continue alone, by a method that does not run in lanes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn leaves(&self, lane: usize) -> bool {
        self.pair == MethodPair::Vern9Radau13 && self.stiffness[lane].changes
    }

    /// Judges the lanes whose first step of length `h` is rejected, and returns the errors to report.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn judge_first(&mut self, h: V, error: V) -> V {
        let is_doubtful = |own: &Stiffness, lane| own.doubts_rejected() && !is_within_tolerance(error.lane(lane));
        let mut own = self.stiffness[..V::LANES].iter().enumerate();
        if !own.any(|(lane, own)| is_doubtful(own, lane)) {
            return error;
        }
        let measured = self.explicit.stiffness(h);
        for (lane, own) in self.stiffness[..V::LANES].iter_mut().enumerate() {
            if is_doubtful(own, lane) {
                own.after_rejected(measured.lane(lane).to_f64(), B::LIMITS);
            }
        }
        V::from_fn(|lane| match self.stiffness[lane].changes {
            true => V::Scalar::from_f64(BARELY_TOO_LARGE),
            false => error.lane(lane),
        })
    }

    /// Returns two flags: the explicit, or the implicit, method is active in some lane.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn at_work(&self) -> [bool; 2] {
        [false, true].map(|is_stiff| self.stiffness[..V::LANES].iter().any(|own| own.is_stiff == is_stiff))
    }

    /// End of an explicit step from `t` to `t_new`. In stiff lanes it is the start, since the step would diverge to
    /// large angles, whose sines are slow.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn end_of_free(&self, t: V, t_new: V) -> V {
        self.stiff().select(&[t].into(), &[t_new].into())[0]
    }

    /// Stiff lanes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn stiff(&self) -> Accepted<V> {
        let sign = |lane: usize| if self.stiffness[lane].is_stiff { -1.0 } else { 1.0 };
        Accepted::Negative(V::from_fn(|lane| V::Scalar::from_f64(sign(lane))))
    }
}

impl<B, I, S, V, const STAGES: usize, const STIFF: usize, const N: usize> Scheme<S, V, N>
    for SwitchInLanes<B, I, V, STAGES, STIFF, N>
where
    B: Bounded<STAGES>,
    I: RosenbrockMethod<STIFF>,
    S: Jacobian<V, N> + ?Sized,
    V: Lanes,
{
    const ORDERS_DIFFER: bool = true;

    fn error_order(&self) -> usize {
        Scheme::<S, V, N>::error_order(&self.explicit)
    }

    fn error_order_in(&self, lane: usize) -> usize {
        if self.stiffness[lane].is_stiff {
            Scheme::<S, V, N>::error_order(&self.implicit)
        } else {
            Scheme::<S, V, N>::error_order(self)
        }
    }

    fn enter(&mut self, lane: usize, _index: usize) {
        self.stiffness[lane] = self.pair.stiffness();
        self.stiffness[lane].begin();
        set_lane(&mut self.fastest, lane, &even(self.active));
    }

    // work is counted for each lane
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn begin(&mut self, system: &InMode<'_, S, V>, t: V, x: &SVector<V, N>, _work: &mut Statistics) -> SVector<V, N> {
        self.work = Work::default();
        if let [_, true] = self.at_work() {
            self.implicit.begin(system, t, x, &mut self.work.implicit);
        }
        // lanes that enter are not stiff at first
        self.explicit.begin(system, t, x, &mut self.work.explicit)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn prepare(&mut self, system: &InMode<'_, S, V>, t: V, x: &SVector<V, N>, _work: &mut Statistics) -> Option<V> {
        self.work = Work::default();
        let mut begins = [false; 2];
        for (lane, own) in self.stiffness[..V::LANES].iter_mut().enumerate() {
            if own.changes {
                own.is_stiff = !own.is_stiff;
                own.begin();
                begins[usize::from(own.is_stiff)] = true;
                self.work.changed |= 1 << lane;
            }
        }
        let [to_explicit, to_implicit] = &mut self.work.of_change;
        if begins[0] {
            to_explicit.switches += 1;
            self.explicit.begin(system, t, x, to_explicit);
        }
        if begins[1] {
            to_implicit.switches += 1;
            self.implicit.begin(system, t, x, to_implicit);
        }
        None
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn attempt(
        &mut self,
        system: &InMode<'_, S, V>,
        start: (V, &SVector<V, N>),
        (t_new, x_new): (V, &mut SVector<V, N>),
        _work: &mut Statistics,
    ) -> Result<V, Stalled> {
        let [some_free, some_stiff] = self.at_work();
        let mut error = V::default();
        if some_free {
            let (t_new, work) = (self.end_of_free(start.0, t_new), &mut self.work.explicit);
            error = self.explicit.attempt(system, start, (t_new, x_new), work)?;
            self.error = error;
            if const { B::YIELDS_IF_REJECTED } {
                error = self.judge_first(t_new - start.0, error);
            }
        }
        if some_stiff {
            let (mut x_stiff, work) = (*x_new, &mut self.work.implicit);
            let of_stiff = self.implicit.attempt(system, start, (t_new, &mut x_stiff), work)?;
            let stiff = self.stiff();
            *x_new = stiff.select(&x_stiff, x_new);
            error = stiff.select(&[of_stiff].into(), &[error].into())[0];
        }
        Ok(error)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn arrive(
        &mut self,
        system: &InMode<'_, S, V>,
        end: (V, &SVector<V, N>),
        _work: &mut Statistics,
    ) -> Option<&SVector<V, N>> {
        self.work = Work::default();
        let [some_free, some_stiff] = self.at_work();
        if some_free {
            let work = &mut self.work.explicit;
            self.slope = self.explicit.arrive(system, end, work).copied()?;
        }
        if some_stiff {
            let work = &mut self.work.implicit;
            work.stiff = 1;
            let slope = self.implicit.arrive(system, end, work).copied()?;
            self.slope = self.stiff().select(&slope, &self.slope);
        }
        Some(&self.slope)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn accept(&mut self, system: &InMode<'_, S, V>, step: &Step<V, N>, lanes: Accepted<V>, work: &mut Statistics) {
        let [some_free, some_stiff] = self.at_work();
        let (mut is_tested, mut tests_free) = ([false; MOST_LANES], false);
        for (lane, own) in self.stiffness[..V::LANES].iter_mut().enumerate() {
            is_tested[lane] = lanes.is_in(lane) && own.takes_test();
            tests_free |= is_tested[lane] && !own.is_stiff;
        }
        if tests_free {
            // before acceptance, which overwrites the first stage by the one of the next step
            let measured = self.explicit.stiffness(step.h);
            let if_smooth = self.explicit.error_if_smooth(step, self.active);
            for (lane, own) in self.stiffness[..V::LANES].iter_mut().enumerate() {
                if !own.is_stiff && is_tested[lane] {
                    let errors = [self.error, if_smooth].map(|error| error.lane(lane).to_f64());
                    own.after_explicit(measured.lane(lane).to_f64(), B::LIMITS, errors);
                }
            }
        }
        if some_free {
            self.explicit.accept(system, step, lanes, work);
        }
        if some_stiff {
            self.implicit.accept(system, step, lanes, work);
            for (lane, own) in self.stiffness[..V::LANES].iter_mut().enumerate() {
                if own.is_stiff && is_tested[lane] {
                    let jacobian = self.implicit.jacobian().map(|entry| entry.lane(lane));
                    let mut fastest = in_lane(&self.fastest, lane);
                    let rate = fastest_rate(&jacobian, &mut fastest, self.active);
                    set_lane(&mut self.fastest, lane, &fastest);
                    own.after_implicit((step.h.lane(lane).abs() * rate).to_f64(), B::LIMITS);
                }
            }
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn dense(&mut self, system: &InMode<'_, S, V>, step: &Step<V, N>, _work: &mut Statistics) -> &[SVector<V, N>] {
        self.work = Work::default();
        let [some_free, some_stiff] = self.at_work();
        if some_free {
            let t1 = self.end_of_free(step.t0, step.t1);
            let step = Step::new((step.t0, step.x0), (t1, step.x1));
            self.explicit.dense(system, &step, &mut self.work.explicit);
        }
        if some_stiff {
            self.implicit.dense(system, step, &mut self.work.implicit);
        }
        // each lane has its own
        &[]
    }

    fn coefficients(&self) -> &[SVector<V, N>] {
        &[]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn coefficients_in(&self, lane: usize) -> &[SVector<V, N>] {
        if self.stiffness[lane].is_stiff {
            Scheme::<S, V, N>::coefficients(&self.implicit)
        } else {
            Scheme::<S, V, N>::coefficients(&self.explicit)
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn work_in(&self, lane: usize, _work: &Statistics) -> Statistics {
        let [to_explicit, to_implicit] = &self.work.of_change;
        let (mut own, change) = if self.stiffness[lane].is_stiff {
            (self.work.implicit, to_implicit)
        } else {
            (self.work.explicit, to_explicit)
        };
        if self.work.changed >> lane & 1 == 1 {
            own.add(change);
        }
        own
    }
}
