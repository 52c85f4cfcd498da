//! Traits of models, implemented by generated code or by hand.
//!
//! `x` is the state, `[q; qd]` for a mechanism: the coordinates, then their rates, in the order of declaration and in
//! SI units (m, rad, s). `N` is the length of the state: twice the number of degrees of freedom, plus one for each
//! orientation, whose position is a unit quaternion and whose rate is the angular velocity along the axes of the body.

mod absent;
mod adjoint;
mod assembly;
mod differences;
mod equations;
mod function;
mod parametric;
mod plant;
mod state;

#[doc(hidden)]
pub use absent::Absent;
pub use adjoint::{Adjoint, ControlledAdjoint};
#[doc(hidden)]
pub use assembly::assemble;
pub(crate) use assembly::{close, open};
pub use differences::Differences;
pub(crate) use differences::{by_number, by_state, by_time};
pub use equations::{Equations, EquationsSystem};
pub use function::{FnSystem, WithJacobian, WithTimeDerivative};
pub use parametric::{Parametric, ParametricControlled};
pub use plant::{Acting, ActsWith, Hybrid, HybridJacobian, Plant, PlantCanonical, PlantJacobian, by_sign};
pub use state::IntoState;

use nalgebra::{SMatrix, SVector};

use crate::constraint::MAX_CONSTRAINTS;
use crate::forward::{forward, forward_system};
use crate::layout::StateLayout;
use crate::real::Real;
use crate::real::lanes::Lanes;

/// A system of first-order ordinary differential equations, `dx/dt = rhs(t, x)`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a system of first-order equations",
    note = "a model with inputs becomes a `System` with a law for them: `model.with_inputs(|t, x| ..)` \
            or `model.with_law(law)`",
    note = "a function of time and state becomes one as `FnSystem(|t, x| ..)`; `mechanism!` implements \
            `System` where `generate` has `rhs`"
)]
pub trait System<T: Real, const N: usize> {
    /// Time derivative of the state; `[qd; qdd]` for a mechanism.
    fn rhs(&self, t: T, x: &SVector<T, N>) -> SVector<T, N>;

