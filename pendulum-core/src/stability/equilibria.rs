//! Search for all equilibria.

use std::f64::consts::{PI, TAU};
use std::ops::Deref;

use nalgebra::SVector;

use super::equilibrium::{SAME, angles, require_autonomous, settle, within_a_turn};
use super::{Equilibrium, StabilityError};
use crate::layout::{Slot, SlotKind, StateLayout};
use crate::system::{Jacobian, System};

/// Range of the search from the seeds in a non-periodic coordinate, in turns or characteristic lengths.
const FAR: f64 = 8.0;
/// Maximum number of coordinates that are shifted in all combinations.
const FEW: usize = 3;
/// Number of equilibria beyond which only periodic angles are shifted.
const MOST: usize = 200;

/// Equilibria as a slice, and the coordinates that were not fully searched.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibria<const N: usize> {
    found: Vec<Equilibrium<N>>,
    unsearched: Vec<String>,
}

impl<const N: usize> Equilibria<N> {
    /// Coordinates whose range was not fully searched: there may be further equilibria.
    ///
    /// These are lengths, since they are unbounded; orientations; and some angles that are not periodic. Such an angle
    /// is listed if equilibria reach 8 turns from the seeds, as on a screw, or if it is shifted separately because
    /// there are more than three coordinates. If equilibria are not isolated, all coordinates except periodic angles
    /// are listed: the search ends after 200 equilibria. Without a layout the list is empty, and only the seeds
    /// themselves were tried.
    #[must_use]
    pub fn unsearched(&self) -> &[String] {
        &self.unsearched
    }
}

impl<const N: usize> Deref for Equilibria<N> {
    type Target = [Equilibrium<N>];

    fn deref(&self) -> &Self::Target {
        &self.found
    }
}

impl<const N: usize> IntoIterator for Equilibria<N> {
    type Item = Equilibrium<N>;
    type IntoIter = std::vec::IntoIter<Equilibrium<N>>;

    fn into_iter(self) -> Self::IntoIter {
        self.found.into_iter()
    }
}

impl<'a, const N: usize> IntoIterator for &'a Equilibria<N> {
    type Item = &'a Equilibrium<N>;
    type IntoIter = std::slice::Iter<'a, Equilibrium<N>>;

    fn into_iter(self) -> Self::IntoIter {
        self.found.iter()
    }
}

/// Finds equilibria from `seeds` and from shifted copies of each result.
///
/// The search continues from each new equilibrium with every angle shifted: by half a turn if the
/// [layout](System::layout) marks it as [periodic](crate::Slot::periodic), otherwise by a quarter and a half turn in
/// both directions, for example under a torsion spring. Lengths are shifted by their size in both directions. Up to
/// three coordinates, if at least one of them is not periodic, are shifted in all combinations; otherwise coordinates
/// are shifted one at a time. Cyclic coordinates and orientations are not shifted.
///
/// For a planar chain on revolute joints without springs the result is complete: each link hangs or stands, in relative
/// or absolute angles. For small scenes with springs completeness is not proven; [`Equilibria::unsearched`] lists the
/// coordinates with an incomplete search.
///
/// Periodic angles are returned in (-pi, pi]; equilibria that differ by full turns of these are the same. Seeds without
/// convergence are skipped.
///
/// # Errors
/// [`StabilityError::TimeDependent`] if the right-hand side may depend on time according to the layout.
pub fn equilibria<S, const N: usize>(
    system: &S,
    seeds: impl IntoIterator<Item = SVector<f64, N>>,
) -> Result<Equilibria<N>, StabilityError>
where
    S: Jacobian<f64, N> + ?Sized,
{
    require_autonomous(system)?;
    let angles = angles(system);
    // the seeds form a stack
    let mut seeds: Vec<_> = seeds.into_iter().collect();
    seeds.reverse();
    let mut beside = Beside::new(system, &seeds);
    let mut found: Vec<Equilibrium<N>> = Vec::new();
    while let Some(mut seed) = seeds.pop() {
        system.project(0.0, &mut seed);
        let Ok(mut x) = settle(system, seed) else {
            continue;
        };
        for &angle in &angles {
            x[angle] = within_a_turn(x[angle]);
        }
        if found.iter().any(|other| is_same(system, &angles, &other.x, &x)) {
            continue;
        }
        let Ok(equilibrium) = Equilibrium::at(system, x) else {
            continue;
        };
        found.push(equilibrium);
        beside.add(&x, &mut seeds);
    }
    Ok(Equilibria {
        found,
        unsearched: beside.unsearched.into_iter().map(String::from).collect(),
    })
}

