//! Friction with a memory, fitted to one run and to two, and compared with another.

use std::error::Error;

use pendulum_core::WithInputs;
use pendulum_core::fit::{Experiment, Fit, Fitted, Measurement};
use pendulum_core::inputs::{Generic, TimeTable};
use pendulum_core::prelude::*;

use super::{ArmFit, ArmParams, CORRELATED, Run, WINDOW};

mechanism! {
    /// The arm of `main.rs` with bristles in place of dry friction (C. Canudas de Wit, H. Olsson, K. J. Åström,
    /// P. Lischinsky, "A new model for control of systems with friction", 1995): they bend as an axle begins to turn,
    /// and slide when they are bent by 1, at low rates by more (Stribeck).
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
            /// 1 in run 3, whose encoders show zero at angles further by these.
            third: 1, shift1: rad, shift2: rad,
        }
        input torque1: N m, input torque2: N m,
        gravity: [0, -9.81, 0],
        let rate1 = dot(upper_angle), let rate2 = dot(lower_angle),
        let most1 = 1 + rise1/dry1*exp(-(rate1/slow)^2), let most2 = 1 + rise2/dry2*exp(-(rate2/slow)^2),
        state bent1 { unit: 1, rate: (rate1 - abs(rate1)*bent1/most1)/(slide1 + bend*abs(rate1)) }
        state bent2 { unit: 1, rate: (rate2 - abs(rate2)*bent2/most2)/(slide2 + bend*abs(rate2)) }
        output q1: upper_angle - zero1 - third*shift1, output q2: lower_angle - zero2 - third*shift2,
        body upper on ground {
            mass: m1, com: [0, -r1, 0], inertia: i1 about joint, joint: revolute(z), coordinate: upper_angle,
            torque: torque1 - dry1*bent1, friction: viscous1,
        }
        body lower on upper {
            mass: m2, com: [0, -r2, 0], inertia: i2 about joint, joint: revolute(z) at [0, -l, 0],
            coordinate: lower_angle, torque: torque2 - dry2*bent2, friction: viscous2,
        }
        body rotor2 on upper { inertia: rotor, joint: revolute(z), motion: -6*lower_angle }
    }
}

type Driven = WithInputs<Bristled, Generic<TimeTable<2>>, 2>;
type BristledFit = Fitted<6, 23>;

/// Step of the integration in s, no longer than `bend`.
const STEP: f64 = 0.002;
/// Deviation of the bristles at the starts of windows, which are between -1 and 1 where axles turn.
const BENT: f64 = 0.6;
/// Least turn in rad that bends bristles. Shorter ones bend from one side to the other within a step where an axle
/// turns back, and the loss then has many minima.
const LEAST_SLIDE: f64 = 1e-3;
const FREE: [&str; 16] = [
    "i1", "i2", "r1", "r2", "rotor", "viscous1", "viscous2", "dry1", "dry2", "zero1", "zero2", "slide1", "slide2",
    "rise1", "rise2", "slow",
];

/// Fits bristles to the first run, and to the first and the third one, and predicts the second run. The noise is what
/// dry friction leaves, times the square root of the number of samples over which it is correlated, so that bristles at
/// the starts of windows have their weight.
pub(crate) fn compare(dry: &ArmFit, runs: &[Run; 3]) -> Result<(), Box<dyn Error>> {
    let noise = ["q1", "q2"].map(|name| dry.rms(name) * (CORRELATED as f64).sqrt());
    let measured = |n: usize| measured(&runs[n], noise);
    let [first, second, third] = [measured(0)?, measured(1)?, measured(2)?];
    let guess = guess(dry);
    let alone = driven(&runs[0], guess)?;
    let after = driven(&runs[2], BristledParams { third: 1.0, ..guess })?;
    let experiments = [Experiment::new(&alone, &first), Experiment::new(&after, &third)];
    println!("\nBristles in place of dry friction; residuals in mrad, and times those of the fit");
    for (what, shifts, experiments) in [
        ("run 1", &[][..], &experiments[..1]),
        ("runs 1 and 3", &["shift1", "shift2"][..], &experiments[..]),
    ] {
        let fitted: BristledFit = fit().free(FREE.iter().chain(shifts).copied()).run(experiments)?;
        print_residuals(what, &fitted, &fitted);
        for name in ["slide1", "slide2", "rise1", "rise2", "slow"] {
            if let Some(estimate) = fitted.estimate(name) {
                println!("    {name:<8} {:>8.1e} +- {:.0e}", estimate.value, estimate.deviation);
            }
        }
        let params = BristledParams {
            third: 0.0,
            ..BristledParams::from_array(fitted.parameters)
        };
        let predicted = fit()
            .free(["zero1", "zero2"])
            .run(&[Experiment::new(&driven(&runs[1], params)?, &second)])?;
        print_residuals("run 2, predicted", &predicted, &fitted);
    }
    Ok(())
}

fn fit() -> Fit<Rk4> {
    let fit = Fit::new(Rk4::new(STEP))
        .separate_windows(WINDOW)
        .bounds("slow", 0.02, 3.0);
    let fit = fit
        .bounds("slide1", LEAST_SLIDE, 0.5)
        .bounds("slide2", LEAST_SLIDE, 0.5);
    fit.bounds("rise1", 0.0, 1.0).bounds("rise2", 0.0, 1.0)
}

fn print_residuals(run: &str, left: &BristledFit, fitted: &BristledFit) {
    let [upper, lower] = ["q1", "q2"].map(|name| 1e3 * left.rms(name));
    let [times_upper, times_lower] = ["q1", "q2"].map(|name| left.rms(name) / fitted.rms(name));
    println!("  {run:<16} {upper:>6.2} {lower:>6.2} {times_upper:>5.2} {times_lower:>5.2}");
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
        .output_with_noise("bent1", &starts, BENT)?
        .output_with_noise("bent2", &starts, BENT)?)
}

fn driven(run: &Run, params: BristledParams) -> Result<Driven, Box<dyn Error>> {
    Ok(Bristled::new(params)?.with_law(run.torques.clone()))
}

/// First guess: the estimates of dry friction, with bristles that bend over more than in the end. Seven of ten others
/// lead to about the same loss.
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
        slide1: 1e-2,
        slide2: 5e-3,
        rise1: 0.1,
        rise2: 0.1,
        slow: 0.15,
        bend: STEP,
        third: 0.0,
        shift1: 0.0,
        shift2: 0.0,
    }
}
