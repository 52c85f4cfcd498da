//! Syntax to meaning: names resolved, joints and masses as screws, all in one graph.

mod expr;
mod force;
mod joint;
mod mass;
mod order;
mod physical;
mod scope;
mod solid;
mod written;

use std::collections::{BTreeMap, BTreeSet};

use syn::Ident;

use crate::ast::{self, Scene};
use crate::error::{Errors, suggestion};
use crate::expr::{Definition, ExprId, Graph, Level, Printer, SymbolKind};
use crate::model::{Body, Coordinate, Input, Model, Output, Parameter, Rule, combine};
use crate::screw::{SpatialInertia, mat_vec, transpose};
use expr::Place;
use mass::{Mass, Turns};
use scope::Names;
use written::written;

/// The state of lowering one scene.
#[derive(Debug)]
struct Lower {
    graph: Graph,
    names: Names,
    errors: Errors,
    /// Names whose declaration had an error: their uses are not reported again.
    broken: BTreeSet<String>,
    rules: Vec<Rule>,
    time: ExprId,
    /// Bodies that have been lowered: their positions among the model's bodies.
    placed: BTreeMap<String, usize>,
}

/// The meaning of a scene. Errors are added to those of the reading.
pub fn lower(scene: &Scene, errors: Errors) -> Result<Model, Errors> {
    let graph = Graph::new();
    let time = graph.symbol("t", SymbolKind::Time);
    let lower = Lower {
        graph,
        names: Names::default(),
        errors,
        broken: BTreeSet::new(),
        rules: Vec::new(),
        time,
        placed: BTreeMap::new(),
    };
    lower.scene(scene)
}

impl Lower {
    fn scene(mut self, scene: &Scene) -> Result<Model, Errors> {
        let items = &scene.items;
        let parameters = self.parameters(&items.params);
        let inputs = self.inputs(&items.inputs);
        for item in &items.lets {
            // declared before its value is known, so that a use before the definition can be told from a misspelling
            self.names.declare(&mut self.errors, "`let`", &item.name, None);
        }
        let lets = items.lets.iter().map(|item| Definition {
            name: item.name.to_string().replace("r#", ""),
            formula: written(&item.value, None),
        });
        let lets = lets.collect();
        let order = self.order(&items.bodies);
        let coordinates = self.coordinates(&items.bodies);
        for item in &items.lets {
            let place = Place {
                what: format!("`{}`", item.name),
                most: Level::State,
                joint: None,
            };
            match self.expr(&item.value, &place) {
                Some(value) => self.names.set_value(&item.name.to_string(), value),
                None => _ = self.broken.insert(item.name.to_string()),
            }
        }
        let gravity = items
            .gravity
            .as_ref()
            .and_then(|g| self.vector(g, &Place::fixed("gravity")));
        let gravity = gravity.unwrap_or([self.graph.zero(); 3]);
        let shapes = self.shapes(&items.shapes);
        let mut bodies = Vec::new();
        for n in order {
            let body = &items.bodies[n];
            let own = body
                .coordinate
                .as_ref()
                .and_then(|name| coordinates.iter().position(|c| name == &c.name));
            if let Some(lowered) = self.body(body, &bodies, &coordinates, own, &shapes) {
                self.placed.insert(lowered.name.clone(), bodies.len());
                bodies.push(lowered);
            }
        }
        let outputs = self.outputs(items.generate.as_deref(), !parameters.is_empty(), !inputs.is_empty());
        if items.bodies.is_empty() && self.errors.is_empty() {
            self.errors.at(
                scene.name.span(),
                format_args!("`{}` has no body", scene.name),
                "add `body name on ground { mass: .., joint: .., coordinate: .. }`",
            );
        } else if coordinates.is_empty() && self.errors.is_empty() {
            self.errors.at(
                scene.name.span(),
                format_args!("nothing in `{}` can move", scene.name),
                "give one body a joint that is not `fixed`, and a coordinate",
            );
        }
        if self.errors.is_empty() {
            // behind another error a name may be unused only because its use could not be read
            self.names.report_unused(&mut self.errors);
            self.report_unused_shapes(items);
        }
        let Self {
            graph,
            errors,
            rules,
            time,
            ..
        } = self;
        errors.finish(Model {
            graph,
            parameters,
            inputs,
            coordinates,
            time,
            gravity,
            lets,
            bodies,
            rules,
            outputs,
        })
    }

    fn report_unused_shapes(&mut self, items: &ast::Items) {
        let used: BTreeSet<String> = items
            .bodies
            .iter()
            .filter_map(|b| b.shape.as_ref())
            .map(Ident::to_string)
            .collect();
        for shape in items
            .shapes
            .iter()
            .filter(|shape| !used.contains(&shape.name.to_string()))
        {
            self.errors.at(
                shape.name.span(),
                format_args!("shape `{}` is never used", shape.name),
                "remove it, or give it to a body: `body b on ground: shape { .. }`",
            );
        }
    }

