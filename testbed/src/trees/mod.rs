//! Mechanisms at random: as data, as declarations for the generator, and as equations of motion of their own.
//!
//! The generator and [`Oracle`] share no formula: it works with screws, expressions and base parameters, the oracle with
//! Newton's and Euler's equations of each body, in numbers, in the ground frame.

mod declare;
mod draw;
mod numbers;
mod oracle;

pub use draw::Kind;
pub use oracle::{Motion, Oracle};

/// A number of a declaration: as it stands, or under a name.
#[derive(Clone, Copy, Debug)]
pub struct Number {
    /// A multiple of a power of 1/2, so that a declaration has it exactly.
    pub value: f64,
    pub name: Option<Name>,
}

/// What stands in a declaration for a number that is given later.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Name {
    /// Its default is the number.
    Parameter(usize),
    Input(usize),
}

pub type Triple = [Number; 3];

/// A tree of bodies, each behind its parent.
#[derive(Clone, Debug)]
pub struct Tree {
    pub gravity: Triple,
    pub bodies: Vec<Body>,
    pub points: Vec<Point>,
    pub actions: Vec<Action>,
    pub outputs: Vec<Output>,
    pub events: Vec<Event>,
    /// The values of the parameters.
    pub parameters: Vec<f64>,
    /// A value for each input.
    pub inputs: Vec<f64>,
}

#[derive(Clone, Debug)]
pub struct Body {
    /// None is ground.
    pub parent: Option<usize>,
    pub at: Option<Triple>,
    pub rpy: Option<Triple>,
    pub joint: Joint,
    pub moves: Moves,
    /// In a scene of parallel axes how the joint turns; none where it does not.
    pub turns: Option<Sense>,
    /// None is a body without mass.
    pub matter: Option<Matter>,
    pub friction: Option<Number>,
    /// Stiffness and position at rest.
    pub spring: Option<[Number; 2]>,
    pub torque: Option<Torque>,
}

/// Whether a joint turns about a direction or against it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    About,
    Against,
}

/// How the mass of a body is declared.
#[derive(Clone, Debug)]
#[expect(clippy::large_enum_variant, reason = "most bodies are lumps")]
pub enum Matter {
    Lump {
        mass: Number,
        com: Option<Triple>,
        /// About the centre of mass, in the order of declarations: xx, yy, zz, xy, xz, yz.
        inertia: Option<[Number; 6]>,
    },
    Solids(Vec<Solid>),
}

/// A solid of uniform density.
#[derive(Clone, Debug)]
pub struct Solid {
    pub mass: Number,
    pub form: Form,
}

/// Lines from end to end; corners one after the other; all else about a centre, which comes last.
#[derive(Clone, Debug)]
pub enum Form {
    Point(Triple),
    Rod([Triple; 2]),
    Disk(Number, Triple),
    Plate(Vec<[Number; 2]>),
    Cuboid(Triple, Triple),
    Cylinder(Number, [Triple; 2]),
    Sphere(Number, Triple),
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
    /// `c*cos(q)`
    Cosine(Number),
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

/// What is observed; points and bodies by their numbers.
#[derive(Clone, Copy, Debug)]
pub enum Output {
    Position(usize),
    Rotation(usize),
    /// `[dot(point.x), dot(point.y), dot(point.z)]`
    Velocity(usize),
    /// `c*point.k + point.l*dot(point.m)` for the axes k, l, m
    Mixed {
        point: usize,
        axes: [usize; 3],
        c: Number,
    },
}

/// `point.k - level` for the axis k
#[derive(Clone, Copy, Debug)]
pub struct Event {
    pub point: usize,
    pub axis: usize,
    pub level: Number,
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
        self.bodies.iter().map(Body::mass).sum()
    }

    /// For each coordinate the mass of all bodies that its joint carries.
    pub fn masses_behind(&self) -> Vec<f64> {
        let mut carried: Vec<f64> = self.bodies.iter().map(Body::mass).collect();
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
}

impl Body {
    /// Whether its joint follows the time.
    pub fn is_driven(&self) -> bool {
        matches!(self.moves, Moves::ByLaw(Law::Swings | Law::Drifts))
    }

    pub fn mass(&self) -> f64 {
        match &self.matter {
            None => 0.0,
            Some(Matter::Lump { mass, .. }) => mass.value,
            Some(Matter::Solids(solids)) => solids.iter().map(|solid| solid.mass.value).sum(),
        }
    }

    /// By how much a turn of the joint turns the body about the direction of a scene of parallel axes.
    fn turning(&self) -> f64 {
        match self.turns {
            None => 0.0,
            Some(Sense::About) => 1.0,
            Some(Sense::Against) => -1.0,
        }
    }
}
