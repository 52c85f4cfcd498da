//! Program of a declaration with errors, which keeps uses of its model from causing further errors.

use std::collections::BTreeSet;

use syn::Ident;

use super::output::{Event, Observed, functions_of_event, functions_of_output, is_function, saturation};
use super::routine::Head;
use super::sizes::Counts;
use super::table::{ROUTINES, Request, words};
use super::{
    Block, Constraint, Drawing, Equations, Program, Quantity, Routine, Series, Slot, SlotKind, StateLayout,
    StateVariable,
};
use crate::ast::{Axis, Body, BodyFields, ExprKind, Input, Items, JointKind, Output, OutputValue, Scene};
use crate::model::{self, FACTS, MAX_CONSTRAINTS, OutputShape, constant, places};

impl Program {
    /// Program with everything that a declaration could request, for the given inputs and `unread` more coordinates:
    /// each routine computes zeros.
    pub(crate) fn blank(scene: &Scene, inputs: &[Input], unread: usize) -> Self {
        let items = &scene.items;
        let (layout, constraints) = (layout(items, unread), constraints(items));
        let names = |bodies: &mut dyn Iterator<Item = &Body>| bodies.map(|body| body.name.to_string()).collect();
        let drives: Vec<String> = names(&mut items.bodies.iter().filter(|body| items.is_driven(body)));
        let ends = items.closures.iter().map(|closure| closure.ends.each_ref());
        let mut program = Self {
            name: scene.head.name.to_string(),
            docs: scene.head.docs.clone(),
            parameters: quantities(items.params.iter().map(|item| (&item.name, &item.docs))),
            inputs: quantities(inputs.iter().map(|item| (&item.name, &item.docs))),
            rules: Vec::new(),
            checked: Block::default(),
            constants: Block::default(),
            constants_text: Vec::new(),
            routines: Vec::new(),
            outputs: Vec::new(),
            output_units: Vec::new(),
            events: Vec::new(),
            loops: ends.map(|ends| ends.map(|end| end.body.to_string())).collect(),
            open_loops: Vec::new(),
            uncounted: Vec::new(),
            drives,
            repaired: Vec::new(),
            most: Vec::new(),
            laws: Block::zeros(constraints.iter().map(Constraint::numbers).sum()),
            drawing: Some(Drawing::default()),
            series: None,
            equations: Equations::default(),
            start: Vec::new(),
            layout,
            constraints,
        };
        program.take(items);
        program
    }

    /// Adds routines, outputs, events and series to a program without any.
    fn take(&mut self, items: &Items) {
        let counts = Counts {
            state: self.layout.len(),
            freedom: self.layout.dof(),
            inputs: self.inputs.len(),
            parameters: self.parameters.len(),
            drives: self.drives.len(),
            constraints: self.constraints.len(),
            loops: self.loops.len(),
            dependents: self.layout.dependents().count(),
            ..Counts::default()
        };
        let mut words: BTreeSet<&'static str> = words().into_iter().collect();
        words.retain(|word| counts.inputs == 0 || *word != "canonical");
        let request = Request {
            counts,
            words: &words,
            time_occurs: false,
        };
        let rows = ROUTINES.iter().filter(|row| (row.wanted)(&request, row.word));
        let mut heads: Vec<Head> = rows.map(|row| row.head(&counts)).collect();

        // a name declared twice gives one function
        let mut known: BTreeSet<String> = BTreeSet::new();
        let mut is_new = |name: &String| !is_function(name, items.is_hybrid()) && known.insert(name.clone());
        let outputs = items.outputs.iter();
        let outputs = outputs.filter(|output| functions_of_output(&output.name).iter().all(&mut is_new));
        let (has_rates, outputs): (Vec<bool>, Vec<model::Output<'_>>) = outputs
            .map(|output| (has_rates(items, output), blank_output(items, output)))
            .unzip();
        let any = has_rates.contains(&true);
        for (observed, has_rates) in Observed::each_and_all(&outputs)
            .into_iter()
            .zip(has_rates.into_iter().chain([any]))
        {
            heads.extend(observed.heads(has_rates && counts.inputs > 0, counts.state));
        }
        let events = items.events.iter();
        let events = events.filter(|event| functions_of_event(&event.name).iter().all(&mut is_new));
        let events = events.map(|event| Event {
            name: event.name.to_string(),
            is_kink: false,
        });
        let saturations = (0..items.clamps).map(|n| Event {
            name: saturation(n),
            is_kink: true,
        });
        self.events = events.chain(saturations).collect();
        heads.extend(self.events.iter().map(|event| Head::of_event(&event.name, &[])));
        self.outputs = outputs.iter().flat_map(model::Output::labels).collect();
        let computes = |head: &Head| head.shapes.iter().all(|shape| !shape.is_empty());
        self.routines = heads.into_iter().filter(computes).map(Routine::blank).collect();
        self.series = (counts.inputs == 0 && counts.state > 0).then(|| Series {
            start: Block::zeros(counts.state),
            before: Block::zeros(counts.constraints),
            order: Block::zeros(counts.state),
            ..Series::default()
        });
    }
}

/// Fields with distinct names.
fn quantities<'a>(items: impl Iterator<Item = (&'a Ident, &'a Vec<String>)>) -> Vec<Quantity> {
    let mut known = BTreeSet::new();
    let fields = items.filter(|(name, _)| known.insert(*name));
    let fields = fields.map(|(name, docs)| Quantity {
        name: name.to_string(),
        docs: docs.clone(),
        unit: "1".to_owned(),
        default: Some(0.0),
    });
    fields.collect()
}

