//! Names and functions in expressions.

use syn::Ident;

use super::Lower;
use super::expr::Place;
use super::scope::Kind;
use crate::ast::{self, ExprKind};
use crate::error::Reported;
use crate::expr::{Binary, Expr, Level, Unary};
use crate::words;

const UNARY: [(&str, Unary); 7] = [
    ("sin", Unary::Sin),
    ("cos", Unary::Cos),
    ("tan", Unary::Tan),
    ("exp", Unary::Exp),
    ("ln", Unary::Ln),
    ("tanh", Unary::Tanh),
    ("abs", Unary::Abs),
];

/// All functions.
fn functions() -> impl Iterator<Item = &'static str> {
    UNARY.iter().map(|(name, _)| *name).chain(["sqrt", "atan2", "dot"])
}

impl<'g> Lower<'g> {
    /// What a name stands for at a place.
    pub(super) fn name(&mut self, name: &Ident, place: &Place<'g>) -> Result<Expr<'g>, Reported> {
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
        match self.names.kind(&text) {
            None => {}
            Some(Kind::Parameter) => {
                let fact = format_args!("{} may not depend on `{text}`", place.what);
                let help = "write a number; a `let` names what depends on parameters";
                return Err(self.errors.at(name.span(), fact, help));
            }
            Some(_) => {
                let fact = format_args!("`{text}` is used before it is defined");
                return Err(self
                    .errors
                    .at(name.span(), fact, "a `let` may use only what stands before it"));
            }
        }
        let fact = format!("unknown symbol `{text}` in {}", place.what);
        if let Some(coordinate) = self.names.rate_meant(&text) {
            let help = format_args!("write `dot({coordinate})` for the rate of `{coordinate}`");
            return Err(self.errors.at(name.span(), fact, help));
        }
        if functions().any(|function| function == text) {
            return Err(self.errors.at(name.span(), fact, format_args!("write `{text}(x)`")));
        }
        let more: &[&str] = match (place.most, place.joint) {
            (Level::State, Some(_)) => &["t", "q", "qd", "pi"],
            (Level::State, None) => &["t", "pi"],
            _ => &["pi"],
        };
        let known = self.names.known(|value| value.level() <= place.most, more);
        Err(self.errors.unknown(name, fact, known, words::SYMBOLS))
    }

    /// A function of its arguments.
    pub(super) fn call(
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
        let unary = UNARY.iter().find(|(known, _)| *known == text).map(|(_, op)| *op);
        if !functions().any(|known| known == text) {
            if let Some(kind) = self.names.kind(&text) {
                let fact = format_args!("`{text}` is {}, not a function", kind.one());
                let help = format_args!("write `{text}` alone, or `{text}*(..)` for a product");
                return Err(self.errors.at(name.span(), fact, help));
            }
            let fact = format_args!("unknown function `{text}` in {}", place.what);
            return Err(self.errors.unknown(name, fact, functions(), words::FUNCTIONS));
        }
        let (count, form) = match text.as_str() {
            "atan2" => (2, "atan2(y, x)".to_owned()),
            _ => (1, format!("{text}(x)")),
        };
        if arguments.len() != count {
            let plural = if count == 1 { "" } else { "s" };
            let fact = format_args!("`{text}` takes {count} argument{plural}, not {}", arguments.len());
            return Err(self.errors.on(expr, fact, format_args!("write `{form}`")));
        }
        let values: Vec<_> = arguments.iter().map(|a| self.operation(a, place)).collect();
        let values: Vec<Expr<'g>> = values.into_iter().collect::<Result<_, _>>()?;
        if text == "sqrt" {
            self.never_negative(&arguments[0], values[0], "a square root", "sqrt(abs(x))")?;
        } else if text == "ln" {
            self.never_negative(&arguments[0], values[0], "a logarithm", "ln(abs(x))")?;
        }
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
        if let Some(reported) = self.broken.get(&text) {
            return Err(*reported);
        }
        let fact = format!("`{text}` is not a coordinate, so it has no rate");
        if text == "q" {
            return Err(self.errors.at(name.span(), fact, "write `qd` for a joint's own rate"));
        }
        Err(self.errors.unknown(name, fact, self.names.with_rates(), &[]))
    }
}
