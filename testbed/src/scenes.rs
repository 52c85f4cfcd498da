//! The first scene, shared by tests and examples.

pendulum_core::mechanism! {
    /// Two identical plates on axles with friction: Williams (2023), Eq. 22.
    pub DoublePendulum {
        params {
            /// Mass of each plate.
            m: kg = 1.0,
            /// Rotational inertia of each plate about its centre of mass.
            inertia: kg m^2 = 1.0,
            /// Distance from a plate's axle to its centre of mass.
            c: m = 1.0,
            /// Distance between the two axles.
            d: m = 1.0,
            /// Acceleration of gravity.
            g: m/s^2 = 9.8,
            /// Friction of the upper axle.
            gamma1: N m s = 0.1,
            /// Friction of the lower axle.
            gamma2: N m s = 0.1,
        }
        gravity: [0, -g, 0],
        generate: [rhs, jacobian, energy, taylor, canonical],

        shape plate { mass: m, com: [0, -c, 0], inertia: inertia }

        body upper on ground: plate {
            joint: revolute(z) at [0, 0, 0],
            coordinate: theta1,
            friction: gamma1,
        }
        body lower on upper: plate {
            joint: revolute(z) at [0, -d, 0],
            coordinate: theta2 absolute,
            friction: gamma2,
        }
    }
}

/// The scene with this friction of both axles.
pub fn double_pendulum(gamma: f64) -> DoublePendulum {
    let params = DoublePendulumParams {
        gamma1: gamma,
        gamma2: gamma,
        ..Default::default()
    };
    DoublePendulum::new(params).expect("physical")
}
