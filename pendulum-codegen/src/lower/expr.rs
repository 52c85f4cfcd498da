//! Lowering of expressions of the language to expressions of the graph.

use std::borrow::Cow;

use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive, Zero};
use proc_macro2::Span;

use super::Lower;
use super::measure::{Measure, Quantity};
use crate::ast::{self, ExprKind, Operator, Vector};
use crate::error::{Code, Reported};
use crate::expr::{Expr, Level, MOST_POWER, Rational, Symbol, SymbolKind, ratio};
use crate::screw::Vec3;
use crate::units::Power;

/// Context of an expression: its name in errors, and the symbols that it may contain.
#[derive(Clone, Debug)]
pub(super) struct Place<'g> {
    /// Name in errors: ``the torque of `arm` ``.
    pub(super) what: String,
    /// Highest level of expressions allowed.
    pub(super) most: Level,
    /// Kinds of varying symbols allowed.
    pub(super) only: Only,
    /// Coordinate and rate of the joint, if `q` and `qd` are allowed.
    pub(super) joint: Option<[Quantity<'g>; 2]>,
    /// Required unit, if there is one.
    pub(super) unit: Option<Cow<'static, str>>,
}

/// Kinds of varying symbols allowed at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Only {
    /// All kinds.
    All,
    /// All kinds except inputs.
    State,
    /// Coordinates, points, first-order states and the time.
    Positions,
    /// Coordinates, points and the time, in the gap of a wall.
    Gap,
    /// The time or coordinates, in the motion of a joint.
    Motion,
}

impl Only {
    fn allows(self, kind: SymbolKind) -> bool {
        match kind {
            SymbolKind::Input(_) => self == Self::All,
            SymbolKind::Rate(_) | SymbolKind::PointRate(_) => matches!(self, Self::All | Self::State),
            SymbolKind::State(_) => !matches!(self, Self::Gap | Self::Motion),
            SymbolKind::Point(_) | SymbolKind::Dependent(_) => self != Self::Motion,
            _ => true,
        }
    }

    /// Help for a symbol that is not allowed.
    fn help(self) -> &'static str {
        match self {
            Self::All | Self::State => "inputs are known only at run time: add this term where the model is used",
            Self::Positions => {
                "build it from coordinates, points, the time and parameters; a force that depends on rates or \
                 inputs is `force theta: e`, and a loss is `dissipation: e`"
            }
            Self::Gap => "a gap depends on positions: build it from coordinates, points, the time and parameters",
            Self::Motion => {
                "build it from `t` and parameters for a prescribed motion, or from coordinates of other joints; a \
                 joint that moves by itself has a `coordinate`"
            }
        }
    }
}

impl Place<'_> {
    /// A place for numbers and parameters.
    pub(super) fn fixed(what: impl Into<String>) -> Self {
        Self {
            what: what.into(),
            most: Level::Parameter,
            only: Only::All,
            joint: None,
            unit: None,
        }
    }

    /// A place for any expression.
    pub(super) fn moving(what: impl Into<String>) -> Self {
        Self {
            most: Level::State,
            ..Self::fixed(what)
        }
    }

    /// The place with a required unit; none for any unit.
    pub(super) fn in_unit(self, unit: impl Into<Option<&'static str>>) -> Self {
        Self {
            unit: unit.into().map(Cow::Borrowed),
            ..self
        }
    }
}

/// Maximum depth of nested operations, including those of each `let`: later stages are recursive.
const MOST_DEPTH: usize = 1000;

