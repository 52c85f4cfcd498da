//! Sizes to which the rounding errors of constraints are relative.

use nalgebra::SVector;

use super::{Hybrid, MAX_CONSTRAINTS};
use crate::layout::{SlotKind, StateLayout};
use crate::real::Float;

/// The largest derivatives of each constraint by lengths and by angles, about the state in which an integration starts.
/// Only their order of magnitude matters.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gains<T, const N: usize> {
    by_lengths: [T; MAX_CONSTRAINTS],
    by_angles: [T; MAX_CONSTRAINTS],
    /// Which positions are angles.
    is_angle: [bool; N],
}

/// Sizes of values and rates at a state.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sizes<T> {
    /// Of the terms that a value is a sum of.
    pub(super) values: [T; MAX_CONSTRAINTS],
    /// Of the terms that a rate is a sum of.
    pub(super) rates: [T; MAX_CONSTRAINTS],
}

impl<T: Float, const N: usize> Gains<T, N> {
    /// None at all: before an integration starts.
    pub(super) fn none() -> Self {
        Self {
            by_lengths: [T::default(); MAX_CONSTRAINTS],
            by_angles: [T::default(); MAX_CONSTRAINTS],
            is_angle: [false; N],
        }
    }

    pub(super) fn near(
        (system, layout): (&dyn Hybrid<T, N>, Option<StateLayout<'_>>),
        t: T,
        x: &SVector<T, N>,
    ) -> Self {
        let mut gains = Self {
            is_angle: core::array::from_fn(|k| is_angle(layout, k)),
            ..Self::none()
        };
        gains.note(system, t, x);
        // the gap to a floor below a pendulum that hangs has no derivative there
        let mut turned = *x;
        for k in 0..N / 2 {
            if gains.is_angle[k] {
                turned[k] += T::from_f64(1.0);
            }
        }
        if turned != *x && system.constraints().iter().any(|constraint| constraint.rate.is_empty()) {
            gains.note(system, t, &turned);
        }
        gains
    }

    /// Notes the derivatives at a state: a rate is linear in the rates of the coordinates.
    fn note(&mut self, system: &dyn Hybrid<T, N>, t: T, x: &SVector<T, N>) {
        let by_itself = rates_at_rest(system, t, x);
        for k in N / 2..N {
            let mut moving = *x;
            for (other, rate) in moving.iter_mut().enumerate().skip(N / 2) {
                *rate = T::from_f64(if other == k { 1.0 } else { 0.0 });
            }
            let measures = system.measures(t, &moving);
            let gains = if self.is_angle[k - N / 2] {
                &mut self.by_angles
            } else {
                &mut self.by_lengths
            };
            for ((gain, [_, rate]), by_itself) in gains.iter_mut().zip(measures).zip(by_itself) {
                let own = (rate - by_itself).abs();
                *gain = if own.is_finite() { gain.max(own) } else { *gain };
            }
        }
    }

    /// The sizes at a state. An angle counts as 1 rad at least, which is the size of what its sine and cosine are
    /// multiplied by; the place of what moves by itself is as exact as the time is.
    pub(super) fn sizes(&self, system: &dyn Hybrid<T, N>, t: T, x: &SVector<T, N>) -> Sizes<T> {
        let [length, angle] = self.largest(x.iter().take(N / 2));
        let [speed, turning] = self.largest(x.iter().skip(N / 2));
        let angle = angle.max(T::from_f64(1.0));
        let by_itself = rates_at_rest(system, t, x).map(|rate| rate.abs());
        let all = |length: T, angle: T, n: usize| (self.by_lengths[n] * length).max(self.by_angles[n] * angle);
        Sizes {
            values: core::array::from_fn(|n| all(length, angle, n).max(t.abs() * by_itself[n])),
            rates: core::array::from_fn(|n| all(speed, turning, n).max(by_itself[n])),
        }
    }

    /// For each rate in a state, the largest one of its kind: of a length, or of an angle.
    pub(super) fn of_kind(&self, x: &SVector<T, N>) -> SVector<T, N> {
        let [speed, turning] = self.largest(x.iter().skip(N / 2));
        SVector::from_fn(|k, _| if self.is_angle[k % (N / 2)] { turning } else { speed })
    }

    /// The largest of lengths, and the largest of angles, of positions or of their rates.
    fn largest<'a>(&self, of: impl Iterator<Item = &'a T>) -> [T; 2]
    where
        T: 'a,
    {
        let [mut lengths, mut angles] = [T::default(); 2];
        for (value, is_angle) in of.zip(self.is_angle) {
            let largest = if is_angle { &mut angles } else { &mut lengths };
            *largest = largest.max(value.abs());
        }
        [lengths, angles]
    }
}

/// Whether a position is an angle; without a layout all of them are lengths.
fn is_angle(layout: Option<StateLayout<'_>>, position: usize) -> bool {
    let slots = layout.map_or(&[][..], |layout| layout.slots);
    // a slot has at least one position, so it is at its place or before
    let mut before = slots.iter().take(position + 1).rev();
    let slot = before.find(|slot| slot.positions.start <= position);
    slot.is_some_and(|slot| slot.kind == SlotKind::Angle && slot.positions.start == position)
}

/// The rate of each constraint while nothing but what is driven moves.
pub(super) fn rates_at_rest<T: Float, const N: usize>(
    system: &dyn Hybrid<T, N>,
    t: T,
    x: &SVector<T, N>,
) -> [T; MAX_CONSTRAINTS] {
    if system
        .constraints()
        .iter()
        .all(|constraint| !constraint.rate.is_empty())
    {
        return [T::default(); MAX_CONSTRAINTS];
    }
    let mut at_rest = *x;
    at_rest.iter_mut().skip(N / 2).for_each(|rate| *rate = T::default());
    system.measures(t, &at_rest).map(|[_, rate]| rate)
}

/// Sizes to which rounding errors of accelerations and of forces are relative, where a mode begins.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ForceSizes<T> {
    /// Of the terms that the acceleration of each constraint is a sum of.
    pub(super) accelerations: [T; MAX_CONSTRAINTS],
    /// Of the forces along each that take such accelerations.
    pub(super) forces: [T; MAX_CONSTRAINTS],
}

impl<T: Float> ForceSizes<T> {
    /// None at all: before an integration starts.
    pub(super) fn none() -> Self {
        let none = [T::default(); MAX_CONSTRAINTS];
        Self {
            accelerations: none,
            forces: none,
        }
    }
}
