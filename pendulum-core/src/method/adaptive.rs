//! Steps whose length is controlled by a tolerance.

use crate::error::Reason;
use crate::method::input::{check_start, require};
use crate::method::scheme::{OneStep, Scheme};
use crate::method::smooth::Steps;
use crate::method::step_control::StepControl;
use crate::method::{Method, Stepper};
use crate::real::Float;
use crate::settings::settings;
use crate::step_size::{Estimates, Tolerance};
use crate::system::{IntoState, System};

/// A method that adapts the length of its steps to a tolerance, such as [`Rk45`](crate::Rk45). `F` is the kind of step.
///
/// A step is accepted if its estimated error `e` satisfies `mean((e / (atol + rtol |x|))^2) <= 1`. The next step is
/// chosen by a PI controller with the constants of Hairer's DOPRI5, or by the method itself. The tolerances bound the
/// error of a single step; the error of a trajectory is larger and grows with time, exponentially if the motion is
/// chaotic.
///
/// Discontinuous right-hand sides are allowed: steps become short at a jump, and grow at most threefold afterwards
/// (twofold with [`Taylor`](crate::Taylor)), so that the next jump is detected if the intervals between jumps are
/// similar. Square waves of 1 Hz to 1 kHz are integrated with errors below 1e-4 at the default tolerance. But a method
/// samples the right-hand side only where it evaluates it. A feature that begins and ends between these times, such as
/// a short pulse after a long rest, escapes every error estimate: set [`h_max`](Self::h_max) no longer than the
/// shortest pulse, or end the integration where the pulse begins and continue from there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adaptive<F> {
    rtol: Option<f64>,
    atol: Option<f64>,
    h0: Option<f64>,
    h_min: f64,
    h_max: f64,
    max_steps: usize,
    controls_derivatives: bool,
    pub(crate) family: F,
}

/// Smallest relative tolerance, in ulps.
const LEAST_ULPS: f64 = 10.0;

impl<F> Adaptive<F> {
    /// Creates the method with default settings.
    ///
    /// Methods without an error estimate do not compile:
    ///
    /// ```compile_fail,E0277
    /// use pendulum_core::method::{Adaptive, Gauss};
    ///
    /// let method = Adaptive::<Gauss<2>>::new();
    /// ```
    #[must_use]
    pub fn new() -> Self
    where
        F: Estimates + Default,
    {
        Self {
            rtol: None,
            atol: None,
            h0: None,
            h_min: 0.0,
            h_max: f64::INFINITY,
            max_steps: 1_000_000,
            controls_derivatives: false,
            family: F::default(),
        }
    }

    /// Transfers the settings to another kind of method.
    #[cfg(feature = "std")]
    pub(crate) fn by<G>(&self, family: G) -> Adaptive<G> {
        let Self {
            rtol,
            atol,
            h0,
            h_min,
            h_max,
            max_steps,
            controls_derivatives,
            ..
        } = *self;
        Adaptive {
            rtol,
            atol,
            h0,
            h_min,
            h_max,
            max_steps,
            controls_derivatives,
            family,
        }
    }

    settings! {
        /// Sets the relative tolerance, at least 10 ulps of the number type and below 1. Default: 1e-6, in `f32` 1.2e-5
        /// (100 ulps).
        rtol: f64 => Some(rtol);

        /// Sets the absolute tolerance, positive, in the units of the state. Default: 1e-9, in `f32` 1.2e-7 (1 ulp).
        ///
        /// The default suits motions of magnitude 1. If a component always stays below 1000 times `atol`, set `atol` to
        /// `rtol` times the size of the motion. A [`Solution`](crate::Solution) lists such components as
        /// [`below_tolerance`](crate::Solution::below_tolerance); a [`Stepper`] cannot.
        atol: f64 => Some(atol);

        /// Sets the first step to try; [`Taylor`](crate::Taylor) takes a shorter one if its series requires it.
        /// Default: chosen from the first and second derivatives at the start.
        h0: f64 => Some(h0);

        /// Sets the minimum step: if the tolerance requires a shorter one, the integration stops with
        /// [`Reason::StepUnderflow`]. Default: 0. The effective minimum is at least 4 ulps of the time; only the last
        /// step may be shorter.
        h_min: f64;

        /// Sets the maximum step. Default: infinite. The last step may be 1 % longer.
        h_max: f64;

        /// Sets the number of steps, accepted or rejected, after which the integration stops with
        /// [`Reason::TooManySteps`]. Default: a million.
        max_steps: usize;
    }

