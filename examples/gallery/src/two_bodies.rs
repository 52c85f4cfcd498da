//! # Two different bodies
//!
//! The compound double pendulum of the paper with two different bodies, friction in both axles, and centres of mass
//! beside the lines of the axles (Section 6).

use pendulum_core::prelude::*;

use crate::{Check, Run, double_pendulum};

mechanism! {
    /// Two different bodies with friction in both axles.
    pub TwoBodies {
        params {
            m1: kg = 1.7, c1: m = 0.43, i1: kg m^2 = 0.31, gamma1: N m s = 0.05,
            m2: kg = 0.8, c2: m = 0.55, i2: kg m^2 = 0.12, gamma2: N m s = 0.02,
            d: m = 0.9, side: m = 0.1, g: m/s^2 = 9.81,
        }
        gravity: [0, -g, 0],
        body upper on ground {
            mass: m1, com: [side, -c1, 0], inertia: i1,
            joint: revolute(z), coordinate: theta1 absolute, friction: gamma1,
        }
        body lower on upper {
            mass: m2, com: [-side, -c2, 0], inertia: i2,
            joint: revolute(z) at [0, -d, 0], coordinate: theta2 absolute, friction: gamma2,
        }
        point tip on lower at [0, -2*c2, 0],
        generate: [rhs, energy, shapes],
    }
}

/// Checks the general formula, and the power of friction.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let params = TwoBodiesParams::default();
    let frictionless = TwoBodies::new(TwoBodiesParams {
        gamma1: 0.0,
        gamma2: 0.0,
        side: 0.0,
        ..params
    })?;
    let x = [1.2, -0.4, 0.3, -1.1];
    let rate = frictionless.rhs(0.0, &x.into());
    let known = double_pendulum([1.7, 0.43, 0.31, 0.0], [0.8, 0.55, 0.12, 0.0], 0.9, 9.81, x);
    let checks = vec![Check::same(
        "accelerations against the formula, in rad/s^2",
        &rate.as_slice()[2..],
        &known,
        1e-13,
    )];
    let model = TwoBodies::new(params)?;
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 6.0, [2.2, 0.4, 0.0, 0.0])?;
    let lost = |_: f64, x: &SVector<f64, 4>| vec![-0.05 * x[2].powi(2), -0.02 * (x[3] - x[2]).powi(2)];
    Run::new(checks, model, solution, lost, |drawing| drawing)
}
