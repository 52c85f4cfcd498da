//! Random trees.

mod additions;

use super::{Action, Body, Joint, Law, Matter, Moves, Name, Number, Point, Sense, Torque, Tree, Triple};
use crate::random::Random;

/// Distribution of masses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Every moving body has mass, and the masses are within a factor of 64.
    Even,
    /// Some bodies are massless, and masses differ by factors of up to a million.
    Uneven,
}

impl Tree {
    /// Draws a tree with up to `most` coordinates. Its mass matrix may be singular.
    pub fn draw(seed: u64, kind: Kind, most: usize) -> Self {
        Draw {
            random: Random::new(seed),
            kind,
            parameters: Vec::new(),
        }
        .tree(most)
    }
}

struct Draw {
    random: Random,
    kind: Kind,
    parameters: Vec<f64>,
}

impl Draw {
    fn below(&mut self, count: usize) -> usize {
        (self.random.between(0.0, count as f64) as usize).min(count - 1)
    }

    /// Returns true with probability `part`.
    fn chance(&mut self, part: f64) -> bool {
        self.random.between(0.0, 1.0) < part
    }

    /// Draws a multiple of 1/16.
    fn value(&mut self, low: f64, high: f64) -> f64 {
        (self.random.between(low, high) * 16.0).round() / 16.0
    }

    fn plain(value: f64) -> Number {
        Number {
            value: value + 0.0,
            name: None,
        }
    }

    /// Makes a number, sometimes a parameter.
    fn number(&mut self, value: f64) -> Number {
        let name = self.chance(0.08).then(|| {
            self.parameters.push(value + 0.0);
            Name::Parameter(self.parameters.len() - 1)
        });
        Number {
            name,
            ..Self::plain(value)
        }
    }

    fn positive(&mut self, high: f64) -> Number {
        let value = self.value(0.0, high) + 0.0625;
        self.number(value)
    }

    /// Draws a vector, often with zero components.
    fn vector(&mut self, reach: f64) -> Triple {
        let sparse = self.chance(0.5);
        std::array::from_fn(|_| {
            if sparse && self.chance(0.6) {
                return Self::plain(0.0);
            }
            let value = self.value(-reach, reach);
            self.number(value)
        })
    }

    /// Draws a coordinate axis, or any direction.
    fn axis(&mut self) -> Triple {
        let letter = self.chance(0.5);
        let mut axis = [0.0; 3];
        if letter {
            axis[self.below(3)] = if self.chance(0.7) { 1.0 } else { -1.0 };
        } else {
            axis = std::array::from_fn(|_| f64::from(self.below(7) as u8) - 3.0);
            if axis == [0.0; 3] {
                axis = [1.0, -2.0, 2.0];
            }
        }
        axis.map(Self::plain)
    }

    fn tree(mut self, most: usize) -> Tree {
        let dof = 1 + self.below(most);
        // in a third of the trees all revolute axes are parallel, as absolute angles require
        let common = self.chance(0.33).then(|| self.axis());
        let gravity = match self.below(4) {
            0 => [0.0, 0.0, 0.0].map(Self::plain),
            1 => [0.0, -9.8125, 0.0].map(Self::plain),
            2 => [0.0, 0.0, -9.8125].map(Self::plain),
            _ => self.vector(10.0),
        };
        let mut bodies: Vec<Body> = Vec::new();
        let mut coordinates = 0;
        while coordinates < dof {
            let moving = self.chance(0.8);
            let driven = moving && self.chance(0.1);
            let body = self.body(&bodies, common.as_ref(), moving, driven, coordinates);
            coordinates += usize::from(moving && !driven);
            bodies.push(body);
        }
        // the last body of each branch must have mass
        let bare: Vec<usize> = (0..bodies.len())
            .filter(|&n| bodies[n].matter.is_none() && bodies.iter().all(|body| body.parent != Some(n)))
            .collect();
        for n in bare {
            let mass = self.mass();
            self.fill(&mut bodies[n], mass);
        }
        let moving = moving(&bodies);
        let count = if self.chance(0.3) { 2 + self.below(3) } else { 0 };
        let points: Vec<Point> = (0..count)
            .map(|n| Point {
                body: (n > 0).then(|| moving[self.below(moving.len())]),
                at: self.vector(1.0),
            })
            .collect();
        let actions = self.actions(&points, &bodies, dof);
        let mut tree = Tree {
            gravity,
            bodies,
            points,
            actions,
            outputs: Vec::new(),
            events: Vec::new(),
            parameters: Vec::new(),
            inputs: Vec::new(),
        };
        // last, so that trees of earlier versions keep their other properties
        self.add_solids(&mut tree);
        self.add_inputs(&mut tree);
        self.add_observed(&mut tree);
        tree.parameters = self.parameters;
        tree.drop_unused();
        tree
    }

    fn mass(&mut self) -> f64 {
        match self.kind {
            Kind::Even => 0.125 * f64::from(1u32 << self.below(7)),
            Kind::Uneven => f64::from(1u32 << self.below(21)) / 1024.0,
        }
    }

