//! Lookup of names and functions in expressions.

use syn::Ident;

use super::Lower;
use super::expr::Place;
use super::measure::{Measure, Quantity};
use super::scope::Kind;
use crate::ast::{self, ExprKind, Measured, Operator};
use crate::error::{Code, Reported};
use crate::expr::{Binary, Expr, Level, SymbolKind, Unary};
use crate::units::{self, Dimension, Power, Unit};
use crate::words::{self, Advice};

const UNARY: [(&str, Unary); 7] = [
    ("sin", Unary::Sin),
    ("cos", Unary::Cos),
    ("tan", Unary::Tan),
    ("exp", Unary::Exp),
    ("ln", Unary::Ln),
    ("tanh", Unary::Tanh),
    ("abs", Unary::Abs),
];

/// Names of all functions.
fn functions() -> impl Iterator<Item = &'static str> {
    UNARY
        .iter()
        .map(|(name, _)| *name)
        .chain(["sqrt", "atan2", "clamp", "dot", "distance", "margin"])
}

/// Last factor of a product, if it is a number with a unit.
fn last_measured(e: &ast::Expr) -> Option<&Measured> {
    match &e.kind {
        ExprKind::Measured(measured) => Some(measured),
        ExprKind::Neg(a) | ExprKind::Binary(Operator::Mul, _, a) => last_measured(a),
        _ => None,
    }
}

