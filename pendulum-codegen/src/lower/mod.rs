//! Lowering of the syntax to a typed scene: names are resolved, joints and masses become screws and inertias, and all
//! expressions share one graph.

mod action;
mod body;
mod clamp;
mod close;
mod components;
mod constraint;
mod declare;
mod expr;
mod fit;
mod force;
mod free_joint;
mod freedom;
mod generate;
mod heading;
mod joint;
mod joint_units;
mod mass;
mod measure;
mod motion;
mod name;
mod open;
mod order;
mod output;
mod physical;
mod places;
mod plate;
mod point;
mod scope;
mod shape;
mod solid;
mod written;

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::Span;

use crate::ast::{Items, MOST_BODIES, MOST_MOTIONS, Read, Scene, Vector};
use crate::error::{Code, Errors, Reported};
use crate::expr::{Definition, Derivative, Expr, Graph, Level, SymbolKind};
use crate::model::{BodyId, Coordinate, Figure, Model, Poses, Rule, Tree, along_motion};
use crate::screw::Vec3;
use components::Components;
use constraint::constrain;
use expr::Place;
use generate::Has;
use motion::Motion;
use point::Declared;
use scope::Names;
pub(crate) use scope::reserved;

/// Result of lowering a scene.
#[derive(Debug)]
pub(crate) struct Lowered<'g> {
    /// The typed scene.
    pub model: Model<'g>,
    /// Source locations for later errors.
    pub spans: Spans,
}

/// Source locations, for errors that are found after lowering.
#[derive(Debug, Default)]
pub(crate) struct Spans {
    /// Name of each body of the model.
    pub bodies: Vec<Span>,
    /// Name of each parameter.
    pub parameters: Vec<Span>,
    /// Name of each input.
    pub inputs: Vec<Span>,
    /// Name of each wall.
    pub walls: Vec<Span>,
}

/// State of the lowering of one scene.
#[derive(Debug)]
struct Lower<'g> {
    graph: &'g Graph,
    names: Names<'g>,
    errors: Errors,
    /// Names whose declaration had an error. Their uses are not reported again.
    broken: BTreeMap<String, Reported>,
    rules: Vec<Rule<'g>>,
    /// Rules that defaults must satisfy but `new` does not check, because other values may be intended.
    for_defaults: Vec<Rule<'g>>,
    spans: Spans,
    time: Expr<'g>,
    /// True if units are checked.
    has_units: bool,
    /// Declared points.
    points: BTreeMap<String, Declared<'g>>,
    /// Components of the orientations and positions, by name.
    components: BTreeMap<String, Components<'g>>,
    /// Figures of the solids that were lowered last.
    figures: Vec<Figure<'g>>,
    /// Values that saturate, each with its lower and upper limit.
    clamps: Vec<[Expr<'g>; 3]>,
    /// Names of the bodies.
    body_names: Vec<String>,
    /// Motion of the joint of each declared body, if it has one.
    motions: Vec<Option<Result<Motion<'g>, Reported>>>,
    /// Index in the model of each declared body, unless it has an error.
    bodies: Vec<Option<BodyId>>,
    /// Names of the bodies that each closed loop ties, and the symbol of its margin.
    margins: Vec<([String; 2], Expr<'g>)>,
    /// True if all loop closures were parsed without errors.
    has_all_loops: bool,
    /// Time derivative of expressions in coordinates, points and the time.
    along_motion: Derivative<'g>,
}

/// Lowers a scene, with its expressions in `graph`. Errors are added to those from parsing.
pub(crate) fn lower<'g>(graph: &'g Graph, scene: &Scene, mut errors: Errors) -> Result<Lowered<'g>, Errors> {
    check_size(&scene.items, &mut errors)?;
    let time = graph.symbol("t", SymbolKind::Time);
    let lower = Lower {
        graph,
        names: Names::default(),
        errors,
        broken: BTreeMap::new(),
        rules: Vec::new(),
        for_defaults: Vec::new(),
        spans: Spans::default(),
        time,
        has_units: scene.items.without_units.is_none(),
        points: BTreeMap::new(),
        components: BTreeMap::new(),
        body_names: scene.items.bodies.iter().map(|body| body.name.to_string()).collect(),
        figures: Vec::new(),
        clamps: Vec::new(),
        motions: Vec::new(),
        bodies: Vec::new(),
        margins: Vec::new(),
        has_all_loops: !scene.items.unread_closures,
        along_motion: Derivative::along([]),
    };
    lower.scene(scene)
}

