//! Double pendulums with dry friction until they rest, compared with smooth ones: `cargo bench --bench dry_friction`.
//!
//! `-- COUNT` sets the number of initial conditions, by default 10,000. Runs on one core; steps are counted for a
//! sample of the initial conditions.

use std::error::Error;
use std::f64::consts::TAU;
use std::slice::from_ref;
use std::time::Instant;

use nalgebra::SVector;
use pendulum_core::Cast;
use pendulum_core::prelude::*;

mechanism! {
    /// Two equal rods of 1 kg and 1 m, with dry and viscous friction in both joints.
    Dry {
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body upper on ground: arm { joint: revolute(z), coordinate: theta1, dry_friction: 1.5, friction: 0.02 }
        body lower on upper: arm {
            joint: revolute(z) at [0, -1, 0], coordinate: theta2 absolute, dry_friction: 0.6, friction: 0.02,
        }
    }
}

mechanism! {
    /// Like `Dry`, but with viscous friction alone.
    Smooth {
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body upper on ground: arm { joint: revolute(z), coordinate: theta1, friction: 0.02 }
        body lower on upper: arm {
            joint: revolute(z) at [0, -1, 0], coordinate: theta2 absolute, friction: 0.02,
        }
    }
}

/// Number of initial conditions for which steps are counted.
const SAMPLE: usize = 500;

fn main() -> Result<(), Box<dyn Error>> {
    let count = std::env::args()
        .nth(1)
        .and_then(|text| text.parse().ok())
        .unwrap_or(10_000);
    let (dry, smooth) = (Dry::new(DryParams::default())?, Smooth::new(SmoothParams::default())?);
    measure("dry friction, 60 s", (&dry, 60.0), count)?;
    measure("viscous friction alone, 10 s", (&smooth, 10.0), count)?;
    let ends = Tsit5::new()
        .rtol(1e-8)
        .atol(1e-8)
        .ensemble(&[dry], 0.0, 60.0, &starts(count))?;
    let at_rest = ends.iter().filter(|x| x.rows(2, 2).amax() == 0.0).count();
    println!("{at_rest} of {count} rest");
    Ok(())
}

/// Initial angles that cover the square evenly.
fn starts(count: usize) -> Vec<SVector<f64, 4>> {
    let angle = |n: usize, ratio: f64| TAU * ((n as f64 * ratio).fract() - 0.5);
    let start = |n| [angle(n, 0.754_877_666), angle(n, 0.569_840_291), 0.0, 0.0];
    (0..count).map(|n| start(n).into()).collect()
}

/// Measures steps per second, alone and in lanes.
fn measure<M>(name: &str, (model, t1): (&M, f64), count: usize) -> Result<(), Box<dyn Error>>
where
    M: Cast<4, In<f64> = M> + System<f64, 4>,
{
    let (method, starts) = (Tsit5::new().rtol(1e-8).atol(1e-8), starts(count));
    let mut steps = 0;
    let alone = Instant::now();
    for &start in &starts[..SAMPLE.min(count)] {
        let mut stepper = method.stepper(model, 0.0, t1, start)?;
        stepper.run()?;
        steps += stepper.statistics().accepted + stepper.statistics().rejected;
    }
    let alone = alone.elapsed().as_secs_f64();
    let lanes = Instant::now();
    method.ensemble(from_ref(model), 0.0, t1, &starts)?;
    let lanes = lanes.elapsed().as_secs_f64() / count as f64 * SAMPLE.min(count) as f64;
    let rate = |seconds: f64| steps as f64 / seconds;
    println!(
        "{name}: {:.3e} steps/s alone, {:.3e} in lanes; {} steps and {:.1} us each",
        rate(alone),
        rate(lanes),
        steps / SAMPLE.min(count),
        lanes * 1e6 / SAMPLE.min(count) as f64,
    );
    Ok(())
}
