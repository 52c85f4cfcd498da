//! The fastest candidates: their settings by pilot runs, then their times side by side.

use libm::sqrt;

use super::TuneError;
use super::candidate::Control;
use super::pilot::{Dropped, MORE_STEPS, Pilot, STEPS, of_kind};
use super::search::{Search, Tried};
use crate::accuracy::timing::{Timer, in_turns};
use crate::system::System;

/// Ratio to the shortest time up to which methods are timed again, side by side.
const CLOSE: f64 = 2.0;
/// Number of these timings.
const ROUNDS: usize = 7;

/// A candidate that keeps within the error: its index and setting.
pub(super) type Found = (usize, Tried);

impl<S: System<f64, N>, const N: usize> Pilot<'_, '_, S, N> {
    /// Finds the candidates that keep within the error, the fastest first, and those given up.
    pub(super) fn search(&self) -> Result<(Vec<Found>, Vec<Dropped>), TuneError> {
        let (compared, mut dropped) = self.compare()?;
        let ends = self.ends(&compared)?;
        let steps = compared.iter().map(|of| of.runs[0].steps).min().unwrap_or(STEPS[0]);
        let search = |candidate, tried, fastest| {
            let start = self.span() / (4.0 * steps as f64);
            let mut search = Search {
                pilot: self,
                candidate,
                ends: &ends,
                most_steps: (MORE_STEPS * steps).max(STEPS[0]),
                tried,
            };
            let found = search.run(start, fastest);
            let errors = search.tried.iter().map(|tried| tried.error);
            (found, errors.fold(f64::INFINITY, f64::min))
        };

        let mut searches: Vec<(usize, Vec<Tried>)> = compared
            .iter()
            .map(|of| {
                let tried = of.runs.iter().map(|runs| Tried::new(runs, self.error_of(runs, &ends)));
                (of.candidate, tried.collect())
            })
            .collect();
        let target = sqrt(self.within[0] * self.within[1]);
        searches.sort_by(|(_, a), (_, b)| Tried::time_to(a, target).total_cmp(&Tried::time_to(b, target)));
        searches.extend(of_kind(self.candidates, Control::Step).map(|n| (n, Vec::new())));

        let (mut found, mut least) = (Vec::<Found>::new(), (f64::INFINITY, ""));
        for (n, tried) in searches {
            let fastest = found.iter().map(|(_, kept)| kept.time).fold(f64::INFINITY, f64::min);
            let (outcome, error) = search(n, tried, fastest);
            self.check_cancelled()?;
            match outcome {
                Ok(kept) => found.push((n, kept)),
                Err(why) => dropped.push((n, why)),
            }
            if error < least.0 {
                least = (error, self.candidates[n].name);
            }
        }
        if found.is_empty() {
            return Err(TuneError::NotReached {
                error: self.error,
                most: self.within[1],
                least,
            });
        }
        self.time_again(&mut found);
        self.check_cancelled()?;
        Ok((found, dropped))
    }

    /// Times the fastest candidates side by side, and sorts all by their times.
    fn time_again(&self, found: &mut [Found]) {
        found.sort_by(|(_, a), (_, b)| a.time.total_cmp(&b.time));
        let close = found.partition_point(|(_, kept)| kept.time <= CLOSE * found[0].1.time);
        let mut timers: Vec<_> = found[..close]
            .iter()
            .map(|&(candidate, kept)| {
                Timer::new(move || {
                    self.runs(candidate, kept.value, usize::MAX).ok();
                })
            })
            .collect();
        in_turns(&mut timers, ROUNDS);
        let count = self.starts.len() as f64;
        let times: Vec<f64> = timers
            .iter_mut()
            .map(|timer| timer.minimum_and_median().0 / count)
            .collect();
        drop(timers);
        for ((_, kept), time) in found.iter_mut().zip(times) {
            kept.time = time;
        }
        found.sort_by(|(_, a), (_, b)| a.time.total_cmp(&b.time));
    }
}