/// Rejects scenes whose expansion would take too long.
fn check_size(items: &Items, errors: &mut Errors) -> Result<(), Errors> {
    let (bodies, motions) = (items.bodies.len(), items.motions());
    let (fact, help) = if bodies > MOST_BODIES {
        (
            format!("{bodies} bodies are declared, but at most {MOST_BODIES} are supported"),
            "merge bodies that are fixed to each other",
        )
    } else if motions > MOST_MOTIONS {
        (
            format!("{motions} coordinates and motions are declared, but at most {MOST_MOTIONS} are supported"),
            "fix joints that are not needed by `joint: fixed`, or split the mechanism into several models",
        )
    } else {
        return Ok(());
    };
    let last = items.bodies.last();
    let span = last.map_or_else(Span::call_site, |body| body.name.span());
    errors.at(Code::TooLong, span, fact, help);
    Err(std::mem::take(errors))
}

impl<'g> Lower<'g> {
    fn scene(mut self, scene: &Scene) -> Result<Lowered<'g>, Errors> {
        let items = &scene.items;
        let (mut tree, lets) = self.tree(items);
        let states = std::mem::take(&mut tree.states);
        let walls = self.walls(items);
        let has = Has {
            parameters: !tree.parameters.is_empty(),
            inputs: !tree.inputs.is_empty(),
            drives: !tree.drives.is_empty(),
            loops: !items.closures.is_empty(),
            orientations: tree.has_orientations(),
            coordinates: !items.bodies.is_empty(),
            states: !states.is_empty(),
        };
        tree.generate = self.generate(scene, has);
        tree.points = self.points(&items.points);
        tree.states = self.state_rates(&items.states, states);
        if tree.generate.contains("shapes") {
            // drawn points count as used
            tree.points.iter().for_each(|point| self.names.mark_used(&point.name));
        }
        tree.actions = self.actions(items, &tree.points);
        if items.bodies.is_empty() && !tree.states.is_empty() {
            self.report_without_bodies(items);
        }
        let loops = self.close(items, &mut tree);
        let outputs = self.outputs(items, &Poses::new(&tree));
        let mut events = self.events(&items.events);
        events.extend(self.saturations());
        self.check_functions(items);
        let constraints = constrain(&mut tree, walls);
        self.require_motion(scene, &tree);
        self.report_refused_defaults(&items.params, &tree.parameters);
        self.report_unused(items);
        let most = items.robot.iter().flat_map(|robot| &robot.most);
        let most: BTreeMap<&str, [f64; 2]> = most.map(|(name, most)| (name.as_str(), *most)).collect();
        let of = |coordinate: &Coordinate<'g>| most.get(coordinate.name.as_str()).copied();
        let all: Vec<Option<[f64; 2]>> = tree.coordinates.iter().map(of).collect();
        let is_limited = all.iter().any(Option::is_some);
        let most = all.into_iter().filter(|_| is_limited);
        let mut model = Model {
            name: scene.head.name.to_string(),
            docs: scene.head.docs.clone(),
            repaired: items
                .robot
                .as_ref()
                .map_or_else(Vec::new, |robot| robot.repaired.clone()),
            most: most.map(|most| most.unwrap_or([f64::INFINITY; 2])).collect(),
            lets,
            tree,
            loops,
            constraints,
            outputs,
            events,
            rules: self.rules,
        };
        let spans = self.spans;
        self.errors.finish(())?;
        model.resolve_points();
        Ok(Lowered { model, spans })
    }

    /// Lowers the declarations and the bodies. Points, actions, loops and outputs follow later.
    fn tree(&mut self, items: &Items) -> (Tree<'g>, Vec<Definition>) {
        let parameters = self.parameters(&items.params);
        let inputs = self.inputs(&items.inputs);
        let states = self.states(&items.states);
        let lets = self.declare_lets(&items.lets);
        let order = self.order(&items.bodies);
        let coordinates = self.coordinates(&items.bodies, 0, false);
        let dependents = self.coordinates(&items.bodies, coordinates.len(), true);
        self.check_places(items);
        self.declare_points(items);
        self.declare_margins(items);
        let points = self.points.values().map(Declared::symbols);
        self.along_motion = along_motion(self.time, coordinates.iter().chain(&dependents), points);
        self.lets(&items.lets);
        let gravity = self.gravity(items.gravity.as_ref());
        let drives = self.drives(&items.bodies, coordinates.len());
        self.number_behind(coordinates.len(), drives.len());
        let shapes = self.shapes(&items.shapes);
        let mut tree = Tree {
            graph: self.graph,
            parameters,
            inputs,
            states,
            coordinates,
            drives,
            dependents,
            closures: Vec::new(),
            time: self.time,
            gravity,
            bodies: Vec::new(),
            points: Vec::new(),
            actions: Vec::new(),
            generate: BTreeSet::new(),
        };
        let all: Vec<Coordinate<'g>> = tree.all_coordinates().cloned().collect();
        tree.bodies = self.bodies(&items.bodies, order, &all, &shapes);
        self.check_conditions(items);
        (tree, lets)
    }

    /// Returns a part of the source, or the report of its syntax error.
    fn read<'a, T>(&mut self, part: &'a Read<T>) -> Result<&'a T, Reported> {
        part.as_ref().map_err(|error| self.errors.push(error.clone()))
    }

    fn gravity(&mut self, gravity: Option<&Vector>) -> Vec3<'g> {
        let given = gravity.and_then(|g| self.vector(g, &Place::fixed("gravity").in_unit("m/s^2")).ok());
        given.unwrap_or(Vec3::zero(self.graph))
    }

    /// Reports gravity and forces in a scene without bodies on which they could act.
    fn report_without_bodies(&mut self, items: &Items) {
        let help = "leave it out, or declare the body on which it acts";
        if let Some(gravity) = &items.gravity {
            let fact = "gravity acts on nothing: the scene has no body";
            self.errors.on(Code::Unused, &gravity.components[0], fact, help);
        }
        for action in &items.actions {
            let fact = format_args!("`{}` acts on nothing: the scene has no body", action.word);
            self.errors.at(Code::NoEffect, action.word.span(), fact, help);
        }
    }

    /// Reports a scene without motion, unless another error may be the cause.
    fn require_motion(&mut self, scene: &Scene, tree: &Tree<'g>) {
        if !self.errors.is_empty() || !tree.coordinates.is_empty() || !tree.states.is_empty() {
            return;
        }
        let name = &scene.head.name;
        let has_motions = scene.items.bodies.iter().any(|body| body.fields.motion.is_some());
        let is_driven = tree.drives.iter().any(|drive| drive.law[0].level() == Level::State);
        let (code, fact, help) = if has_motions {
            let which = if is_driven {
                "only driven joints move"
            } else {
                "nothing moves"
            };
            (
                Code::NothingMoves,
                format!("{which} in `{name}`, so it has no state"),
                "give one joint a coordinate instead of a motion",
            )
        } else if !scene.items.closures.is_empty() {
            (
                Code::NothingMoves,
                format!("closed loops leave no degree of freedom in `{name}`"),
                "close fewer loops, or add a body with an independent coordinate",
            )
        } else if scene.items.bodies.is_empty() {
            (
                Code::NoScene,
                format!("`{name}` has no body"),
                "add `body name on ground { mass: .., joint: .., coordinate: .. }`, or \
                 `state name { unit: .., rate: .. }`",
            )
        } else {
            (
                Code::NothingMoves,
                format!("nothing in `{name}` can move"),
                "give one body a joint that is not `fixed`, and a coordinate",
            )
        };
        self.errors.at(code, name.span(), fact, help);
    }

    /// Reports unused names and shapes, unless another error may hide their uses.
    fn report_unused(&mut self, items: &Items) {
        if self.errors.is_empty() {
            self.names.report_unused(&mut self.errors);
            self.report_unused_shapes(items);
        }
    }
}
