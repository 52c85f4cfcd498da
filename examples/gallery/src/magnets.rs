//! # Magnets in both bodies
//!
//! A double pendulum with a magnet at the end of each body, above two fixed magnets (reference 18). The potential of a
//! pair of magnets decreases with the cube of their distance.

use pendulum_core::prelude::*;

use crate::{Run, jacobian_by_differences};

mechanism! {
    /// Two rods with magnets at their ends, above two magnets.
    pub Magnets {
        params { m: kg = 0.2, l: m = 0.3, k: N m^4 = 2e-4, gamma: N m s = 2e-4 }
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(m, [0, 0, 0], [0, -l, 0])] }
        body upper on ground: arm { joint: revolute(z), coordinate: theta1, friction: gamma }
        body lower on upper: arm { joint: revolute(z) at [0, -l, 0], coordinate: theta2, friction: gamma }
        point first on upper at [0, -l, 0],
        point second on lower at [0, -l, 0],
        point left on ground at [-0.15, -0.66, 0],
        point right on ground at [0.2, -0.66, 0],
        let pull = 1/distance(second, left)^3 + 1/distance(second, right)^3,
        let push = 1/distance(first, left)^3 + 1/distance(first, right)^3,
        potential: k * (push - pull),
        generate: [rhs, jacobian, energy, shapes],
    }
}

/// Checks the Jacobian by differences, the slope of the potential, and the power of friction.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let model = Magnets::new(MagnetsParams::default())?;
    let checks = vec![jacobian_by_differences(&model, 0.0, [0.4, -0.3, 1.0, -2.0])];
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 6.0, [1.4, 0.3, 0.0, 0.0])?;
    let lost = |_: f64, x: &SVector<f64, 4>| vec![-2e-4 * x[2].powi(2), -2e-4 * x[3].powi(2)];
    Run::new(checks, model, solution, lost, |drawing| drawing)
}
