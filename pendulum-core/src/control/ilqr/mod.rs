//! Motions of least cost within limits of the inputs, by iterative LQR.

mod backward;
mod boxed;
mod cost;
mod error;
mod forward;
mod integrated;
mod kink;
mod least_squares;
mod line_search;
mod matrix;
mod predictive;
mod search;
mod step;
mod tracker;

use nalgebra::{SMatrix, SVector};

pub use cost::{CostDerivatives, Objective, Quadratic};
pub use error::IlqrError;
pub use integrated::Integrated;
pub use least_squares::{LeastSquares, Residuals};
pub use predictive::{Predictive, PredictiveState};
pub use search::{Pass, Solved};
pub use step::{StepDerivatives, StepMap};
pub use tracker::{Tracker, TrackerState};

use crate::real::Float;
use search::Damping;

/// Iterative LQR: the motion of least cost over `K` steps, within limits of the inputs, and the law that holds it.
///
/// Each iteration linearizes the motion step by step, by the generated derivatives, and goes through it backward: at
/// each node, the changes of the inputs minimize a quadratic model of the cost to go, within the limits, and the gains
/// are those of the inputs that are not at a limit. A forward pass follows, with a line search. [`solve`](Self::solve)
/// repeats both until the cost decreases no more, [`pass`](Self::pass) takes one of each, for the time between two
/// samples of a controller, and [`controller`](Self::controller) does that for [`Sampled`](crate::control::Sampled).
/// [`tracker`](Self::tracker) holds the motion as it is, by its gains.
///
/// The value holds the motion and its gains, in `K` nodes of fixed size: nothing is allocated, and everything works
/// without `std`. It has about `K (2 N + 3 M + N M)` numbers, of which a search puts some on the stack. The next search
/// begins with the last motion, which [`shift`](Self::shift) moves on by a step.
///
/// ```
/// use pendulum_core::control::{Ilqr, Quadratic};
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
/// let cost = Quadratic::diagonal([0.0, 0.0], [0.1]).end(SMatrix::identity() * 100.0);
/// // 150 steps of 20 ms
/// let mut ilqr = Ilqr::<_, _, 2, 1, 150>::new(0.02, cost).limits([-2.0], [2.0]).start([0.5]);
/// ilqr.solve(&arm, 0.0, [std::f64::consts::PI, 0.0])?;
/// assert!(ilqr.end().amax() < 0.1);
/// assert!(ilqr.inputs().iter().all(|[motor]| motor.abs() <= 2.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Steps are those of the explicit midpoint rule, with inputs that are held over each: choose them short enough for it.
/// Quaternions are normalised after each step. Models with dry friction, stops or walls are passed as [`Integrated`]
/// ones, whose steps go through mode switches; loops without a closed form are refused.
///
/// Y. Tassa, T. Erez, E. Todorov, IROS (2012) 4906; Y. Tassa, N. Mansard, E. Todorov, ICRA (2014) 1168.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ilqr<C, T, const N: usize, const M: usize, const K: usize> {
    h: T,
    cost: C,
    low: [T; M],
    high: [T; M],
    tolerance: T,
    max_iterations: usize,
    /// The best motion.
    plan: Plan<T, N, M, K>,
    /// The motion of the last forward pass, along which the backward pass goes.
    trial: Plan<T, N, M, K>,
    /// Change of the inputs by the last backward pass; 0 once it is in the plan.
    change: [[T; M]; K],
    /// Transposed gains.
    gain: [SMatrix<T, N, M>; K],
    damping: Damping<T>,
}

/// States and inputs at the nodes, and the state at the end.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Plan<T, const N: usize, const M: usize, const K: usize> {
    x: [SVector<T, N>; K],
    end: SVector<T, N>,
    u: [[T; M]; K],
}

impl<C, T: Float, const N: usize, const M: usize, const K: usize> Ilqr<C, T, N, M, K> {
    /// Creates a search for motions of `K` steps of length `h` in s, such as 100 of 0.02 s.
    #[must_use]
    pub fn new(h: T, cost: C) -> Self {
        const { assert!(K > 0, "a motion has at least one step") };
        let plan = Plan {
            x: [matrix::zeros(); K],
            end: matrix::zeros(),
            u: [[T::default(); M]; K],
        };
        Self {
            h,
            cost,
            low: [T::from_f64(f64::NEG_INFINITY); M],
            high: [T::from_f64(f64::INFINITY); M],
            tolerance: T::from_f64(1e-6),
            max_iterations: 500,
            plan,
            trial: plan,
            change: [[T::default(); M]; K],
            gain: [matrix::zeros(); K],
            damping: Damping::none(),
        }
    }

