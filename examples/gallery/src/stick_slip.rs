//! # Block on a belt
//!
//! A belt drags a block until its spring pulls harder than friction can hold; the block slips back and sticks again,
//! like a string under the bow. If static friction exceeds kinetic friction, this never ends.

use std::f64::consts::PI;

use pendulum_core::prelude::*;

use crate::{Check, Run};

mechanism! {
    /// A block on a belt that runs at the speed `v`, tied to the ground by a spring.
    pub StickSlip {
        params { m: kg = 1, k: N/m = 40, v: m/s = 0.2, slipping: N = 3, sticking: N = 5 }
        point nail on ground at [-0.3, 0, 0],
        point eye on block at [-0.06, 0, 0],
        spring between nail and eye: (k, 0.24),
        body belt on ground { joint: prismatic(x), motion: v*t }
        body block on belt {
            solids: [cuboid(m, [0.12, 0.08, 0.08], [0, 0, 0])],
            joint: prismatic(x), coordinate: s, dry_friction: slipping, static_friction: sticking,
        }
        generate: [rhs, energy, drive_forces, shapes],
    }
}

/// Checks the limit cycle against its closed form, and the power of friction and of the belt.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    const PERIODS: usize = 8;
    let params = StickSlipParams::default();
    let StickSlipParams {
        m,
        k,
        v,
        slipping,
        sticking,
    } = params;
    // It slips where the spring force reaches `sticking`, oscillates about the position where that is `slipping`, and
    // reaches the speed of the belt again at the same distance beyond it.
    let (w, beyond) = ((k / m).sqrt(), (sticking - slipping) / k);
    let slips_for = (PI + 2.0 * (v / w / beyond).atan()) / w;
    let sticks_for = 2.0 * beyond / v;
    let (mut t, mut times, mut places) = (sticking / k / v, Vec::new(), Vec::new());
    for _ in 0..PERIODS {
        times.extend([t, t + slips_for]);
        places.extend([sticking / k, slipping / k - beyond]);
        t += slips_for + sticks_for;
    }
    let model = StickSlip::new(params)?;
    let solution = Vern9::new().rtol(1e-13).atol(1e-13).solve(&model, 0.0, t, [0.0, 0.0])?;
    let changes: Vec<f64> = solution.modes()[1..]
        .iter()
        .map(|(t, _)| *t)
        .take(times.len())
        .collect();
    let found = changes.iter().map(|&t| Ok(v * t + solution.at(t)?[StickSlip::S]));
    let found = found.collect::<Result<Vec<f64>, Box<dyn std::error::Error>>>()?;
    let caught = solution.at(changes[1] + 0.5 * sticks_for)?;
    let checks = vec![
        Check::same("times at which it slips and sticks, in s", &changes, &times, 1e-10),
        Check::same("places there, in m", &found, &places, 1e-10),
        Check::new("its rate on the belt while it sticks, in m/s", caught[1], 0.0, 0.0),
    ];
    let powers = move |t: f64, x: &SVector<f64, 2>| {
        let forces = model.drive_forces(t, x);
        vec![-slipping * x[1].abs(), v * forces[0]]
    };
    let model = StickSlip::new(params)?;
    Run::new(checks, model, solution, powers, |drawing| {
        drawing.wall([-0.3, -0.04, 0.0], [0.2, -0.04, 0.0])
    })
}