/// Layout of the coordinates that could be read, and of `unread` more.
///
/// Only the solution of the loops decides if their dependent coordinates are in the state. Here loops in a plane are
/// assumed to have a closed form.
fn layout(items: &Items, unread: usize) -> StateLayout {
    let (mut slots, mut taken) = (Vec::new(), BTreeSet::from(FACTS.map(str::to_owned)));
    let depends = |body: &&Body| body.fields.depends.is_some() && body.fields.orientation.is_none();
    let (dependent, free): (Vec<&Body>, Vec<&Body>) = items.bodies.iter().partition(depends);
    let mut coordinates: Vec<(String, SlotKind, [usize; 2])> = Vec::new();
    for body in free {
        coordinates.extend(
            body.fields
                .slots()
                .into_iter()
                .map(|(_, name)| match kind(&body.fields, &name) {
                    SlotKind::Quaternion => (name, SlotKind::Quaternion, [4, 3]),
                    kind => (name, kind, [1, 1]),
                }),
        );
    }
    coordinates.extend((0..unread).map(|n| (format!("unread{n}"), SlotKind::Angle, [1, 1])));
    if !lies_in_a_plane(items) {
        let names = dependent.iter().flat_map(|body| body.fields.slots());
        coordinates.extend(names.map(|(_, name)| (name, SlotKind::Angle, [1, 0])));
    }
    let (mut position, mut rate) = (0, coordinates.iter().map(|(_, _, [positions, _])| positions).sum());
    for (n, (name, kind, [positions, rates])) in coordinates.into_iter().enumerate() {
        // the constant of one position may have the name of another by mistake
        let mut own = |place: String, other: &str| {
            if taken.insert(place.clone()) {
                place
            } else {
                format!("{other}{n}")
            }
        };
        let [place, place_of_rate] = places(&name);
        let constants = [own(place, "__"), own(place_of_rate, "__DOT_")];
        slots.push(Slot {
            name,
            kind,
            positions: position..position + positions,
            rates: rate..rate + rates,
            constants,
            periodic: false,
            cyclic: false,
        });
        (position, rate) = (position + positions, rate + rates);
    }
    let states = items
        .states
        .iter()
        .filter(|state| taken.insert(constant(&state.name.to_string())));
    let states = (rate..).zip(states).map(|(index, state)| StateVariable {
        name: state.name.to_string(),
        docs: state.docs.clone(),
        unit: "1".to_owned(),
        index,
        constant: constant(&state.name.to_string()),
    });
    StateLayout {
        slots,
        states: states.collect(),
        autonomous: false,
    }
}

/// True if all hinges are parallel to one axis, and only hinges and slides close loops.
fn lies_in_a_plane(items: &Items) -> bool {
    let joints = items.bodies.iter().filter_map(|body| body.fields.joint.as_ref());
    let is_straight = joints.clone().all(|joint| joint.rpy.is_none());
    let ends = items.closures.iter().flat_map(|closure| &closure.ends);
    let kinds = joints
        .map(|joint| &joint.kind)
        .chain(items.closures.iter().map(|closure| &closure.joint));
    let mut hinges = BTreeSet::new();
    let fits = kinds.flatten().all(|kind| match kind {
        JointKind::Revolute(Ok(Axis::Unit { number, .. })) => {
            hinges.insert(*number);
            true
        }
        JointKind::Prismatic(_) | JointKind::Fixed => true,
        _ => false,
    });
    fits && is_straight && hinges.len() < 2 && ends.into_iter().all(|end| end.rpy.is_none())
}

fn kind(fields: &BodyFields, name: &str) -> SlotKind {
    let joint = fields.joint.as_ref().and_then(|joint| joint.kind.as_ref().ok());
    match joint {
        _ if fields.orientation.as_ref().is_some_and(|own| own == name) => SlotKind::Quaternion,
        Some(JointKind::Prismatic(_) | JointKind::Free) => SlotKind::Length,
        _ => SlotKind::Angle,
    }
}

/// Constraints with their names only.
fn constraints(items: &Items) -> Vec<Constraint> {
    let is_held = |body: &&Body| body.fields.dry_friction.is_some() || body.fields.stop.is_some();
    let joints = items
        .bodies
        .iter()
        .filter(is_held)
        .map(|body| body.fields.coordinate.as_ref().unwrap_or(&body.name));
    let names = joints.chain(items.walls.iter().map(|wall| &wall.name));
    let constraints = names.take(MAX_CONSTRAINTS).map(|name| Constraint {
        name: name.to_string(),
        rate: Vec::new(),
        low: false,
        high: false,
    });
    constraints.collect()
}

fn blank_output(items: &Items, output: &Output) -> model::Output<'static> {
    let is_point = |name: &Ident| items.points.iter().any(|point| point.name == *name);
    let shape = match &output.value {
        Ok(OutputValue::List(list)) => OutputShape::Vector(list.len()),
        Ok(OutputValue::Scalar(e)) => match &e.kind {
            ExprKind::Name(name) if is_point(name) => OutputShape::Point,
            ExprKind::Call(function, _) if function == "rotation" => OutputShape::Rotation,
            _ => OutputShape::Scalar,
        },
        Err(_) => OutputShape::Scalar,
    };
    model::Output {
        name: output.name.to_string(),
        docs: output.docs.clone(),
        shape,
        values: Vec::new(),
        units: Vec::new(),
    }
}

/// True if an output appears to depend on rates.
fn has_rates(items: &Items, output: &Output) -> bool {
    let is_rate = |kind: &ExprKind| matches!(kind, ExprKind::Call(function, _) if function == "dot");
    match &output.value {
        Ok(OutputValue::Scalar(e)) => items.uses(e, &is_rate),
        Ok(OutputValue::List(list)) => list.iter().any(|e| items.uses(e, &is_rate)),
        Err(_) => false,
    }
}
