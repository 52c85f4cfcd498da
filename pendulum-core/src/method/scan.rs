//! Sampling of a function along a step, densely enough to separate its zeros.

use crate::event::Direction;
use crate::method::zero::PLACES;
use crate::real::Float;

/// Thresholds for signs that a function varies faster than its samples in a step resolve.
#[derive(Clone, Copy)]
struct Signs {
    /// Number of turns between the samples.
    turns: usize,
    /// Number of ends at which the tangent is far off the next sample.
    ends: usize,
    /// Deviation of the tangent that counts as far off, relative to the range of the samples.
    off: f64,
    /// True if the function may exceed its samples by the same deviation.
    may_reach_beyond: bool,
}

/// Signs that more samples are needed: a sine shows them from 1.5 rad between neighbours on, and has more than one zero
/// between neighbours from pi on.
const SUSPICIOUS: Signs = Signs {
    turns: 4,
    ends: 1,
    off: 0.5,
    may_reach_beyond: true,
};
/// Signs that zeros may be missed even between the finest samples.
const UNRESOLVED: Signs = Signs {
    turns: 7,
    ends: 2,
    off: 1.5,
    may_reach_beyond: false,
};
/// Change that counts as a turn, relative to the range of the function.
const SWING: f64 = 1.0 / 8.0;
/// Number of times that intervals between samples are subdivided.
const DEPTH: usize = 2;
/// Swings, relative to the largest magnitude, below which intervals are not subdivided: remainders of cancellation.
const NOISE: f64 = 1e-9;

/// Positions at which a function was evaluated in a step, with its values. Stored to reuse its memory.
pub(super) struct Scan<T> {
    samples: Vec<(T, T)>,
    coarse: Vec<(T, T)>,
}

impl<T> Default for Scan<T> {
    fn default() -> Self {
        Self {
            samples: Vec::new(),
            coarse: Vec::new(),
        }
    }
}

impl<T: Float> Scan<T> {
    /// Samples after the start, in their order.
    pub(super) fn samples(&self) -> &[(T, T)] {
        &self.samples
    }

    /// Takes samples of a function in a step, and refines them where they are too coarse. Returns true if neighbours
    /// are close enough to separate all zeros. `size` is the largest magnitude so far, and `start` the value at the
    /// start.
    pub(super) fn look(
        &mut self,
        function: impl Fn(T) -> T,
        (start, size): (T, T),
        places: impl Iterator<Item = (T, T)>,
        wanted: Wanted,
    ) -> bool {
        self.samples.clear();
        self.samples.extend(places);
        let first = (T::default(), start);
        if !goes_up_and_down(first, &self.samples, size, SUSPICIOUS) {
            return true;
        }
        // the first step has more samples, close together at its start
        let close = self.samples.len().saturating_sub(PLACES.len());
        self.coarse.clear();
        self.coarse.extend(self.samples.drain(close..));
        let from = self.samples.last().copied().unwrap_or(first);
        let division = Division { function, size, wanted };
        division.divide((from, &self.coarse), DEPTH - 1, &mut self.samples)
    }
}

/// Zeros of a step that matter.
#[derive(Clone, Copy)]
pub(super) enum Wanted {
    All,
    /// None after the first zero passed in this direction.
    First(Direction),
}

/// Subdivision of intervals between the samples of a function.
struct Division<F, T> {
    function: F,
    size: T,
    wanted: Wanted,
}

