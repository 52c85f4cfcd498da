//! What a one-step method supplies; the engine, [`Stepper`](crate::Stepper), does the rest.

use nalgebra::SVector;

use crate::control::Tolerance;
use crate::dense::Step;
use crate::error::Reason;
use crate::real::Float;
use crate::solution::Statistics;

/// A kind of one-step method, which [`Fixed`](crate::method::Fixed) and [`Adaptive`](crate::method::Adaptive) give a pace.
pub trait OneStep<S: ?Sized, T: Float, const N: usize> {
    /// What a step of it works with.
    type Scheme: Scheme<S, T, N>;

    /// The scheme for steps within a tolerance, or for steps of a given length, which have none.
    ///
    /// # Errors
    /// [`Reason::InvalidInput`] if a setting of the family is out of its range.
    fn scheme(&self, system: &S, tolerance: Option<Tolerance<T>>) -> Result<Self::Scheme, Reason>;
}

/// The work of single steps: tried, finished, and interpolated.
///
/// The engine holds time and state, chooses the length of steps, and looks whether what comes back is finite.
pub trait Scheme<S: ?Sized, T: Float, const N: usize> {
    /// Whether [`prepare`](Self::prepare) chooses the steps.
    const PROPOSES: bool = false;

    /// The order `q` of the error estimate: the estimate falls as `h^(q + 1)`.
    fn error_order(&self) -> usize;

    /// Goes to an initial point, or to one after a jump: the derivative there.
    fn begin(&mut self, system: &S, t: T, x: &SVector<T, N>, work: &mut Statistics) -> SVector<T, N>;

    /// Gets ready for a step from `(t, x)`: the length that it should have, from methods that know before they try; else `None`.
    #[inline]
    fn prepare(&mut self, _system: &S, _t: T, _x: &SVector<T, N>, _work: &mut Statistics) -> Option<T> {
        None
    }

    /// Tries a step from `(t, x)` to `t_new`.
    fn attempt(
        &mut self,
        system: &S,
        start: (T, &SVector<T, N>),
        t_new: T,
        work: &mut Statistics,
    ) -> Result<Attempt<T, N>, Stalled>;

    /// Accepts the step that was tried last; if the derivative at its end is not finite, the scheme stays where it was.
    fn finish(&mut self, system: &S, step: &Step<T, N>, work: &mut Statistics) -> Result<(), NonFinite>;

    /// The vectors `c_1, c_2, ..` of the dense output `x0 + c_1 theta + c_2 theta^2 + ..`, `theta` the fraction of the step, for
    /// the step that was accepted last.
    fn dense(&mut self, system: &S, step: &Step<T, N>, work: &mut Statistics) -> &[SVector<T, N>];
}

/// Where an attempt arrived.
#[derive(Clone, Copy, Debug)]
pub struct Attempt<T, const N: usize> {
    /// The state at the end.
    pub x: SVector<T, N>,
    /// The mean square of the estimated error in units of the tolerance; 0 where there is no estimate.
    pub mean_square: T,
}

/// The iteration of an implicit method did not converge, or its matrix is singular: a shorter step may do.
#[derive(Clone, Copy, Debug)]
pub struct Stalled;

/// The component of a state or derivative that is infinite or not a number.
#[derive(Clone, Copy, Debug)]
pub struct NonFinite(pub usize);

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
        Reason::NonFinite { component, h: 0.0 }
    }
}
