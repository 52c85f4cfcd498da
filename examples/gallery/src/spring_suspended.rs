//! # Body on a damped spring
//!
//! A rigid plate that hangs on a spring with a damper and is shaken by a force at the frequency `w` (references 7, 8
//! and 9). Straight below the hook it is a linear oscillator.

use pendulum_core::prelude::*;

use crate::{Check, Run};

mechanism! {
    /// A plate on a damped spring, free to move and to rotate in the plane.
    pub SpringSuspended {
        params {
            m: kg = 1, a: m = 0.3, b: m = 0.2, rest: m = 0.6,
            k: N/m = 60, c: N s/m = 0.8, f: N = 1.5, w: rad/s = 7,
        }
        gravity: [0, -9.81, 0],
        point hook on ground,
        point eye on block,
        spring between hook and eye: (k, rest),
        damper between hook and eye: c,
        force on eye: [0, f*cos(w*t), 0],
        body across on ground { joint: prismatic(x), coordinate: x }
        body down on across { joint: prismatic(y), coordinate: y }
        body block on down {
            solids: [plate(m, [[-b/2, 0], [-b/2, -a], [b/2, -a], [b/2, 0]])],
            joint: revolute(z), coordinate: phi,
        }
        generate: [rhs, jacobian, energy, shapes],
    }
}

/// Checks the amplitude at resonance and beside it, and the power of damper and force.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let params = SpringSuspendedParams::default();
    let SpringSuspendedParams { m, rest, k, c, f, .. } = params;
    let still = rest + m * 9.81 / k;
    let resonance = (k / m).sqrt();
    let amplitude = |w: f64| -> Result<f64, Box<dyn std::error::Error>> {
        let model = SpringSuspended::new(SpringSuspendedParams { w, ..params })?;
        let start = [0.0, -still, 0.0, 0.0, 0.0, 0.0];
        let solution = Vern9::new().rtol(1e-11).atol(1e-11).solve(&model, 0.0, 80.0, start)?;
        // Fourier coefficients over the last whole periods
        let (periods, samples) = (4.0, 400);
        let span = periods * std::f64::consts::TAU / w;
        let (mut cosine, mut sine) = (0.0, 0.0);
        for n in 0..samples {
            let t = 80.0 - span * f64::from(n) / f64::from(samples);
            let y = solution.at(t)?[SpringSuspended::Y] + still;
            cosine += 2.0 * y * (w * t).cos() / f64::from(samples);
            sine += 2.0 * y * (w * t).sin() / f64::from(samples);
        }
        Ok(cosine.hypot(sine))
    };
    let linear = |w: f64| f / (k - m * w * w).hypot(c * w);
    let mut checks = Vec::new();
    for (name, w) in [
        ("below", 0.8 * resonance),
        ("in", resonance),
        ("above", 1.3 * resonance),
    ] {
        let what = format!("amplitude {name} resonance, in m");
        checks.push(Check::new(what, amplitude(w)?, linear(w), 1e-8));
    }
    let model = SpringSuspended::new(params)?;
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 8.0, [0.5, -still, 0.4, 0.0, 0.0, 0.0])?;
    let powers = move |t: f64, x: &SVector<f64, 6>| {
        let length = x[0].hypot(x[1]);
        let rate = (x[0] * x[3] + x[1] * x[4]) / length;
        vec![-c * rate * rate, f * (7.0 * t).cos() * x[4]]
    };
    Run::new(checks, model, solution, powers, |drawing| drawing)
}
