//! Accuracy of the generated accelerations if one body is much lighter or heavier than the others.
//!
//! `cargo run --release -p studies --example solve_accuracy` compares them with 50-digit values for mass ratios from
//! 1e-8 to 1e8, prints the worst errors, and draws them together with the bound by the conditioning of the problem and
//! with the errors of textbook methods.

mod figure;
mod textbook;

use std::error::Error;
use std::path::Path;

use charts::page::Picture;
use testbed::ratios::{Sample, Scene, generated, scenes};

/// Maximum condition number, over all mass ratios, of a state that counts as steady.
const STEADY: f64 = 100.0;

/// Errors of one method to compute the accelerations of a scene.
struct Run {
    name: String,
    /// Worst errors of steady states, and of the others.
    kinds: [Vec<Worst>; 2],
}

/// Worst error over some states with one mass ratio.
#[derive(Clone, Copy)]
struct Worst {
    ratio: f64,
    error: f64,
    /// Bound by the conditioning.
    bound: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let scenes = scenes();
    let mut runs = Vec::new();
    for scene in &scenes {
        runs.push(run(scene, &scene.name, |sample| generated(&scene.name, sample)));
    }
    let points = scenes.iter().find(|scene| scene.name == "points").ok_or("no points")?;
    let mut textbook = vec![run(points, "generated", |sample| generated("points", sample))];
    for (name, solve) in [
        ("Cholesky", textbook::cholesky as fn(&Sample) -> _),
        ("Cramer, differences of products", textbook::cramer),
    ] {
        points.samples.iter().try_for_each(|sample| solve(sample).map(drop))?;
        textbook.push(run(points, name, |sample| solve(sample).unwrap_or_default()));
    }
    println!(
        "Largest error of the accelerations, in units of the largest acceleration, over mass ratios from 1e-8 to 1e8"
    );
    println!("bound: machine epsilon times (1 + condition); steady: states of condition below {STEADY}\n");
    println!("  {:<32}  steady    bound  others    bound", "");
    for run in runs.iter().chain(&textbook) {
        print(run);
    }
    println!();
    for path in figure::figure(&runs, &textbook)?.save(Path::new("out/solve_accuracy/mass_ratios"))? {
        println!("{}", path.display());
    }
    Ok(())
}

fn run(scene: &Scene, name: &str, solve: impl Fn(&Sample) -> Vec<f64>) -> Run {
    let most = |state: &[f64]| {
        let same = scene.samples.iter().filter(|sample| sample.state == state);
        same.map(Sample::kappa).fold(0.0, f64::max)
    };
    let worst = |steady: bool| {
        let mut worst: Vec<Worst> = Vec::new();
        for sample in scene
            .samples
            .iter()
            .filter(|sample| (most(&sample.state) < STEADY) == steady)
        {
            let (ratio, error, bound) = (sample.ratio, sample.error_of(&solve(sample)), sample.bound());
            // NaN is the worst error of all; `max` would ignore it
            let error = if error.is_nan() { f64::INFINITY } else { error };
            match worst.last_mut().filter(|last| last.ratio == ratio) {
                Some(last) => {
                    last.error = last.error.max(error);
                    last.bound = last.bound.max(bound);
                }
                None => worst.push(Worst { ratio, error, bound }),
            }
        }
        worst
    };
    Run {
        name: name.to_owned(),
        kinds: [true, false].map(worst),
    }
}

fn print(run: &Run) {
    print!("  {:<32}", run.name);
    for kind in &run.kinds {
        let most = |part: fn(&Worst) -> f64| kind.iter().map(part).fold(0.0, f64::max);
        if kind.is_empty() {
            print!("  {:>6}  {:>7}", "none", "");
        } else {
            print!(
                "  {:>6.0e}  {:>7.0e}",
                most(|worst| worst.error),
                most(|worst| worst.bound)
            );
        }
    }
    println!();
}
