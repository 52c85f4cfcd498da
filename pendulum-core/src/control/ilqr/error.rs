//! Errors of the iterative regulator.

use core::error::Error;

use crate::error::{Name, Reason, debug_as_display, messages};

/// Reason why [`Ilqr`](super::Ilqr) has no motion.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum IlqrError {
    /// The length of a step is not a positive number.
    Step(f64),
    /// The tolerance is not between 0 and 1.
    Tolerance(f64),
    /// The limits of an input are reversed, or not numbers.
    Limits {
        /// Index of the input.
        input: usize,
        /// Its limits.
        limits: [f64; 2],
    },
    /// An input at the start of the search is beyond its limits.
    StartBeyondLimits {
        /// Index of the input.
        input: usize,
        /// Index of the node.
        node: usize,
        /// Value of the input.
        value: f64,
        /// Its limits.
        limits: [f64; 2],
    },
    /// A matrix, a vector or a time is infinite or NaN, or has such an entry.
    NotFinite {
        /// Its name.
        what: &'static str,
    },
    /// A weight is not symmetric.
    NotSymmetric {
        /// Name of the matrix.
        what: &'static str,
        /// Row and column of an entry that differs from its mirror image.
        entry: [usize; 2],
        /// The entry and its mirror image.
        values: [f64; 2],
    },
    /// A weight is not positive semidefinite, or not definite where it has to be.
    NotPositive {
        /// Name of the matrix.
        what: &'static str,
        /// True if it has to be definite.
        strictly: bool,
    },
    /// The cost is not convex in the inputs of a node.
    NotConvex {
        /// Index of the node.
        node: usize,
    },
    /// The motion at the start of the search leaves the range of numbers.
    Diverged {
        /// Index of the node at the end of the last step with a finite state.
        node: usize,
        /// Its time in s.
        t: f64,
    },
    /// A step of the motion cannot be integrated, or has no derivatives: see [`Integrated`](super::Integrated).
    StepFailed {
        /// Index of the node at its start.
        node: usize,
        /// Reason of the method.
        reason: Reason,
    },
    /// No step in the direction of the search decreases the cost: the derivatives are wrong, or the motion is at a jump
    /// or kink of the cost.
    NoDecrease {
        /// Number of iterations.
        iterations: usize,
        /// The cost.
        cost: f64,
        /// Decrease that the derivatives promise.
        promised: f64,
    },
    /// The cost still decreases after the permitted number of iterations.
    TooManyIterations {
        /// Number of iterations.
        iterations: usize,
        /// The cost.
        cost: f64,
        /// Its decrease by the last iteration.
        decrease: f64,
    },
    /// The model has mode switches: dry friction, a stop or a wall.
    ModeSwitches {
        /// Name of the first constraint.
        constraint: Name,
    },
    /// The model has a closed loop without a closed form.
    ClosedLoop {
        /// The two bodies that close the loop.
        bodies: [Name; 2],
    },
}

debug_as_display! { [] IlqrError; }

messages! {
    [] IlqrError;
    Self::Step(h) => "the length of a step is {h} s\nhelp: use a positive and finite one, such as 0.02";
    Self::Tolerance(tolerance) =>
        "the tolerance is {tolerance}\nhelp: pass a share of the cost between 0 and 1, such as 1e-6";
    Self::Limits { input, limits: [low, high] } =>
        "the limits of input {input} are {low} and {high}\nhelp: pass the lower one first, `limits(low, high)`; \
         without a limit, infinity";
    Self::StartBeyondLimits { input, node, value, limits: [low, high] } =>
        "the search starts with {value} for input {input} at node {node}, beyond its limits {low} and {high}\nhelp: \
         pass inputs within the limits by `start`, such as those that hold the goal";
    Self::NotFinite { what } =>
        "{what} is not finite\nhelp: pass finite weights, states and times; limits alone may be infinite";
    Self::NotSymmetric { what, entry: [i, j], values: [value, mirrored] } =>
        "{what} is not symmetric: entry ({i}, {j}) is {value}, and entry ({j}, {i}) is {mirrored}\nhelp: use ({what} + \
         {what}^T) / 2";
    Self::NotPositive { what, strictly: true } =>
        "{what} is not positive definite\nhelp: use a diagonal matrix with entries > 0, or C^T W C with such a W";
    Self::NotPositive { what, strictly: false } =>
        "{what} is not positive semidefinite\nhelp: use a diagonal matrix with entries >= 0, or C^T W C with such a W";
    Self::NotConvex { node } =>
        "the cost is not convex in the inputs of node {node}\nhelp: return second derivatives without negative \
         eigenvalues, such as 2 J^T J for a sum of squares; check that they are finite";
    Self::Diverged { node, t } =>
        "the motion with the inputs at the start leaves the range of numbers after node {node}, t = {t} s\nhelp: start \
         from inputs that keep the motion bounded, shorten the step, or use fewer nodes";
    Self::StepFailed { node, reason } => "the step from node {node}: {reason}";
    Self::NoDecrease { iterations, cost, promised } =>
        "no step decreases the cost of {cost} after {iterations} iterations, although its derivatives promise \
         {promised:.1e}\nhelp: check the derivatives of the model and of the cost, or raise the tolerance; with mode \
         switches the best motion, which is kept, may be at a jump or kink of the cost";
    Self::TooManyIterations { iterations, cost, decrease } =>
        "the cost of {cost} still decreases, by {decrease:.1e} in the last of {iterations} iterations\nhelp: raise \
         `max_iterations` or the tolerance, or call `solve` again, which continues from there";
    Self::ModeSwitches { constraint } =>
        "the model has mode switches at `{constraint}`, and the steps of the search are smooth\nhelp: plan with \
         `Integrated::new(model, Tsit5::new())`, in double precision, whose steps go through them";
    Self::ClosedLoop { bodies: [a, b] } =>
        "the loop of `{a}` and `{b}` has no closed form, and its closure no derivatives\nhelp: plan with a scene whose \
         loops have closed forms";
}

impl Error for IlqrError {}
