//! Expressions of the language to expressions of the graph.

use num_traits::{Signed, ToPrimitive, Zero};
use syn::Ident;

use super::Lower;
use crate::ast::{self, ExprKind, Operator, Vector};
use crate::error::{Reported, suggestion};
use crate::expr::{Binary, Expr, Level, Unary};
use crate::screw::Vec3;

/// Where an expression stands: what it may use, and how errors speak of it.
#[derive(Clone, Debug)]
pub(super) struct Place<'g> {
    /// `the torque of `arm``
    pub(super) what: String,
    /// On what it may depend.
    pub(super) most: Level,
    /// The coordinate and the rate of the joint, where `q` and `qd` may stand.
    pub(super) joint: Option<(Expr<'g>, Expr<'g>)>,
}

impl Place<'_> {
    /// A place for numbers and parameters.
    pub(super) fn fixed(what: impl Into<String>) -> Self {
        Self {
            what: what.into(),
            most: Level::Parameter,
            joint: None,
        }
    }
}

const FUNCTIONS: [(&str, Unary); 7] = [
    ("sin", Unary::Sin),
    ("cos", Unary::Cos),
    ("tan", Unary::Tan),
    ("exp", Unary::Exp),
    ("ln", Unary::Ln),
    ("tanh", Unary::Tanh),
    ("abs", Unary::Abs),
];

/// The largest numerator and denominator of a constant power.
const MOST_POWER: i64 = 64;