    fn parameters(&mut self, params: &[ast::Param]) -> Vec<Parameter> {
        let mut parameters = Vec::new();
        for param in params {
            let place = Place {
                what: format!("the default of `{}`", param.name),
                most: Level::Constant,
                joint: None,
            };
            // defaults come before any name is known, so they are built from numbers alone
            let default = param
                .default
                .as_ref()
                .and_then(|e| self.expr(e, &place))
                .and_then(|id| self.graph.constant(id));
            let name = param.name.to_string();
            let symbol = self.graph.symbol(&name, SymbolKind::Parameter(parameters.len()));
            parameters.push((
                param,
                Parameter {
                    name,
                    docs: param.docs.clone(),
                    unit: param.unit.clone(),
                    default,
                    symbol,
                },
            ));
        }
        for (param, parameter) in &parameters {
            self.names
                .declare(&mut self.errors, "parameter", &param.name, Some(parameter.symbol));
        }
        parameters.into_iter().map(|(_, parameter)| parameter).collect()
    }

    fn inputs(&mut self, declared: &[ast::Input]) -> Vec<Input> {
        let mut inputs = Vec::new();
        for input in declared {
            let name = input.name.to_string();
            let symbol = self.graph.symbol(&name, SymbolKind::Input(inputs.len()));
            self.names.declare(&mut self.errors, "input", &input.name, Some(symbol));
            inputs.push(Input {
                name,
                docs: input.docs.clone(),
                unit: input.unit.clone(),
                symbol,
            });
        }
        inputs
    }

    fn coordinates(&mut self, bodies: &[ast::Body]) -> Vec<Coordinate> {
        let mut coordinates = Vec::new();
        for ident in bodies.iter().filter_map(|body| body.coordinate.as_ref()) {
            let (name, k) = (ident.to_string(), coordinates.len());
            let position = self.graph.symbol(&name, SymbolKind::Coordinate(k));
            self.names
                .declare(&mut self.errors, "coordinate", ident, Some(position));
            coordinates.push((name, position));
        }
        let rate = |k: usize, name: &String| self.graph.symbol(&format!("dot({name})"), SymbolKind::Rate(k));
        let rates: Vec<_> = coordinates
            .iter()
            .enumerate()
            .map(|(k, (name, _))| rate(k, name))
            .collect();
        for ((name, _), &rate) in coordinates.iter().zip(&rates) {
            self.names.set_rate(name, rate);
        }
        let with_rates = coordinates.into_iter().zip(rates).enumerate();
        with_rates
            .map(|(k, ((name, position), rate))| {
                let acceleration = self.graph.symbol(&format!("ddot({name})"), SymbolKind::Acceleration(k));
                Coordinate {
                    name,
                    position,
                    rate,
                    acceleration,
                }
            })
            .collect()
    }

    fn index_of_parent(&self, body: &ast::Body) -> Option<usize> {
        self.placed.get(&body.parent.to_string()).copied()
    }

    fn shapes(&mut self, declared: &[ast::Shape]) -> BTreeMap<String, Option<Mass>> {
        let mut shapes = BTreeMap::new();
        for shape in declared {
            let mass = self.mass(&shape.name, &shape.properties, shape.unread);
            if shapes.insert(shape.name.to_string(), mass).is_some() {
                self.errors.at(
                    shape.name.span(),
                    format_args!("shape `{}` is declared twice", shape.name),
                    "rename one of the two",
                );
            }
        }
        shapes
    }

    fn body(
        &mut self,
        body: &ast::Body,
        bodies: &[Body],
        coordinates: &[Coordinate],
        own: Option<usize>,
        shapes: &BTreeMap<String, Option<Mass>>,
    ) -> Option<Body> {
        let mass = self.mass_of_body(body, shapes);
        let geometry = self.geometry(&body.name, body.joint.as_ref());
        let joint_works = self.joint_fits_coordinate(body, geometry.as_ref().map(|g| g.screw.is_some()));
        let parent = self.index_of_parent(body);
        let parent_known = body.parent == "ground" || parent.is_some();
        let heading = geometry
            .as_ref()
            .filter(|_| parent_known && joint_works)
            .and_then(|geometry| {
                let parent = parent.map(|p| &bodies[p]);
                self.heading(body, parent, geometry, own)
            });
        let motion = heading.as_ref().map(|(_, motion)| motion.clone()).unwrap_or_default();
        let position = combine(&self.graph, coordinates, &motion, |c| c.position);
        let rate = combine(&self.graph, coordinates, &motion, |c| c.rate);
        let forces = self.forces(body, position, rate);
        let joint = [position, rate].map(|x| Printer::new(&self.graph).formula(x));
        let torque = body.torque.as_ref().map(|torque| written(torque, Some(&joint)));
        let ((heading, motion), geometry, forces) = (heading?, geometry?, forces?);
        let inertia = match mass? {
            None => SpatialInertia::zero(&self.graph),
            Some(mass) => {
                let turns = match (heading.station, heading.axis) {
                    (None, Some(axis)) => {
                        let back = transpose(heading.rest);
                        Turns::About(mat_vec(&self.graph, back, axis))
                    }
                    (None, None) => Turns::Never,
                    (Some(_), _) => Turns::Freely,
                };
                mass.of_body(self, &body.name, turns)?
            }
        };
        Some(Body {
            name: body.name.to_string(),
            parent,
            placement: geometry.placement,
            screw: geometry.screw,
            coordinate: own,
            motion,
            heading,
            inertia,
            force: forces.total,
            passive: forces.passive,
            torque,
            potential: forces.potential,
        })
    }

