//! Dry friction that holds: a capsule between two pads, as in a gripper.

use std::error::Error;

use pendulum_core::prelude::*;

use super::Answer;

mechanism! {
    /// A capsule that hangs between two pads. After a minute, a pull on it grows from nothing.
    pub Grip {
        params { m: kg = 0.045, g: m/s^2 = 9.81, mu: 1 = 0.7, press: N = 12, growth: N/s = 1 }
        gravity: [0, -g, 0],
        body capsule on ground {
            mass: m, joint: prismatic(y), coordinate: y, dry_friction: 2*mu*press, torque: -growth*(t - 60),
        }
    }
}

/// Distance in m by which the capsule slips under its weight in a minute.
pub(crate) fn slip() -> Result<f64, Box<dyn Error>> {
    let hanging = Grip::new(GripParams {
        growth: 0.0,
        ..GripParams::default()
    })?;
    Ok(Vern7::new().solve(&hanging, 0.0, 60.0, [0.0, 0.0])?.end()[Grip::Y].abs())
}

/// Force in N, weight included, at which the capsule gives way.
pub(crate) fn gives_way() -> Result<f64, Box<dyn Error>> {
    let pulled = Grip::new(GripParams::default())?;
    let motion = Vern7::new().solve(&pulled, 60.0, 90.0, [0.0, 0.0])?;
    let (start, _) = motion.modes()[1];
    Ok(0.045 * 9.81 + start - 60.0)
}

pub(crate) fn answer() -> Result<Answer, Box<dyn Error>> {
    let (slip, pull) = (slip()?, gives_way()?);
    Ok(Answer::new(
        slip,
        format!("slips by {slip} m in 60 s, and gives way at {pull:.10} N"),
    ))
}
