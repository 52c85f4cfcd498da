//! Search for zeros of witnesses by sampling a step. Used where a witness is not a polynomial of the dense output, or
//! starts at zero.

use super::MAX_CONSTRAINTS;
use super::mode::bits;
use super::step::{Place, StepInMode};
use super::watch::{Ended, ModeWatch, sooner};
use super::witness::{Values, Witness, Witnesses};
use crate::error::Reason;
use crate::method::{first_zero, places, unseen_bend, zero_between};
use crate::real::Float;

/// Largest bend of a force between three samples, relative to its size. A larger one doubles the number of samples.
const MOST_BEND: f64 = 0.25;
/// Maximum number of force samples in a step.
const MOST_FORCES: usize = 1 << 10;

impl<T: Float, const N: usize> ModeWatch<T, N> {
    /// Finds the first zero of some witnesses of the state that ends the mode before `ended`, or returns `ended`.
    pub(super) fn sample_states(
        &mut self,
        step: &StepInMode<'_, T, N>,
        start: (&Place<T>, bool),
        (live, noise): (Witnesses, &Values<T>),
        ended: Option<Ended<T>>,
    ) -> Result<Option<Ended<T>>, Reason> {
        if live.is_empty() || ended.is_some_and(|(theta, _)| theta <= start.0.theta) {
            return Ok(ended);
        }
        let positive = self.positive;
        let mut bends = [T::default(); MAX_CONSTRAINTS];
        let found = self.pass(step, start, (live, noise), &mut bends, ended)?;
        // a driven constraint may move faster than the samples up to there have shown
        if let Some((_, fired)) = found
            && look_ahead(step, start.0, (fired.and(live), noise), &mut bends)
        {
            self.positive = positive;
            return self.pass(step, start, (live, noise), &mut bends, ended);
        }
        Ok(found)
    }

    /// Samples the step once, in order. `bends` holds the largest bend of each gap between samples so far.
    fn pass(
        &mut self,
        step: &StepInMode<'_, T, N>,
        (start, is_first): (&Place<T>, bool),
        (live, noise): (Witnesses, &Values<T>),
        bends: &mut [T; MAX_CONSTRAINTS],
        ended: Option<Ended<T>>,
    ) -> Result<Option<Ended<T>>, Reason> {
        let to = ended.map_or(T::from_f64(1.0), |(theta, _)| theta);
        let (mut earlier, mut last) = (None, *start);
        // a mode may end as soon as it begins
        for theta in places::<T>(is_first).filter(|&theta| theta > start.theta) {
            let here = step.place(theta.min(to));
            self.note_reach(step, &here);
            let mut first = None;
            for (n, witness) in live.pairs() {
                let value = step.number(here.theta, n, step.value(&here, (n, witness)))?;
                let noise = noise[n][witness.slot()];
                let place = if !self.positive.has(n, witness) {
                    if value > noise {
                        self.positive.insert(n, witness);
                    }
                    step.end_at_the_start((n, witness), noise, [start, &last, &here])
                } else if witness.is_gap() {
                    zero_of_gap(
                        step,
                        (n, witness),
                        earlier.as_ref(),
                        [&last, &here],
                        (&mut bends[n], noise),
                    )
                } else {
                    let at = |place: &Place<T>| (place.theta, step.value(place, (n, witness)));
                    let rate = |theta| step.value(&step.place(theta), (n, witness));
                    zero_between(rate, T::default(), earlier.as_ref().map(at), [&last, &here].map(at))
                };
                first = sooner(first, place.map(|theta| (theta, Witnesses::only(n, witness))));
            }
            if first.is_some() || here.theta == to {
                return Ok(first.or(ended));
            }
            (earlier, last) = (Some(last), here);
        }
        Ok(ended)
    }

    /// Finds where the first holding force passes its limit before `ended`, or returns `ended`. Each sample takes an
    /// evaluation.
    pub(super) fn sample_forces(
        &mut self,
        step: &StepInMode<'_, T, N>,
        live: Witnesses,
        ended: Option<Ended<T>>,
    ) -> Result<Option<Ended<T>>, Reason> {
        let known = self.forces.take();
        let start = known.unwrap_or_else(|| step.forces(T::default()));
        for (n, witness) in live.pairs() {
            if step.margin(&start, (n, witness)) > self.noise_of_force(step, n) {
                self.positive.insert(n, witness);
            }
        }
        let positive = self.positive;
        let mut count = self.count_of_forces(step);
        loop {
            let (found, bend) = self.pass_forces(step, (&start, count), live, ended)?;
            if bend > T::from_f64(MOST_BEND) && count < MOST_FORCES {
                (count, self.positive) = (2 * count, positive);
                continue;
            }
            self.width = if bend == T::default() {
                T::from_f64(f64::INFINITY)
            } else {
                step.dense.step().h.abs() / T::from_f64(count as f64)
            };
            return Ok(found);
        }
    }

    /// Number of force samples in a step, a power of two: enough for all extrema of its polynomial, and not much
    /// coarser than a spacing that was fine enough before.
    fn count_of_forces(&self, step: &StepInMode<'_, T, N>) -> usize {
        let least = step.dense.terms().len().div_ceil(2).next_power_of_two();
        let widest = T::from_f64(2.0) * self.width;
        let wanted = libm::ceil((step.dense.step().h.abs() / widest).to_f64()) as usize;
        wanted.next_power_of_two().clamp(least.max(2), MOST_FORCES)
    }

