//! What a model offers: traits that the generated code implements, and that hand-written models can implement as well.
//!
//! Everywhere `x` is the state, `[q; qd]` for a mechanism: the coordinates first, then their rates, in the order of
//! declaration and in SI units (m, rad, s). `N` is the length of the state, twice the number of degrees of freedom, and
//! one more for each orientation: its position is a unit quaternion, its rate the angular velocity along the axes of
//! the body.

mod absent;
mod assembly;
mod differences;
mod function;
mod plant;
mod state;

#[doc(hidden)]
pub use absent::Absent;
#[doc(hidden)]
pub use assembly::assemble;
pub(crate) use assembly::{close, open};
pub use differences::Differences;
pub(crate) use differences::{by_number, by_state, by_time};
pub use function::{FnSystem, WithJacobian, WithTimeDerivative};
pub use plant::{Acting, ActsWith, Hybrid, HybridJacobian, Plant, PlantCanonical, PlantJacobian, by_sign};
pub use state::IntoState;

use nalgebra::{SMatrix, SVector};

use crate::constraint::MAX_CONSTRAINTS;
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
    /// The time derivative of the state; `[qd; qdd]` for a mechanism.
    fn rhs(&self, t: T, x: &SVector<T, N>) -> SVector<T, N>;

    /// What each component of the state is, and whether time occurs; `None` where that is not known, as by default.
    #[inline]
    fn layout(&self) -> Option<StateLayout<'_>> {
        None
    }

    /// Whether the right-hand side depends on the state alone, as far as that is known: by default what the
    /// [layout](Self::layout) says.
    #[inline]
    fn is_autonomous(&self) -> Option<bool> {
        Some(self.layout()?.autonomous)
    }

    /// Puts a state back onto the constraints that the equations preserve, but rounding and truncation do not: a
    /// quaternion is of unit length, a loop is closed. By default there are none, which costs nothing.
    ///
    /// Methods call it at the start and after each step, so that no error across the constraints adds up. States within
    /// a step, by dense output, are as exact as that is.
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

    /// Tells how far each closed loop is from its toggle and the rate of that, with the names of the two bodies that
    /// close it; by default there are none. Steps end before a margin is zero, as
    /// [`Reason::Toggle`](crate::Reason::Toggle) tells. An angle that is known within half a turn only, but whose turns
    /// a force takes, has a margin as well, with its name and an empty one:
    /// [`Reason::HalfTurn`](crate::Reason::HalfTurn).
    #[inline(always)]
    fn margins(&self, _t: T, _x: &SVector<T, N>, _tell: &mut dyn FnMut([&str; 2], [T; 2])) {}

    /// Reports the gap of each closed loop that [`project`](Self::project) closes, with the names of the two bodies
    /// that close it: the distance between its ends in m, the angle between their orientations, or their axes, in rad,
    /// and the size of the loop, the sum of the lengths around it in m. By default there are none.
    ///
    /// A state to start from is refused, as [`Reason::Open`](crate::Reason::Open), where the distance exceeds 4096
    /// units of rounding of the size, or the angle as many of 1 rad: 9e-13 in `f64`, 5e-4 in `f32`; and 4 more for each
    /// radian of the largest angle of the state, which is rounded itself. Steps do not call it.
    #[inline]
    fn gaps(&self, _t: T, _x: &SVector<T, N>, _tell: &mut dyn FnMut([&str; 2], [T; 3])) {}

    /// What switches between the modes of a [hybrid](crate::hybrid) system; `None`, as by default, where the equations
    /// are always the same.
    #[inline(always)]
    fn hybrid(&self) -> Option<&dyn Hybrid<T, N>> {
        None
    }
}

/// A model that can be converted to any number type, vectors of lanes included; `N` is the length of its state.
///
/// [`mechanism!`](crate::mechanism) implements it for models without inputs, in double precision. A model with inputs
/// has it together with a law that is generic as well: see [`InputLaw`](crate::InputLaw).
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be converted to other number types",
    note = "`mechanism!` implements `Cast` for scenes without inputs where `generate` has `rhs`; a model with inputs \
            has it as `model.with_law(law)`, with a law that is generic over `Real`"
)]
pub trait Cast<const N: usize> {
    /// Whether the model may be [hybrid](crate::hybrid).
    const HYBRID: bool = false;

    /// The model in another number type.
    type In<T: Real>: System<T, N>;

    /// The same model in another number type; its constants are rounded.
    fn cast<T: Real>(&self) -> Self::In<T>;

    /// One model per lane, so that parameters may differ: lane `i` takes its constants from `models(i)`.
    ///
    /// Everything except the constants, such as the parameters by name, is taken from model 0.
    fn gather<'m, V: Lanes>(models: impl Fn(usize) -> &'m Self) -> Self::In<V>
    where
        Self: 'm;

    /// Whether the two models differ in their constants at most, so that they may share lanes: always, by default.
    fn shares_lanes(&self, _other: &Self) -> bool {
        true
    }
}

/// A [`System`] that knows the derivative of its right-hand side.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no Jacobian",
    note = "`mechanism!` generates it unless `generate` leaves it out; a system of your own gets it by \
            `FnSystem::with_jacobian(f, j)` or `impl Jacobian`, or by differences as `Differences(system)`",
    note = "explicit methods such as `Vern9` do not require it"
)]
pub trait Jacobian<T: Real, const N: usize>: System<T, N> {
    /// Entry `(i, j)` is the derivative of component `i` of the right-hand side with respect to component `j` of the
    /// state.
    fn jacobian(&self, t: T, x: &SVector<T, N>) -> SMatrix<T, N, N>;

