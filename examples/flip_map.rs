//! Time of the first flip of a double pendulum, over its two initial angles.
//!
//! `cargo run --release --example flip_map` takes 200 x 200 initial conditions on all cores, and draws the map into
//! `out/flip_map/`; `-- SIZE` sets another number along each side.

use std::error::Error;
use std::f64::consts::PI;
use std::path::Path;

use charts::chart::Axis;
use charts::heat::{Atlas, Map, Palette};
use charts::page::Picture;
use pendulum_core::prelude::*;

mechanism! {
    /// Two equal rods of 1 m without friction; both angles are measured from hanging.
    Rods {
        gravity: [0, -9.81, 0],
        generate: [rhs, taylor],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body upper on ground: arm { joint: revolute(z), coordinate: theta1 }
        body lower on upper: arm { joint: revolute(z) at [0, -1, 0], coordinate: theta2 absolute }
    }
}

/// Duration of each motion, in seconds.
const T_END: f64 = 30.0;

/// Time of the first flip of either rod; infinite if none flips.
fn first_flip(model: &Rods, theta1: f64, theta2: f64) -> Result<f64, String> {
    // The cosine of half an angle vanishes if the rod points straight up.
    let upright = |i: usize| Event::new(move |_t, x: &SVector<f64, 4>| (0.5 * x[i]).cos()).terminal();
    let method = Taylor::new().rtol(1e-8).atol(1e-8);
    let events = [upright(Rods::THETA1), upright(Rods::THETA2)];
    let solution = method.solve_with(model, 0.0, T_END, [theta1, theta2, 0.0, 0.0], &events);
    let solution = solution.map_err(|error| error.to_string())?;
    Ok(solution.events().first().map_or(f64::INFINITY, |flip| flip.t))
}

fn main() -> Result<(), Box<dyn Error>> {
    let size = match std::env::args().nth(1) {
        None => 200,
        Some(size) => size
            .parse::<usize>()
            .ok()
            .filter(|&size| size > 1)
            .ok_or("usage: flip_map [SIZE], SIZE above 1")?,
    };
    let model = Rods::new(RodsParams {})?;
    // Cells are sampled at their centres.
    let angle = |i: usize| PI * ((2 * i + 1) as f64 / size as f64 - 1.0);
    let row = |i: usize| {
        (0..size)
            .map(|j| first_flip(&model, angle(j), angle(i)))
            .collect::<Result<Vec<_>, _>>()
    };

    // Rows are interleaved over the cores, since neighbours take about the same time.
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let mut rows = vec![Vec::new(); size];
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..cores)
            .map(|core| {
                scope.spawn(move || {
                    (core..size)
                        .step_by(cores)
                        .map(|i| Ok((i, row(i)?)))
                        .collect::<Result<Vec<_>, String>>()
                })
            })
            .collect();
        for worker in workers {
            for (i, row) in worker.join().map_err(|_| "a thread panicked".to_owned())?? {
                rows[i] = row;
            }
        }
        Ok::<(), String>(())
    })?;
    let flips: Vec<f64> = rows.concat();
    let flipped = flips.iter().filter(|t| t.is_finite()).count();
    println!("{flipped} of {} flip within {T_END} s", flips.len());

    let degrees = |label: &str| Axis::linear(label, -180.0..180.0);
    let atlas = Atlas {
        title: "First flip of a double pendulum".to_owned(),
        subtitle: format!("Equal rods of 1 m without friction, from rest; white: none within {T_END} s"),
        legend: Vec::new(),
        columns: 1,
        maps: vec![Map {
            x: degrees("upper rod (°)"),
            y: degrees("lower rod (°)"),
            colors: Axis::decades("First flip (s)", 0.5_f64.log10()..T_END.log10()),
            palette: Palette::Rising,
            steps: 9,
            cells: flips
                .iter()
                .map(|t| if t.is_finite() { t.log10() } else { f64::NAN })
                .collect(),
            across: size,
            curves: Vec::new(),
        }],
    };
    println!("{}", atlas.save_png(Path::new("out/flip_map/first_flip"))?.display());
    Ok(())
}
