//! Charts of measured, fitted and predicted angles, of residuals, and of confidence ellipses.

use std::error::Error;
use std::f64::consts::TAU;

use charts::chart::{Axis, Column, Curve, Figure, Line, Row, Stroke};
use charts::page::{BLUE, ORANGE, VERMILION};
use pendulum_core::fit::Residuals;
use pendulum_core::prelude::*;

use super::{Arm, ArmFit, ArmParams, Run, SCENES, STEP};

const MEASURED: Line = Line {
    width: 7.0,
    ..Line::solid(ORANGE)
};
const COMPUTED: Line = Line {
    width: 2.4,
    ..Line::solid(BLUE)
};

/// Measured and computed angles of both runs, the first fitted and the second predicted.
pub(crate) fn angles(runs: [(&Run, &ArmFit); 2]) -> Result<Figure, Box<dyn Error>> {
    let mut rows = [("upper link", Vec::new()), ("lower link", Vec::new())];
    for (run, fitted) in runs {
        let params = ArmParams::from_array(fitted.parameters);
        let (arm, driven) = (Arm::new(params)?, run.arm(params)?);
        let mut computed = [Vec::new(), Vec::new()];
        for window in &fitted.windows {
            let motion = Rk4::new(STEP).solve(&driven, window.t0, window.t1, window.start)?;
            for (t, x) in motion.points() {
                for (curve, angle) in computed.iter_mut().zip(&arm.outputs(t, x)) {
                    curve.push((t, angle.to_degrees()));
                }
            }
            // windows are not joined
            computed.iter_mut().for_each(|curve| curve.push((window.t1, f64::NAN)));
        }
        for (((_, panels), name), computed) in rows.iter_mut().zip(["q1", "q2"]).zip(computed) {
            let measured = run
                .angles
                .times()
                .iter()
                .copied()
                .zip(run.values(name).iter().map(|q| q.to_degrees()))
                .step_by(10);
            panels.push(vec![
                Curve::new(MEASURED, measured.collect()),
                Curve::new(COMPUTED, computed),
            ]);
        }
    }
    Ok(Figure {
        title: "A real double pendulum, fitted and predicted".to_owned(),
        subtitle: "Windows of 0.5 s: parameters from run 1, states at the starts of windows from each run".to_owned(),
        size: (1600, 1100),
        legend: vec![(MEASURED, "measured".to_owned()), (COMPUTED, "computed".to_owned())],
        columns: ["run 1, fitted", "run 2, predicted"]
            .map(|title| {
                Column::new(
                    title,
                    Axis::linear("time t (s)", 0.0..10.0),
                    Axis::linear("angle (°)", -100.0..100.0),
                )
            })
            .into(),
        rows: rows
            .map(|(caption, panels)| Row {
                caption: caption.to_owned(),
                legend: Vec::new(),
                panels,
            })
            .into(),
    })
}

/// Residuals of run 1, with a row for each scene.
pub(crate) fn residuals(run: &Run, fits: &[ArmFit]) -> Figure {
    let curve = |fitted: &ArmFit, residuals: &Residuals| {
        let samples = run.angles.times().iter().zip(&residuals.values);
        let mut points = Vec::new();
        for window in &fitted.windows {
            let inside = samples.clone().filter(|&(t, _)| (window.t0..window.t1).contains(t));
            points.extend(inside.map(|(&t, residual)| (t, 1e3 * residual)));
            // windows are not joined
            points.push((window.t1, f64::NAN));
        }
        vec![Curve::new(
            Line {
                width: 1.6,
                ..Line::solid(BLUE)
            },
            points,
        )]
    };
    let rows = SCENES.iter().zip(fits).map(|((name, _), fitted)| Row {
        caption: (*name).to_owned(),
        legend: Vec::new(),
        panels: fitted
            .residuals
            .iter()
            .map(|residuals| curve(fitted, residuals))
            .collect(),
    });
    Figure {
        title: "What the scenes leave of run 1".to_owned(),
        subtitle: "Measured minus computed angles in windows of 0.5 s; the noise of the encoders is 0.2 mrad"
            .to_owned(),
        size: (1600, 1500),
        legend: Vec::new(),
        columns: ["upper link", "lower link"]
            .map(|title| {
                Column::new(
                    title,
                    Axis::linear("time t (s)", 0.0..10.0),
                    Axis::linear("residual (mrad)", -50.0..50.0),
                )
            })
            .into(),
        rows: rows.collect(),
    }
}

/// Confidence ellipses of 95 % of the frictions of both axles, with the published values.
pub(crate) fn ellipses(fitted: &ArmFit) -> Figure {
    let place = |name: &str| {
        fitted
            .estimates
            .iter()
            .position(|estimate| estimate.name == name)
            .unwrap_or(0)
    };
    // quantile of chi squared with two degrees of freedom
    let radius = (-2.0 * 0.05_f64.ln()).sqrt();
    let published = ArmParams::default();
    let of = |names: [&str; 2], published: [f64; 2]| {
        let [x, y] = names.map(place);
        let centre = [fitted.estimates[x].value, fitted.estimates[y].value];
        let covariance = &fitted.covariance;
        // Cholesky factor of the covariance of the two
        let a = covariance[(x, x)].sqrt();
        let b = covariance[(x, y)] / a;
        let c = (covariance[(y, y)] - b * b).max(0.0).sqrt();
        let points = (0..=200)
            .map(|n| (TAU * f64::from(n) / 200.0).sin_cos())
            .map(|(sin, cos)| (centre[0] + radius * a * cos, centre[1] + radius * (b * cos + c * sin)));
        let dot = |color, at: [f64; 2]| {
            Curve::new(
                Line {
                    stroke: Stroke::Dots,
                    width: 12.0,
                    ..Line::solid(color)
                },
                vec![(at[0], at[1])],
            )
        };
        vec![
            Curve::new(Line::solid(BLUE), points.collect()),
            dot(BLUE, centre),
            dot(VERMILION, published),
        ]
    };
    let dots = |color| Line {
        stroke: Stroke::Dots,
        width: 12.0,
        ..Line::solid(color)
    };
    Figure {
        title: "Friction of the axles".to_owned(),
        subtitle: "From every 25th sample of run 1, whose residuals are hardly correlated".to_owned(),
        size: (1600, 800),
        legend: vec![
            (dots(BLUE), "estimate, with its region of 95 %".to_owned()),
            (dots(VERMILION), "published".to_owned()),
        ],
        columns: ["upper axle", "lower axle"]
            .map(|title| {
                Column::new(
                    title,
                    Axis::linear("viscous friction (N m s)", -0.005..0.025),
                    Axis::linear("dry friction (N m)", 0.06..0.15),
                )
            })
            .into(),
        rows: vec![Row::new(vec![
            of(["viscous1", "dry1"], [published.viscous1, published.dry1]),
            of(["viscous2", "dry2"], [published.viscous2, published.dry2]),
        ])],
    }
}
