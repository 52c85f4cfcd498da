//! Unit checks, and help for values in the wrong unit.

use std::f64::consts::TAU;
use std::fmt::Display;

use num_traits::ToPrimitive;

use super::Lower;
use super::expr::Place;
use super::joint_units::JointUnits;
use super::measure::{Measure, Quantity};
use super::scope::Kind;
use super::written::written;
use crate::ast::{self, ExprKind, Measured, Operator};
use crate::error::{Code, Reported};
use crate::expr::{Level, Rational, ratio};
use crate::units::{Dimension, Power, Scale, Unit};

impl<'g> Lower<'g> {
    /// Converts a number with a unit to SI units.
    pub(super) fn measured(
        &mut self,
        e: &ast::Expr,
        Measured { number, unit, .. }: &Measured,
        place: &Place<'g>,
    ) -> Result<Quantity<'g>, Reported> {
        if !self.has_units && !unit.dimension.is_one() {
            let help = "leave out the unit; angles may be in `deg` or `turn`";
            let fact = "there are no units in a scene with `units: none`";
            return Err(self.errors.on(Code::UnitMismatch, e, fact, help));
        }
        for name in unit.names() {
            // a declared name of another dimension than the unit cannot be confused with it
            let of_unit = Unit::dimension_of(name);
            let is_other = |measure| matches!(measure, Measure::Of(own, _) if of_unit.is_some_and(|unit| own != unit));
            if place.most > Level::Constant && self.names.measure(name).is_some_and(|measure| !is_other(measure)) {
                let kind = self.names.kind(name).map_or_else(String::new, Kind::one);
                let fact = format_args!("`{name}` after a number is a unit, but here it is also {kind}");
                let help = format_args!("write a product as `2*{name}`, or rename `{name}` to use the unit");
                return Err(self.errors.on(Code::WrongKind, e, fact, help));
            }
        }
        let Scale { number: scale, pi } = &unit.scale;
        let number = self.graph.number(number * scale);
        Ok(Quantity {
            value: number * self.graph.pi().power(ratio((*pi).into(), 1)),
            measure: Measure::in_dimension(unit.dimension),
        })
    }

    /// Checks that two values have the same dimension; errors say that they cannot be `joined`, for example "added".
    pub(super) fn require_alike(&mut self, [a, b]: [&ast::Expr; 2], [x, y]: [Measure; 2], joined: &str) -> Measure {
        if let Some(measure) = x.alike(y) {
            return measure;
        }
        let fact = format_args!("{} {x}, but {} {y}: they cannot be {joined}", short(a), short(b));
        let help = self.cause(&[a, b]).unwrap_or_else(|| {
            let (number, missing) = match (bare_factor(b), bare_factor(a)) {
                (None, Some(number)) => (Some(number), factor(y, x)),
                (number, _) => (number, factor(x, y)),
            };
            let hint = number.map_or_else(String::new, |number| number.with_unit(missing));
            format!("they differ by a factor in {missing}{hint}")
        });
        self.misfit(b, fact, help);
        Measure::Unknown
    }

    /// Checks that a value has no unit; `what` names it in errors, for example "the argument of `sin`".
    pub(super) fn require_plain(&mut self, e: &ast::Expr, given: Quantity<'g>, what: &str) {
        if given.measure.alike(Measure::ONE).is_some() {
            return;
        }
        let fact = format_args!(
            "{what} must be dimensionless or an angle, but {} {}",
            short(e),
            given.measure
        );
        let help = self.help(e, given.measure, Measure::ONE, None);
        self.misfit(e, fact, help);
    }

    /// Checks that a value has the unit required at a place.
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
            None => self.help(e, given.measure, needed, Some(unit)),
        };
        self.misfit(e, fact, help);
    }

    /// Reports a unit error, unless the scene has no units.
    fn misfit(&mut self, e: &ast::Expr, fact: impl Display, help: String) {
        if self.has_units {
            self.errors.on(Code::UnitMismatch, e, fact, help);
        }
    }

    /// Rejects bare numbers beyond one turn in place of an angle in rad, alone or as terms of a sum: they may be in
    /// degrees.
    pub(super) fn not_degrees(&mut self, e: &ast::Expr, given: Quantity<'g>, what: &str) {
        if let Some(angle) = beyond_a_turn(given) {
            return self.more_than_a_turn(e, angle, what);
        }
        let mut terms = Vec::new();
        gather_terms(e, &mut terms);
        for term in terms {
            let value = match &term.kind {
                ExprKind::Number(_) => self.operation(term, &Place::fixed(what)).ok(),
                ExprKind::Name(name) => self.names.value(&name.to_string()),
                _ => None,
            };
            if let Some(angle) = value.and_then(beyond_a_turn) {
                self.more_than_a_turn(term, angle, &format!("a term of {what}"));
            }
        }
    }

    fn more_than_a_turn(&mut self, e: &ast::Expr, angle: f64, what: &str) {
        let (fact, help) = if self.errors.is_from_file(e) {
            let radians = (angle.to_radians() * 1e4).round() / 1e4;
            let help = format!(
                "write {radians} there for {angle} degrees; if it is {angle} rad, write `{angle} rad` in a `body` \
                 of this name in the scene, which overrides the file"
            );
            (format!("{what} is {angle}, more than a turn: angles are in rad"), help)
        } else {
            let help = format!("write `{angle} deg` for degrees, or `{angle} rad` if radians are meant");
            (format!("{what} is more than a turn: angles are in rad"), help)
        };
        self.errors.on(Code::Degrees, e, fact, help);
    }

    /// Help for a value of the wrong dimension, at a place that requires `unit`.
    fn help(&self, e: &ast::Expr, given: Measure, needed: Measure, unit: Option<&str>) -> String {
        if let Some(cause) = self.cause(&[e]) {
            return cause;
        }
        let [mass, length] = ["kg", "m"].map(Measure::of);
        if [given, needed] == [mass, length] || [given, needed] == [length, mass] {
            return "mass and length may be swapped".to_owned();
        }
        let missing = factor(needed, given);
        match (&e.kind, unit) {
            (ExprKind::Name(name), Some(unit)) if self.has_declared_unit(name) => {
                return format!("declare `{name}: {unit}`, or multiply it by a factor in {missing}");
            }
            (ExprKind::Measured(_), Some(unit)) if given == Measure::ONE => {
                return format!(
                    "write a value in {unit} instead of an angle; a parameter that is an angle is declared in rad"
                );
            }
            _ => {}
        }
        let is_rate = Measure::in_dimension(missing) == Measure::ONE.rate();
        let coefficient = || coefficient(e).filter(|_| unit.is_none() || is_rate);
        if let Some(number) = bare_factor(e).or_else(coefficient) {
            return format!("a factor in {missing} is missing{}", number.with_unit(missing));
        }
        if Measure::in_dimension(factor(given, needed)) == Measure::ONE.rate() {
            return "a factor in s is missing, or there is one `dot` too many".to_owned();
        }
        format!("a factor in {missing} is missing")
    }

    /// True if a name is declared with a unit.
    fn has_declared_unit(&self, name: &syn::Ident) -> bool {
        let kind = self.names.kind(&name.to_string());
        matches!(kind, Some(Kind::Parameter | Kind::Input))
    }

    /// Likely cause of an error: a name after a number parsed as a unit, or a unit after the divisor of a fraction.
    fn cause(&self, given: &[&ast::Expr]) -> Option<String> {
        given.iter().find_map(|e| {
            if let Some((above, Measured { digits, number, unit })) = fraction(e) {
                let (unit, value) = (&unit.text, (above / number).to_f64().unwrap_or(f64::NAN));
                return Some(format!(
                    "`{digits} {unit}` is the divisor: write the fraction as `{value} {unit}`"
                ));
            }
            let Measured { digits, unit, .. } = measured(e, &|unit: &Unit| self.names.kind(&unit.text).is_some())?;
            let name = &unit.text;
            let kind = self.names.kind(name)?;
            Some(format!(
                "`{digits} {name}` is a number with the unit {name}; for the product with the {kind} `{name}` write \
                 `{digits}*{name}`"
            ))
        })
    }
}

