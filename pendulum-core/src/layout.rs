//! Layout of a state: kind, position and symmetries of each coordinate.

#[cfg(feature = "std")]
mod names;

use core::ops::Range;

#[cfg(feature = "std")]
use nalgebra::SVector;

#[cfg(feature = "std")]
use crate::real::Real;

#[cfg(feature = "std")]
pub use names::WrongLength;

/// Kind and place of each coordinate of a state, and whether the right-hand side depends on time.
///
/// [`mechanism!`](crate::mechanism) generates the layout as the constant `LAYOUT` of a model, and
/// [`System::layout`](crate::System::layout) returns it. The analyses of [`stability`](crate::stability) use it.
/// Systems written by hand should provide a layout if they are periodic in an angle:
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::{Slot, StateLayout};
///
/// struct Swing;
///
/// impl System<f64, 2> for Swing {
///     fn rhs(&self, _t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
///         SVector::from([x[1], -9.81 * x[0].sin()])
///     }
///
///     fn layout(&self) -> Option<StateLayout<'_>> {
///         const LAYOUT: StateLayout<'_> = StateLayout::new(&[Slot::angle("theta", 0, 1).periodic()]).autonomous();
///         Some(LAYOUT)
///     }
/// }
///
/// let layout = Swing.layout().expect("stated above");
/// assert_eq!((layout.slots[0].name, layout.slots[0].rate_unit()), ("theta", "rad/s"));
/// assert!(layout.autonomous && layout.angles().eq([0]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct StateLayout<'a> {
    /// Coordinates and their rates. In the state, all positions precede all rates.
    pub slots: &'a [Slot<'a>],
    /// First-order states, which follow the rates.
    pub states: &'a [StateVariable<'a>],
    /// True if the right-hand side is known not to depend on time.
    pub autonomous: bool,
}

impl<'a> StateLayout<'a> {
    /// Layout of a state with these coordinates. The right-hand side may depend on time.
    #[must_use]
    pub const fn new(slots: &'a [Slot<'a>]) -> Self {
        Self {
            slots,
            states: &[],
            autonomous: false,
        }
    }

    /// Adds first-order states, which follow the rates of the coordinates.
    #[must_use]
    pub const fn with_states(mut self, states: &'a [StateVariable<'a>]) -> Self {
        self.states = states;
        self
    }

    /// Marks the right-hand side as independent of time.
    #[must_use]
    pub const fn autonomous(mut self) -> Self {
        self.autonomous = true;
        self
    }

    /// Number of position components; the rates follow them.
    #[must_use]
    pub fn positions(self) -> usize {
        self.slots.iter().map(|slot| slot.positions.len()).sum()
    }

    /// Number of rate components; the first-order states follow them.
    #[must_use]
    pub fn rates(self) -> usize {
        self.slots.iter().map(|slot| slot.rates.len()).sum()
    }

    /// Number of all components: positions, rates and first-order states.
    #[must_use]
    pub fn length(self) -> usize {
        self.positions() + self.rates() + self.states.len()
    }

    /// Components of the state that form a quaternion, one range for each.
    pub fn quaternions(self) -> impl Iterator<Item = Range<usize>> {
        let slots = self.slots.iter().filter(|slot| slot.kind == SlotKind::Quaternion);
        slots.map(|slot| slot.positions.clone())
    }

    /// Scales the quaternions of a state to unit length.
    #[cfg(feature = "std")]
    pub(crate) fn normalise<T: Real, const N: usize>(self, x: &mut SVector<T, N>) {
        for places in self.quaternions() {
            let mut squares = places.clone().map(|place| x[place] * x[place]);
            let first = squares.next().unwrap_or_default();
            let norm = squares.fold(first, |sum, square| sum + square).sqrt();
            places.for_each(|place| x[place] /= norm);
        }
    }

    /// Components of the state that are angles with the period 2 pi, as defined by [`Slot::periodic`].
    pub fn angles(self) -> impl Iterator<Item = usize> {
        self.slots
            .iter()
            .filter(|slot| slot.periodic)
            .flat_map(|slot| slot.positions.clone())
    }
}

