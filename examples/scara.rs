//! SCARA arm whose tool draws a star, with computed-torque control.
//!
//! `cargo run --release --example scara` solves the inverse kinematics along the path, computes the torques by inverse
//! dynamics, and draws path and errors into `out/scara/`.

use std::error::Error;
use std::f64::consts::TAU;
use std::path::Path;

use charts::chart::{Axis, Column, Curve, Figure, Line, Row};
use charts::page::{BLUE, GREY, Picture, VERMILION};
use pendulum_core::prelude::*;

mechanism! {
    /// Two links that rotate about vertical axes, and a quill that slides down.
    Scara {
        params { m1: kg = 4, m2: kg = 3, m3: kg = 1, l1: m = 0.35, l2: m = 0.3, g: m/s^2 = 9.81 }
        input tau1: N m,
        input tau2: N m,
        input lift: N,
        gravity: [0, 0, -g],
        generate: [rhs, jacobian, inverse_dynamics],
        body shoulder on ground {
            solids: [rod(m1, [0, 0, 0], [l1, 0, 0])],
            joint: revolute(z), coordinate: a, friction: 0.5, torque: tau1,
        }
        body elbow on shoulder {
            solids: [rod(m2, [0, 0, 0], [l2, 0, 0])],
            joint: revolute(z) at [l1, 0, 0], coordinate: b, friction: 0.3, torque: tau2,
        }
        body quill on elbow {
            mass: m3,
            joint: prismatic(z) at [l2, 0, 0], coordinate: z, torque: lift,
        }
    }
}

type Joints = SVector<f64, 3>;

/// Duration of one turn around the star, in seconds.
const T_END: f64 = 6.0;
/// Double pole of the error of each joint, in 1/s.
const POLE: f64 = 12.0;

/// Desired position of the tool, in metres: a curve with five tips.
fn star(t: f64) -> [f64; 2] {
    let turn = TAU * t / T_END;
    let radius = 0.11 + 0.035 * (5.0 * turn).cos();
    [0.42 + radius * turn.cos(), 0.1 + radius * turn.sin()]
}

/// Joint coordinates for this position of the tool, with the elbow on the right.
fn joints(params: &ScaraParams, t: f64) -> Joints {
    let ([x, y], ScaraParams { l1, l2, .. }) = (star(t), *params);
    let b = ((x * x + y * y - l1 * l1 - l2 * l2) / (2.0 * l1 * l2)).acos();
    let a = y.atan2(x) - (l2 * b.sin()).atan2(l1 + l2 * b.cos());
    Joints::new(a, b, -0.05)
}

/// Position of the tool.
fn tool(params: &ScaraParams, x: &SVector<f64, 6>) -> [f64; 2] {
    let (a, b) = (x[Scara::A], x[Scara::A] + x[Scara::B]);
    [
        params.l1 * a.cos() + params.l2 * b.cos(),
        params.l1 * a.sin() + params.l2 * b.sin(),
    ]
}

fn main() -> Result<(), Box<dyn Error>> {
    let params = ScaraParams::default();
    let arm = Scara::new(params)?;
    let controlled = arm.with_inputs(|t, x| {
        // Rates and accelerations of the path by central differences, with a relative error of about 1e-7.
        let dt = 1e-3;
        let [before, now, after] = [t - dt, t, t + dt].map(|t| joints(&params, t));
        let (rate, acceleration) = ((after - before) / (2.0 * dt), (after - 2.0 * now + before) / (dt * dt));
        let error = now - x.fixed_rows::<3>(0);
        let error_rate = rate - x.fixed_rows::<3>(3);
        let tau = arm.inverse_dynamics(t, x, &(acceleration + 2.0 * POLE * error_rate + POLE * POLE * error));
        ScaraInputs {
            tau1: tau[0],
            tau2: tau[1],
            lift: tau[2],
        }
    });
    // It starts at rest beside the path.
    let start = joints(&params, 0.0) + Joints::new(0.25, -0.3, 0.05);
    let start = [start[0], start[1], start[2], 0.0, 0.0, 0.0];
    let solution = Vern7::new()
        .rtol(1e-9)
        .atol(1e-9)
        .solve(&controlled, 0.0, T_END, start)?;

    let times: Vec<f64> = (0..=1500).map(|i| T_END * f64::from(i) / 1500.0).collect();
    let drawn: Vec<[f64; 2]> = solution
        .sample(times.iter().copied())?
        .iter()
        .map(|x| tool(&params, x))
        .collect();
    let wanted: Vec<[f64; 2]> = times.iter().map(|&t| star(t)).collect();
    let distance = |i: usize| (drawn[i][0] - wanted[i][0]).hypot(drawn[i][1] - wanted[i][1]);
    for i in [0, 125, 250, 500, 1500] {
        println!("{:4.1} s: {:.1e} m beside the path", times[i], distance(i));
    }

    let path = |points: &[[f64; 2]]| points.iter().map(|&[x, y]| (x, y)).collect();
    let errors = (0..times.len())
        .map(|i| (times[i], distance(i).max(1e-9).log10()))
        .collect();
    let figure = Figure {
        title: "A SCARA arm draws a star by computed torque".to_owned(),
        subtitle: format!("Started beside the path; both poles of each joint's error at \u{2212}{POLE} 1/s"),
        size: (1500, 800),
        legend: vec![
            (Line::solid(BLUE), "tool".to_owned()),
            (Line::dashed(GREY), "path".to_owned()),
            (Line::solid(VERMILION), "distance".to_owned()),
        ],
        columns: vec![
            Column::new(
                "Seen from above",
                Axis::linear("x (m)", 0.2..0.65),
                Axis::linear("y (m)", -0.1..0.35),
            ),
            Column::new(
                "Distance of the tool from the path",
                Axis::linear("time t (s)", 0.0..T_END),
                Axis::decades("distance (m)", -9.0..0.0),
            ),
        ],
        rows: vec![Row::new(vec![
            vec![
                Curve::new(Line::dashed(GREY), path(&wanted)),
                Curve::new(Line::solid(BLUE), path(&drawn)),
            ],
            vec![Curve::new(Line::solid(VERMILION), errors)],
        ])],
    }
    .with_equal_scales();
    println!();
    for path in figure.save(Path::new("out/scara/star"))? {
        println!("{}", path.display());
    }
    Ok(())
}
