//! # Rocking block
//!
//! A slender block that slides along smooth ground and rocks from corner to corner (on rough ground: G. W. Housner
//! 1963). At each impact the next corner stops dead, and the one on which the block turned lifts off.

use pendulum_core::prelude::*;

use crate::{Check, Run, impacts, larger};

mechanism! {
    /// A block of the half width `b` and the half height `h` on smooth ground.
    pub RockingBlock {
        params { b: m = 0.08, h: m = 0.25 }
        gravity: [0, -9.81, 0],
        point left on block at [-b, -h, 0],
        point right on block at [b, -h, 0],
        wall under_left { gap: left.y },
        wall under_right { gap: right.y },
        body across on ground { joint: prismatic(x), coordinate: x }
        body up on across { joint: prismatic(y), coordinate: y }
        body block on up {
            solids: [plate(2, [[-b, -h], [b, -h], [b, h], [-b, h]])],
            joint: revolute(z), coordinate: phi,
        }
        body floor on ground { solids: [plate(1, [[-0.3, -0.02], [0.9, -0.02], [0.9, 0], [-0.3, 0]])] }
        generate: [rhs, energy, shapes],
    }
}

/// The first impact, and the rate of turning after each, in closed form.
///
/// Before an impact the block turns at the rate `w` on a corner, so its centre rises at `b w`. The impulse `P` at the
/// other corner makes that `b w + P/m`, and the rate `w' = w + b P/I`; it stops the corner, `b w + P/m + b w' = 0`. So
/// `w' = w (I - m b^2) / (I + m b^2)`.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let RockingBlockParams { b, h } = RockingBlockParams::default();
    let model = RockingBlock::new(RockingBlockParams { b, h })?;
    let (tilt, along) = (0.28_f64, 1.0);
    let start = [0.0, b * tilt.sin() + h * tilt.cos(), tilt, along, 0.0, 0.0];
    // Impacts follow each other ever faster; at 0.58657 s they would end.
    let end = 0.586;
    let solution = Vern9::new().rtol(1e-12).atol(1e-12).solve(&model, 0.0, end, start)?;
    let inertia = (b * b + h * h) / 3.0;
    let fallen = start[1] - h;
    let mut known = -(2.0 * 9.81 * fallen / (inertia + b * b)).sqrt();
    let (mut error, mut count) = (0.0, 0.0);
    for (_, before, after) in impacts(&solution) {
        error = larger(error, (before[5] - known).abs());
        known *= (inertia - b * b) / (inertia + b * b);
        error = larger(error, (after[5] - known).abs());
        // There and back on this corner.
        known = -known;
        count += 1.0;
    }
    let least = solution
        .points()
        .flat_map(|(t, x)| model.measures(t, x).map(|[gap, _]| -gap));
    let x = solution.end();
    let checks = vec![
        Check::new("impacts", count, 11.0, 0.0),
        Check::new("rates of turning before and after them, in rad/s", error, 0.0, 1e-11),
        Check::new("a corner in the ground, in m", least.fold(0.0, larger), 0.0, 1e-13),
        Check::same(
            "sliding along, in m and m/s",
            &[x[0], x[3]],
            &[end * along, along],
            1e-14,
        ),
    ];
    Run::new(checks, model, solution, |_, _| Vec::new(), |drawing| drawing)
}
