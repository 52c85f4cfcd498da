//! The method that detects stiffness.

#[cfg(feature = "std")]
mod in_lanes;
mod stiff;
mod stiffness;

use nalgebra::SVector;

use crate::cost::Operations;
use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::InMode;
use crate::method::explicit::{self, ExplicitStages};
use crate::method::operations as count;
use crate::method::rosenbrock;
use crate::method::scheme::{Accepted, OneStep, Scheme, Stalled};
use crate::method::step_control::is_within_tolerance;
use crate::method::{Adaptive, Explicit, RadauIIA};
use crate::real::Float;
use crate::statistics::Statistics;
use crate::step_size::{Estimates, Tolerance};
use crate::system::{Jacobian, System};
use crate::tableau::{HairerWanner4, Steinebach5, Tableau, Tsitouras5, Verner7, Verner9};

/// An explicit method that switches to an implicit one where the system is stiff; see [`Adaptive`] for its settings.
///
/// | larger of both tolerances | explicit | implicit |
/// |---|---|---|
/// | above 5e-4 | [`Tsit5`](crate::Tsit5) | [`Rodas4`](crate::Rodas4) |
/// | above 1e-4 | [`Vern7`](crate::Vern7) | [`Rodas4`](crate::Rodas4) |
/// | above 5e-8 | [`Vern7`](crate::Vern7) | [`Rodas5P`](crate::Rodas5P) |
/// | above 1e-9 | [`Vern9`](crate::Vern9) | [`Rodas5P`](crate::Rodas5P) |
/// | up to 1e-9 | [`Vern9`](crate::Vern9) | [`Radau13`](crate::Radau13) |
///
/// The explicit method estimates `|h lambda|`, the length of the step times the fastest rate of the system, as
/// `h |f(x1) - f(x2)| / |x1 - x2|` from its two states at the end of the step (Hairer and Wanner II, IV.2). If it
/// repeatedly reaches the limit of stability, then stability rather than the tolerance limits the steps, and the
/// implicit method takes over. It also does so where the error estimate, of order `p`, repeatedly exceeds a tenth of
/// the trapezoidal rule's error times `(h r)^(p - 2)`, with the rate `r` of the solution. Along smooth solutions it is
/// far smaller, but not where fast modes oscillate or are driven, even far below the limit of stability. With
/// tolerances above 1e-4 a first step at the limit is enough, and with those above 5e-4 also a first step that is
/// rejected far beyond it. The implicit method estimates `|h lambda|` by power iteration with its Jacobian, and hands
/// back once explicit steps could be as long. Every second step is tested.
///
/// [`Statistics`] count the implicit steps and the switches.
///
/// ```
/// use pendulum_core::prelude::*;
///
/// mechanism! {
///     pub Creep {
///         params { gamma: N m s = 1e4 }
///         gravity: [0, -9.81, 0],
///         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, friction: gamma }
///     }
/// }
///
/// let creep = Creep::new(CreepParams::default())?;
/// let statistics = Auto::new().solve(&creep, 0.0, 100.0, [1.0, 0.0])?.statistics();
/// assert!(statistics.switches == 1 && statistics.stiff < 100 && statistics.accepted < 200);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type Auto = Adaptive<Switching>;

#[cfg(feature = "std")]
pub(crate) use in_lanes::{SwitchInLanes, SwitchingFrom};
use stiff::Stiff;
use stiffness::{Limits, Stiffness, even, of_fastest_rate};

/// Kind of method of [`Auto`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Switching;

/// Mean square of the error that a rejected step of an unstable method reports: the next one is about as long.
const BARELY_TOO_LARGE: f64 = 1.001;

impl Auto {
    /// Upper bound of the operations of one attempt of a step, for any tolerance and either method, in a system of `n`
    /// state components. `rhs` are the operations of the right-hand side, `jacobian` those of the right-hand side with
    /// the Jacobian and, if time occurs, the derivative by the time. An error above the tolerance takes another
    /// attempt.
    ///
    /// The bound assumes the maximum number of iterations of `Radau13`, 17. Comparisons and moves of numbers are extra.
    /// The error, the stiffness estimate, a switch and the choice of the next step are included; dense output and the
    /// choice of the first step are not.
    #[must_use]
    pub const fn operations(rhs: Operations, jacobian: Operations, n: usize) -> Operations {
        let tsit5 = explicit::attempt_within::<Tsitouras5, 7>(rhs, n).and(explicit::stiffness::<Tsitouras5, 7>(n));
        let vern7 = explicit::attempt_within::<Verner7, 11>(rhs, n).and(explicit::stiffness::<Verner7, 11>(n));
        let vern9 = explicit::attempt_within::<Verner9, 17>(rhs, n).and(explicit::stiffness::<Verner9, 17>(n));
        let explicit = tsit5.or(vern7).or(vern9).and(rhs);
        let rodas4 = rosenbrock::attempt_within::<HairerWanner4, 6>(rhs, jacobian, n);
        let rodas5p = rosenbrock::attempt_within::<Steinebach5, 8>(rhs, jacobian, n);
        let radau13 = Adaptive::<RadauIIA<7, 3>>::operations(rhs, jacobian, n);
        let implicit = rodas4.or(rodas5p).or(radau13);
        let implicit = implicit.and(of_fastest_rate(n)).and(jacobian);
        explicit.or(implicit).and(count::CONTROLLED)
    }
}

