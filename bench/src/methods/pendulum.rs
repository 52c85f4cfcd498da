//! The model of all scenes, used from Rust here and, compiled into a library, from C.

pendulum_core::mechanism! {
    /// Two identical plates on axles with friction: Williams (2023), Eq. 22.
    pub DoublePendulum {
        params {
            m: kg,
            inertia: kg m^2,
            c: m,
            d: m,
            g: m/s^2,
            /// Friction of each axle.
            gamma: N m s,
        }
        gravity: [0, -g, 0],
        generate: [rhs, jacobian, taylor],
        shape plate { mass: m, com: [0, -c, 0], inertia: inertia }
        body upper on ground: plate { joint: revolute(z), coordinate: theta1, friction: gamma }
        body lower on upper: plate { joint: revolute(z) at [0, -d, 0], coordinate: theta2 absolute, friction: gamma }
    }
}

/// The model with the parameters of the paper, hidden from the optimiser so that they are known only at run time.
pub(crate) fn double_pendulum(gamma: f64) -> Result<DoublePendulum, pendulum_core::ParameterError> {
    let params = DoublePendulumParams {
        m: 1.0,
        inertia: 1.0,
        c: 1.0,
        d: 1.0,
        g: 9.8,
        gamma,
    };
    DoublePendulum::new(std::hint::black_box(params))
}
