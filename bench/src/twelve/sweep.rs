//! Error and time of every method at every tolerance.

use std::time::{Duration, Instant};

use twelve::{End, Problem};

use super::entrant::{Entrant, Run};
use crate::methods::{Curve, Point, tolerances};

/// Time budget for the settings of a problem that may be the fastest.
const BUDGET: Duration = Duration::from_secs(12);
/// Number of rounds, of all settings and of those that may be the fastest.
const ROUNDS: usize = 2;
const MORE_ROUNDS: [usize; 2] = [9, 300];
/// Settings that take up to so many times as long as the fastest one with at most their error may be the fastest.
const NEAR: f64 = 1.6;
/// Minimum duration of a sample, in nanoseconds, so that its setup is negligible.
const SAMPLE: f64 = 2e5;
/// Nanoseconds for a trajectory beyond which a method is not tried with smaller tolerances.
const PATIENCE: f64 = 3e8;
/// Nanoseconds for a trajectory beyond which cold caches do not count.
const LONG: f64 = 1e7;
/// Nanoseconds for a trajectory that no problem stays below, lest a first time that is too short lead to long samples.
const SHORT: f64 = 1e3;

/// Method with a tolerance.
pub(crate) struct Setting {
    /// Index of its curve.
    pub curve: usize,
    pub point: Point,
    /// Nanoseconds for a trajectory in each round.
    pub samples: Vec<f64>,
    /// Nanoseconds for the first trajectory.
    first: f64,
}

/// Curves of all methods on a problem, and the settings from which they are.
pub(crate) fn sweep(problem: &Problem, entrants: &[Entrant]) -> (Vec<Curve>, Vec<Setting>) {
    let mut curves: Vec<Curve> = entrants
        .iter()
        .map(|entrant| Curve::new(entrant.by, entrant.method))
        .collect();
    let mut settings = Vec::new();
    for (curve, entrant) in entrants.iter().enumerate() {
        for tolerance in tolerances() {
            let run = (entrant.run)(tolerance, 1).and_then(|run| reached(problem, run));
            let nanoseconds = run.as_ref().map_or(0.0, |run| run.nanoseconds);
            match run {
                Ok(run) => settings.push(Setting {
                    curve,
                    point: Point::new(tolerance, error(problem, &run.end), run.end.evaluations),
                    samples: Vec::new(),
                    first: nanoseconds,
                }),
                Err(why) => curves[curve].failures.push((tolerance, why)),
            }
            if nanoseconds > PATIENCE {
                curves[curve]
                    .failures
                    .push((tolerance, "smaller ones would take too long".to_owned()));
                break;
            }
        }
    }
    let all: Vec<usize> = (0..settings.len()).collect();
    for round in 0..ROUNDS {
        sample(&mut settings, &all, round, entrants);
    }
    let near = near(&settings);
    let start = Instant::now();
    for round in 0..MORE_ROUNDS[1] {
        if round >= MORE_ROUNDS[0] && start.elapsed() > BUDGET {
            break;
        }
        sample(&mut settings, &near, round, entrants);
    }
    for Setting {
        curve, point, samples, ..
    } in &mut settings
    {
        point.least = least(samples);
        point.median = median(samples.clone());
        curves[*curve].points.push(*point);
    }
    (curves, settings)
}

/// Adds a sample to each of the settings, beginning with another one in each round.
fn sample(settings: &mut [Setting], which: &[usize], round: usize, entrants: &[Entrant]) {
    for n in 0..which.len() {
        let setting = &mut settings[which[(n + round) % which.len()]];
        let times = (SAMPLE / setting.first.max(SHORT)).ceil() as usize;
        let run = || (entrants[setting.curve].run)(setting.point.tolerance, times);
        if setting.first < LONG {
            // fills the caches
            let _ = run();
        }
        // it has not failed before
        setting.samples.extend(run().map(|run| run.nanoseconds));
    }
}

/// Settings that may be the fastest ones with at most their error.
fn near(settings: &[Setting]) -> Vec<usize> {
    let fastest = |error: f64| {
        let as_good = settings.iter().filter(|setting| setting.point.error <= error);
        as_good
            .map(|setting| least(&setting.samples))
            .fold(f64::INFINITY, f64::min)
    };
    let is_near = |&n: &usize| least(&settings[n].samples) <= NEAR * fastest(settings[n].point.error);
    (0..settings.len()).filter(is_near).collect()
}

pub(crate) fn least(samples: &[f64]) -> f64 {
    samples.iter().copied().fold(f64::INFINITY, f64::min)
}

pub(crate) fn median(mut samples: Vec<f64>) -> f64 {
    samples.sort_by(f64::total_cmp);
    samples.get(samples.len() / 2).copied().unwrap_or(f64::NAN)
}

fn reached(problem: &Problem, run: Run) -> Result<Run, String> {
    let t = run.end.t;
    if (t - problem.t1).abs() <= 2.0 * f64::EPSILON * problem.t1 {
        Ok(run)
    } else {
        Err(format!("stopped at t = {t}"))
    }
}

/// Largest error of the components of an end, relative to the largest component.
fn error(problem: &Problem, end: &End) -> f64 {
    let size = problem.end.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    let differences = end.x.iter().zip(&problem.end).map(|(x, expected)| (x - expected).abs());
    // keep NaN, which `max` would ignore
    differences.fold(0.0, |worst, error| if error <= worst { worst } else { error }) / size
}
