//! Friction with a memory, fitted to one run and compared with another.

use std::error::Error;

use pendulum_core::WithInputs;
use pendulum_core::fit::{Experiment, Fit, Fitted, Measurement};
use pendulum_core::inputs::{Generic, TimeTable};
use pendulum_core::prelude::*;

use super::{ArmFit, ArmParams, Run, WINDOW};

mechanism! {
    /// The arm of `main.rs` with bristles in place of dry friction (P. R. Dahl, "A solid friction model", 1968): they
    /// bend as an axle begins to turn, and slide when they are bent by 1. Friction rises at low rates (Stribeck).
    Bristled {
        params {
            m1: kg, m2: kg, l: m,
            i1: kg m^2, i2: kg m^2, r1: m, r2: m, rotor: kg m^2,
            viscous1: N m s, viscous2: N m s, dry1: N m, dry2: N m, zero1: rad, zero2: rad,
            /// Turns of the axles that bend bristles.
            slide1: rad, slide2: rad,
            /// Friction at rest beyond dry friction, and the rate at which a third of it is left.
            rise1: N m, rise2: N m, slow: rad/s,
            /// Shortest time in which bristles bend.
            bend: s,
        }
        input torque1: N m, input torque2: N m,
        gravity: [0, -9.81, 0],
        let rate1 = dot(upper_angle), let rate2 = dot(lower_angle),
        state bent1 { unit: 1, rate: (rate1 - abs(rate1)*bent1)/(slide1 + bend*abs(rate1)) }
        state bent2 { unit: 1, rate: (rate2 - abs(rate2)*bent2)/(slide2 + bend*abs(rate2)) }
        output q1: upper_angle - zero1, output q2: lower_angle - zero2, output bristle1: bent1, output bristle2: bent2,
        body upper on ground {
            mass: m1, com: [0, -r1, 0], inertia: i1 about joint, joint: revolute(z), coordinate: upper_angle,
            torque: torque1 - (dry1 + rise1*exp(-(rate1/slow)^2))*bent1, friction: viscous1,
        }
        body lower on upper {
            mass: m2, com: [0, -r2, 0], inertia: i2 about joint, joint: revolute(z) at [0, -l, 0],
            coordinate: lower_angle,
            torque: torque2 - (dry2 + rise2*exp(-(rate2/slow)^2))*bent2, friction: viscous2,
        }
        body rotor2 on upper { inertia: rotor, joint: revolute(z), motion: -6*lower_angle }
    }
}

type Driven = WithInputs<Bristled, Generic<TimeTable<2>>, 2>;

/// Step of the integration in s, no longer than `bend`.
const STEP: f64 = 0.002;
/// Deviation of the bristles at the starts of windows, which are between -1 and 1.
const BENT: f64 = 0.6;
const FREE: [&str; 16] = [
    "i1", "i2", "r1", "r2", "rotor", "viscous1", "viscous2", "dry1", "dry2", "zero1", "zero2", "slide1", "slide2",
    "rise1", "rise2", "slow",
];

/// Fits bristles to the first run, from the estimates of dry friction and with its residuals as noise, and predicts the
/// second run.
pub(crate) fn compare(dry: &ArmFit, runs: [&Run; 2]) -> Result<(), Box<dyn Error>> {
    let noise = ["q1", "q2"].map(|name| dry.rms(name));
    let [first, second] = runs.map(|run| measured(run, noise));
    let fit = || {
        let fit = Fit::new(Rk4::new(STEP))
            .separate_windows(WINDOW)
            .bounds("slow", 0.05, 3.0);
        let fit = fit.bounds("slide1", 5e-5, 0.5).bounds("slide2", 5e-5, 0.5);
        fit.bounds("rise1", 0.0, 1.0).bounds("rise2", 0.0, 1.0)
    };
    let bristled = driven(runs[0], guess(dry))?;
    let fitted: Fitted<6, 20> = fit().free(FREE).run(&[Experiment::new(&bristled, &first?)])?;
    println!("\nBristles in place of dry friction, by run 1; residuals in mrad");
    print_residuals("run 1", &fitted);
    for name in ["slide1", "slide2", "rise1", "rise2", "slow"] {
        if let Some(estimate) = fitted.estimate(name) {
            println!("    {name:<8} {:>8.1e} +- {:.0e}", estimate.value, estimate.deviation);
        }
    }
    let bristled = driven(runs[1], BristledParams::from_array(fitted.parameters))?;
    let predicted = fit()
        .free(["zero1", "zero2"])
        .run(&[Experiment::new(&bristled, &second?)])?;
    print_residuals("run 2", &predicted);
    Ok(())
}

fn print_residuals(run: &str, fitted: &Fitted<6, 20>) {
    let [upper, lower] = ["q1", "q2"].map(|name| 1e3 * fitted.rms(name));
    println!("  {run} {upper:>6.2} {lower:>6.2}");
}

/// Angles of a run with this noise. Nothing measures the bristles: that they are about straight at the start of each
/// window keeps them within reach.
fn measured(run: &Run, noise: [f64; 2]) -> Result<Measurement, Box<dyn Error>> {
    let times = run.angles.times();
    let [first, last] = [times[0], times[times.len() - 1]];
    // windows of equal length, as those of the fit
    let length = (last - first) / ((last - first) / WINDOW).ceil();
    let mut next = first;
    let starts = times.iter().map(|&t| {
        let begins = t >= next;
        next += if begins { length } else { 0.0 };
        if begins { 0.0 } else { f64::NAN }
    });
    let starts: Vec<f64> = starts.collect();
    let [upper, lower] = ["q1", "q2"].map(|name| run.values(name));
    Ok(Measurement::new(times)?
        .output_with_noise("q1", upper, noise[0])?
        .output_with_noise("q2", lower, noise[1])?
        .output_with_noise("bristle1", &starts, BENT)?
        .output_with_noise("bristle2", &starts, BENT)?)
}

fn driven(run: &Run, params: BristledParams) -> Result<Driven, Box<dyn Error>> {
    Ok(Bristled::new(params)?.with_law(run.torques.clone()))
}

/// First guess: the estimates of dry friction, with bristles that bend over a thousandth or two of a rad. Eleven of
/// twelve guesses, up to four times as large or ten times as small, lead to about the same parameters.
fn guess(dry: &ArmFit) -> BristledParams {
    let dry = ArmParams::from_array(dry.parameters);
    BristledParams {
        m1: dry.m1,
        m2: dry.m2,
        l: dry.l,
        i1: dry.i1,
        i2: dry.i2,
        r1: dry.r1,
        r2: dry.r2,
        rotor: dry.rotor,
        viscous1: dry.viscous1,
        viscous2: dry.viscous2,
        dry1: dry.dry1,
        dry2: dry.dry2,
        zero1: dry.zero1,
        zero2: dry.zero2,
        slide1: 2e-3,
        slide2: 1e-3,
        rise1: 0.05,
        rise2: 0.1,
        slow: 0.2,
        bend: STEP,
    }
}
