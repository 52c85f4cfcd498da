//! # Double four-bar linkage
//!
//! Three equal bars on the ground, connected by two others: the first of the IFToMM benchmarks of multibody programs,
//! here hanging. All bars on the ground stay parallel. In the flat configuration, a singularity, the linkage could
//! continue in several ways, and its coordinate would not determine which.

use pendulum_core::prelude::*;

use crate::{Check, Run, larger};

mechanism! {
    /// Five bars of length `l` and mass `m`.
    pub DoubleFourBar {
        params { m: kg = 1, l: m = 1, g: m/s^2 = 9.81 }
        gravity: [0, -g, 0],
        shape hanging { solids: [rod(m, [0, 0, 0], [0, -l, 0])] }
        shape across { solids: [rod(m, [0, 0, 0], [l, 0, 0])] }
        body first on ground: hanging { joint: revolute(z), coordinate: theta near 0.5 }
        body beam on first: across { joint: revolute(z) at [0, -l, 0], coordinate: a depends near -0.5 }
        body second on ground: hanging { joint: revolute(z) at [l, 0, 0], coordinate: b depends near 0.5 }
        body other on second: across { joint: revolute(z) at [0, -l, 0], coordinate: c depends near -0.5 }
        body third on ground: hanging { joint: revolute(z) at [2*l, 0, 0], coordinate: d depends near 0.5 }
        close beam at [l, 0, 0] to second at [0, -l, 0]: revolute(z),
        close other at [l, 0, 0] to third at [0, -l, 0]: revolute(z),
        output parallel: [theta + a, theta - b, b + c, theta - d],
        output margins: [margin(beam, second), margin(other, third)],
        generate: [rhs, jacobian, energy, shapes],
    }
}

/// Checks that bars stay parallel, the equivalent single pendulum, the Jacobian, and the energy.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let model = DoubleFourBar::new(DoubleFourBarParams::default())?;
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 4.0, [1.1, 0.0])?;
    let (mut turned, mut pendulum) = (0.0, 0.0);
    for (t, x) in solution.points() {
        turned = larger(turned, model.parallel(t, x).amax());
        // (3 m l^2 / 3 + 2 m l^2) theta'' = -(3 m l / 2 + 2 m l) g sin theta
        let known = -3.5 / 3.0 * 9.81 * x[0].sin();
        pendulum = larger(pendulum, (model.rhs(t, x)[1] - known).abs());
    }
    let checks = vec![
        Check::new("bars out of parallel, in rad", turned, 0.0, 1e-14),
        Check::new("accelerations, in rad/s^2", pendulum, 0.0, 1e-12),
        crate::jacobian_by_differences(&model, 0.0, [0.7, -3.0]),
    ];
    Run::new(checks, model, solution, |_, _| Vec::new(), |drawing| drawing)
}
