//! # Coupled pendulums in a field that varies
//!
//! Two pendulums with magnetic moments, tied by an elastic band, in an oscillating field (reference 19).

use pendulum_core::prelude::*;

use crate::{Check, Run, frequencies, jacobian_by_differences};

mechanism! {
    /// Two equal rods side by side, with a spring between them and magnets at their ends.
    pub Coupled {
        params {
            m: kg = 0.5, l: m = 0.8, apart: m = 0.4, k: N/m = 6, gamma: N m s = 0.01,
            moment: N m = 0.4, w: rad/s = 3,
        }
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(m, [0, 0, 0], [0, -l, 0])] }
        body left on ground: arm { joint: revolute(z), coordinate: theta1, friction: gamma }
        body right on ground: arm { joint: revolute(z) at [apart, 0, 0], coordinate: theta2, friction: gamma }
        point a on left at [0, -l/2, 0],
        point b on right at [0, -l/2, 0],
        spring between a and b: (k, apart),
        potential: -moment * sin(w*t) * (sin(theta1) - sin(theta2)),
        generate: [rhs, jacobian, energy, shapes],
    }
}

/// Checks the modes of the two, the Jacobian by differences, and the power of friction and of the field.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let params = CoupledParams::default();
    let CoupledParams { m, l, k, moment, w, .. } = params;
    let free = Coupled::new(CoupledParams {
        gamma: 0.0,
        moment: 0.0,
        ..params
    })?;
    // about rest: in phase like one rod; in antiphase with the spring at half of the length
    let (inertia, weight) = (m * l * l / 3.0, m * 9.81 * l / 2.0);
    let known = [weight / inertia, (weight + k * l * l / 2.0) / inertia].map(f64::sqrt);
    let model = Coupled::new(params)?;
    let checks = vec![
        Check::same("modes, in rad/s", &frequencies(&free, [0.0; 4])?, &known, 1e-12),
        jacobian_by_differences(&model, 0.7, [0.4, -0.3, 1.0, -2.0]),
    ];
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 8.0, [0.9, 0.0, 0.0, 0.0])?;
    let powers = move |t: f64, x: &SVector<f64, 4>| {
        let field = -moment * w * (w * t).cos() * (x[0].sin() - x[1].sin());
        vec![-0.01 * x[2].powi(2), -0.01 * x[3].powi(2), field]
    };
    Run::new(checks, model, solution, powers, |drawing| drawing)
}