/// Source of new seeds next to known equilibria.
struct Beside<'a, const N: usize> {
    slots: Vec<&'a Slot<'a>>,
    /// Initial seeds.
    from: Vec<SVector<f64, N>>,
    /// Largest length coordinate of the first equilibrium, or 1 m.
    length: Option<f64>,
    /// Number of equilibria found.
    found: usize,
    unsearched: Vec<&'a str>,
}

impl<'a, const N: usize> Beside<'a, N> {
    fn new(system: &'a (impl System<f64, N> + ?Sized), seeds: &[SVector<f64, N>]) -> Self {
        let slots = system.layout().map_or(&[][..], |layout| layout.slots).iter();
        // dependent coordinates of closed loops are determined by the others
        let slots = slots.filter(|slot| !slot.cyclic && !slot.rates.is_empty());
        let (balls, slots): (Vec<_>, Vec<_>) = slots.partition(|slot| slot.kind == SlotKind::Quaternion);
        Self {
            slots,
            from: seeds.to_vec(),
            length: None,
            unsearched: balls.into_iter().map(|slot| slot.name).collect(),
            found: 0,
        }
    }

    /// Adds seeds next to a new equilibrium.
    fn add(&mut self, x: &SVector<f64, N>, seeds: &mut Vec<SVector<f64, N>>) {
        let lengths = self.slots.iter().filter(|slot| slot.kind == SlotKind::Length);
        let largest = lengths.fold(0.0_f64, |largest, slot| largest.max(x[slot.positions.start].abs()));
        let length = *self.length.get_or_insert(if largest > SAME { largest } else { 1.0 });
        self.found += 1;
        let returns = self.slots.iter().all(|slot| slot.periodic);
        let is_alone = returns || self.slots.len() > FEW;
        // indicates equilibria that are not isolated
        let are_many = self.found > MOST;
        let mut moves: Vec<(usize, &[f64])> = Vec::new();
        let by_length = [length, -length];
        for slot in &self.slots {
            let place = slot.positions.start;
            let (by, whole): (&[f64], f64) = match slot.kind {
                SlotKind::Length => (&by_length, length),
                _ if slot.periodic => (&[PI], f64::INFINITY),
                _ => (&[0.5 * PI, -0.5 * PI, PI, -PI], TAU),
            };
            let is_far = |from: &SVector<f64, N>| (x[place] - from[place]).abs() > FAR * whole;
            let is_far = self.from.iter().all(is_far) || are_many && !slot.periodic;
            let is_left = is_far || slot.kind == SlotKind::Length || is_alone && !slot.periodic;
            if is_left && !self.unsearched.contains(&slot.name) {
                self.unsearched.push(slot.name);
            }
            if !is_far {
                moves.push((place, by));
            }
        }
        let before = seeds.len();
        for (place, by) in moves {
            let together = if is_alone { before } else { seeds.len() };
            for k in before..=together {
                let from = if k < together { seeds[k] } else { *x };
                for by in by {
                    let mut moved = from;
                    moved[place] += by;
                    seeds.push(moved);
                }
            }
        }
        // search the first coordinate first
        seeds[before..].reverse();
    }
}

/// Checks that two states are equal up to full turns and the signs of quaternions.
fn is_same<const N: usize>(
    system: &(impl System<f64, N> + ?Sized),
    angles: &[usize],
    other: &SVector<f64, N>,
    x: &SVector<f64, N>,
) -> bool {
    let mut apart = other - x;
    for &angle in angles {
        apart[angle] = within_a_turn(apart[angle]);
    }
    for places in system.layout().into_iter().flat_map(StateLayout::quaternions) {
        // opposite quaternions represent the same orientation
        if places.clone().map(|n| other[n] * x[n]).sum::<f64>() < 0.0 {
            places.for_each(|n| apart[n] = other[n] + x[n]);
        }
    }
    apart.norm() <= SAME * (1.0 + x.norm())
}
