//! Declarations of the ten mechanisms of `testbed/data/mechanisms.json`.

use pendulum_core::mechanism;

mechanism! {
    /// Eq. 22: identical bodies, c = d = 1, I about the centre of mass, absolute angles.
    pub Eq22 {
        gravity: [0, -9.8, 0],
        generate: [rhs, jacobian, energy, mass_matrix, bias, momentum, canonical, inverse_dynamics],
        body b1 on ground {
            mass: 1, com: [0, -1, 0],
            inertia: [1, 1, 1],
            joint: revolute(z),
            coordinate: q1 absolute,
            friction: 0.1,
        }
        body b2 on b1 {
            mass: 1, com: [0, -1, 0],
            inertia: [1, 1, 1],
            joint: revolute(z) at [0, -1, 0],
            coordinate: q2 absolute,
            friction: 0.1,
        }
    }
}

mechanism! {
    /// Like `Eq22`, but in joint angles.
    pub Eq22Joint {
        gravity: [0, -9.8, 0],
        generate: [rhs, jacobian, energy, mass_matrix, bias, momentum, canonical, inverse_dynamics],
        body b1 on ground {
            mass: 1, com: [0, -1, 0],
            inertia: [1, 1, 1],
            joint: revolute(z),
            coordinate: q1,
            friction: 0.1,
        }
        body b2 on b1 {
            mass: 1, com: [0, -1, 0],
            inertia: [1, 1, 1],
            joint: revolute(z) at [0, -1, 0],
            coordinate: q2,
            friction: 0.1,
        }
    }
}

mechanism! {
    /// Two different plates with c != d, whose centres of mass lie off the line of the joints.
    pub IrregularPlates {
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, mass_matrix, bias, momentum, canonical, inverse_dynamics],
        body b1 on ground {
            mass: 1.7, com: [0.13, -0.43, 0],
            inertia: [0.2, 0.15, 0.31],
            joint: revolute(z),
            coordinate: q1 absolute,
            friction: 0.05,
        }
        body b2 on b1 {
            mass: 0.8, com: [-0.07, -0.55, 0],
            inertia: [0.08, 0.05, 0.12],
            joint: revolute(z) at [0.05, -0.9, 0],
            coordinate: q2 absolute,
            friction: 0.02,
        }
    }
}

mechanism! {
    /// Five planar rods.
    pub Chain5 {
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, mass_matrix, bias, momentum, canonical, inverse_dynamics],
        body b1 on ground {
            mass: 1.0, com: [0, -0.5, 0],
            inertia: [0.08, 0.005, 0.08],
            joint: revolute(z),
            coordinate: q1 absolute,
            friction: 0.01,
        }
        body b2 on b1 {
            mass: 0.9, com: [0, -0.5, 0],
            inertia: [0.07, 0.005, 0.07],
            joint: revolute(z) at [0, -1, 0],
            coordinate: q2 absolute,
            friction: 0.02,
        }
        body b3 on b2 {
            mass: 0.8, com: [0, -0.5, 0],
            inertia: [0.06, 0.005, 0.06],
            joint: revolute(z) at [0, -1, 0],
            coordinate: q3 absolute,
            friction: 0.03,
        }
        body b4 on b3 {
            mass: 0.7, com: [0, -0.5, 0],
            inertia: [0.05, 0.005, 0.05],
            joint: revolute(z) at [0, -1, 0],
            coordinate: q4 absolute,
            friction: 0.04,
        }
        body b5 on b4 {
            mass: 0.6, com: [0, -0.5, 0],
            inertia: [0.04, 0.005, 0.04],
            joint: revolute(z) at [0, -1, 0],
            coordinate: q5 absolute,
            friction: 0.05,
        }
    }
}

mechanism! {
    /// Prismatic cart along x, pole about z.
    pub CartPole {
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, mass_matrix, bias, momentum, canonical, inverse_dynamics],
        body b1 on ground {
            mass: 2.0, com: [0, 0, 0],
            inertia: [0.1, 0.1, 0.1],
            joint: prismatic(x),
            coordinate: q1,
            friction: 0.2,
        }
        body b2 on b1 {
            mass: 0.4, com: [0, -0.6, 0],
            inertia: [0.05, 0.01, 0.05],
            joint: revolute(z),
            coordinate: q2,
            friction: 0.01,
        }
    }
}

