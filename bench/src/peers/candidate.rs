//! Functions that compete.

use pendulum_core::Operations;
use serde::{Deserialize, Serialize};

use crate::compile::Job;
use crate::library::Program;

/// The name of the generated code among the peers.
pub(crate) const OURS: &str = "pendulum";

/// The models, as the peers' files call them, and as people do.
pub(crate) const MODELS: [(&str, &str); 4] = [
    ("eq22", "Double pendulum, Eq. 22"),
    ("ur5", "UR5, six joints"),
    ("panda", "Panda, seven joints"),
    ("solo", "Solo 12 in flight, twelve joints"),
];

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Function {
    /// The accelerations of the coordinates.
    Rhs,
    /// These, and their derivatives by coordinates and rates.
    Jacobian,
    /// The position of a point of the last body, and its derivatives by the coordinates.
    Point,
}

impl Function {
    /// Those that compete for a model.
    pub(crate) fn of(model: &str) -> &'static [Self] {
        match model {
            "ur5" => &[Self::Rhs, Self::Jacobian, Self::Point],
            "solo" => &[Self::Rhs],
            _ => &[Self::Rhs, Self::Jacobian],
        }
    }

    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Rhs => "right-hand side",
            Self::Jacobian => "right-hand side and Jacobian",
            Self::Point => "position and Jacobian of a point",
        }
    }

    /// The numbers that are derived, and by how many others, in a model of `dof` coordinates.
    pub(crate) fn shape(self, dof: usize) -> (usize, usize) {
        match self {
            Self::Rhs => (dof, 0),
            Self::Jacobian => (dof, 2 * dof),
            Self::Point => (3, dof),
        }
    }
}

/// One way to evaluate a function of a model.
pub(crate) struct Candidate {
    pub model: String,
    pub function: Function,
    pub peer: String,
    /// The algorithm, and for C how it was compiled.
    pub form: String,
    pub operations: Option<Operations>,
    pub program: Program,
    /// The same with hardly any sine and cosine.
    pub cheap: Option<Program>,
    /// How a peer was compiled, and the name of its function.
    pub job: Option<(Job, String)>,
}
