//! Pilot runs: the setting with which each method keeps within the error, and its time.

use libm::{log, pow};
use nalgebra::SVector;

use super::TuneError;
use super::candidate::{Candidate, Control, Motion};
use super::search::rounded;
use crate::accuracy::Failure;
use crate::error::Reason;
use crate::method::{check_span, require};
use crate::system::System;

/// Maximum number of starts of the pilot runs.
const MOST_STARTS: usize = 16;
/// Smallest error, in ulps, from rounding the state and some operations.
const LEAST_ULPS: f64 = 8.0;
/// Range of the tolerance of the first runs.
const FIRST: [f64; 2] = [1e-10, 1e-3];
/// Ratio of the tolerance of the next runs to the last tolerance.
const TIGHTER: f64 = 0.01;
/// Tolerance with which the ends become known, as a fraction of the error.
const FAR_BELOW: f64 = 1e-3;
/// Least tolerance with which the ends become known.
const LEAST: f64 = 1e-14;
/// Largest one, below those of the pilot runs.
const MOST: f64 = 1e-6;
/// Fraction of the error to which the ends have to be known.
const KNOWN: f64 = 0.1;
/// Fraction that is enough with the least tolerance.
const BARELY_KNOWN: f64 = 0.5;
/// Range of measured errors in which a search ends, as fractions of the error: from all starts, and from a part.
const WITHIN: [[f64; 2]; 2] = [[0.25, 0.9], [0.1, 0.4]];
/// Maximum number of steps of the first pilot runs, and of all.
pub(super) const STEPS: [usize; 2] = [4_000, 4_000_000];
/// Number of steps that a method may take for each of the fastest one.
pub(super) const MORE_STEPS: usize = 50;
/// A method that takes the steps of others, up to a switch or to the end, so that they cannot confirm it; and these
/// others, those of its table.
const AUTO: &str = "Auto";
const OF_AUTO: [&str; 6] = ["Tsit5", "Vern7", "Vern9", "Rodas4", "Rodas5P", "Radau13"];

/// Pilot runs of all candidates.
pub(super) struct Pilot<'p, 'a, S, const N: usize> {
    motion: &'p Motion<'a, S>,
    pub(super) candidates: &'p [Candidate<'a, S, N>],
    pub(super) starts: Vec<SVector<f64, N>>,
    pub(super) error: f64,
    /// Range of measured errors in which a search ends.
    pub(super) within: [f64; 2],
}

/// Runs of a candidate with one setting, from all starts.
pub(super) struct Runs<const N: usize> {
    pub(super) value: f64,
    pub(super) ends: Vec<SVector<f64, N>>,
    /// Averages.
    pub(super) evaluations: f64,
    pub(super) time: f64,
    /// Largest number of steps.
    pub(super) steps: usize,
}

/// An adaptive candidate with its runs for two tolerances.
pub(super) struct Compared<const N: usize> {
    pub(super) candidate: usize,
    pub(super) runs: [Runs<N>; 2],
}

/// A candidate given up: its index and the reason.
pub(super) type Dropped = (usize, String);

