//! # Kapitza's pendulum
//!
//! A pendulum whose pivot is shaken up and down fast enough is stable upright: if `(a w)^2 > 2 g l` (P. L. Kapitza
//! 1951), for small amplitudes `a` of the pivot.

use pendulum_core::prelude::*;

use crate::{Check, Run};

mechanism! {
    /// A point mass on a massless rod, below a pivot that is shaken.
    pub Kapitza {
        params { m: kg = 0.3, l: m = 0.5, a: m = 0.01, w: rad/s = 400, gamma: N m s = 0.01 }
        gravity: [0, -9.81, 0],
        body pivot on ground { joint: prismatic(y), motion: a*cos(w*t) }
        body rod on pivot {
            solids: [point(m, [0, -l, 0])],
            joint: revolute(z), coordinate: theta, friction: gamma,
        }
        point bob on rod at [0, -l, 0],
        generate: [rhs, jacobian, energy, drive_forces, shapes],
    }
}

/// Checks that it stands above the threshold and falls below it, and the power of friction and of the pivot.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let params = KapitzaParams::default();
    let KapitzaParams { l, a, w, gamma, .. } = params;
    let threshold = (2.0 * 9.81 * l).sqrt() / a;
    let upright = std::f64::consts::PI;
    // largest angle from upright within 6 s, starting at 0.05 rad
    let strays = |w: f64| -> Result<f64, Box<dyn std::error::Error>> {
        let model = Kapitza::new(KapitzaParams { w, ..params })?;
        let solution = Vern7::new()
            .rtol(1e-9)
            .atol(1e-9)
            .solve(&model, 0.0, 6.0, [upright - 0.05, 0.0])?;
        let angles = solution.x().iter().map(|x| (x[Kapitza::THETA] - upright).abs());
        Ok(angles.fold(0.0, f64::max))
    };
    let (stands, falls) = (strays(1.1 * threshold)?, strays(0.9 * threshold)?);
    let checks = vec![
        Check::new(
            "furthest from the top at 1.1 of the threshold, in rad",
            stands,
            0.05,
            0.01,
        ),
        Check::new(
            "falls through the bottom at 0.9 of it (1: yes)",
            f64::from(u8::from(falls > upright)),
            1.0,
            0.0,
        ),
    ];
    let model = Kapitza::new(params)?;
    let solution = Vern9::new()
        .rtol(1e-11)
        .atol(1e-11)
        .solve(&model, 0.0, 1.5, [upright - 0.6, 0.0])?;
    let powers = move |t: f64, x: &SVector<f64, 2>| {
        let forces = model.drive_forces(t, x);
        vec![-gamma * x[1] * x[1], -forces[0] * a * w * (w * t).sin()]
    };
    Run::new(checks, model, solution, powers, |drawing| drawing)
}
