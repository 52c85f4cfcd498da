//! # Pivot on a curve
//!
//! A double rigid pendulum whose pivot follows a Lissajous curve (references 11 and 17), or, with `nx = ny = 1`, an
//! ellipse at a constant frequency of the drive (Section 6). The pivot is not part of the state.

use pendulum_core::prelude::*;

use crate::{Check, Run, larger, solve_two};

mechanism! {
    /// Two rods below a pivot that moves as (a cos(nx w t), b sin(ny w t)).
    pub DrivenPivot {
        params {
            m1: kg = 1, m2: kg = 0.8, l1: m = 1, l2: m = 0.7,
            a: m = 0.25, b: m = 0.15, w: rad/s = 1.5, nx: 1 = 3, ny: 1 = 2, gamma: N m s = 0.02,
        }
        gravity: [0, -9.81, 0],
        body across on ground { joint: prismatic(x), motion: a*cos(nx*w*t) }
        body pivot on across { joint: prismatic(y), motion: b*sin(ny*w*t) }
        body upper on pivot {
            solids: [rod(m1, [0, 0, 0], [0, -l1, 0])],
            joint: revolute(z), coordinate: theta1 absolute, friction: gamma,
        }
        body lower on upper {
            solids: [rod(m2, [0, 0, 0], [0, -l2, 0])],
            joint: revolute(z) at [0, -l1, 0], coordinate: theta2 absolute, friction: gamma,
        }
        point nail on pivot, point tip on lower at [0, -l2, 0],
        generate: [rhs, jacobian, energy, drive_forces, shapes],
    }
}

/// Lagrange's equations of the two rods, for a pivot with the acceleration `(ax, ay)`.
fn lagrange(params: &DrivenPivotParams, [ax, ay]: [f64; 2], x: &[f64; 4]) -> [f64; 2] {
    let DrivenPivotParams {
        m1, m2, l1, l2, gamma, ..
    } = *params;
    let [a, b, da, db] = *x;
    let ((sine, cosine), g) = ((a - b).sin_cos(), 9.81);
    let mass = [
        (m1 / 3.0 + m2) * l1 * l1,
        m2 * l1 * l2 / 2.0 * cosine,
        m2 * l2 * l2 / 3.0,
    ];
    let (s1, s2) = ((m1 / 2.0 + m2) * l1, m2 * l2 / 2.0);
    let twist = gamma * (db - da);
    let coupling = m2 * l1 * l2 / 2.0 * sine;
    let first = -coupling * db * db - s1 * ((g + ay) * a.sin() + ax * a.cos()) - gamma * da + twist;
    let second = coupling * da * da - s2 * ((g + ay) * b.sin() + ax * b.cos()) - twist;
    solve_two(mass, [first, second])
}

/// Checks Lagrange's equations on both curves, and the power of friction and of the pivot.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let lissajous = DrivenPivotParams::default();
    let ellipse = DrivenPivotParams {
        nx: 1.0,
        ny: 1.0,
        ..lissajous
    };
    let mut checks = Vec::new();
    for (curve, params) in [("the Lissajous curve", lissajous), ("the ellipse", ellipse)] {
        let model = DrivenPivot::new(params)?;
        let mut worst = [0.0; 2];
        for n in 0..50 {
            let t = 0.13 * f64::from(n);
            let x = [0.7, 1.9, 2.3, 0.4].map(|speed: f64| 2.0 * (speed * t + speed).sin());
            let (wx, wy) = (params.nx * params.w, params.ny * params.w);
            let pivot = [
                -params.a * wx * wx * (wx * t).cos(),
                -params.b * wy * wy * (wy * t).sin(),
            ];
            let known = lagrange(&params, pivot, &x);
            let found = model.rhs(t, &x.into());
            for k in 0..2 {
                worst[k] = larger(worst[k], (found[2 + k] - known[k]).abs());
            }
        }
        checks.push(Check::same(
            format!("accelerations on {curve}, in rad/s^2"),
            &worst,
            &[0.0; 2],
            1e-12,
        ));
    }
    let model = DrivenPivot::new(lissajous)?;
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 8.0, [1.0, -0.5, 0.0, 0.0])?;
    let powers = move |t: f64, x: &SVector<f64, 4>| {
        let DrivenPivotParams {
            a, b, w, nx, ny, gamma, ..
        } = lissajous;
        let [along, up]: [f64; 2] = model.drive_forces(t, x).into();
        let lost = [-gamma * x[2].powi(2), -gamma * (x[3] - x[2]).powi(2)];
        vec![
            lost[0],
            lost[1],
            -along * a * nx * w * (nx * w * t).sin(),
            up * b * ny * w * (ny * w * t).cos(),
        ]
    };
    Run::new(checks, model, solution, powers, |drawing| drawing)
}
