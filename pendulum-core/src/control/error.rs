//! Errors of the design of controllers.

use std::error::Error;

use super::LostModes;
use crate::error::{debug_as_display, messages};

/// Reason why a linear model or a controller for a state of `N` components cannot be computed.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum ControlError<const N: usize> {
    /// A matrix or vector has an entry that is infinite or NaN.
    NotFinite {
        /// Name of the matrix or vector.
        what: &'static str,
    },
    /// A matrix has an entry whose square is too large for a number.
    TooLarge {
        /// Name of the matrix.
        what: &'static str,
    },
    /// The model grows too much over a sampling period.
    Growth {
        /// The period in s.
        period: f64,
    },
    /// The sampling period is not a positive number.
    Period(f64),
    /// The model is already one from sample to sample.
    Sampled {
        /// Its period in s.
        period: f64,
    },
    /// The model has no sampling period.
    Continuous,
    /// A weight or covariance is not symmetric.
    NotSymmetric {
        /// Name of the matrix.
        what: &'static str,
        /// Row and column of an entry that differs from its mirror image.
        entry: [usize; 2],
        /// The entry and its mirror image.
        values: [f64; 2],
    },
    /// A weight or covariance is not positive semidefinite, or not definite where it has to be.
    NotPositive {
        /// Name of the matrix.
        what: &'static str,
        /// True if it has to be definite.
        strictly: bool,
        /// Smallest eigenvalue of the matrix after scaling of its diagonal to 1.
        eigenvalue: f64,
    },
    /// The model is linearized about a state that is not an equilibrium.
    NotAtRest {
        /// Name of the component that is furthest from rest.
        component: String,
        /// Its rate, or its change per sample.
        rate: f64,
        /// Sampling period in s; `None` for a continuous model.
        period: Option<f64>,
    },
    /// No input acts on some modes that do not decay. The directions are left eigenvectors `w`: the inputs do not
    /// change `w . x`.
    Unstabilizable(LostModes<N>),
    /// Modes on the limit of stability do not contribute to the cost. The directions are right eigenvectors.
    Unweighted(LostModes<N>),
    /// No output shows some modes that do not decay. The directions are right eigenvectors.
    Undetectable(LostModes<N>),
    /// The process noise does not drive some modes on the limit of stability. The directions are left eigenvectors.
    Undisturbed(LostModes<N>),
    /// The stabilizing solution was not found to the accuracy that rounding errors permit.
    NoConvergence {
        /// Residual relative to the terms of the equation; NaN if eigenvalues did not converge.
        residual: f64,
    },
}

debug_as_display! { [const N: usize] ControlError<N>; }

messages! {
    [const N: usize] ControlError<N>;
    Self::NotFinite { what: what @ ("Q" | "R" | "W" | "V") } =>
        "{what} has an entry that is infinite or NaN\nhelp: pass finite weights and covariances";
    Self::NotFinite { what } =>
        "{what} has an entry that is infinite or NaN\nhelp: check the parameters and the state, which may be \
         singular";
    Self::TooLarge { what } =>
        "{what} has entries above 1e150, whose squares overflow\nhelp: use other units, or check the parameters and \
         the state, which may be singular";
    Self::Growth { period } =>
        "the model grows beyond the range of numbers within {period} s\nhelp: use a shorter period";
    Self::Period(period) => "the sampling period is {period} s\nhelp: use a positive and finite one, such as 0.001";
    Self::Sampled { period } =>
        "the model is already one from sample to sample, with a period of {period} s\nhelp: discretize the continuous \
         one";
    Self::Continuous =>
        "the model is continuous, and a filter in a sampled controller predicts from sample to sample\nhelp: use \
         `model.discretize(period)`, also for the law and the filter";
    Self::NotSymmetric { what, entry: [i, j], values: [value, mirrored] } =>
        "{what} is not symmetric: entry ({i}, {j}) is {value}, and entry ({j}, {i}) is {mirrored}\nhelp: use ({what} + \
         {what}^T) / 2";
    Self::NotPositive { what, strictly: true, eigenvalue } =>
        "{what} is not positive definite: with its diagonal scaled to 1, its smallest eigenvalue is {eigenvalue:.3e}\n\
         help: use a diagonal matrix with entries > 0, or C^T W C with such a W";
    Self::NotPositive { what, strictly: false, eigenvalue } =>
        "{what} is not positive semidefinite: with its diagonal scaled to 1, its smallest eigenvalue is \
         {eigenvalue:.3e}\nhelp: use a diagonal matrix with entries >= 0, or C^T W C with such a W";
    Self::NotAtRest { component, rate, period } =>
        "the state is no equilibrium: {change}\nhelp: start from an equilibrium found by `stability::equilibrium`, or \
         pass the inputs that hold the state; for deviations from a steady motion, design with `model.without_drift()`",
        change = match period {
            None => format!("the rate of {component} is {rate:.3e}"),
            Some(_) => format!("{component} changes by {rate:.3e} per sample"),
        };
    Self::Unstabilizable(modes) =>
        "the model cannot be stabilized: no input acts on {modes}\nhelp: add an input that acts along {them}, fix the \
         joint, or give it friction",
        them = modes.agree("it", "them");
    Self::Unweighted(modes) =>
        "the cost does not depend on {modes}, which {do_not} decay by {themselves}\nhelp: give {their} components a \
         weight in Q",
        do_not = modes.agree("does not", "do not"),
        themselves = modes.agree("itself", "themselves"),
        their = modes.agree("its", "their");
    Self::Undetectable(modes) =>
        "no output shows {modes}, so {they} cannot be estimated\nhelp: add an output that depends on {them}",
        they = modes.agree("it", "they"),
        them = modes.agree("it", "them");
    Self::Undisturbed(modes) =>
        "the process noise does not drive {modes}, which {do_not} decay by {themselves}\nhelp: give {their} components \
         noise in W",
        do_not = modes.agree("does not", "do not"),
        themselves = modes.agree("itself", "themselves"),
        their = modes.agree("its", "their");
    Self::NoConvergence { residual } =>
        "no stabilizing solution of the Riccati equation was found: its relative residual is {residual:.1e}\nhelp: \
         check `StateSpace::controllability` and `StateSpace::observability` for a mode that is almost lost, and use \
         weights that differ by fewer orders of magnitude";
}

impl<const N: usize> Error for ControlError<N> {}
