//! # Point masses on a double pendulum
//!
//! Two masses on massless rods, the double pendulum of the textbooks (references 1 and 2 of the paper). From (2, 2.5)
//! rad it is chaotic.

use pendulum_core::prelude::*;
use pendulum_core::stability::Lyapunov;

use crate::{Check, Run, double_pendulum};

mechanism! {
    /// Two point masses on massless rods.
    pub PointMasses {
        params { m1: kg = 1, m2: kg = 1, l1: m = 1, l2: m = 1, g: m/s^2 = 9.81 }
        gravity: [0, -g, 0],
        body upper on ground { solids: [point(m1, [0, -l1, 0])], joint: revolute(z), coordinate: theta1 absolute }
        body lower on upper {
            solids: [point(m2, [0, -l2, 0])],
            joint: revolute(z) at [0, -l1, 0],
            coordinate: theta2 absolute,
        }
        point bob on lower at [0, -l2, 0],
        generate: [rhs, jacobian, energy, shapes],
    }
}

/// Checks the known formula, the largest Lyapunov exponent, and the energy.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let params = PointMassesParams {
        m2: 0.7,
        l2: 1.3,
        ..Default::default()
    };
    let uneven = PointMasses::new(params)?;
    let x = [0.8, -0.5, 1.2, 2.1];
    let rate = uneven.rhs(0.0, &x.into());
    let known = double_pendulum([1.0, 1.0, 0.0, 0.0], [0.7, 1.3, 0.0, 0.0], 1.0, 9.81, x);
    let model = PointMasses::new(PointMassesParams::default())?;
    let start = [2.0, 2.5, 0.0, 0.0];
    let exponent = Lyapunov::new()
        .transient(20.0)
        .duration(1000.0)
        .largest(&model, start)?;
    let checks = vec![
        Check::same(
            "accelerations against the formula, in rad/s^2",
            &rate.as_slice()[2..],
            &known,
            1e-13,
        ),
        Check::new("largest Lyapunov exponent, per s", exponent.values[0], 1.45, 0.05),
    ];
    let solution = Vern9::new().rtol(1e-12).atol(1e-12).solve(&model, 0.0, 6.0, start)?;
    Run::new(checks, model, solution, |_, _| vec![], |drawing| drawing)
}
