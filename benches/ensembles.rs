//! Ensembles beside the same trajectories one by one: `cargo bench --bench ensembles`.
//!
//! One core. Each figure is the median of ratios of times that were taken in turns.

use std::error::Error;
use std::time::Instant;

use nalgebra::SVector;
use pendulum_core::prelude::*;

mechanism! {
    /// Two rods of 1 kg and 1 m, the lower one on a stiff spring with a damper: what joins them hardly bends.
    Stiff {
        params { k: N m/rad = 1e5, c: N m s/rad = 1e3 }
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body upper on ground: arm { joint: revolute(z), coordinate: theta1, friction: 0.02 }
        body lower on upper: arm {
            joint: revolute(z) at [0, -1, 0], coordinate: theta2, spring: (k, 0), friction: c,
        }
    }
}

/// Rounds, and trajectories in each.
const ROUNDS: usize = 9;
const COUNT: usize = 128;

fn main() -> Result<(), Box<dyn Error>> {
    let stiff = |n: usize| {
        Stiff::new(StiffParams {
            k: 1e5 * (1.0 + n as f64 / COUNT as f64),
            ..Default::default()
        })
    };
    let models: Vec<_> = (0..COUNT).map(stiff).collect::<Result<_, _>>()?;
    let starts: Vec<_> = (0..COUNT)
        .map(|n| SVector::from([3.0 * n as f64 / COUNT as f64, 0.1, 0.0, 0.0]))
        .collect();
    compare("Rodas4", &Rodas4::new(), &models, &starts)?;
    compare("Rodas5P", &Rodas5P::new(), &models, &starts)?;
    Ok(())
}

/// The times of trajectories alone, in units of those in lanes.
fn compare<A>(name: &str, method: &A, models: &[Stiff], starts: &[SVector<f64, 4>]) -> Result<(), Box<dyn Error>>
where
    A: Method<Stiff, f64, 4> + Ensemble<Stiff, f64, 4>,
{
    let (mut ratios, mut fastest, mut steps) = (Vec::new(), f64::INFINITY, 0);
    for _ in 0..ROUNDS {
        let start = Instant::now();
        let mut ends = Vec::new();
        steps = 0;
        for (model, x) in models.iter().zip(starts) {
            let mut stepper = method.stepper(model, 0.0, 10.0, *x)?;
            ends.push(stepper.run()?);
            steps += stepper.statistics().accepted + stepper.statistics().rejected;
        }
        let alone = start.elapsed().as_secs_f64();
        let start = Instant::now();
        let in_lanes = method.ensemble(models, 0.0, 10.0, starts)?;
        let lanes = start.elapsed().as_secs_f64();
        assert_eq!(ends, in_lanes);
        ratios.push(alone / lanes);
        fastest = lanes.min(fastest);
    }
    ratios.sort_by(f64::total_cmp);
    let rate = COUNT as f64 / fastest;
    println!(
        "{name}: {:.2} times as many trajectories in lanes as alone; {rate:.0} per second of {} steps",
        ratios[ROUNDS / 2],
        steps / COUNT
    );
    Ok(())
}
