//! The method that detects stiffness.

use nalgebra::{SMatrix, SVector};

use crate::cost::Operations;
use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::InMode;
use crate::linear::{image, square};
use crate::method::explicit::{self, ExplicitStages};
use crate::method::operations as count;
use crate::method::rosenbrock::{self, RosenbrockStages};
use crate::method::scheme::{Accepted, OneStep, Scheme, Stalled};
use crate::method::{Adaptive, Explicit, Rosenbrock};
use crate::real::{Float, Real};
use crate::statistics::Statistics;
use crate::step_size::{Estimates, Tolerance};
use crate::system::{Jacobian, System};
use crate::tableau::{self, Tableau, Tsitouras5, Verner7, Verner9};

/// An explicit method that switches to [`Rodas5P`](crate::Rodas5P) where the system is stiff; see [`Adaptive`] for its
/// settings.
///
/// The explicit method is Tsitouras's for tolerances above 1e-4, Verner's of order 7 above 1e-8, and Verner's of order
/// 9 below. In each step it estimates `|h lambda|`, the length of the step times the fastest rate of the system, as `h
/// |f(x1) - f(x2)| / |x1 - x2|` from its two states at the end of the step (Hairer and Wanner II, IV.2). If the
/// estimate repeatedly reaches the limit of stability, then stability rather than the tolerance limits the steps, and
/// the implicit method takes over. It does so at a smaller estimate if the derivative changes much less over a step
/// than it would at that rate. The implicit method estimates `|h lambda|` by power iteration with its Jacobian, and
/// hands back once explicit steps of the same length would be stable.
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

/// Kind of method of [`Auto`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Switching;

/// Tolerance above which the method of Tsitouras is used.
const LOOSE: f64 = 1e-4;
/// Tolerance above which Verner's method of order 7 is used.
const MIDDLE: f64 = 1e-8;
/// Fraction of the stability limit at which it limits the explicit steps: error estimates grow before the errors do
/// (with Verner's method of order 9 the fraction hovers about 0.6).
const AT_THE_LIMIT: f64 = 0.55;
/// Fraction of the stability limit above which it limits steps along a smooth solution. With Verner's method of order 9
/// and a tolerance of 1e-12, steps along the slow solution of Robertson's problem stay between 0.4 and 0.55.
const AT_THE_LIMIT_IF_SMOOTH: f64 = 0.35;
/// Change of the derivative over a step, in units of `|h lambda|`, below which a solution is smooth: it does not move
/// at the fastest rate `lambda`.
const SMOOTH: f64 = 0.1;
/// Number of steps at the limit that make a system stiff, without [`FREE`] others in a row between them.
const STIFF: usize = 8;
/// Number of steps in a row below the limit that reset the count, or that return to the explicit method.
const FREE: usize = 4;
/// Fraction of the stability limit up to which an implicit step could as well be explicit.
const WITHIN: f64 = 0.3;

impl Auto {
    /// Upper bound of the operations of one attempt of a step, for any tolerance and either method, in a system of `n`
    /// state components. `rhs` are the operations of the right-hand side, `jacobian` those of the right-hand side with
    /// the Jacobian and, if time occurs, the derivative by the time. An error above the tolerance takes another
    /// attempt.
    ///
    /// Comparisons and moves of numbers are extra. The error, the stiffness estimate, a switch and the choice of the
    /// next step are included; dense output and the choice of the first step are not.
    #[must_use]
    pub const fn operations(rhs: Operations, jacobian: Operations, n: usize) -> Operations {
        let tsit5 = explicit::attempt_within::<Tsitouras5, 7>(rhs, n).and(explicit::stiffness::<Tsitouras5, 7>(n));
        let vern7 = explicit::attempt_within::<Verner7, 11>(rhs, n).and(explicit::stiffness::<Verner7, 11>(n));
        let vern9 = explicit::attempt_within::<Verner9, 17>(rhs, n).and(explicit::stiffness::<Verner9, 17>(n));
        let explicit = tsit5.or(vern7).or(vern9).and(rhs);
        let implicit = rosenbrock::attempt_within::<tableau::Steinebach5, 8>(rhs, jacobian, n);
        let implicit = implicit.and(of_fastest_rate(n)).and(jacobian);
        explicit.or(implicit).and(count::CONTROLLED)
    }
}

/// Operations of [`fastest_rate`], and of its product with the length of a step.
const fn of_fastest_rate(n: usize) -> Operations {
    let image = Operations::new(n * n, n * n, 0, 0, 0, n + 1);
    let lengths = count::square(n).times(2).and(Operations::new(0, 0, 0, 0, 2, 20));
    let iteration = image
        .and(lengths)
        .and(count::multiplied(n))
        .and(Operations::new(0, 1, 2, 0, 0, 9));
    iteration.times(ITERATIONS).and(Operations::new(0, 1, 0, 0, 3, 21))
}

