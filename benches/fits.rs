//! Time of a fit to a measured double pendulum, with viscous friction and encoders that are not aligned:
//! `cargo bench -p benches --bench fits`. `bench/fits/scipy_fit.py` is the same fit by SciPy.

use std::error::Error;
use std::fs::File;
use std::time::Instant;

use pendulum_core::fit::{Experiment, Fit, Measurement, Table};
use pendulum_core::inputs::TimeTable;
use pendulum_core::prelude::*;

mechanism! {
    Arm {
        params {
            i1: kg m^2 = 0.0535, i2: kg m^2 = 0.0239, r1: m = 0.3, r2: m = 0.184,
            viscous1: N m s = 0.001, viscous2: N m s = 0.001, zero1: rad = 0, zero2: rad = 0,
        }
        input torque1: N m, input torque2: N m,
        gravity: [0, -9.81, 0],
        output q1: upper_angle - zero1,
        output q2: lower_angle - zero2,
        body upper on ground {
            mass: 0.559, com: [0, -r1, 0], inertia: i1 about joint,
            joint: revolute(z), coordinate: upper_angle, friction: viscous1, torque: torque1,
        }
        body lower on upper {
            mass: 0.604, com: [0, -r2, 0], inertia: i2 about joint,
            joint: revolute(z) at [0, -0.3, 0], coordinate: lower_angle, friction: viscous2, torque: torque2,
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let table = Table::read_csv(File::open("../examples/measured/data/run_1.csv")?)?;
    let times = table.column("time_s")?;
    let angles = Measurement::new(times)?
        .output_with_noise("q1", table.column("q1_rad")?, 2e-4)?
        .output_with_noise("q2", table.column("q2_rad")?, 2e-4)?;
    let torques = TimeTable::linear(times, [table.column("tau1_Nm")?, table.column("tau2_Nm")?])?;
    let arm = Arm::new(ArmParams::default())?.with_law(torques);
    let fit = Fit::new(Rk4::new(0.004)).separate_windows(0.5);
    for _ in 0..5 {
        let start = Instant::now();
        let fitted = fit.run(&[Experiment::new(&arm, &angles)])?;
        let [q1, q2] = ["q1", "q2"].map(|name| 1e3 * fitted.rms(name));
        println!(
            "{:.1} ms, residuals {q1:.3} and {q2:.3} mrad",
            1e3 * start.elapsed().as_secs_f64()
        );
    }
    Ok(())
}