impl<S, T, const N: usize> OneStep<S, T, N> for Switching
where
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    type Scheme = Switch<T, N>;

    fn scheme(&self, system: &S, tolerance: Option<Tolerance<T>>) -> Result<Self::Scheme, Reason> {
        let pair = MethodPair::within(tolerance.as_ref());
        Ok(Switch {
            explicit: Free::new(pair, system, tolerance)?,
            implicit: Stiff::new(pair, system, tolerance)?,
            stiffness: pair.stiffness(),
            fastest: even(system.active()),
            error: T::default(),
        })
    }
}

impl Estimates for Switching {}

/// Both methods, one of which is active.
#[derive(Clone, Debug)]
pub struct Switch<T, const N: usize> {
    explicit: Free<T, N>,
    implicit: Stiff<T, N>,
    stiffness: Stiffness,
    /// Direction of the fastest change, for power iteration.
    fastest: SVector<T, N>,
    /// Mean square of the error of the last explicit attempt.
    error: T,
}

/// An explicit method with its limits.
pub(crate) trait Bounded<const STAGES: usize>: Tableau<STAGES> {
    /// Limits of the steps.
    const LIMITS: Limits;

    /// True if the implicit method takes over where the first step is rejected far beyond the limit. Other methods do
    /// not know their last stage then.
    const YIELDS_IF_REJECTED: bool = false;
}

impl Bounded<7> for Tsitouras5 {
    const LIMITS: Limits = Limits { stable: 3.5, free: 1.0 };
    const YIELDS_IF_REJECTED: bool = true;
}

impl Bounded<11> for Verner7 {
    const LIMITS: Limits = Limits { stable: 4.6, free: 1.4 };
}

impl Bounded<17> for Verner9 {
    const LIMITS: Limits = Limits {
        stable: 4.4,
        // with tight tolerances error estimates may grow from 0.4 on
        free: 0.7,
    };
}

/// Explicit and implicit method for a tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MethodPair {
    Tsit5Rodas4,
    Vern7Rodas4,
    Vern7Rodas5P,
    Vern9Rodas5P,
    Vern9Radau13,
}

impl MethodPair {
    /// Methods for a tolerance, the larger of both.
    pub(crate) fn within<T: Float>(tolerance: Option<&Tolerance<T>>) -> Self {
        let larger = tolerance.map_or(0.0, |tolerance| tolerance.rtol.max(tolerance.atol).to_f64());
        if larger > 5e-4 {
            Self::Tsit5Rodas4
        } else if larger > 1e-4 {
            // with tighter ones it loses its order where the motion is stiff and driven
            Self::Vern7Rodas4
        } else if larger > 5e-8 {
            Self::Vern7Rodas5P
        } else if larger > 1e-9 {
            Self::Vern9Rodas5P
        } else {
            // with 1e-8 and above, `Radau13` fails on some reactions or takes many short steps (Robertson's problem)
            Self::Vern9Radau13
        }
    }

    /// Detection of stiffness. `Rodas4` takes over after a first step at the limit of stability; with tighter
    /// tolerances the explicit method is better at fast transients, which it has to resolve.
    pub(crate) fn stiffness(self) -> Stiffness {
        Stiffness::new(matches!(self, Self::Tsit5Rodas4 | Self::Vern7Rodas4))
    }
}

/// The explicit method.
#[derive(Clone, Debug)]
enum Free<T, const N: usize> {
    Tsit5(ExplicitStages<Tsitouras5, T, 7, N>),
    Vern7(ExplicitStages<Verner7, T, 11, N>),
    Vern9(ExplicitStages<Verner9, T, 17, N>),
}

/// Matches on the explicit method.
macro_rules! explicit {
    ($free:expr, $stages:ident => $value:expr) => {
        match $free {
            Free::Tsit5($stages) => $value,
            Free::Vern7($stages) => $value,
            Free::Vern9($stages) => $value,
        }
    };
}

impl<T: Float, const N: usize> Free<T, N> {
    /// Creates the method of a pair.
    fn new<S>(pair: MethodPair, system: &S, tolerance: Option<Tolerance<T>>) -> Result<Self, Reason>
    where
        S: System<T, N> + ?Sized,
    {
        Ok(match pair {
            MethodPair::Tsit5Rodas4 => Self::Tsit5(OneStep::<S, T, N>::scheme(&Explicit::new(), system, tolerance)?),
            MethodPair::Vern7Rodas4 | MethodPair::Vern7Rodas5P => {
                Self::Vern7(OneStep::<S, T, N>::scheme(&Explicit::new(), system, tolerance)?)
            }
            MethodPair::Vern9Rodas5P | MethodPair::Vern9Radau13 => {
                Self::Vern9(OneStep::<S, T, N>::scheme(&Explicit::new(), system, tolerance)?)
            }
        })
    }

