//! # Cart-pole
//!
//! A pole on a cart, with friction in both joints.

use pendulum_core::prelude::*;

use crate::{Check, Run};

mechanism! {
    /// A pole on a cart.
    pub CartPole {
        gravity: [0, -9.81, 0],
        body cart on ground {
            solids: [cuboid(2, [0.5, 0.2, 0.2], [0, 0, 0])],
            joint: prismatic(x), coordinate: s, friction: 0.2,
        }
        body pole on cart {
            mass: 0.4, com: [0, -0.6, 0], inertia: 0.05,
            joint: revolute(z), coordinate: theta, friction: 0.01,
        }
        point tip on pole at [0, -1.2, 0],
        output tip: tip,
        generate: [rhs, energy, mass_matrix, shapes],
    }
}

/// Checks reference data to 20 digits, the tip against its closed form, and the power of friction.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let model = CartPole::new(CartPoleParams {})?;
    let x = SVector::from([-1.678, -0.203, 0.297, 2.3_f64]);
    let rate = model.rhs(0.0, &x);
    let known = [-0.407_842_499_518_734_5, 2.822_369_412_008_145_4];
    let tip = [x[0] + 1.2 * x[1].sin(), -1.2 * x[1].cos(), 0.0];
    let speed = [x[2] + 1.2 * x[1].cos() * x[3], 1.2 * x[1].sin() * x[3], 0.0];
    let checks = vec![
        Check::same(
            "accelerations against reference data",
            &rate.as_slice()[2..],
            &known,
            1e-14,
        ),
        Check::same("position of the tip, in m", model.tip(0.0, &x).as_slice(), &tip, 1e-15),
        Check::same(
            "velocity of the tip, in m/s",
            model.tip_rate(0.0, &x).as_slice(),
            &speed,
            1e-15,
        ),
    ];
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 5.0, [0.0, 2.8, 0.0, 0.0])?;
    let lost = |_: f64, x: &SVector<f64, 4>| vec![-0.2 * x[2].powi(2), -0.01 * x[3].powi(2)];
    Run::new(checks, model, solution, lost, |drawing| drawing)
}
