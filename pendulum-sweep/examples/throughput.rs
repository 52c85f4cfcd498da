//! Overhead of a sweep over the integration itself: the processor time of a sweep over double pendulums (100 steps of
//! `Rk4` each) into a Parquet file, compared with one group of lanes alone, and the peak memory. Linux only.
//!
//! `cargo run --release --example throughput` takes ten million trajectories, `POINTS=100000000` in the environment
//! more.

use std::error::Error;
use std::fs;
use std::time::Instant;

use pendulum_core::prelude::*;
use pendulum_sweep::{Arguments, Draw, Sweep};

mechanism! {
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

const METHOD: fn() -> Rk4 = || Rk4::new(0.01);
const T_END: f64 = 1.0;
/// Trajectories of the group: the lanes of the widest registers, four registers deep.
const GROUP: usize = 32;

/// Processor time of all threads so far, in seconds.
fn processor_time() -> Result<f64, Box<dyn Error>> {
    let stat = fs::read_to_string("/proc/self/stat")?;
    let fields: Vec<&str> = stat.rsplit(')').next().ok_or("no fields")?.split_whitespace().collect();
    let ticks = fields[11].parse::<f64>()? + fields[12].parse::<f64>()?;
    Ok(ticks / 100.0)
}

/// Peak memory so far, in MB.
fn most_memory() -> Result<f64, Box<dyn Error>> {
    let status = fs::read_to_string("/proc/self/status")?;
    let line = status
        .lines()
        .find(|line| line.starts_with("VmHWM"))
        .ok_or("no VmHWM")?;
    Ok(line.split_whitespace().nth(1).ok_or("no number")?.parse::<f64>()? / 1000.0)
}

/// Processor time per trajectory in one group of lanes alone, in seconds.
fn time_alone() -> Result<f64, Box<dyn Error>> {
    let models = [DoublePendulum::new(DoublePendulumParams::default())?];
    let starts: Vec<SVector<f64, 4>> = (0..GROUP)
        .map(|n| SVector::from([0.1 * n as f64, -0.2, 0.0, 0.0]))
        .collect();
    let (since, mut groups, mut sum) = (processor_time()?, 0, 0.0);
    while processor_time()? < since + 5.0 {
        for _ in 0..100 {
            sum += METHOD().ensemble(&models, 0.0, T_END, &starts)?[0][0];
            groups += 1;
        }
    }
    assert!(sum.is_finite());
    Ok((processor_time()? - since) / f64::from(groups * GROUP as i32))
}

fn main() -> Result<(), Box<dyn Error>> {
    let points = std::env::var("POINTS").map_or(Ok(10_000_000), |points| points.parse())?;
    let arguments = Arguments::parse(std::env::args().skip(1))?;
    let before = time_alone()?;
    let (since, clock) = (processor_time()?, Instant::now());
    let angle = |name| Draw::uniform(name, "rad", -3.0, 3.0);
    Sweep::random("throughput", [angle("upper"), angle("lower")], points, 1)
        .ends(METHOD(), (0.0, T_END), |[upper, lower]| {
            Ok((
                DoublePendulum::new(DoublePendulumParams::default())?,
                [upper, lower, 0.0, 0.0],
            ))
        })
        .rows_per_shard(3 << 15)
        .obey(arguments, "out/throughput.parquet")?;
    let (time, wall) = (processor_time()? - since, clock.elapsed().as_secs_f64());
    let memory = most_memory()?;
    fs::remove_file("out/throughput.parquet")?;
    let after = time_alone()?;
    let alone = (before + after) / 2.0;
    println!(
        "a group of lanes alone: {:.0} and {:.0} ns for each trajectory, before and after",
        1e9 * before,
        1e9 * after
    );
    println!(
        "the sweep: {:.0} ns of processor time for each, {:.3} times that; {:.3e} a second, as {:.2} such groups; \
         at most {:.0} MB",
        1e9 * time / points as f64,
        time / points as f64 / alone,
        points as f64 / wall,
        points as f64 / wall * alone,
        memory
    );
    Ok(())
}
