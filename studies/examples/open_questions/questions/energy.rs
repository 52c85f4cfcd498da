//! Energy over a long motion: the acrobot of reinforcement learning.

use std::error::Error;

use pendulum_core::prelude::*;

use super::Answer;

mechanism! {
    /// Two links without friction, as in Gymnasium's `Acrobot-v1`; the torque between them is zero.
    pub Acrobot {
        gravity: [0, -9.8, 0],
        shape link { mass: 1, com: [0, -0.5, 0], inertia: 1 }
        body upper on ground: link { joint: revolute(z), coordinate: theta1 }
        body lower on upper: link { joint: revolute(z) at [0, -1, 0], coordinate: theta2 }
        generate: [rhs, energy, canonical],
    }
}

/// Initial angles in rad and rates in rad/s, the length of a step and the duration in s.
pub(crate) const SWING: ([f64; 4], f64, f64) = ([1.0, 0.0, 0.0, 0.0], 0.2, 100.0);

/// Largest change of the energy, over its height above the energy of the hanging links, in steps of `h`.
pub(crate) fn drift(h: f64) -> Result<f64, Box<dyn Error>> {
    let (start, _, end) = SWING;
    let acrobot = Acrobot::new(AcrobotParams {})?;
    let motion = Gauss16::new(h).solve(&acrobot, 0.0, end, start)?;
    let whole = acrobot.energy(0.0, &start);
    let above = whole - acrobot.energy(0.0, &[0.0; 4]);
    let changes = motion.points().map(|(t, x)| (acrobot.energy(t, x) - whole).abs());
    Ok(changes.fold(0.0, f64::max) / above)
}

pub(crate) fn answer() -> Result<Answer, Box<dyn Error>> {
    let (_, h, end) = SWING;
    let drift = drift(h)?;
    Ok(Answer::new(
        drift,
        format!("the energy changes by at most {drift:.1e} in {end} s of steps of {h} s"),
    ))
}
