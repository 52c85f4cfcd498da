//! Declarations of the closed loops of `testbed/data/loops.json`.
//!
//! Each has two outputs: `following`, the coordinates determined by the loops, and `gaps`, the distances between the
//! two ends of each loop.

use pendulum_core::mechanism;

mechanism! {
    /// A crank, a coupler and a rocker.
    pub FourBar {
        gravity: [0, -9.81, 0],
        body crank on ground {
            mass: 0.5, com: [0.1, 0, 0], inertia: 0.001666666666666667,
            joint: revolute(z), coordinate: theta near 0.8, friction: 0.02,
        }
        body coupler on crank {
            mass: 1.1, com: [0.25, 0, 0], inertia: 0.02291666666666667,
            joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3,
        }
        body rocker on ground {
            mass: 0.9, com: [0.2, 0, 0], inertia: 0.012,
            joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6, friction: 0.05,
        }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
        point of_coupler on coupler at [0.5, 0, 0],
        point of_rocker on rocker at [0.4, 0, 0],
        output following: [phi, psi],
        output following_rates: [dot(phi), dot(psi)],
        output gaps: [of_coupler.x - of_rocker.x, of_coupler.y - of_rocker.y],
        generate: [rhs, jacobian, energy, mass_matrix, momentum, canonical, taylor, inverse_dynamics],
    }
}

mechanism! {
    /// An engine: a crank, a rod and a piston with friction.
    pub SliderCrank {
        gravity: [0, -9.81, 0],
        body crank on ground {
            mass: 0.36, com: [0.0765, 0, 0], inertia: 0.000702,
            joint: revolute(z), coordinate: theta near 0.8,
        }
        body rod on crank {
            mass: 0.151, com: [0.153, 0, 0], inertia: 0.001178253,
            joint: revolute(z) at [0.153, 0, 0], coordinate: phi depends near -1.1,
        }
        body piston on ground {
            mass: 0.0755, joint: prismatic(x), coordinate: s depends near 0.4, friction: 1.5,
        }
        close rod at [0.306, 0, 0] to piston: revolute(z),
        point of_rod on rod at [0.306, 0, 0],
        point of_piston on piston,
        output following: [phi, s],
        output following_rates: [dot(phi), dot(s)],
        output gaps: [of_rod.x - of_piston.x, of_rod.y - of_piston.y],
        generate: [rhs, jacobian, energy, mass_matrix, momentum, canonical, taylor, inverse_dynamics],
    }
}

mechanism! {
    /// Two cranks that carry a common point on two bars.
    pub FiveBar {
        gravity: [0, -9.81, 0],
        body left on ground {
            mass: 0.4, com: [0.125, 0, 0], inertia: 0.0020833333333333333,
            joint: revolute(z), coordinate: a near 2.2, friction: 0.01,
        }
        body left_bar on left {
            mass: 0.3, com: [0.175, 0, 0], inertia: 0.0030624999999999997,
            joint: revolute(z) at [0.25, 0, 0], coordinate: b depends near -1.7,
        }
        body right on ground {
            mass: 0.4, com: [0.125, 0, 0], inertia: 0.0020833333333333333,
            joint: revolute(z) at [0.3, 0, 0], coordinate: c near 0.9, friction: 0.01,
        }
        body right_bar on right {
            mass: 0.3, com: [0.175, 0, 0], inertia: 0.0030624999999999997,
            joint: revolute(z) at [0.25, 0, 0], coordinate: d depends near 1.7,
        }
        close left_bar at [0.35, 0, 0] to right_bar at [0.35, 0, 0]: revolute(z),
        point of_left on left_bar at [0.35, 0, 0],
        point of_right on right_bar at [0.35, 0, 0],
        output following: [b, d],
        output following_rates: [dot(b), dot(d)],
        output gaps: [of_left.x - of_right.x, of_left.y - of_right.y],
        generate: [rhs, jacobian, energy, mass_matrix, momentum, canonical, taylor, inverse_dynamics],
    }
}

