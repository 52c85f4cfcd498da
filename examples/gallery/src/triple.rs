//! # Triple pendulum
//!
//! A compound double pendulum that carries a rod (reference 14), with friction in all axles.

use pendulum_core::prelude::*;

use crate::{Check, Run};

mechanism! {
    /// A double rigid body and a rod.
    pub Triple {
        gravity: [0, -9.81, 0],
        body first on ground {
            mass: 1, com: [0, -0.5, 0], inertia: 0.08,
            joint: revolute(z), coordinate: theta1 absolute, friction: 0.01,
        }
        body second on first {
            mass: 0.7, com: [0, -0.4, 0], inertia: 0.05,
            joint: revolute(z) at [0, -1, 0], coordinate: theta2 absolute, friction: 0.01,
        }
        body rod on second {
            mass: 0.5, com: [0, -0.3, 0], inertia: 0.02,
            joint: revolute(z) at [0, -0.8, 0], coordinate: theta3 absolute, friction: 0.01,
        }
        point tip on rod at [0, -0.6, 0],
        generate: [rhs, energy, shapes],
    }
}

/// Checks the state after 5 s against independent integration to 24 digits, and the power of friction.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let model = Triple::new(TripleParams {})?;
    let solution = Vern9::new()
        .rtol(1e-13)
        .atol(1e-13)
        .solve(&model, 0.0, 5.0, [0.9, 0.2, -0.6, 0.0, 0.5, 0.0])?;
    let known = [
        0.172_505_338_091_726_8,
        0.837_506_396_938_219,
        1.622_884_967_162_310_2,
        -0.548_040_528_020_920_7,
        2.022_151_408_275_248,
        -0.440_763_318_266_770_9,
    ];
    let checks = vec![Check::same("state after 5 s", solution.end().as_slice(), &known, 1e-10)];
    let lost = |_: f64, x: &SVector<f64, 6>| {
        vec![
            -0.01 * x[3].powi(2),
            -0.01 * (x[4] - x[3]).powi(2),
            -0.01 * (x[5] - x[4]).powi(2),
        ]
    };
    Run::new(checks, model, solution, lost, |drawing| drawing)
}
