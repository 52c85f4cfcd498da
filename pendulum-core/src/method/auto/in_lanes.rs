//! Many trajectories side by side, some of which are stiff.

use nalgebra::SVector;

use super::{Free, Stiffness, fastest_rate};
use crate::control::Tolerance;
use crate::dense::Step;
use crate::ensemble::{MOST_LANES, in_lane, set_lane};
use crate::error::Reason;
use crate::hybrid::InMode;
use crate::linear::PerLane;
use crate::method::rosenbrock::RosenbrockStages;
use crate::method::scheme::{Accepted, Scheme, Stalled};
use crate::real::lanes::Lanes;
use crate::real::{Float, Real};
use crate::statistics::Statistics;
use crate::system::{Jacobian, System};
use crate::tableau::Steinebach5;

/// Both methods in lanes, each of which has one at work. Where lanes differ, both take a step in all of them.
///
/// It has no dense output: trajectories that are seen go one by one.
#[derive(Clone, Debug)]
pub struct SwitchInLanes<V: Lanes, const N: usize> {
    explicit: Free<V, N>,
    implicit: RosenbrockStages<Steinebach5, V, 8, N, PerLane<V, N>>,
    stiffness: [Stiffness; MOST_LANES],
    /// The directions of the fastest change, for power iteration.
    fastest: SVector<V, N>,
    /// The derivatives where both methods arrived.
    slope: SVector<V, N>,
}

impl<V: Lanes, const N: usize> SwitchInLanes<V, N> {
    pub(crate) fn new<S>(system: &S, tolerance: Option<Tolerance<V::Scalar>>) -> Result<Self, Reason>
    where
        S: System<V, N> + ?Sized,
    {
        Ok(Self {
            explicit: Free::new(system, tolerance)?,
            implicit: RosenbrockStages::new(tolerance),
            stiffness: [Stiffness::default(); MOST_LANES],
            fastest: SVector::from_element(V::from_f64(1.0)),
            slope: SVector::from_element(V::default()),
        })
    }

    /// Whether some lanes are free, and some are stiff.
    #[inline(always)]
    fn at_work(&self) -> [bool; 2] {
        [false, true].map(|is_stiff| self.stiffness[..V::LANES].iter().any(|own| own.is_stiff == is_stiff))
    }

    /// The lanes that are stiff.
    #[inline(always)]
    fn stiff(&self) -> Accepted<V> {
        let sign = |lane: usize| if self.stiffness[lane].is_stiff { -1.0 } else { 1.0 };
        Accepted::Negative(V::from_fn(|lane| V::Scalar::from_f64(sign(lane))))
    }
}

