//! Units of measure: names, dimensions and syntax.

mod dimension;
mod names;
mod parse;

use num_traits::{One, Pow};

pub(crate) use dimension::{Dimension, Power};
pub(crate) use parse::{help_after_number, help_in_product};

use crate::expr::{Rational, ratio};

/// A unit as written, with its meaning.
#[derive(Clone, Debug)]
pub(crate) struct Unit {
    /// Source text, as shown in the documentation of the field.
    pub text: String,
    /// Physical dimension.
    pub dimension: Dimension,
    /// Factor to the SI unit of this dimension.
    pub scale: Scale,
}

/// `number * pi^power`
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Scale {
    pub number: Rational,
    /// Power of pi.
    pub pi: i32,
}

impl Unit {
    /// Returns the unit that a text denotes.
    pub(crate) fn of(text: &str) -> Option<Self> {
        syn::parse_str(text).ok()
    }

    /// Text of the unit of a rate of change.
    pub(crate) fn rate(&self) -> String {
        let rate = self.dimension.times(Dimension::TIME, -Power::one());
        match rate.filter(|_| self.text.contains('/')) {
            Some(rate) => rate.to_string(),
            None => format!("{}/s", self.text),
        }
    }

    /// Iterates over the names in the unit, without their powers.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        let words = self.text.split(|c: char| !c.is_ascii_alphabetic());
        words.filter(|word| !word.is_empty())
    }

    /// Returns the dimension of a name that may follow a number.
    pub(crate) fn dimension_of(name: &str) -> Option<Dimension> {
        names::meaning(name).map(|(dimension, _)| dimension)
    }

    /// True if a word is the name of a unit that may follow a number.
    pub(crate) fn is_name(word: &str) -> bool {
        names::dimension(word).is_some() || names::other(word).is_some()
    }
}

impl Default for Unit {
    /// Returns the unit of plain numbers.
    fn default() -> Self {
        Self {
            text: "1".to_owned(),
            dimension: Dimension::ONE,
            scale: Scale::new([1, 1, 0]),
        }
    }
}

impl Scale {
    fn new([numerator, denominator, pi]: [i64; 3]) -> Self {
        Self {
            number: ratio(numerator, denominator),
            pi: i32::try_from(pi).unwrap_or_default(),
        }
    }

    /// True for SI units.
    pub(crate) fn is_one(&self) -> bool {
        self.number.is_one() && self.pi == 0
    }

    fn times(&mut self, other: &Self, power: i32) {
        self.number *= Pow::pow(&other.number, power);
        self.pi += power * other.pi;
    }
}
