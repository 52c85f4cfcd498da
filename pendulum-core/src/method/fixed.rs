//! Steps of a given length.

use crate::error::Reason;
use crate::method::grid::Grid;
use crate::method::input::check_start;
use crate::method::scheme::OneStep;
use crate::method::stepper::Steps;
use crate::method::{Method, Stepper};
use crate::real::Float;
use crate::system::{IntoState, System};

/// A method with steps of a given length; [`Rk4`](crate::Rk4) is one. `F` is what a step of it does.
///
/// The steps end at the multiples `t0 + i h`, formed without summing up, and the last one is shortened so that it ends at
/// `t1` exactly. After a restart within a step the multiples stay where they were.
///
/// The only setting is `h`, which must be positive, whatever the direction of time, and resolved by the times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fixed<F> {
    pub(crate) h: f64,
    pub(crate) family: F,
}

impl<F: Default> Fixed<F> {
    /// The method with steps of length `h`, which is positive whatever the direction of time.
    #[must_use]
    pub fn new(h: f64) -> Self {
        Self {
            h,
            family: F::default(),
        }
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
