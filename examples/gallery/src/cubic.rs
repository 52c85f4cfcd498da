//! # Cubic spring and cubic damping
//!
//! Two sliders connected by springs whose force has a linear and a cubic part, and by dampers whose force is
//! proportional to the cube of the rate (reference 10).

use pendulum_core::prelude::*;

use crate::{Check, Run};

mechanism! {
    /// Two sliders on cubic springs and dampers.
    pub Cubic {
        params { m1: kg = 1, m2: kg = 0.6, k: N/m = 4, k3: N/m^3 = 30, c3: N s^3/m^3 = 0.2 }
        let stretch = x2 - x1,
        let speed = dot(x2) - dot(x1),
        potential: k/2 * (x1^2 + stretch^2) + k3/4 * (x1^4 + stretch^4),
        dissipation: c3/4 * (dot(x1)^4 + speed^4),
        body left on ground {
            solids: [cuboid(m1, [0.3, 0.2, 0.2], [0, 0, 0])],
            joint: prismatic(x), coordinate: x1,
        }
        body right on ground {
            solids: [cuboid(m2, [0.2, 0.2, 0.2], [0, 0, 0])],
            joint: prismatic(x) at [0.8, 0, 0], coordinate: x2,
        }
        point hook on ground at [-0.6, 0, 0],
        point rear on left at [-0.15, 0, 0], point front on left at [0.15, 0, 0],
        point eye on right at [-0.1, 0, 0],
        generate: [rhs, energy, shapes],
    }
}

/// Checks the equation of motion by hand, and the power of the dampers: four times the dissipation.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let model = Cubic::new(CubicParams::default())?;
    let x = [0.3, -0.2, 0.8, -1.1];
    let (stretch, speed) = (x[1] - x[0], x[3] - x[2]);
    let spring = |s: f64| 4.0 * s + 30.0 * s.powi(3);
    let damper = |v: f64| 0.2 * v.powi(3);
    let between = spring(stretch) + damper(speed);
    let known = [between - spring(x[0]) - damper(x[2]), -between / 0.6];
    let rate = model.rhs(0.0, &x.into());
    let checks = vec![Check::same(
        "accelerations against the equation, in m/s^2",
        &rate.as_slice()[2..],
        &known,
        1e-14,
    )];
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 5.0, [0.25, -0.15, 0.0, 0.0])?;
    let lost = |_: f64, x: &SVector<f64, 4>| vec![-0.2 * x[2].powi(4), -0.2 * (x[3] - x[2]).powi(4)];
    Run::new(checks, model, solution, lost, |drawing| {
        drawing
            .wall([-0.6, 0.2, 0.0], [-0.6, -0.2, 0.0])
            .spring("hook", "rear")
            .spring("front", "eye")
    })
}
