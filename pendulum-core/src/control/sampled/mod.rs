//! Sampled controllers: they measure at the times of a clock, and hold their commands between these.

mod controller;
mod held;
#[cfg(feature = "std")]
mod lanes;
mod legs;
mod noise;
mod outputs;
mod pid;
#[cfg(feature = "std")]
mod record;
mod run;
mod trajectory;

pub use controller::Controller;
pub use held::{Commanded, Held};
#[cfg(feature = "std")]
pub use lanes::SampledMethod;
pub use outputs::{Components, Outputs, WholeState};
pub use pid::{Pid, PidState};
#[cfg(feature = "std")]
pub use record::SampledSolution;
pub use run::Sample;

use crate::error::Reason;
use crate::method::require;
use crate::real::Float;
use crate::settings::settings;

/// Maximum delay of a command, in periods.
pub const MAX_DELAY: usize = 32;
/// Minimum period, in ulps of the time.
const LEAST_ULPS: f64 = 16.0;

/// A [`Controller`] that runs at the times `t0 + k period`, and the devices around it: sensors with noise and a
/// resolution, a delay, actuators with limits, a resolution and noise.
///
/// At each sample it measures the outputs of the model, and computes a command. The inputs of the model take its value
/// after the delay, and hold it. Between two changes of the inputs the motion is smooth: it is integrated at the full
/// order of the method, with steps that end at each change and at each sample. Methods keep the length of their steps
/// from sample to sample, and `max_steps` limits the number of steps between two samples.
///
/// ```
/// use pendulum_core::control::{Pid, Sampled};
/// use pendulum_core::prelude::*;
///
/// mechanism! {
///     pub Arm {
///         input motor: N m,
///         gravity: [0, -9.81, 0],
///         body rod on ground {
///             solids: [rod(1, [0, 0, 0], [0, -1, 0])], joint: revolute(z), coordinate: angle, torque: motor,
///         }
///     }
/// }
///
/// let arm = Arm::new(ArmParams {})?;
/// // an encoder of 4096 lines, a motor of 8 N m, and 2 ms for the computation, at 500 Hz
/// let pid = Pid::new(40.0, 60.0, 6.0).set_point(1.0);
/// let sampled = Sampled::of_components(pid, 2e-3, [Arm::ANGLE])
///     .resolution([std::f64::consts::TAU / 4096.0])
///     .delay(2e-3)
///     .limits([-8.0], [8.0]);
/// let motion = sampled.solve(&Vern7::new(), &arm, 0.0, 5.0, [0.0, 0.0])?;
/// assert!((motion.trajectory.end()[0] - 1.0).abs() < 2e-3);
/// assert_eq!(motion.samples.len(), 2500);
/// assert_eq!(motion.samples[0].sent, [8.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Numbers are reproducible: noise is a function of the [seed](Self::seed), the [member](Self::member) of an ensemble,
/// the number of the sample and the channel.
///
/// Dry friction, stops and walls are integrated as in other motions. Quantities with derivatives carry them on from
/// sample to sample; a resolution passes none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampled<C, W, const P: usize, const M: usize> {
    controller: C,
    outputs: W,
    period: f64,
    delay: f64,
    start: [f64; M],
    low: [f64; M],
    high: [f64; M],
    resolution: [f64; P],
    input_resolution: [f64; M],
    noise: [f64; P],
    input_noise: [f64; M],
    seed: u64,
    member: u64,
}

impl<C, const N: usize, const M: usize> Sampled<C, WholeState, N, M> {
    /// Creates a controller of a model with `N` state components and `M` inputs that measures the whole state, with the
    /// period `period` in s. By default there is no delay, no limit, no rounding and no noise.
    #[must_use]
    pub const fn new(controller: C, period: f64) -> Self {
        Self::with(controller, period, WholeState)
    }
}

impl<C, const P: usize, const M: usize> Sampled<C, Components<P>, P, M> {
    /// Like [`new`](Sampled::new), but measures the components of the state with these indices.
    #[must_use]
    pub const fn of_components(controller: C, period: f64, components: [usize; P]) -> Self {
        Self::with(controller, period, Components(components))
    }
}

impl<C, W, const P: usize, const M: usize> Sampled<C, W, P, M> {
    /// Like [`new`](Sampled::new), but measures `outputs(t, x)`, such as points of the model, or the distance from a
    /// moving set point.
    #[must_use]
    pub const fn of_outputs<T, const N: usize>(controller: C, period: f64, outputs: W) -> Self
    where
        T: Float,
        W: Fn(T, &nalgebra::SVector<T, N>) -> [T; P],
    {
        Self::with(controller, period, outputs)
    }