    /// Samples forces at equal distances. Returns the end of the mode, and the largest bend of a force between three
    /// samples, relative to its size.
    fn pass_forces(
        &mut self,
        step: &StepInMode<'_, T, N>,
        (start, count): (&[T; MAX_CONSTRAINTS], usize),
        live: Witnesses,
        ended: Option<Ended<T>>,
    ) -> Result<(Option<Ended<T>>, T), Reason> {
        let to = ended.map_or(T::from_f64(1.0), |(theta, _)| theta);
        let (mut earlier, mut last): (Option<(T, [T; MAX_CONSTRAINTS])>, _) = (None, (T::default(), *start));
        let mut noise = [T::default(); MAX_CONSTRAINTS];
        bits(step.hold.held).for_each(|n| noise[n] = self.noise_of_force(step, n));
        let mut bend = T::default();
        for nth in 1..=count {
            let equal = T::from_f64(nth as f64 / count as f64);
            let theta = equal.min(to);
            let here = (theta, step.forces(theta));
            if theta == equal {
                for (size, force) in self.sizes.iter_mut().zip(&here.1) {
                    *size = size.max(force.abs());
                }
                if let Some(earlier) = &earlier {
                    bend = bend.max(self.bend(step, [&earlier.1, &last.1, &here.1]));
                }
            }
            let mut first = None;
            for (n, witness) in live.pairs() {
                let noise = noise[n];
                let margin = |theta| step.margin(&step.forces(theta), (n, witness));
                let at = |(theta, forces): &(T, [T; MAX_CONSTRAINTS])| (*theta, step.margin(forces, (n, witness)));
                let (before, after) = (at(&last), at(&here));
                step.number(theta, n, after.1)?;
                let place = if self.positive.has(n, witness) {
                    zero_between(margin, noise, earlier.as_ref().map(at), [before, after])
                } else if after.1 + noise < T::default() {
                    let raise = |(theta, margin): (T, T)| (theta, margin + noise);
                    Some(step.end_since(|theta| margin(theta) + noise, raise(before), raise(after)))
                } else {
                    if after.1 > noise {
                        self.positive.insert(n, witness);
                    }
                    None
                };
                first = sooner(first, place.map(|theta| (theta, Witnesses::only(n, witness))));
            }
            self.forces = Some(here.1);
            if first.is_some() || theta == to {
                return Ok((first.or(ended), bend));
            }
            (earlier, last) = (Some(last), here);
        }
        Ok((ended, bend))
    }

    /// Largest bend of the holding forces between three equidistant samples, relative to their sizes.
    fn bend(&self, step: &StepInMode<'_, T, N>, [first, middle, last]: [&[T; MAX_CONSTRAINTS]; 3]) -> T {
        let mut most = T::default();
        for n in bits(step.hold.held) {
            let size = step.laws[n].sticking.max(self.sizes[n]);
            let bend = (first[n] - middle[n] - middle[n] + last[n]).abs();
            if bend > most * size {
                most = bend / size;
            }
        }
        most
    }
}

/// Samples the whole step where gaps of driven constraints have ended the mode. Returns true if they bend more than
/// `bends` showed.
fn look_ahead<T: Float, const N: usize>(
    step: &StepInMode<'_, T, N>,
    start: &Place<T>,
    (fired, noise): (Witnesses, &Values<T>),
    bends: &mut [T; MAX_CONSTRAINTS],
) -> bool {
    let moves = |&(n, witness): &(usize, Witness)| witness.is_gap() && step.moves_by_itself(n);
    let mut finds = false;
    for (n, gap) in fired.pairs().filter(moves) {
        let known = bends[n];
        let (mut earlier, mut last) = (None, step.known(start, (n, gap)));
        for theta in places(false).filter(|&theta| theta > start.theta) {
            let here = step.known(&step.place(theta), (n, gap));
            if let Some(earlier) = earlier {
                bends[n] = bends[n].max(unseen_bend([earlier, last, here], noise[n][gap.slot()]));
            }
            (earlier, last) = (Some(last), here);
        }
        finds |= bends[n] > known;
    }
    finds
}

/// Like [`zero_between`], but for a gap, whose slope is available. `bend` is its largest bend between samples so far.
fn zero_of_gap<T: Float, const N: usize>(
    step: &StepInMode<'_, T, N>,
    gap: (usize, Witness),
    earlier: Option<&Place<T>>,
    last_two: [&Place<T>; 2],
    (bend, noise): (&mut T, T),
) -> Option<T> {
    let function = |theta: T| step.known(&step.place(theta), gap).1;
    let at = |place: &Place<T>| step.known(place, gap);
    let [last, here] = last_two.map(at);
    let Some(earlier) = earlier.map(at).filter(|(_, [value, _])| *value > T::default()) else {
        return first_zero(&function, (last, here), bend, noise);
    };
    *bend = bend.max(unseen_bend([earlier, last, here], noise));
    first_zero(&function, (earlier, last), bend, noise).or_else(|| first_zero(&function, (last, here), bend, noise))
}