    /// Limits of the steps.
    fn limits(&self) -> Limits {
        match self {
            Self::Tsit5(_) => Tsitouras5::LIMITS,
            Self::Vern7(_) => Verner7::LIMITS,
            Self::Vern9(_) => Verner9::LIMITS,
        }
    }
}

/// Tests the last explicit step with its error if a test is due.
#[inline(always)]
fn test<B, T, const STAGES: usize, const N: usize>(
    stages: &ExplicitStages<B, T, STAGES, N>,
    (step, error, active): (&Step<T, N>, T, usize),
    stiffness: &mut Stiffness,
) where
    B: Bounded<STAGES>,
    T: Float,
{
    if stiffness.takes_test() {
        let measured = stages.stiffness(step.h).to_f64();
        let if_smooth = stages.error_if_smooth(step, active).to_f64();
        stiffness.after_explicit(measured, B::LIMITS, [error.to_f64(), if_smooth]);
    }
}

impl<T: Float, const N: usize> Switch<T, N> {
    /// Begins with the other method.
    #[cold]
    fn change<S>(&mut self, system: &InMode<'_, S, T>, t: T, x: &SVector<T, N>, work: &mut Statistics)
    where
        S: Jacobian<T, N> + ?Sized,
    {
        self.stiffness.is_stiff = !self.stiffness.is_stiff;
        work.switches += 1;
        self.begin(system, t, x, work);
    }
}

impl<S, T, const N: usize> Scheme<S, T, N> for Switch<T, N>
where
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    fn error_order(&self) -> usize {
        if self.stiffness.is_stiff {
            self.implicit.error_order::<S>()
        } else {
            explicit!(&self.explicit, stages => Scheme::<S, T, N>::error_order(stages))
        }
    }

    #[inline(always)]
    fn keeps_length(&self) -> (f64, f64) {
        if self.stiffness.is_stiff {
            self.implicit.keeps_length::<S>()
        } else {
            (1.0, 1.0)
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn begin(&mut self, system: &InMode<'_, S, T>, t: T, x: &SVector<T, N>, work: &mut Statistics) -> SVector<T, N> {
        self.stiffness.begin();
        if self.stiffness.is_stiff {
            self.implicit.begin(system, t, x, work)
        } else {
            explicit!(&mut self.explicit, stages => stages.begin(system, t, x, work))
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn attempt(
        &mut self,
        system: &InMode<'_, S, T>,
        (t, x): (T, &SVector<T, N>),
        (t_new, x_new): (T, &mut SVector<T, N>),
        work: &mut Statistics,
    ) -> Result<T, Stalled> {
        if self.stiffness.changes {
            self.change(system, t, x, work);
        }
        if self.stiffness.is_stiff {
            return self.implicit.attempt(system, (t, x), (t_new, x_new), work);
        }
        let error = explicit!(&mut self.explicit, stages => stages.attempt(system, (t, x), (t_new, x_new), work)?);
        self.error = error;
        if const { Tsitouras5::YIELDS_IF_REJECTED }
            && let Free::Tsit5(stages) = &self.explicit
            && self.stiffness.doubts_rejected()
            && !is_within_tolerance(error)
        {
            let measured = stages.stiffness(t_new - t).to_f64();
            self.stiffness.after_rejected(measured, Tsitouras5::LIMITS);
            if self.stiffness.changes {
                return Ok(T::from_f64(BARELY_TOO_LARGE));
            }
        }
        Ok(error)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn arrive(
        &mut self,
        system: &InMode<'_, S, T>,
        end: (T, &SVector<T, N>),
        work: &mut Statistics,
    ) -> Option<&SVector<T, N>> {
        if self.stiffness.is_stiff {
            Some(self.implicit.arrive(system, end, work))
        } else {
            explicit!(&mut self.explicit, stages => stages.arrive(system, end, work))
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn accept(&mut self, system: &InMode<'_, S, T>, step: &Step<T, N>, lanes: Accepted<T>, work: &mut Statistics) {
        if self.stiffness.is_stiff {
            work.stiff += 1;
            let limits = self.explicit.limits();
            let fastest = self.stiffness.takes_test().then_some(&mut self.fastest);
            if let Some(rate) = self.implicit.accept(system, (step, lanes), fastest, work) {
                self.stiffness.after_implicit((step.h.abs() * rate).to_f64(), limits);
            }
        } else {
            explicit!(&mut self.explicit, stages => {
                stages.accept(system, step, lanes, work);
                test(stages, (step, self.error, system.active()), &mut self.stiffness);
            });
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn dense(&mut self, system: &InMode<'_, S, T>, step: &Step<T, N>, work: &mut Statistics) -> &[SVector<T, N>] {
        if self.stiffness.is_stiff {
            self.implicit.dense(system, step, work)
        } else {
            explicit!(&mut self.explicit, stages => stages.dense(system, step, work))
        }
    }

    fn coefficients(&self) -> &[SVector<T, N>] {
        if self.stiffness.is_stiff {
            self.implicit.coefficients::<S>()
        } else {
            explicit!(&self.explicit, stages => Scheme::<S, T, N>::coefficients(stages))
        }
    }
}
