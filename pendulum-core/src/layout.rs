//! What each part of a state is: angle or length, its place in the state, and the symmetries of the system.

use std::error::Error;
use std::fmt;
use std::ops::Range;

use nalgebra::{SVector, Scalar};

/// What each part of a state is, and whether time occurs in the right-hand side.
///
/// [`mechanism!`](crate::mechanism) generates it as the constant `LAYOUT` of a model, and
/// [`System::layout`](crate::System::layout) returns it. The analyses of [`stability`](crate::stability) use it, so
/// systems written by hand should have one where a full turn changes nothing:
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
///     fn layout(&self) -> Option<&'static StateLayout> {
///         const LAYOUT: StateLayout = StateLayout::new(&[Slot::angle("theta", 0, 1).periodic()]).autonomous();
///         Some(&LAYOUT)
///     }
/// }
///
/// let layout = Swing.layout().expect("stated above");
/// assert_eq!((layout.slots[0].name, layout.slots[0].rate_unit()), ("theta", "rad/s"));
/// assert!(layout.autonomous && layout.angles().eq([0]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct StateLayout {
    /// The coordinates with their rates. All positions precede all rates in the state.
    pub slots: &'static [Slot],
    /// Whether the right-hand side is known not to depend on time.
    pub autonomous: bool,
}

impl StateLayout {
    /// The layout of a state in these coordinates. The right-hand side may depend on time.
    #[must_use]
    pub const fn new(slots: &'static [Slot]) -> Self {
        Self {
            slots,
            autonomous: false,
        }
    }

    /// The same layout for a right-hand side that does not depend on time.
    #[must_use]
    pub const fn autonomous(mut self) -> Self {
        self.autonomous = true;
        self
    }

    /// The number of components that are positions; the rates follow them.
    #[must_use]
    pub fn positions(&self) -> usize {
        self.slots.iter().map(|slot| slot.positions.len()).sum()
    }

    /// The names of the components of the state: `theta` is a coordinate, `dot(theta)` its rate, and `o.w`, .. `o.z`
    /// are a quaternion.
    #[must_use]
    pub fn components(&self) -> Vec<String> {
        let mut named: Vec<(usize, String)> = self.slots.iter().flat_map(Slot::components).collect();
        named.sort();
        named.into_iter().map(|(_, name)| name).collect()
    }

    /// The state with these components, from numbers that are known at run time only.
    ///
    /// ```
    /// # use pendulum_core::{Slot, StateLayout};
    /// # use pendulum_core::prelude::*;
    /// const LAYOUT: StateLayout = StateLayout::new(&[Slot::angle("theta", 0, 1)]);
    /// let x: SVector<f64, 2> = LAYOUT.state(&[0.1, 0.0])?;
    /// let error = LAYOUT.state::<f64, 2>(&[0.1]).expect_err("too short");
    /// assert_eq!(error.to_string(), "the state has 2 components, theta and dot(theta), not 1");
    /// # Ok::<(), pendulum_core::WrongLength>(())
    /// ```
    ///
    /// # Errors
    /// If the number of components is not that of the layout, or `N` is not.
    pub fn state<T: Scalar, const N: usize>(&self, components: &[T]) -> Result<SVector<T, N>, WrongLength> {
        let names = self.components();
        match [components.len(), N].into_iter().find(|&length| length != names.len()) {
            Some(given) => Err(WrongLength { given, names }),
            None => Ok(SVector::from_column_slice(components)),
        }
    }

    /// The components of the state that are angles with the period 2 pi, as [`Slot::periodic`] defines it.
    pub fn angles(&self) -> impl Iterator<Item = usize> {
        self.slots
            .iter()
            .filter(|slot| slot.periodic)
            .flat_map(|slot| slot.positions.clone())
    }
}