    /// Both at once. Generated models compute their common parts once, and give the right-hand side of [`System::rhs`]
    /// up to rounding.
    #[inline]
    fn rhs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>) {
        (self.rhs(t, x), self.jacobian(t, x))
    }

    /// The derivative of the right-hand side with respect to the time, the state held fixed; Rosenbrock methods require
    /// it.
    ///
    /// Generated models know it exactly. By default it is a central difference over `cbrt(EPSILON) max(|t|, 1)` to
    /// either side, for two evaluations of the right-hand side: where that varies over times of about 1 s, it is right
    /// to about 10 digits, in `f32` to 4. Zero, without evaluations, where the [layout](System::layout) says that time
    /// does not occur.
    #[inline]
    fn time_derivative(&self, t: T, x: &SVector<T, N>) -> SVector<T, N>
    where
        T: Lanes,
    {
        by_time(self, t, |t| self.rhs(t, x))
    }

    /// The derivatives of a [hybrid](crate::hybrid) system; `None`, as by default, for others, and where they are not
    /// known: each mode is derived by central differences then, and analyses that pass changes of mode refuse it.
    #[inline(always)]
    fn hybrid_jacobian(&self) -> Option<&dyn HybridJacobian<T, N>> {
        None
    }
}

/// A model that has its [`Jacobian`] in every number type, so that implicit methods run in lanes.
///
/// [`mechanism!`](crate::mechanism) implements it for models without inputs where `generate` has `jacobian`. A model
/// with inputs has it together with a law that is generic as well, as it has [`Cast`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no Jacobian in other number types",
    note = "`mechanism!` implements `CastJacobian` for scenes without inputs where `generate` has `jacobian`; a model \
            with inputs has it as `model.with_law(law)`, with a law that is generic over `Real`"
)]
pub trait CastJacobian<const N: usize>: Cast<N> {
    /// The model as one with a Jacobian; that of [`Cast::In`], where it has one.
    fn with_jacobian<T: Real>(model: &Self::In<T>) -> &impl Jacobian<T, N>;
}

/// A mechanism in canonical variables: its coordinates and their momenta, `y = [q; p]` with `p = A(q) qd`.
///
/// Both `y` and its rate are functions of the state `x = [q; qd]`, so nothing is divided by: `dp/dt = dL/dq + Q`, with
/// the Lagrangian `L` and the forces `Q` that have no potential. A momentum has the unit of energy times time over that
/// of its coordinate. Structure-preserving methods such as [`Gauss4`](crate::Gauss4) step in these variables, in which
/// the motion without friction is a canonical map.
///
/// [`mechanism!`](crate::mechanism) implements it for scenes without inputs where `generate` has `canonical`. Scenes
/// with orientations cannot have it: an angular velocity is the rate of no coordinates.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no canonical equations",
    note = "`mechanism!` generates them for scenes without inputs where `generate` has `canonical`"
)]
pub trait Canonical<T: Real, const N: usize>: System<T, N> {
    /// The variables `y = [q; p]`, and their rates `dy/dt = [qd; dp/dt]`.
    fn canonical(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SVector<T, N>);

    /// The derivatives of both with respect to the state.
    fn canonical_jacobian(&self, t: T, x: &SVector<T, N>) -> (SMatrix<T, N, N>, SMatrix<T, N, N>);

    /// The same of a [hybrid](crate::hybrid) system, given the forces along its constraints: required of these; `None`,
    /// as by default, for others.
    #[inline(always)]
    fn hybrid_canonical(&self) -> Option<&dyn PlantCanonical<T, N, Given = [T; MAX_CONSTRAINTS]>> {
        None
    }
}

/// A model that knows its energy, in joules.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no energy",
    note = "`mechanism!` generates it unless `generate` leaves it out; implement `Energy` for systems of your own"
)]
pub trait Energy<T: Real, const N: usize> {
    /// Kinetic energy.
    fn kinetic(&self, t: T, x: &SVector<T, N>) -> T;

    /// Potential energy, up to the constant that its declaration leaves open.
    fn potential(&self, t: T, x: &SVector<T, N>) -> T;

    /// Kinetic and potential energy together; constant in time where nothing drives or brakes the model.
    #[inline]
    fn energy(&self, t: T, x: &(impl IntoState<T, N> + Copy)) -> T
    where
        Self: Sized,
    {
        let x = (*x).into_state();
        self.kinetic(t, &x) + self.potential(t, &x)
    }
}

/// Methods by those of what is wrapped.
macro_rules! forward {
    ($self:ident => $wrapped:expr;
     $($method:ident($($argument:ident: $kind:ty),*) $(-> $output:ty)? $(where $number:ident: $order:ident)?;)*) => {
        $(
            #[inline]
            fn $method(&$self, $($argument: $kind),*) $(-> $output)?
            $(where $number: $order)?
            {
                $wrapped.$method($($argument),*)
            }
        )*
    };
}

/// All methods of a [`System`] by those of one that is wrapped.
macro_rules! forward_system {
    ($self:ident => $wrapped:expr) => {
        $crate::system::forward! { $self => $wrapped;
            rhs(t: T, x: &SVector<T, N>) -> SVector<T, N>;
            layout() -> Option<StateLayout<'_>>;
            is_autonomous() -> Option<bool>;
            project(t: T, x: &mut SVector<T, N>);
            margins(t: T, x: &SVector<T, N>, tell: &mut dyn FnMut([&str; 2], [T; 2]));
            gaps(t: T, x: &SVector<T, N>, tell: &mut dyn FnMut([&str; 2], [T; 3]));
            hybrid() -> Option<&dyn Hybrid<T, N>>;
        }
    };
}
pub(crate) use {forward, forward_system};

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
