//! Derivatives through impacts: a ball that rebounds twice.

use std::error::Error;

use pendulum_core::prelude::*;
use pendulum_core::sensitivity::{self, Variable};

use super::Answer;

mechanism! {
    /// A ball above a floor.
    pub Drop {
        params { e: 1 = 0.8 }
        gravity: [0, -9.81, 0],
        wall floor { gap: y, restitution: e }
        body ball on ground { mass: 1, joint: prismatic(y), coordinate: y }
    }
}

/// Height from which the ball falls, in m, and the time of the derivatives, in s.
pub(crate) const FALL: (f64, f64) = (1.0, 1.5);

/// Derivatives of the height at the end, by the initial height and by the restitution.
pub(crate) fn derivatives() -> Result<[f64; 2], Box<dyn Error>> {
    let drop = Drop::new(DropParams::default())?;
    let (height, end) = FALL;
    let by = [Variable::Start(Drop::Y), Variable::Parameter(0)];
    let (_, derivatives) = sensitivity::end(&Vern7::new(), &drop, 0.0, end, [height, 0.0], by)?;
    Ok([derivatives[(0, 0)], derivatives[(0, 1)]])
}

/// Closed form of these derivatives, from the height.
///
/// The ball reaches the floor at `s = sqrt(2 h / g)`, and the `n`-th rebound at `s (1 + 2 e + .. + 2 e^(n-1))`; it
/// leaves with the rate `e^n g s`.
pub(crate) fn closed_form() -> [f64; 2] {
    let ((h, end), e, g) = (FALL, 0.8, 9.81);
    let fall = f64::sqrt(2.0 * h / g);
    let flown = end - fall * (1.0 + 2.0 * e);
    let rate = e * e * g * fall;
    // of the height `rate flown - g flown^2 / 2` after the second impact
    let by_rate_and_time = |rate_by: f64, flown_by: f64| rate_by * flown + (rate - g * flown) * flown_by;
    let fall_by_h = 0.5 * fall / h;
    [
        by_rate_and_time(e * e * g * fall_by_h, -fall_by_h * (1.0 + 2.0 * e)),
        by_rate_and_time(2.0 * e * g * fall, -2.0 * fall),
    ]
}

pub(crate) fn answer() -> Result<Answer, Box<dyn Error>> {
    let (found, exact) = (derivatives()?, closed_form());
    let error = (0..2).map(|n| (found[n] - exact[n]).abs()).fold(0.0, f64::max);
    let text = format!(
        "{:.12} by the height and {:.12} m by the restitution; error {error:.1e}",
        found[0], found[1]
    );
    Ok(Answer::new(error, text))
}
