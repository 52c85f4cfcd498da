//! The declaration as written: syntax with spans, no meaning yet.

mod body;
mod expr;

use proc_macro2::TokenStream;
use syn::Ident;

pub(crate) use body::{
    Axis, Body, BodyFields, Inertia, Joint, JointKind, Properties, Robot, Shape, Solid, SolidKind, Stop,
};
pub(crate) use expr::{Expr, ExprKind, Measured, Operator, Read, Vector};

use crate::error::Reported;
use crate::units::Unit;

/// A whole declaration.
#[derive(Debug)]
pub(crate) struct Scene {
    /// What stands before the braces.
    pub head: Head,
    /// Everything between the braces.
    pub items: Items,
}

/// What stands before the braces of a declaration.
#[derive(Debug)]
pub(crate) struct Head {
    /// Documentation of the model.
    pub docs: Vec<String>,
    /// Visibility of the generated items.
    pub vis: TokenStream,
    /// Name of the model.
    pub name: Ident,
}

/// The items of a scene, by kind, each in the order of the text.
#[derive(Debug, Default)]
pub(crate) struct Items {
    /// `units: none`: units are not checked.
    pub without_units: Option<()>,
    /// Parameters.
    pub params: Vec<Param>,
    /// Acceleration of gravity.
    pub gravity: Option<Vector>,
    /// Named expressions.
    pub lets: Vec<Let>,
    /// Inputs.
    pub inputs: Vec<Input>,
    /// Mass properties under a name.
    pub shapes: Vec<Shape>,
    /// The robot that brings bodies of its own.
    pub robot: Option<Robot>,
    /// Bodies.
    pub bodies: Vec<Body>,
    /// Points of bodies.
    pub points: Vec<Point>,
    /// What acts on the scene, beside what its joints do.
    pub actions: Vec<Action>,
    /// Quantities that the model evaluates.
    pub outputs: Vec<Output>,
    /// Functions whose zeros are events.
    pub events: Vec<Event>,
    /// Walls.
    pub walls: Vec<Wall>,
    /// Joints that close loops.
    pub closures: Vec<Closure>,
    /// Whether there are more, which could not be read.
    pub unread_closures: bool,
    /// How often the word `clamp` stands in the scene.
    pub clamps: usize,
    /// The word `generate`, and what to generate.
    pub generate: Option<(Ident, Vec<Ident>)>,
}

/// `name: unit = default`
#[derive(Debug)]
pub(crate) struct Param {
    /// Documentation of the field.
    pub docs: Vec<String>,
    /// Name.
    pub name: Ident,
    /// Unit.
    pub unit: Read<Unit>,
    /// Value where none is given.
    pub default: Option<Read<Expr>>,
}

/// `let name = value,`
#[derive(Debug)]
pub(crate) struct Let {
    /// Name.
    pub name: Ident,
    /// What it stands for.
    pub value: Read<Expr>,
}

/// `input name: unit,`
#[derive(Debug)]
pub(crate) struct Input {
    /// Documentation of the field.
    pub docs: Vec<String>,
    /// Name.
    pub name: Ident,
    /// Unit.
    pub unit: Read<Unit>,
}

/// `point name on body at [x, y, z],`
#[derive(Debug)]
pub(crate) struct Point {
    /// Name.
    pub name: Ident,
    /// The body that it is a point of, or `ground`.
    pub body: Read<Ident>,
    /// Where it sits in the frame of the body; at its origin if left out.
    pub at: Option<Read<Vector>>,
}

/// Something that acts on the scene: an item of its own.
#[derive(Debug)]
pub(crate) struct Action {
    /// The word that the item begins with.
    pub word: Ident,
    /// What it does.
    pub kind: ActionKind,
}

/// What acts on a scene.
#[derive(Debug)]
pub(crate) enum ActionKind {
    /// `force on point: [fx, fy, fz] in body,`
    Push {
        /// The point.
        point: Ident,
        /// The force.
        force: Read<Vector>,
        /// The body in whose frame it is given; ground if left out.
        frame: Option<Ident>,
    },
    /// `force coordinate: e,`
    Along {
        /// The coordinate.
        coordinate: Ident,
        /// The force.
        force: Read<Expr>,
    },
    /// `spring between a and b: (stiffness, length),`
    Spring {
        /// The two points.
        ends: [Ident; 2],
        /// Its stiffness, and its length at rest.
        law: Read<(Expr, Expr)>,
    },
    /// `damper between a and b: e,`
    Damper {
        /// The two points.
        ends: [Ident; 2],
        /// The force for each unit of the rate of their distance.
        coefficient: Read<Expr>,
    },
    /// `potential: e,`
    Potential(Expr),
    /// `dissipation: e,`
    Dissipation(Expr),
}

