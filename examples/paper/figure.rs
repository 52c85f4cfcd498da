//! Fig. 2 of the paper: angles and rates against time, for three frictions.

use std::error::Error;
use std::path::{Path, PathBuf};

use pendulum_core::prelude::*;

use crate::chart::{Axis, BLUE, Curve, Figure, Line, Row, VERMILION};
use crate::{END, Motion};

/// Told apart by colour and by dashes.
const THETA1: Line = Line {
    color: BLUE,
    width: 2.5,
    dashed: false,
};
const THETA2: Line = Line {
    color: VERMILION,
    width: 2.5,
    dashed: true,
};

/// Points of a curve, less than two pixels apart.
const POINTS: u32 = 1000;

/// Draws the figure, and returns the files that it is in.
pub fn draw(motions: &[Motion]) -> Result<[PathBuf; 2], Box<dyn Error>> {
    let rows: Result<Vec<Row>, OutsideSpan> = motions.iter().map(row).collect();
    let figure = Figure {
        title: "Compound double pendulum with friction (Williams 2023, Fig. 2)".to_owned(),
        subtitle:
            "Released at rest from θ₁ = 0°, θ₂ = 4°;  m = 1 kg, I = 1 kg m², c = d = 1 m, g = 9.8 m/s², γ₁ = γ₂ = γ"
                .to_owned(),
        size: (1600, 1500),
        legend: vec![
            (THETA1, "θ₁, upper plate".to_owned()),
            (THETA2, "θ₂, lower plate".to_owned()),
        ],
        x: axis("time t (s)", 0.0, END, 5),
        columns: vec![
            axis("angle (degrees)", -5.0, 5.0, 5),
            axis("rate (degrees/s)", -20.0, 20.0, 5),
        ],
        rows: rows?,
    };
    figure.save(Path::new("out/paper/fig2"))
}

/// The panels of one friction: the angles, and the rates.
fn row(motion: &Motion) -> Result<Row, OutsideSpan> {
    let times: Vec<f64> = (0..=POINTS).map(|n| END * f64::from(n) / f64::from(POINTS)).collect();
    let states = motion.rk45.sample(times.iter().copied())?;
    let curve = |line, component: usize| Curve {
        line,
        points: times
            .iter()
            .zip(&states)
            .map(|(&t, x)| (t, x[component].to_degrees()))
            .collect(),
    };
    Ok(Row {
        caption: format!("γ = {} N m s", motion.gamma),
        panels: vec![
            vec![curve(THETA1, 0), curve(THETA2, 1)],
            vec![curve(THETA1, 2), curve(THETA2, 3)],
        ],
    })
}

fn axis(label: &str, from: f64, to: f64, ticks: usize) -> Axis {
    Axis {
        label: label.to_owned(),
        range: from..to,
        ticks,
    }
}