    const fn with(controller: C, period: f64, outputs: W) -> Self {
        Self {
            controller,
            outputs,
            period,
            delay: 0.0,
            start: [0.0; M],
            low: [f64::NEG_INFINITY; M],
            high: [f64::INFINITY; M],
            resolution: [0.0; P],
            input_resolution: [0.0; M],
            noise: [0.0; P],
            input_noise: [0.0; M],
            seed: 0,
            member: 0,
        }
    }

    settings! {
        /// Sets the time in s from a sample to the change of the inputs that it commands: at most [`MAX_DELAY`]
        /// periods, whole or not. Default: 0.
        delay: f64;

        /// Sets the inputs until the first command acts. Default: 0.
        start: [f64; M];

        /// Rounds each measurement to a multiple of its resolution (quantisation). 0, the default, does not round.
        resolution: [f64; P];

        /// Rounds each command to a multiple of its resolution, before the limits. 0, the default, does not round.
        input_resolution: [f64; M];

        /// Adds normally distributed noise with these standard deviations to the measurements, independent from sample
        /// to sample. Default: 0.
        noise: [f64; P];

        /// Adds normally distributed noise with these standard deviations to the inputs, beyond their limits as well.
        /// It is held from sample to sample, a disturbance that the controller does not know. Default: 0.
        input_noise: [f64; M];

        /// Sets the seed of the noise. Default: 0.
        seed: u64;

        /// Sets the member of an ensemble whose noise a trajectory has. In an ensemble it is that of the first one, and
        /// counts up from there. Default: 0.
        member: u64;
    }

    /// Limits each input to the range from `low` to `high` (saturation). Default: no limits.
    #[must_use]
    pub const fn limits(mut self, low: [f64; M], high: [f64; M]) -> Self {
        (self.low, self.high) = (low, high);
        self
    }

    /// The sampling period in s.
    #[must_use]
    pub const fn period(&self) -> f64 {
        self.period
    }

    /// Checks the settings for a span of time.
    fn check<T: Float>(&self, (t0, t1): (T, T)) -> Result<(), Reason> {
        let Self { period, delay, .. } = *self;
        let rule = "the sampling period must be positive and finite: pass seconds, such as 0.001";
        require(period.is_finite() && period > 0.0, "period", period, rule)?;
        let rule = "a sampled controller runs forward in time: pass an end after the start";
        require(t0 <= t1, "t1", t1.to_f64(), rule)?;
        let resolved = LEAST_ULPS * T::EPSILON.to_f64() * t0.abs().max(t1.abs()).to_f64();
        let rule = "the sampling period is below the resolution of the time: lengthen it, or count time from a closer \
                    origin";
        require(period >= resolved, "period", period, rule)?;
        let rule = "a delay must be finite and not negative: pass seconds, or 0 for none";
        require(delay.is_finite() && delay >= 0.0, "delay", delay, rule)?;
        let rule = "commands can be delayed by at most 32 periods: lengthen the period, or keep older commands in the \
                    state of the controller";
        let (whole, rest) = legs::lag(delay, period);
        let waiting = whole.saturating_add(usize::from(rest > 0.0));
        require(waiting <= MAX_DELAY, "delay", delay, rule)?;
        for input in 0..M {
            let (low, start, high) = (self.low[input], self.start[input], self.high[input]);
            let rule = "the lower limit of an input must not exceed the upper one: pass them as `limits(low, high)`";
            require(low <= high, "limits", low, rule)?;
            let rule = "the inputs before the first command must be finite";
            require(T::from_f64(start).is_finite(), "start", start, rule)?;
            if !(low <= start && start <= high) {
                let limits = [low, high];
                return Err(Reason::StartBeyondLimits { input, start, limits });
            }
        }
        let rule = "a standard deviation must be finite and not negative: pass 0 for no noise";
        check_each("noise", &self.noise, rule)?;
        check_each("input_noise", &self.input_noise, rule)?;
        let rule = "a resolution must be finite and not negative: pass 0 for none";
        check_each("resolution", &self.resolution, rule)?;
        check_each("input_resolution", &self.input_resolution, rule)
    }
}

fn check_each(what: &'static str, values: &[f64], rule: &'static str) -> Result<(), Reason> {
    let wrong = values.iter().find(|value| !(value.is_finite() && **value >= 0.0));
    wrong.map_or(Ok(()), |&value| require(false, what, value, rule))
}
