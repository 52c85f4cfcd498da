//! Traversal of all numbers, names and points of a tree.

use std::collections::BTreeSet;

use super::{Action, Body, Event, Form, Joint, Matter, Name, Number, Output, Solid, Torque, Tree};

impl Tree {
    /// Returns the tree with a parameter or an input replaced by its value.
    #[must_use]
    pub fn without(&self, gone: Name) -> Self {
        let mut tree = self.clone();
        tree.each_number(|number| number.name = number.name.filter(|name| *name != gone));
        tree.drop_unused();
        tree
    }

    /// Returns the tree without an event.
    #[must_use]
    pub fn without_event(&self, gone: usize) -> Self {
        let mut tree = self.clone();
        tree.events.remove(gone);
        tree.drop_unused();
        tree
    }

    /// Removes unused points, parameters and inputs, which a declaration must not have.
    pub(super) fn drop_unused(&mut self) {
        let mut points = BTreeSet::new();
        self.each_point(|point| {
            points.insert(*point);
        });
        keep(&mut self.points, &points);
        self.each_point(|point| *point = rank(&points, *point));

        // names used by the remaining points, too
        let (mut parameters, mut inputs) = (BTreeSet::new(), BTreeSet::new());
        self.each_number(|number| {
            match number.name {
                None => false,
                Some(Name::Parameter(n)) => parameters.insert(n),
                Some(Name::Input(n)) => inputs.insert(n),
            };
        });
        keep(&mut self.parameters, &parameters);
        keep(&mut self.inputs, &inputs);
        self.each_number(|number| {
            number.name = number.name.map(|name| match name {
                Name::Parameter(n) => Name::Parameter(rank(&parameters, n)),
                Name::Input(n) => Name::Input(rank(&inputs, n)),
            });
        });
    }

    /// Calls `see` with the index of every used point.
    fn each_point(&mut self, mut see: impl FnMut(&mut usize)) {
        for action in &mut self.actions {
            match action {
                Action::Force { point, .. } => see(point),
                Action::Spring { between, .. } | Action::Damper { between, .. } => {
                    between.iter_mut().for_each(&mut see)
                }
                Action::Along { .. } | Action::Potential { .. } | Action::Dissipation { .. } => {}
            }
        }
        for output in &mut self.outputs {
            match output {
                Output::Position(point) | Output::Velocity(point) | Output::Mixed { point, .. } => see(point),
                Output::Rotation(_) => {}
            }
        }
        self.events.iter_mut().for_each(|event| see(&mut event.point));
    }

    fn each_number(&mut self, mut see: impl FnMut(&mut Number)) {
        self.gravity.iter_mut().for_each(&mut see);
        self.bodies.iter_mut().for_each(|body| body.each_number(&mut see));
        let places = self.points.iter_mut().flat_map(|point| &mut point.at);
        places.for_each(&mut see);
        for action in &mut self.actions {
            match action {
                Action::Force { force, .. } => force.iter_mut().for_each(&mut see),
                Action::Spring { stiffness, length, .. } => [stiffness, length].into_iter().for_each(&mut see),
                Action::Damper { coefficient: c, .. }
                | Action::Along { c, .. }
                | Action::Potential { c, .. }
                | Action::Dissipation { c, .. } => see(c),
            }
        }
        for output in &mut self.outputs {
            if let Output::Mixed { c, .. } = output {
                see(c);
            }
        }
        self.events.iter_mut().for_each(|Event { level, .. }| see(level));
    }
}

impl Body {
    fn each_number(&mut self, mut see: impl FnMut(&mut Number)) {
        let triples = [&mut self.at, &mut self.rpy];
        triples.into_iter().flatten().flatten().for_each(&mut see);
        match &mut self.joint {
            Joint::Fixed => {}
            Joint::Revolute(axis) | Joint::Prismatic(axis) => axis.iter_mut().for_each(&mut see),
            Joint::Helical(axis, pitch) => axis.iter_mut().chain([pitch]).for_each(&mut see),
            Joint::Screw(angular, linear) => angular.iter_mut().chain(linear).for_each(&mut see),
        }
        match &mut self.matter {
            None => {}
            Some(Matter::Lump { mass, com, inertia }) => {
                see(mass);
                com.iter_mut().flatten().for_each(&mut see);
                inertia.iter_mut().flatten().for_each(&mut see);
            }
            Some(Matter::Solids(solids)) => solids.iter_mut().for_each(|solid| solid.each_number(&mut see)),
        }
        self.friction.iter_mut().for_each(&mut see);
        self.spring.iter_mut().flatten().for_each(&mut see);
        match &mut self.torque {
            None => {}
            Some(Torque::Constant(c) | Torque::Sine(c) | Torque::Cubic(c) | Torque::Pumped(c) | Torque::Cosine(c)) => {
                see(c)
            }
        }
    }
}

impl Solid {
    fn each_number(&mut self, mut see: impl FnMut(&mut Number)) {
        see(&mut self.mass);
        match &mut self.form {
            Form::Point(at) => at.iter_mut().for_each(see),
            Form::Rod(ends) => ends.iter_mut().flatten().for_each(see),
            Form::Disk(radius, at) | Form::Sphere(radius, at) => at.iter_mut().chain([radius]).for_each(see),
            Form::Plate(corners) => corners.iter_mut().flatten().for_each(see),
            Form::Cuboid(sides, at) => sides.iter_mut().chain(at).for_each(see),
            Form::Cylinder(radius, ends) => ends.iter_mut().flatten().chain([radius]).for_each(see),
        }
    }
}

/// Removes the unused elements.
fn keep<T>(list: &mut Vec<T>, used: &BTreeSet<usize>) {
    let mut places = 0..;
    list.retain(|_| places.next().is_some_and(|place| used.contains(&place)));
}

/// Rank of an element among the used ones.
fn rank(used: &BTreeSet<usize>, place: usize) -> usize {
    used.range(..place).count()
}
