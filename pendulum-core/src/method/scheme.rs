//! Interface of one-step methods. Two engines do the rest: [`Stepper`](crate::Stepper) for one trajectory, and
//! [`ensemble`](crate::ensemble) for many, in lanes.

use nalgebra::{SMatrix, SVector};

use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::{InMode, ModeSwitch};
use crate::real::lanes::Lanes;
use crate::real::{Float, Real};
use crate::statistics::Statistics;
use crate::step_size::Tolerance;

/// A kind of one-step method, independent of step-size control: [`Fixed`](crate::method::Fixed) and
/// [`Adaptive`](crate::method::Adaptive) determine the lengths of its steps.
///
/// `T` is a scalar, or several scalars in lanes.
pub trait OneStep<S: ?Sized, T: Lanes, const N: usize> {
    /// Scheme that takes the steps.
    type Scheme: Scheme<S, T, N>;

    /// Creates the scheme for steps within a tolerance, or for steps of fixed length, without one.
    ///
    /// # Errors
    /// [`Reason::InvalidInput`] if a setting is out of range.
    fn scheme(&self, system: &S, tolerance: Option<Tolerance<T::Scalar>>) -> Result<Self::Scheme, Reason>;
}

/// Work of single steps: attempts, acceptance, and dense output.
///
/// The engine stores time and state, chooses the length of steps, and checks that results are finite. `T` is a scalar,
/// or several scalars in lanes, each with its own time and step.
pub trait Scheme<S: ?Sized, T: Lanes, const N: usize>: Clone {
    /// True if [`prepare`](Self::prepare) chooses the steps.
    const PROPOSES: bool = false;

    /// True if each lane has its own, variable order.
    const ORDERS_DIFFER: bool = false;

    /// True if a step is complete without [`arrive`](Self::arrive), where the next one [begins](Self::begin) anew.
    const LEAVES_END: bool = false;

    /// True if the dense output is as accurate as the end of a step, also up to a kink within it.
    const DENSE_IS_EXACT: bool = false;

    /// Order `q` of the error estimate: the estimate falls as `h^(q + 1)`.
    fn error_order(&self) -> usize;

    /// Order of the error estimate in a lane, for schemes with [`ORDERS_DIFFER`](Self::ORDERS_DIFFER).
    fn error_order_in(&self, _lane: usize) -> usize {
        self.error_order()
    }

    /// Range of the change of a step within which the next one keeps the length of the last one, which saves the scheme
    /// work.
    #[inline(always)]
    fn keeps_length(&self) -> (f64, f64) {
        (1.0, 1.0)
    }

    /// Replaces the trajectory in a lane by the one with this index. All lanes [begin](Self::begin) next, at their
    /// present points.
    fn enter(&mut self, _lane: usize, _index: usize) {}

