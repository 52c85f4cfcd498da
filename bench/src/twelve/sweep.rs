//! Error and time of every method at every tolerance.

use std::time::{Duration, Instant};

use twelve::{End, OUTPUTS, Problem, Request};

use super::entrant::{Entrant, Run};
use super::results::{Curve, MEASURES, Measure, Point};

/// Time budget for the settings of a problem that may be the fastest.
const BUDGET: Duration = Duration::from_secs(12);
/// Number of rounds: of all settings, and of the ones that may be the fastest.
const ROUNDS: usize = 2;
const MORE_ROUNDS: [usize; 2] = [9, 300];
/// A setting may be the fastest if it takes up to this many times the least time at no more error.
const NEAR: f64 = 1.6;
/// Minimum duration of a sample, in nanoseconds, so that its setup is negligible.
const SAMPLE: f64 = 2e5;
/// Nanoseconds for a trajectory beyond which a method is not tried with smaller tolerances.
const PATIENCE: f64 = 3e8;
/// Number of failures in a row that take as long, after which it is not tried either: one that takes huge numbers of
/// steps with loose tolerances may succeed with others.
const SLOW_FAILURES: usize = 3;
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
        let failures = &mut curves[curve].failures;
        let mut slow = 0;
        for tolerance in tolerances() {
            if slow >= SLOW_FAILURES {
                failures.push((tolerance, "not tried: larger ones take too long".to_owned()));
                continue;
            }
            let run = (entrant.run)(once(tolerance));
            let end = run.end.and_then(|end| reached(problem, end));
            slow = match &end {
                _ if run.nanoseconds <= PATIENCE => 0,
                Ok(_) => SLOW_FAILURES,
                Err(_) => slow + 1,
            };
            match end {
                Ok(end) => settings.push(Setting {
                    curve,
                    point: Point::new(tolerance, errors(problem, entrant, tolerance, &end), &end),
                    samples: Vec::new(),
                    first: run.nanoseconds,
                }),
                Err(why) => failures.push((tolerance, why)),
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

/// Tolerances from 1e-3 to 1e-14, two per decade.
fn tolerances() -> impl Iterator<Item = f64> {
    (6..=28).map(|half| 10.0_f64.powf(-0.5 * f64::from(half)))
}

/// One integration for its end.
fn once(tolerance: f64) -> Request {
    Request {
        tolerance,
        times: 1,
        outputs: 0,
    }
}

/// Adds a sample to each of the settings, beginning with another one in each round.
fn sample(settings: &mut [Setting], which: &[usize], round: usize, entrants: &[Entrant]) {
    for n in 0..which.len() {
        let setting = &mut settings[which[(n + round) % which.len()]];
        let request = Request {
            times: (SAMPLE / setting.first.max(SHORT)).ceil() as usize,
            ..once(setting.point.tolerance)
        };
        let run = || (entrants[setting.curve].run)(request);
        if setting.first < LONG {
            // fills the caches
            run();
        }
        let Run { end, nanoseconds } = run();
        // it has not failed before
        setting.samples.extend(end.is_ok().then_some(nanoseconds));
    }
}

/// Settings that may be the fastest ones with at most their error, by any measure.
fn near(settings: &[Setting]) -> Vec<usize> {
    let is_near = |n: usize, measure: Measure| {
        let Setting { point, samples, .. } = &settings[n];
        let error = point.error(measure);
        let as_good = settings.iter().filter(|setting| setting.point.error(measure) <= error);
        let fastest = as_good
            .map(|setting| least(&setting.samples))
            .fold(f64::INFINITY, f64::min);
        error.is_finite() && least(samples) <= NEAR * fastest
    };
    let is_any = |&n: &usize| MEASURES.into_iter().any(|measure| is_near(n, measure));
    (0..settings.len()).filter(is_any).collect()
}

pub(crate) fn least(samples: &[f64]) -> f64 {
    samples.iter().copied().fold(f64::INFINITY, f64::min)
}

pub(crate) fn median(mut samples: Vec<f64>) -> f64 {
    samples.sort_by(f64::total_cmp);
    samples.get(samples.len() / 2).copied().unwrap_or(f64::NAN)
}

fn reached(problem: &Problem, end: End) -> Result<End, String> {
    let t = end.t;
    if (t - problem.t1).abs() <= 2.0 * f64::EPSILON * problem.t1 {
        Ok(end)
    } else {
        Err(format!("stopped at t = {t}"))
    }
}

/// Errors by each measure; dense output is computed in a run of its own.
fn errors(problem: &Problem, entrant: &Entrant, tolerance: f64, end: &End) -> [f64; MEASURES.len()] {
    let request = Request {
        outputs: OUTPUTS,
        ..once(tolerance)
    };
    let along = (entrant.run)(request).end.map_or(Vec::new(), |end| end.along);
    MEASURES.map(|measure| match measure {
        Measure::End => error(&[&end.x], &[&problem.end]),
        Measure::Along if along.len() < OUTPUTS => f64::INFINITY,
        Measure::Along => error(&along, &problem.along),
    })
}

/// Largest error of the components of states, relative to the largest component.
fn error<A: AsRef<[f64]>, B: AsRef<[f64]>>(states: &[A], known: &[B]) -> f64 {
    let size = known
        .iter()
        .flat_map(B::as_ref)
        .fold(0.0_f64, |size, x| size.max(x.abs()));
    let both = states.iter().flat_map(A::as_ref).zip(known.iter().flat_map(B::as_ref));
    let differences = both.map(|(x, known)| (x - known).abs());
    // keep NaN, which `max` would ignore
    differences.fold(0.0, |worst, error| if error <= worst { worst } else { error }) / size
}
