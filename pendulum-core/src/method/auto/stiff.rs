//! The implicit methods of [`Auto`](crate::Auto).
//!
//! Their steps are compiled apart: explicit steps take an eighth longer in one function with them.

use nalgebra::SVector;

use super::MethodPair;
use super::stiffness::fastest_rate;
use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::InMode;
use crate::method::radau::RadauStages;
use crate::method::rosenbrock::RosenbrockStages;
use crate::method::scheme::{Accepted, OneStep, Scheme, Stalled};
use crate::method::{RadauIIA, Rosenbrock};
use crate::real::Float;
use crate::real::lanes::Routine;
use crate::statistics::Statistics;
use crate::step_size::Tolerance;
use crate::system::{Jacobian, System};
use crate::tableau::{HairerWanner4, Steinebach5};

/// The implicit method.
#[derive(Clone, Debug)]
pub(super) enum Stiff<T, const N: usize> {
    Rodas4(RosenbrockStages<HairerWanner4, T, 6, N>),
    Rodas5P(RosenbrockStages<Steinebach5, T, 8, N>),
    Radau13(RadauStages<T, 7, 3, N>),
}

/// Matches on the implicit method.
macro_rules! implicit {
    ($stiff:expr, $stages:ident => $value:expr) => {
        match $stiff {
            Stiff::Rodas4($stages) => $value,
            Stiff::Rodas5P($stages) => $value,
            Stiff::Radau13($stages) => $value,
        }
    };
}

impl<T: Float, const N: usize> Stiff<T, N> {
    /// Creates the method of a pair.
    pub(super) fn new<S>(pair: MethodPair, system: &S, tolerance: Option<Tolerance<T>>) -> Result<Self, Reason>
    where
        S: Jacobian<T, N> + ?Sized,
    {
        Ok(match pair {
            MethodPair::Tsit5Rodas4 | MethodPair::Vern7Rodas4 => {
                Self::Rodas4(OneStep::<S, T, N>::scheme(&Rosenbrock::default(), system, tolerance)?)
            }
            MethodPair::Vern7Rodas5P | MethodPair::Vern9Rodas5P => {
                Self::Rodas5P(OneStep::<S, T, N>::scheme(&Rosenbrock::default(), system, tolerance)?)
            }
            MethodPair::Vern9Radau13 => Self::Radau13(OneStep::<S, T, N>::scheme(&RadauIIA, system, tolerance)?),
        })
    }

    pub(super) fn error_order<S: Jacobian<T, N> + ?Sized>(&self) -> usize {
        implicit!(self, stages => Scheme::<S, T, N>::error_order(stages))
    }

    #[inline(always)]
    pub(super) fn keeps_length<S: Jacobian<T, N> + ?Sized>(&self) -> (f64, f64) {
        implicit!(self, stages => Scheme::<S, T, N>::keeps_length(stages))
    }

    pub(super) fn coefficients<S: Jacobian<T, N> + ?Sized>(&self) -> &[SVector<T, N>] {
        implicit!(self, stages => Scheme::<S, T, N>::coefficients(stages))
    }

    #[inline(always)]
    pub(super) fn begin<S>(
        &mut self,
        system: &InMode<'_, S, T>,
        t: T,
        x: &SVector<T, N>,
        work: &mut Statistics,
    ) -> SVector<T, N>
    where
        S: Jacobian<T, N> + ?Sized,
    {
        T::call(Begin(t, x), &mut (self, work), system)
    }

    #[inline(always)]
    pub(super) fn attempt<S>(
        &mut self,
        system: &InMode<'_, S, T>,
        start: (T, &SVector<T, N>),
        (t_new, x_new): (T, &mut SVector<T, N>),
        work: &mut Statistics,
    ) -> Result<T, Stalled>
    where
        S: Jacobian<T, N> + ?Sized,
    {
        T::call(Attempt { start, t_new }, &mut (self, x_new, work), system)
    }