    /// Sets whether the tolerances bound the errors of [derivatives](crate::sensitivity) computed forward as well.
    /// Default: false, which gives the steps of an integration without derivatives.
    ///
    /// The derivatives of the state with respect to each variable are a column `s`, whose error is bounded by
    /// `atol + rtol |s|` as a whole: a component that is small beside others is accurate relative to these.
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    /// use pendulum_core::sensitivity::{self, Variable};
    ///
    /// mechanism! {
    ///     pub Swing {
    ///         gravity: [0, -1, 0],
    ///         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle }
    ///     }
    /// }
    ///
    /// // at rest, steps of any length are right for the state, but not for its derivatives
    /// let swing = Swing::new(SwingParams {})?;
    /// let at = |method: Vern9| sensitivity::end(&method, &swing, 0.0, 20.0, [0.0, 0.0], [Variable::Start(0)]);
    /// let (_, derivatives) = at(Vern9::new().control_derivatives(true))?;
    /// assert!((derivatives[(0, 0)] - 20_f64.cos()).abs() < 1e-5);
    /// let (_, derivatives) = at(Vern9::new())?;
    /// assert!((derivatives[(0, 0)] - 20_f64.cos()).abs() > 0.1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub const fn control_derivatives(mut self, controls: bool) -> Self {
        self.controls_derivatives = controls;
        self
    }

    /// Multiplies the tolerances for numbers of the type `T`, but not below the least possible, and admits ten times as
    /// many steps.
    #[cfg(feature = "std")]
    pub(crate) fn tightened<T: Float>(self, factor: f64) -> Self {
        let least = LEAST_ULPS * T::EPSILON.to_f64();
        let (rtol, atol) = self.tolerances::<T>();
        Self {
            // what is not valid remains so
            rtol: Some((factor * rtol).max(least.min(rtol))),
            atol: Some(factor * atol),
            max_steps: self.max_steps.saturating_mul(10),
            ..self
        }
    }

    /// Relative and absolute tolerance, with the defaults of the number type.
    fn tolerances<T: Float>(&self) -> (f64, f64) {
        let ulp = T::EPSILON.to_f64();
        (
            self.rtol.unwrap_or((1e-6_f64).max(100.0 * ulp)),
            self.atol.unwrap_or((1e-9_f64).max(ulp)),
        )
    }

    /// Step-size settings of an integration from `t0` to `t1`, with an error estimate of this order, for engines other
    /// than [`Stepper`].
    ///
    /// # Errors
    /// [`Reason::InvalidInput`] if a setting is out of range.
    pub fn step_control<T: Float>(&self, error_order: usize, (t0, t1): (T, T)) -> Result<StepControl<T>, Reason> {
        self.control(self.tolerance()?, error_order, (t0, t1))
    }

    /// Step control of an integration from `t0` to `t1`.
    pub(crate) fn control<T: Float>(
        &self,
        tolerance: Tolerance<T>,
        error_order: usize,
        (t0, t1): (T, T),
    ) -> Result<StepControl<T>, Reason> {
        let control = StepControl {
            h0: self.h0.map(|h0| T::from_f64(h0.min(self.h_max))),
            h_min: T::from_f64(self.h_min),
            h_max: T::from_f64(self.h_max),
            max_steps: self.max_steps,
            error_order,
            tolerance,
            keeps_pace: false,
        };
        self.check_steps(control.least(t0.abs().max(t1.abs())).to_f64())?;
        Ok(control)
    }

    pub(crate) fn tolerance<T: Float>(&self) -> Result<Tolerance<T>, Reason> {
        let ulp = T::EPSILON.to_f64();
        let (rtol, atol) = self.tolerances::<T>();
        let rule = "a tolerance must be positive and finite";
        require(rtol.is_finite() && rtol > 0.0, "rtol", rtol, rule)?;
        require(atol.is_finite() && atol > 0.0, "atol", atol, rule)?;
        require(
            rtol >= LEAST_ULPS * ulp,
            "rtol",
            rtol,
            "it must be at least 10 ulps of the number type, below which rounding errors dominate",
        )?;
        let rule = "it must be below 1: an error as large as the state would be within the tolerance";
        require(rtol < 1.0, "rtol", rtol, rule)?;
        let (rtol, atol) = (T::from_f64(rtol), T::from_f64(atol));
        // a relative tolerance with derivatives holds for derivatives
        let rtol = if self.controls_derivatives {
            rtol.with_own_slopes()
        } else {
            rtol
        };
        Ok(Tolerance { rtol, atol })
    }

    fn check_steps(&self, least: f64) -> Result<(), Reason> {
        if let Some(h0) = self.h0 {
            let rule = "the first step must be positive and finite";
            require(h0.is_finite() && h0 > 0.0, "h0", h0, rule)?;
        }
        require(
            self.h_min.is_finite() && self.h_min >= 0.0,
            "h_min",
            self.h_min,
            "the minimum step must be finite and not negative",
        )?;
        require(
            self.h_max > 0.0 && self.h_max >= least,
            "h_max",
            self.h_max,
            "the maximum step must be positive, at least `h_min`, and at least the resolution of the times",
        )
    }
}

impl<F: Estimates + Default> Default for Adaptive<F> {
    fn default() -> Self {
        Self::new()
    }
}

impl<F, S, T, const N: usize> Method<S, T, N> for Adaptive<F>
where
    F: OneStep<S, T, N> + Estimates,
    S: System<T, N> + ?Sized,
    T: Float,
{
    type Scheme = F::Scheme;

    fn tolerance(&self) -> Option<Tolerance<T>> {
        self.tolerance().ok()
    }

    fn stepper<'s>(
        &self,
        system: &'s S,
        t0: T,
        t1: T,
        x0: impl IntoState<T, N>,
    ) -> Result<Stepper<'s, Self::Scheme, S, T, N>, Reason> {
        let x0 = x0.into_state();
        check_start(t0, t1, &x0)?;
        let tolerance = self.tolerance()?;
        let scheme = self.family.scheme(system, Some(tolerance))?;
        let control = self.control(tolerance, scheme.error_order(), (t0, t1))?;
        Stepper::new(system, scheme, (t0, t1), x0, Steps::controlled(control))
    }
}
