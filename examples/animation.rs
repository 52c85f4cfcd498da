//! Animated GIF of a double pendulum, drawn from the plates of its declaration.
//!
//! `cargo run --release --example animation` writes `out/animation/double_pendulum.gif`.

use std::error::Error;

use pendulum_core::prelude::*;
use pendulum_draw::Drawing;

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
        point tip on lower at [0, -l, 0],
        generate: [rhs, shapes],
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let model = DoublePendulum::new(DoublePendulumParams::default())?;
    let solution = Vern9::new()
        .rtol(1e-10)
        .atol(1e-10)
        .solve(&model, 0.0, 12.0, [2.2, 2.6, 0.0, 0.0])?;
    let path = Drawing::new(&model, &solution).animation("out/animation/double_pendulum".as_ref())?;
    println!("{}", path.display());
    Ok(())
}
