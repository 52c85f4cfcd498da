//! Power series of motions.
//!
//! Around a time `t` a motion is `x(tau) = sum_k x_k (tau - t)^k`. The coefficients follow recursively: those of order
//! `k` of all intermediate results of the right-hand side give those of order `k + 1` of the state (Jorba and Zou, "A
//! software package for the numerical integration of ODEs by means of high-order Taylor methods", Experimental
//! Mathematics 2005; Griewank and Walther, "Evaluating Derivatives" 2008, ch. 13). [`mechanism!`](crate::mechanism)
//! generates the recurrences of a scene whose `generate` contains `taylor`. Those of equations by hand,
//! [`EquationsSystem`](crate::system::EquationsSystem), follow from their operations, which are recorded.

mod dual_sums;
#[cfg(feature = "std")]
mod equations;
mod products;
#[cfg(feature = "std")]
mod recorded;
#[cfg(feature = "std")]
mod recording;
mod tangents;

use nalgebra::SVector;

pub(crate) use self::dual_sums::DualSums;
pub use self::products::{FewProducts, Newest, Products};
#[cfg(feature = "std")]
pub use self::recording::Recording;
pub use self::tangents::{DualKernel, Linearized, Matrices, series_by_tangents};
use crate::constraint::Hold;
use crate::forward::forward;
use crate::real::Real;
use crate::system::{Cast, System};

/// Maximum order of a series.
pub const MAX_ORDER: usize = 24;

/// A [`System`] with the power series of its motions.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no Taylor series of its motions",
    note = "`mechanism!` generates it for scenes without inputs where `generate` has `taylor`",
    note = "models with inputs, also under `control::Sampled`, run with `Vern9` at tight tolerances",
    note = "a system of your own has it as `EquationsSystem(equations)`, with `Equations`, which are generic over \
            number types, and the feature `std`"
)]
pub trait TaylorSeries<T: Real, const N: usize>: System<T, N> {
    /// Memory of the recurrences: some kilobytes, without heap allocation.
    type Workspace: Clone;

    /// Creates a workspace, for any number of series one after the other.
    fn workspace(&self) -> Self::Workspace;

    /// Computes `x[1..]` from `x[0]`, the state at `t`: the motion is `sum_k x[k] (tau - t)^k`, with `x[k]` in the
    /// units of the state over s^k.
    ///
    /// The order is `x.len() - 1`. If the motion has no series, as at the edge of the domain of a square root,
    /// coefficients are not finite. `abs` and `signum` count as smooth continuations of their side at `t`, and as
    /// constant where their argument is zero.
    ///
    /// # Panics
    /// If the order is above [`MAX_ORDER`].
    fn series(&self, t: T, x: &mut [SVector<T, N>], work: &mut Self::Workspace);

    /// Series of a [hybrid](crate::hybrid) system, given its mode. Required of hybrid systems; `None` by default, for
    /// others.
    #[inline(always)]
    fn hybrid_series(&self) -> Option<&dyn HybridSeries<T, N, Workspace = Self::Workspace>> {
        None
    }
}

/// A [hybrid](crate::hybrid) system with the power series of its motions in each mode.
pub trait HybridSeries<T: Real, const N: usize> {
    /// See [`TaylorSeries::Workspace`].
    type Workspace;

    /// Like [`TaylorSeries::series`], but in a mode.
    ///
    /// # Panics
    /// If the order is above [`MAX_ORDER`].
    fn eval_series(&self, hold: &Hold<T>, t: T, x: &mut [SVector<T, N>], work: &mut Self::Workspace);
}

/// A [`Cast`] with power series in every number type, including lanes.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no Taylor series of its motions in other number types",
    note = "`mechanism!` generates it for scenes without inputs where `generate` has `taylor`",
    note = "models with inputs, also under `control::Sampled`, run with `Vern9` at tight tolerances",
    note = "a system of your own has it as `EquationsSystem(equations)`, with `Equations`, which are generic over \
            number types, and the feature `std`"
)]
pub trait CastTaylor<const N: usize>: Cast<N> {
    /// The [`TaylorSeries::Workspace`] of the model in a number type.
    type Workspace<T: Real>: Clone;

    /// Returns the model with power series, which is the one of [`Cast::In`] if it has them.
    fn with_series<T: Real>(model: &Self::In<T>) -> &impl TaylorSeries<T, N, Workspace = Self::Workspace<T>>;
}

impl<T: Real, S: TaylorSeries<T, N> + ?Sized, const N: usize> TaylorSeries<T, N> for &S {
    type Workspace = S::Workspace;

    forward! { self => (**self);
        workspace() -> Self::Workspace;
        series(t: T, x: &mut [SVector<T, N>], work: &mut Self::Workspace);
        hybrid_series() -> Option<&dyn HybridSeries<T, N, Workspace = Self::Workspace>>;
    }
}
