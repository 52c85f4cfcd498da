//! Bifurcation diagram of the driven pendulum with friction: the rates in a Poincaré section over the amplitude of the
//! drive.
//!
//! `cargo run --release --example bifurcations` takes 3000 amplitudes with twelve starts each; `SIZE` in the
//! environment sets another number of amplitudes. The table and its picture are in `out/`.

use std::error::Error;
use std::f64::consts::TAU;
use std::path::Path;

use charts::chart::{Axis as Scale, Column, Curve, Figure, Line, Row, Stroke};
use charts::page::{BLUE, INK, Picture, VERMILION};
use pendulum_core::prelude::*;
use pendulum_sweep::{Axis, Sweep, Table};

mechanism! {
    /// Pendulum of Baker and Gollub, "Chaotic Dynamics" (1990), with quality factor 2, driven at two thirds of its
    /// natural frequency. That frequency is 1 rad/s, and moments are in units of its weight.
    Driven {
        params { amplitude: N m }
        gravity: [0, -1, 0],
        generate: [rhs, taylor],
        body bob on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, friction: 0.5,
            torque: amplitude*cos(2 rad/s*t/3),
        }
    }
}

/// Period of the drive, in seconds.
const PERIOD: f64 = 3.0 * std::f64::consts::PI;
/// Number of periods skipped as transient, and number of periods recorded.
const PERIODS: [usize; 2] = [200, 20];
/// Range of amplitudes in the picture, in N m.
const AMPLITUDES: [f64; 2] = [1.0, 1.5];
/// Range of rates in the picture, in rad/s.
const RATES: [f64; 2] = [-0.6, 2.6];
/// Angles and rates at the start, in rad and rad/s: each amplitude takes all pairs.
const STARTS: ([f64; 4], [f64; 3]) = ([-2.0, -0.5, 0.1, 2.5], [-1.5, 0.0, 1.5]);
/// Mean rate, in turns per period of the drive, from which on a motion counts as turning one way.
const TURNING: f64 = 0.9;

fn main() -> Result<(), Box<dyn Error>> {
    let size = std::env::var("SIZE").map_or(Ok(3000), |size| size.parse())?;
    let file = format!("out/bifurcations_{size}.parquet");
    let times: Vec<f64> = (0..PERIODS[1]).map(|n| (PERIODS[0] + n) as f64 * PERIOD).collect();
    Sweep::grid(
        "bifurcations",
        [
            Axis::cells("amplitude", "N m", AMPLITUDES[0], AMPLITUDES[1], size),
            Axis::values("start", "rad", STARTS.0),
            Axis::values("push", "rad/s", STARTS.1),
        ],
    )
    .trajectories(
        Taylor::new().rtol(1e-9).atol(1e-9),
        (0.0, times[PERIODS[1] - 1]),
        |[amplitude, start, push]| Ok((Driven::new(DrivenParams { amplitude })?, [start, push])),
    )
    .at(times.clone())
    .in_lanes()
    .main(&file)?;
    if !Path::new(&file).exists() {
        return Ok(());
    }
    let table = Table::read(&file)?;
    let column = |name: &str, n: usize| &table[&*format!("{name} at {} s", times[n])];
    let kinds = [
        (INK, "swings, or turns to and fro"),
        (BLUE, "turns forward in each period"),
        (VERMILION, "turns backward in each period"),
    ];
    let kinds = kinds.map(|(color, name)| {
        let line = Line {
            width: 1.2,
            stroke: Stroke::Dots,
            ..Line::solid(color)
        };
        (line, name.to_owned())
    });
    let mut points = [const { Vec::new() }; 3];
    let (first, last) = (column("angle", 0), column("angle", PERIODS[1] - 1));
    for row in 0..table.rows() {
        let turns = (last[row] - first[row]) / TAU / (PERIODS[1] - 1) as f64;
        let kind = if turns > TURNING {
            1
        } else if turns < -TURNING {
            2
        } else {
            0
        };
        let rates = (0..PERIODS[1]).map(|n| column("dot(angle)", n)[row]);
        points[kind].extend(rates.map(|rate| (table["amplitude"][row], rate)));
    }
    let curves = kinds.iter().zip(points);
    let figure = Figure {
        title: "Bifurcations of a driven pendulum".to_owned(),
        subtitle: format!(
            "Once in each period of the drive, {} times after {} periods, from {} starts at each of {size} amplitudes",
            PERIODS[1],
            PERIODS[0],
            STARTS.0.len() * STARTS.1.len(),
        ),
        size: (1600, 1000),
        legend: kinds.to_vec(),
        columns: vec![Column::new(
            "",
            Scale {
                ticks: 11,
                ..Scale::linear("amplitude of the drive (weight)", AMPLITUDES[0]..AMPLITUDES[1])
            },
            Scale {
                ticks: 8,
                ..Scale::linear("rate at the section (rad/s)", RATES[0]..RATES[1])
            },
        )],
        rows: vec![Row::new(vec![
            curves.map(|((line, _), points)| Curve::new(*line, points)).collect(),
        ])],
    };
    let picture = figure.save_png(Path::new(&format!("out/bifurcations_{size}")))?;
    println!("{}", picture.display());
    Ok(())
}