impl<'g> Lower<'g> {
    /// Lowers an expression.
    pub(super) fn expr(&mut self, expr: &ast::Expr, place: &Place<'g>) -> Result<Expr<'g>, Reported> {
        self.quantity(expr, place).map(|quantity| quantity.value)
    }

    /// Lowers an expression, and determines its measure.
    pub(super) fn quantity(&mut self, expr: &ast::Expr, place: &Place<'g>) -> Result<Quantity<'g>, Reported> {
        let quantity = self.operation(expr, place)?;
        let value = quantity.value;
        if value.depth() > MOST_DEPTH {
            let fact = format_args!("{} has more than {MOST_DEPTH} nested operations", place.what);
            let help = "write it with fewer nested `let`s";
            return Err(self.errors.on(Code::TooLong, expr, fact, help));
        }
        if value.level() > place.most {
            let symbols = self.graph.reachable(&[value]).into_iter().map(|id| self.graph.expr(id));
            let mut symbols = symbols.filter(|x| x.level() > place.most).filter_map(Expr::as_symbol);
            let on = symbols
                .next()
                .map_or("the motion".to_owned(), |symbol| format!("`{}`", symbol.name));
            let help = if place.joint.is_some() {
                "give the coefficient of viscous friction here, and write any other law as `torque: ..`"
            } else {
                "build it from numbers and parameters: it is computed once, when the model is built"
            };
            let fact = format_args!("{} may not depend on {on}", place.what);
            return Err(self.errors.on(Code::Dependence, expr, fact, help));
        }
        let double = value.constant();
        let vanishes = double == Some(0.0) && value.as_number().is_some() && !value.is_zero();
        if vanishes || double.is_some_and(|value| !value.is_finite()) {
            let fact = format_args!("{} is out of range in double precision", place.what);
            let help = "its magnitude must lie between 1e-300 and 1e300";
            return Err(self.errors.on(Code::NumberRange, expr, fact, help));
        }
        self.fits(expr, quantity, place);
        Ok(quantity)
    }

    /// Lowers three expressions.
    pub(super) fn vector(&mut self, vector: &Vector, place: &Place<'g>) -> Result<Vec3<'g>, Reported> {
        let [x, y, z] = vector.components.each_ref().map(|e| self.expr(e, place));
        Ok(Vec3([x?, y?, z?]))
    }

    /// Lowers an operation. A constant value must be finite.
    pub(super) fn operation(&mut self, expr: &ast::Expr, place: &Place<'g>) -> Result<Quantity<'g>, Reported> {
        let quantity = self.unchecked(expr, place)?;
        let value = quantity.value;
        if value.as_number().is_none() && value.constant().is_some_and(|value| !value.is_finite()) {
            let help = "check for a division by zero, or a root or logarithm of a negative number";
            let fact = format_args!("a part of {} is not finite", place.what);
            return Err(self.errors.on(Code::Undefined, expr, fact, help));
        }
        Ok(quantity)
    }

    fn unchecked(&mut self, expr: &ast::Expr, place: &Place<'g>) -> Result<Quantity<'g>, Reported> {
        match &expr.kind {
            ExprKind::Number(n) => Ok(Quantity {
                value: self.graph.number(n.clone()),
                measure: Measure::Number,
            }),
            ExprKind::Measured(measured) => self.measured(expr, measured, place),
            ExprKind::Name(name) => {
                let quantity = self.name(name, place)?;
                self.permit(quantity.value, name.span(), place)?;
                Ok(quantity)
            }
            ExprKind::Component(point, axis) => self.component(point, axis, place),
            ExprKind::RateComponent(name, axis) => self.rate_component(name, axis, place),
            ExprKind::Call(name, arguments) => self.call(expr, name, arguments, place),
            ExprKind::Neg(a) => {
                let Quantity { value, measure } = self.operation(a, place)?;
                Ok(Quantity { value: -value, measure })
            }
            ExprKind::Binary(operator, a, b) => self.binary(*operator, a, b, place),
            ExprKind::Power(base, exponent) => self.power(expr, base, exponent, place),
        }
    }

    /// Lowers a sum, a difference, a product or a quotient.
    fn binary(
        &mut self,
        operator: Operator,
        a: &ast::Expr,
        b: &ast::Expr,
        place: &Place<'g>,
    ) -> Result<Quantity<'g>, Reported> {
        let left = self.operation(a, place);
        let right = match self.rest_of_unit(operator, a, b, place) {
            Some(reported) => Err(reported),
            None => self.operation(b, place),
        };
        let (left, right) = (left?, right?);
        let ([x, y], measures) = ([left.value, right.value], [left.measure, right.measure]);
        if operator == Operator::Div && y.is_zero() {
            let fact = format_args!("division by zero in {}", place.what);
            return Err(self.errors.on(Code::Undefined, b, fact, "the divisor must not be 0"));
        }
        let (measure, value) = match operator {
            Operator::Add => (self.require_alike([a, b], measures, "added"), x + y),
            Operator::Sub => (self.require_alike([a, b], measures, "subtracted"), x - y),
            Operator::Mul => (left.measure.times(right.measure, Power::one()), x * y),
            Operator::Div => (left.measure.times(right.measure, -Power::one()), x / y),
        };
        Ok(Quantity { value, measure })
    }

    /// Lowers a power whose exponent is a number.
    fn power(
        &mut self,
        expr: &ast::Expr,
        base: &ast::Expr,
        exponent: &ast::Expr,
        place: &Place<'g>,
    ) -> Result<Quantity<'g>, Reported> {
        let (x, n) = (self.operation(base, place), self.operation(exponent, place));
        let (Quantity { value: x, measure }, given) = (x?, n?);
        let n = self.exponent(exponent, given.value, place)?;
        self.require_plain(exponent, given, "a power");
        if x.is_zero() && !n.is_positive() && !n.is_zero() {
            let fact = format_args!("division by zero in {}", place.what);
            return Err(self
                .errors
                .on(Code::Undefined, expr, fact, "zero has no negative power"));
        }
        if !n.is_integer() {
            let less = n - ratio(1, 1);
            let instead = |x: &str| format!("`abs({x})^({n})`, or `{x}*abs({x})^({less})` to keep its sign");
            self.never_negative(base, x, "a fractional power", instead)?;
        }
        let power = n.numer().to_i32().zip(n.denom().to_i32());
        let power = power.map_or(Power::one(), |(numerator, denominator)| {
            Power::new(numerator, denominator)
        });
        Ok(Quantity {
            value: x.power(n.clone()),
            measure: measure.power(power),
        })
    }

    /// Rejects varying symbols that are not allowed at a place.
    pub(super) fn permit(&mut self, value: Expr<'g>, span: Span, place: &Place<'g>) -> Result<Expr<'g>, Reported> {
        if place.only == Only::All || place.most < Level::State || value.level() < Level::State {
            return Ok(value);
        }
        let mut symbols = self.graph.symbols_of(&[value]);
        match symbols.find(|symbol| !place.only.allows(symbol.kind)) {
            None => Ok(value),
            Some(symbol) => {
                let fact = format_args!("{} may not depend on `{}`", place.what, symbol.name);
                Err(self.errors.at(Code::Dependence, span, fact, place.only.help()))
            }
        }
    }

    /// Value of an exponent, which must be a small rational number.
    fn exponent(&mut self, given: &ast::Expr, value: Expr<'g>, place: &Place<'g>) -> Result<&'g Rational, Reported> {
        let Some(n) = value.as_number() else {
            let help = "write an integer or a fraction, such as `x^2` or `x^(1/2)`; `exp(b*ln(a))` is a to the power b";
            let fact = format_args!("an exponent in {} is not a number", place.what);
            return Err(self.errors.on(Code::Exponent, given, fact, help));
        };
        let small = |n: &BigInt| n.abs().to_i64().is_some_and(|n| n <= MOST_POWER);
        if small(n.numer()) && small(n.denom()) {
            return Ok(n);
        }
        let fact = format_args!("an exponent in {} is {n}", place.what);
        let help = format_args!(
            "its numerator and denominator must be at most {MOST_POWER}; `exp(b*ln(a))` is a to the power b"
        );
        Err(self.errors.on(Code::Exponent, given, fact, help))
    }

    /// Rejects a coordinate or a rate as the argument of a function that is undefined for negative numbers.
    pub(super) fn never_negative(
        &mut self,
        given: &ast::Expr,
        value: Expr<'g>,
        what: &str,
        instead: impl Fn(&str) -> String,
    ) -> Result<(), Reported> {
        let Some(Symbol {
            name: x,
            kind: SymbolKind::Coordinate(_) | SymbolKind::Rate(_) | SymbolKind::Point(_) | SymbolKind::PointRate(_),
        }) = value.as_symbol()
        else {
            return Ok(());
        };
        let fact = format_args!("{what} is undefined where `{x}` is negative");
        let help = format!("write {}", instead(x));
        Err(self.errors.on(Code::Undefined, given, fact, help))
    }
}
