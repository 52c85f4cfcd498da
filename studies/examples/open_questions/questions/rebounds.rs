//! A ball that comes to rest after infinitely many rebounds.

use std::error::Error;

use pendulum_core::prelude::*;

use super::Answer;

mechanism! {
    /// A ball that keeps half of its rate at each impact on a floor one metre below its start.
    pub Ball {
        gravity: [0, -9.8, 0],
        wall floor { gap: y + 1, restitution: 0.5 }
        body across on ground { joint: prismatic(x), coordinate: x }
        body ball on across { mass: 1, joint: prismatic(y), coordinate: y }
    }
}

/// Initial condition of the question.
pub(crate) const START: [f64; 4] = [0.0, 0.0, 1.0, 1.0];

pub(crate) fn answer() -> Result<Answer, Box<dyn Error>> {
    let ball = Ball::new(BallParams {})?;
    let motion = Tsit5::new().solve(&ball, 0.0, 2.0, START)?;
    let (rest, _) = *motion.modes().last().ok_or("no mode")?;
    let gap = motion.end()[Ball::Y] + 1.0;
    let text = format!("at rest from {rest:.9} s on, {gap} m above the floor");
    Ok(Answer::new(rest, text))
}
