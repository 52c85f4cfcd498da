//! The search for all states of rest.

use std::f64::consts::{PI, TAU};
use std::ops::Deref;

use nalgebra::SVector;

use super::equilibrium::{SAME, angles, require_autonomous, settle, within_a_turn};
use super::{Equilibrium, StabilityError};
use crate::layout::{Slot, SlotKind, StateLayout};
use crate::system::{Jacobian, System};

/// The turns, or lengths of the scene, from the seeds within which the search goes on where nothing is periodic.
const FAR: f64 = 8.0;
/// The most coordinates that are moved in all combinations.
const FEW: usize = 3;
/// The number of equilibria after which only periodic angles are turned.
const MOST: usize = 200;

/// Equilibria that were found, as a slice, and what was not searched.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibria<const N: usize> {
    found: Vec<Equilibrium<N>>,
    unsearched: Vec<String>,
}

impl<const N: usize> Equilibria<N> {
    /// The coordinates whose range was not searched to its end: there may be equilibria beyond.
    ///
    /// Such are lengths, which know no turns; angles that are not periodic and had equilibria up to 8 turns away from
    /// the seeds, as on a screw, or that are moved one at a time since there are more than three coordinates; and
    /// orientations. Where equilibria are not isolated all are listed but periodic angles: the search ends after 200.
    /// Without a layout the list is empty, and nothing was searched but from the seeds.
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

/// The equilibria that are found from `seeds`, and from points beside those.
///
/// From each new one the search goes on with each angle turned: by half a turn where the [layout](System::layout) calls
/// it [periodic](crate::Slot::periodic), and by a quarter and a half either way where it is not, as under a spring.
/// Lengths are moved by their size either way. At most three coordinates, of which one is not periodic, are moved in
/// all combinations, more of them one at a time. Cyclic ones and orientations stay. Of a planar chain that hangs on
/// revolute joints, without springs, these are all: each of its links hangs or stands, in relative or in absolute
/// angles. Of small scenes with springs nothing proves that they are; [`Equilibria::unsearched`] tells in which
/// coordinates there may be more.
///
/// Periodic angles are returned in (-pi, pi]; equilibria that differ by full turns of these are the same. Seeds that
/// lead nowhere are passed over.
///
/// # Errors
/// [`StabilityError::TimeDependent`] if the layout says that time may occur.
pub fn equilibria<S, const N: usize>(
    system: &S,
    seeds: impl IntoIterator<Item = SVector<f64, N>>,
) -> Result<Equilibria<N>, StabilityError>
where
    S: Jacobian<f64, N> + ?Sized,
{
    require_autonomous(system)?;
    let angles = angles(system);
    // the last are the next
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

/// Where to search beside equilibria.
struct Beside<'a, const N: usize> {
    slots: Vec<&'a Slot<'a>>,
    /// Where the search began.
    from: Vec<SVector<f64, N>>,
    /// The largest length of the first equilibrium, or 1 m.
    length: Option<f64>,
    /// The number of equilibria so far.
    found: usize,
    unsearched: Vec<&'a str>,
}

impl<'a, const N: usize> Beside<'a, N> {
    fn new(system: &'a (impl System<f64, N> + ?Sized), seeds: &[SVector<f64, N>]) -> Self {
        let slots = system.layout().map_or(&[][..], |layout| layout.slots).iter();
        // what follows from closed loops moves with the rest
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

    /// Adds what lies beside a new equilibrium.
    fn add(&mut self, x: &SVector<f64, N>, seeds: &mut Vec<SVector<f64, N>>) {
        let lengths = self.slots.iter().filter(|slot| slot.kind == SlotKind::Length);
        let largest = lengths.fold(0.0_f64, |largest, slot| largest.max(x[slot.positions.start].abs()));
        let length = *self.length.get_or_insert(if largest > SAME { largest } else { 1.0 });
        self.found += 1;
        let returns = self.slots.iter().all(|slot| slot.periodic);
        let is_alone = returns || self.slots.len() > FEW;
        // as where they are not isolated
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
        // the first coordinate comes first
        seeds[before..].reverse();
    }
}

/// Whether two states are one, but for full turns and the signs of quaternions.
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
        // the opposite quaternion is the same orientation
        if places.clone().map(|n| other[n] * x[n]).sum::<f64>() < 0.0 {
            places.for_each(|n| apart[n] = other[n] + x[n]);
        }
    }
    apart.norm() <= SAME * (1.0 + x.norm())
}
