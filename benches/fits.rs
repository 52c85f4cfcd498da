//! Times of fits to a measured double pendulum whose encoders are not aligned: with viscous friction, and with dry
//! friction and the rotor of a motor as well: `cargo bench -p benches --bench fits`. `bench/fits/scipy_fit.py` is the
//! first of them by SciPy.

use std::error::Error;
use std::fs::File;
use std::time::Instant;

use pendulum_core::fit::{Experiment, Fit, FitError, Fitted, Measurement, Table};
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

mechanism! {
    /// Eleven parameters.
    DryArm {
        params {
            i1: kg m^2 = 0.0535, i2: kg m^2 = 0.0239, r1: m = 0.3, r2: m = 0.184, rotor: kg m^2 = 7.66e-5,
            viscous1: N m s = 0.001, viscous2: N m s = 0.001, dry1: N m = 0.093, dry2: N m = 0.078,
            zero1: rad = 0, zero2: rad = 0,
        }
        input torque1: N m, input torque2: N m,
        gravity: [0, -9.81, 0],
        output q1: upper_angle - zero1,
        output q2: lower_angle - zero2,
        body upper on ground {
            mass: 0.559, com: [0, -r1, 0], inertia: i1 about joint,
            joint: revolute(z), coordinate: upper_angle, torque: torque1,
            friction: viscous1, dry_friction: dry1,
        }
        body lower on upper {
            mass: 0.604, com: [0, -r2, 0], inertia: i2 about joint,
            joint: revolute(z) at [0, -0.3, 0], coordinate: lower_angle, torque: torque2,
            friction: viscous2, dry_friction: dry2,
        }
        body rotor2 on upper { inertia: rotor, joint: revolute(z), motion: -6*lower_angle }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let table = Table::read_csv(File::open("../examples/measured/data/run_1.csv")?)?;
    let times = table.column("time_s")?;
    let angles = Measurement::new(times)?
        .output_with_noise("q1", table.column("q1_rad")?, 2e-4)?
        .output_with_noise("q2", table.column("q2_rad")?, 2e-4)?;
    let torques = TimeTable::linear(times, [table.column("tau1_Nm")?, table.column("tau2_Nm")?])?;
    let arm = Arm::new(ArmParams::default())?.with_law(torques.clone());
    let dry = DryArm::new(DryArmParams::default())?.with_law(torques);
    let fit = Fit::new(Rk4::new(0.004)).separate_windows(0.5);
    measure("viscous friction", || fit.run(&[Experiment::new(&arm, &angles)]))?;
    measure("dry friction", || fit.run(&[Experiment::new(&dry, &angles)]))
}

/// Measures fits, and prints the shortest time and the residuals.
fn measure<const P: usize>(name: &str, fit: impl Fn() -> Result<Fitted<4, P>, FitError>) -> Result<(), Box<dyn Error>> {
    let (mut shortest, mut residuals) = (f64::INFINITY, [0.0; 2]);
    for _ in 0..10 {
        let start = Instant::now();
        let fitted = fit()?;
        shortest = shortest.min(1e3 * start.elapsed().as_secs_f64());
        residuals = ["q1", "q2"].map(|name| 1e3 * fitted.rms(name));
    }
    let [q1, q2] = residuals;
    println!("{name}: {shortest:.1} ms, residuals {q1:.3} and {q2:.3} mrad");
    Ok(())
}
