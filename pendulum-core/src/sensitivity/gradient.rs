//! Gradients of costs of trajectories, by the discrete adjoint.

use nalgebra::SVector;

use crate::dense::Dense;
use crate::dual::{Dual, variables};
use crate::error::Reason;
use crate::method::{AdjointStep, DiscreteAdjoint, Method};
use crate::real::{Float, Real};
use crate::solution::{Need, Observer};
use crate::system::{Adjoint, IntoState};

/// Maximum number of states that are kept.
const MOST_STATES: usize = 1 << 16;

/// A scalar function of a trajectory: a cost of its end, plus the integral of a running cost.
///
/// It is generic over the number type, so that its derivatives follow from [dual numbers](crate::dual). A running cost
/// that depends on parameters is a `state` of the scene, whose value at the end is the integral.
pub trait Cost<const N: usize> {
    /// Cost of the state `x` at the end.
    fn end<T: Real>(&self, t: T, x: &SVector<T, N>) -> T;

    /// Integrand over time of the running cost; `None`, which is the default, if there is none.
    #[inline]
    fn running<T: Real>(&self, _t: T, _x: &SVector<T, N>) -> Option<T> {
        None
    }
}

/// A cost of a trajectory, and its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gradient<T, const N: usize, const P: usize> {
    /// Value of the cost.
    pub value: T,
    /// Last state.
    pub end: SVector<T, N>,
    /// Derivatives with respect to the initial condition.
    pub by_start: SVector<T, N>,
    /// Derivatives with respect to the parameters, in the order of their declaration.
    pub by_parameters: SVector<T, P>,
}

/// Integrates a model from `t0` to `t1` and computes the derivatives of a cost with respect to the initial condition
/// and all parameters, backward in time.
///
/// The time that this takes does not grow with the number of variables; for a few of them [`end`](super::end) is
/// faster. The result is the exact derivative of the numerical solution at the steps that the method took, which are
/// those of the values: at rest, where these may be of any length, set [`h_max`](crate::method::Adaptive::h_max).
/// Errors of the derivatives and of the running cost, which is integrated by the weights of the method, are not
/// controlled.
///
/// States are kept at the starts of steps, up to 65536 of them. Of a longer integration every second one is kept, or
/// every fourth, and so on, and the steps between them are taken again. Times of steps are kept for all of them. Events
/// are not watched.
///
/// With a model, times and an initial condition in [dual numbers](crate::dual) the derivatives carry derivatives
/// themselves: products of the second derivatives with a direction.
///
/// ```
/// use pendulum_core::Real;
/// use pendulum_core::prelude::*;
/// use pendulum_core::sensitivity::{self, Cost};
///
/// mechanism! {
///     pub Swing {
///         params { l: m = 1, damping: N m s = 0.1 }
///         gravity: [0, -9.81, 0],
///         generate: [rhs, adjoint],
///         body bob on ground {
///             solids: [point(1, [0, -l, 0])], joint: revolute(z), coordinate: theta, friction: damping,
///         }
///     }
/// }
///
/// /// Square of the angle at the end, and the integral of the square of the rate.
/// struct Restless;
///
/// impl Cost<2> for Restless {
///     fn end<T: Real>(&self, _t: T, x: &SVector<T, 2>) -> T {
///         x[0] * x[0]
///     }
///
///     fn running<T: Real>(&self, _t: T, x: &SVector<T, 2>) -> Option<T> {
///         Some(x[1] * x[1])
///     }
/// }
///
/// let swing = Swing::new(SwingParams::default())?;
/// let gradient = sensitivity::gradient(&Vern9::new(), &swing, 0.0, 10.0, [1.0, 0.0], &Restless)?;
/// // a longer pendulum moves more slowly, and a damped one less
/// assert!(gradient.by_parameters.iter().all(|&slope| slope < 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// As for [`Method::follow`], and [`Reason::CostNotFinite`].
pub fn gradient<X, M, C, T, const N: usize, const P: usize>(
    method: &X,
    model: &M,
    t0: T,
    t1: T,
    x0: impl IntoState<T, N>,
    cost: &C,
) -> Result<Gradient<T, N, P>, Reason>
where
    X: Method<M, T, N> + DiscreteAdjoint,
    M: Adjoint<T, N, P>,
    C: Cost<N>,
    T: Float,
{
    with_checkpoints(MOST_STATES, method, model, (t0, t1), x0.into_state(), cost)
}