impl<'g> Lower<'g> {
    /// Looks up a name at a place.
    pub(super) fn name(&mut self, name: &Ident, place: &Place<'g>) -> Result<Quantity<'g>, Reported> {
        let text = name.to_string();
        let (value, measure) = match (text.as_str(), place.joint) {
            ("pi", _) => (self.graph.pi(), Measure::Number),
            ("t", _) => (self.time, Measure::in_dimension(Dimension::TIME)),
            ("q", Some([position, _])) => return Ok(position),
            ("qd", Some([_, rate])) => return Ok(rate),
            _ => return self.declared(name, place),
        };
        Ok(Quantity { value, measure })
    }

    /// Looks up a declared name at a place.
    fn declared(&mut self, name: &Ident, place: &Place<'g>) -> Result<Quantity<'g>, Reported> {
        let text = name.to_string();
        if let Some(value) = self.names.value(&text) {
            return Ok(value);
        }
        if let Some(reported) = self.broken.get(&text) {
            return Err(*reported);
        }
        match self.names.kind(&text) {
            None => {}
            Some(Kind::Orientation | Kind::Position | Kind::Point) => {
                if let Some(reported) = self.not_a_number(name, false) {
                    return Err(reported);
                }
            }
            Some(Kind::Parameter) => {
                let fact = format_args!("{} may not depend on `{text}`", place.what);
                let help = "write a number, or use a `let` for a value that depends on parameters";
                return Err(self.errors.at(Code::Dependence, name.span(), fact, help));
            }
            Some(_) => {
                let fact = format_args!("`{text}` is used before it is defined");
                let help = "a `let` may use only names that are defined before it";
                return Err(self.errors.at(Code::Circle, name.span(), fact, help));
            }
        }
        let fact = format!("unknown symbol `{text}` in {}", place.what);
        if let Some(coordinate) = self.names.rate_meant(&text) {
            let help = format_args!("write `dot({coordinate})` for the rate of `{coordinate}`");
            return Err(self.errors.at(Code::UnknownName, name.span(), fact, help));
        }
        if self.body_names.contains(&text) {
            let help = format_args!(
                "`{text}` is a body, not a number: declare a point, `point {text}_end on {text} at [x, y, z],`, or \
                 write `rotation({text})`"
            );
            return Err(self.errors.at(Code::WrongKind, name.span(), fact, help));
        }
        if functions().any(|function| function == text) {
            return Err(self
                .errors
                .at(Code::WrongKind, name.span(), fact, format_args!("write `{text}(x)`")));
        }
        let more: &[&str] = match (place.most, place.joint) {
            (Level::State, Some(_)) => &["t", "q", "qd", "pi"],
            (Level::State, None) => &["t", "pi"],
            _ => &["pi"],
        };
        let known = self.names.known(|value| value.level() <= place.most, more);
        let Advice { help, .. } = words::advice(&text, known, words::SYMBOLS);
        let unit = match self.has_units && Unit::is_name(&text) {
            true => format!("; as a unit, `{text}` follows a number: `1 {text}` or `x/(1 {text})`"),
            false => String::new(),
        };
        let help = format_args!("{help}{unit}");
        Err(self.errors.at(Code::UnknownName, name.span(), fact, help))
    }

    /// Reports an unknown name that seems to continue the unit of the number before it, as in `2 N*m` and `9.81 m/s2`.
    pub(super) fn rest_of_unit(
        &mut self,
        operator: Operator,
        before: &ast::Expr,
        name: &ast::Expr,
        place: &Place<'g>,
    ) -> Option<Reported> {
        let ExprKind::Name(name) = &name.kind else { return None };
        let text = name.to_string();
        let is_known = ["pi", "t", "q", "qd"].contains(&text.as_str())
            || self.names.kind(&text).is_some()
            || self.broken.contains_key(&text);
        let is_divisor = match operator {
            Operator::Mul => false,
            Operator::Div => true,
            Operator::Add | Operator::Sub => return None,
        };
        let number = last_measured(before).filter(|_| !is_known)?;
        let help = units::help_in_product(number, is_divisor, &text)?;
        let fact = format_args!("unknown symbol `{text}` in {}", place.what);
        Some(self.errors.at(Code::UnknownUnit, name.span(), fact, help))
    }

    /// Lowers a function call.
    pub(super) fn call(
        &mut self,
        expr: &ast::Expr,
        name: &Ident,
        arguments: &[ast::Expr],
        place: &Place<'g>,
    ) -> Result<Quantity<'g>, Reported> {
        let text = name.to_string();
        match text.as_str() {
            "dot" => {
                let rate = self.dot(expr, arguments, place)?;
                self.permit(rate.value, name.span(), place)?;
                return Ok(rate);
            }
            "clamp" => return self.clamp(expr, arguments, place),
            "margin" => {
                return Ok(Quantity {
                    value: self.margin(expr, arguments, place)?,
                    measure: Measure::ONE,
                });
            }
            "distance" => {
                return Ok(Quantity {
                    value: self.distance(expr, arguments, place)?,
                    measure: Measure::of("m"),
                });
            }
            _ => {}
        }
        let unary = UNARY.iter().find(|(known, _)| *known == text).map(|(_, op)| *op);
        if !functions().any(|known| known == text) {
            return Err(self.no_function(name, place));
        }
        self.require_count(expr, &text, arguments)?;
        let given: Vec<_> = arguments.iter().map(|a| self.operation(a, place)).collect();
        let given: Vec<Quantity<'g>> = given.into_iter().collect::<Result<_, _>>()?;
        let values: Vec<Expr<'g>> = given.iter().map(|given| given.value).collect();
        if text == "sqrt" {
            self.never_negative(&arguments[0], values[0], "a square root", |x| {
                format!("`sqrt(abs({x}))`")
            })?;
        } else if text == "ln" {
            self.never_negative(&arguments[0], values[0], "a logarithm", |x| format!("`ln(abs({x}))`"))?;
        }
        let measure = self.measure_of(&text, arguments, &given);
        let value = match unary {
            Some(op) => values[0].apply(op),
            None if text == "sqrt" => values[0].sqrt(),
            None => values[0].combine(Binary::Atan2, values[1]),
        };
        Ok(Quantity { value, measure })
    }

    /// Requires the number of arguments that a function of numbers takes.
    fn require_count(&mut self, expr: &ast::Expr, function: &str, arguments: &[ast::Expr]) -> Result<(), Reported> {
        let (count, form) = match function {
            "atan2" => (2, "atan2(y, x)".to_owned()),
            _ => (1, format!("{function}(x)")),
        };
        if arguments.len() == count {
            return Ok(());
        }
        let plural = if count == 1 { "" } else { "s" };
        let fact = format_args!("`{function}` takes {count} argument{plural}, not {}", arguments.len());
        let help = format_args!("write `{form}`");
        Err(self.errors.on(Code::Arguments, expr, fact, help))
    }

    /// Reports a call of a name that is not a function.
    fn no_function(&mut self, name: &Ident, place: &Place<'g>) -> Reported {
        let Some(kind) = self.names.kind(&name.to_string()) else {
            let fact = format_args!("unknown function `{name}` in {}", place.what);
            return self
                .errors
                .unknown(Code::UnknownFunction, name, fact, functions(), words::FUNCTIONS);
        };
        let fact = format_args!("`{name}` is {}, not a function", kind.one());
        let help = format_args!("write `{name}` alone, or `{name}*(..)` for a product");
        self.errors.at(Code::WrongKind, name.span(), fact, help)
    }

    /// Measure of a function value.
    fn measure_of(&mut self, function: &str, arguments: &[ast::Expr], given: &[Quantity<'g>]) -> Measure {
        match (function, arguments, given) {
            ("abs", _, [x]) => return x.measure,
            ("sqrt", _, [x]) => return x.measure.power(Power::new(1, 2)),
            ("atan2", [a, b], [y, x]) => {
                _ = self.require_alike([a, b], [y.measure, x.measure], "the sides of one angle")
            }
            (_, [argument], [x]) => {
                let what = format!("the argument of `{function}`");
                self.require_plain(argument, *x, &what);
                if matches!(function, "sin" | "cos" | "tan") {
                    self.not_degrees(argument, *x, &what);
                }
            }
            _ => {}
        }
        // a function of numbers is a number
        let is_number = given.iter().all(|x| x.measure == Measure::Number);
        if is_number { Measure::Number } else { Measure::ONE }
    }

    /// Lowers `dot(x)`, the time derivative.
    fn dot(&mut self, expr: &ast::Expr, arguments: &[ast::Expr], place: &Place<'g>) -> Result<Quantity<'g>, Reported> {
        let [argument] = arguments else {
            return Err(self.errors.on(
                Code::Arguments,
                expr,
                "`dot` takes one quantity",
                "write `dot(theta)` for the rate of `theta`",
            ));
        };
        match &argument.kind {
            ExprKind::Name(name) => {
                if let Some(rate) = self.rate_named(name)? {
                    return Ok(rate);
                }
            }
            ExprKind::Component(point, _)
                if !self.components.contains_key(&point.to_string()) && !self.point_named(point)?.moves =>
            {
                let fact = format_args!("`{point}` does not move, so it has no rate");
                let help = "leave it out, or name a point of a body that moves";
                return Err(self.errors.at(Code::NoRate, point.span(), fact, help));
            }
            _ => {}
        }
        // the argument has the same restrictions as the place, and must not contain rates itself
        let Quantity { value, measure } = self.operation(argument, place)?;
        self.require_rate(argument, value)?;
        Ok(Quantity {
            value: self.along_motion.of(value),
            measure: measure.rate(),
        })
    }

    /// Declared rate of a name; none if it follows from the value of the name.
    fn rate_named(&mut self, name: &Ident) -> Result<Option<Quantity<'g>>, Reported> {
        let text = name.to_string();
        if let Some(rate) = self.names.rate(&text) {
            return Ok(Some(rate));
        }
        if let Some(reported) = self.broken.get(&text) {
            return Err(*reported);
        }
        match self.names.kind(&text) {
            Some(Kind::State) => {
                let fact = format_args!("the rate of the state `{text}` is not known here");
                let help = format_args!("name it: `let rate_of_{text} = ..`, and `rate: rate_of_{text}` in the state");
                Err(self.errors.at(Code::NoRate, name.span(), fact, help))
            }
            Some(Kind::Let | Kind::Input) => Ok(None),
            None if text == "t" => Ok(None),
            Some(Kind::Orientation | Kind::Position | Kind::Point) => {
                self.not_a_number(name, true).map_or(Ok(None), Err)
            }
            _ => {
                let fact = format!("`{text}` is not a coordinate, so it has no rate");
                if text == "q" {
                    return Err(self
                        .errors
                        .at(Code::NoRate, name.span(), fact, "write `qd` for a joint's own rate"));
                }
                Err(self
                    .errors
                    .unknown(Code::NoRate, name, fact, self.names.with_rates(), &[]))
            }
        }
    }

    /// Rejects a value whose rate is unknown or always zero.
    fn require_rate(&mut self, given: &ast::Expr, value: Expr<'g>) -> Result<(), Reported> {
        let mut symbols = self.graph.symbols_of(&[value]);
        let without_rate = symbols.find(|symbol| {
            matches!(
                symbol.kind,
                SymbolKind::Rate(_)
                    | SymbolKind::PointRate(_)
                    | SymbolKind::Input(_)
                    | SymbolKind::State(_)
                    | SymbolKind::Dependent(_)
            )
        });
        if let Some(symbol) = without_rate {
            let fact = format_args!("the rate of `{}` is not available", symbol.name);
            let help = "accelerations follow from the equations of motion, and inputs are given without rates; the \
                        rate of an output is the function `.._rate` of the model";
            return Err(self.errors.on(Code::NoRate, given, fact, help));
        }
        if value.level() < Level::State {
            let fact = "this is constant, so its rate is zero";
            return Err(self.errors.on(Code::NoRate, given, fact, "remove it"));
        }
        Ok(())
    }
}
