//! # Bouncing ball
//!
//! A ball that rebounds with a fraction of its speed, infinitely often in a finite time; then it rolls on.

use pendulum_core::prelude::*;

use crate::{Check, Run, impacts};

mechanism! {
    /// A ball above the ground, from which it rebounds with `e` times its speed.
    pub BouncingBall {
        params { e: 1 = 0.8 }
        gravity: [0, -9.81, 0],
        point centre on ball,
        wall ground { gap: y, restitution: e }
        body across on ground { joint: prismatic(x), coordinate: x }
        body ball on across {
            solids: [sphere(0.06, 0.05, [0, 0, 0])],
            joint: prismatic(y) at [0, 0.05, 0], coordinate: y,
        }
        generate: [rhs, energy, shapes],
    }
}

/// Checks the law of each impact, the heights between impacts, and the time of rest: a geometric series.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let (height, along) = (1.0, 0.5);
    let BouncingBallParams { e } = BouncingBallParams::default();
    let model = BouncingBall::new(BouncingBallParams { e })?;
    let start = [0.0, height, along, 0.0];
    let solution = Vern9::new().rtol(1e-13).atol(1e-13).solve(&model, 0.0, 4.6, start)?;
    let fall = (2.0 * height / 9.81).sqrt();
    let rests = fall * (1.0 + 2.0 * e / (1.0 - e));
    let &(rested, mode) = solution.modes().last().ok_or("no mode")?;
    let end = solution.end();
    // the first rebounds: their impacts and tops
    let (mut t, mut rates, mut tops) = (fall, Vec::new(), Vec::new());
    let mut known = (Vec::new(), Vec::new());
    for (n, (at, before, after)) in impacts(&solution).take(12).enumerate() {
        let part = e.powi(n as i32 + 1);
        rates.extend([at - t, after[3] + e * before[3]]);
        known.0.extend([0.0; 2]);
        tops.push(solution.at(t + fall * part)?[BouncingBall::Y]);
        known.1.push(height * part * part);
        t += 2.0 * fall * part;
    }
    let checks = vec![
        Check::same("times of impacts in s, and their law in m/s", &rates, &known.0, 1e-12),
        // rounding of the polynomial of a long step is some 1e-12 near its end
        Check::same("heights of the rebounds, in m", &tops, &known.1, 1e-11),
        Check::new("at rest from, in s", rested, rests, 1e-12),
        Check::new(
            "touches the floor at the end (1: yes)",
            f64::from(u8::from(mode.is_held(0))),
            1.0,
            0.0,
        ),
        Check::same(
            "height in m and its rate in m/s at the end",
            &[end[1], end[3]],
            &[0.0; 2],
            0.0,
        ),
    ];
    Run::new(
        checks,
        model,
        solution,
        |_, _| Vec::new(),
        |drawing| drawing.ghosts(8).wall([-0.1, 0.0, 0.0], [2.5, 0.0, 0.0]),
    )
}
