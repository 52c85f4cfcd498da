//! Declarations of a scene: parameters, inputs, named expressions and coordinates.

use super::Lower;
use super::components::Unrated;
use super::expr::Place;
use super::freedom::freedom;
use super::joint_units::JointUnits;
use super::measure::Measure;
use super::scope::Kind;
use super::written::written;
use crate::ast::{self, ExprKind, Read};
use crate::error::{Code, Reported};
use crate::expr::{Definition, Expr, Level, SymbolKind};
use crate::model::{Coordinate, Input, Parameter, State};
use crate::units::Unit;

impl<'g> Lower<'g> {
    pub(super) fn parameters(&mut self, params: &[ast::Param]) -> Vec<Parameter<'g>> {
        let mut units = Vec::new();
        for param in params {
            let unit = self.unit(param.unit.as_ref(), || {
                ast::without_unit("parameter", &param.name, &param.name.to_string(), "kg")
            });
            self.names
                .declare(&mut self.errors, Kind::Parameter, &param.name, (measure(&unit), None));
            self.spans.parameters.push(param.name.span());
            units.push(unit);
        }
        let mut parameters = Vec::new();
        for (param, unit) in params.iter().zip(units) {
            let name = param.name.to_string();
            // no parameter has a value yet, so defaults consist of numbers only
            let default = param
                .default
                .as_ref()
                .and_then(|default| self.default(&name, &unit, default).ok());
            let symbol = self.graph.symbol(&name, SymbolKind::Parameter(parameters.len()));
            parameters.push(Parameter {
                name,
                docs: param.docs.clone(),
                unit: unit.unwrap_or_default(),
                default: default.and_then(Expr::constant),
                symbol,
            });
        }
        for parameter in &parameters {
            self.names.set_value(&parameter.name, parameter.symbol);
        }
        parameters
    }

    /// Unit of a parameter, an input or a state, which may be missing in a scene without units; `missing` is the error
    /// elsewhere.
    fn unit(&mut self, unit: Option<&Read<Unit>>, missing: impl FnOnce() -> syn::Error) -> Result<Unit, Reported> {
        match unit {
            Some(unit) => self.read(unit).cloned(),
            None if !self.has_units => Ok(Unit::default()),
            None => Err(self.errors.push(missing())),
        }
    }

    fn default(
        &mut self,
        name: &str,
        unit: &Result<Unit, Reported>,
        default: &Read<ast::Expr>,
    ) -> Result<Expr<'g>, Reported> {
        let place = Place {
            most: Level::Constant,
            unit: unit.as_ref().ok().map(|unit| unit.text.clone().into()),
            ..Place::fixed(format!("the default of `{name}`"))
        };
        let default = self.read(default)?;
        if let (Ok(unit), ExprKind::Measured(measured)) = (unit, &default.kind) {
            // the unit check treats a radian as 1, so it cannot distinguish frequencies from angular rates
            let has = |unit: &Unit, known: &[&str]| unit.names().any(|name| known.contains(&name));
            let counts = |unit: &Unit| has(unit, &["Hz", "kHz"]);
            let turns = |unit: &Unit| has(unit, &["rad", "mrad", "deg", "turn", "rpm"]);
            let given = &measured.unit;
            if counts(given) && turns(unit) || counts(unit) && turns(given) {
                let fact = format_args!(
                    "cycles and angles differ by a factor of 2 pi: `{name}` is in {}",
                    unit.text
                );
                let help = "write an angular rate as `30 turn/s` or `30 rpm`, and a frequency as `30 Hz`";
                return Err(self.errors.on(Code::UnitMismatch, default, fact, help));
            }
        }
        self.expr(default, &place)
    }

    pub(super) fn inputs(&mut self, declared: &[ast::Input]) -> Vec<Input<'g>> {
        let mut inputs = Vec::new();
        for input in declared {
            let name = input.name.to_string();
            let unit = self.unit(input.unit.as_ref(), || {
                ast::without_unit("input", &input.name, &name, "N")
            });
            self.spans.inputs.push(input.name.span());
            let symbol = self.graph.symbol(&name, SymbolKind::Input(inputs.len()));
            self.names.declare(
                &mut self.errors,
                Kind::Input,
                &input.name,
                (measure(&unit), Some(symbol)),
            );
            inputs.push(Input {
                name,
                docs: input.docs.clone(),
                unit: unit.unwrap_or_default(),
                symbol,
            });
        }
        inputs
    }

    /// Declares the first-order states; their rates follow later.
    pub(super) fn states(&mut self, declared: &[ast::State]) -> Vec<State<'g>> {
        let mut states = Vec::new();
        for state in declared {
            let name = state.name.to_string();
            let unit = match (&state.unit, state.unread) {
                (None, Some(reported)) => Err(reported),
                (unit, _) => self.unit(unit.as_ref(), || ast::without_unit("state", &state.name, "unit", "A")),
            };
            let symbol = self.graph.symbol(&name, SymbolKind::State(states.len()));
            self.names.declare(
                &mut self.errors,
                Kind::State,
                &state.name,
                (measure(&unit), Some(symbol)),
            );
            states.push(State {
                name,
                docs: state.docs.clone(),
                unit: unit.unwrap_or_default(),
                symbol,
                rate: self.graph.zero(),
            });
        }
        states
    }

    /// Lowers the rates of the first-order states.
    pub(super) fn state_rates(&mut self, declared: &[ast::State], mut states: Vec<State<'g>>) -> Vec<State<'g>> {
        for (state, own) in declared.iter().zip(&mut states) {
            let Some(rate) = &state.rate else {
                if state.unread.is_none() {
                    let fact = format_args!("state `{}` has no rate", state.name);
                    let help = "write `rate: e`, its time derivative";
                    self.errors.at(Code::NoRate, state.name.span(), fact, help);
                }
                continue;
            };
            let has_unit = matches!(state.unit, Some(Ok(_)));
            let place = Place {
                unit: has_unit.then(|| own.unit.rate().into()),
                ..Place::moving(format!("the rate of `{}`", state.name))
            };
            let value = self.read(rate);
            if let Ok(rate) = value.and_then(|rate| self.expr(rate, &place)) {
                own.rate = rate;
            }
        }
        states
    }

    /// Declares names, and returns their definitions as written. Values are set later, so that a use before the
    /// definition is not reported as a misspelling.
    pub(super) fn declare_lets(&mut self, lets: &[ast::Let]) -> Vec<Definition> {
        for item in lets {
            self.names
                .declare(&mut self.errors, Kind::Let, &item.name, (Measure::Unknown, None));
        }
        let definition = |item: &ast::Let| {
            let value = item.value.as_ref().ok()?;
            Some(Definition {
                name: item.name.to_string().replace("r#", ""),
                formula: written(value, None),
            })
        };
        lets.iter().filter_map(definition).collect()
    }

    /// Sets the value of each name, in the order of the source.
    pub(super) fn lets(&mut self, lets: &[ast::Let]) {
        for item in lets {
            let place = Place::moving(format!("`{}`", item.name));
            let value = self.read(&item.value);
            let name = item.name.to_string();
            match value.and_then(|value| self.quantity(value, &place)) {
                Ok(quantity) => {
                    self.names.set_value(&name, quantity.value);
                    self.names.set_measure(&name, quantity.measure);
                }
                Err(reported) => _ = self.broken.insert(name, reported),
            }
        }
    }

    /// Declares the coordinates of the state, or the dependent ones, numbered from `first`.
    pub(super) fn coordinates(&mut self, bodies: &[ast::Body], first: usize, depend: bool) -> Vec<Coordinate<'g>> {
        let mut coordinates = Vec::new();
        for body in bodies.iter().filter(|body| body.fields.depends.is_some() == depend) {
            self.freedom_coordinates(body, &mut coordinates);
            let Some(ident) = &body.fields.coordinate else { continue };
            if let Some(slides) = freedom(body) {
                let reported = self.refuse_coordinate(body, slides, ident);
                self.broken.insert(ident.to_string(), reported);
                continue;
            }
            let (name, k) = (ident.to_string(), first + coordinates.len());
            let position = self.graph.symbol(&name, SymbolKind::Coordinate(k));
            let measure = JointUnits::of(body).measure();
            self.names
                .declare(&mut self.errors, Kind::Coordinate, ident, (measure, Some(position)));
            coordinates.push(Unrated {
                rate: format!("dot({name})"),
                name,
                position,
                turns: None,
            });
        }
        let rate = |(k, unrated): (usize, &Unrated<'g>)| self.graph.symbol(&unrated.rate, SymbolKind::Rate(first + k));
        let rates: Vec<_> = coordinates.iter().enumerate().map(rate).collect();
        for (Unrated { name, .. }, &rate) in coordinates.iter().zip(&rates) {
            self.names.set_rate(name, rate);
        }
        let with_rates = coordinates.into_iter().zip(rates).enumerate();
        let coordinates = with_rates
            .map(|(k, (unrated, rate))| {
                let name = format!("d{}", unrated.rate);
                let acceleration = self.graph.symbol(&name, SymbolKind::Acceleration(first + k));
                unrated.with_rates(rate, acceleration)
            })
            .collect::<Vec<_>>();
        self.name_components(bodies, &coordinates);
        coordinates
    }
}

/// Measure of a declared quantity.
fn measure(unit: &Result<Unit, Reported>) -> Measure {
    unit.as_ref()
        .map_or(Measure::Unknown, |unit| Measure::in_dimension(unit.dimension))
}
