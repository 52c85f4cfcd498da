//! Continuation of equilibria and of periodic orbits in a parameter.

use std::f64::consts::TAU;

use nalgebra::{Complex, DVector, SVector};

use super::branch::{Bifurcation, BifurcationKind, Branch};
use super::curve::correct;
use super::equilibrium::angles;
use super::families::{EquilibriumCurve, Family, OrbitCurve, Period, Scales};
use super::trace::Tracer;
use super::{Eigenmode, Equilibrium, PeriodicOrbit, Shooting, StabilityError, equilibrium};
use crate::error::{ParameterError, Reason};
use crate::method::require;
use crate::settings::settings;
use crate::system::{IntoState, Jacobian};

/// Continuation of equilibria or periodic orbits in a parameter: a plain value with settings.
///
/// A family of systems is a function that builds the member for a value of the parameter. From a solution at one value,
/// the branch is followed in both directions, over the span of the parameter and around folds. Each new point is
/// computed by Newton's method in a plane normal to the direction of the branch (pseudo-arclength). Steps are shortened
/// if Newton's method needs many iterations or the branch bends. The unknowns are the state divided by its
/// [sizes](Self::length), the parameter divided by its span, and for orbits of free period the period divided by the
/// initial one. Step sizes are measured in these units.
///
/// Bifurcations between points are detected by a sign change of a test function and then located on the branch. The
/// test functions are:
///
/// - folds: the parameter component of the tangent;
/// - crossing branches: the determinant of the equations;
/// - period doublings: the determinant of the monodromy matrix plus the identity;
/// - Hopf and torus bifurcations: the growth rate of a pair of eigenvalues or multipliers.
///
/// The number of growing modes must change by one at the first three, and by two at the last. A pair inside the unit
/// circle is therefore no torus bifurcation, however weak its damping. A significant change that no test function
/// explains is reported as [`BifurcationKind::Unnamed`](super::BifurcationKind::Unnamed). Of two bifurcations within
/// one step, one or both may be missed. In conservative systems a mode counts as growing only beyond the uncertainty of
/// its eigenvalue.
///
/// The uncertainty of a bifurcation of orbits is twice the change caused by a tolerance smaller by a factor of 100 (but
/// at least 1e-14), plus rounding errors and the last correction of the root search.
///
/// Derivatives with respect to the state come from the generated Jacobian. Derivatives with respect to the parameter
/// are central differences. For equilibria their half-width is 6e-6 of the span, accurate to about 10 digits. For
/// orbits it is the cube root of the tolerance, accurate to about two thirds of its digits. These derivatives guide the
/// search and give the direction of the branch; the solutions themselves are not affected.
///
/// H. B. Keller, in P. H. Rabinowitz (ed.), "Applications of Bifurcation Theory" (1977) 359; Yu. A. Kuznetsov,
/// "Elements of Applied Bifurcation Theory", 4th ed. (2023), ch. 10; R. Seydel, "Practical Bifurcation and Stability
/// Analysis", 3rd ed. (2010), chapters 4 to 7.
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::stability::{BifurcationKind, Continuation};
///
/// mechanism! {
///     /// A pendulum that a constant torque holds up.
///     pub Held {
///         params { torque: N m }
///         gravity: [0, -9.81, 0],
///         body bob on ground {
///             mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, friction: 0.1, torque: torque,
///         }
///     }
/// }
///
/// let held = |torque| Held::new(HeldParams { torque });
/// let branch = Continuation::new(held, 0.0, 20.0).equilibria([0.0, 0.0], 0.0)?;
/// // It is lifted to the horizontal, and no torque beyond holds it.
/// let [fold] = branch.bifurcations() else { panic!("there is one") };
/// assert_eq!(fold.kind, BifurcationKind::Fold);
/// assert!((fold.parameter - 9.81).abs() < 1e-8);
/// assert!((fold.solution.x[0].to_degrees() - 90.0).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Continuation<F> {
    family: F,
    span: (f64, f64),
    step: f64,
    points: usize,
    tolerance: f64,
    length: f64,
}