    /// Limits each input to the range from `low` to `high`. Default: no limits.
    #[must_use]
    pub fn limits(mut self, low: [T; M], high: [T; M]) -> Self {
        (self.low, self.high) = (low, high);
        self
    }

    /// Sets the inputs with which the search starts, at all nodes. Default: 0.
    ///
    /// Where the motion has a symmetry, as a pendulum hanging still has, inputs that break it help.
    #[must_use]
    pub fn start(self, inputs: impl Into<[T; M]>) -> Self {
        self.start_from([inputs.into(); K])
    }

    /// Sets the inputs with which the search starts, node by node.
    #[must_use]
    pub fn start_from(mut self, inputs: [[T; M]; K]) -> Self {
        self.plan.u = inputs;
        self.gain = [matrix::zeros(); K];
        self.change = [[T::default(); M]; K];
        self.damping = Damping::none();
        self
    }

    /// Sets the decrease of the cost at which [`solve`](Self::solve) ends, as a share of the cost. Default: 1e-6.
    #[must_use]
    pub fn tolerance(mut self, tolerance: T) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// Sets the maximum number of iterations of [`solve`](Self::solve), at least one. Default: 500.
    #[must_use]
    pub fn max_iterations(mut self, iterations: usize) -> Self {
        self.max_iterations = iterations.max(1);
        self
    }

    /// Moves the motion on by a step, as a start for the next sample: the last inputs and gains are repeated.
    pub fn shift(&mut self) {
        let Plan { x, end, u } = &mut self.plan;
        x.copy_within(1.., 0);
        x[K - 1] = *end;
        u.copy_within(1.., 0);
        self.gain.copy_within(1.., 0);
    }

    /// The cost, to change its goal before the next pass.
    pub fn cost_mut(&mut self) -> &mut C {
        &mut self.cost
    }

    /// Length of a step in s.
    pub fn h(&self) -> T {
        self.h
    }

    /// Inputs of each step.
    pub fn inputs(&self) -> &[[T; M]; K] {
        &self.plan.u
    }

    /// State at the start of each step.
    pub fn states(&self) -> &[SVector<T, N>; K] {
        &self.plan.x
    }

    /// State at the end of the last step.
    pub fn end(&self) -> &SVector<T, N> {
        &self.plan.end
    }

    /// Gain `G` of the law `u + G (x - x_k)` at the node `node`, of the last backward pass. Rows of inputs at a limit
    /// are 0.
    ///
    /// # Panics
    /// If there is no such node.
    pub fn gain(&self, node: usize) -> SMatrix<T, M, N> {
        matrix::transposed(&self.gain[node])
    }

    /// Inputs that the law of a node commands in the state `x`, within the limits: they hold the motion where it is
    /// disturbed.
    ///
    /// # Panics
    /// If there is no such node.
    pub fn command(&self, node: usize, x: &SVector<T, N>) -> [T; M] {
        self.law(node, T::default(), x)
    }

    /// The law of a node with a share of the change of its inputs.
    #[inline(always)]
    fn law(&self, node: usize, share: T, x: &SVector<T, N>) -> [T; M] {
        let (planned, change) = (&self.plan.x[node], &self.change[node]);
        let mut u = self.plan.u[node];
        for (m, input) in u.iter_mut().enumerate() {
            *input += share * change[m];
            let mut feedback = T::default();
            for n in 0..N {
                let deviation = x.data.0[0][n] - planned.data.0[0][n];
                feedback = self.gain[node].data.0[m][n].mul_add(deviation, feedback);
            }
            *input += feedback;
        }
        boxed::limited(&u, [&self.low, &self.high])
    }

    /// Time of a node.
    #[inline(always)]
    fn time(&self, t0: T, node: usize) -> T {
        t0 + T::from_f64(node as f64) * self.h
    }
}