/// `output name: value,`
#[derive(Debug)]
pub(crate) struct Output {
    /// Documentation of its functions.
    pub docs: Vec<String>,
    /// Name.
    pub name: Ident,
    /// What it is.
    pub value: Read<OutputValue>,
}

/// What an output is.
#[derive(Debug)]
pub(crate) enum OutputValue {
    /// One expression, or the name of a point.
    Scalar(Expr),
    /// A list of expressions.
    List(Vec<Expr>),
}

/// `event name: e,`
#[derive(Debug)]
pub(crate) struct Event {
    /// Documentation of its functions.
    pub docs: Vec<String>,
    /// Name.
    pub name: Ident,
    /// What passes zero.
    pub value: Read<Expr>,
}

/// `wall name { gap: e, restitution: e, slow: e }`
#[derive(Debug)]
pub(crate) struct Wall {
    /// Name.
    pub name: Ident,
    /// What stands in the braces.
    pub fields: WallFields,
    /// The error in a field that could not be read, if there is one: something may be missing.
    pub unread: Option<Reported>,
}

/// The fields of a wall.
#[derive(Debug, Default)]
pub(crate) struct WallFields {
    /// What never turns negative.
    pub gap: Option<Expr>,
    /// How much of the rate remains after an impact.
    pub restitution: Option<Expr>,
    /// Below this rate nothing rebounds.
    pub slow: Option<Expr>,
}

/// `close body at [x, y, z] to body at [x, y, z]: revolute(z),`
#[derive(Debug)]
pub(crate) struct Closure {
    /// The word that the item begins with.
    pub word: Ident,
    /// The two places that coincide.
    pub ends: [End; 2],
    /// How one may move against the other.
    pub joint: Read<JointKind>,
}

/// `body at [x, y, z] rpy [x, y, z]`
#[derive(Debug)]
pub(crate) struct End {
    /// The body, or `ground`.
    pub body: Ident,
    /// Where in its frame; at its origin if left out.
    pub at: Option<Read<Vector>>,
    /// How the frame of the joint is turned in that of the body.
    pub rpy: Option<Read<Vector>>,
}

/// Coordinates and motions of the largest scene: the time of expansion grows with about their third power.
pub(crate) const MOST_MOTIONS: usize = 128;

impl Items {
    /// The number of coordinates of joints, those that depend included, and of motions.
    pub(crate) fn motions(&self) -> usize {
        let of = |body: &Body| {
            let of_orientation = 2 * usize::from(body.fields.orientation.is_some());
            body.fields.slots().len() + of_orientation + usize::from(body.fields.motion.is_some())
        };
        self.bodies.iter().map(of).sum()
    }

    /// Whether something may hold the motion: dry friction, a stop, or a wall.
    pub(crate) fn is_hybrid(&self) -> bool {
        let is_constrained = |body: &Body| body.fields.dry_friction.is_some() || body.fields.stop.is_some();
        !self.walls.is_empty() || self.bodies.iter().any(is_constrained)
    }

    /// Whether the joint of a body has a motion in which the time stands.
    pub(crate) fn is_driven(&self, body: &Body) -> bool {
        let is_time = |kind: &ExprKind| matches!(kind, ExprKind::Name(name) if name == "t");
        let motion = body.fields.motion.as_ref();
        motion.is_some_and(|motion| self.uses(motion, &is_time))
    }

    /// Whether the joint of a body has a motion in which a coordinate stands.
    pub(crate) fn follows(&self, body: &Body) -> bool {
        let coordinates = || self.bodies.iter().filter_map(|body| body.fields.coordinate.as_ref());
        let is_coordinate = |kind: &ExprKind| matches!(kind, ExprKind::Name(name) if coordinates().any(|c| c == name));
        let motion = body.fields.motion.as_ref();
        motion.is_some_and(|motion| self.uses(motion, &is_coordinate))
    }

    /// Whether an operation stands in an expression, or in what its names stand for.
    pub(crate) fn uses(&self, e: &Expr, operation: &impl Fn(&ExprKind) -> bool) -> bool {
        // a `let` may use those before it
        let mut using: Vec<&Ident> = Vec::new();
        for item in &self.lets {
            if item.value.as_ref().is_ok_and(|value| value.uses(&using, operation)) {
                using.push(&item.name);
            }
        }
        e.uses(&using, operation)
    }
}
