//! # Andrews' squeezing mechanism
//!
//! Seven bodies, three loops, and one degree of freedom: the benchmark of multibody programs (Schiehlen 1990; IVP test
//! set, release 2.4). A motor on the smallest body drives it. All three loops are triangles, one after another, so its
//! state has two numbers.

use pendulum_core::prelude::*;

use crate::{Check, Run, larger};

mechanism! {
    /// Data as published, with the angle names of the test set.
    pub Squeezer {
        body k1 on ground { mass: 0.04325, com: [0.00092, 0, 0], inertia: 2.194e-6,
            joint: revolute(z), coordinate: beta near -0.0617, torque: 0.033 }
        body k2 on k1 { mass: 0.00365, com: [-0.0115, 0, 0], inertia: 4.41e-7,
            joint: revolute(z) at [0.007, 0, 0], coordinate: theta depends near 0 }
        body k3 on ground { mass: 0.02373, com: [0.01043, -0.01874, 0], inertia: 5.255e-6,
            joint: revolute(z) at [-0.03635, 0.03273, 0], coordinate: gamma depends near 0.455 }
        body k4 on ground { mass: 0.0705, com: [0.02308, 0.00916, 0], inertia: 1.169e-5,
            joint: revolute(z) at [-0.06934, -0.00227, 0], coordinate: delta depends near 0.487 }
        body k5 on k4 { mass: 0.00706, com: [0, -0.00579, 0], inertia: 5.667e-7,
            joint: revolute(z) at [0.04, 0, 0], coordinate: phi depends near 0.223 }
        body k6 on ground { mass: 0.05498, com: [0.01228, -0.00449, 0], inertia: 1.912e-5,
            joint: revolute(z) at [-0.06934, -0.00227, 0], coordinate: epsilon depends near 1.23 }
        body k7 on k6 { mass: 0.00706, com: [0.00579, 0, 0], inertia: 5.667e-7,
            joint: revolute(z) at [0, -0.04, 0], coordinate: omega depends near -0.223 }
        close k2 at [-0.028, 0, 0] to k3 at [0, -0.035, 0]: revolute(z),
        close k2 at [-0.028, 0, 0] to k5 at [0, -0.02, 0]: revolute(z),
        close k2 at [-0.028, 0, 0] to k7 at [0.02, 0, 0]: revolute(z),
        point c on ground at [0.014, 0.072, 0], point d on k3 at [0.02, -0.018, 0],
        spring between d and c: (4530, 0.07785),
        point e on k2 at [-0.028, 0, 0], point f on k7 at [0.02, 0, 0],
        output gap: [e.x - f.x, e.y - f.y],
        output follow: [gamma, delta, phi],
        generate: [rhs, jacobian, energy, shapes],
    }
}

/// Checks the end of the published motion, the closed loops, the Jacobian, and the power of the motor.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    /// Angles beta, gamma, delta and phi at 0.03 s; the test set gives them to ten digits.
    const END: [f64; 4] = [
        15.810_771_195_153_71,
        0.040_822_240_119_645_8,
        0.524_409_965_879_954_1,
        -0.534_730_116_342_079_6,
    ];
    let model = Squeezer::new(SqueezerParams::default())?;
    let start = [-0.061_713_890_014_276_45, 0.0];
    let solution = Vern9::new().rtol(1e-13).atol(1e-13).solve(&model, 0.0, 0.03, start)?;
    let (t, x) = solution.last();
    let follow = model.follow(t, &x);
    let mut open = 0.0;
    for (t, x) in solution.points() {
        open = larger(open, model.gap(t, x).amax());
    }
    let checks = vec![
        Check::same(
            "angles at 0.03 s, in rad",
            &[x[0], follow[0], follow[1], follow[2]],
            &END,
            1e-11,
        ),
        Check::new("ends of the last loop apart, in m", open, 0.0, 1e-15),
        crate::jacobian_by_differences(&model, 0.0, [0.7, 30.0]),
    ];
    let powers = |_: f64, x: &SVector<f64, 2>| vec![0.033 * x[1]];
    Run::new(checks, model, solution, powers, |drawing| drawing.speed(0.01))
}
