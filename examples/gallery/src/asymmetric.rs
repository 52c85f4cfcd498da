//! # Asymmetric double pendulum, and two bodies on torsion springs
//!
//! Bodies of any mass, centre and inertia on two axles, with springs in both (reference 5). Without gravity, as with
//! vertical axles, only the springs restore it.

use pendulum_core::prelude::*;

use crate::{Check, Run, frequencies, two_modes};

mechanism! {
    /// Two bodies on two axles with torsion springs.
    pub Asymmetric {
        params {
            m1: kg = 1.2, c1: m = 0.4, i1: kg m^2 = 0.09,
            m2: kg = 0.7, c2: m = 0.5, i2: kg m^2 = 0.05,
            d: m = 0.9, k1: N m = 4, k2: N m = 2.5, g: m/s^2 = 9.81,
        }
        gravity: [0, -g, 0],
        body upper on ground {
            mass: m1, com: [0, -c1, 0], inertia: i1,
            joint: revolute(z), coordinate: theta1 absolute, spring: (k1, 0),
        }
        body lower on upper {
            mass: m2, com: [0, -c2, 0], inertia: i2,
            joint: revolute(z) at [0, -d, 0], coordinate: theta2 absolute, spring: (k2, 0),
        }
        point tip on lower at [0, -2*c2, 0],
        generate: [rhs, jacobian, energy, shapes],
    }
}

/// Checks the modes about rest, with gravity and without, and the energy.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let params = AsymmetricParams::default();
    let AsymmetricParams {
        m1,
        c1,
        i1,
        m2,
        c2,
        i2,
        d,
        k1,
        k2,
        g,
    } = params;
    let mass = [
        [i1 + m1 * c1 * c1 + m2 * d * d, m2 * d * c2],
        [m2 * d * c2, i2 + m2 * c2 * c2],
    ];
    let stiffness = |g: f64| [[k1 + k2 + (m1 * c1 + m2 * d) * g, -k2], [-k2, k2 + m2 * c2 * g]];
    let model = Asymmetric::new(params)?;
    let torsion = Asymmetric::new(AsymmetricParams { g: 0.0, ..params })?;
    let (swinging, twisting) = (frequencies(&model, [0.0; 4])?, frequencies(&torsion, [0.0; 4])?);
    let checks = vec![
        Check::same(
            "modes in gravity, in rad/s",
            &swinging,
            &two_modes(mass, stiffness(g)),
            1e-12,
        ),
        Check::same(
            "modes on the springs alone, in rad/s",
            &twisting,
            &two_modes(mass, stiffness(0.0)),
            1e-12,
        ),
    ];
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 5.0, [1.5, -0.5, 0.0, 2.0])?;
    Run::new(checks, model, solution, |_, _| vec![], |drawing| drawing)
}
