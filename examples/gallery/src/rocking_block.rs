//! # Rocking block
//!
//! A slender block that slides along smooth ground and rocks from corner to corner (on rough ground: G. W. Housner
//! 1963). At each impact the next corner comes to rest, and the pivot corner lifts off.

use pendulum_core::prelude::*;

use crate::{Check, Run, impacts, larger};

mechanism! {
    /// A block of half width `b` and half height `h` on smooth ground.
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
        generate: [rhs, energy, shapes],
    }
}

/// Checks the first impact, the angular velocity after each impact in closed form, and the time at which the block
/// stands, by quadrature.
///
/// Before an impact the block rotates at the rate `w` on a corner, so its centre rises at `b w`. The impulse `P` at the
/// other corner changes this to `b w + P/m`, and the rate to `w' = w + b P/I`; it stops the corner,
/// `b w + P/m + b w' = 0`. So `w' = w (I - m b^2) / (I + m b^2)`.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let RockingBlockParams { b, h } = RockingBlockParams::default();
    let model = RockingBlock::new(RockingBlockParams { b, h })?;
    let (tilt, along) = (0.28_f64, 1.0);
    let start = [0.0, b * tilt.sin() + h * tilt.cos(), tilt, along, 0.0, 0.0];
    let end = 0.8;
    let solution = Vern9::new().rtol(1e-12).atol(1e-12).solve(&model, 0.0, end, start)?;
    let inertia = (b * b + h * h) / 3.0;
    let fallen = start[1] - h;
    let mut known = -(2.0 * 9.81 * fallen / (inertia + b * b)).sqrt();
    let mut error = 0.0;
    // until the rates are as small as their errors
    for (_, before, after) in impacts(&solution).take(20) {
        error = larger(error, (before[5] - known).abs());
        known *= (inertia - b * b) / (inertia + b * b);
        error = larger(error, (after[5] - known).abs());
        // the same rate back at the end of the rebound
        known = -known;
    }
    let &(stands, mode) = solution.modes().last().ok_or("no mode")?;
    let least = solution
        .points()
        .flat_map(|(t, x)| model.measures(t, x).map(|[gap, _]| -gap));
    let x = solution.end();
    let checks = vec![
        Check::new(
            "rates of turning before and after 20 impacts, in rad/s",
            error,
            0.0,
            1e-11,
        ),
        // the last rebounds rise by 1e-13 m, so rounding of the gap shifts the time by this much
        Check::new("stands from, in s", stands, stands_from(b, h, tilt), 1e-11),
        Check::new(
            "on both corners at the end (1: yes)",
            f64::from(u8::from(mode.is_held(0) && mode.is_held(1))),
            1.0,
            0.0,
        ),
        Check::new("a corner in the ground, in m", least.fold(0.0, larger), 0.0, 1e-13),
        Check::same(
            "sliding along, in m and m/s",
            &[x[0], x[3]],
            &[end * along, along],
            1e-14,
        ),
        Check::same(
            "height in m, tilt in rad and their rates at the end",
            &[x[1], x[2], x[4], x[5]],
            &[h, 0.0, 0.0, 0.0],
            1e-14,
        ),
    ];
    Run::new(
        checks,
        model,
        solution,
        |_, _| Vec::new(),
        |drawing| drawing.wall([-0.3, 0.0, 0.0], [0.9, 0.0, 0.0]),
    )
}

/// Time at which a block that starts from a tilt comes to rest.
///
/// By conservation of energy, the fall from the tilt `p` takes the integral of `dphi / w`, where
/// `w^2 (I + m y'^2) = 2 m g (y(p) - y(phi))` with the height `y = b sin(phi) + h cos(phi)`; every rise takes as long
/// as the next fall. For small rates, the durations decrease in proportion to the rates: a geometric series.
fn stands_from(b: f64, h: f64, tilt: f64) -> f64 {
    const PARTS: u32 = 200;
    // the two Gauss points of each part
    let places = [0.5 - 0.5 / 3.0_f64.sqrt(), 0.5 + 0.5 / 3.0_f64.sqrt()];
    let inertia = (b * b + h * h) / 3.0;
    let (kept, g) = ((inertia - b * b) / (inertia + b * b), 9.81);
    let energy = |tilt: f64| g * (b * tilt.sin() - 2.0 * h * (0.5 * tilt).sin().powi(2));
    let fall = |tilt: f64| {
        // equal parts of the square root of the remaining tilt, in which the integrand is smooth
        let at = |place: f64| {
            let root = place / f64::from(PARTS);
            let phi = tilt * (1.0 - root * root);
            let rise = b * phi.cos() - h * phi.sin();
            let rate = (2.0 * (energy(tilt) - energy(phi)) / (inertia + rise * rise)).sqrt();
            2.0 * tilt * root / rate
        };
        let all = (0..PARTS).flat_map(|n| places.map(|place| at(f64::from(n) + place)));
        all.sum::<f64>() / f64::from(2 * PARTS)
    };
    let mut rate = kept * (2.0 * energy(tilt) / (inertia + b * b)).sqrt();
    let mut t = fall(tilt);
    while rate > 1e-3 {
        let height = h + 0.5 * (inertia + b * b) * rate * rate / g;
        let tilt = (height / b.hypot(h)).asin() - h.atan2(b);
        t += 2.0 * fall(tilt);
        rate *= kept;
    }
    t + 2.0 * rate * (inertia + b * b) / (g * b) / (1.0 - kept)
}
