//! Scenes of `testbed/data/mass_ratios.json`: chains in which one body may be much lighter or heavier than the others.

pendulum_core::mechanism! {
    /// Two point masses on massless rods, in absolute angles.
    pub Points {
        params { m1: kg, m2: kg, l1: m, l2: m, g: m/s^2 }
        gravity: [0, -g, 0],
        generate: [rhs, mass_matrix, bias],
        body upper on ground {
            mass: m1, com: [0, -l1, 0],
            joint: revolute(z),
            coordinate: theta1 absolute,
        }
        body lower on upper {
            mass: m2, com: [0, -l2, 0],
            joint: revolute(z) at [0, -l1, 0],
            coordinate: theta2 absolute,
        }
    }
}

pendulum_core::mechanism! {
    /// Like `Points`, but in joint angles.
    pub RelativePoints {
        params { m1: kg, m2: kg, l1: m, l2: m, g: m/s^2 }
        gravity: [0, -g, 0],
        generate: [rhs],
        body upper on ground {
            mass: m1, com: [0, -l1, 0],
            joint: revolute(z),
            coordinate: q1,
        }
        body lower on upper {
            mass: m2, com: [0, -l2, 0],
            joint: revolute(z) at [0, -l1, 0],
            coordinate: q2,
        }
    }
}

pendulum_core::mechanism! {
    /// A point mass on a massless rod, on a cart.
    pub Cart {
        params { m1: kg, m2: kg, l: m, g: m/s^2 }
        gravity: [0, -g, 0],
        generate: [rhs],
        body cart on ground {
            mass: m1,
            joint: prismatic(x),
            coordinate: s,
        }
        body pole on cart {
            mass: m2, com: [0, -l, 0],
            joint: revolute(z),
            coordinate: theta,
        }
    }
}

pendulum_core::mechanism! {
    /// Three point masses on massless rods, in absolute angles.
    pub Chain {
        params { m1: kg, m2: kg, m3: kg, l1: m, l2: m, l3: m, g: m/s^2 }
        gravity: [0, -g, 0],
        generate: [rhs],
        body first on ground {
            mass: m1, com: [0, -l1, 0],
            joint: revolute(z),
            coordinate: theta1 absolute,
        }
        body second on first {
            mass: m2, com: [0, -l2, 0],
            joint: revolute(z) at [0, -l1, 0],
            coordinate: theta2 absolute,
        }
        body third on second {
            mass: m3, com: [0, -l3, 0],
            joint: revolute(z) at [0, -l2, 0],
            coordinate: theta3 absolute,
        }
    }
}

pendulum_core::mechanism! {
    /// Three thin rods that turn about z, y and x.
    pub Arm {
        params { m1: kg, m2: kg, m3: kg, l1: m, l2: m, l3: m, g: m/s^2 }
        gravity: [0, 0, -g],
        generate: [rhs],
        body first on ground {
            solids: [rod(m1, [0, 0, 0], [l1, 0, 0])],
            joint: revolute(z),
            coordinate: q1,
        }
        body second on first {
            solids: [rod(m2, [0, 0, 0], [l2, 0, 0])],
            joint: revolute(y) at [l1, 0, 0],
            coordinate: q2,
        }
        body third on second {
            solids: [rod(m3, [0, 0, 0], [0, 0, -l3])],
            joint: revolute(x) at [l2, 0, 0],
            coordinate: q3,
        }
    }
}
