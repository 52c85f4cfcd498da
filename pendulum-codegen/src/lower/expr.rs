//! Expressions of the language to expressions of the graph.

use num_traits::{Signed, ToPrimitive, Zero};
use syn::Ident;

use super::Lower;
use crate::ast::{Expr, ExprKind, Operator, Vector};
use crate::error::{Reported, suggestion};
use crate::expr::{ExprId, Level, Unary};
use crate::screw::Vec3;

/// Where an expression stands: what it may use, and how errors speak of it.
#[derive(Clone, Debug)]
pub(super) struct Place {
    /// `the torque of `arm``
    pub(super) what: String,
    /// On what it may depend.
    pub(super) most: Level,
    /// The coordinate and the rate of the joint, where `q` and `qd` may stand.
    pub(super) joint: Option<(ExprId, ExprId)>,
}

impl Place {
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

impl Lower {
    /// The expression at a place.
    pub(super) fn expr(&mut self, expr: &Expr, place: &Place) -> Result<ExprId, Reported> {
        let id = self.operation(expr, place)?;
        let level = self.graph.level(id);
        if level > place.most {
            let help = if place.joint.is_some() {
                "give the coefficient of viscous friction here, and any other law as `torque: ..`"
            } else {
                "build it from numbers and parameters: it is computed once, when the model is built"
            };
            return Err(self
                .errors
                .on(expr, format_args!("{} may not depend on the motion", place.what), help));
        }
        Ok(id)
    }

    /// Three expressions at a place.
    pub(super) fn vector(&mut self, vector: &Vector, place: &Place) -> Result<Vec3, Reported> {
        let [x, y, z] = vector.components.each_ref().map(|e| self.expr(e, place));
        Ok([x?, y?, z?])
    }

    /// An operation, whose value must be finite where it is constant.
    fn operation(&mut self, expr: &Expr, place: &Place) -> Result<ExprId, Reported> {
        let id = self.unchecked(expr, place)?;
        let constant = self.graph.level(id) == Level::Constant && self.graph.as_number(id).is_none();
        if constant && self.graph.constant(id).is_some_and(|value| !value.is_finite()) {
            let help = "look for a division by zero or the root or logarithm of a negative number";
            return Err(self
                .errors
                .on(expr, format_args!("a part of {} has no finite value", place.what), help));
        }
        Ok(id)
    }

    fn unchecked(&mut self, expr: &Expr, place: &Place) -> Result<ExprId, Reported> {
        match &expr.kind {
            ExprKind::Number(n) => Ok(self.graph.number(n.clone())),
            ExprKind::Name(name) => self.name(name, place),
            ExprKind::Call(name, arguments) => self.call(expr, name, arguments, place),
            ExprKind::Neg(a) => {
                let a = self.operation(a, place)?;
                Ok(self.graph.neg(a))
            }
            ExprKind::Binary(operator, a, b) => {
                let (left, right) = (self.operation(a, place), self.operation(b, place));
                let (left, right) = (left?, right?);
                if *operator == Operator::Div && self.graph.is_zero(right) {
                    return Err(self.errors.on(
                        &**b,
                        format_args!("division by zero in {}", place.what),
                        "the divisor must not be the number 0",
                    ));
                }
                Ok(match operator {
                    Operator::Add => self.graph.add(left, right),
                    Operator::Sub => self.graph.sub(left, right),
                    Operator::Mul => self.graph.mul(left, right),
                    Operator::Div => self.graph.div(left, right),
                })
            }
            ExprKind::Power(base, exponent) => {
                let (x, n) = (self.operation(base, place), self.operation(exponent, place));
                let (x, n) = (x?, n?);
                let small = |n: &num_bigint::BigInt| n.abs().to_i64().is_some_and(|n| n <= MOST_POWER);
                let Some(n) = self
                    .graph
                    .as_number(n)
                    .filter(|n| small(n.numer()) && small(n.denom()))
                    .cloned()
                else {
                    let help = format!(
                        "write an integer or a fraction such as `(1/2)`, with parts up to {MOST_POWER}; `exp(b*ln(a))` gives other powers"
                    );
                    return Err(self.errors.on(
                        &**exponent,
                        format_args!("the power in {} is not a constant small enough", place.what),
                        help,
                    ));
                };
                if self.graph.is_zero(x) && !n.is_positive() && !n.is_zero() {
                    return Err(self.errors.on(
                        expr,
                        format_args!("division by zero in {}", place.what),
                        "zero has no negative power",
                    ));
                }
                Ok(self.graph.power(x, n))
            }
        }
    }

    fn name(&mut self, name: &Ident, place: &Place) -> Result<ExprId, Reported> {
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
            let fits = |id: ExprId| self.graph.level(id) <= place.most;
            suggestion(&text, self.names.known(fits, more))
        };
        let fact = format!("unknown symbol `{text}` in {}", place.what);
        Err(self.errors.at(name.span(), fact, help))
    }

    fn call(&mut self, expr: &Expr, name: &Ident, arguments: &[Expr], place: &Place) -> Result<ExprId, Reported> {
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
        let values: Vec<ExprId> = values.into_iter().collect::<Result<_, _>>()?;
        Ok(match unary {
            Some(op) => self.graph.unary(op, values[0]),
            None if text == "sqrt" => self.graph.sqrt(values[0]),
            None => self.graph.binary(crate::expr::Binary::Atan2, values[0], values[1]),
        })
    }

    fn dot(&mut self, expr: &Expr, arguments: &[Expr]) -> Result<ExprId, Reported> {
        let [
            Expr {
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
