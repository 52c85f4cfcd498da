//! Competing functions.

use pendulum_core::Operations;
use serde::{Deserialize, Serialize};

use crate::compile::Job;
use crate::library::Program;

/// Names of the generated code among the peers: compiled for this processor, and as in a plain release build. The
/// latter also with fused arithmetic, as the C of the peers has, and with several states at once in lanes, which no
/// generator here does.
pub(crate) const OURS: &str = "pendulum";
pub(crate) const PLAIN: &str = "pendulum, plain build";
pub(crate) const FUSED: &str = "pendulum, fused";
pub(crate) const BATCH: &str = "pendulum, in batches";
/// Name of hand-written code, which is shown but is no generator to compete with.
pub(crate) const BY_HAND: &str = "by hand";

/// Names of the models: in the files of the peers, and in full.
pub(crate) const MODELS: [(&str, &str); 5] = [
    ("eq22", "Double pendulum, Eq. 22"),
    ("ur5", "UR5, six joints"),
    ("panda", "Panda, seven joints"),
    ("xarm7", "xArm 7, seven joints"),
    ("solo", "Solo 12 in flight, twelve joints"),
];

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Function {
    /// Accelerations of the coordinates.
    Rhs,
    /// Accelerations, and their derivatives by coordinates and rates.
    Jacobian,
    /// Position of a point of the last body, and its derivatives by the coordinates.
    Point,
}

impl Function {
    /// Functions measured for a model.
    pub(crate) fn of(model: &str) -> &'static [Self] {
        match model {
            "ur5" => &[Self::Rhs, Self::Jacobian, Self::Point],
            "solo" => &[Self::Rhs],
            _ => &[Self::Rhs, Self::Jacobian],
        }
    }

    /// Name in symbols of libraries.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Rhs => "rhs",
            Self::Jacobian => "jacobian",
            Self::Point => "point",
        }
    }

    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Rhs => "right-hand side",
            Self::Jacobian => "right-hand side and Jacobian",
            Self::Point => "position and Jacobian of a point",
        }
    }

    /// Number of differentiated values, and of the variables by which they are differentiated, for a model with `dof`
    /// coordinates.
    pub(crate) fn shape(self, dof: usize) -> (usize, usize) {
        match self {
            Self::Rhs => (dof, 0),
            Self::Jacobian => (dof, 2 * dof),
            Self::Point => (3, dof),
        }
    }
}

/// Dependence of the states of a loop.
#[derive(Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Order {
    /// No state depends on another, so that evaluations overlap.
    SideBySide,
    /// Each state depends on the previous result, as in an integration.
    InSequence,
}

impl Order {
    pub(crate) const ALL: [Self; 2] = [Self::SideBySide, Self::InSequence];

    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::SideBySide => "side by side",
            Self::InSequence => "in sequence",
        }
    }
}

/// An implementation of a function of a model.
pub(crate) struct Candidate {
    pub model: String,
    pub function: Function,
    pub order: Order,
    pub peer: String,
    /// Algorithm, and for C the compiler call.
    pub form: String,
    pub operations: Option<Operations>,
    pub program: Program,
    /// Variant of the program with cheap sines and cosines.
    pub cheap: Option<Program>,
    /// Compilation of a peer, and the name of its function.
    pub job: Option<(Job, String)>,
}