    #[inline(always)]
    pub(super) fn arrive<S>(
        &mut self,
        system: &InMode<'_, S, T>,
        (t, x): (T, &SVector<T, N>),
        work: &mut Statistics,
    ) -> &SVector<T, N>
    where
        S: Jacobian<T, N> + ?Sized,
    {
        T::call(Arrive(t, x), &mut (&mut *self, work), system);
        implicit!(self, stages => stages.end())
    }

    /// Accepts the step, and returns the fastest rate of the system at its end if a direction for the iteration that
    /// finds it is given.
    #[inline(always)]
    pub(super) fn accept<S>(
        &mut self,
        system: &InMode<'_, S, T>,
        (step, lanes): (&Step<T, N>, Accepted<T>),
        fastest: Option<&mut SVector<T, N>>,
        work: &mut Statistics,
    ) -> Option<T>
    where
        S: Jacobian<T, N> + ?Sized,
    {
        T::call(Accept(step, lanes), &mut (self, fastest, work), system)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn dense<S>(
        &mut self,
        system: &InMode<'_, S, T>,
        step: &Step<T, N>,
        work: &mut Statistics,
    ) -> &[SVector<T, N>]
    where
        S: Jacobian<T, N> + ?Sized,
    {
        implicit!(self, stages => stages.dense(system, step, work))
    }
}

/// Start from a point.
struct Begin<'a, T, const N: usize>(T, &'a SVector<T, N>);

impl<'s, S, T, const N: usize> Routine<(&mut Stiff<T, N>, &mut Statistics), InMode<'s, S, T>> for Begin<'_, T, N>
where
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    type Output = SVector<T, N>;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run(self, (stiff, work): &mut (&mut Stiff<T, N>, &mut Statistics), system: &InMode<'s, S, T>) -> Self::Output {
        implicit!(stiff, stages => stages.begin(system, self.0, self.1, work))
    }
}

/// Attempt of a step.
struct Attempt<'a, T, const N: usize> {
    start: (T, &'a SVector<T, N>),
    t_new: T,
}

/// Data that an attempt changes: the method, the state at the end, and the work so far.
type Tried<'a, T, const N: usize> = (&'a mut Stiff<T, N>, &'a mut SVector<T, N>, &'a mut Statistics);

impl<'s, S, T, const N: usize> Routine<Tried<'_, T, N>, InMode<'s, S, T>> for Attempt<'_, T, N>
where
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    type Output = Result<T, Stalled>;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run(self, (stiff, x_new, work): &mut Tried<'_, T, N>, system: &InMode<'s, S, T>) -> Self::Output {
        implicit!(stiff, stages => stages.attempt(system, self.start, (self.t_new, x_new), work))
    }
}

/// Derivative at the end of an attempt.
struct Arrive<'a, T, const N: usize>(T, &'a SVector<T, N>);

impl<'s, S, T, const N: usize> Routine<(&mut Stiff<T, N>, &mut Statistics), InMode<'s, S, T>> for Arrive<'_, T, N>
where
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    type Output = ();

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run(self, (stiff, work): &mut (&mut Stiff<T, N>, &mut Statistics), system: &InMode<'s, S, T>) {
        implicit!(stiff, stages => {
            stages.arrive(system, (self.0, self.1), work);
        });
    }
}

/// Acceptance of a step, with the fastest rate at its end.
struct Accept<'a, T, const N: usize>(&'a Step<T, N>, Accepted<T>);

/// Data that an acceptance changes: the method, the direction of the fastest change, and the work so far.
type Taken<'a, T, const N: usize> = (&'a mut Stiff<T, N>, Option<&'a mut SVector<T, N>>, &'a mut Statistics);

impl<'s, S, T, const N: usize> Routine<Taken<'_, T, N>, InMode<'s, S, T>> for Accept<'_, T, N>
where
    S: Jacobian<T, N> + ?Sized,
    T: Float,
{
    type Output = Option<T>;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run(self, (stiff, fastest, work): &mut Taken<'_, T, N>, system: &InMode<'s, S, T>) -> Option<T> {
        implicit!(stiff, stages => {
            stages.accept(system, self.0, self.1, work);
            let fastest = fastest.as_deref_mut()?;
            Some(fastest_rate(stages.jacobian(), fastest, system.active()))
        })
    }
}
