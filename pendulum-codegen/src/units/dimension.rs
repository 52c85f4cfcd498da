//! Dimensions: what units measure.

use std::fmt::{Display, Formatter, Result};

use num_rational::Ratio;
use num_traits::{CheckedAdd, CheckedMul, One, Signed, Zero};

/// A power of a base unit. Roots make fractions of them.
pub(crate) type Power = Ratio<i32>;

/// The largest numerator and denominator of a power.
const MOST_POWER: u32 = 1000;

/// A product of powers of the SI base units that mechanics needs. The radian is 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Dimension {
    /// The powers of the base units.
    powers: [Power; 5],
}

const fn whole(n: i32) -> Power {
    Power::new_raw(n, 1)
}

/// The names of the base units, in the order in which they are written.
const BASE: [&str; 5] = ["kg", "m", "s", "A", "K"];

impl Dimension {
    /// That of plain numbers and angles.
    pub(crate) const ONE: Self = Self::new([0; 5]);
    /// That of the time.
    pub(crate) const TIME: Self = Self::new([0, 0, 1, 0, 0]);

    /// The dimension with these powers of m, kg, s, A and K.
    pub(super) const fn new([m, kg, s, a, k]: [i32; 5]) -> Self {
        Self {
            powers: [whole(kg), whole(m), whole(s), whole(a), whole(k)],
        }
    }

    /// Whether it is that of plain numbers and angles.
    pub(crate) fn is_one(self) -> bool {
        self == Self::ONE
    }

    /// `self * other^n`, unless the powers are too large to be meant.
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

    /// Names of units with powers, the positive powers first.
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
            // people think in forces: kg m^2/s^2 is N m, and kg/s is N s/m
            (*kg, *m, *s) = (Power::zero(), *m - one, *s + one + one);
            names.push(("N", one));
        }
        names.extend(BASE.into_iter().zip(powers).filter(|(_, power)| !power.is_zero()));
        names.sort_by_key(|(_, power)| power.is_negative());
        names
    }
}

impl Display for Dimension {
    /// As people write it, and as the language reads it: `N m s`, `kg m^2`, `m/s^2`, `1`.
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
