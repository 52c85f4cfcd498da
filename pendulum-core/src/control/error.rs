//! Errors of the design of controllers.

use std::error::Error;
use std::fmt;

use super::LostModes;
use crate::error::debug_as_display;

debug_as_display! { [const N: usize] ControlError<N>; }

/// Reason why a linear model or a controller for a state of `N` components cannot be computed.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum ControlError<const N: usize> {
    /// A matrix or vector has an entry that is infinite or NaN.
    NotFinite {
        /// Name of the matrix or vector.
        what: &'static str,
    },
    /// The sampling period is not a positive number.
    Period(f64),
    /// The model is already one from sample to sample.
    Sampled {
        /// Its period in s.
        period: f64,
    },
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
    /// The state about which the model is linearized is no equilibrium.
    NotAtRest {
        /// Name of the component that changes fastest.
        component: String,
        /// Its rate.
        rate: f64,
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

impl<const N: usize> fmt::Display for ControlError<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { what } => write!(
                f,
                "{what} has an entry that is infinite or NaN; check the parameters and the state, which may be singular"
            ),
            Self::Period(period) => write!(
                f,
                "the sampling period is {period} s; it has to be positive and finite, such as 0.001"
            ),
            Self::Sampled { period } => write!(
                f,
                "the model is already one from sample to sample, with a period of {period} s; discretize the \
                 continuous one"
            ),
            Self::NotSymmetric {
                what,
                entry: [i, j],
                values: [value, mirrored],
            } => write!(
                f,
                "{what} is not symmetric: entry ({i}, {j}) is {value}, and entry ({j}, {i}) is {mirrored}; use \
                 ({what} + {what}^T) / 2"
            ),
            Self::NotPositive {
                what,
                strictly,
                eigenvalue,
            } => {
                let (kind, least) = if *strictly { ("", "> 0") } else { ("semi", ">= 0") };
                write!(
                    f,
                    "{what} is not positive {kind}definite: with its diagonal scaled to 1, its smallest eigenvalue is \
                     {eigenvalue:.3e}; use a diagonal matrix with entries {least}, or C^T W C with such a W"
                )
            }
            Self::NotAtRest { component, rate } => write!(
                f,
                "the state is no equilibrium: the rate of {component} is {rate:.3e}; start from one found by \
                 `stability::equilibrium`, or pass the inputs that hold the state; for a steady motion, design with \
                 `StateSpace::new(model.a, model.b)`"
            ),
            Self::Unstabilizable(modes) => write!(
                f,
                "no input acts on {modes}, so the model cannot be stabilized; add an input that acts along it, fix the \
                 joint, or give it friction"
            ),
            Self::Unweighted(modes) => write!(
                f,
                "the cost does not depend on {modes}, which does not decay by itself; give its components a weight in Q"
            ),
            Self::Undetectable(modes) => write!(
                f,
                "no output shows {modes}, so it cannot be estimated; add an output that depends on it"
            ),
            Self::Undisturbed(modes) => write!(
                f,
                "the process noise does not drive {modes}, which does not decay by itself; give it noise in W"
            ),
            Self::NoConvergence { residual } => write!(
                f,
                "no stabilizing solution of the Riccati equation was found: its relative residual is {residual:.1e}; \
                 some mode may be almost out of reach (see `StateSpace::controllability`), or the weights may differ \
                 by too many orders of magnitude"
            ),
        }
    }
}

impl<const N: usize> Error for ControlError<N> {}
