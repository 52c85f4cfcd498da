//! Prediction of a run by the parameters of another, and what limits it.

use std::error::Error;

use pendulum_core::fit::{Experiment, Fit, Measurement};
use pendulum_core::inputs::TimeTable;
use pendulum_core::prelude::*;

use super::random::Random;
use super::{Arm, ArmFit, ArmParams, Run, STEP, WINDOW, noise};

/// Predicts a run by parameters of another, in windows whose starts are fitted, with its own zeros of the encoders, and
/// with static friction, which the other run does not determine. Then forecasts each window from the end of the one
/// before.
pub(crate) fn predict(best: &ArmFit, run: &Run) -> Result<ArmFit, Box<dyn Error>> {
    let arm = run.arm(ArmParams::from_array(best.parameters))?;
    let fit = Fit::new(Rk4::new(STEP))
        .free(["zero1", "zero2"])
        .separate_windows(WINDOW);
    let predicted = fit.run(&[Experiment::new(&arm, &run.angles)])?;
    println!("\nRun 2 by the parameters of run 1; residuals in mrad, and times those of run 1");
    let row = |name: &str, [upper, lower]: [f64; 2]| {
        println!(
            "  {name:<32} {:>6.2} {:>6.2} {:>5.1} {:>5.1}",
            1e3 * upper,
            1e3 * lower,
            upper / best.rms("q1"),
            lower / best.rms("q2")
        );
    };
    row(
        "windows with their own starts",
        ["q1", "q2"].map(|name| predicted.rms(name)),
    );
    let params = ArmParams::from_array(predicted.parameters);
    let own = |run: &str, fitted: &ArmFit, names: [&str; 2]| {
        let value = |name| fitted.estimate(name).map_or(f64::NAN, |estimate| estimate.value);
        println!(
            "    {}, {} of {run}: {:.3}, {:.3}",
            names[0],
            names[1],
            value(names[0]),
            value(names[1])
        );
    };
    own("run 1", best, ["zero1", "zero2"]);
    own("run 2", &predicted, ["zero1", "zero2"]);
    // the lower link rests six times in run 2, and never in run 1
    let params = ArmParams {
        static1: 1.5,
        static2: 1.5,
        ..params
    };
    let arm = run.arm(params)?;
    let sticks = Fit::new(Rk4::new(STEP))
        .free(["zero1", "zero2", "static1", "static2"])
        .bounds("static1", 1.0, 9.0)
        .bounds("static2", 1.0, 9.0)
        .separate_windows(WINDOW)
        .run(&[Experiment::new(&arm, &run.angles)])?;
    row(
        "with static friction of its own",
        ["q1", "q2"].map(|name| sticks.rms(name)),
    );
    own("run 2", &sticks, ["static1", "static2"]);
    for (ahead, errors) in AHEAD.into_iter().zip(forecast(&predicted, run)?) {
        row(&format!("forecast {ahead} s ahead"), errors);
    }
    Ok(predicted)
}

/// Times ahead at which forecasts are compared, in s.
const AHEAD: [f64; 3] = [0.1, 0.25, 0.5];

/// Root mean square errors of both angles in forecasts from the end of one window into the next, at the times
/// [`AHEAD`]. No sample of a window is used for its forecast.
fn forecast(fitted: &ArmFit, run: &Run) -> Result<[[f64; 2]; 3], Box<dyn Error>> {
    let params = ArmParams::from_array(fitted.parameters);
    let (arm, driven) = (Arm::new(params)?, run.arm(params)?);
    let mut errors = [const { Vec::new() }; 3];
    for window in &fitted.windows[..fitted.windows.len() - 1] {
        let motion = Rk4::new(STEP).solve(&driven, window.t1, window.t1 + WINDOW, window.end)?;
        let samples = run.values("q1").iter().zip(run.values("q2"));
        for (&t, (&upper, &lower)) in run.angles.times().iter().zip(samples) {
            let after = t - window.t1;
            let near = AHEAD.iter().position(|ahead| (ahead - after).abs() < 0.025);
            if let Some(k) = near.filter(|_| after <= WINDOW) {
                let error = SVector::from([upper, lower]) - arm.outputs(t, &motion.at(t)?);
                errors[k].push([error[0], error[1]]);
            }
        }
    }
    Ok(errors.map(|errors| rms(&errors)))
}

/// The lower link rests if its angle changes by less than `RESTS`, in rad, over this many samples: 0.1 s.
const RESTING: usize = 50;
const RESTS: f64 = 2e-3;

/// Parameters of which each window may have its own values.
const OWN: [(&str, [&str; 2]); 2] = [
    ("with an error of each torque in each window", ["error1", "error2"]),
    ("with dry friction of each window", ["dry1", "dry2"]),
];