impl<F, S> Continuation<F>
where
    F: Fn(f64) -> Result<S, ParameterError>,
{
    /// Continuation of the systems built by `family`, over the span of the parameter from `from` to the larger `to`.
    /// Newton's method may evaluate `family` somewhat outside the span; if it fails there, the step is shortened.
    #[must_use]
    pub fn new(family: F, from: f64, to: f64) -> Self {
        Self {
            family,
            span: (from, to),
            step: 0.05,
            points: 1000,
            tolerance: 1e-10,
            length: 1.0,
        }
    }

    settings! {
        /// Sets the characteristic length of the scene, in m. Default: 1.
        ///
        /// Steps measure lengths in this unit and angles in radians. The time unit of rates is 1 s for equilibria, and
        /// `period / 2 pi` of the first orbit for orbits. Without a layout all components have the size 1.
        length: f64;

        /// Sets the largest step size. If the state changes little, a step of 0.05 covers the span in 20 steps.
        /// Default: 0.05.
        step: f64;

        /// Sets the maximum number of points on each side of the start. Default: 1000.
        points: usize;

        /// Sets the tolerance of the integration for periodic orbits. Default: 1e-10.
        tolerance: f64;
    }

    /// Computes the branch through the equilibrium near `x0` at the parameter `p0`.
    ///
    /// # Errors
    /// [`StabilityError::Integration`] if a setting is invalid, [`StabilityError::Build`] if the family has no member
    /// at `p0`, and the errors of [`equilibrium`]. Later errors end the branch and are stored in it as
    /// [`BranchEnd::Failed`](super::BranchEnd::Failed).
    pub fn equilibria<const N: usize>(
        &self,
        x0: impl IntoState<f64, N>,
        p0: f64,
    ) -> Result<Branch<Equilibrium<N>>, StabilityError>
    where
        S: Jacobian<f64, N>,
    {
        self.check(p0)?;
        let system = (self.family)(p0)?;
        let x = equilibrium(&system, x0)?.x;
        let curve = EquilibriumCurve {
            family: self.family(),
            angles: angles(&system),
            sizes: Scales::of(&system, self.length, 1.0),
        };
        let unknowns = self.unknowns(&curve.sizes.scaled(&x), None, p0);
        self.tracer(&curve).branch(unknowns)
    }

    /// Computes the branch through the periodic orbit near the state `x0` with a period near `period`, at the parameter
    /// `p0`. The systems must be autonomous; the period varies along the branch.
    ///
    /// Orbits must be isolated at each parameter, unlike those of conservative systems. A branch of orbits that shrink
    /// to an equilibrium, at a Hopf bifurcation, ends with [`StabilityError::AtRest`].
    ///
    /// # Errors
    /// Errors of [`equilibria`](Self::equilibria) and of [`Shooting::autonomous`].
    pub fn autonomous_orbits<const N: usize>(
        &self,
        x0: impl IntoState<f64, N>,
        period: f64,
        p0: f64,
    ) -> Result<Branch<PeriodicOrbit<N>>, StabilityError>
    where
        S: Jacobian<f64, N>,
    {
        self.check(p0)?;
        let system = (self.family)(p0)?;
        let orbit = Shooting::new()
            .tolerance(self.tolerance)
            .autonomous(&system, x0, period)?;
        let curve = self.orbits(&system, Period::<&fn(f64) -> f64>::Free(orbit.period), orbit.period);
        let unknowns = self.unknowns(&curve.sizes.scaled(&orbit.x), Some(1.0), p0);
        self.tracer(&curve).branch(unknowns)
    }

    /// Computes the branch of periodic orbits that starts at a Hopf bifurcation of an autonomous system. Its end at the
    /// bifurcation is [`BranchEnd::Failed`](super::BranchEnd::Failed) with [`StabilityError::AtRest`].
    ///
    /// The first orbit is computed with a fixed amplitude of the critical mode and a free parameter. The amplitude is
    /// 0.01 of the sizes that define step lengths, and is reduced if this fails.
    ///
    /// ```
    /// use nalgebra::SMatrix;
    /// use pendulum_core::prelude::*;
    /// use pendulum_core::stability::Continuation;
    ///
    /// // Lorenz: the convection that sets in loses its stability to an unstable cycle.
    /// let lorenz = |rho: f64| {
    ///     Ok(FnSystem::with_jacobian(
    ///         move |_, x: &SVector<f64, 3>| {
    ///             SVector::from([10.0 * (x[1] - x[0]), x[0] * (rho - x[2]) - x[1], x[0] * x[1] - 8.0 / 3.0 * x[2]])
    ///         },
    ///         move |_, x: &SVector<f64, 3>| {
    ///             SMatrix::from([[-10.0, rho - x[2], x[1]], [10.0, -1.0, x[0]], [0.0, -x[0], -8.0 / 3.0]])
    ///         },
    ///     ))
    /// };
    /// let continuation = Continuation::new(lorenz, 20.0, 28.0);
    /// let convection = continuation.equilibria([7.8, 7.8, 23.0], 24.0)?;
    /// let cycles = continuation.cycles(&convection.bifurcations()[0])?;
    /// assert!((convection.bifurcations()[0].parameter - 470.0 / 19.0).abs() < 1e-9);
    /// assert!(cycles.points().iter().all(|cycle| cycle.parameter < 24.74));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`StabilityError::Integration`] if the bifurcation is of another kind or outside of the span, or if a setting is
    /// invalid; [`StabilityError::Build`] if the family has no member there; the error of the last attempt if no orbit
    /// is found.
    pub fn cycles<const N: usize>(
        &self,
        hopf: &Bifurcation<Equilibrium<N>>,
    ) -> Result<Branch<PeriodicOrbit<N>>, StabilityError>
    where
        S: Jacobian<f64, N>,
    {
        self.check(hopf.parameter)?;
        let BifurcationKind::Hopf { angular_frequency } = hopf.kind else {
            let rule = "cycles begin at a Hopf bifurcation: pass one of `bifurcations()` whose kind is `Hopf`";
            let (what, value) = ("hopf", hopf.parameter);
            return Err(Reason::InvalidInput { what, value, rule }.into());
        };
        let system = (self.family)(hopf.parameter)?;
        let period = TAU / angular_frequency;
        let curve = self.orbits(&system, Period::<&fn(f64) -> f64>::Free(period), period);
        let off = |mode: &&Eigenmode<N>| (mode.eigenvalue - Complex::I * angular_frequency).norm();
        let modes = hopf.solution.spectrum.modes().iter();
        let Some(mode) = modes.min_by(|a, b| off(a).total_cmp(&off(b))) else {
            return Err(StabilityError::AtRest);
        };
        let shape = curve
            .sizes
            .scaled(&mode.shape.map(|component| component.re))
            .normalize();
        let rest = self.unknowns(&curve.sizes.scaled(&hopf.solution.x), Some(1.0), hopf.parameter);
        let mut growing = DVector::zeros(rest.len());
        growing.rows_mut(0, N).copy_from(&shape);
        let mut amplitude = 0.01;
        loop {
            let guess = &rest + &growing * amplitude;
            let target = growing.dot(&guess);
            match correct(&curve, guess, (&growing, target), &growing) {
                Ok(place) if (&place.u - &rest).norm() < 3.0 * amplitude => return self.tracer(&curve).branch(place.u),
                Err(error) if amplitude < 1e-4 => return Err(error),
                Ok(_) if amplitude < 1e-4 => return Err(StabilityError::AtRest),
                _ => amplitude *= 0.5,
            }
        }
    }

    /// Computes the branch through the periodic motion near the state `x0` at the time 0 and at the parameter `p0`, for
    /// driven systems. `period` returns the period of the motion in s for each value of the parameter: the period of
    /// the drive or a multiple of it.
    ///
    /// # Errors
    /// Errors of [`equilibria`](Self::equilibria) and of [`Shooting::forced`].
    pub fn forced_orbits<const N: usize>(
        &self,
        x0: impl IntoState<f64, N>,
        period: impl Fn(f64) -> f64,
        p0: f64,
    ) -> Result<Branch<PeriodicOrbit<N>>, StabilityError>
    where
        S: Jacobian<f64, N>,
    {
        self.check(p0)?;
        let system = (self.family)(p0)?;
        let orbit = Shooting::new()
            .tolerance(self.tolerance)
            .forced(&system, x0, period(p0))?;
        let curve = self.orbits(&system, Period::Given(&period), orbit.period);
        let unknowns = self.unknowns(&curve.sizes.scaled(&orbit.x), None, p0);
        self.tracer(&curve).branch(unknowns)
    }

    fn family(&self) -> Family<'_, F> {
        Family {
            member: &self.family,
            span: self.span,
        }
    }

    /// Curve of orbits, scaled by the period `first` of the first one.
    fn orbits<'c, P, const N: usize>(&'c self, system: &S, period: Period<&'c P>, first: f64) -> OrbitCurve<'c, F, P, N>
    where
        S: Jacobian<f64, N>,
    {
        OrbitCurve {
            family: self.family(),
            period,
            tolerance: self.tolerance,
            angles: angles(system),
            sizes: Scales::of(system, self.length, first / TAU),
        }
    }

    fn tracer<'c, C, const N: usize>(&self, curve: &'c C) -> Tracer<'c, C, N> {
        let unit = self.span.1 - self.span.0;
        Tracer {
            curve,
            span: (self.span.0 / unit, self.span.1 / unit),
            step: self.step,
            points: self.points,
            unit,
        }
    }

    /// Point of a curve: the state, the period if it is free, and the parameter.
    fn unknowns<const N: usize>(&self, x: &SVector<f64, N>, period: Option<f64>, parameter: f64) -> DVector<f64> {
        let parameter = parameter / (self.span.1 - self.span.0);
        let unknowns = x.iter().copied().chain(period).chain([parameter]);
        DVector::from_vec(unknowns.collect())
    }

    fn check(&self, p0: f64) -> Result<(), Reason> {
        let (low, high) = self.span;
        let rule = "a span must be finite and ascending";
        require(
            low.is_finite() && high.is_finite() && low < high,
            "span",
            high - low,
            rule,
        )?;
        let rule = "the start must lie in the span";
        require((low..=high).contains(&p0), "p0", p0, rule)?;
        for (what, value, rule) in [
            ("step", self.step, "the longest step must be finite and positive"),
            ("tolerance", self.tolerance, "the tolerance must be finite and positive"),
            ("length", self.length, "the size of lengths must be finite and positive"),
        ] {
            require(value.is_finite() && value > 0.0, what, value, rule)?;
        }
        Ok(())
    }
}
