//! Measured outputs of a model.

use nalgebra::SVector;

use crate::error::Reason;
use crate::method::require;
use crate::real::Real;

/// The `P` outputs that a sampled controller measures, as a function of time and a state of length `N`. Closures
/// implement it.
#[diagnostic::on_unimplemented(
    message = "a state of {N} components does not have the {P} measurements of this controller",
    note = "`Sampled::new` measures the whole state, `Sampled::of_components(controller, period, [index, ..])` some \
            components, and `Sampled::of_outputs(controller, period, |t: f64, x: &SVector<f64, N>| [..])` anything"
)]
pub trait Outputs<T: Real, const N: usize, const P: usize> {
    /// Computes the outputs.
    fn outputs(&self, t: T, x: &SVector<T, N>) -> SVector<T, P>;

    /// Checks that the outputs exist.
    ///
    /// # Errors
    /// [`Reason::InvalidInput`].
    #[doc(hidden)]
    fn check(&self) -> Result<(), Reason> {
        Ok(())
    }
}

/// All components of the state, as outputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WholeState;

impl<T: Real, const N: usize> Outputs<T, N, N> for WholeState {
    #[inline]
    fn outputs(&self, _t: T, x: &SVector<T, N>) -> SVector<T, N> {
        *x
    }
}

/// Components of the state with these indices, as outputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Components<const P: usize>(pub [usize; P]);

impl<T: Real, const N: usize, const P: usize> Outputs<T, N, P> for Components<P> {
    #[inline]
    fn outputs(&self, _t: T, x: &SVector<T, N>) -> SVector<T, P> {
        self.0.map(|index| x[index]).into()
    }

    fn check(&self) -> Result<(), Reason> {
        let rule = "the state has no component with this index: use the constants of the model, such as `Arm::ANGLE`";
        let wrong = self.0.iter().find(|&&index| index >= N);
        wrong.map_or(Ok(()), |&index| require(false, "components", index as f64, rule))
    }
}

impl<T, F, const N: usize, const P: usize> Outputs<T, N, P> for F
where
    T: Real,
    F: Fn(T, &SVector<T, N>) -> [T; P],
{
    #[inline]
    fn outputs(&self, t: T, x: &SVector<T, N>) -> SVector<T, P> {
        self(t, x).into()
    }
}
