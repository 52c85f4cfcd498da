//! Names of the components of a state.

use std::error::Error;
use std::fmt;
use std::ops::Range;

use nalgebra::{SVector, Scalar};

use super::{Slot, StateLayout};

impl StateLayout<'_> {
    /// Returns the names of the components of the state. `theta` is a coordinate, `dot(theta)` its rate, and `o.w`, ..
    /// `o.z` are a quaternion.
    #[must_use]
    pub fn components(&self) -> Vec<String> {
        let mut named: Vec<(usize, String)> = self.slots.iter().flat_map(Slot::components).collect();
        named.extend(self.states.iter().map(|state| (state.index, state.name.to_owned())));
        named.sort();
        named.into_iter().map(|(_, name)| name).collect()
    }

    /// Builds a state from a slice whose length is known only at run time.
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
    /// If `components.len()` or `N` differs from the number of components of the layout.
    pub fn state<T: Scalar, const N: usize>(&self, components: &[T]) -> Result<SVector<T, N>, WrongLength> {
        let names = self.components();
        match [components.len(), N].into_iter().find(|&length| length != names.len()) {
            Some(given) => Err(WrongLength { given, names }),
            None => Ok(SVector::from_column_slice(components)),
        }
    }
}

impl Slot<'_> {
    /// Names of the components, with their places in the state.
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
}

/// A slice of the wrong length for a state.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct WrongLength {
    /// Number of components passed.
    pub given: usize,
    /// Names of the components of the state.
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