/// Prints what the noise of the torques alone would leave of runs, and what fits leave whose windows have parameters
/// [of their own](OWN).
pub(crate) fn limits(runs: [(&Run, &ArmFit); 2]) -> Result<(), Box<dyn Error>> {
    println!("\nLimits; residuals in mrad");
    let mrad = |residuals: [f64; 2]| residuals.map(|residual| 1e3 * residual);
    for (number, (run, fitted)) in (1..).zip(runs) {
        let [upper, lower] = mrad(left_by_noise(fitted, run)?);
        println!("  run {number}: noise of the torques alone leaves {upper:>18.2} {lower:>6.2}");
        for (windows, [upper, lower]) in ["in which the lower link rests", "in which it does not"]
            .into_iter()
            .zip(by_rest(fitted, run).map(mrad))
            .filter(|(_, residuals)| residuals[0].is_finite())
        {
            println!("  run {number}: windows {windows:<35} {upper:>8.2} {lower:>6.2}");
        }
        for (what, names) in OWN {
            let [residuals, changes] = with_own(names, fitted, run)?;
            let [upper, lower] = mrad(residuals);
            println!(
                "  run {number}: {what:<43} {upper:>8.2} {lower:>6.2}; changes {:.0} and {:.0} mN m",
                1e3 * changes[0],
                1e3 * changes[1]
            );
        }
    }
    Ok(())
}

/// Root mean squares.
fn rms<const N: usize>(rows: &[[f64; N]]) -> [f64; N] {
    std::array::from_fn(|n| (rows.iter().map(|row| row[n] * row[n]).sum::<f64>() / rows.len() as f64).sqrt())
}

/// Residuals in rad of a simulated run whose torques differ from those of the scene by noise, as large as that of the
/// measured torques.
fn left_by_noise(fitted: &ArmFit, run: &Run) -> Result<[f64; 2], Box<dyn Error>> {
    let params = ArmParams::from_array(fitted.parameters);
    let (arm, times) = (Arm::new(params)?, run.angles.times());
    let random = &mut Random::new(1);
    let noisy = run.samples.each_ref().map(|samples| {
        let deviation = noise(samples);
        samples
            .iter()
            .map(|tau| tau + deviation * random.normal())
            .collect::<Vec<_>>()
    });
    let driven = Arm::new(params)?.with_law(TimeTable::linear(times, noisy.each_ref().map(Vec::as_slice))?);
    let mut angles = [Vec::new(), Vec::new()];
    for window in &fitted.windows {
        let motion = Rk4::new(STEP).solve(&driven, window.t0, window.t1, window.start)?;
        for &t in &times[angles[0].len()..] {
            if t < window.t1 || window.t1 == times[times.len() - 1] {
                let outputs = arm.outputs(t, &motion.at(t)?);
                angles
                    .iter_mut()
                    .zip(&outputs)
                    .for_each(|(angles, angle)| angles.push(*angle));
            }
        }
    }
    let [q1, q2] = &angles;
    let angles = Measurement::new(times)?
        .output_with_noise("q1", q1, 2e-4)?
        .output_with_noise("q2", q2, 2e-4)?;
    let fit = Fit::new(Rk4::new(STEP)).free([]).separate_windows(WINDOW);
    let left: ArmFit = fit.run(&[Experiment::new(&run.arm(params)?, &angles)])?;
    Ok(["q1", "q2"].map(|name| left.rms(name)))
}

/// Residuals in rad of the windows in which the lower link rests, and of the others.
fn by_rest(fitted: &ArmFit, run: &Run) -> [[f64; 2]; 2] {
    let mut parts = [Vec::new(), Vec::new()];
    let (times, lower) = (run.angles.times(), run.values("q2"));
    for window in &fitted.windows {
        let inside: Vec<usize> = (0..times.len())
            .filter(|&n| (window.t0..window.t1).contains(&times[n]))
            .collect();
        let rests = inside.windows(RESTING).any(|part| {
            let [least, most] = [f64::min, f64::max].map(|of| part.iter().map(|&n| lower[n]).reduce(of));
            most.zip(least).is_some_and(|(most, least)| most - least < RESTS)
        });
        let residual = |n: usize| [0, 1].map(|column: usize| fitted.residuals[column].values[n]);
        parts[usize::from(!rests)].extend(inside.into_iter().map(residual));
    }
    parts.map(|part| rms(&part))
}

/// Fits each window alone, with its start and two parameters. Returns the root mean squares of residuals, in rad, and
/// of changes of the parameters.
fn with_own(names: [&str; 2], fitted: &ArmFit, run: &Run) -> Result<[[f64; 2]; 2], Box<dyn Error>> {
    let arm = run.arm(ArmParams::from_array(fitted.parameters))?;
    let fit = Fit::new(Rk4::new(STEP)).free(names).separate_windows(WINDOW);
    let before = names.map(|name| ArmParams::NAMES.iter().position(|own| *own == name));
    let before = before.map(|n| n.map_or(f64::NAN, |n| fitted.parameters[n]));
    let (mut residuals, mut changes) = (Vec::new(), Vec::new());
    for window in &fitted.windows {
        let angles = run.angles.between(window.t0, window.t1);
        let own: ArmFit = fit.run(&[Experiment::new(&arm, &angles).from_guess(window.start)])?;
        residuals.push(["q1", "q2"].map(|name| own.rms(name)));
        changes.push([0, 1].map(|n: usize| own.estimates[n].value - before[n]));
    }
    Ok([residuals, changes].map(|rows| rms(&rows)))
}
