//! A real double pendulum: its parameters from one measured run, and another run predicted.
//!
//! `cargo run --release --example measured` fits four scenes to run 1, from viscous friction alone to an arm with dry
//! friction, misaligned encoders and the rotor of a motor, shows which measurement determines which parameter, and
//! predicts run 2. Bristles in place of dry friction, fitted to runs 1 and 3, predict it better.
//!
//! The data are of the robotics laboratory DFKI RIC, <https://github.com/dfki-ric-underactuated-lab/double_pendulum>,
//! under the license beside them: angles of two driven links, the first from hanging, the second relative to the first,
//! and the torques of both motors. The makers published the parameters of [`ArmParams::default`].

mod bristles;
mod figures;
mod prediction;
mod random;

use std::error::Error;
use std::fs::File;
use std::path::Path;
use std::time::Instant;

use charts::page::Picture;
use pendulum_core::fit::{Experiment, Fit, Fitted, Measurement, Table};
use pendulum_core::inputs::{Generic, TimeTable};
use pendulum_core::prelude::*;
use pendulum_core::{ParameterError, WithInputs};

mechanism! {
    /// Two links on axles with friction. The motor of the lower link turns it through a gear of ratio 6; the inertia of
    /// the rotor of the upper one is part of the inertia of the link.
    Arm {
        params {
            m1: kg = 0.559, m2: kg = 0.604,
            /// Distance of the axles.
            l: m = 0.3,
            /// Inertia of the links about their axles.
            i1: kg m^2 = 0.0535, i2: kg m^2 = 0.0239,
            /// Distance of the centres of mass from the axles.
            r1: m = 0.3, r2: m = 0.184,
            /// Inertia of the rotor of the lower motor.
            rotor: kg m^2 = 7.66e-5,
            viscous1: N m s = 0.001, viscous2: N m s = 0.001,
            dry1: N m = 0.093, dry2: N m = 0.078,
            /// Static friction over dry friction.
            static1: 1 = 1, static2: 1 = 1,
            /// Angles at which the encoders show zero.
            zero1: rad = 0, zero2: rad = 0,
            /// Errors of the measured torques.
            error1: N m = 0, error2: N m = 0,
        }
        input torque1: N m, input torque2: N m,
        gravity: [0, -9.81, 0],
        output q1: upper_angle - zero1,
        output q2: lower_angle - zero2,
        body upper on ground {
            mass: m1, com: [0, -r1, 0], inertia: i1 about joint,
            joint: revolute(z), coordinate: upper_angle, torque: torque1 + error1,
            friction: viscous1, dry_friction: dry1, static_friction: static1*dry1,
        }
        body lower on upper {
            mass: m2, com: [0, -r2, 0], inertia: i2 about joint,
            joint: revolute(z) at [0, -l, 0],
            coordinate: lower_angle, torque: torque2 + error2,
            friction: viscous2, dry_friction: dry2, static_friction: static2*dry2,
        }
        body rotor2 on upper { inertia: rotor, joint: revolute(z), motion: -6*lower_angle }
    }
}

/// The arm with recorded torques.
type Driven = WithInputs<Arm, Generic<TimeTable<2>>, 2>;
type ArmFit = Fitted<4, 18>;

/// Length of the windows of fits and predictions, in s.
const WINDOW: f64 = 0.5;
/// Step of the integration in s: about two samples.
const STEP: f64 = 0.004;
/// Residuals are correlated over about this many samples.
const CORRELATED: usize = 25;
/// Inertias and centres of mass, which each fit adjusts.
const LINKS: [&str; 4] = ["i1", "i2", "r1", "r2"];

