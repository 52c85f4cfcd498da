//! Steps per second of each OpenCL device of this machine, compared with all cores and their SIMD lanes:
//! `cargo run --release --features opencl --example devices`.

use std::error::Error;
use std::time::Instant;

use pendulum_core::Cast;
use pendulum_core::prelude::*;
use pendulum_sweep::opencl::{Declared, Device};
use pendulum_sweep::{Draw, Failure, Sweep, declared};

declared! {
    /// Compound double pendulum with friction of Williams (2023).
    DoublePendulum {
        params { gamma: N m s = 0.1 }
        gravity: [0, -9.8, 0],
        generate: [rhs],
        shape plate { mass: 1, inertia: 1, com: [0, -1, 0] }
        body upper on ground: plate { joint: revolute(z), coordinate: theta1, friction: gamma }
        body lower on upper: plate {
            joint: revolute(z) at [0, -1, 0], coordinate: theta2 absolute, friction: gamma,
        }
    }
}

declared! {
    /// Franka Emika Panda: seven revolute joints, falling.
    Panda {
        gravity: [0, 0, -9.81],
        generate: [rhs],
        body b1 on ground {
            mass: 4.970684, com: [0.003875, 0.002081, -0.04762],
            inertia: [0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.019169],
            joint: revolute(z) at [0.0, 0.0, 0.333],
            coordinate: q1,
        }
        body b2 on b1 {
            mass: 0.646926, com: [-0.003141, -0.02872, 0.003495],
            inertia: [0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704],
            joint: revolute(z) rpy [-pi/2, 0, 0],
            coordinate: q2,
        }
        body b3 on b2 {
            mass: 3.228604, com: [0.027518, 0.039252, -0.066502],
            inertia: [0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805],
            joint: revolute(z) at [0.0, -0.316, 0.0] rpy [pi/2, 0, 0],
            coordinate: q3,
        }
        body b4 on b3 {
            mass: 3.587895, com: [-0.05317, 0.104419, 0.027454],
            inertia: [0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641],
            joint: revolute(z) at [0.0825, 0.0, 0.0] rpy [pi/2, 0, 0],
            coordinate: q4,
        }
        body b5 on b4 {
            mass: 1.225946, com: [-0.011953, 0.041065, -0.038437],
            inertia: [0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229],
            joint: revolute(z) at [-0.0825, 0.384, 0.0] rpy [-pi/2, 0, 0],
            coordinate: q5,
        }
        body b6 on b5 {
            mass: 1.666555, com: [0.060149, -0.014117, -0.010517],
            inertia: [0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341],
            joint: revolute(z) rpy [pi/2, 0, 0],
            coordinate: q6,
        }
        body b7 on b6 {
            mass: 1.495522, com: [0.001720874298, 0.001360354417, 0.100485281149],
            inertia: [0.016529853713, 0.014107248642, 0.006676955557, 0.000394892297, -0.000706695711, -0.001051105327],
            joint: revolute(z) at [0.088, 0.0, 0.0] rpy [pi/2, 0, 0],
            coordinate: q7,
        }
    }
}

/// Number of trajectories of each measurement.
const TRAJECTORIES: usize = 1 << 17;

/// Steps per second of a method in an ensemble, from its second run on.
fn rate<M, const N: usize>(
    method: impl Ensemble<M, f64, N> + std::fmt::Debug + Sync,
    steps: usize,
    model: impl Fn() -> Result<M, Failure> + Sync,
) -> Result<f64, Box<dyn Error>>
where
    M: Cast<N>,
{
    let sweep = Sweep::random("rates", [Draw::uniform("angle", "rad", -1.0, 1.0)], TRAJECTORIES, 1);
    let job = sweep
        .ends(method, (0.0, 1e-3 * steps as f64), |[angle]| Ok((model()?, [angle; N])))
        .quiet();
    let mut best = f64::INFINITY;
    for _ in 0..3 {
        let since = Instant::now();
        let table = job.run()?;
        assert!(table.failures().is_empty(), "{:?}", table.failures().first_key_value());
        best = best.min(since.elapsed().as_secs_f64());
    }
    Ok((TRAJECTORIES * steps) as f64 / best)
}

fn compare<M, const N: usize>(
    name: &str,
    steps: usize,
    model: impl Fn() -> Result<M, Failure> + Sync,
) -> Result<(), Box<dyn Error>>
where
    M: Cast<N> + Declared,
    Rk4: Ensemble<M, f64, N> + Method<M::In<f64>, f64, N> + Method<M::In<f32>, f32, N>,
{
    let method = Rk4::new(1e-3);
    println!("{name}, Rk4, steps a second:");
    println!("  {:9.2e}  all cores, f64", rate::<M, N>(method, steps, &model)?);
    for device in Device::all()? {
        let kind = if device.is_gpu() { "GPU" } else { "no GPU" };
        match device.method::<M, _>(method) {
            Ok(on_device) => println!(
                "  {:9.2e}  {} ({kind}), f64",
                rate(on_device, steps, &model)?,
                device.name()
            ),
            Err(error) => println!("  {error}"),
        }
        let single = device.method_in_single::<M, _>(method)?;
        println!(
            "  {:9.2e}  {} ({kind}), f32",
            rate(single, steps, &model)?,
            device.name()
        );
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    compare("double pendulum", 1000, || {
        Ok(DoublePendulum::new(DoublePendulumParams::default())?)
    })?;
    compare("Panda", 100, || Ok(Panda::new(PandaParams {})?))
}