    /// Writes the [time derivative](Self::rhs) of the state to `rates`. Systems that compute it in memory save a copy.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rhs_into(&self, t: T, x: &SVector<T, N>, rates: &mut SVector<T, N>) {
        *rates = self.rhs(t, x);
    }

    /// Like [`rhs_into`](Self::rhs_into), with memory that is empty at first, and that the caller keeps for this system
    /// alone.
    #[cfg(feature = "std")]
    #[doc(hidden)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rhs_with(&self, _memory: &mut Vec<T>, t: T, x: &SVector<T, N>, rates: &mut SVector<T, N>) {
        self.rhs_into(t, x, rates);
    }

    /// True if the right-hand side is [long](Real::apart): methods then leave the call to it.
    #[doc(hidden)]
    #[inline(always)]
    fn is_apart(&self) -> bool {
        false
    }

    /// Number of components that the system has, `N` by default. The others, at the end of the state, are padding: they
    /// and their derivatives are zero, error norms leave them out, and matrices end before them. Models with inputs,
    /// periodic orbits and continuation do without padding.
    #[inline(always)]
    fn active(&self) -> usize {
        N
    }

    /// Kinds of the components of the state, and dependence on time; `None` if unknown, which is the default.
    #[inline]
    fn layout(&self) -> Option<StateLayout<'_>> {
        None
    }

    /// `Some(true)` if the right-hand side depends on the state only, `None` if unknown. By default taken from the
    /// [layout](Self::layout).
    #[inline]
    fn is_autonomous(&self) -> Option<bool> {
        Some(self.layout()?.autonomous)
    }

    /// Projects a state onto the constraints that the exact solution preserves, but rounding and truncation do not:
    /// unit quaternions, closed loops. By default there are none, at no cost.
    ///
    /// Methods call it at the start and after each step, so that constraint errors do not accumulate. States of the
    /// dense output within a step satisfy the constraints to the accuracy of the dense output.
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    ///
    /// /// A point on the unit circle, which turns.
    /// struct Turning;
    ///
    /// impl System<f64, 2> for Turning {
    ///     fn rhs(&self, _t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
    ///         SVector::from([-x[1], x[0]])
    ///     }
    ///
    ///     fn project(&self, _t: f64, x: &mut SVector<f64, 2>) {
    ///         *x /= x.norm();
    ///     }
    /// }
    ///
    /// let end = Rk4::new(0.1).stepper(&Turning, 0.0, 1000.0, [1.0, 0.0])?.run()?;
    /// assert!((end.norm() - 1.0).abs() < 1e-15);
    /// assert!(Rk4::new(0.1).stepper(&Turning, 0.0, 1000.0, [1.1, 0.0]).is_err());
    /// # Ok::<(), pendulum_core::Reason>(())
    /// ```
    #[inline(always)]
    fn project(&self, _t: T, _x: &mut SVector<T, N>) {}

    /// Reports for each closed loop the margin from its toggle and the rate of this margin, with the names of the two
    /// bodies that close the loop. By default there are none.
    ///
    /// Steps end before a margin reaches zero, with [`Reason::Toggle`](crate::Reason::Toggle). An angle that is
    /// determined only within half a turn, but has its turns counted by a force, has a margin as well, with its name
    /// and an empty second name: [`Reason::HalfTurn`](crate::Reason::HalfTurn).
    #[inline(always)]
    fn margins(&self, _t: T, _x: &SVector<T, N>, _tell: &mut dyn FnMut([&str; 2], [T; 2])) {}

    /// Reports the gap of each closed loop that [`project`](Self::project) closes, with the names of the two bodies
    /// that close it. The gap consists of the distance between the ends in m, the angle between their orientations or
    /// axes in rad, and the size of the loop in m, which is the sum of the lengths around it. By default there are
    /// none.
    ///
    /// An initial state is rejected, with [`Reason::Open`](crate::Reason::Open), if the distance exceeds 4096 rounding
    /// units of the size, or the angle exceeds as many of 1 rad: 9e-13 in `f64`, 5e-4 in `f32`. The limit grows by 4
    /// rounding units for each radian of the largest angle of the state, since the angle itself is rounded. Steps do
    /// not call this method.
    #[inline]
    fn gaps(&self, _t: T, _x: &SVector<T, N>, _tell: &mut dyn FnMut([&str; 2], [T; 3])) {}

    /// Reports each component of each output with its name. By default there are none.
    ///
    /// [`mechanism!`](crate::mechanism) reports those of `Name::OUTPUTS`.
    #[inline]
    fn each_output(&self, _t: T, _x: &SVector<T, N>, _tell: &mut dyn FnMut(&str, T)) {}

    /// Interface for the mode switches of a [hybrid](crate::hybrid) system. The default, `None`, means that the
    /// equations have a single mode.
    #[inline(always)]
    fn hybrid(&self) -> Option<&dyn Hybrid<T, N>> {
        None
    }
}

/// A model that can be converted to any number type, including vectors of lanes; `N` is the length of its state.
///
/// [`mechanism!`](crate::mechanism) implements it for models without inputs, in double precision. A model with inputs
/// implements it together with a generic law: see [`InputLaw`](crate::InputLaw).
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be converted to other number types",
    note = "`mechanism!` implements `Cast` for scenes without inputs where `generate` has `rhs`; a model with inputs \
            has it as `model.with_law(law)`, with a law that is generic over `Real`",
    note = "a system of your own has it as `EquationsSystem(equations)`, with `Equations`, which are generic over \
            `Real`; a method without `.fused()` does not need it"
)]
pub trait Cast<const N: usize> {
    /// True if the model may be [hybrid](crate::hybrid).
    const HYBRID: bool = false;

