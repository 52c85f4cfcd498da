//! Declarations of the robots of `testbed/data/robots.json`.

use pendulum_core::mechanism;

mechanism! {
    /// Universal Robots UR5: six revolute joints.
    pub Ur5 {
        gravity: [0, 0, -9.81],
        generate: [rhs, jacobian, energy, mass_matrix, bias, momentum, inverse_dynamics, taylor],
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
    }
}

mechanism! {
    /// Joints of the UR5, and the pose of its flange.
    pub Ur5Flange {
        generate: [],
        body b1 on ground { joint: revolute(z) at [0.0, 0.0, 0.089159], coordinate: q1 }
        body b2 on b1 { joint: revolute(y) at [0.0, 0.13585, 0.0] rpy [0, pi/2, 0], coordinate: q2 }
        body b3 on b2 { joint: revolute(y) at [0.0, -0.1197, 0.425], coordinate: q3 }
        body b4 on b3 { joint: revolute(y) at [0.0, 0.0, 0.39225] rpy [0, pi/2, 0], coordinate: q4 }
        body b5 on b4 { joint: revolute(z) at [0.0, 0.093, 0.0], coordinate: q5 }
        body b6 on b5 { joint: revolute(y) at [0.0, 0.0, 0.09465], coordinate: q6 }
        point flange on b6 at [0, 0.0823, 0],
        output flange: flange,
    }
}

mechanism! {
    /// Franka Emika Panda: seven revolute joints.
    pub Panda {
        gravity: [0, 0, -9.81],
        generate: [rhs, jacobian, energy, mass_matrix, bias, momentum, inverse_dynamics, taylor],
        body b1 on ground {
            mass: 4.970684, com: [0.003875, 0.002081, -0.04762],
            inertia: [0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.019169],
            joint: revolute(z) at [0.0, 0.0, 0.333],
            coordinate: q1,
        }
        body b2 on b1 {
            mass: 0.646926, com: [-0.003141, -0.02872, 0.003495],
            inertia: [0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704],
            joint: revolute(z) rpy [-pi/2, 0, 0],
            coordinate: q2,
        }
        body b3 on b2 {
            mass: 3.228604, com: [0.027518, 0.039252, -0.066502],
            inertia: [0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805],
            joint: revolute(z) at [0.0, -0.316, 0.0] rpy [pi/2, 0, 0],
            coordinate: q3,
        }
        body b4 on b3 {
            mass: 3.587895, com: [-0.05317, 0.104419, 0.027454],
            inertia: [0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641],
            joint: revolute(z) at [0.0825, 0.0, 0.0] rpy [pi/2, 0, 0],
            coordinate: q4,
        }
        body b5 on b4 {
            mass: 1.225946, com: [-0.011953, 0.041065, -0.038437],
            inertia: [0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229],
            joint: revolute(z) at [-0.0825, 0.384, 0.0] rpy [-pi/2, 0, 0],
            coordinate: q5,
        }
        body b6 on b5 {
            mass: 1.666555, com: [0.060149, -0.014117, -0.010517],
            inertia: [0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341],
            joint: revolute(z) rpy [pi/2, 0, 0],
            coordinate: q6,
        }
        body b7 on b6 {
            mass: 1.495522, com: [0.001720874298, 0.001360354417, 0.100485281149],
            inertia: [0.016529853713, 0.014107248642, 0.006676955557, 0.000394892297, -0.000706695711, -0.001051105327],
            joint: revolute(z) at [0.088, 0.0, 0.0] rpy [pi/2, 0, 0],
            coordinate: q7,
        }
    }
}
