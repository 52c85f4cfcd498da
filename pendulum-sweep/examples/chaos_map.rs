//! Chaos of a driven pendulum with friction: the largest Lyapunov exponent over the amplitude and the frequency of the
//! drive.
//!
//! `cargo run --release --example chaos_map` takes 400 x 400 drives, `SIZE=2000` in the environment four million. The
//! table and its picture are in `out/`.

use std::error::Error;
use std::path::Path;

use charts::chart::{Axis as Scale, Line};
use charts::heat::{Atlas, Map, Palette};
use charts::page::{INK, Picture};
use pendulum_core::prelude::*;
use pendulum_core::stability::Lyapunov;
use pendulum_sweep::{Axis, Sweep, Table};

mechanism! {
    /// Pendulum of Baker and Gollub, "Chaotic Dynamics" (1990), with quality factor 2. Its natural frequency is 1
    /// rad/s, and moments are in units of its weight.
    Driven {
        params { amplitude: N m, frequency: rad/s }
        gravity: [0, -1, 0],
        body bob on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, friction: 0.5,
            torque: amplitude*cos(frequency*t),
        }
    }
}

/// Axes of the map, in N m and in rad/s.
const AMPLITUDES: [f64; 2] = [0.9, 1.7];
const FREQUENCIES: [f64; 2] = [0.3, 0.9];

fn main() -> Result<(), Box<dyn Error>> {
    let size = std::env::var("SIZE").map_or(Ok(400), |size| size.parse())?;
    let file = format!("out/chaos_map_{size}.parquet");
    let axis = |name, unit, [from, to]: [f64; 2]| Axis::cells(name, unit, from, to, size);
    let lyapunov = Lyapunov::new().tolerance(1e-7).transient(200.0).duration(600.0);
    Sweep::grid(
        "chaos map",
        [
            axis("amplitude", "N m", AMPLITUDES),
            axis("frequency", "rad/s", FREQUENCIES),
        ],
    )
    .exponents::<1, _, _, _>(lyapunov, |[amplitude, frequency]| {
        Ok((Driven::new(DrivenParams { amplitude, frequency })?, [0.1, 0.0]))
    })
    .main(&file)?;
    if !Path::new(&file).exists() {
        return Ok(());
    }
    let table = Table::read(&file)?;
    let chaotic = |row: &usize| table["exponent"][*row] > 3.0 * table["uncertainty"][*row].max(1e-3);
    let count = (0..table.rows()).filter(chaotic).count();
    println!("{count} of {} are chaotic", table.rows());
    let scale = |label: &str, [from, to]: [f64; 2]| Scale {
        ticks: 9,
        ..Scale::linear(label, from..to)
    };
    let zero = Line {
        width: 0.9,
        ..Line::solid(INK)
    };
    let atlas = Atlas {
        title: "Chaos of a driven pendulum".to_owned(),
        subtitle: "From near rest, after 200 s, over 600 s; chaotic where it is red".to_owned(),
        legend: vec![(zero, "exponent zero".to_owned())],
        columns: 1,
        maps: vec![
            Map {
                x: scale("frequency of the drive (rad/s)", FREQUENCIES),
                y: scale("amplitude of the drive (weight)", AMPLITUDES),
                colors: Scale::linear("Largest Lyapunov exponent (1/s)", -0.25..0.25),
                palette: Palette::Signed,
                steps: 50,
                cells: table["exponent"].to_vec(),
                across: size,
                curves: Vec::new(),
            }
            .with_zeros(zero, size / 8),
        ],
    };
    let picture = atlas.save_png(Path::new(&format!("out/chaos_map_{size}")))?;
    println!("{}", picture.display());
    Ok(())
}
