//! The scene: a double pendulum of two plates.

use pendulum_core::ParameterError;
use pendulum_core::prelude::*;

mechanism! {
    /// Two identical plates on axles with friction: Williams (2023), Eq. 22.
    pub(crate) DoublePendulum {
        params {
            /// Friction of the upper axle.
            gamma1: N m s = 0.0,
            /// Friction of the lower axle.
            gamma2: N m s = 0.0,
        }
        gravity: [0, -9.8, 0],
        generate: [rhs, jacobian, energy, mass_matrix, taylor],

        shape plate { mass: 1, com: [0, -1, 0], inertia: 1 }

        body upper on ground: plate {
            joint: revolute(z),
            coordinate: theta1,
            friction: gamma1,
        }
        body lower on upper: plate {
            joint: revolute(z) at [0, -1, 0],
            coordinate: theta2 absolute,
            friction: gamma2,
        }
    }
}

impl DoublePendulum {
    /// Creates the pendulum with friction in its two joints, in N m s.
    pub(crate) fn with_friction(gamma1: f64, gamma2: f64) -> Result<Self, ParameterError> {
        Self::new(DoublePendulumParams { gamma1, gamma2 })
    }
}

/// Threshold of finite-time exponents over `duration` seconds, in 1/s, above which a motion counts as chaotic: twice
/// the exponent of regular motion, in which neighbours separate in proportion to time.
pub(crate) fn chaos_above(duration: f64) -> f64 {
    2.0 * duration.ln() / duration
}
