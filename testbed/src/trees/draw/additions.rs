//! Parts that are drawn last: solids, inputs, outputs and events.

use super::{Draw, moving};
use crate::trees::{Action, Event, Form, Matter, Moves, Name, Number, Output, Point, Solid, Torque, Tree, Triple};

impl Draw {
    /// Replaces the mass properties of some bodies by solids.
    pub(super) fn add_solids(&mut self, tree: &mut Tree) {
        for body in &mut tree.bodies {
            let Some(Matter::Lump { mass, .. }) = body.matter else {
                continue;
            };
            if !self.chance(0.2) {
                continue;
            }
            let form = self.form();
            let mut solids = vec![Solid { mass, form }];
            if self.chance(0.3) {
                let (mass, form) = (self.mass(), self.form());
                let mass = self.number(mass);
                solids.push(Solid { mass, form });
            }
            body.matter = Some(Matter::Solids(solids));
        }
    }

    fn form(&mut self) -> Form {
        match self.below(7) {
            0 => Form::Point(self.vector(0.75)),
            1 => Form::Rod(self.ends()),
            2 => Form::Disk(self.positive(0.5), self.vector(0.75)),
            3 => Form::Plate(self.corners()),
            4 => Form::Cuboid([(); 3].map(|()| self.positive(1.0)), self.vector(0.75)),
            5 => Form::Cylinder(self.positive(0.5), self.ends()),
            _ => Form::Sphere(self.positive(0.5), self.vector(0.75)),
        }
    }

    /// Draws two distinct points.
    fn ends(&mut self) -> [Triple; 2] {
        let from = self.vector(0.75);
        let length = self.positive(1.0).value;
        let along = self.below(3);
        let mut to = from.map(|number| Self::plain(number.value));
        to[along] = Self::plain(from[along].value + length);
        if self.chance(0.5) {
            let other = (along + 1) % 3;
            to[other] = Self::plain(to[other].value - 0.5);
        }
        [from, to]
    }

    /// Draws corners in four or five directions from a point, in cyclic order so that no sides cross; the polygon may
    /// be nonconvex.
    fn corners(&mut self) -> Vec<[Number; 2]> {
        let directions = [[4.0, 0.0], [1.0, 3.0], [-3.0, 2.0], [-2.0, -3.0], [2.0, -3.0]];
        let count = 4 + self.below(2);
        let middle = [self.value(-0.5, 0.5), self.value(-0.5, 0.5)];
        let mut corners: Vec<[Number; 2]> = Vec::new();
        for [x, y] in directions.into_iter().take(count) {
            let reach = self.value(0.0, 0.25) + 0.0625;
            corners.push([middle[0] + reach * x, middle[1] + reach * y].map(Self::plain));
        }
        if self.chance(0.5) {
            corners.reverse();
        }
        corners
    }

    /// Gives some trees one or two inputs, each of which acts in one or two places.
    pub(super) fn add_inputs(&mut self, tree: &mut Tree) {
        if !self.chance(0.3) {
            return;
        }
        for n in 0..1 + self.below(2) {
            let value = self.value(0.0, 2.0) + 0.0625;
            tree.inputs.push(value);
            let input = Number {
                name: Some(Name::Input(n)),
                ..Self::plain(value)
            };
            for _ in 0..1 + self.below(2) {
                self.let_act(input, tree);
            }
        }
    }

    fn let_act(&mut self, input: Number, tree: &mut Tree) {
        let dof = tree.dof();
        let coordinate = self.below(dof);
        match self.below(3) {
            0 => {
                let own = |moves: Moves| matches!(moves, Moves::Freely(k) | Moves::Absolutely(k) if k == coordinate);
                let body = tree
                    .bodies
                    .iter_mut()
                    .find(|body| own(body.moves))
                    .expect("a joint of every coordinate");
                body.torque = Some(match self.below(4) {
                    0 => Torque::Constant(input),
                    1 => Torque::Cubic(input),
                    2 => Torque::Pumped(input),
                    _ => Torque::Cosine(input),
                });
            }
            1 => {
                let (b, c) = (self.below(dof), input);
                tree.actions.push(Action::Along { a: coordinate, b, c });
            }
            _ => {
                let point = self.point_that_moves(tree);
                let mut force = self.vector(2.0);
                force[self.below(3)] = input;
                let within = self.chance(0.4).then(|| self.below(tree.bodies.len()));
                tree.actions.push(Action::Force { point, force, within });
            }
        }
    }

    /// Gives some trees outputs and events.
    pub(super) fn add_observed(&mut self, tree: &mut Tree) {
        let count = if self.chance(0.35) { 1 + self.below(2) } else { 0 };
        for _ in 0..count {
            let output = match self.below(4) {
                0 => Output::Position(self.point_that_moves(tree)),
                1 => Output::Rotation(self.below(tree.bodies.len())),
                2 => Output::Velocity(self.point_that_moves(tree)),
                _ => Output::Mixed {
                    point: self.point_that_moves(tree),
                    axes: [(); 3].map(|()| self.below(3)),
                    c: self.positive(2.0),
                },
            };
            tree.outputs.push(output);
        }
        if self.chance(0.2) {
            let point = self.point_that_moves(tree);
            let (axis, level) = (self.below(3), self.positive(1.0));
            tree.events.push(Event { point, axis, level });
        }
    }

    /// Returns a point on a body: an existing one, or a new one.
    fn point_that_moves(&mut self, tree: &mut Tree) -> usize {
        let of_bodies: Vec<usize> = (0..tree.points.len())
            .filter(|&n| tree.points[n].body.is_some())
            .collect();
        if !of_bodies.is_empty() && self.chance(0.5) {
            return of_bodies[self.below(of_bodies.len())];
        }
        let moving = moving(&tree.bodies);
        tree.points.push(Point {
            body: Some(moving[self.below(moving.len())]),
            at: self.vector(1.0),
        });
        tree.points.len() - 1
    }
}