/// Value of a bare number, in rad, if it is beyond one turn.
fn beyond_a_turn(given: Quantity<'_>) -> Option<f64> {
    let number = given.value.as_number().and_then(ToPrimitive::to_f64);
    number.filter(|angle| given.measure == Measure::Number && angle.abs() > TAU)
}

/// Collects the terms of a sum.
fn gather_terms<'a>(e: &'a ast::Expr, terms: &mut Vec<&'a ast::Expr>) {
    match &e.kind {
        ExprKind::Neg(a) => gather_terms(a, terms),
        ExprKind::Binary(Operator::Add | Operator::Sub, a, b) => {
            gather_terms(a, terms);
            gather_terms(b, terms);
        }
        _ => terms.push(e),
    }
}

/// Numerator and divisor of a fraction such as `1/2 kg`, where the unit belongs to the divisor.
fn fraction(e: &ast::Expr) -> Option<(&Rational, &Measured)> {
    match &e.kind {
        ExprKind::Binary(Operator::Div, a, b) => match (&a.kind, &b.kind) {
            (ExprKind::Number(above), ExprKind::Measured(below)) => Some((above, below)),
            _ => fraction(a),
        },
        ExprKind::Neg(a) | ExprKind::Binary(Operator::Mul, a, _) => fraction(a),
        _ => None,
    }
}