    /// True if an operation takes hardly longer in more lanes, so that there should be as many as possible.
    #[doc(hidden)]
    const WIDE: bool = false;

    /// The model in another number type.
    type In<T: Real>: System<T, N>;

    /// Converts the model to another number type. Its constants are rounded.
    fn cast<T: Real>(&self) -> Self::In<T>;

    /// Combines one model per lane, so that parameters may differ: lane `i` takes its constants from `models(i)`, and
    /// samples that inputs of tapes follow.
    ///
    /// Everything else, such as the parameters by name, comes from model 0.
    fn gather<'m, V: Lanes>(models: impl Fn(usize) -> &'m Self) -> Self::In<V>
    where
        Self: 'm;

    /// True if the two models differ at most in what [`gather`](Self::gather) takes from each, so that they can share
    /// lanes. The default is true.
    fn shares_lanes(&self, _other: &Self) -> bool {
        true
    }
}

/// A [`System`] with the derivative of its right-hand side.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no Jacobian",
    note = "`mechanism!` generates it unless `generate` leaves it out; a system of your own gets it by \
            `FnSystem::with_jacobian(f, j)`, by dual numbers as `EquationsSystem(equations)`, or by differences as \
            `Differences(system)`",
    note = "explicit methods such as `Vern9` do not require it"
)]
pub trait Jacobian<T: Real, const N: usize>: System<T, N> {
    /// Computes the Jacobian. Entry `(i, j)` is the derivative of component `i` of the right-hand side with respect to
    /// component `j` of the state.
    fn jacobian(&self, t: T, x: &SVector<T, N>) -> SMatrix<T, N, N>;

    /// Computes the right-hand side and the Jacobian. Generated models share common subexpressions between them; the
    /// right-hand side equals [`System::rhs`] up to rounding.
    #[inline]
    fn rhs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>) {
        (self.rhs(t, x), self.jacobian(t, x))
    }

    /// Partial derivative of the right-hand side with respect to time, required by Rosenbrock methods.
    ///
    /// Generated models compute it exactly. The default is a central difference with half-width
    /// `cbrt(EPSILON) max(|t|, 1)`, at the cost of two evaluations of the right-hand side. It is accurate to about 10
    /// digits (4 in `f32`) if the right-hand side varies on a time scale of about 1 s. Zero, without evaluations, if
    /// the system is autonomous according to its [layout](System::layout).
    #[inline]
    fn time_derivative(&self, t: T, x: &SVector<T, N>) -> SVector<T, N>
    where
        T: Lanes,
    {
        by_time(self, t, |t| self.rhs(t, x))
    }

    /// Derivatives of a [hybrid](crate::hybrid) system. The default is `None`, for other systems and for unknown
    /// derivatives. In the latter case each mode is differentiated by central differences, and analyses across mode
    /// switches reject the system.
    #[inline(always)]
    fn hybrid_jacobian(&self) -> Option<&dyn HybridJacobian<T, N>> {
        None
    }
}

/// A model with a [`Jacobian`] in every number type, so that implicit methods run in lanes.
///
/// [`mechanism!`](crate::mechanism) implements it for models without inputs if `generate` has `jacobian`. A model with
/// inputs implements it together with a generic law, like [`Cast`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no Jacobian in other number types",
    note = "`mechanism!` implements `CastJacobian` for scenes without inputs where `generate` has `jacobian`; a model \
            with inputs has it as `model.with_law(law)`, with a law that is generic over `Real`"
)]
pub trait CastJacobian<const N: usize>: Cast<N> {
    /// The model as one with a Jacobian; identical to the one of [`Cast::In`] if that has a Jacobian.
    fn with_jacobian<T: Real>(model: &Self::In<T>) -> &impl Jacobian<T, N>;
}

