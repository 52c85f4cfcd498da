//! Search for the setting of one method.

use libm::{log, pow, sqrt};
use nalgebra::SVector;

use super::candidate::Control;
use super::pilot::{Pilot, Runs};
use crate::error::Reason;
use crate::system::System;

/// Smallest and largest tolerance: some ulps, and one that still controls the steps.
const TOLERANCES: [f64; 2] = [3e-15, 0.1];
/// Number of settings that are tried.
const TRIES: usize = 10;
/// Ratio to the shortest time of another method at which a method is given up.
const SLOW: f64 = 4.0;
/// Ratio of a setting to the next larger one, which is not accurate enough, at which a search ends.
const FINE: [f64; 2] = [1.7, 1.1];
/// Largest ratio of a setting to the last one.
const STRIDE: f64 = 1e3;
/// Factors of larger settings that are tried at the end.
const LARGER: [f64; 2] = [2.5, 8.0];
/// Exponent of the error over the setting, before two errors are known, and its range: over tolerances and steps.
const EXPONENTS: [[f64; 3]; 2] = [[1.0, 0.4, 2.0], [4.0, 2.0, 10.0]];

/// A setting with the measured error and time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tried {
    pub(super) value: f64,
    /// Infinite if the runs failed.
    pub(super) error: f64,
    /// Evaluations of a trajectory, on average.
    pub(super) evaluations: f64,
    /// Time of a trajectory, on average, in seconds.
    pub(super) time: f64,
}

/// Search for the setting with which a candidate keeps within the error.
pub(super) struct Search<'s, 'p, 'a, S, const N: usize> {
    pub(super) pilot: &'s Pilot<'p, 'a, S, N>,
    pub(super) candidate: usize,
    pub(super) ends: &'s [SVector<f64, N>],
    pub(super) most_steps: usize,
    /// Settings so far.
    pub(super) tried: Vec<Tried>,
}

impl Tried {
    pub(super) fn new<const N: usize>(runs: &Runs<N>, error: f64) -> Self {
        Self {
            value: runs.value,
            error,
            evaluations: runs.evaluations,
            time: runs.time,
        }
    }

    /// Time to reach an error, extrapolated from two settings as a power of it.
    pub(super) fn time_to(tried: &[Self], error: f64) -> f64 {
        let [a, b] = tried else { return f64::INFINITY };
        let growth = log(b.time / a.time) / log(a.error / b.error);
        let growth = if growth.is_finite() {
            growth.clamp(0.0, 0.5)
        } else {
            0.0
        };
        b.time * pow(b.error / error, growth)
    }
}