    /// Starts from an initial point, or from one after a jump, and returns the derivative there.
    fn begin(&mut self, system: &InMode<'_, S, T>, t: T, x: &SVector<T, N>, work: &mut Statistics) -> SVector<T, N>;

    /// Derivative at the start of the next step, if nothing else is kept from the step before: to change it in a lane
    /// is to [begin](Self::begin) there. Else `None`.
    #[inline(always)]
    fn slope_at_start(&mut self) -> Option<&mut SVector<T, N>> {
        None
    }

    /// Prepares a step from `(t, x)`. Returns its length from methods that determine it before an attempt, else `None`.
    #[inline(always)]
    fn prepare(&mut self, _system: &InMode<'_, S, T>, _t: T, _x: &SVector<T, N>, _work: &mut Statistics) -> Option<T> {
        None
    }

    /// Attempts a step from the start `(t, x)` to the end `(t, x)`, and writes the state at the end: on the constraints
    /// of the system, by [`System::project`](crate::System::project).
    ///
    /// Returns the mean square of the estimated error in units of the tolerance; 0 without an estimate. If some of
    /// several lanes stall, they get a negative mean square and a state that is not finite.
    fn attempt(
        &mut self,
        system: &InMode<'_, S, T>,
        start: (T, &SVector<T, N>),
        end: (T, &mut SVector<T, N>),
        work: &mut Statistics,
    ) -> Result<T, Stalled>;

    /// Returns the derivative at the end `(t, x)` of the last attempt, from methods that need it for the next step; it
    /// must be finite.
    fn arrive(
        &mut self,
        system: &InMode<'_, S, T>,
        end: (T, &SVector<T, N>),
        work: &mut Statistics,
    ) -> Option<&SVector<T, N>>;

    /// Accepts the step after [`arrive`](Self::arrive), in some lanes or in [all](Accepted::All). A scalar is all
    /// lanes.
    fn accept(&mut self, system: &InMode<'_, S, T>, step: &Step<T, N>, lanes: Accepted<T>, work: &mut Statistics);

    /// Coefficients `c_1, c_2, ..` of the dense output `x0 + c_1 theta + c_2 theta^2 + ..`, with `theta` the fraction
    /// of the step, for the last accepted step. In lanes it is the last attempted step, before it is accepted.
    fn dense(&mut self, system: &InMode<'_, S, T>, step: &Step<T, N>, work: &mut Statistics) -> &[SVector<T, N>];

    /// Restores the scheme's own state at the start of the last accepted step, before it [begins](Self::begin) there.
    fn go_back(&mut self) {}

    /// Transfers the scheme's own state across a mode switch of a hybrid system.
    fn pass(&mut self, _system: &S, _passage: &ModeSwitch<T, N>) {}

    /// Coefficients that [`dense`](Self::dense) computed for the last step.
    fn coefficients(&self) -> &[SVector<T, N>];

    /// Coefficients in a lane, whose number may differ between lanes.
    #[inline(always)]
    fn coefficients_in(&self, _lane: usize) -> &[SVector<T, N>] {
        self.coefficients()
    }

    /// Share of a lane in the `work` counted last by [`begin`](Self::begin), by [`prepare`](Self::prepare) and
    /// [`attempt`](Self::attempt), by [`arrive`](Self::arrive), or by [`dense`](Self::dense).
    #[inline(always)]
    fn work_in(&self, _lane: usize, work: &Statistics) -> Statistics {
        *work
    }
}

/// Lanes that accept a step.
#[derive(Clone, Copy, Debug)]
pub enum Accepted<T> {
    /// All lanes; a scalar is one lane.
    All,
    /// Lanes in which the number is negative.
    Negative(T),
}

impl<T: Lanes> Accepted<T> {
    /// True if a lane accepts.
    #[inline(always)]
    pub fn is_in(self, lane: usize) -> bool {
        match self {
            Self::All => true,
            Self::Negative(sign) => sign.lane(lane) < T::Scalar::default(),
        }
    }

    /// Returns `new` in the lanes that accept, and `old` in the others.
    #[inline(always)]
    pub fn select<const R: usize, const C: usize>(
        self,
        new: &SMatrix<T, R, C>,
        old: &SMatrix<T, R, C>,
    ) -> SMatrix<T, R, C> {
        match self {
            Self::All => *new,
            Self::Negative(_) => {
                let mut selected = *old;
                self.replace(&mut selected, new);
                selected
            }
        }
    }

    /// Replaces `old` by `new` in the lanes that accept.
    #[inline(always)]
    pub fn replace<const R: usize, const C: usize>(self, old: &mut SMatrix<T, R, C>, new: &SMatrix<T, R, C>) {
        match self {
            Self::All => *old = *new,
            Self::Negative(sign) => {
                let entries = old.data.0.as_flattened_mut().iter_mut();
                for (old, new) in entries.zip(new.data.0.as_flattened()) {
                    *old = sign.select(*new, *old);
                }
            }
        }
    }
}

/// Failure of an implicit method: its iteration did not converge, or its matrix is singular. A shorter step may
/// succeed.
#[derive(Clone, Copy, Debug)]
pub struct Stalled;

/// Marks the lanes that stall, where `defect` is not finite, as specified by [`Scheme::attempt`].
#[cold]
pub(crate) fn stall<V: Lanes, const N: usize>(defect: V, x_new: &mut SVector<V, N>, mean_square: V) -> V {
    let marked = |number: V, mark: f64| {
        V::from_fn(|lane| match defect.lane(lane).is_finite() {
            true => number.lane(lane),
            false => V::Scalar::from_f64(mark),
        })
    };
    *x_new = x_new.map(|x| marked(x, f64::NAN));
    marked(mean_square, -1.0)
}

/// Index of the component of a state or derivative that is infinite or NaN.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NonFinite(usize);

impl NonFinite {
    /// Returns the first such component as an error, if there is one.
    #[inline]
    pub(crate) fn check<T: Float, const N: usize>(v: &SVector<T, N>) -> Result<(), Self> {
        match v.iter().position(|component| !component.is_finite()) {
            None => Ok(()),
            Some(component) => Err(Self(component)),
        }
    }

    /// Reason not to start there, or not to continue there after a reset.
    pub(crate) fn at_start(self) -> Reason {
        let Self(component) = self;
        Reason::NonFinite { component, h: None }
    }

    /// The reason not to continue from a point that a step of the length `h` reached.
    #[cold]
    pub(crate) fn after(reason: Reason, h: f64) -> Reason {
        match reason {
            Reason::NonFinite { component, h: None } => Reason::NonFinite { component, h: Some(h) },
            other => other,
        }
    }
}

/// Reason why an attempt failed.
#[derive(Clone, Copy, Debug)]
pub(crate) enum StepFailure {
    Stalled,
    NonFinite(NonFinite),
}

impl From<Stalled> for StepFailure {
    fn from(Stalled: Stalled) -> Self {
        Self::Stalled
    }
}

impl From<NonFinite> for StepFailure {
    fn from(component: NonFinite) -> Self {
        Self::NonFinite(component)
    }
}

impl StepFailure {
    /// Reason to stop, after an attempt of length `h`.
    pub(crate) fn reason(self, h: f64) -> Reason {
        match self {
            Self::Stalled => Reason::NoConvergence { h },
            Self::NonFinite(NonFinite(component)) => Reason::NonFinite { component, h: Some(h) },
        }
    }
}