impl<F: Fn(T) -> T, T: Float> Division<F, T> {
    /// Samples the function between the given positions, and recursively where it oscillates, or everywhere if it
    /// oscillates in most intervals. Returns true if neighbours are close enough to separate the zeros.
    fn divide(&self, (mut from, places): ((T, T), &[(T, T)]), depth: usize, samples: &mut Vec<(T, T)>) -> bool {
        let signs = if depth == 0 { UNRESOLVED } else { SUSPICIOUS };
        let part = |&to: &(T, T)| {
            let start = std::mem::replace(&mut from, to);
            let between = self.between(start, to);
            (start, between, goes_up_and_down(start, &between, self.size, signs))
        };
        let mut parts = places.iter().map(part);
        // only further subdivisions depend on later parts: else none is sampled after the last zero that matters
        let ahead = if depth > 0 { places.len() } else { 0 };
        let sampled: Vec<_> = parts.by_ref().take(ahead).collect();
        let all_are_fast = 2 * sampled.iter().filter(|&&(.., is_fast)| is_fast).count() >= PLACES.len();
        let mut is_resolved = true;
        for (start, between, is_fast) in sampled.into_iter().chain(parts) {
            let first = samples.len();
            if depth > 0 && (is_fast || all_are_fast) {
                is_resolved &= self.divide((start, &between), depth - 1, samples);
            } else {
                samples.extend(between);
                is_resolved &= depth > 0 || !is_fast;
            }
            if self.passes(start, &samples[first..]) {
                break;
            }
        }
        is_resolved
    }

    /// Samples between two positions, and the second of these.
    fn between(&self, from: (T, T), to: (T, T)) -> [(T, T); PLACES.len()] {
        let mut between = [to; PLACES.len()];
        for (point, place) in between.iter_mut().zip(&PLACES[..PLACES.len() - 1]) {
            let theta = from.0 + T::from_f64(*place) * (to.0 - from.0);
            *point = (theta, (self.function)(theta));
        }
        between
    }

    /// True if the samples clearly pass the zero after which no other matters.
    fn passes(&self, start: (T, T), points: &[(T, T)]) -> bool {
        let Wanted::First(direction) = self.wanted else {
            return false;
        };
        let noise = T::EPSILON.sqrt() * self.size;
        let values = std::iter::once(start)
            .chain(points.iter().copied())
            .map(|(_, value)| value);
        let mut signs = values
            .filter(|value| value.abs() > noise)
            .map(|value| value > T::default());
        let Some(mut before) = signs.next() else {
            return false;
        };
        signs.any(|rises| {
            let passes = rises != std::mem::replace(&mut before, rises);
            passes && direction.includes(rises)
        })
    }
}

/// True if values show one of the signs, and come so close to zero that more zeros may lie between them.
fn goes_up_and_down<T: Float>(first: (T, T), rest: &[(T, T)], size: T, signs: Signs) -> bool {
    let (mut least, mut low, mut high) = (first.1.abs(), first.1, first.1);
    for &(_, value) in rest {
        (least, low, high) = (least.min(value.abs()), low.min(value), high.max(value));
    }
    let range = high - low;
    let is_noise = range <= T::from_f64(NOISE) * size.max(high).max(-low);
    if is_noise || rest.iter().any(|(_, value)| !value.is_finite()) {
        return false;
    }
    // the first step has more samples at its start
    if let Some([near, next, .., before, beside, last]) = rest.last_chunk::<{ PLACES.len() }>() {
        let far = T::from_f64(PLACES[1] / PLACES[0]);
        let off = |end: T, near: T, next: T| (next - end - far * (near - end)).abs();
        let off = [off(first.1, near.1, next.1), off(last.1, beside.1, before.1)];
        let ends = off
            .into_iter()
            .filter(|&off| off > T::from_f64(signs.off) * range)
            .count();
        let reach = if signs.may_reach_beyond {
            off[0].max(off[1])
        } else {
            range
        };
        if ends >= signs.ends && least <= reach {
            return true;
        }
    }
    least <= range && turns((first.1, rest), T::from_f64(SWING) * range) >= signs.turns
}

/// Number of times that values go back by more than `swing`.
fn turns<T: Float>((first, rest): (T, &[(T, T)]), swing: T) -> usize {
    let (mut count, mut extreme, mut rises) = (0, first, None);
    for &(_, value) in rest {
        let goes_on = rises.is_some_and(|rises| rises == (value > extreme));
        if !goes_on && (value - extreme).abs() <= swing {
            continue;
        }
        count += usize::from(!goes_on && rises.is_some());
        (extreme, rises) = (value, Some(value > extreme));
    }
    count
}