/// A coordinate: its place in the state and its symmetries.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct Slot<'a> {
    /// Name of the coordinate.
    pub name: &'a str,
    /// Kind of the coordinate.
    pub kind: SlotKind,
    /// Components of the state that hold the position.
    pub positions: Range<usize>,
    /// Components of the state that hold the rate. A quaternion has fewer rates than positions.
    pub rates: Range<usize>,
    /// True if a full turn of 2 pi is known to be a symmetry: each body returns to its place, and the right-hand side
    /// is the same.
    ///
    /// A helical joint with a pitch advances its body, and a torsion spring counts turns: neither has a periodic
    /// coordinate.
    pub periodic: bool,
    /// True if the right-hand side is known not to depend on the position, for example the place of a cart on a level
    /// track.
    pub cyclic: bool,
}

impl<'a> Slot<'a> {
    /// A coordinate at the components `positions` of the state, with its rate at `rates`. No symmetry is assumed.
    #[must_use]
    pub const fn new(name: &'a str, kind: SlotKind, positions: Range<usize>, rates: Range<usize>) -> Self {
        Self {
            name,
            kind,
            positions,
            rates,
            periodic: false,
            cyclic: false,
        }
    }

    /// An angle at the component `position` of the state, with its rate at `rate`. It is not
    /// [`periodic`](Self::periodic) by default.
    #[must_use]
    pub const fn angle(name: &'a str, position: usize, rate: usize) -> Self {
        Self::new(name, SlotKind::Angle, position..position + 1, rate..rate + 1)
    }

    /// A length at the component `position` of the state, with its rate at `rate`.
    #[must_use]
    pub const fn length(name: &'a str, position: usize, rate: usize) -> Self {
        Self::new(name, SlotKind::Length, position..position + 1, rate..rate + 1)
    }

    /// Marks a full turn as a symmetry; see the field of this name.
    #[must_use]
    pub const fn periodic(mut self) -> Self {
        self.periodic = true;
        self
    }

    /// Marks the right-hand side as independent of this coordinate.
    #[must_use]
    pub const fn cyclic(mut self) -> Self {
        self.cyclic = true;
        self
    }

    /// Unit of the position.
    #[must_use]
    pub const fn unit(&self) -> &'static str {
        match self.kind {
            SlotKind::Angle => "rad",
            SlotKind::Length => "m",
            SlotKind::Quaternion => "1",
        }
    }

    /// Unit of the rate.
    #[must_use]
    pub const fn rate_unit(&self) -> &'static str {
        match self.kind {
            SlotKind::Angle | SlotKind::Quaternion => "rad/s",
            SlotKind::Length => "m/s",
        }
    }
}

/// A first-order state, such as a motor current: a component of the state that is neither a coordinate nor a rate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct StateVariable<'a> {
    /// Name of the state.
    pub name: &'a str,
    /// Its unit.
    pub unit: &'a str,
    /// Component of the state.
    pub index: usize,
}

impl<'a> StateVariable<'a> {
    /// A first-order state at the component `index` of the state.
    #[must_use]
    pub const fn new(name: &'a str, unit: &'a str, index: usize) -> Self {
        Self { name, unit, index }
    }
}

/// Kind of a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum SlotKind {
    /// An angle, in rad.
    Angle,
    /// A length, in m.
    Length,
    /// An orientation: four components of a unit quaternion, scalar first, and three of the angular velocity.
    Quaternion,
}

#[cfg(test)]
mod tests {
    use super::{Slot, SlotKind, StateLayout};

    #[test]
    fn positions_may_outnumber_rates() {
        const LAYOUT: StateLayout = StateLayout::new(&[
            Slot::length("s", 0, 6),
            Slot::new("o", SlotKind::Quaternion, 1..5, 7..10),
            Slot::angle("theta", 5, 10).periodic(),
        ]);
        assert_eq!(LAYOUT.positions(), 6);
        let names = "s o.w o.x o.y o.z theta dot(s) dot(o).x dot(o).y dot(o).z dot(theta)";
        assert_eq!(LAYOUT.components().join(" "), names);
        assert!(LAYOUT.angles().eq([5]) && LAYOUT.quaternions().count() == 1);
        assert_eq!(LAYOUT.quaternions().next(), Some(1..5));
        let units = LAYOUT.slots.iter().map(|slot| (slot.unit(), slot.rate_unit()));
        assert!(units.eq([("m", "m/s"), ("1", "rad/s"), ("rad", "rad/s")]));
    }
}