    /// The mass of a body: `Some(None)` if it has none, `None` after an error.
    fn mass_of_body(&mut self, body: &ast::Body, shapes: &BTreeMap<String, Option<Mass>>) -> Option<Option<Mass>> {
        let own = &body.properties;
        let has_own = own.mass.is_some() || own.com.is_some() || own.inertia.is_some() || own.solids.is_some();
        let Some(shape) = &body.shape else {
            return if has_own {
                self.mass(&body.name, own, body.unread).map(Some)
            } else {
                Some(None)
            };
        };
        if has_own {
            self.errors.at(
                shape.span(),
                format_args!("`{}` has a shape and mass properties of its own", body.name),
                "give either the shape, or mass, com and inertia, or solids",
            );
            return None;
        }
        match shapes.get(&shape.to_string()) {
            Some(mass) => mass.clone().map(Some),
            None => {
                let help = suggestion(&shape.to_string(), shapes.keys().map(String::as_str));
                self.errors
                    .at(shape.span(), format_args!("no shape named `{shape}`"), help);
                None
            }
        }
    }

    fn joint_fits_coordinate(&mut self, body: &ast::Body, moves: Option<bool>) -> bool {
        let name = &body.name;
        if body.unread {
            return moves == Some(body.coordinate.is_some());
        }
        match (moves, &body.coordinate) {
            (Some(true), None) => {
                self.errors.at(
                    name.span(),
                    format_args!("the joint of `{name}` moves but has no coordinate"),
                    "add `coordinate: name`, or make the joint `fixed`",
                );
                false
            }
            (Some(false), Some(coordinate)) => {
                self.errors.at(
                    coordinate.span(),
                    format_args!("the joint of `{name}` is fixed, so `{coordinate}` cannot change"),
                    "remove the coordinate, or give the joint an axis: `joint: revolute(z)`",
                );
                false
            }
            (Some(false), None) => {
                let spring = body.spring.as_ref().map(|(stiffness, _)| stiffness);
                if let Some(force) = body.friction.as_ref().or(spring).or(body.torque.as_ref()) {
                    self.errors.on(
                        force,
                        format_args!("the joint of `{name}` is fixed, so no force can act along it"),
                        "remove it, or give the joint an axis and a coordinate",
                    );
                }
                true
            }
            _ => true,
        }
    }

    fn outputs(&mut self, generate: Option<&[Ident]>, has_parameters: bool, has_inputs: bool) -> BTreeSet<Output> {
        let Some(list) = generate else {
            return [Output::Rhs, Output::Jacobian, Output::Energy].into();
        };
        let mut outputs = BTreeSet::new();
        for ident in list {
            let name = ident.to_string();
            match Output::ALL.iter().find(|(known, _)| *known == name) {
                Some((_, output)) if !outputs.insert(*output) => {
                    self.errors.at(
                        ident.span(),
                        format_args!("`{name}` is listed twice"),
                        "keep one of the two",
                    );
                }
                Some((_, Output::ParameterJacobian)) if !has_parameters => {
                    self.errors.at(
                        ident.span(),
                        "there are no parameters to derive by",
                        "declare the quantities of interest in `params { .. }`; numbers are constants",
                    );
                }
                Some((_, Output::Canonical)) if has_inputs => {
                    self.errors.at(
                        ident.span(),
                        "the canonical equations of a motion under inputs are not known: their law is given after the code is written",
                        "leave out `canonical`, or write the law into a `torque` in place of the input",
                    );
                }
                Some((_, Output::Taylor)) if has_inputs => {
                    self.errors.at(
                        ident.span(),
                        "the Taylor series of a motion under inputs is not known: their law is given after the code is written",
                        "leave out `taylor`, or write the law into a `torque` in place of the input",
                    );
                }
                Some(_) => {}
                None => {
                    let help = suggestion(&name, Output::ALL.map(|(known, _)| known));
                    self.errors
                        .at(ident.span(), format_args!("`{name}` cannot be generated"), help);
                }
            }
        }
        outputs
    }
}
