//! Controllers with proportional, integral and derivative parts.

use nalgebra::SVector;

use super::Controller;
use crate::real::Float;
use crate::settings::settings;

/// A PID controller of one input and one measurement `y`: the command is
/// `kp (b r - y) + integral of ki (r - y) - kd dy/dt`, with the set point `r` and its weight `b`.
///
/// The derivative acts on the measurement, so that changes of the set point do not kick, and is filtered:
/// `kd s / (1 + filter s)`, discretized by backward differences. Where the command is limited, the integral follows
/// what was sent, `(sent - command) / tracking` per s: no windup, by back-calculation.
///
/// K. J. Åström, R. M. Murray, "Feedback Systems", 2nd ed. (2020), 11.5.
///
/// For a moving set point, measure the distance from it, with [`Sampled::of_outputs`](super::Sampled::of_outputs).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pid {
    kp: f64,
    ki: f64,
    kd: f64,
    set_point: f64,
    weight: f64,
    filter: f64,
    tracking: Option<f64>,
    offset: f64,
}

impl Pid {
    /// Creates a controller with the gains of its proportional, integral and derivative parts: of the error, of its
    /// integral over time, and of the rate of the measurement.
    #[must_use]
    pub const fn new(kp: f64, ki: f64, kd: f64) -> Self {
        Self {
            kp,
            ki,
            kd,
            set_point: 0.0,
            weight: 1.0,
            filter: 0.0,
            tracking: None,
            offset: 0.0,
        }
    }

    settings! {
        /// Sets the value that the measurement shall take. Default: 0.
        set_point: f64;

        /// Sets the weight of the set point in the proportional part, from 0 to 1; less overshoots less. Default: 1.
        weight: f64;

        /// Sets the time constant in s of the filter of the derivative: use it where the measurement is noisy or
        /// rounded. Default: 0, the difference of the last two measurements.
        filter: f64;

        /// Sets the time in s in which the integral follows a limited command; infinite for windup. Default: `kp / ki`,
        /// or the geometric mean of that and `kd / kp`, and at least a period.
        tracking: f64 => Some(tracking);

        /// Sets the integral at the start, such as the input that holds the set point. Default: 0.
        offset: f64;
    }

    /// Time in which the integral follows a limited command.
    fn tracking_time(&self) -> f64 {
        let Self { kp, ki, kd, .. } = *self;
        let automatic = if kd != 0.0 {
            libm::sqrt((kd / ki).abs())
        } else {
            (kp / ki).abs()
        };
        self.tracking.unwrap_or(automatic)
    }
}

/// Memory of a [`Pid`] controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct PidState<T> {
    /// Integral part of the command.
    pub integral: T,
    /// Derivative part of the command.
    pub derivative: T,
    /// Last measurement; `None` before the first sample.
    pub measured: Option<T>,
    period: T,
}

impl<T: Float> Controller<T, 1, 1> for Pid {
    type State = PidState<T>;

    fn start(&self, period: T) -> PidState<T> {
        PidState {
            integral: T::from_f64(self.offset),
            derivative: T::default(),
            measured: None,
            period,
        }
    }

    fn sample(&self, _t: T, measured: &SVector<T, 1>, state: &mut PidState<T>) -> [T; 1] {
        let [kp, kd, set_point, weight, filter] =
            [self.kp, self.kd, self.set_point, self.weight, self.filter].map(T::from_f64);
        let y = measured[0];
        let change = y - state.measured.unwrap_or(y);
        state.derivative = (filter * state.derivative - kd * change) / (filter + state.period);
        state.measured = Some(y);
        [kp * (weight * set_point - y) + state.integral + state.derivative]
    }

    fn sent(&self, [command]: &[T; 1], [sent]: &[T; 1], state: &mut PidState<T>) {
        if self.ki == 0.0 {
            return;
        }
        let measured = state.measured.unwrap_or_default();
        state.integral += T::from_f64(self.ki) * state.period * (T::from_f64(self.set_point) - measured);
        let followed = state.period / T::from_f64(self.tracking_time()).max(state.period);
        state.integral += followed * (*sent - *command);
    }
}