/// A mechanism in canonical variables: its coordinates and their momenta, `y = [q; p]` with `p = A(q) qd`.
///
/// Both `y` and its rate are functions of the state `x = [q; qd]` without matrix inversion: `dp/dt = dL/dq + Q`, with
/// the Lagrangian `L` and the nonconservative forces `Q`. A momentum has the unit of energy times time divided by the
/// unit of its coordinate. Structure-preserving methods such as [`Gauss4`](crate::Gauss4) step in these variables, in
/// which the motion without friction is a canonical map.
///
/// [`mechanism!`](crate::mechanism) implements it for scenes without inputs if `generate` has `canonical`. Scenes with
/// orientations are excluded: an angular velocity is not the rate of any coordinates.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no canonical equations",
    note = "`mechanism!` generates them for scenes without inputs where `generate` has `canonical`",
    note = "models with inputs, also under `control::Sampled`, run with `Vern9`, or `Rodas5P` if they are stiff"
)]
pub trait Canonical<T: Real, const N: usize>: System<T, N> {
    /// Computes the variables `y = [q; p]` and their rates `dy/dt = [qd; dp/dt]`.
    fn canonical(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SVector<T, N>);

    /// Derivatives of `y` and `dy/dt` with respect to the state.
    fn canonical_jacobian(&self, t: T, x: &SVector<T, N>) -> (SMatrix<T, N, N>, SMatrix<T, N, N>);

    /// Canonical equations of a [hybrid](crate::hybrid) system as functions of its constraint forces. Required for
    /// hybrid systems; the default, `None`, is for others.
    #[inline(always)]
    fn hybrid_canonical(&self) -> Option<&dyn PlantCanonical<T, N, Given = [T; MAX_CONSTRAINTS]>> {
        None
    }
}

/// A model with an energy, in joules.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no energy",
    note = "`mechanism!` generates it unless `generate` leaves it out; implement `Energy` for systems of your own"
)]
pub trait Energy<T: Real, const N: usize> {
    /// Kinetic energy.
    fn kinetic(&self, t: T, x: &SVector<T, N>) -> T;

    /// Potential energy, up to the constant left open by the declaration.
    fn potential(&self, t: T, x: &SVector<T, N>) -> T;

    /// Total energy: kinetic plus potential. Constant in time if no drive or friction acts on the model.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn energy(&self, t: T, x: &(impl IntoState<T, N> + Copy)) -> T
    where
        Self: Sized,
    {
        let x = (*x).into_state();
        self.kinetic(t, &x) + self.potential(t, &x)
    }
}

impl<T: Real, S: System<T, N> + ?Sized, const N: usize> System<T, N> for &S {
    forward_system!(self => (**self));
}

impl<T: Real, S: Jacobian<T, N> + ?Sized, const N: usize> Jacobian<T, N> for &S {
    forward! { self => (**self);
        jacobian(t: T, x: &SVector<T, N>) -> SMatrix<T, N, N>;
        rhs_and_jacobian(t: T, x: &SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>);
        time_derivative(t: T, x: &SVector<T, N>) -> SVector<T, N> where T: Lanes;
        hybrid_jacobian() -> Option<&dyn HybridJacobian<T, N>>;
    }
}

impl<T: Real, S: Canonical<T, N> + ?Sized, const N: usize> Canonical<T, N> for &S {
    forward! { self => (**self);
        canonical(t: T, x: &SVector<T, N>) -> (SVector<T, N>, SVector<T, N>);
        canonical_jacobian(t: T, x: &SVector<T, N>) -> (SMatrix<T, N, N>, SMatrix<T, N, N>);
        hybrid_canonical() -> Option<&dyn PlantCanonical<T, N, Given = [T; MAX_CONSTRAINTS]>>;
    }
}

impl<T: Real, S: Energy<T, N> + ?Sized, const N: usize> Energy<T, N> for &S {
    forward! { self => (**self);
        kinetic(t: T, x: &SVector<T, N>) -> T;
        potential(t: T, x: &SVector<T, N>) -> T;
    }
}
