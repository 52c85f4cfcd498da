//! What a one-step method supplies. Two engines do the rest: [`Stepper`](crate::Stepper) for one trajectory, and
//! [`ensemble`](crate::ensemble) for many, in lanes.

use nalgebra::SVector;

use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::{InMode, ModeSwitch};
use crate::real::lanes::Lanes;
use crate::real::{Float, Real};
use crate::statistics::Statistics;
use crate::step_size::Tolerance;

/// A kind of one-step method, which [`Fixed`](crate::method::Fixed) and [`Adaptive`](crate::method::Adaptive) give the
/// lengths of its steps.
///
/// `T` is a scalar, or several in lanes.
pub trait OneStep<S: ?Sized, T: Lanes, const N: usize> {
    /// What a step of it works with.
    type Scheme: Scheme<S, T, N>;

    /// The scheme for steps within a tolerance, or for steps of fixed length, which have none.
    ///
    /// # Errors
    /// [`Reason::InvalidInput`] if a setting is out of its range.
    fn scheme(&self, system: &S, tolerance: Option<Tolerance<T::Scalar>>) -> Result<Self::Scheme, Reason>;
}

/// The work of single steps: tried, accepted, and interpolated.
///
/// The engine holds time and state, chooses the length of steps, and checks that what comes back is finite. `T` is a
/// scalar, or several in lanes, each of which has a time and a step of its own.
pub trait Scheme<S: ?Sized, T: Lanes, const N: usize>: Clone {
    /// Whether [`prepare`](Self::prepare) chooses the steps.
    const PROPOSES: bool = false;

    /// Whether each lane has an order of its own, which changes.
    const ORDERS_DIFFER: bool = false;

    /// The order `q` of the error estimate: the estimate falls as `h^(q + 1)`.
    fn error_order(&self) -> usize;

    /// The same in a lane, where [`ORDERS_DIFFER`](Self::ORDERS_DIFFER).
    fn error_order_in(&self, _lane: usize) -> usize {
        self.error_order()
    }

    /// Another trajectory, of this index, takes a lane; all of them [begin](Self::begin) next, where they are.
    fn enter(&mut self, _lane: usize, _index: usize) {}

    /// Goes to an initial point, or to one after a jump: the derivative there.
    fn begin(&mut self, system: &InMode<'_, S, T>, t: T, x: &SVector<T, N>, work: &mut Statistics) -> SVector<T, N>;

    /// Prepares a step from `(t, x)`: its length, from methods that know it before they try; else `None`.
    #[inline(always)]
    fn prepare(&mut self, _system: &InMode<'_, S, T>, _t: T, _x: &SVector<T, N>, _work: &mut Statistics) -> Option<T> {
        None
    }

    /// Tries a step from the start `(t, x)` to the end `(t, x)`, whose state it writes: on the constraints of the
    /// system, by [`System::project`](crate::System::project).
    ///
    /// Returns the mean square of the estimated error in units of the tolerance; 0 where there is no estimate. Of
    /// several lanes, those that stall have a negative one, and a state that is not finite.
    fn attempt(
        &mut self,
        system: &InMode<'_, S, T>,
        start: (T, &SVector<T, N>),
        end: (T, &mut SVector<T, N>),
        work: &mut Statistics,
    ) -> Result<T, Stalled>;

    /// The derivative at the end `(t, x)` of the step that was tried last, from methods that need it for the next step;
    /// it must be finite.
    fn arrive(
        &mut self,
        system: &InMode<'_, S, T>,
        end: (T, &SVector<T, N>),
        work: &mut Statistics,
    ) -> Option<&SVector<T, N>>;

    /// Accepts the step after [`arrive`](Self::arrive), in some lanes or in [all](Accepted::All); a scalar is all.
    fn accept(&mut self, system: &InMode<'_, S, T>, step: &Step<T, N>, lanes: Accepted<T>, work: &mut Statistics);

    /// The vectors `c_1, c_2, ..` of the dense output `x0 + c_1 theta + c_2 theta^2 + ..`, `theta` the fraction of the
    /// step, for the step that was accepted last. In lanes it is that which was tried last, before it is accepted.
    fn dense(&mut self, system: &InMode<'_, S, T>, step: &Step<T, N>, work: &mut Statistics) -> &[SVector<T, N>];

    /// Goes back to the start of the step that was accepted last, before it [begins](Self::begin) there: what a scheme
    /// carries along with the state.
    fn go_back(&mut self) {}

    /// Passes from one mode of a hybrid system to the next: what a scheme carries along with the state.
    fn pass(&mut self, _system: &S, _passage: &ModeSwitch<T, N>) {}

    /// What [`dense`](Self::dense) found for the last step.
    fn coefficients(&self) -> &[SVector<T, N>];

    /// The same in a lane, of which others may have fewer or more.
    #[inline(always)]
    fn coefficients_in(&self, _lane: usize) -> &[SVector<T, N>] {
        self.coefficients()
    }

    /// A lane's part of the `work` that was counted last: to [begin](Self::begin), to [prepare](Self::prepare) and
    /// [attempt](Self::attempt), to [arrive](Self::arrive), or for [`dense`](Self::dense).
    #[inline(always)]
    fn work_in(&self, _lane: usize, work: &Statistics) -> Statistics {
        *work
    }
}

/// Which lanes accept a step.
#[derive(Clone, Copy, Debug)]
pub enum Accepted<T> {
    /// All of them; a scalar is one lane.
    All,
    /// Those in which the number is negative.
    Negative(T),
}

impl<T: Lanes> Accepted<T> {
    /// Whether a lane accepts.
    #[inline(always)]
    pub fn is_in(self, lane: usize) -> bool {
        match self {
            Self::All => true,
            Self::Negative(sign) => sign.lane(lane) < T::Scalar::default(),
        }
    }

    /// `new` in the lanes that accept, and `old` in the others.
    #[inline(always)]
    pub fn select<const N: usize>(self, new: &SVector<T, N>, old: &SVector<T, N>) -> SVector<T, N> {
        match self {
            Self::All => *new,
            Self::Negative(sign) => {
                let mut selected = *old;
                for (old, new) in selected.data.0[0].iter_mut().zip(&new.data.0[0]) {
                    *old = sign.select(*new, *old);
                }
                selected
            }
        }
    }
}

/// The iteration of an implicit method did not converge, or its matrix is singular: a shorter step may succeed.
#[derive(Clone, Copy, Debug)]
pub struct Stalled;

/// Marks the lanes that stall, where `defect` is not finite, as [`Scheme::attempt`] says.
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

/// The component of a state or derivative that is infinite or not a number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NonFinite(usize);

impl NonFinite {
    /// The first such component, if there is one.
    #[inline]
    pub(crate) fn check<T: Float, const N: usize>(v: &SVector<T, N>) -> Result<(), Self> {
        match v.iter().position(|component| !component.is_finite()) {
            None => Ok(()),
            Some(component) => Err(Self(component)),
        }
    }

    /// The reason not to start, or to go on after a reset, from there.
    pub(crate) fn at_start(self) -> Reason {
        let Self(component) = self;
        Reason::NonFinite { component, h: None }
    }
}

/// Why an attempt was not a step.
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
    /// The reason to give up, after a step of length `h`.
    pub(crate) fn reason(self, h: f64) -> Reason {
        match self {
            Self::Stalled => Reason::NoConvergence { h },
            Self::NonFinite(NonFinite(component)) => Reason::NonFinite { component, h: Some(h) },
        }
    }
}
