//! Heavy top whose axis draws cusps, loops and waves.
//!
//! `cargo run --release --example heavy_top` integrates three initial conditions of one top, checks the conserved
//! quantities, and draws the path of its axis into `out/heavy_top/`.

use std::error::Error;
use std::path::Path;

use charts::chart::{Axis, Column, Curve, Figure, Line, Row};
use charts::page::{BLUE, Picture};
use pendulum_core::prelude::*;

mechanism! {
    /// A disk on a massless rod that rotates about its lower end.
    HeavyTop {
        params { m: kg = 0.5, l: m = 0.1, r: m = 0.05, g: m/s^2 = 9.81 }
        gravity: [0, 0, -g],
        generate: [rhs, jacobian, energy, momentum],
        point middle on top at [0, 0, l],
        output middle: middle,
        body top on ground {
            solids: [disk(m, r, [0, 0, l])],
            joint: ball,
            orientation: o,
        }
    }
}

/// End time, in seconds.
const T_END: f64 = 2.0;
/// Spin about the axis, in rad/s.
const SPIN: f64 = 240.0;
/// Initial angle of the axis from the vertical, in rad.
const LEAN: f64 = 0.5;

fn main() -> Result<(), Box<dyn Error>> {
    let top = HeavyTop::new(HeavyTopParams::default())?;
    println!("{}", HeavyTop::EQUATIONS);
    // slow precession is m g l / (I spin); the axis starts at rest, against the precession, or ahead of it
    let HeavyTopParams { m, l, r, g } = HeavyTopParams::default();
    let precession = m * g * l / (m * r * r / 2.0 * SPIN);
    let starts = [
        ("At rest: cusps", 0.0),
        ("Backwards: loops", -1.0),
        ("Ahead: waves", 0.5),
    ];
    let mut columns = Vec::new();
    let mut row = Vec::new();
    for (name, times) in starts {
        let x0 = start(times * precession);
        let solution = Vern9::new()
            .rtol(1e-12)
            .atol(1e-12)
            .h_max(0.002)
            .solve(&top, 0.0, T_END, x0)?;
        let end = solution.end();
        let energy = top.energy(T_END, &end) / top.energy(0.0, &x0) - 1.0;
        let spin = end[HeavyTop::DOT_O + 2] - SPIN;
        println!("{name}: energy and spin change by {energy:.0e} and {spin:.0e}");
        let way = solution.x().iter().map(|x| {
            let middle = top.middle(0.0, x);
            (100.0 * middle[0], 100.0 * middle[1])
        });
        let axis = |name: &str| Axis::linear(name, -7.5..7.5);
        columns.push(Column::new(name, axis("x (cm)"), axis("y (cm)")));
        row.push(vec![Curve::new(Line::solid(BLUE), way.collect())]);
    }
    let figure = Figure {
        title: "The axis of a heavy top, seen from above".to_owned(),
        subtitle: format!("A disk of 0.5 kg on a rod of 10 cm, {SPIN} rad/s, over {T_END} s"),
        size: (1800, 760),
        legend: Vec::new(),
        columns,
        rows: vec![Row::new(row)],
    }
    .with_equal_scales();
    for path in figure.save(Path::new("out/heavy_top/axis"))? {
        println!("{}", path.display());
    }
    Ok(())
}

/// Initial state: leaning from the vertical to -y, and rotating about the vertical at this rate besides the spin.
fn start(precession: f64) -> SVector<f64, 7> {
    let (sine, cosine) = (LEAN / 2.0).sin_cos();
    let mut x = SVector::zeros();
    (x[HeavyTop::O], x[HeavyTop::O + 1]) = (cosine, sine);
    // the vertical in body coordinates
    x[HeavyTop::DOT_O + 1] = precession * LEAN.sin();
    x[HeavyTop::DOT_O + 2] = SPIN;
    x
}
