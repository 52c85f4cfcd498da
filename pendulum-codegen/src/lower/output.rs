//! Outputs and events.

use std::collections::BTreeMap;

use super::Lower;
use super::expr::{Only, Place};
use super::measure::{Measure, Quantity};
use super::scope::Kind;
use crate::ast::{self, ExprKind, OutputValue};
use crate::error::{Code, Reported};
use crate::expr::{Expr, Level};
use crate::model::{Event, FACTS, Output, OutputShape, Poses, constant, places};
use crate::program;

impl<'g> Lower<'g> {
    /// Lowers the outputs of a scene with the given poses of its bodies.
    pub(super) fn outputs(&mut self, items: &ast::Items, poses: &Poses<'g>) -> Vec<Output<'g>> {
        let mut outputs = Vec::new();
        for output in &items.outputs {
            let place = place(format!("output `{}`", output.name));
            let value = match self.read(&output.value) {
                Ok(OutputValue::Scalar(e)) => self.output(e, &place, &items.bodies, poses),
                Ok(OutputValue::List(list)) => {
                    let values: Vec<_> = list.iter().map(|e| self.with_unit(e, &place)).collect();
                    let values = values.into_iter().collect::<Result<Vec<_>, _>>();
                    values.map(|values| (OutputShape::Vector(values.len()), values))
                }
                Err(reported) => Err(reported),
            };
            outputs.extend(value.map(|(shape, values)| {
                let (values, units) = values.into_iter().unzip();
                Output {
                    name: output.name.to_string(),
                    docs: output.docs.clone(),
                    shape,
                    values,
                    units,
                }
            }));
        }
        outputs
    }

    /// Lowers a component of an output, with its unit.
    fn with_unit(&mut self, e: &ast::Expr, place: &Place<'g>) -> Result<(Expr<'g>, String), Reported> {
        let Quantity { value, measure } = self.quantity(e, place)?;
        let unit = match measure {
            Measure::Of(dimension, _) if self.has_units => dimension.to_string(),
            _ => String::new(),
        };
        Ok((value, unit))
    }

    /// Lowers an output: a number, the position of a point, or the rotation of a body. Each component has its unit.
    fn output(
        &mut self,
        e: &ast::Expr,
        place: &Place<'g>,
        bodies: &[ast::Body],
        poses: &Poses<'g>,
    ) -> Result<(OutputShape, Vec<(Expr<'g>, String)>), Reported> {
        match &e.kind {
            ExprKind::Name(name) if self.names.kind(&name.to_string()) == Some(Kind::Point) => {
                let [position, _] = self.point_named(name)?.symbols();
                let components = position.0.map(|x| (x, "m".to_owned()));
                Ok((OutputShape::Point, components.into()))
            }
            ExprKind::Call(function, arguments) if function == "rotation" => {
                let [
                    ast::Expr {
                        kind: ExprKind::Name(body),
                        ..
                    },
                ] = &arguments[..]
                else {
                    let fact = "`rotation` takes the name of a body";
                    return Err(self.errors.on(Code::Arguments, e, fact, "write `rotation(body)`"));
                };
                let Some(n) = self.body_named(body, bodies)? else {
                    let fact = "`ground` does not turn";
                    return Err(self
                        .errors
                        .at(Code::Arguments, body.span(), fact, "name a body that moves"));
                };
                let rotation = poses.rotation(self.placed(Some(n)).flatten());
                let components = (0..3).flat_map(|j| rotation.column(j).0);
                let components = components.map(|x| (x, "1".to_owned()));
                Ok((OutputShape::Rotation, components.collect()))
            }
            _ => Ok((OutputShape::Scalar, vec![self.with_unit(e, place)?])),
        }
    }

    /// Lowers the events of a scene.
    pub(super) fn events(&mut self, declared: &[ast::Event]) -> Vec<Event<'g>> {
        let mut events = Vec::new();
        for event in declared {
            let place = place(format!("event `{}`", event.name));
            let value = match self.read(&event.value) {
                Ok(value) => self.expr(value, &place),
                Err(reported) => Err(reported),
            };
            let Ok(value) = value else { continue };
            if value.level() < Level::State {
                let fact = format_args!("event `{}` never occurs: its function is constant", event.name);
                self.errors.at(
                    Code::Unused,
                    event.name.span(),
                    fact,
                    "build it from coordinates, points, rates or the time",
                );
            }
            events.push(Event {
                name: event.name.to_string(),
                docs: event.docs.clone(),
                value,
                is_kink: false,
            });
        }
        events
    }

    /// Rejects outputs and events whose functions have the name of another function or constant of the model.
    pub(super) fn check_functions(&mut self, items: &ast::Items) {
        let outputs = items.outputs.iter().map(|output| (&output.name, "output"));
        let events = items.events.iter().map(|event| (&event.name, "event"));
        let mut taken: BTreeMap<String, String> = BTreeMap::new();
        for (_, coordinate) in items.bodies.iter().flat_map(|body| body.fields.slots()) {
            let constants = places(&coordinate);
            taken.extend(constants.map(|constant| (constant, format!("coordinate `{coordinate}`"))));
        }
        for state in &items.states {
            taken.insert(constant(&state.name.to_string()), format!("state `{}`", state.name));
        }
        for n in 0..self.clamps.len() {
            let functions = program::functions_of_event(&program::saturation(n));
            taken.extend(functions.map(|function| (function, "a `clamp`".to_owned())));
        }
        let is_hybrid = items.is_hybrid();
        for (ident, kind) in outputs.chain(events) {
            let functions = match kind {
                "output" => program::functions_of_output(ident).to_vec(),
                _ => program::functions_of_event(ident).to_vec(),
            };
            for function in functions {
                let is_given = program::is_function(&function, is_hybrid) || FACTS.contains(&function.as_str());
                let owner = match taken.get(&function) {
                    Some(owner) => owner.as_str(),
                    None if is_given => "every model",
                    None => {
                        taken.insert(function, format!("{kind} `{ident}`"));
                        continue;
                    }
                };
                let fact = format_args!("{kind} `{ident}` needs the name `{function}`, which {owner} already has");
                self.errors
                    .at(Code::NameTaken, ident.span(), fact, "choose another name");
                break;
            }
        }
    }
}

fn place<'g>(what: String) -> Place<'g> {
    Place {
        only: Only::State,
        ..Place::moving(what)
    }
}