impl<S, V, const N: usize> Scheme<S, V, N> for SwitchInLanes<V, N>
where
    S: Jacobian<V, N> + ?Sized,
    V: Lanes,
{
    const ORDERS_DIFFER: bool = true;

    fn error_order(&self) -> usize {
        explicit!(&self.explicit, stages => Scheme::<S, V, N>::error_order(stages))
    }

    fn error_order_in(&self, lane: usize) -> usize {
        if self.stiffness[lane].is_stiff {
            Scheme::<S, V, N>::error_order(&self.implicit)
        } else {
            Scheme::<S, V, N>::error_order(self)
        }
    }

    fn enter(&mut self, lane: usize) {
        self.stiffness[lane] = Stiffness::default();
        let ones = SVector::from_element(V::Scalar::from_f64(1.0));
        set_lane(&mut self.fastest, lane, &ones);
    }

    #[inline(always)]
    fn begin(&mut self, system: &InMode<'_, S, V>, t: V, x: &SVector<V, N>, work: &mut Statistics) -> SVector<V, N> {
        if let [_, true] = self.at_work() {
            self.implicit.begin(system, t, x, work);
        }
        // those that enter are not known to be stiff
        explicit!(&mut self.explicit, stages => stages.begin(system, t, x, work))
    }

    #[inline(always)]
    fn prepare(&mut self, system: &InMode<'_, S, V>, t: V, x: &SVector<V, N>, work: &mut Statistics) -> Option<V> {
        let mut begins = [false; 2];
        for own in &mut self.stiffness[..V::LANES] {
            if own.changes {
                own.is_stiff = !own.is_stiff;
                own.begin();
                begins[usize::from(own.is_stiff)] = true;
            }
        }
        if begins[0] {
            explicit!(&mut self.explicit, stages => stages.begin(system, t, x, work));
        }
        if begins[1] {
            self.implicit.begin(system, t, x, work);
        }
        None
    }

    #[inline(always)]
    fn attempt(
        &mut self,
        system: &InMode<'_, S, V>,
        start: (V, &SVector<V, N>),
        (t_new, x_new): (V, &mut SVector<V, N>),
        work: &mut Statistics,
    ) -> Result<V, Stalled> {
        let [some_free, some_stiff] = self.at_work();
        let mut error = V::default();
        if some_free {
            error = explicit!(&mut self.explicit, stages => stages.attempt(system, start, (t_new, x_new), work))?;
        }
        if some_stiff {
            let mut x_stiff = *x_new;
            let of_stiff = self.implicit.attempt(system, start, (t_new, &mut x_stiff), work)?;
            let stiff = self.stiff();
            *x_new = stiff.select(&x_stiff, x_new);
            error = stiff.select(&[of_stiff].into(), &[error].into())[0];
        }
        Ok(error)
    }

    #[inline(always)]
    fn arrive(
        &mut self,
        system: &InMode<'_, S, V>,
        end: (V, &SVector<V, N>),
        work: &mut Statistics,
    ) -> Option<&SVector<V, N>> {
        let [some_free, some_stiff] = self.at_work();
        if some_free {
            let slope = explicit!(&mut self.explicit, stages => stages.arrive(system, end, work));
            self.slope = slope.copied()?;
        }
        if some_stiff {
            let slope = self.implicit.arrive(system, end, work).copied()?;
            self.slope = self.stiff().select(&slope, &self.slope);
        }
        Some(&self.slope)
    }

    #[inline(always)]
    fn accept(&mut self, system: &InMode<'_, S, V>, step: &Step<V, N>, lanes: Accepted<V>, work: &mut Statistics) {
        let [some_free, some_stiff] = self.at_work();
        let limit = self.explicit.limit();
        let is_accepted = |lane: usize| match lanes {
            Accepted::All => true,
            Accepted::Negative(sign) => sign.lane(lane) < V::Scalar::default(),
        };
        if some_free {
            // before it is accepted: then the first stage is that of the next step
            let measured = explicit!(&self.explicit, stages => stages.stiffness(step.h));
            explicit!(&mut self.explicit, stages => stages.accept(system, step, lanes, work));
            for (lane, own) in self.stiffness[..V::LANES].iter_mut().enumerate() {
                if !own.is_stiff && is_accepted(lane) {
                    own.after_explicit(measured.lane(lane).to_f64(), limit);
                }
            }
        }
        if some_stiff {
            self.implicit.accept(system, step, lanes, work);
            for (lane, own) in self.stiffness[..V::LANES].iter_mut().enumerate() {
                if own.is_stiff && is_accepted(lane) {
                    let jacobian = self.implicit.jacobian().map(|entry| entry.lane(lane));
                    let mut fastest = in_lane(&self.fastest, lane);
                    let rate = fastest_rate(&jacobian, &mut fastest);
                    set_lane(&mut self.fastest, lane, &fastest);
                    own.after_implicit((step.h.lane(lane).abs() * rate).to_f64(), limit);
                }
            }
        }
    }

    fn dense(&mut self, _system: &InMode<'_, S, V>, _step: &Step<V, N>, _work: &mut Statistics) -> &[SVector<V, N>] {
        &[]
    }

    fn coefficients(&self) -> &[SVector<V, N>] {
        &[]
    }
}