/// Dimension of the factor that converts a given value to the needed dimension.
fn factor(needed: Measure, given: Measure) -> Dimension {
    factor_of(needed.dimension(), given.dimension())
}

fn factor_of(needed: Dimension, given: Dimension) -> Dimension {
    needed.times(given, Power::from(-1)).unwrap_or(Dimension::ONE)
}

/// A dimension as the unit of a number, which must begin with a name: `rad/s` for `1/s`.
fn after_number(dimension: Dimension) -> String {
    let text = dimension.to_string();
    text.strip_prefix("1/")
        .map_or(text.clone(), |below| format!("rad/{below}"))
}

/// Text of an expression for a message, or "this" if it is long.
fn short(e: &ast::Expr) -> String {
    let text = written(e, None).to_string();
    if text.len() <= 40 {
        format!("`{text}`")
    } else {
        "this".to_owned()
    }
}

/// A bare number among the factors of a product.
struct Bare {
    /// Text, as written.
    text: String,
    /// True if it stands in a divisor.
    below: bool,
    /// True for small integers, which most often are coefficients.
    is_small: bool,
}

impl Bare {
    /// Help for a product that lacks a factor of dimension `missing`.
    fn with_unit(&self, missing: Dimension) -> String {
        let of_number = if self.below {
            factor_of(Dimension::ONE, missing)
        } else {
            missing
        };
        let (text, unit) = (&self.text, after_number(of_number));
        format!("; if {text} has a unit, write it: `{text} {unit}`")
    }
}

/// Bare factor of a product that most likely stands for a quantity: the last one with a decimal point or exponent, else
/// the last one. Small integers are taken as coefficients.
fn bare_factor(e: &ast::Expr) -> Option<Bare> {
    let mut numbers = Vec::new();
    gather(e, false, &mut numbers);
    numbers.retain(|bare| !bare.is_small);
    let decimal = numbers.iter().rposition(|bare| bare.text.contains(['.', 'e']));
    let place = decimal.or(numbers.len().checked_sub(1))?;
    Some(numbers.swap_remove(place))
}

/// The only bare number of a product, small integers included: a quantity where the product must be dimensionless, as
/// in `sin(2*t)`.
fn coefficient(e: &ast::Expr) -> Option<Bare> {
    let mut numbers = Vec::new();
    gather(e, false, &mut numbers);
    numbers.pop().filter(|_| numbers.is_empty())
}

fn gather(e: &ast::Expr, below: bool, numbers: &mut Vec<Bare>) {
    match &e.kind {
        ExprKind::Number(n) => numbers.push(Bare {
            text: e.tokens.to_string(),
            below,
            is_small: n.is_integer() && *n <= ratio(4, 1),
        }),
        ExprKind::Neg(a) => gather(a, below, numbers),
        ExprKind::Call(name, arguments) if name == "clamp" => {
            arguments.iter().take(1).for_each(|a| gather(a, below, numbers));
        }
        ExprKind::Binary(operator @ (Operator::Mul | Operator::Div), a, b) => {
            gather(a, below, numbers);
            gather(b, below ^ (*operator == Operator::Div), numbers);
        }
        _ => {}
    }
}

/// First number whose unit satisfies a predicate.
fn measured<'a>(e: &'a ast::Expr, fits: &impl Fn(&Unit) -> bool) -> Option<&'a Measured> {
    match &e.kind {
        ExprKind::Measured(measured) if fits(&measured.unit) => Some(measured),
        ExprKind::Neg(a) => measured(a, fits),
        ExprKind::Binary(_, a, b) | ExprKind::Power(a, b) => measured(a, fits).or_else(|| measured(b, fits)),
        ExprKind::Call(_, arguments) => arguments.iter().find_map(|a| measured(a, fits)),
        _ => None,
    }
}