impl<S, T, const N: usize> OneStep<S, T, N> for Switching
where
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    type Scheme = Switch<T, N>;

    fn scheme(&self, system: &S, tolerance: Option<Tolerance<T>>) -> Result<Self::Scheme, Reason> {
        Ok(Switch {
            explicit: Free::new(system, tolerance)?,
            implicit: OneStep::<S, T, N>::scheme(&Rosenbrock::default(), system, tolerance)?,
            stiffness: Stiffness::default(),
            fastest: ones(system.active()),
        })
    }
}

impl Estimates for Switching {}

/// Both methods, one of which is active.
#[derive(Clone, Debug)]
pub struct Switch<T, const N: usize> {
    explicit: Free<T, N>,
    implicit: RosenbrockStages<tableau::Steinebach5, T, 8, N>,
    stiffness: Stiffness,
    /// Direction of the fastest change, for power iteration.
    fastest: SVector<T, N>,
}

/// Detection of stiffness from the steps so far.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Stiffness {
    /// True if the implicit method is active.
    pub(crate) is_stiff: bool,
    /// True if the other method takes the next step.
    pub(crate) changes: bool,
    /// Number of steps at the limit of stability.
    at_limit: usize,
    /// Number of steps in a row that are not.
    free: usize,
}

impl Stiffness {
    /// Restarts the counts for the active method.
    pub(crate) fn begin(&mut self) {
        (self.changes, self.at_limit, self.free) = (false, 0, 0);
    }

    /// Counts an explicit step by its `|h lambda|` and the relative change of the derivative over it, and requests a
    /// switch after too many at the limit of stability.
    pub(crate) fn after_explicit(&mut self, measured: f64, turn: f64, limit: f64) {
        let is_smooth = turn < SMOOTH * measured;
        let share = if is_smooth {
            AT_THE_LIMIT_IF_SMOOTH
        } else {
            AT_THE_LIMIT
        };
        if measured > share * limit {
            self.at_limit += 1;
            self.free = 0;
        } else {
            self.free += 1;
            if self.free >= FREE {
                self.at_limit = 0;
            }
        }
        self.changes = self.at_limit >= STIFF;
    }

    /// Counts an implicit step, and requests a switch if explicit steps of such lengths would have been stable for a
    /// while.
    pub(crate) fn after_implicit(&mut self, measured: f64, limit: f64) {
        if measured <= WITHIN * limit {
            self.free += 1;
        } else {
            self.free = 0;
        }
        self.changes = self.free >= FREE;
    }
}

/// An explicit method with its limit of stability.
pub(crate) trait Bounded<const STAGES: usize>: Tableau<STAGES> {
    /// Limit of stability on the negative real axis.
    const LIMIT: f64;
}

impl Bounded<7> for Tsitouras5 {
    const LIMIT: f64 = 3.5;
}

impl Bounded<11> for Verner7 {
    const LIMIT: f64 = 4.6;
}

impl Bounded<17> for Verner9 {
    const LIMIT: f64 = 4.4;
}

/// Choice of the explicit method.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Choice {
    Tsit5,
    Vern7,
    Vern9,
}

