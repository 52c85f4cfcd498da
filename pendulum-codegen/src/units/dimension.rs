//! Physical dimensions of units.

use std::fmt::{Display, Formatter, Result};

use num_rational::Ratio;
use num_traits::{CheckedAdd, CheckedMul, One, Signed, Zero};

/// Power of a base unit, which is a fraction under a root.
pub(crate) type Power = Ratio<i32>;

/// Maximum numerator and denominator of a power.
const MOST_POWER: u32 = 1000;

/// Product of powers of the SI base units that mechanics needs. The radian has dimension 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Dimension {
    /// Powers of the base units, in the order of `BASE`.
    powers: [Power; 5],
}

const fn whole(n: i32) -> Power {
    Power::new_raw(n, 1)
}

/// Names of the base units, in the order of printing.
const BASE: [&str; 5] = ["kg", "m", "s", "A", "K"];

impl Dimension {
    /// Dimension of plain numbers and angles.
    pub(crate) const ONE: Self = Self::new([0; 5]);
    /// Dimension of time.
    pub(crate) const TIME: Self = Self::new([0, 0, 1, 0, 0]);

    /// Returns the dimension with the given powers of m, kg, s, A and K.
    pub(super) const fn new([m, kg, s, a, k]: [i32; 5]) -> Self {
        Self {
            powers: [whole(kg), whole(m), whole(s), whole(a), whole(k)],
        }
    }

    /// True for plain numbers and angles.
    pub(crate) fn is_one(self) -> bool {
        self == Self::ONE
    }

    /// Returns `self * other^n`, or `None` if a power is too large to be intended.
    pub(crate) fn times(self, other: Self, n: Power) -> Option<Self> {
        let mut powers = self.powers;
        for (power, more) in powers.iter_mut().zip(other.powers) {
            *power = power.checked_add(&more.checked_mul(&n)?)?;
            if power.numer().unsigned_abs() > MOST_POWER || power.denom().unsigned_abs() > MOST_POWER {
                return None;
            }
        }
        Some(Self { powers })
    }

    /// Iterates over the base units that occur, with their powers.
    pub(crate) fn powers(self) -> impl Iterator<Item = (&'static str, Power)> {
        BASE.into_iter().zip(self.powers).filter(|(_, power)| !power.is_zero())
    }

    /// Returns the names of units with their powers, positive powers first.
    fn names(self) -> Vec<(&'static str, Power)> {
        let one = Power::one();
        if self == Self::new([2, 1, -3, 0, 0]) {
            return vec![("W", one)];
        }
        let mut powers = self.powers;
        let mut names = Vec::new();
        if let [kg, m, s, ..] = &mut powers
            && kg.is_one()
            && *s <= -one
        {
            // forces are the usual notation: kg m^2/s^2 is N m, and kg/s is N s/m
            (*kg, *m, *s) = (Power::zero(), *m - one, *s + one + one);
            names.push(("N", one));
        }
        names.extend(BASE.into_iter().zip(powers).filter(|(_, power)| !power.is_zero()));
        names.sort_by_key(|(_, power)| power.is_negative());
        names
    }
}

impl Display for Dimension {
    /// Writes the usual notation, in the syntax of the language: `N m s`, `kg m^2`, `m/s^2`, `1`.
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let names = self.names();
        if names.first().is_none_or(|(_, power)| power.is_negative()) {
            f.write_str("1")?;
        }
        for (n, (name, power)) in names.into_iter().enumerate() {
            let before = match (n, power.is_negative()) {
                (_, true) => "/",
                (0, false) => "",
                (_, false) => " ",
            };
            write!(f, "{before}{name}")?;
            match power.abs() {
                power if power.is_one() => {}
                power if power.is_integer() => write!(f, "^{power}")?,
                power => write!(f, "^({power})")?,
            }
        }
        Ok(())
    }
}
