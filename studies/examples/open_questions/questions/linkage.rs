//! Loops that stay closed: a leg of Jansen's Strandbeest.

use std::error::Error;

use pendulum_core::prelude::*;

use super::Answer;

mechanism! {
    /// Jansen's leg, ten times as large as his "holy numbers" in mm, on a crank that a motor with a flat characteristic
    /// turns.
    pub Leg {
        params { stall: N m = 2, fast: rad/s = 12 }
        gravity: [0, -9.81, 0],
        body crank on ground {
            solids: [rod(0.2, [0, 0, 0], [0.15, 0, 0])],
            joint: revolute(z), coordinate: theta near 0.5, torque: stall*(1 - qd/fast),
        }
        body upper on crank {
            solids: [rod(0.2, [0, 0, 0], [0.5, 0, 0])],
            joint: revolute(z) at [0.15, 0, 0], coordinate: j depends near 2.1,
        }
        body rocker on ground {
            solids: [rod(0.2, [0, 0, 0], [0.415, 0, 0]), rod(0.2, [0, 0, 0], [0.0261, 0.4001, 0])],
            joint: revolute(z) at [-0.38, -0.078, 0], coordinate: b depends near 1.4,
        }
        body lower on crank {
            solids: [rod(0.2, [0, 0, 0], [0.619, 0, 0])],
            joint: revolute(z) at [0.15, 0, 0], coordinate: k depends near -2.7,
        }
        body knee on ground {
            solids: [rod(0.2, [0, 0, 0], [0.393, 0, 0])],
            joint: revolute(z) at [-0.38, -0.078, 0], coordinate: c depends near -1.2,
        }
        body shin on rocker {
            solids: [rod(0.2, [0, 0, 0], [0.394, 0, 0])],
            joint: revolute(z) at [0.0261, 0.4001, 0], coordinate: f depends near -2.4,
        }
        body foot on knee {
            solids: [rod(0.2, [0, 0, 0], [0.367, 0, 0]), rod(0.2, [0, 0, 0], [-0.0775, 0.4838, 0])],
            joint: revolute(z) at [0.393, 0, 0], coordinate: g depends near -2.3,
        }
        close upper at [0.5, 0, 0] to rocker at [0.415, 0, 0]: revolute(z),
        close lower at [0.619, 0, 0] to knee at [0.393, 0, 0]: revolute(z),
        close shin at [0.394, 0, 0] to foot at [0.367, 0, 0]: revolute(z),
        point upper_end on upper at [0.5, 0, 0],
        point rocker_end on rocker at [0.415, 0, 0],
        point lower_end on lower at [0.619, 0, 0],
        point knee_end on knee at [0.393, 0, 0],
        point shin_end on shin at [0.394, 0, 0],
        point foot_end on foot at [0.367, 0, 0],
        point toe on foot at [-0.0775, 0.4838, 0],
        output gaps: [distance(upper_end, rocker_end), distance(lower_end, knee_end), distance(shin_end, foot_end)],
        output toe: [toe.x, toe.y],
        event turn: sin(theta),
        generate: [rhs],
    }
}

pub(crate) fn answer() -> Result<Answer, Box<dyn Error>> {
    let leg = Leg::new(LegParams::default())?;
    let turns = leg.turn_event().rising();
    let motion = Vern9::new()
        .rtol(1e-9)
        .atol(1e-9)
        .solve_with(&leg, 0.0, 60.0, [0.5, 0.0], &[turns])?;
    let gaps = motion.points().map(|(t, x)| leg.gaps(t, x).max());
    let widest = gaps.fold(0.0, f64::max);
    let text = format!(
        "the joints part by at most {widest:.1e} m in {} turns",
        motion.events().len()
    );
    Ok(Answer::new(widest, text))
}