mechanism! {
    /// Rotary arm about y (vertical), pendulum about the arm's x axis, full inertia.
    pub Furuta {
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, mass_matrix, bias, momentum, canonical, inverse_dynamics],
        body b1 on ground {
            mass: 0.3, com: [0.12, 0.01, 0.0],
            inertia: [0.012, 0.02, 0.017, 0.001, -0.002, 0.0015],
            joint: revolute(y),
            coordinate: q1,
            friction: 0.003,
        }
        body b2 on b1 {
            mass: 0.15, com: [0.02, -0.14, 0.01],
            inertia: [0.031, 0.027, 0.018, -0.004, 0.002, 0.003],
            joint: revolute(x) at [0.25, 0, 0],
            coordinate: q2,
            friction: 0.001,
        }
    }
}

mechanism! {
    /// Helical joint (pitch in m/rad) that carries a revolute one on a skew axis.
    pub ScrewJoint {
        gravity: [0, 0, -9.81],
        generate: [rhs, jacobian, energy, mass_matrix, bias, momentum, canonical, inverse_dynamics],
        body b1 on ground {
            mass: 1.1, com: [0.05, 0.02, 0.1],
            inertia: [0.031, 0.027, 0.018, -0.004, 0.002, 0.003],
            joint: helical(z, 0.07),
            coordinate: q1,
            friction: 0.02,
        }
        body b2 on b1 {
            mass: 0.6, com: [0.1, -0.05, 0.2],
            inertia: [0.012, 0.02, 0.017, 0.001, -0.002, 0.0015],
            joint: revolute([1, 2, -1]) at [0.2, 0.1, 0.3],
            coordinate: q2,
            friction: 0.01,
        }
    }
}

mechanism! {
    /// Spatial 3R arm.
    pub Elbow3 {
        gravity: [0, 0, -9.81],
        generate: [rhs, jacobian, energy, mass_matrix, bias, momentum, canonical, inverse_dynamics],
        body b1 on ground {
            mass: 3.0, com: [0.01, 0.02, 0.15],
            inertia: [0.03, 0.03, 0.02],
            joint: revolute(z),
            coordinate: q1,
            friction: 0.1,
        }
        body b2 on b1 {
            mass: 2.0, com: [0.2, 0.0, 0.01],
            inertia: [0.031, 0.027, 0.018, -0.004, 0.002, 0.003],
            joint: revolute(y) at [0, 0.1, 0.3],
            coordinate: q2,
            friction: 0.1,
        }
        body b3 on b2 {
            mass: 1.0, com: [0.15, -0.01, 0.0],
            inertia: [0.012, 0.02, 0.017, 0.001, -0.002, 0.0015],
            joint: revolute(y) at [0.4, 0, 0],
            coordinate: q3,
            friction: 0.05,
        }
    }
}

mechanism! {
    /// Branched: torso with two arms, one of them prismatic.
    pub Tree {
        gravity: [0, 0, -9.81],
        generate: [rhs, jacobian, energy, mass_matrix, bias, momentum, canonical, inverse_dynamics],
        body b1 on ground {
            mass: 4.0, com: [0, 0.05, -0.3],
            inertia: [0.031, 0.027, 0.018, -0.004, 0.002, 0.003],
            joint: revolute(x),
            coordinate: q1,
            friction: 0.1,
        }
        body b2 on b1 {
            mass: 1.0, com: [0.1, 0, -0.2],
            inertia: [0.012, 0.02, 0.017, 0.001, -0.002, 0.0015],
            joint: revolute(y) at [0.2, 0, -0.5],
            coordinate: q2,
            friction: 0.05,
        }
        body b3 on b1 {
            mass: 0.7, com: [0, 0.1, -0.1],
            inertia: [0.012, 0.02, 0.017, 0.001, -0.002, 0.0015],
            joint: prismatic([0, 1, 1]) at [-0.2, 0, -0.5],
            coordinate: q3,
            friction: 0.3,
        }
        body b4 on b2 {
            mass: 0.5, com: [0.0, 0.02, -0.1],
            inertia: [0.012, 0.02, 0.017, 0.001, -0.002, 0.0015],
            joint: revolute([0, 1, 2]) at [0, 0, -0.4],
            coordinate: q4,
            friction: 0.02,
        }
    }
}

mechanism! {
    /// Revolute, then prismatic along the arm (the elastic pendulum without its spring).
    pub SpringPendulumRig {
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, mass_matrix, bias, momentum, canonical, inverse_dynamics],
        body b1 on ground {
            mass: 0.2, com: [0, -0.1, 0],
            inertia: [0.01, 0.01, 0.002],
            joint: revolute(z),
            coordinate: q1,
            friction: 0.01,
        }
        body b2 on b1 {
            mass: 1.3, com: [0, -0.5, 0],
            inertia: [0.02, 0.02, 0.03],
            joint: prismatic(-y),
            coordinate: q2,
            friction: 0.4,
        }
    }
}
