//! Mechanisms at random: as data, as declarations for the generator, and as equations of motion of their own.
//!
//! The generator and [`Oracle`] share no formula: it works with screws, expressions and base parameters, the oracle with
//! Newton's and Euler's equations of each body, in numbers, in the ground frame.

mod declare;
mod draw;
mod oracle;

pub use draw::Kind;
pub use oracle::{Motion, Oracle};

/// A number of a declaration: as it stands, or as the default of a parameter.
#[derive(Clone, Copy, Debug)]
pub struct Number {
    /// A multiple of a power of 1/2, so that a declaration has it exactly.
    pub value: f64,
    pub parameter: Option<usize>,
}

pub type Triple = [Number; 3];

/// A tree of bodies, each behind its parent.
#[derive(Clone, Debug)]
pub struct Tree {
    pub gravity: Triple,
    pub bodies: Vec<Body>,
    pub points: Vec<Point>,
    pub actions: Vec<Action>,
    /// The values of the parameters.
    pub parameters: Vec<f64>,
}

#[derive(Clone, Debug)]
pub struct Body {
    /// None is ground.
    pub parent: Option<usize>,
    pub at: Option<Triple>,
    pub rpy: Option<Triple>,
    pub joint: Joint,
    pub moves: Moves,
    /// In a scene of parallel axes the sense of this one; 0 where the joint does not turn.
    pub sense: f64,
    pub mass: Option<Number>,
    pub com: Option<Triple>,
    /// About the centre of mass, in the order of declarations: xx, yy, zz, xy, xz, yz.
    pub inertia: Option<[Number; 6]>,
    pub friction: Option<Number>,
    /// Stiffness and position at rest.
    pub spring: Option<[Number; 2]>,
    pub torque: Option<Torque>,
}

#[derive(Clone, Copy, Debug)]
pub enum Joint {
    Fixed,
    Revolute(Triple),
    Prismatic(Triple),
    Helical(Triple, Number),
    /// The angular and the linear part.
    Screw(Triple, Triple),
}

/// How a joint moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moves {
    /// It is fixed.
    Never,
    /// By the coordinate of this number, relative to the parent.
    Freely(usize),
    /// By the coordinate of this number, measured from ground.
    Absolutely(usize),
    /// By its law.
    ByLaw(Law),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// It stays at 3/8.
    Still,
    /// `sin(3*t/2)/2`
    Swings,
    /// `t^2/4 - t/8`
    Drifts,
}

/// A force along a joint, as a function of its own coordinate.
#[derive(Clone, Copy, Debug)]
pub enum Torque {
    /// `c`
    Constant(Number),
    /// `-c*sin(q)`
    Sine(Number),
    /// `-c*qd^3`
    Cubic(Number),
    /// `c*q*cos(2*t)`
    Pumped(Number),
}

#[derive(Clone, Debug)]
pub struct Point {
    /// None is ground.
    pub body: Option<usize>,
    pub at: Triple,
}

/// What acts across a scene; points and coordinates by their numbers.
#[derive(Clone, Copy, Debug)]
pub enum Action {
    /// A constant force, in the ground frame or in that of a body.
    Force {
        point: usize,
        force: Triple,
        within: Option<usize>,
    },
    Spring {
        between: [usize; 2],
        stiffness: Number,
        length: Number,
    },
    Damper {
        between: [usize; 2],
        coefficient: Number,
    },
    /// `-c*dot(b)^3` along `a`
    Along {
        a: usize,
        b: usize,
        c: Number,
    },
    /// `c*cos(a)*b`
    Potential {
        a: usize,
        b: usize,
        c: Number,
    },
    /// `c/2*(dot(a) + dot(b))^2`
    Dissipation {
        a: usize,
        b: usize,
        c: Number,
    },
}

impl Tree {
    /// The number of coordinates.
    pub fn dof(&self) -> usize {
        let of = |body: &&Body| matches!(body.moves, Moves::Freely(_) | Moves::Absolutely(_));
        self.bodies.iter().filter(of).count()
    }

    /// The number of joints that the time drives.
    pub fn drives(&self) -> usize {
        self.bodies.iter().filter(|body| body.is_driven()).count()
    }

    /// The mass of all bodies.
    pub fn mass(&self) -> f64 {
        self.bodies
            .iter()
            .filter_map(|body| body.mass)
            .map(|mass| mass.value)
            .sum()
    }

    /// For each coordinate the mass of all bodies that its joint carries.
    pub fn masses_behind(&self) -> Vec<f64> {
        let mut carried: Vec<f64> = self
            .bodies
            .iter()
            .map(|body| body.mass.map_or(0.0, |mass| mass.value))
            .collect();
        let mut behind = vec![0.0; self.dof()];
        for (n, body) in self.bodies.iter().enumerate().rev() {
            if let Moves::Freely(k) | Moves::Absolutely(k) = body.moves {
                behind[k] = carried[n];
            }
            if let Some(parent) = body.parent {
                carried[parent] += carried[n];
            }
        }
        behind
    }

    /// Whether the joint of a body carries another one.
    pub fn carries(&self, below: usize, body: usize) -> bool {
        let mut parents = std::iter::successors(self.bodies[body].parent, |&parent| self.bodies[parent].parent);
        parents.any(|parent| parent == below)
    }

    /// The same tree with the value of a parameter in its place.
    #[must_use]
    pub fn without_parameter(&self, gone: usize) -> Self {
        let mut tree = self.clone();
        tree.parameters.remove(gone);
        tree.each_number(|number| match &mut number.parameter {
            Some(n) if *n == gone => number.parameter = None,
            Some(n) if *n > gone => *n -= 1,
            _ => {}
        });
        tree
    }

    fn each_number(&mut self, mut see: impl FnMut(&mut Number)) {
        self.gravity.iter_mut().for_each(&mut see);
        for body in &mut self.bodies {
            let triples = [&mut body.at, &mut body.rpy, &mut body.com];
            triples.into_iter().flatten().flatten().for_each(&mut see);
            match &mut body.joint {
                Joint::Fixed => {}
                Joint::Revolute(axis) | Joint::Prismatic(axis) => axis.iter_mut().for_each(&mut see),
                Joint::Helical(axis, pitch) => axis.iter_mut().chain([pitch]).for_each(&mut see),
                Joint::Screw(angular, linear) => angular.iter_mut().chain(linear).for_each(&mut see),
            }
            body.mass.iter_mut().chain(&mut body.friction).for_each(&mut see);
            body.inertia.iter_mut().flatten().for_each(&mut see);
            body.spring.iter_mut().flatten().for_each(&mut see);
            if let Some(Torque::Constant(c) | Torque::Sine(c) | Torque::Cubic(c) | Torque::Pumped(c)) = &mut body.torque
            {
                see(c);
            }
        }
        self.points
            .iter_mut()
            .flat_map(|point| &mut point.at)
            .for_each(&mut see);
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
    }
}

impl Body {
    /// Whether its joint follows the time.
    pub fn is_driven(&self) -> bool {
        matches!(self.moves, Moves::ByLaw(Law::Swings | Law::Drifts))
    }
}
