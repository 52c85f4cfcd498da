//! # Slider-crank
//!
//! The engine: crank, rod and piston, with friction of the piston in its cylinder. The position of the piston follows
//! from the angle of the crank.

use pendulum_core::prelude::*;

use crate::{Check, Run, larger};

mechanism! {
    /// A crank of radius `r`, a rod of length `l`, and a piston.
    pub SliderCrank {
        params { r: m = 0.15, l: m = 0.4, m1: kg = 0.8, m2: kg = 0.3, m3: kg = 0.4, gamma: N s/m = 0.6 }
        gravity: [0, -9.81, 0],
        body crank on ground {
            solids: [disk(m1, 0.1, [0, 0, 0]), rod(0.1, [0, 0, 0], [r, 0, 0])],
            joint: revolute(z), coordinate: theta near 0.8,
        }
        body rod on crank {
            solids: [rod(m2, [0, 0, 0], [l, 0, 0])],
            joint: revolute(z) at [r, 0, 0], coordinate: phi absolute depends near -0.3,
        }
        body piston on ground {
            solids: [cuboid(m3, [0.1, 0.14, 0.1], [0.03, 0, 0])],
            joint: prismatic(x), coordinate: s depends near 0.5, friction: gamma,
        }
        close rod at [l, 0, 0] to piston: revolute(z),
        output stroke: s,
        output speed: dot(s),
        generate: [rhs, jacobian, energy, shapes],
    }
}

/// Checks position and speed of the piston from the angle of the crank, the Jacobian, and the power of friction.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let model = SliderCrank::new(SliderCrankParams::default())?;
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 2.0, [0.8, 25.0])?;
    let SliderCrankParams { r, l, gamma, .. } = SliderCrankParams::default();
    let (mut place, mut speed) = (0.0, 0.0);
    for (t, x) in solution.points() {
        let (sine, cosine) = x[0].sin_cos();
        let along = (l * l - r * r * sine * sine).sqrt();
        place = larger(place, (model.stroke(t, x) - (r * cosine + along)).abs());
        let known = -r * sine * (1.0 + r * cosine / along) * x[1];
        speed = larger(speed, (model.speed(t, x) - known).abs());
    }
    let checks = vec![
        Check::new("place of the piston, in m", place, 0.0, 1e-15),
        Check::new("its speed, in m/s", speed, 0.0, 1e-14),
        crate::jacobian_by_differences(&model, 0.0, [0.7, -3.0]),
    ];
    let powers = move |t: f64, x: &SVector<f64, 2>| vec![-gamma * model.speed(t, x).powi(2)];
    Run::new(checks, model, solution, powers, |drawing| drawing)
}
