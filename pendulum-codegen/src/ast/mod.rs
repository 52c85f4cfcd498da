//! Syntax tree of a declaration, with spans; names are not yet resolved.

mod body;
mod expr;

use proc_macro2::TokenStream;
use syn::Ident;

pub(crate) use body::{
    Axis, Body, BodyFields, Inertia, Joint, JointKind, Properties, Robot, Shape, Solid, SolidKind, Stop,
};
pub(crate) use expr::{Expr, ExprKind, Measured, Operator, Read, Vector};

use crate::error::{Code, Reported, at};
use crate::units::Unit;

/// A whole declaration.
#[derive(Debug)]
pub(crate) struct Scene {
    /// Part before the braces.
    pub head: Head,
    /// Items between the braces.
    pub items: Items,
}

/// Part of a declaration before the braces.
#[derive(Debug)]
pub(crate) struct Head {
    /// Documentation of the model.
    pub docs: Vec<String>,
    /// Visibility of the generated items.
    pub vis: TokenStream,
    /// Name of the model.
    pub name: Ident,
}

/// Items of a scene by kind, each kind in source order.
#[derive(Debug, Default)]
pub(crate) struct Items {
    /// `units: none`: units are not checked.
    pub without_units: Option<()>,
    pub params: Vec<Param>,
    /// Acceleration of gravity.
    pub gravity: Option<Vector>,
    /// Named expressions.
    pub lets: Vec<Let>,
    pub inputs: Vec<Input>,
    /// First-order states.
    pub states: Vec<State>,
    /// Named mass properties.
    pub shapes: Vec<Shape>,
    /// Robot whose links become bodies.
    pub robot: Option<Robot>,
    pub bodies: Vec<Body>,
    /// Points of bodies.
    pub points: Vec<Point>,
    /// Forces and energies beside those of joints.
    pub actions: Vec<Action>,
    /// Quantities to evaluate.
    pub outputs: Vec<Output>,
    /// Functions whose zeros are events.
    pub events: Vec<Event>,
    pub walls: Vec<Wall>,
    /// Joints that close loops.
    pub closures: Vec<Closure>,
    /// True if there are more closing joints, which could not be parsed.
    pub unread_closures: bool,
    /// Number of occurrences of the word `clamp`.
    pub clamps: usize,
    /// The word `generate`, and the routines to generate.
    pub generate: Option<(Ident, Vec<Ident>)>,
    /// Words of `generate` that are added where the scene can have them.
    pub also: Vec<String>,
    /// True if nothing but `rhs` and the added words is generated.
    pub only: bool,
}

/// `name: unit = default`
#[derive(Debug)]
pub(crate) struct Param {
    /// Documentation of the field.
    pub docs: Vec<String>,
    pub name: Ident,
    /// Unit; none if it is missing.
    pub unit: Option<Read<Unit>>,
    /// Value unless the user gives one.
    pub default: Option<Read<Expr>>,
}

/// Error: a parameter, an input or a state has no unit. The help writes it after `key`, with the example `such`.
pub(crate) fn without_unit(kind: &str, name: &Ident, key: &str, such: &str) -> syn::Error {
    let fact = format_args!("{kind} `{name}` has no unit");
    let help = format_args!("write `{key}: {such}`, or `{key}: 1` for a plain number");
    at(Code::MissingUnit, name.span(), fact, help)
}

/// `let name = value,`
#[derive(Debug)]
pub(crate) struct Let {
    pub name: Ident,
    pub value: Read<Expr>,
}

/// `input name: unit,`
#[derive(Debug)]
pub(crate) struct Input {
    /// Documentation of the field.
    pub docs: Vec<String>,
    pub name: Ident,
    /// Unit; none if it is missing.
    pub unit: Option<Read<Unit>>,
}

/// `state name { unit: unit, rate: e }`
#[derive(Debug)]
pub(crate) struct State {
    /// Documentation of the index.
    pub docs: Vec<String>,
    pub name: Ident,
    /// Unit of the state; none if it is missing.
    pub unit: Option<Read<Unit>>,
    /// Time derivative; none if it is missing.
    pub rate: Option<Read<Expr>>,
    /// Error in a field that could not be parsed; some fields may be missing.
    pub unread: Option<Reported>,
}

/// `point name on body at [x, y, z],`
#[derive(Debug)]
pub(crate) struct Point {
    pub name: Ident,
    /// The body that it belongs to, or `ground`.
    pub body: Read<Ident>,
    /// Position in the frame of the body; its origin if left out.
    pub at: Option<Read<Vector>>,
}

/// A force or an energy of the scene, declared by an item of its own.
#[derive(Debug)]
pub(crate) struct Action {
    /// First word of the item.
    pub word: Ident,
    pub kind: ActionKind,
}

