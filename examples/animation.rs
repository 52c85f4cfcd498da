//! An animated GIF of the double pendulum, drawn from the plates of its declaration.
//!
//! `cargo run --release --example animation` writes `out/animation/double_pendulum.gif`.

use std::error::Error;
use std::path::Path;

use charts::animation::{Scene, save_gif};
use charts::page::{BLUE, GREY, VERMILION};
use pendulum_core::prelude::*;

mechanism! {
    /// Two rectangular plates that hang below each other, with friction in both axles.
    DoublePendulum {
        params {
            /// Mass of each plate.
            m: kg = 1,
            /// Half the width of each plate.
            w: m = 0.12,
            /// Height of a plate above its axle.
            top: m = 0.1,
            /// Length of a plate below its axle.
            l: m = 1.1,
            /// Distance between the axles.
            d: m = 1,
            gamma: N m s = 0.02,
        }
        gravity: [0, -9.81, 0],
        shape slab { solids: [plate(m, [[-w, top], [-w, -l], [w, -l], [w, top]])] }
        body upper on ground: slab { joint: revolute(z), coordinate: theta1, friction: gamma }
        body lower on upper: slab { joint: revolute(z) at [0, -d, 0], coordinate: theta2 absolute, friction: gamma }
    }
}

/// The length of the film in seconds, and its frames in a second.
const T_END: f64 = 12.0;
const RATE: u32 = 25;

fn main() -> Result<(), Box<dyn Error>> {
    let params = DoublePendulumParams::default();
    let model = DoublePendulum::new(params)?;
    let start = [2.2, 2.6, 0.0, 0.0];
    let solution = Vern9::new().rtol(1e-10).atol(1e-10).solve(&model, 0.0, T_END, start)?;

    let DoublePendulumParams { w, top, l, d, .. } = params;
    let corners = [[-w, top], [-w, -l], [w, -l], [w, top]];
    let frames = (0..=(T_END * f64::from(RATE)) as u32)
        .map(|i| {
            let x = solution.at(f64::from(i) / f64::from(RATE))?;
            let axle = place([0.0, 0.0], x[DoublePendulum::THETA1], [0.0, -d]);
            let plate = |axle, angle| corners.map(|corner| place(axle, angle, corner)).to_vec();
            Ok(Scene {
                polygons: vec![
                    (BLUE, plate([0.0, 0.0], x[DoublePendulum::THETA1])),
                    (VERMILION, plate(axle, x[DoublePendulum::THETA2])),
                ],
                disks: vec![(GREY, [0.0, 0.0], 0.03), (GREY, axle, 0.03)],
            })
        })
        .collect::<Result<Vec<_>, Box<dyn Error>>>()?;
    println!("{} frames", frames.len());
    let path = save_gif(Path::new("out/animation/double_pendulum"), 480, 2.4, RATE, &frames)?;
    println!("{}", path.display());
    Ok(())
}

/// A point of a plate, in the ground frame.
fn place(axle: [f64; 2], angle: f64, point: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [
        axle[0] + cos * point[0] - sin * point[1],
        axle[1] + sin * point[0] + cos * point[1],
    ]
}
