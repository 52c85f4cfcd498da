//! # Armour-plated leg
//!
//! A robot's leg of two irregular plates (Section 6): with a fixed hip, and swinging while the hip moves. A stop keeps
//! the knee from bending forward. Mass, centre and inertia of the plates follow from their corners.

use pendulum_core::prelude::*;

use crate::{Check, Run, double_pendulum, impacts, larger};

mechanism! {
    /// Thigh and shank, two plates of one density with friction in hip and knee. The hip moves at `v`, and up and down.
    pub Leg {
        params {
            m1: kg = 3, m2: kg = 2, d: m = 0.42, gamma: N m s = 0.08, knee: N m = 9,
            v: m/s = 0.6, rise: m = 0.02, w: rad/s = 6,
        }
        gravity: [0, -9.81, 0],
        body carried on ground { joint: prismatic(x), motion: v*t }
        body hip on carried { joint: prismatic(y), motion: rise*sin(w*t) }
        body thigh on hip {
            solids: [
                plate(m1, [[-0.08, 0.06], [-0.06, -0.3], [-0.03, -0.46], [0.05, -0.44], [0.1, -0.15], [0.07, 0.07]]),
            ],
            joint: revolute(z), coordinate: theta1 absolute, friction: gamma,
        }
        body shank on thigh {
            solids: [
                plate(m2, [[-0.05, 0.05], [-0.07, -0.12], [-0.03, -0.4], [0.14, -0.43], [0.04, -0.33], [0.05, 0.04]]),
            ],
            joint: revolute(z) at [0, -d, 0], coordinate: theta2 absolute, friction: gamma, spring: (knee, -0.3),
            stop: [-2.4, -0.02] restitution(0.2),
        }
        point toe on shank at [0.14, -0.43, 0],
        generate: [rhs, energy, drive_forces, shapes],
    }
}

/// Centre of mass and inertia about it of a polygon of unit mass, summed over its triangles from one corner.
fn polygon(corners: &[[f64; 2]]) -> ([f64; 2], f64) {
    let (mut area, mut first, mut second) = (0.0, [0.0; 2], 0.0);
    let origin = corners[0];
    let from = |p: [f64; 2]| [p[0] - origin[0], p[1] - origin[1]];
    for pair in corners[1..].windows(2) {
        let [p, q] = [from(pair[0]), from(pair[1])];
        let own = (p[0] * q[1] - p[1] * q[0]) / 2.0;
        area += own;
        for axis in 0..2 {
            first[axis] += own * (p[axis] + q[axis]) / 3.0;
            second += own * (p[axis] * p[axis] + p[axis] * q[axis] + q[axis] * q[axis]) / 6.0;
        }
    }
    let com = first.map(|first| first / area);
    let about_com = second / area - com[0] * com[0] - com[1] * com[1];
    ([origin[0] + com[0], origin[1] + com[1]], about_com)
}

/// Checks the plates by their triangles, the leg with a fixed hip against the formula, the stop of the knee, and the
/// power of friction and of the hip.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let thigh = [
        [-0.08, 0.06],
        [-0.06, -0.3],
        [-0.03, -0.46],
        [0.05, -0.44],
        [0.1, -0.15],
        [0.07, 0.07],
    ];
    let shank = [
        [-0.05, 0.05],
        [-0.07, -0.12],
        [-0.03, -0.4],
        [0.14, -0.43],
        [0.04, -0.33],
        [0.05, 0.04],
    ];
    let ([x1, y1], i1) = polygon(&thigh);
    let ([x2, y2], i2) = polygon(&shank);
    let params = LegParams {
        v: 0.0,
        rise: 0.0,
        gamma: 0.0,
        knee: 0.0,
        ..Default::default()
    };
    let held = Leg::new(params)?;
    // angles of the lines from the joints to the centres of mass; the knee lies on the thigh's own line
    let (alpha1, alpha2) = (x1.atan2(-y1), x2.atan2(-y2));
    let (c1, c2, d) = (x1.hypot(y1), x2.hypot(y2), 0.42);
    let straight = Leg::new(params)?.kinetic(0.0, &[-alpha1, -alpha2, 1.0, 0.0].into());
    let inertia = (3.0 * (i1 + c1 * c1) + 2.0 * d * d) / 2.0;
    let x = [0.4, -0.7, 1.5, -2.0];
    let rate = held.rhs(0.0, &x.into());
    let known = double_pendulum([3.0, c1, 3.0 * i1, alpha1], [2.0, c2, 2.0 * i2, alpha2], d, 9.81, x);
    let mut checks = vec![
        Check::new("energy of the thigh that turns, in J", straight, inertia, 1e-14),
        Check::same(
            "accelerations held by the hip, in rad/s^2",
            &rate.as_slice()[2..],
            &known,
            1e-11,
        ),
    ];
    let model = Leg::new(LegParams::default())?;
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 3.0, [0.9, 0.2, 0.0, 0.0])?;
    let turning = |x: &SVector<f64, 4>| x[3] - x[2];
    let (mut count, mut law) = (0.0, 0.0);
    for (_, before, after) in impacts(&solution) {
        law = larger(law, (turning(&after) + 0.2 * turning(&before)).abs());
        count += 1.0;
    }
    let bends = solution.x().iter().map(|x| x[Leg::THETA2] - x[Leg::THETA1]);
    checks.push(Check::new(
        "straightest, in rad",
        bends.fold(f64::NEG_INFINITY, larger),
        -0.02,
        1e-15,
    ));
    checks.push(Check::new("impacts at the stop of the knee", count, 1.0, 0.0));
    checks.push(Check::new("their law, in rad/s", law, 0.0, 1e-13));
    let powers = move |t: f64, x: &SVector<f64, 4>| {
        let [along, up]: [f64; 2] = model.drive_forces(t, x).into();
        let lost = [-0.08 * x[2].powi(2), -0.08 * (x[3] - x[2]).powi(2)];
        vec![lost[0], lost[1], 0.6 * along, up * 0.02 * 6.0 * (6.0 * t).cos()]
    };
    Run::new(checks, model, solution, powers, |drawing| drawing)
}
