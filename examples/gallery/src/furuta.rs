//! # Furuta pendulum
//!
//! An arm that turns about the vertical carries a pendulum that turns about the arm. Both bodies have a full inertia.

use pendulum_core::prelude::*;

use crate::{Check, Run};

mechanism! {
    /// A pendulum on a rotary arm; y points upward.
    pub Furuta {
        gravity: [0, -9.81, 0],
        body arm on ground {
            mass: 0.3, com: [0.12, 0.01, 0], inertia: [0.012, 0.02, 0.017, 0.001, -0.002, 0.0015],
            joint: revolute(y), coordinate: phi, friction: 0.003,
        }
        body pendulum on arm {
            mass: 0.15, com: [0.02, -0.14, 0.01], inertia: [0.031, 0.027, 0.018, -0.004, 0.002, 0.003],
            joint: revolute(x) at [0.25, 0, 0], coordinate: theta, friction: 0.001,
        }
        point tip on pendulum at [0, -0.28, 0],
        output tip: tip,
        generate: [rhs, energy, shapes],
    }
}

/// Checks reference data to 20 digits, the tip against its closed form, and the power of friction.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let model = Furuta::new(FurutaParams {})?;
    let x = SVector::from([0.356, -0.949, -2.975, -0.486_f64]);
    let known = [-0.271_240_908_178_652_4, 6.235_112_200_085_53];
    // rotation about y by phi, after a rotation about x by theta
    let ((sp, cp), (st, ct)) = (x[0].sin_cos(), x[1].sin_cos());
    let [across, up, along] = [0.25, -0.28 * ct, -0.28 * st];
    let tip = [cp * across + sp * along, up, cp * along - sp * across];
    let checks = vec![
        Check::same(
            "accelerations against reference data",
            &model.rhs(0.0, &x).as_slice()[2..],
            &known,
            1e-13,
        ),
        Check::same("position of the tip, in m", model.tip(0.0, &x).as_slice(), &tip, 1e-15),
    ];
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 4.0, [0.0, 2.6, 2.0, 0.0])?;
    let lost = |_: f64, x: &SVector<f64, 4>| vec![-0.003 * x[2].powi(2), -0.001 * x[3].powi(2)];
    Run::new(checks, model, solution, lost, |drawing| {
        drawing.seen_from([0.5, 0.45, 1.0], [0.0, 1.0, 0.0])
    })
}
