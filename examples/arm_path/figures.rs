//! The arm at work, and its errors, torques and computing times.

use std::error::Error;
use std::path::{Path, PathBuf};

use charts::chart::{Axis, Column, Curve, Figure, Line, Row};
use charts::page::{BLUE, GREEN, GREY, Picture, VERMILION};
use pendulum_core::prelude::*;
use pendulum_draw::Drawing;

use crate::{Arm, PERIOD, Run, T_END};

const FOLDER: &str = "out/arm_path";

pub(crate) fn arm(arm: &Arm, turn: &Solution<f64, 12>) -> Result<[PathBuf; 2], Box<dyn Error>> {
    let drawing = Drawing::new(arm, turn)
        .ghosts(3)
        .seen_from([1.0, 1.0, 0.9], [0.0, 0.0, 1.0]);
    drawing.picture(&Path::new(FOLDER).join("arm"))
}

pub(crate) fn errors(runs: &[Run]) -> Result<[PathBuf; 2], Box<dyn Error>> {
    let time = || Axis::linear("time t (s)", 0.0..T_END);
    let decades = |points: &[(f64, f64)]| points.iter().map(|&(t, value)| (t, value.log10())).collect();
    let (mut legend, mut panels) = (Vec::new(), [Vec::new(), Vec::new(), Vec::new()]);
    for (run, color) in runs.iter().zip([BLUE, GREEN, VERMILION]) {
        legend.push((Line::solid(color), run.name.to_owned()));
        for (panel, points) in panels
            .iter_mut()
            .zip([decades(&run.off), run.torque.clone(), decades(&run.time)])
        {
            panel.push(Curve::new(Line::dots(color), points));
        }
    }
    let period = (1e3 * PERIOD).log10();
    legend.push((Line::dashed(GREY), "sampling period".to_owned()));
    panels[2].push(Curve::new(Line::dashed(GREY), vec![(0.0, period), (T_END, period)]));
    let figure = Figure {
        title: "A UR5 draws a figure of eight by model-predictive control".to_owned(),
        subtitle: "Plans of 30 steps of 20 ms, one pass of iterative LQR at each sample; started beside the path"
            .to_owned(),
        size: (1800, 680),
        legend,
        columns: vec![
            Column::new(
                "Tip of the pen",
                time(),
                Axis::decades("distance from the path (mm)", -3.0..2.0),
            ),
            Column::new(
                "Largest torque",
                time(),
                Axis::linear("share of its limit (%)", 0.0..100.0),
            ),
            Column::new("Computation", time(), Axis::decades("time per sample (ms)", -2.0..2.0)),
        ],
        rows: vec![Row::new(panels.into())],
    };
    figure.save(&Path::new(FOLDER).join("errors"))
}
