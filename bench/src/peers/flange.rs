//! The flange of `testbed`'s UR5.

use pendulum_core::mechanism;

mechanism! {
    /// Universal Robots UR5, and where its flange is.
    pub Ur5Flange {
        generate: [],
        body b1 on ground {
            mass: 3.7, com: [0.0, 0.0, 0.0],
            inertia: [0.010267495893, 0.010267495893, 0.00666],
            joint: revolute(z) at [0.0, 0.0, 0.089159],
            coordinate: q1,
        }
        body b2 on b1 {
            mass: 8.393, com: [0.0, 0.0, 0.28],
            inertia: [0.22689067591, 0.22689067591, 0.0151074],
            joint: revolute(y) at [0.0, 0.13585, 0.0] rpy [0, pi/2, 0],
            coordinate: q2,
        }
        body b3 on b2 {
            mass: 2.275, com: [0.0, 0.0, 0.25],
            inertia: [0.049443313556, 0.049443313556, 0.004095],
            joint: revolute(y) at [0.0, -0.1197, 0.425],
            coordinate: q3,
        }
        body b4 on b3 {
            mass: 1.219, com: [0.0, 0.0, 0.0],
            inertia: [0.111172755531, 0.111172755531, 0.21942],
            joint: revolute(y) at [0.0, 0.0, 0.39225] rpy [0, pi/2, 0],
            coordinate: q4,
        }
        body b5 on b4 {
            mass: 1.219, com: [0.0, 0.0, 0.0],
            inertia: [0.111172755531, 0.111172755531, 0.21942],
            joint: revolute(z) at [0.0, 0.093, 0.0],
            coordinate: q5,
        }
        body b6 on b5 {
            mass: 0.1879, com: [0.0, 0.0, 0.0],
            inertia: [0.017136473145, 0.017136473145, 0.033822],
            joint: revolute(y) at [0.0, 0.0, 0.09465],
            coordinate: q6,
        }
        point flange on b6 at [0, 0.0823, 0],
        output flange: flange,
    }
}
