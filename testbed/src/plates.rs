//! Planar chains in which every number is a parameter.

pendulum_core::mechanism! {
    /// Two different plates whose centres of mass lie on the lines of their joints.
    pub Plates {
        params {
            m1: kg, m2: kg,
            inertia1: kg m^2, inertia2: kg m^2,
            c1: m, c2: m, d: m,
            g: m/s^2,
            gamma1: N m s, gamma2: N m s,
        }
        gravity: [0, -g, 0],
        body upper on ground {
            mass: m1, com: [0, -c1, 0], inertia: inertia1,
            joint: revolute(z),
            coordinate: theta1 absolute,
            friction: gamma1,
        }
        body lower on upper {
            mass: m2, com: [0, -c2, 0], inertia: inertia2,
            joint: revolute(z) at [0, -d, 0],
            coordinate: theta2 absolute,
            friction: gamma2,
        }
    }
}

pendulum_core::mechanism! {
    /// Like `Plates`, but in joint angles: the second angle is measured from the first body.
    pub RelativePlates {
        params {
            m1: kg, m2: kg,
            inertia1: kg m^2, inertia2: kg m^2,
            c1: m, c2: m, d: m,
            g: m/s^2,
            gamma1: N m s, gamma2: N m s,
        }
        gravity: [0, -g, 0],
        body upper on ground {
            mass: m1, com: [0, -c1, 0], inertia: inertia1,
            joint: revolute(z),
            coordinate: q1,
            friction: gamma1,
        }
        body lower on upper {
            mass: m2, com: [0, -c2, 0], inertia: inertia2,
            joint: revolute(z) at [0, -d, 0],
            coordinate: q2,
            friction: gamma2,
        }
    }
}

pendulum_core::mechanism! {
    /// Three rods of the reference scene `triple_chain`.
    pub TripleChain {
        gravity: [0, -9.81, 0],
        body first on ground {
            mass: 1, com: [0, -0.5, 0], inertia: 0.08,
            joint: revolute(z),
            coordinate: theta1 absolute,
            friction: 0.01,
        }
        body second on first {
            mass: 0.7, com: [0, -0.4, 0], inertia: 0.05,
            joint: revolute(z) at [0, -1, 0],
            coordinate: theta2 absolute,
            friction: 0.01,
        }
        body third on second {
            mass: 0.5, com: [0, -0.3, 0], inertia: 0.02,
            joint: revolute(z) at [0, -0.8, 0],
            coordinate: theta3 absolute,
            friction: 0.01,
        }
    }
}