/// A coordinate: its place in the state, and its symmetries.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct Slot {
    /// The name of the coordinate.
    pub name: &'static str,
    /// What it measures.
    pub kind: SlotKind,
    /// The components of the state that hold its position.
    pub positions: Range<usize>,
    /// The components of the state that hold its rate. There may be fewer of them than positions.
    pub rates: Range<usize>,
    /// Whether a full turn, 2 pi, is known to leave everything as it was: each body is in its place again, and the
    /// right-hand side is the same.
    ///
    /// A helical joint with a pitch moves its body on, and a torsion spring counts turns: neither has a periodic
    /// coordinate.
    pub periodic: bool,
    /// Whether the right-hand side is known not to depend on the position at all, as on the place of a cart on a level
    /// track.
    pub cyclic: bool,
}

impl Slot {
    /// A coordinate at the components `positions` of the state, with its rate at `rates`. No symmetry is assumed.
    #[must_use]
    pub const fn new(name: &'static str, kind: SlotKind, positions: Range<usize>, rates: Range<usize>) -> Self {
        Self {
            name,
            kind,
            positions,
            rates,
            periodic: false,
            cyclic: false,
        }
    }

    /// An angle at the component `position` of the state, with its rate at `rate`. Not every angle is
    /// [`periodic`](Self::periodic).
    #[must_use]
    pub const fn angle(name: &'static str, position: usize, rate: usize) -> Self {
        Self::new(name, SlotKind::Angle, position..position + 1, rate..rate + 1)
    }

    /// A length at the component `position` of the state, with its rate at `rate`.
    #[must_use]
    pub const fn length(name: &'static str, position: usize, rate: usize) -> Self {
        Self::new(name, SlotKind::Length, position..position + 1, rate..rate + 1)
    }

    /// The same coordinate, of which a full turn leaves everything as it was.
    #[must_use]
    pub const fn periodic(mut self) -> Self {
        self.periodic = true;
        self
    }

    /// The same coordinate, on which the right-hand side does not depend.
    #[must_use]
    pub const fn cyclic(mut self) -> Self {
        self.cyclic = true;
        self
    }

    /// The names of its components with their places in the state.
    fn components(&self) -> impl Iterator<Item = (usize, String)> {
        let name = |stem: String, range: &Range<usize>| {
            let parts: &[&str] = match range.len() {
                3 => &[".x", ".y", ".z"],
                4 => &[".w", ".x", ".y", ".z"],
                _ => &[],
            };
            let named = range.clone().enumerate();
            named.map(move |(n, place)| (place, format!("{stem}{}", parts.get(n).unwrap_or(&""))))
        };
        let rate = format!("dot({})", self.name);
        name(self.name.to_owned(), &self.positions).chain(name(rate, &self.rates))
    }

    /// The unit of its position.
    #[must_use]
    pub const fn unit(&self) -> &'static str {
        match self.kind {
            SlotKind::Angle => "rad",
            SlotKind::Length => "m",
            SlotKind::Quaternion => "1",
        }
    }

    /// The unit of its rate.
    #[must_use]
    pub const fn rate_unit(&self) -> &'static str {
        match self.kind {
            SlotKind::Angle | SlotKind::Quaternion => "rad/s",
            SlotKind::Length => "m/s",
        }
    }
}

/// What a coordinate measures.
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

/// Numbers that are too few or too many for a state.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct WrongLength {
    /// How many were given.
    pub given: usize,
    /// The names of the components that the state has.
    pub names: Vec<String>,
}

impl fmt::Display for WrongLength {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { given, names } = self;
        write!(f, "the state has {} components, ", names.len())?;
        if let [first @ .., last] = &names[..] {
            write!(f, "{} and {last}, ", first.join(", "))?;
        }
        write!(f, "not {given}")
    }
}

impl Error for WrongLength {}

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
        assert!(LAYOUT.angles().eq([5]));
        let units = LAYOUT.slots.iter().map(|slot| (slot.unit(), slot.rate_unit()));
        assert!(units.eq([("m", "m/s"), ("1", "rad/s"), ("rad", "rad/s")]));
    }
}