    fn body(&mut self, bodies: &[Body], common: Option<&Triple>, moving: bool, driven: bool, k: usize) -> Body {
        // mostly chains
        let parent = match bodies.len() {
            0 => None,
            n if self.chance(0.7) => Some(n - 1),
            n => Some(self.below(n + 1)).filter(|&parent| parent < n),
        };
        let at = self.chance(0.7).then(|| self.vector(1.0));
        let rpy = if common.is_none() && self.chance(0.3) {
            Some(self.rpy())
        } else {
            None
        };
        let (joint, turns) = match (moving, common) {
            (false, _) => (Joint::Fixed, None),
            (true, None) => (self.joint(), None),
            (true, Some(common)) => self.joint_about(common),
        };
        let moves = match (moving, driven) {
            (false, _) => Moves::Never,
            (true, true) => Moves::ByLaw([Law::Still, Law::Swings, Law::Drifts][self.below(3)]),
            (true, false) if turns.is_some() && self.chance(0.4) => Moves::Absolutely(k),
            (true, false) => Moves::Freely(k),
        };
        let mut body = Body {
            parent,
            at,
            rpy,
            joint,
            moves,
            turns,
            matter: None,
            friction: None,
            spring: None,
            torque: None,
        };
        let light = match self.kind {
            Kind::Even => !moving || driven,
            Kind::Uneven => true,
        };
        if !(light && self.chance(0.3)) {
            let mass = self.mass();
            self.fill(&mut body, mass);
        }
        if moving && !driven {
            body.friction = self.chance(0.3).then(|| self.positive(1.0));
            body.spring = self.chance(0.2).then(|| {
                let rest = self.value(-1.0, 1.0);
                [self.positive(8.0), self.number(rest)]
            });
            body.torque = self.chance(0.2).then(|| {
                let c = self.positive(2.0);
                match self.below(4) {
                    0 => Torque::Constant(c),
                    1 => Torque::Sine(c),
                    2 => Torque::Cubic(c),
                    _ => Torque::Pumped(c),
                }
            });
        }
        body
    }

    fn rpy(&mut self) -> Triple {
        let sparse = self.chance(0.5);
        std::array::from_fn(|_| {
            let zero = sparse && self.chance(0.6);
            Self::plain(if zero { 0.0 } else { self.value(-3.0, 3.0) })
        })
    }

    fn joint(&mut self) -> Joint {
        let axis = self.axis();
        match self.below(10) {
            0..5 => Joint::Revolute(axis),
            5..7 => Joint::Prismatic(axis),
            7..9 => {
                let pitch = self.value(-0.5, 0.5);
                Joint::Helical(axis, self.number(pitch))
            }
            _ => {
                let slides = self.chance(0.2);
                let linear = self.axis();
                Joint::Screw(if slides { [Self::plain(0.0); 3] } else { axis }, linear)
            }
        }
    }

    /// Draws a prismatic joint, or a revolute one about the direction `common` or against it.
    fn joint_about(&mut self, common: &Triple) -> (Joint, Option<Sense>) {
        if self.chance(0.25) {
            return (Joint::Prismatic(self.axis()), None);
        }
        let (sense, sign) = match self.chance(0.75) {
            true => (Sense::About, 1.0),
            false => (Sense::Against, -1.0),
        };
        let axis = common.map(|number| Self::plain(sign * number.value));
        if self.chance(0.15) {
            let pitch = self.value(-0.5, 0.5);
            return (Joint::Helical(axis, self.number(pitch)), Some(sense));
        }
        (Joint::Revolute(axis), Some(sense))
    }

    /// Gives a body mass, and usually an inertia.
    fn fill(&mut self, body: &mut Body, mass: f64) {
        body.matter = Some(Matter::Lump {
            mass: self.number(mass),
            com: self.chance(0.85).then(|| self.vector(0.75)),
            inertia: (!self.chance(0.2)).then(|| self.inertia(mass)),
        });
    }

    /// Inertia of six point masses, at the ends of three skew rods.
    fn inertia(&mut self, mass: f64) -> [Number; 6] {
        let along_axes = self.chance(0.4);
        let mut sum = [0.0; 6];
        for n in 0..3 {
            let [x, y, z]: [f64; 3] = std::array::from_fn(|m| {
                let value = self.value(-0.5, 0.5);
                if along_axes && m != n { 0.0 } else { value }
            });
            let terms = [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z];
            sum.iter_mut().zip(terms).for_each(|(sum, term)| *sum += mass * term);
        }
        sum.map(Self::plain)
    }

    fn actions(&mut self, points: &[Point], bodies: &[Body], dof: usize) -> Vec<Action> {
        let mut actions = Vec::new();
        for n in 1..points.len() {
            if self.chance(0.4) {
                actions.push(Action::Force {
                    point: n,
                    force: self.vector(2.0),
                    within: self.chance(0.4).then(|| self.below(bodies.len())),
                });
            }
            let other = self.below(n);
            // the distance of two points of one body is constant
            if points[n].body == points[other].body {
                continue;
            }
            let between = [other, n];
            if self.chance(0.5) {
                let length = self.value(0.0, 1.0);
                actions.push(Action::Spring {
                    between,
                    stiffness: self.positive(5.0),
                    length: Self::plain(length),
                });
            }
            if self.chance(0.3) {
                actions.push(Action::Damper {
                    between,
                    coefficient: self.positive(1.0),
                });
            }
        }
        if self.chance(0.2) {
            let (a, b, c) = (self.below(dof), self.below(dof), self.positive(1.0));
            actions.push(match self.below(3) {
                0 => Action::Along { a, b, c },
                1 => Action::Potential { a, b, c },
                _ => Action::Dissipation { a, b, c },
            });
        }
        actions
    }
}

/// Bodies moved by a joint. A force on any other body has no effect, which is an error.
fn moving(bodies: &[Body]) -> Vec<usize> {
    let mut moving: Vec<usize> = Vec::new();
    for (n, body) in bodies.iter().enumerate() {
        let own = !matches!(body.moves, Moves::Never | Moves::ByLaw(Law::Still));
        if own || body.parent.is_some_and(|parent| moving.contains(&parent)) {
            moving.push(n);
        }
    }
    moving
}