impl<'p, 'a, S: System<f64, N>, const N: usize> Pilot<'p, 'a, S, N> {
    pub(super) fn new(
        motion: &'p Motion<'a, S>,
        candidates: &'p [Candidate<'a, S, N>],
        starts: &[SVector<f64, N>],
        error: f64,
    ) -> Result<Self, TuneError> {
        let (t0, t1) = motion.span;
        check_span(t0, t1)?;
        require(t0 != t1, "t1", t1, "the span must not be empty")?;
        let rule = "there must be at least one start";
        require(!starts.is_empty(), "starts.len()", 0.0, rule)?;
        let count = of_kind(candidates, Control::Tolerance).count();
        let rule = "at least two methods must be adaptive, since they tell the end states";
        require(count >= 2, "methods.len()", count as f64, rule)?;
        let rule = "the scale must be positive and finite";
        require(
            motion.scale.is_finite() && motion.scale > 0.0,
            "scale",
            motion.scale,
            rule,
        )?;
        let rule = "the error must be at least 8 ulps (1.8e-15), since states are rounded, and below 1";
        require((LEAST_ULPS * f64::EPSILON..1.0).contains(&error), "error", error, rule)?;
        let infinite = starts.iter().flatten().find(|component| !component.is_finite());
        let rule = "all components of a start must be finite";
        infinite.map_or(Ok(()), |&component| require(false, "starts", component, rule))?;
        let count = starts.len().min(MOST_STARTS);
        let is_part = starts.len() > MOST_STARTS;
        Ok(Self {
            motion,
            candidates,
            starts: (0..count).map(|n| starts[n * starts.len() / count]).collect(),
            error,
            within: WITHIN[usize::from(is_part)].map(|fraction| fraction * error),
        })
    }

    /// Length of the span.
    pub(super) fn span(&self) -> f64 {
        (self.motion.span.1 - self.motion.span.0).abs()
    }

    /// Runs a candidate from all starts.
    pub(super) fn runs(&self, candidate: usize, value: f64, most_steps: usize) -> Result<Runs<N>, Failure> {
        let mut runs = Runs {
            value,
            ends: Vec::with_capacity(self.starts.len()),
            evaluations: 0.0,
            time: 0.0,
            steps: 0,
        };
        let weight = 1.0 / self.starts.len() as f64;
        for &start in &self.starts {
            let run = self.candidates[candidate].run(self.motion, value, most_steps, start)?;
            runs.ends.push(run.end);
            runs.evaluations += weight * run.statistics.evaluations as f64;
            runs.time += weight * run.time;
            runs.steps = runs.steps.max(run.statistics.accepted + run.statistics.rejected);
        }
        Ok(runs)
    }

    /// Largest relative error of runs, whose ends are finite.
    pub(super) fn error_of(&self, runs: &Runs<N>, ends: &[SVector<f64, N>]) -> f64 {
        let relative = |(x, known): (&SVector<f64, N>, &SVector<f64, N>)| {
            let scale = self.motion.scale;
            x.zip_map(known, |x, known| (x - known).abs() / known.abs().max(scale))
                .max()
        };
        runs.ends.iter().zip(ends).map(relative).fold(0.0, f64::max)
    }

    /// Fails if the search is cancelled.
    pub(super) fn check_cancelled(&self) -> Result<(), TuneError> {
        match self.motion.cancel {
            Some(cancel) if cancel() => Err(TuneError::Cancelled),
            _ => Ok(()),
        }
    }

    /// Runs all adaptive candidates with two tolerances, and returns the ones that reach the end with both.
    pub(super) fn compare(&self) -> Result<(Vec<Compared<N>>, Vec<Dropped>), TuneError> {
        let first = rounded(self.error.clamp(FIRST[0], FIRST[1]));
        let mut most = STEPS[0];
        loop {
            let (mut compared, mut failures) = (Vec::new(), Vec::new());
            for candidate in of_kind(self.candidates, Control::Tolerance) {
                let both = self.runs(candidate, first, most).and_then(|first| {
                    let second = self.runs(
                        candidate,
                        rounded(TIGHTER * first.value),
                        MORE_STEPS * first.steps.max(100),
                    )?;
                    Ok([first, second])
                });
                match both {
                    Ok(runs) => compared.push(Compared { candidate, runs }),
                    Err(failure) => failures.push((candidate, failure)),
                }
            }
            self.check_cancelled()?;
            if compared.len() >= 2 {
                let why = |(n, failure): (usize, Failure)| (n, failure.to_string());
                return Ok((compared, failures.into_iter().map(why).collect()));
            }
            let many = Reason::TooManySteps { max_steps: most };
            let could_go_on = |(_, failure): &(usize, Failure)| failure.reason == many;
            if most >= STEPS[1] || !failures.iter().any(could_go_on) {
                let named = |(n, failure): (usize, Failure)| (self.candidates[n].name, failure);
                return Err(TuneError::TooFewSucceeded {
                    failures: failures.into_iter().map(named).collect(),
                });
            }
            most *= 10;
        }
    }

    /// Determines the end states by two methods that agree.
    pub(super) fn ends(&self, compared: &[Compared<N>]) -> Result<Vec<SVector<f64, N>>, TuneError> {
        let mut tolerance = (FAR_BELOW * self.error).clamp(LEAST, MOST);
        loop {
            let mut order: Vec<_> = compared.iter().collect();
            let name = |of: &Compared<N>| self.candidates[of.candidate].name;
            order.sort_by(|a, b| {
                let last = |of| name(of) == AUTO;
                let by_time = a.time_at(tolerance).total_cmp(&b.time_at(tolerance));
                last(a).cmp(&last(b)).then(by_time)
            });
            let is_part = |of: &Compared<N>, part: &Compared<N>| name(of) == AUTO && OF_AUTO.contains(&name(part));
            let mut known: Vec<(&Compared<N>, Runs<N>)> = Vec::new();
            let mut failures = Vec::new();
            for of in order {
                match self.runs(of.candidate, tolerance, STEPS[1]) {
                    Ok(runs)
                        if known
                            .iter()
                            .any(|(before, at)| is_part(of, before) || at.ends == runs.ends) => {}
                    Ok(runs) => known.push((of, runs)),
                    Err(failure) => failures.push((name(of), failure)),
                }
                if known.len() == 2 {
                    break;
                }
            }
            self.check_cancelled()?;
            let Some((first, best)) = known.first() else {
                return Err(TuneError::TooFewSucceeded { failures });
            };
            // all others are the same, as at rest
            let alone = (*first, &first.runs[1].ends);
            let (second, other) = known.get(1).map_or(alone, |(of, runs)| (*of, &runs.ends));
            let uncertainty = self.error_of(best, other);
            let enough = if tolerance > LEAST { KNOWN } else { BARELY_KNOWN };
            if uncertainty <= enough * self.error {
                return Ok(known.swap_remove(0).1.ends);
            }
            if tolerance <= LEAST {
                return Err(TuneError::BelowUncertainty {
                    error: self.error,
                    uncertainty,
                    methods: [first, second].map(|of| self.candidates[of.candidate].name),
                });
            }
            tolerance = (TIGHTER * tolerance).max(LEAST);
        }
    }
}

/// Indices of the candidates with this kind of setting.
pub(super) fn of_kind<S, const N: usize>(
    candidates: &[Candidate<'_, S, N>],
    kind: Control,
) -> impl Iterator<Item = usize> {
    (0..candidates.len()).filter(move |&n| candidates[n].control == kind)
}

impl<const N: usize> Compared<N> {
    /// Time with a tolerance, extrapolated as a power of it.
    fn time_at(&self, tolerance: f64) -> f64 {
        let [a, b] = &self.runs;
        let growth = log(b.time / a.time).max(0.0) / log(a.value / b.value);
        b.time * pow(b.value / tolerance, growth)
    }
}