/// A scene: its name, and the parameters that it adjusts beside [`LINKS`]. The others are zero.
type Scene = (&'static str, &'static [&'static str]);
const SCENES: [Scene; 4] = [
    ("viscous friction", &["viscous1", "viscous2"]),
    ("viscous and dry friction", &["viscous1", "viscous2", "dry1", "dry2"]),
    (
        "both, encoders not aligned",
        &["viscous1", "viscous2", "dry1", "dry2", "zero1", "zero2"],
    ),
    (
        "both, encoders, rotor",
        &["viscous1", "viscous2", "dry1", "dry2", "zero1", "zero2", "rotor"],
    ),
];
/// The last scene with one kind of friction alone.
const VISCOUS: Scene = ("viscous only", &["viscous1", "viscous2", "zero1", "zero2", "rotor"]);
const DRY: Scene = ("dry only", &["dry1", "dry2", "zero1", "zero2", "rotor"]);
/// The scene that predicts.
const BEST: usize = 3;

/// A measured run: angles, and the torques as a law of the inputs.
struct Run {
    angles: Measurement,
    torques: TimeTable<2>,
    /// Samples of the torques.
    samples: [Vec<f64>; 2],
}

fn main() -> Result<(), Box<dyn Error>> {
    let runs = [read("run_1.csv")?, read("run_2.csv")?, read("run_3.csv")?];
    let noise = ["q1", "q2"].map(|name| noise(runs[0].values(name)));
    println!(
        "noise of the angles of run 1, from second differences: {:.2} and {:.2} mrad",
        1e3 * noise[0],
        1e3 * noise[1]
    );

    println!("\nRun 1 in windows of {WINDOW} s, each with a start of its own; residuals in mrad");
    println!(
        "  {:<28} {:>5} {:>5} {:>13} {:>9}",
        "scene", "upper", "lower", "times noise", "time"
    );
    let mut fits = Vec::new();
    for scene in &SCENES {
        let start = Instant::now();
        let fitted = fit(scene, &runs[0])?;
        let time = start.elapsed();
        let [upper, lower] = ["q1", "q2"].map(|name| fitted.rms(name));
        println!(
            "  {:<28} {:>5.2} {:>5.2} {:>6.0} {:>6.0} {:>6.0} ms",
            scene.0,
            1e3 * upper,
            1e3 * lower,
            upper / noise[0],
            lower / noise[1],
            1e3 * time.as_secs_f64()
        );
        fits.push(fitted);
    }
    let best = &fits[BEST];
    let residuals = ["q1", "q2"].map(|name| best.rms(name));
    let sparse = thinned(&SCENES[BEST], &runs[0], residuals)?;
    print_estimates(best, &sparse);
    which_friction(&sparse, &runs[0], residuals)?;
    which_parameters(best, &runs[0])?;
    let predicted = prediction::predict(best, &runs[1])?;
    prediction::limits([(&runs[0], best), (&runs[1], &predicted)])?;
    bristles::compare(best, &runs)?;

    println!();
    let stem = |name: &str| Path::new("out/measured").join(name);
    let angles = figures::angles([(&runs[0], best), (&runs[1], &predicted)])?;
    let residuals = figures::residuals(&runs[0], &fits[..=BEST]);
    let ellipses = figures::ellipses(&sparse);
    for path in [
        angles.save(&stem("angles"))?,
        residuals.save(&stem("residuals"))?,
        ellipses.save(&stem("ellipses"))?,
    ]
    .concat()
    {
        println!("{}", path.display());
    }
    Ok(())
}

/// Reads a run. The angles have known noise of equal size: what they leave is mostly due to the scene.
fn read(name: &str) -> Result<Run, Box<dyn Error>> {
    let path = Path::new("examples/measured/data").join(name);
    let table = Table::read_csv(File::open(path)?)?;
    let times = table.column("time_s")?;
    let angles = Measurement::new(times)?
        .output_with_noise("q1", table.column("q1_rad")?, 2e-4)?
        .output_with_noise("q2", table.column("q2_rad")?, 2e-4)?;
    let samples = [table.column("tau1_Nm")?, table.column("tau2_Nm")?];
    let torques = TimeTable::linear(times, samples)?;
    let samples = samples.map(<[f64]>::to_vec);
    Ok(Run {
        angles,
        torques,
        samples,
    })
}

/// Standard deviation of the noise of samples, from second differences, which the motion hardly has at 500 Hz.
fn noise(samples: &[f64]) -> f64 {
    let second = samples.windows(3).map(|x| (x[0] - 2.0 * x[1] + x[2]).powi(2) / 6.0);
    (second.sum::<f64>() / samples.len() as f64).sqrt()
}

impl Run {
    /// Values of an angle.
    fn values(&self, name: &str) -> &[f64] {
        let mut columns = self.angles.names().zip(self.angles.values());
        columns.find(|(own, _)| *own == name).map_or(&[], |(_, values)| values)
    }

    fn arm(&self, params: ArmParams) -> Result<Driven, ParameterError> {
        Ok(Arm::new(params)?.with_law(self.torques.clone()))
    }
}

/// The published parameters, without the effects that a scene does not have.
fn published((_, free): &Scene) -> ArmParams {
    let published = ArmParams::default();
    let with = |name, value: f64| if free.contains(&name) { value } else { 0.0 };
    ArmParams {
        viscous1: with("viscous1", published.viscous1),
        viscous2: with("viscous2", published.viscous2),
        dry1: with("dry1", published.dry1),
        dry2: with("dry2", published.dry2),
        // not zero, for a body must have inertia
        rotor: with("rotor", published.rotor).max(1e-12),
        ..published
    }
}

/// Fits a scene from the published parameters, in windows.
fn fit_to(scene: &Scene, run: &Run, angles: &Measurement) -> Result<ArmFit, Box<dyn Error>> {
    let free = LINKS.iter().chain(scene.1).copied();
    let arm = run.arm(published(scene))?;
    let fit = Fit::new(Rk4::new(STEP)).free(free).separate_windows(WINDOW);
    Ok(fit.run(&[Experiment::new(&arm, angles)])?)
}

fn fit(scene: &Scene, run: &Run) -> Result<ArmFit, Box<dyn Error>> {
    fit_to(scene, run, &run.angles)
}

/// Fit to samples so far apart that their residuals are hardly correlated, with the residuals of a scene as the noise
/// of all.
fn thinned(scene: &Scene, run: &Run, noise: [f64; 2]) -> Result<ArmFit, Box<dyn Error>> {
    let sparse = run.angles.every(CORRELATED);
    let mut angles = Measurement::new(sparse.times())?;
    for ((name, values), noise) in sparse.names().zip(sparse.values()).zip(noise) {
        angles = angles.output_with_noise(name, values, noise)?;
    }
    fit_to(scene, run, &angles)
}

/// Prints estimates with the deviations of a fit to fewer samples, and the published values.
fn print_estimates(best: &ArmFit, sparse: &ArmFit) {
    println!("\nParameters of the last scene, with deviations by every {CORRELATED}th sample");
    println!("  {:<9} {:>10} {:>9} {:>10}", "", "estimate", "deviation", "published");
    let published = ArmParams::default().to_array();
    for (estimate, rough) in best.estimates.iter().zip(&sparse.estimates) {
        let published = ArmParams::NAMES
            .iter()
            .zip(published)
            .find(|(name, _)| **name == estimate.name);
        let published = published.map_or(f64::NAN, |(_, value)| value);
        println!(
            "  {:<9} {:>10.3e} {:>9.0e} {published:>10.3e}",
            estimate.name, estimate.value, rough.deviation
        );
    }
}

/// Compares each kind of friction with both by their likelihood.
fn which_friction(both: &ArmFit, run: &Run, noise: [f64; 2]) -> Result<(), Box<dyn Error>> {
    println!("\nFriction of the axles, by every {CORRELATED}th sample: both kinds against one");
    for scene in [VISCOUS, DRY] {
        let comparison = thinned(&scene, run, noise)?.likelihood.compare(&both.likelihood);
        println!(
            "  {:<12} 2 ln L grows by {:>6.1}; p < {:.0e}; Bayesian criterion {:+.1}",
            scene.0,
            comparison.statistic,
            comparison.p_value.max(1e-99),
            comparison.bic
        );
    }
    Ok(())
}

/// Frees masses and lengths, too, and prints what the motion does not determine.
fn which_parameters(best: &ArmFit, run: &Run) -> Result<(), Box<dyn Error>> {
    let arm = run.arm(ArmParams::from_array(best.parameters))?;
    let fit = Fit::new(Rk4::new(STEP)).separate_windows(WINDOW).max_iterations(1);
    let fitted = fit.run(&[Experiment::new(&arm, &run.angles)])?;
    println!("\nWith all parameters free:");
    for combination in &fitted.undetermined {
        println!("  {combination}");
    }
    Ok(())
}
