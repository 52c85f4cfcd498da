//! Controllers.

use nalgebra::SVector;

use crate::inputs::InputLaw;
use crate::real::Float;

/// A controller that computes a command for `M` inputs from `P` measurements, sample by sample.
///
/// Every [`InputLaw`] is a controller without a state, whose measurements are its `x`. [`Pid`](super::Pid) and
/// [`OutputFeedback`](crate::control::OutputFeedback) are others. It may branch, since it is never run in lanes.
///
/// ```
/// use pendulum_core::control::{Controller, Sampled};
/// use pendulum_core::prelude::*;
///
/// mechanism! {
///     pub Cart {
///         input push: N,
///         body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, torque: push }
///     }
/// }
///
/// /// Pushes to the right until the cart is 1 m away, and back until it is at 0.
/// struct BackAndForth;
///
/// impl Controller<f64, 1, 1> for BackAndForth {
///     /// Direction.
///     type State = f64;
///
///     fn start(&self, _period: f64) -> f64 {
///         1.0
///     }
///
///     fn sample(&self, _t: f64, measured: &SVector<f64, 1>, direction: &mut f64) -> [f64; 1] {
///         if measured[0] > 1.0 {
///             *direction = -1.0;
///         } else if measured[0] < 0.0 {
///             *direction = 1.0;
///         }
///         [*direction]
///     }
/// }
///
/// let cart = Cart::new(CartParams {})?;
/// let sampled = Sampled::of_components(BackAndForth, 0.01, [Cart::S]);
/// let motion = sampled.solve(&Tsit5::new(), &cart, 0.0, 3.0, [0.0, 0.0])?;
/// let turn = motion.samples.iter().find(|sample| sample.sent == [-1.0]).unwrap();
/// assert!((turn.t - 2.01).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a controller for {M} inputs that measures {P} numbers",
    note = "a controller implements `Controller`; every `InputLaw` is one, with the measurements as its state"
)]
pub trait Controller<T: Float, const P: usize, const M: usize> {
    /// Memory of the controller, such as an integral.
    type State: Copy;

    /// Memory before the first sample, for a sampling period in s.
    fn start(&self, period: T) -> Self::State;

    /// Computes the command for the inputs from the measurements at the time `t`.
    fn sample(&self, t: T, measured: &SVector<T, P>, state: &mut Self::State) -> [T; M];

    /// Receives the command after rounding and limits, right after [`sample`](Self::sample). Controllers with an
    /// integral use it against windup. By default, nothing happens.
    fn sent(&self, _command: &[T; M], _sent: &[T; M], _state: &mut Self::State) {}
}

impl<T: Float, L: InputLaw<P, M>, const P: usize, const M: usize> Controller<T, P, M> for L {
    type State = ();

    #[inline]
    fn start(&self, _period: T) {}

    #[inline]
    fn sample(&self, t: T, measured: &SVector<T, P>, _state: &mut ()) -> [T; M] {
        self.inputs(t, measured)
    }
}
