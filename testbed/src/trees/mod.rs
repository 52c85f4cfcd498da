//! Random mechanisms: as data, as declarations for the generator, and as independent equations of motion.
//!
//! The generator and [`Oracle`] share no formula: the generator uses screws, expressions and base parameters; the
//! oracle uses the Newton-Euler equations of each body, numerically, in the ground frame.

mod declare;
mod draw;
mod numbers;
mod oracle;

pub use draw::Kind;
pub use oracle::{Motion, Oracle};

/// Number in a declaration: literal or named.
#[derive(Clone, Copy, Debug)]
pub struct Number {
    /// Multiple of a power of 1/2, which a declaration represents exactly.
    pub value: f64,
    pub name: Option<Name>,
}

/// Name in a declaration for a number whose value is set later.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Name {
    /// Parameter, whose default is the number.
    Parameter(usize),
    Input(usize),
}

pub type Triple = [Number; 3];

/// Tree of bodies; each body comes after its parent.
#[derive(Clone, Debug)]
pub struct Tree {
    pub gravity: Triple,
    pub bodies: Vec<Body>,
    pub points: Vec<Point>,
    pub actions: Vec<Action>,
    pub outputs: Vec<Output>,
    pub events: Vec<Event>,
    /// Values of the parameters.
    pub parameters: Vec<f64>,
    /// Value of each input.
    pub inputs: Vec<f64>,
}

#[derive(Clone, Debug)]
pub struct Body {
    /// Parent body; `None` is ground.
    pub parent: Option<usize>,
    pub at: Option<Triple>,
    pub rpy: Option<Triple>,
    pub joint: Joint,
    pub moves: Moves,
    /// In scenes with parallel axes, the sense of rotation of the joint; `None` if it does not rotate.
    pub turns: Option<Sense>,
    /// Mass and its distribution; `None` for a massless body.
    pub matter: Option<Matter>,
    pub friction: Option<Number>,
    /// Stiffness and rest position.
    pub spring: Option<[Number; 2]>,
    pub torque: Option<Torque>,
}

/// Sense of rotation: about the common direction or against it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    About,
    Against,
}

/// Declared mass of a body.
#[derive(Clone, Debug)]
#[expect(clippy::large_enum_variant, reason = "most bodies are lumps")]
pub enum Matter {
    Lump {
        mass: Number,
        com: Option<Triple>,
        /// Inertia about the centre of mass, in the order of declarations: xx, yy, zz, xy, xz, yz.
        inertia: Option<[Number; 6]>,
    },
    Solids(Vec<Solid>),
}

/// Solid of uniform density.
#[derive(Clone, Debug)]
pub struct Solid {
    pub mass: Number,
    pub form: Form,
}

/// Shape of a solid: lines by their ends, plates by their corners in order, the others with the centre as last
/// argument.
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
    /// Screw with its angular and linear part.
    Screw(Triple, Triple),
}

/// Motion of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moves {
    /// Fixed.
    Never,
    /// Coordinate of this index, relative to the parent.
    Freely(usize),
    /// Coordinate of this index, measured from ground.
    Absolutely(usize),
    /// Prescribed by a law.
    ByLaw(Law),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Constant at 3/8.
    Still,
    /// `sin(3*t/2)/2`
    Swings,
    /// `t^2/4 - t/8`
    Drifts,
}

/// Force along a joint, as a function of its own coordinate.
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
    /// Body of the point; `None` is ground.
    pub body: Option<usize>,
    pub at: Triple,
}

/// Force across a scene; points and coordinates by their indices.
#[derive(Clone, Copy, Debug)]
pub enum Action {
    /// A constant force, in ground or body coordinates.
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

/// Output of a scene; points and bodies by their indices.
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
    /// Number of coordinates.
    pub fn dof(&self) -> usize {
        let of = |body: &&Body| matches!(body.moves, Moves::Freely(_) | Moves::Absolutely(_));
        self.bodies.iter().filter(of).count()
    }

    /// Number of driven joints.
    pub fn drives(&self) -> usize {
        self.bodies.iter().filter(|body| body.is_driven()).count()
    }

    /// Total mass of all bodies.
    pub fn mass(&self) -> f64 {
        self.bodies.iter().map(Body::mass).sum()
    }

    /// For each coordinate, the mass of all bodies that its joint carries.
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

    /// True if `body` is carried by the joint of `below`.
    pub fn carries(&self, below: usize, body: usize) -> bool {
        let mut parents = std::iter::successors(self.bodies[body].parent, |&parent| self.bodies[parent].parent);
        parents.any(|parent| parent == below)
    }
}

impl Body {
    /// True if the joint is driven by the time.
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

    /// Angle by which a unit of the joint turns the body about the common direction of a scene with parallel axes.
    fn turning(&self) -> f64 {
        match self.turns {
            None => 0.0,
            Some(Sense::About) => 1.0,
            Some(Sense::Against) => -1.0,
        }
    }
}