impl Choice {
    /// Method for a tolerance.
    pub(crate) fn within<T: Float>(tolerance: Option<&Tolerance<T>>) -> Self {
        let least = tolerance.map_or(0.0, |tolerance| tolerance.rtol.max(tolerance.atol).to_f64());
        if least > LOOSE {
            Self::Tsit5
        } else if least > MIDDLE {
            Self::Vern7
        } else {
            Self::Vern9
        }
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

#[cfg(feature = "std")]
mod in_lanes;

impl<T: Float, const N: usize> Free<T, N> {
    /// Creates the method for a tolerance.
    fn new<S>(system: &S, tolerance: Option<Tolerance<T>>) -> Result<Self, Reason>
    where
        S: System<T, N> + ?Sized,
    {
        Ok(match Choice::within(tolerance.as_ref()) {
            Choice::Tsit5 => Self::Tsit5(OneStep::<S, T, N>::scheme(&Explicit::new(), system, tolerance)?),
            Choice::Vern7 => Self::Vern7(OneStep::<S, T, N>::scheme(&Explicit::new(), system, tolerance)?),
            Choice::Vern9 => Self::Vern9(OneStep::<S, T, N>::scheme(&Explicit::new(), system, tolerance)?),
        })
    }

    /// Limit of stability.
    fn limit(&self) -> f64 {
        match self {
            Self::Tsit5(_) => Tsitouras5::LIMIT,
            Self::Vern7(_) => Verner7::LIMIT,
            Self::Vern9(_) => Verner9::LIMIT,
        }
    }
}

/// First vector of a power iteration, without padding.
pub(crate) fn ones<T: Real, const N: usize>(active: usize) -> SVector<T, N> {
    SVector::from_fn(|n, _| T::from_f64(if n < active { 1.0 } else { 0.0 }))
}

/// Number of power iterations. The fourth root below depends on it.
const ITERATIONS: usize = 4;

/// Magnitude of the largest eigenvalue of a matrix, by a few power iterations from `v`, which converges to its
/// eigenvector.
///
/// A complex pair makes `v` rotate; the mean over the iterations smooths its effect.
pub(crate) fn fastest_rate<T: Float, const N: usize>(
    matrix: &SMatrix<T, N, N>,
    v: &mut SVector<T, N>,
    active: usize,
) -> T {
    let mut product = T::from_f64(1.0);
    for _ in 0..ITERATIONS {
        let before = square(v).sqrt();
        let image = image(matrix, v);
        let after = square(&image).sqrt();
        if !(after.is_finite() && after > T::default() && before > T::default()) {
            *v = ones(active);
            return T::default();
        }
        product *= after / before;
        *v = image * (T::from_f64(1.0) / after);
    }
    product.sqrt().sqrt()
}

impl<S, T, const N: usize> Scheme<S, T, N> for Switch<T, N>
where
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    fn error_order(&self) -> usize {
        if self.stiffness.is_stiff {
            Scheme::<S, T, N>::error_order(&self.implicit)
        } else {
            explicit!(&self.explicit, stages => Scheme::<S, T, N>::error_order(stages))
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

    fn prepare(&mut self, system: &InMode<'_, S, T>, t: T, x: &SVector<T, N>, work: &mut Statistics) -> Option<T> {
        if self.stiffness.changes {
            self.stiffness.is_stiff = !self.stiffness.is_stiff;
            work.switches += 1;
            self.begin(system, t, x, work);
        }
        None
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn attempt(
        &mut self,
        system: &InMode<'_, S, T>,
        start: (T, &SVector<T, N>),
        end: (T, &mut SVector<T, N>),
        work: &mut Statistics,
    ) -> Result<T, Stalled> {
        if self.stiffness.is_stiff {
            self.implicit.attempt(system, start, end, work)
        } else {
            explicit!(&mut self.explicit, stages => stages.attempt(system, start, end, work))
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn arrive(
        &mut self,
        system: &InMode<'_, S, T>,
        end: (T, &SVector<T, N>),
        work: &mut Statistics,
    ) -> Option<&SVector<T, N>> {
        if self.stiffness.is_stiff {
            self.implicit.arrive(system, end, work)
        } else {
            explicit!(&mut self.explicit, stages => stages.arrive(system, end, work))
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn accept(&mut self, system: &InMode<'_, S, T>, step: &Step<T, N>, lanes: Accepted<T>, work: &mut Statistics) {
        if self.stiffness.is_stiff {
            self.implicit.accept(system, step, lanes, work);
            work.stiff += 1;
            let rate = fastest_rate(self.implicit.jacobian(), &mut self.fastest, system.active());
            self.stiffness
                .after_implicit((step.h.abs() * rate).to_f64(), self.explicit.limit());
        } else {
            explicit!(&mut self.explicit, stages => stages.accept(system, step, lanes, work));
            let (measured, turn) = explicit!(&self.explicit, stages => (stages.stiffness(step.h), stages.turn()));
            self.stiffness
                .after_explicit(measured.to_f64(), turn.to_f64(), self.explicit.limit());
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
            Scheme::<S, T, N>::coefficients(&self.implicit)
        } else {
            explicit!(&self.explicit, stages => Scheme::<S, T, N>::coefficients(stages))
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};

    use super::fastest_rate;

    #[test]
    fn the_fastest_rate_is_that_of_the_largest_eigenvalue() {
        let symmetric = SMatrix::<f64, 2, 2>::new(-3.0, 1.0, 1.0, -3.0);
        // almost the eigenvector of -2
        let mut v = SVector::from([1.0, 0.999]);
        for _ in 0..20 {
            fastest_rate(&symmetric, &mut v, 2);
        }
        assert!((fastest_rate(&symmetric, &mut v, 2) - 4.0).abs() < 1e-9);
        assert!((v.norm() - 1.0).abs() < 1e-12 && (v[0] + v[1]).abs() < 1e-9, "{v}");
        // a pair +-5 i: over two iterations the vector grows by 25 and makes half a turn
        let turning = SMatrix::<f64, 2, 2>::new(0.0, 50.0, -0.5, 0.0);
        assert!((fastest_rate(&turning, &mut v, 2) - 5.0).abs() < 1e-9);
    }

    #[test]
    fn what_shows_no_rate_is_left_for_another_direction() {
        let second = SMatrix::<f64, 2, 2>::new(0.0, 0.0, 0.0, -7.0);
        for mut v in [[1.0, 0.0], [0.0, 0.0], [f64::NAN, 1.0]].map(SVector::from) {
            assert_eq!(fastest_rate(&second, &mut v, 2), 0.0);
            assert_eq!(
                fastest_rate(&second, &mut v, 2).powi(4).round(),
                (7.0_f64.powi(4) / 2.0_f64.sqrt()).round()
            );
            assert!((fastest_rate(&second, &mut v, 2) - 7.0).abs() < 1e-12);
        }
    }
}