/// [`gradient`] that keeps at most this number of states.
fn with_checkpoints<X, M, C, T, const N: usize, const P: usize>(
    most: usize,
    method: &X,
    model: &M,
    (t0, t1): (T, T),
    x0: SVector<T, N>,
    cost: &C,
) -> Result<Gradient<T, N, P>, Reason>
where
    X: Method<M, T, N> + DiscreteAdjoint,
    M: Adjoint<T, N, P>,
    C: Cost<N>,
    T: Float,
{
    let mut checkpoints = Checkpoints::new(most);
    let end = method.follow(model, t0, t1, x0, &[], &mut checkpoints)?;
    let at_end = cost.end(Dual::constant(t1), &variables(&end));
    let (mut value, mut weights) = (at_end.value, SVector::from(at_end.slopes));
    let mut by_parameters = SVector::from([T::default(); P]);
    let Checkpoints {
        steps, states, stride, ..
    } = &checkpoints;
    let mut between = Vec::with_capacity(*stride);
    for (stretch, &state) in steps.chunks(*stride).zip(states).rev() {
        between.clear();
        between.push(state);
        for &step in &stretch[..stretch.len() - 1] {
            let last = between[between.len() - 1];
            between.push(method.family().repeated(model, step, &last));
        }
        for (&step, x) in stretch.iter().zip(&between).rev() {
            value += method
                .family()
                .backward((model, cost), step, x, (&mut weights, &mut by_parameters));
        }
    }
    model.project_adjoint(t0, &x0, &mut weights);
    let derivatives = weights.iter().chain(by_parameters.iter());
    if !(value.is_finite() && derivatives.copied().all(Float::is_finite)) {
        return Err(Reason::CostNotFinite);
    }
    Ok(Gradient {
        value,
        end,
        by_start: weights,
        by_parameters,
    })
}

/// Time and length of each step, and the states from which the others can be computed again.
struct Checkpoints<T, const N: usize> {
    steps: Vec<(T, T)>,
    /// State at the start of every `stride`-th step.
    states: Vec<SVector<T, N>>,
    stride: usize,
    most: usize,
}

impl<T, const N: usize> Checkpoints<T, N> {
    fn new(most: usize) -> Self {
        Self {
            steps: Vec::new(),
            states: Vec::new(),
            stride: 1,
            most,
        }
    }
}

impl<T: Float, const N: usize> Observer<T, N> for Checkpoints<T, N> {
    fn needs(&self, _t0: T, _t1: T) -> Need {
        Need::Ends
    }

    fn step(&mut self, dense: &Dense<'_, T, N>) {
        let step = dense.step();
        if self.steps.len().is_multiple_of(self.stride) {
            if self.states.len() == self.most {
                let mut is_kept = false;
                self.states.retain(|_| {
                    is_kept = !is_kept;
                    is_kept
                });
                self.stride *= 2;
            }
            if self.steps.len().is_multiple_of(self.stride) {
                self.states.push(step.x0);
            }
        }
        self.steps.push((step.t0, step.h));
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::{Cost, MOST_STATES, with_checkpoints};
    use crate::Vern7;
    use crate::real::Real;
    use crate::system::{Adjoint, System};

    /// A pendulum with its frequency as a parameter.
    struct Swing(f64);

    impl System<f64, 2> for Swing {
        fn rhs(&self, _t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
            SVector::from([x[1], -self.0 * Real::sin_cos(x[0]).0])
        }
    }

    impl Adjoint<f64, 2, 1> for Swing {
        fn adjoint(&self, _t: f64, x: &SVector<f64, 2>, w: &SVector<f64, 2>) -> (SVector<f64, 2>, SVector<f64, 1>) {
            let (sin, cos) = Real::sin_cos(x[0]);
            (
                SVector::from([-self.0 * cos * w[1], w[0]]),
                SVector::from([-sin * w[1]]),
            )
        }
    }

    struct Angle;

    impl Cost<2> for Angle {
        fn end<T: Real>(&self, _t: T, x: &SVector<T, 2>) -> T {
            x[0]
        }
    }

    #[test]
    fn steps_between_checkpoints_are_taken_again() {
        let (swing, start) = (Swing(2.0), SVector::from([1.0, 0.0]));
        let kept = with_checkpoints(MOST_STATES, &Vern7::new(), &swing, (0.0, 60.0), start, &Angle).expect("regular");
        for most in [1, 2, 3, 10, 64] {
            let again = with_checkpoints(most, &Vern7::new(), &swing, (0.0, 60.0), start, &Angle).expect("regular");
            assert_eq!(again, kept, "{most} states");
        }
    }
}
