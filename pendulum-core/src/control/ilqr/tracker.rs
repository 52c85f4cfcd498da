//! Tracking of a motion by its gains.

use nalgebra::SVector;

use super::{Ilqr, Plan};
use crate::control::Controller;
use crate::real::Float;

/// Share of a step by which a sample may be early, since the times of samples are rounded.
const EARLY: f64 = 1e-3;

/// A [`Controller`] that holds a motion of [`Ilqr`] by its gains (time-varying LQR), and then hands over to another
/// one, such as a regulator about the state that the motion leads to: [`Ilqr::tracker`] makes it.
///
/// Measurements are the whole state. The motion begins at the first sample. Samples may be closer to each other than
/// its nodes: between them, the planned state is interpolated linearly, and inputs and gains are those of the last one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tracker<I, C> {
    motion: I,
    then: C,
}

/// Memory of a [`Tracker`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct TrackerState<T, S> {
    /// Time of the first sample; `None` before it.
    pub t: Option<T>,
    /// Memory of the controller that takes over, from the first sample that it commands.
    pub then: Option<S>,
    period: T,
}

impl<O, T: Float, const N: usize, const M: usize, const K: usize> Ilqr<O, T, N, M, K> {
    /// A controller that holds this motion by its gains, and hands over to `then` at its end.
    ///
    /// ```
    /// use pendulum_core::control::{Ilqr, Quadratic, Sampled, linearize};
    /// use pendulum_core::prelude::*;
    ///
    /// mechanism! {
    ///     /// The motor is too weak to lift the arm at once; the angle is 0 upright.
    ///     pub Arm {
    ///         input motor: N m,
    ///         gravity: [0, -9.81, 0],
    ///         body rod on ground {
    ///             solids: [rod(1, [0, 0, 0], [0, 1, 0])], joint: revolute(z), coordinate: angle, torque: motor,
    ///         }
    ///     }
    /// }
    ///
    /// let arm = Arm::new(ArmParams {})?;
    /// let weights = SMatrix::from_diagonal(&[1.0, 0.1].into());
    /// let hold = linearize(&arm, 0.0, [0.0; 2], [0.0])?.discretize(0.005)?.lqr(&weights, &SMatrix::from([[0.1]]))?;
    /// let cost = Quadratic::diagonal([0.0, 0.0], [0.1]).end(SMatrix::identity() * 100.0);
    /// let mut ilqr = Ilqr::<_, _, 2, 1, 150>::new(0.02, cost).limits([-2.0], [2.0]).start([0.5]);
    /// ilqr.solve(&arm, 0.0, [std::f64::consts::PI, 0.0])?;
    ///
    /// let sampled = Sampled::new(ilqr.tracker(hold.law), 0.005).limits([-2.0], [2.0]).noise([2e-3, 2e-2]);
    /// let end = sampled.end(&Tsit5::new(), &arm, 0.0, 8.0, [std::f64::consts::PI, 0.0])?;
    /// assert!(end.amax() < 0.05);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn tracker<C>(self, then: C) -> Tracker<Self, C>
    where
        C: Controller<T, N, M>,
    {
        Tracker { motion: self, then }
    }
}

impl<O, C, T, const N: usize, const M: usize, const K: usize> Controller<T, N, M> for Tracker<Ilqr<O, T, N, M, K>, C>
where
    C: Controller<T, N, M>,
    T: Float,
{
    type State = TrackerState<T, C::State>;

    fn start(&self, period: T) -> Self::State {
        TrackerState {
            t: None,
            then: None,
            period,
        }
    }

    fn sample(&self, t: T, measured: &SVector<T, N>, state: &mut Self::State) -> [T; M] {
        let passed = (t - *state.t.get_or_insert(t)) / self.motion.h;
        let node = (passed.to_f64() + EARLY) as usize;
        if node >= K {
            let then = state.then.get_or_insert_with(|| self.then.start(state.period));
            return self.then.sample(t, measured, then);
        }
        // the law takes the deviation from the state at the node
        let Plan { x, end, .. } = &self.motion.plan;
        let share = passed - T::from_f64(node as f64);
        let (from, to) = (&x[node], x.get(node + 1).unwrap_or(end));
        let moved = SVector::from_fn(|n, _| measured[n] - share * (to[n] - from[n]));
        self.motion.command(node, &moved)
    }

    fn sent(&self, command: &[T; M], sent: &[T; M], state: &mut Self::State) {
        if let Some(then) = &mut state.then {
            self.then.sent(command, sent, then);
        }
    }
}