impl<S: System<f64, N>, const N: usize> Search<'_, '_, '_, S, N> {
    /// Finds the setting, from the first one, unless the candidate is much slower than the `fastest` time so far.
    ///
    /// # Errors
    /// The reason why the candidate is given up.
    pub(super) fn run(&mut self, start: f64, fastest: f64) -> Result<Tried, String> {
        let [least, most] = self.pilot.within;
        if self.tried.is_empty() {
            self.attempt(start)?;
        }
        loop {
            let kept = self.kept();
            let is_slow = |tried: &&Tried| tried.error >= least && tried.time > SLOW * fastest;
            if let Some(slow) = self.tried.iter().find(is_slow) {
                return Err(format!(
                    "slower: {:.1} us for an error of {:.1e}",
                    1e6 * slow.time,
                    slow.error
                ));
            }
            let done = self.tried.len() >= TRIES || kept.is_some_and(|kept| kept.error >= least);
            let next = if done { self.larger() } else { self.next() };
            match (kept, next) {
                (_, Some(value)) => self.attempt(value)?,
                (Some(kept), None) => {
                    return Ok(kept);
                }
                (None, None) => {
                    let smallest = self.tried.iter().map(|tried| tried.error).fold(f64::INFINITY, f64::min);
                    return Err(format!("reaches an error of {smallest:.1e}, not of {most:.1e}"));
                }
            }
        }
    }

    /// Largest setting that is accurate enough.
    fn kept(&self) -> Option<Tried> {
        let most = self.pilot.within[1];
        let enough = self.tried.iter().copied().filter(|tried| tried.error <= most);
        enough.max_by(|a, b| a.value.total_cmp(&b.value))
    }

    /// Next setting to try, by a power law through two settings; `None` if there is none between those tried.
    fn next(&self) -> Option<f64> {
        let [least, most] = self.pilot.within;
        let kind = usize::from(self.is_fixed());
        let kept = self.kept();
        let larger = self
            .tried
            .iter()
            .copied()
            .filter(|tried| kept.is_none_or(|kept| tried.value > kept.value));
        let coarse = larger.min_by(|a, b| a.value.total_cmp(&b.value));
        if let (Some(kept), Some(coarse)) = (kept, coarse)
            && coarse.value / kept.value <= FINE[kind]
        {
            return None;
        }
        let from = kept.or(coarse)?;
        let other = self
            .tried
            .iter()
            .filter(|tried| tried.value != from.value && tried.error.is_finite());
        let near = other.min_by(|a, b| {
            let distance = |tried: &Tried| log(tried.value / from.value).abs();
            distance(a).total_cmp(&distance(b))
        });
        let [guess, low, high] = EXPONENTS[kind];
        let slope = near.map_or(guess, |near| {
            log(near.error / from.error) / log(near.value / from.value)
        });
        let exponent = if slope.is_finite() {
            slope.clamp(low, high)
        } else {
            guess
        };
        let missing = sqrt(least * most) / from.error.max(f64::MIN_POSITIVE);
        let ratio = pow(missing, 1.0 / exponent);
        let ratio = if from.error.is_finite() {
            ratio.clamp(1.0 / STRIDE, STRIDE)
        } else {
            0.25
        };
        let mut value = from.value * ratio;
        if let (Some(kept), Some(coarse)) = (kept, coarse) {
            // away from both, else the search would creep
            let quarter = pow(coarse.value / kept.value, 0.25);
            value = value.clamp(kept.value * quarter, coarse.value / quarter);
        }
        let [shortest, longest] = if self.is_fixed() {
            [self.pilot.span() / self.most_steps as f64, 0.5 * self.pilot.span()]
        } else {
            TOLERANCES
        };
        let value = rounded(value.clamp(shortest, longest));
        self.tried.iter().all(|tried| tried.value != value).then_some(value)
    }

    /// A larger setting than the one found: errors do not grow evenly, and may be small there by chance.
    fn larger(&self) -> Option<f64> {
        let kept = self.kept()?;
        if self.is_fixed() || self.tried.len() >= TRIES + LARGER.len() {
            return None;
        }
        let values = LARGER.map(|factor| rounded(kept.value * factor).min(TOLERANCES[1]));
        values.into_iter().find(|&value| {
            let (low, high) = (value / FINE[0], value * FINE[0]);
            value > kept.value && !self.tried.iter().any(|tried| low < tried.value && tried.value < high)
        })
    }

    fn attempt(&mut self, value: f64) -> Result<(), String> {
        let tried = match self.pilot.runs(self.candidate, value, self.most_steps) {
            Ok(runs) => Tried::new(&runs, self.pilot.error_of(&runs, self.ends)),
            Err(failure) => {
                let may_be_shorter = self.is_fixed() && !matches!(failure.reason, Reason::TooManySteps { .. });
                if self.kept().is_none() && !(may_be_shorter && self.tried.len() < TRIES) {
                    return Err(failure.to_string());
                }
                Tried {
                    value,
                    error: f64::INFINITY,
                    evaluations: 0.0,
                    time: 0.0,
                }
            }
        };
        self.tried.push(tried);
        Ok(())
    }

    fn is_fixed(&self) -> bool {
        self.pilot.candidates[self.candidate].control == Control::Step
    }
}

/// Two significant digits, for a setting to be read.
pub(super) fn rounded(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}
