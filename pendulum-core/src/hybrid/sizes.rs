//! Sizes relative to which rounding errors of constraints are measured.

use core::ops::Range;

use nalgebra::SVector;

use super::kinematics::Kinematics;
use super::{Hybrid, MAX_CONSTRAINTS};
use crate::layout::{SlotKind, StateLayout};
use crate::real::Float;

/// Largest derivatives of each constraint with respect to lengths and to angles, near the state in which an integration
/// starts. Only their order of magnitude matters.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gains<T, const N: usize> {
    by_lengths: [T; MAX_CONSTRAINTS],
    by_angles: [T; MAX_CONSTRAINTS],
    /// True for positions and rates of angles and orientations.
    is_angle: [bool; N],
}

/// Sizes of values and rates at a state.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sizes<T> {
    /// Size of the terms that sum up to each value.
    pub(super) values: [T; MAX_CONSTRAINTS],
    /// Size of the terms that sum up to each rate.
    pub(super) rates: [T; MAX_CONSTRAINTS],
}

impl<T: Float, const N: usize> Gains<T, N> {
    /// Placeholder before an integration starts.
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
        let kinematics = Kinematics::of(system);
        let mut gains = Self {
            is_angle: angles(layout, kinematics),
            ..Self::none()
        };
        gains.note(system, t, x);
        // the gap between a hanging pendulum and the floor has a zero derivative there
        let mut turned = *x;
        kinematics.displace(&mut turned, |k| T::from_f64(f64::from(u8::from(gains.is_angle[k]))));
        if turned != *x && system.constraints().iter().any(|constraint| constraint.rate.is_empty()) {
            gains.note(system, t, &turned);
        }
        gains
    }

    /// Updates the derivatives by those at a state, where a rate is linear in the rates of the coordinates.
    fn note(&mut self, system: &dyn Hybrid<T, N>, t: T, x: &SVector<T, N>) {
        let by_itself = rates_at_rest(system, t, x);
        let rates = Kinematics::of(system).rates();
        for k in rates.clone() {
            let mut moving = *x;
            for other in rates.clone() {
                moving[other] = T::from_f64(if other == k { 1.0 } else { 0.0 });
            }
            let measures = system.measures(t, &moving);
            let gains = if self.is_angle[k] {
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

    /// Sizes at a state. An angle counts as at least 1 rad, which is the size of the factor of its sine and cosine. A
    /// driven position is as accurate as the time.
    pub(super) fn sizes(&self, system: &dyn Hybrid<T, N>, t: T, x: &SVector<T, N>) -> Sizes<T> {
        let kinematics = Kinematics::of(system);
        let [length, angle] = self.largest(x, kinematics.positions());
        let [speed, turning] = self.largest(x, kinematics.rates());
        let angle = angle.max(T::from_f64(1.0));
        let by_itself = rates_at_rest(system, t, x).map(|rate| rate.abs());
        let all = |length: T, angle: T, n: usize| (self.by_lengths[n] * length).max(self.by_angles[n] * angle);
        Sizes {
            values: core::array::from_fn(|n| all(length, angle, n).max(t.abs() * by_itself[n])),
            rates: core::array::from_fn(|n| all(speed, turning, n).max(by_itself[n])),
        }
    }

    /// For each component, the largest rate of its kind: of lengths, or of angles.
    pub(super) fn of_kind(&self, kinematics: Kinematics<'_>, x: &SVector<T, N>) -> SVector<T, N> {
        let [speed, turning] = self.largest(x, kinematics.rates());
        SVector::from_fn(|k, _| if self.is_angle[k] { turning } else { speed })
    }

    /// Largest of the lengths and largest of the angles, among positions or rates. Components of quaternions count as
    /// angles.
    fn largest(&self, x: &SVector<T, N>, among: Range<usize>) -> [T; 2] {
        let [mut lengths, mut angles] = [T::default(); 2];
        for k in among {
            let largest = if self.is_angle[k] { &mut angles } else { &mut lengths };
            *largest = largest.max(x[k].abs());
        }
        [lengths, angles]
    }
}

/// Marks the positions and rates of angles and orientations. Without a layout all other positions are lengths.
fn angles<const N: usize>(layout: Option<StateLayout<'_>>, kinematics: Kinematics<'_>) -> [bool; N] {
    let slots = layout.map_or(&[][..], |layout| layout.slots);
    let angles = slots.iter().filter(|slot| slot.kind == SlotKind::Angle);
    let angles = angles.flat_map(|slot| [slot.positions.clone(), slot.rates.clone()]);
    let mut marks = [false; N];
    for places in angles.chain(kinematics.orientations().flatten()) {
        marks
            .get_mut(places)
            .into_iter()
            .flatten()
            .for_each(|mark| *mark = true);
    }
    marks
}

/// Rate of each constraint where all coordinates rest: nonzero only for driven constraints.
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
    Kinematics::of(system).rates().for_each(|k| at_rest[k] = T::default());
    system.measures(t, &at_rest).map(|[_, rate]| rate)
}

/// Sizes relative to which rounding errors of accelerations and of forces are measured, at the beginning of a mode.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ForceSizes<T> {
    /// Size of the terms that sum up to the acceleration of each constraint.
    pub(super) accelerations: [T; MAX_CONSTRAINTS],
    /// Force along each constraint that causes such an acceleration.
    pub(super) forces: [T; MAX_CONSTRAINTS],
}

impl<T: Float> ForceSizes<T> {
    /// Placeholder before an integration starts.
    pub(super) fn none() -> Self {
        let none = [T::default(); MAX_CONSTRAINTS];
        Self {
            accelerations: none,
            forces: none,
        }
    }
}
