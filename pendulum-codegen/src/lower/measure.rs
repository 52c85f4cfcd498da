//! What values are measured in, and that it is what is needed.

use std::f64::consts::TAU;
use std::fmt::Display;

use num_traits::ToPrimitive;

use super::Lower;
use super::expr::Place;
use super::joint_units::JointUnits;
use super::scope::Kind;
use super::written::{digits, written};
use crate::ast::{self, ExprKind, Operator};
use crate::error::Reported;
use crate::expr::{Expr, Level, Rational, ratio};
use crate::units::{Dimension, Power, Scale, Unit};

/// A value, and what it is measured in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quantity<'g> {
    pub(super) value: Expr<'g>,
    pub(super) measure: Measure,
}

/// What a value is measured in, as far as its expression says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Measure {
    /// Numbers alone: they stand for any quantity, in SI units.
    Number,
    /// A number times what has no unit, such as `0.3*sin(theta)`: the number may stand for any quantity.
    Scaled,
    /// A dimension.
    Of(Dimension),
    /// It is not known, after an error.
    Unknown,
}

impl Measure {
    /// Plain numbers and angles.
    pub(super) const ONE: Self = Self::Of(Dimension::ONE);

    /// What a unit measures, by its name in the language.
    pub(super) fn of(unit: &str) -> Self {
        Unit::of(unit).map_or(Self::Unknown, |unit| Self::Of(unit.dimension))
    }

    /// That of `self * other^n`.
    pub(super) fn times(self, other: Self, n: Power) -> Self {
        match (self, other) {
            (Self::Unknown, _) | (_, Self::Unknown) => Self::Unknown,
            (Self::Number, Self::Number) => Self::Number,
            (a, b) => match a.dimension().times(b.dimension(), n) {
                None => Self::Unknown,
                // a number makes a plain value one that may be anything, and another dimension leaves it a number
                Some(product) if product.is_one() && (a.is_open() || b.is_open()) => Self::Scaled,
                Some(product) => Self::Of(product),
            },
        }
    }

    /// That of the rate.
    pub(super) fn rate(self) -> Self {
        match self {
            Self::Number | Self::Scaled => Self::Scaled,
            known => known.times(Self::Of(Dimension::TIME), Power::from(-1)),
        }
    }

    /// That of a power.
    pub(super) fn power(self, n: Power) -> Self {
        match self {
            Self::Of(_) => Self::ONE.times(self, n),
            open => open,
        }
    }

    /// That of two values that must be alike; none where they are not.
    pub(super) fn alike(self, other: Self) -> Option<Self> {
        match (self, other) {
            (Self::Unknown, _) | (_, Self::Unknown) => Some(Self::Unknown),
            (Self::Number, known) | (known, Self::Number) => Some(known),
            (Self::Scaled, Self::Of(one)) | (Self::Of(one), Self::Scaled) if one.is_one() => Some(Self::Of(one)),
            (a, b) => (a == b).then_some(a),
        }
    }

    /// Whether it takes the unit that is needed.
    fn is_open(self) -> bool {
        matches!(self, Self::Number | Self::Scaled)
    }

    /// Its dimension, where numbers count as plain.
    fn dimension(self) -> Dimension {
        match self {
            Self::Of(dimension) => dimension,
            _ => Dimension::ONE,
        }
    }
}

impl Display for Measure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let dimension = self.dimension();
        if dimension.is_one() {
            f.write_str("has no unit")
        } else {
            write!(f, "is in {dimension}")
        }
    }
}

