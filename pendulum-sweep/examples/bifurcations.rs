//! Bifurcation diagram of the driven pendulum with friction: the rates in a Poincaré section over the amplitude of the
//! drive.
//!
//! `cargo run --release --example bifurcations` takes 4000 amplitudes, `SIZE=100000` in the environment a hundred
//! thousand. The table and its picture are in `out/`.

use std::error::Error;
use std::path::Path;

use charts::chart::Axis as Scale;
use charts::heat::{Atlas, Map};
use charts::page::Picture;
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
const PERIODS: [usize; 2] = [200, 100];
/// Range of amplitudes in the picture, in N m.
const AMPLITUDES: [f64; 2] = [1.0, 1.5];
/// Range of rates in the picture, in rad/s.
const RATES: [f64; 2] = [-0.5, 2.5];
/// Number of cells of the picture, across and up.
const CELLS: [usize; 2] = [500, 500];

fn main() -> Result<(), Box<dyn Error>> {
    let size = std::env::var("SIZE").map_or(Ok(4000), |size| size.parse())?;
    let file = format!("out/bifurcations_{size}.parquet");
    let times: Vec<f64> = (0..PERIODS[1]).map(|n| (PERIODS[0] + n) as f64 * PERIOD).collect();
    Sweep::grid(
        "bifurcations",
        [Axis::cells("amplitude", "N m", AMPLITUDES[0], AMPLITUDES[1], size)],
    )
    .trajectories(
        Taylor::new().rtol(1e-9).atol(1e-9),
        (0.0, times[PERIODS[1] - 1]),
        |[amplitude]| Ok((Driven::new(DrivenParams { amplitude })?, [0.1, 0.0])),
    )
    .at(times.clone())
    .in_lanes()
    .main(&file)?;
    if !Path::new(&file).exists() {
        return Ok(());
    }
    let table = Table::read(&file)?;
    let mut cells = vec![0.0_f64; CELLS[0] * CELLS[1]];
    let place = |x: f64, [from, to]: [f64; 2], cells: usize| {
        let part = (x - from) / (to - from);
        (0.0..1.0).contains(&part).then_some((part * cells as f64) as usize)
    };
    for t in &times {
        for (&amplitude, &rate) in table["amplitude"].iter().zip(&table[&*format!("dot(angle) at {t} s")]) {
            if let (Some(x), Some(y)) = (place(amplitude, AMPLITUDES, CELLS[0]), place(rate, RATES, CELLS[1])) {
                cells[y * CELLS[0] + x] += 1.0;
            }
        }
    }
    // mean number of points in a column of cells
    let all = (size * PERIODS[1]) as f64 / CELLS[0] as f64;
    let cells = cells
        .into_iter()
        .map(|count| (count / all).log10())
        .map(|part| if part.is_finite() { part } else { f64::NAN });
    let atlas = Atlas {
        title: "Bifurcations of a driven pendulum".to_owned(),
        subtitle: format!("{size} amplitudes, {} periods each", PERIODS[1]),
        legend: Vec::new(),
        columns: 1,
        maps: vec![Map {
            x: Scale::linear("Amplitude of the drive (weight)", AMPLITUDES[0]..AMPLITUDES[1]),
            y: Scale::linear("Rate at the section (rad/s)", RATES[0]..RATES[1]),
            colors: Scale::decades("Part of the points", -4.0..0.0),
            steps: 8,
            cells: cells.collect(),
            across: CELLS[0],
            curves: Vec::new(),
        }],
    };
    let picture = atlas.save_png(Path::new(&format!("out/bifurcations_{size}")))?;
    println!("{}", picture.display());
    Ok(())
}