/// Kind of an action, with its arguments.
#[derive(Debug)]
pub(crate) enum ActionKind {
    /// `force on point: [fx, fy, fz] in body,`
    Push {
        point: Ident,
        force: Read<Vector>,
        /// Body whose frame the components refer to; ground if left out.
        frame: Option<Ident>,
    },
    /// `force coordinate: e,`
    Along {
        /// Coordinate of a joint.
        coordinate: Ident,
        force: Read<Expr>,
    },
    /// `spring between a and b: (stiffness, length),`
    Spring {
        /// The two points.
        ends: [Ident; 2],
        /// Stiffness and rest length.
        law: Read<(Expr, Expr)>,
    },
    /// `damper between a and b: e,`
    Damper {
        /// The two points.
        ends: [Ident; 2],
        /// Force per unit rate of the distance.
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
    pub name: Ident,
    pub value: Read<OutputValue>,
}

/// Value of an output.
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
    pub name: Ident,
    /// Function whose zeros are events.
    pub value: Read<Expr>,
}

/// `wall name { gap: e, restitution: e, slow: e }`
#[derive(Debug)]
pub(crate) struct Wall {
    pub name: Ident,
    /// Fields in the braces.
    pub fields: WallFields,
    /// Error in a field that could not be parsed; some fields may be missing.
    pub unread: Option<Reported>,
}

/// The fields of a wall.
#[derive(Debug, Default)]
pub(crate) struct WallFields {
    /// Distance to the wall, which never becomes negative.
    pub gap: Option<Expr>,
    /// Coefficient of restitution.
    pub restitution: Option<Expr>,
    /// Impact rate below which there is no rebound.
    pub slow: Option<Expr>,
}

/// `close body at [x, y, z] to body at [x, y, z]: revolute(z),`
#[derive(Debug)]
pub(crate) struct Closure {
    /// First word of the item.
    pub word: Ident,
    /// The two places to connect.
    pub ends: [End; 2],
    /// Joint between the two places.
    pub joint: Read<JointKind>,
}

/// `body at [x, y, z] rpy [x, y, z]`
#[derive(Debug)]
pub(crate) struct End {
    /// The body, or `ground`.
    pub body: Ident,
    /// Position in the frame of the body; its origin if left out.
    pub at: Option<Read<Vector>>,
    /// Roll, pitch and yaw of the joint frame in the frame of the body.
    pub rpy: Option<Read<Vector>>,
}

/// Maximum number of coordinates, states and motions of a scene; the time of expansion grows with about their third
/// power.
pub(crate) const MOST_MOTIONS: usize = 128;
/// Bodies of the largest scene: the time of expansion grows with the square of their number.
pub(crate) const MOST_BODIES: usize = 1000;

impl Items {
    /// True if the scene is small enough to be expanded.
    pub(crate) fn is_possible(&self) -> bool {
        self.bodies.len() <= MOST_BODIES && self.motions() <= MOST_MOTIONS
    }

    /// Number of joint coordinates, including dependent ones, of states and of motions.
    pub(crate) fn motions(&self) -> usize {
        let of = |body: &Body| {
            let of_orientation = 2 * usize::from(body.fields.orientation.is_some());
            body.fields.slots().len() + of_orientation + usize::from(body.fields.motion.is_some())
        };
        self.states.len() + self.bodies.iter().map(of).sum::<usize>()
    }

    /// True if the system is hybrid: with dry friction, a stop or a wall.
    pub(crate) fn is_hybrid(&self) -> bool {
        let is_constrained = |body: &Body| body.fields.dry_friction.is_some() || body.fields.stop.is_some();
        !self.walls.is_empty() || self.bodies.iter().any(is_constrained)
    }

    /// True if the joint of a body has a motion that depends explicitly on time.
    pub(crate) fn is_driven(&self, body: &Body) -> bool {
        let is_time = |kind: &ExprKind| matches!(kind, ExprKind::Name(name) if name == "t");
        let motion = body.fields.motion.as_ref();
        motion.is_some_and(|motion| self.uses(motion, &is_time))
    }

    /// True if the joint of a body has a motion that depends on a coordinate.
    pub(crate) fn follows(&self, body: &Body) -> bool {
        let coordinates = || self.bodies.iter().filter_map(|body| body.fields.coordinate.as_ref());
        let is_coordinate = |kind: &ExprKind| matches!(kind, ExprKind::Name(name) if coordinates().any(|c| c == name));
        let motion = body.fields.motion.as_ref();
        motion.is_some_and(|motion| self.uses(motion, &is_coordinate))
    }

    /// True if an expression, or a `let` that it refers to, contains an operation for which `operation` holds.
    pub(crate) fn uses(&self, e: &Expr, operation: &impl Fn(&ExprKind) -> bool) -> bool {
        // a `let` may refer to earlier ones
        let mut using: Vec<&Ident> = Vec::new();
        for item in &self.lets {
            if item.value.as_ref().is_ok_and(|value| value.uses(&using, operation)) {
                using.push(&item.name);
            }
        }
        e.uses(&using, operation)
    }
}