impl<'g> Lower<'g> {
    /// A number with a unit, in SI units.
    pub(super) fn measured(
        &mut self,
        e: &ast::Expr,
        number: &Rational,
        unit: &Unit,
        place: &Place<'g>,
    ) -> Result<Quantity<'g>, Reported> {
        for name in unit.text.split(|c: char| !c.is_ascii_alphabetic()) {
            // names of another dimension are told apart where the value is used
            let own = Unit::any(name).map(|unit| Measure::Of(unit.dimension));
            if place.most > Level::Constant && own.is_some() && self.names.measure(name) == own {
                let kind = self.names.kind(name).map_or_else(String::new, Kind::one);
                let fact = format_args!("`{name}` after a number is a unit, but it is also {kind} of that unit");
                let help = format_args!("write a product as `2*{name}`, or rename `{name}` to use the unit");
                return Err(self.errors.on(e, fact, help));
            }
        }
        let Scale { number: scale, pi } = &unit.scale;
        let number = self.graph.number(number * scale);
        Ok(Quantity {
            value: number * self.graph.pi().power(ratio((*pi).into(), 1)),
            measure: Measure::Of(unit.dimension),
        })
    }

    /// Requires that two values are alike, which are `joined`, as in "they cannot be added".
    pub(super) fn alike(&mut self, [a, b]: [&ast::Expr; 2], [x, y]: [Measure; 2], joined: &str) -> Measure {
        if let Some(measure) = x.alike(y) {
            return measure;
        }
        let fact = format_args!("{} {x}, but {} {y}: they cannot be {joined}", short(a), short(b));
        let help = self.cause(&[a, b]).unwrap_or_else(|| {
            let scaled = if y == Measure::Scaled { (b, x) } else { (a, y) };
            let number = bare_factor(scaled.0).filter(|_| [x, y].contains(&Measure::Scaled));
            match number {
                Some(number) => format!("give the number its unit: `{number} {}`", scaled.1.dimension()),
                None => format!("they differ by a factor in {}", factor(x, y)),
            }
        });
        self.misfit(b, fact, help);
        Measure::Unknown
    }

    /// Requires that a value has no unit, because of what it is: "the argument of `sin`".
    pub(super) fn plain(&mut self, e: &ast::Expr, given: Quantity<'g>, what: &str) {
        if given.measure.alike(Measure::ONE).is_some() {
            return;
        }
        let fact = format_args!(
            "{what} must be an angle or a plain number, but {} {}",
            short(e),
            given.measure
        );
        let help = self.help(e, given.measure, Measure::ONE);
        self.misfit(e, fact, help);
    }

    /// Requires the unit of a place.
    pub(super) fn fits(&mut self, e: &ast::Expr, given: Quantity<'g>, place: &Place<'g>) {
        let Some(unit) = &place.unit else { return };
        if unit == "rad" {
            self.not_degrees(e, given, &place.what);
        }
        let needed = Measure::of(unit);
        if given.measure.is_open() || given.measure.alike(needed).is_some() {
            return;
        }
        let fact = format_args!("{} is in {unit}, but {} {}", place.what, short(e), given.measure);
        let other = JointUnits::other(unit).filter(|(other, _)| given.measure == Measure::of(other));
        let help = match other {
            Some((other, way)) => format!("{other} belongs to joints that {way}"),
            None => self.help(e, given.measure, needed),
        };
        self.misfit(e, fact, help);
    }

    /// Notes an error of units, in a scene that has any.
    fn misfit(&mut self, e: &ast::Expr, fact: impl Display, help: String) {
        if self.has_units {
            self.errors.on(e, fact, help);
        }
    }

    /// Refuses a bare number of radians that is more than a turn, since it may be in degrees.
    pub(super) fn not_degrees(&mut self, e: &ast::Expr, given: Quantity<'g>, what: &str) {
        let number = given.value.as_number().and_then(ToPrimitive::to_f64);
        if let (Measure::Number, Some(angle)) = (given.measure, number.filter(|angle| angle.abs() > TAU)) {
            let fact = format_args!("{what} is more than a turn: angles are in rad");
            let help = format_args!("write `{angle} deg` for degrees, or `{angle} rad` if it is meant");
            self.errors.on(e, fact, help);
        }
    }

    /// What to do about a value that is measured in something else than is needed.
    fn help(&self, e: &ast::Expr, given: Measure, needed: Measure) -> String {
        if let Some(cause) = self.cause(&[e]) {
            return cause;
        }
        let [mass, length] = ["kg", "m"].map(Measure::of);
        if [given, needed] == [mass, length] || [given, needed] == [length, mass] {
            return "mass and length may be swapped".to_owned();
        }
        let missing = factor(needed, given);
        if Measure::Of(factor(given, needed)) == Measure::ONE.rate() {
            return "a factor in s is missing, or a `dot` is too many".to_owned();
        }
        match bare_factor(e) {
            Some(number) => format!(
                "if the number stands for a quantity, give it its unit: `{number} {}`; \
                 else a factor in {missing} is missing",
                after_number(missing)
            ),
            None => format!("a factor in {missing} is missing"),
        }
    }

    /// The likely cause: a name after a number that was read as a unit.
    fn cause(&self, given: &[&ast::Expr]) -> Option<String> {
        given.iter().find_map(|e| {
            let (number, unit) = measured(e, &|unit: &Unit| self.names.kind(&unit.text).is_some())?;
            let name = &unit.text;
            let kind = self.names.kind(name)?;
            Some(format!(
                "`{number} {name}` has the unit {name}; its product with the {kind} `{name}` is `{number}*{name}`"
            ))
        })
    }
}

/// What one value must be multiplied by to become like another.
fn factor(needed: Measure, given: Measure) -> Dimension {
    let factor = needed.dimension().times(given.dimension(), Power::from(-1));
    factor.unwrap_or(Dimension::ONE)
}

/// A dimension as the unit of a number, which begins with a name: `rad/s` for `1/s`.
fn after_number(dimension: Dimension) -> String {
    let text = dimension.to_string();
    text.strip_prefix("1/")
        .map_or(text.clone(), |below| format!("rad/{below}"))
}

/// An expression in a message: its text where that is short.
fn short(e: &ast::Expr) -> String {
    let text = written(e, None).to_string();
    if text.len() <= 40 {
        format!("`{text}`")
    } else {
        "this".to_owned()
    }
}

/// The first bare number among the factors of a product, as it is written.
fn bare_factor(e: &ast::Expr) -> Option<String> {
    match &e.kind {
        ExprKind::Number(_) => Some(e.tokens.to_string()),
        ExprKind::Neg(a) => bare_factor(a),
        ExprKind::Binary(Operator::Mul, a, b) => bare_factor(a).or_else(|| bare_factor(b)),
        ExprKind::Binary(Operator::Div, a, _) => bare_factor(a),
        _ => None,
    }
}

/// The first number with a unit that fits, as text, and the unit.
fn measured<'a>(e: &'a ast::Expr, fits: &impl Fn(&Unit) -> bool) -> Option<(String, &'a Unit)> {
    match &e.kind {
        ExprKind::Measured(_, unit) if fits(unit) => Some((digits(e), unit)),
        ExprKind::Neg(a) => measured(a, fits),
        ExprKind::Binary(_, a, b) | ExprKind::Power(a, b) => measured(a, fits).or_else(|| measured(b, fits)),
        ExprKind::Call(_, arguments) => arguments.iter().find_map(|a| measured(a, fits)),
        _ => None,
    }
}