impl<'g> Lower<'g> {
    /// The expression at a place.
    pub(super) fn expr(&mut self, expr: &ast::Expr, place: &Place<'g>) -> Result<Expr<'g>, Reported> {
        let value = self.operation(expr, place)?;
        if value.level() > place.most {
            let help = if place.joint.is_some() {
                "give the coefficient of viscous friction here, and any other law as `torque: ..`"
            } else {
                "build it from numbers and parameters: it is computed once, when the model is built"
            };
            return Err(self
                .errors
                .on(expr, format_args!("{} may not depend on the motion", place.what), help));
        }
        Ok(value)
    }

    /// Three expressions at a place.
    pub(super) fn vector(&mut self, vector: &Vector, place: &Place<'g>) -> Result<Vec3<'g>, Reported> {
        let [x, y, z] = vector.components.each_ref().map(|e| self.expr(e, place));
        Ok(Vec3([x?, y?, z?]))
    }

    /// An operation, whose value must be finite where it is constant.
    fn operation(&mut self, expr: &ast::Expr, place: &Place<'g>) -> Result<Expr<'g>, Reported> {
        let value = self.unchecked(expr, place)?;
        if value.as_number().is_none() && value.constant().is_some_and(|value| !value.is_finite()) {
            let help = "look for a division by zero or the root or logarithm of a negative number";
            return Err(self
                .errors
                .on(expr, format_args!("a part of {} has no finite value", place.what), help));
        }
        Ok(value)
    }

    fn unchecked(&mut self, expr: &ast::Expr, place: &Place<'g>) -> Result<Expr<'g>, Reported> {
        match &expr.kind {
            ExprKind::Number(n) => Ok(self.graph.number(n.clone())),
            ExprKind::Name(name) => self.name(name, place),
            ExprKind::Call(name, arguments) => self.call(expr, name, arguments, place),
            ExprKind::Neg(a) => Ok(-self.operation(a, place)?),
            ExprKind::Binary(operator, a, b) => {
                let (left, right) = (self.operation(a, place), self.operation(b, place));
                let (left, right) = (left?, right?);
                if *operator == Operator::Div && right.is_zero() {
                    return Err(self.errors.on(
                        &**b,
                        format_args!("division by zero in {}", place.what),
                        "the divisor must not be the number 0",
                    ));
                }
                Ok(match operator {
                    Operator::Add => left + right,
                    Operator::Sub => left - right,
                    Operator::Mul => left * right,
                    Operator::Div => left / right,
                })
            }
            ExprKind::Power(base, exponent) => {
                let (x, n) = (self.operation(base, place), self.operation(exponent, place));
                let (x, n) = (x?, n?);
                let small = |n: &num_bigint::BigInt| n.abs().to_i64().is_some_and(|n| n <= MOST_POWER);
                let Some(n) = n.as_number().filter(|n| small(n.numer()) && small(n.denom())) else {
                    let help = format!(
                        "write an integer or a fraction such as `(1/2)`, with parts up to {MOST_POWER}; `exp(b*ln(a))` gives other powers"
                    );
                    return Err(self.errors.on(
                        &**exponent,
                        format_args!("the power in {} is not a constant small enough", place.what),
                        help,
                    ));
                };
                if x.is_zero() && !n.is_positive() && !n.is_zero() {
                    return Err(self.errors.on(
                        expr,
                        format_args!("division by zero in {}", place.what),
                        "zero has no negative power",
                    ));
                }
                Ok(x.power(n.clone()))
            }
        }
    }

    fn name(&mut self, name: &Ident, place: &Place<'g>) -> Result<Expr<'g>, Reported> {
        let text = name.to_string();
        match (text.as_str(), place.joint) {
            ("pi", _) => return Ok(self.graph.pi()),
            ("t", _) => return Ok(self.time),
            ("q", Some((position, _))) => return Ok(position),
            ("qd", Some((_, rate))) => return Ok(rate),
            _ => {}
        }
        if let Some(value) = self.names.value(&text) {
            return Ok(value);
        }
        if let Some(reported) = self.broken.get(&text) {
            return Err(*reported);
        }
        let help = if self.names.is_declared(&text) {
            "a `let` may use only what stands before it".to_owned()
        } else {
            let more: &[&str] = match (place.most, place.joint) {
                (Level::State, Some(_)) => &["t", "q", "qd", "pi"],
                (Level::State, None) => &["t", "pi"],
                _ => &["pi"],
            };
            let fits = |value: Expr<'g>| value.level() <= place.most;
            suggestion(&text, self.names.known(fits, more))
        };
        let fact = format!("unknown symbol `{text}` in {}", place.what);
        Err(self.errors.at(name.span(), fact, help))
    }

    fn call(
        &mut self,
        expr: &ast::Expr,
        name: &Ident,
        arguments: &[ast::Expr],
        place: &Place<'g>,
    ) -> Result<Expr<'g>, Reported> {
        let text = name.to_string();
        if text == "dot" {
            return self.dot(expr, arguments);
        }
        let count = if text == "atan2" { 2 } else { 1 };
        let unary = FUNCTIONS.iter().find(|(known, _)| *known == text).map(|(_, op)| *op);
        if unary.is_none() && !["sqrt", "atan2"].contains(&text.as_str()) {
            let known = FUNCTIONS
                .iter()
                .map(|(known, _)| *known)
                .chain(["sqrt", "atan2", "dot"]);
            return Err(self.errors.at(
                name.span(),
                format_args!("unknown function `{text}` in {}", place.what),
                suggestion(&text, known),
            ));
        }
        if arguments.len() != count {
            let help = if count == 2 {
                "write `atan2(y, x)`".to_owned()
            } else {
                format!("write `{text}(x)`")
            };
            return Err(self.errors.on(
                expr,
                format_args!(
                    "`{text}` takes {count} argument{}, not {}",
                    if count == 1 { "" } else { "s" },
                    arguments.len()
                ),
                help,
            ));
        }
        let values: Vec<_> = arguments.iter().map(|a| self.operation(a, place)).collect();
        let values: Vec<Expr<'g>> = values.into_iter().collect::<Result<_, _>>()?;
        Ok(match unary {
            Some(op) => values[0].apply(op),
            None if text == "sqrt" => values[0].sqrt(),
            None => values[0].combine(Binary::Atan2, values[1]),
        })
    }

    fn dot(&mut self, expr: &ast::Expr, arguments: &[ast::Expr]) -> Result<Expr<'g>, Reported> {
        let [
            ast::Expr {
                kind: ExprKind::Name(name),
                ..
            },
        ] = arguments
        else {
            return Err(self.errors.on(
                expr,
                "`dot` takes the name of a coordinate",
                "write `dot(theta)` for the rate of `theta`",
            ));
        };
        let text = name.to_string();
        if let Some(rate) = self.names.rate(&text) {
            return Ok(rate);
        }
        let fact = format!("`{text}` is not a coordinate, so it has no rate");
        let help = self.names.suggest_rate(&text);
        Err(self.errors.at(name.span(), fact, help))
    }
}
