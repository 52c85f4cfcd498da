//! # Five-bar with two motors
//!
//! The planar parallel robot: two cranks, each with a motor, carry one hand by two bars. It has two degrees of freedom,
//! and no motor moves with the hand. The motors track two angles like springs with dampers.

use pendulum_core::prelude::*;

use crate::{Check, Run, larger};

mechanism! {
    /// Cranks of length `a` and bars of length `b`, on motors a distance `d` apart.
    pub FiveBar {
        params { a: m = 0.25, b: m = 0.4, d: m = 0.3, k: N m = 40, c: N m s = 1.5, w: rad/s = 4 }
        gravity: [0, -9.81, 0],
        let first = 2.2 + 0.35*sin(w*t),
        let second = 0.9 + 0.35*cos(2*w*t),
        body left_crank on ground { solids: [rod(0.4, [0, 0, 0], [a, 0, 0])],
            joint: revolute(z), coordinate: q1 near 2.2, torque: k*(first - q) - c*qd }
        body left_bar on left_crank { solids: [rod(0.3, [0, 0, 0], [b, 0, 0])],
            joint: revolute(z) at [a, 0, 0], coordinate: p1 depends near -1.6 }
        body right_crank on ground { solids: [rod(0.4, [0, 0, 0], [a, 0, 0])],
            joint: revolute(z) at [d, 0, 0], coordinate: q2 near 0.9, torque: k*(second - q) - c*qd }
        body right_bar on right_crank { solids: [rod(0.3, [0, 0, 0], [b, 0, 0])],
            joint: revolute(z) at [a, 0, 0], coordinate: p2 depends near 1.6 }
        close left_bar at [b, 0, 0] to right_bar at [b, 0, 0]: revolute(z),
        point hand on left_bar at [b, 0, 0], point other on right_bar at [b, 0, 0],
        output hand: [hand.x, hand.y],
        output gap: [hand.x - other.x, hand.y - other.y],
        generate: [rhs, jacobian, energy, shapes],
    }
}

/// Checks the lengths of both bars from the position of the hand, the closed loop, the Jacobian, and the power of the
/// motors.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let model = FiveBar::new(FiveBarParams::default())?;
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 4.0, [2.2, 0.9, 0.0, 0.0])?;
    let FiveBarParams { a, b, d, k, c, w } = FiveBarParams::default();
    let (mut lengths, mut open) = (0.0, 0.0);
    for (t, x) in solution.points() {
        let hand = model.hand(t, x);
        for (foot, angle) in [(0.0, x[0]), (d, x[1])] {
            let (sine, cosine) = angle.sin_cos();
            let bar = (hand[0] - foot - a * cosine).hypot(hand[1] - a * sine);
            lengths = larger(lengths, (bar - b).abs());
        }
        open = larger(open, model.gap(t, x).amax());
    }
    let checks = vec![
        Check::new("lengths of the bars, in m", lengths, 0.0, 1e-15),
        Check::new("ends of the loop apart, in m", open, 0.0, 1e-15),
        crate::jacobian_by_differences(&model, 0.3, [2.0, 1.0, 0.7, -3.0]),
    ];
    let powers = move |t: f64, x: &SVector<f64, 4>| {
        let targets = [2.2 + 0.35 * (w * t).sin(), 0.9 + 0.35 * (2.0 * w * t).cos()];
        (0..2)
            .map(|n| (k * (targets[n] - x[n]) - c * x[2 + n]) * x[2 + n])
            .collect()
    };
    Run::new(checks, model, solution, powers, |drawing| drawing)
}
