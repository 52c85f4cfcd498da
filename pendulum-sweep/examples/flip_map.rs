//! Time of the first flip of a double pendulum, over its two initial angles: a map that may take hours.
//!
//! `cargo run --release --example flip_map` takes 400 x 400 initial conditions; `SIZE=4000` in the environment takes 16
//! million. A killed run continues when it is started again. `-- --shard 0/2` and `-- --shard 1/2` share the work
//! between two processes, and `-- --merge` merges their results. The table and its picture are in `out/`.

use std::error::Error;
use std::f64::consts::PI;
use std::path::Path;

use charts::chart::Axis as Scale;
use charts::heat::{Atlas, Map, Palette};
use charts::page::Picture;
use pendulum_core::prelude::*;
use pendulum_sweep::{Axis, Sweep, Table};

mechanism! {
    /// Two equal rods of 1 m without friction; both angles are measured from hanging.
    Rods {
        gravity: [0, -9.81, 0],
        generate: [rhs, taylor],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body upper on ground: arm { joint: revolute(z), coordinate: theta1 }
        body lower on upper: arm { joint: revolute(z) at [0, -1, 0], coordinate: theta2 absolute }
        // zero if the rod points straight up
        event upper_flips: cos(theta1/2),
        event lower_flips: cos(theta2/2),
    }
}

/// Duration of each motion, in seconds.
const T_END: f64 = 30.0;

fn main() -> Result<(), Box<dyn Error>> {
    let size = std::env::var("SIZE").map_or(Ok(400), |size| size.parse())?;
    let file = format!("out/flip_map_{size}.parquet");
    let angle = |name| Axis::cells(name, "rad", -PI, PI, size);
    Sweep::grid("flip map", [angle("lower"), angle("upper")])
        .trajectories(Taylor::new().rtol(1e-8).atol(1e-8), (0.0, T_END), |[lower, upper]| {
            Ok((Rods::new(RodsParams {})?, [upper, lower, 0.0, 0.0]))
        })
        .event("upper flips", |rods| rods.upper_flips_event().terminal())
        .event("lower flips", |rods| rods.lower_flips_event().terminal())
        .in_lanes()
        .main(&file)?;
    if !Path::new(&file).exists() {
        return Ok(());
    }
    let table = Table::read(&file)?;
    let first = table["t of upper flips"].iter().zip(&table["t of lower flips"]);
    let cells: Vec<f64> = first.map(|(upper, lower)| upper.min(*lower).log10()).collect();
    let flipped = cells.iter().filter(|t| t.is_finite()).count();
    println!("{flipped} of {} flip within {T_END} s", table.rows());
    let degrees = |label: &str| Scale::linear(label, -180.0..180.0);
    let atlas = Atlas {
        title: "First flip of a double pendulum".to_owned(),
        subtitle: format!("Equal rods of 1 m without friction, from rest; white: none within {T_END} s"),
        legend: Vec::new(),
        columns: 1,
        maps: vec![Map {
            x: degrees("upper rod (°)"),
            y: degrees("lower rod (°)"),
            colors: Scale::decades("First flip (s)", 0.5_f64.log10()..T_END.log10()),
            palette: Palette::Rising,
            steps: 9,
            cells,
            across: size,
            curves: Vec::new(),
        }],
    };
    let picture = atlas.save_png(Path::new(&format!("out/flip_map_{size}")))?;
    println!("{}", picture.display());
    Ok(())
}
