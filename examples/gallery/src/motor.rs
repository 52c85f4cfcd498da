//! # A motor with an armature
//!
//! A pendulum on a direct-current motor under a constant voltage. The current through the armature is a first-order
//! state: it follows the voltage with the inductance of the coils, and the turning rotor induces a voltage against it.

use pendulum_core::prelude::*;
use pendulum_core::stability;

use crate::{Check, Run};

mechanism! {
    /// A rotor with a rod, and the current that turns it.
    pub Motor {
        params {
            v: V = 6, r: ohm = 1.2, ind: H = 0.05, k: N m/A = 0.11, gamma: N m s = 0.01,
            m: kg = 0.2, l: m = 0.4,
        }
        gravity: [0, -9.81, 0],
        /// Current through the armature.
        state i { unit: A, rate: (v - r*i - k*dot(theta))/ind }
        body rotor on ground {
            solids: [disk(0.5, 0.06, [0, 0, 0]), rod(m, [0, 0, 0], [0, -l, 0])],
            joint: revolute(z), coordinate: theta, torque: k*i, friction: gamma,
        }
        point tip on rotor at [0, -l, 0],
        output heat: r*i^2,
        generate: [rhs, jacobian, energy, shapes],
    }
}

/// Checks the equations by hand, the current and the angle at rest, and the energy that the voltage supplies.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let model = Motor::new(MotorParams::default())?;
    let MotorParams {
        v,
        r,
        ind,
        k,
        gamma,
        m,
        l,
    } = *model.params();
    let inertia = 0.5 * 0.5 * 0.06 * 0.06 + m * l * l / 3.0;
    let weight = 0.5 * m * 9.81 * l;
    let x = [0.4, 3.0, 2.0];
    let torque = k * x[2] - gamma * x[1] - weight * f64::sin(x[0]);
    let known = [x[1], torque / inertia, (v - r * x[2] - k * x[1]) / ind];
    let rates = model.rhs(0.0, &x.into());
    // a fifth of the voltage holds the pendulum
    let held = model.with_params(MotorParams {
        v: 0.2 * v,
        ..*model.params()
    })?;
    let rest = stability::equilibrium(&held, [0.2, 0.0, 1.0])?;
    let current = 0.2 * v / r;
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 2.0, [0.0, 0.0, 0.0])?;
    // the voltage supplies what becomes heat, friction, energy of the coils and of the rotor
    let supplied = integral(&solution, |x| v * x[Motor::I]);
    let lost = integral(&solution, |x| {
        r * x[Motor::I].powi(2) + gamma * x[Motor::DOT_THETA].powi(2)
    });
    let end = solution.end();
    let stored = 0.5 * ind * end[Motor::I].powi(2) + model.energy(2.0, &end) - model.energy(0.0, &[0.0; 3]);
    let checks = vec![
        Check::same("rates against the equations", rates.as_slice(), &known, 1e-12),
        Check::new("current at rest, in A", rest.x[Motor::I], current, 1e-12),
        Check::new(
            "angle at rest, in rad",
            rest.x[Motor::THETA],
            f64::asin(k * current / weight),
            1e-12,
        ),
        Check::new("energy from the source, in J", lost + stored, supplied, 1e-8),
    ];
    let powers = move |_: f64, x: &SVector<f64, 3>| vec![k * x[Motor::I] * x[1], -gamma * x[1] * x[1]];
    Run::new(checks, model, solution, powers, |drawing| drawing)
}

/// Integral of a quantity over a solution, by Simpson's rule.
fn integral(solution: &Solution<f64, 3>, quantity: impl Fn(&SVector<f64, 3>) -> f64) -> f64 {
    const PARTS: usize = 4000;
    let h = solution.last().0 / PARTS as f64;
    let value = |n: usize| {
        let weight = if n == 0 || n == PARTS {
            1.0
        } else {
            2.0 + 2.0 * (n % 2) as f64
        };
        weight
            * solution
                .at((n as f64 * h).min(solution.last().0))
                .map_or(f64::NAN, |x| quantity(&x))
    };
    h / 3.0 * (0..=PARTS).map(value).sum::<f64>()
}