mechanism! {
    /// Andrews' squeezing mechanism: seven bodies, three loops, one degree of freedom (IVP test set, release 2.4).
    pub Andrews {
        body k1 on ground {
            mass: 0.04325, com: [0.00092, 0, 0], inertia: 2.194e-6,
            joint: revolute(z), coordinate: beta near -0.0617, torque: 0.033,
        }
        body k2 on k1 {
            mass: 0.00365, com: [-0.0115, 0, 0], inertia: 4.41e-7,
            joint: revolute(z) at [0.007, 0, 0], coordinate: theta depends near 0,
        }
        body k3 on ground {
            mass: 0.02373, com: [0.01043, -0.01874, 0], inertia: 5.255e-6,
            joint: revolute(z) at [-0.03635, 0.03273, 0], coordinate: gamma depends near 0.455,
        }
        body k4 on ground {
            mass: 0.0705, com: [0.02308, 0.00916, 0], inertia: 1.169e-5,
            joint: revolute(z) at [-0.06934, -0.00227, 0], coordinate: delta depends near 0.487,
        }
        body k5 on k4 {
            mass: 0.00706, com: [0, -0.00579, 0], inertia: 5.667e-7,
            joint: revolute(z) at [0.04, 0, 0], coordinate: phi depends near 0.223,
        }
        body k6 on ground {
            mass: 0.05498, com: [0.01228, -0.00449, 0], inertia: 1.912e-5,
            joint: revolute(z) at [-0.06934, -0.00227, 0], coordinate: epsilon depends near 1.23,
        }
        body k7 on k6 {
            mass: 0.00706, com: [0.00579, 0, 0], inertia: 5.667e-7,
            joint: revolute(z) at [0, -0.04, 0], coordinate: omega depends near -0.223,
        }
        close k2 at [-0.028, 0, 0] to k3 at [0, -0.035, 0]: revolute(z),
        close k2 at [-0.028, 0, 0] to k5 at [0, -0.02, 0]: revolute(z),
        close k2 at [-0.028, 0, 0] to k7 at [0.02, 0, 0]: revolute(z),
        point d on k3 at [0.02, -0.018, 0],
        point c on ground at [0.014, 0.072, 0],
        spring between d and c: (4530, 0.07785),
        point of_2 on k2 at [-0.028, 0, 0],
        point of_3 on k3 at [0, -0.035, 0],
        point of_5 on k5 at [0, -0.02, 0],
        point of_7 on k7 at [0.02, 0, 0],
        output following: [theta, gamma, delta, phi, epsilon, omega],
        output following_rates: [dot(theta), dot(gamma), dot(delta), dot(phi), dot(epsilon), dot(omega)],
        output gaps: [
            of_2.x - of_3.x, of_2.y - of_3.y, of_2.x - of_5.x, of_2.y - of_5.y, of_2.x - of_7.x, of_2.y - of_7.y,
        ],
        generate: [rhs, jacobian, energy, mass_matrix, momentum, canonical, taylor, inverse_dynamics],
    }
}

mechanism! {
    /// A parallelogram, which is flat (singular) twice per turn.
    pub Parallelogram {
        generate: [rhs, jacobian, energy, taylor, canonical],
        gravity: [0, -9.81, 0],
        body left on ground { solids: [rod(1, [0, 0, 0], [0, 1, 0])], joint: revolute(z), coordinate: alpha near 0.1 }
        body beam on left {
            solids: [rod(1, [0, 0, 0], [1, 0, 0])], joint: revolute(z) at [0, 1, 0], coordinate: beta depends near -0.1,
        }
        body right on ground {
            solids: [rod(1, [0, 0, 0], [0, 1, 0])], joint: revolute(z) at [1, 0, 0], coordinate: p depends near 0.1,
        }
        close beam at [1, 0, 0] to right at [0, 1, 0]: revolute(z),
        output margin: margin(beam, right),
        output angles: [beta, p],
        event flat: margin(beam, right) - 0.01,
    }
}
