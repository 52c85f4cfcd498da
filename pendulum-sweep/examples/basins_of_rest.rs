//! Basins of rest of a double pendulum with dry friction: the resting place and the number of turns, over the initial
//! rates with which the hanging pendulum is thrown.
//!
//! `cargo run --release --example basins_of_rest` takes 400 x 400 throws, `SIZE=2000` in the environment four million.
//! The table and its picture are in `out/`.

use std::error::Error;
use std::f64::consts::TAU;
use std::path::Path;

use charts::chart::Axis as Scale;
use charts::heat::{Atlas, Map, Palette};
use charts::page::Picture;
use pendulum_core::prelude::*;
use pendulum_sweep::{Axis, Sweep, Table};

mechanism! {
    /// Two equal rods of 1 kg and 1 m with friction in both joints; both angles are measured from hanging.
    Rods {
        params { mu1: N m = 1.5, mu2: N m = 0.6 }
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body upper on ground: arm { joint: revolute(z), coordinate: theta1, dry_friction: mu1 }
        body lower on upper: arm {
            joint: revolute(z) at [0, -1, 0], coordinate: theta2 absolute, dry_friction: mu2,
        }
    }
}

/// End time in seconds, by which all throws rest.
const T_END: f64 = 60.0;
/// The fastest throw, in rad/s.
const FASTEST: f64 = 12.0;

fn main() -> Result<(), Box<dyn Error>> {
    let size = std::env::var("SIZE").map_or(Ok(400), |size| size.parse())?;
    let file = format!("out/basins_of_rest_{size}.parquet");
    let rate = |name| Axis::cells(name, "rad/s", -FASTEST, FASTEST, size);
    Sweep::grid("basins of rest", [rate("lower"), rate("upper")])
        .ends(Vern7::new().rtol(1e-8).atol(1e-8), (0.0, T_END), |[lower, upper]| {
            Ok((Rods::new(RodsParams::default())?, [0.0, 0.0, upper, lower]))
        })
        .main(&file)?;
    if !Path::new(&file).exists() {
        return Ok(());
    }
    let table = Table::read(&file)?;
    let rests = |row: usize| {
        ["dot(theta1)", "dot(theta2)"]
            .iter()
            .all(|rate| table[rate][row] == 0.0)
    };
    let at_rest = (0..table.rows()).filter(|&row| rests(row)).count();
    println!("{at_rest} of {} rest after {T_END} s", table.rows());
    let throws = |label: &str| Scale::linear(label, -FASTEST..FASTEST);
    let map = |label: &str, range: std::ops::Range<f64>, steps: usize, cell: &dyn Fn(f64) -> f64| Map {
        x: throws("upper rod at the start (rad/s)"),
        y: throws("lower rod at the start (rad/s)"),
        colors: Scale::linear(label, range),
        palette: Palette::Signed,
        steps,
        cells: table["theta2"].iter().map(|&angle| cell(angle)).collect(),
        across: size,
        curves: Vec::new(),
    };
    let turns = |angle: f64| (angle / TAU).round();
    let atlas = Atlas {
        title: "Where a double pendulum with dry friction rests".to_owned(),
        subtitle: "Equal rods of 1 m, thrown from hanging".to_owned(),
        legend: Vec::new(),
        columns: 2,
        maps: vec![
            map("Turns of the lower rod", -3.5..3.5, 7, &turns),
            map("Lower rod at rest (°)", -8.0..8.0, 16, &|angle| {
                (angle - TAU * turns(angle)).to_degrees()
            }),
        ],
    };
    let picture = atlas.save_png(Path::new(&format!("out/basins_of_rest_{size}")))?;
    println!("{}", picture.display());
    Ok(())
}
