//! Steps of fixed length.

use crate::error::Reason;
use crate::method::grid::Grid;
use crate::method::input::check_start;
use crate::method::scheme::OneStep;
use crate::method::smooth::Steps;
use crate::method::{Method, Stepper};
use crate::real::Float;
use crate::system::{IntoState, System};

/// A method with steps of fixed length, such as [`Rk4`](crate::Rk4). `F` is the kind of step.
///
/// The steps end at the times `t0 + i h`, computed without accumulating rounding errors; the last step is shortened to
/// end exactly at `t1`. A restart within a step does not move these times.
///
/// There is no error control: steps too long for a motion give wrong results without an error.
/// [`Solution::unresolved`](crate::Solution::unresolved) reports steps that are far too long. To estimate the error,
/// compare with half the step, or with an adaptive method; [`max_stable_step`](crate::stability::max_stable_step)
/// returns the longest stable step.
///
/// The only setting is `h`, which must be positive, even backward in time, and large enough to be resolved by the
/// times. [`solve`](Method::solve) stores at most ten million points; [`stepper`](Method::stepper) has no such limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fixed<F> {
    pub(crate) h: f64,
    pub(crate) family: F,
}

impl<F: Default> Fixed<F> {
    /// Creates the method with steps of length `h`, which is positive even backward in time.
    #[must_use]
    pub fn new(h: f64) -> Self {
        Self {
            h,
            family: F::default(),
        }
    }
}

impl<F> Fixed<F> {
    /// Length of a step.
    #[must_use]
    pub const fn h(&self) -> f64 {
        self.h
    }
}

impl<F, S, T, const N: usize> Method<S, T, N> for Fixed<F>
where
    F: OneStep<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    type Scheme = F::Scheme;

    fn stepper<'s>(
        &self,
        system: &'s S,
        t0: T,
        t1: T,
        x0: impl IntoState<T, N>,
    ) -> Result<Stepper<'s, Self::Scheme, S, T, N>, Reason> {
        let x0 = x0.into_state();
        check_start(t0, t1, &x0)?;
        let grid = Grid::new(self.h, t0, t1)?;
        let scheme = self.family.scheme(system, None)?;
        Stepper::new(system, scheme, (t0, t1), x0, Steps::Equal(grid))
    }
}
