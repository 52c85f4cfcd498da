//! The declaration as written: syntax with spans, no meaning yet.

use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use syn::Ident;

use crate::error::Reported;
use crate::expr::Rational;
use crate::units::Unit;

/// A part of the text, or why it cannot be read. The error is reported when lowering comes to it, in line with others
/// of the body.
pub(crate) type Read<T> = syn::Result<T>;

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

/// `[low, high] restitution(e, slow)`
#[derive(Debug)]
pub(crate) struct Stop {
    /// The least and the largest coordinate.
    pub limits: [Expr; 2],
    /// Their text.
    pub tokens: TokenStream,
    /// How much of the rate remains after an impact, and below which rate nothing rebounds.
    pub restitution: Option<(Expr, Option<Expr>)>,
}

/// `shape name { .. }`
#[derive(Debug)]
pub(crate) struct Shape {
    /// Name.
    pub name: Ident,
    /// What it weighs.
    pub properties: Properties,
    /// The error in a field that could not be read, if there is one: something may be missing.
    pub unread: Option<Reported>,
}

/// Mass properties: either mass, centre of mass and inertia, or solids.
#[derive(Debug, Default)]
pub(crate) struct Properties {
    /// Mass.
    pub mass: Option<Expr>,
    /// Centre of mass in the body frame.
    pub com: Option<Vector>,
    /// Rotational inertia.
    pub inertia: Option<Inertia>,
    /// Solids that add up.
    pub solids: Option<Vec<Read<Solid>>>,
}

/// `inertia: e`, `[xx, yy, zz]` or `[xx, yy, zz, xy, xz, yz]`, perhaps `about joint`
#[derive(Debug)]
pub(crate) struct Inertia {
    /// One, three or six entries.
    pub entries: Vec<Expr>,
    /// How the axes of the entries are turned against those of the body frame.
    pub rpy: Option<Vector>,
    /// About the origin of the body frame rather than about the centre of mass.
    pub about_joint: bool,
    /// The text of the entries.
    pub tokens: TokenStream,
}

/// `kind(mass, arguments)`
#[derive(Debug)]
pub(crate) struct Solid {
    /// `point`, `rod`, `disk`, ...
    pub word: Ident,
    /// Mass.
    pub mass: Expr,
    /// The rest.
    pub kind: Read<SolidKind>,
}

/// A solid of uniform density.
#[derive(Debug)]
pub(crate) enum SolidKind {
    /// A point mass.
    Point {
        /// Where it sits.
        at: Read<Vector>,
    },
    /// A thin rod.
    Rod {
        /// One end.
        from: Read<Vector>,
        /// The other end.
        to: Read<Vector>,
    },
    /// A thin disk about the z direction.
    Disk {
        /// Radius.
        radius: Expr,
        /// Its centre.
        at: Read<Vector>,
    },
    /// A thin plate in the xy plane.
    Plate {
        /// Its corners, in order.
        corners: Vec<Read<[Expr; 2]>>,
        /// Their text.
        tokens: TokenStream,
    },
    /// A cuboid along the axes.
    Cuboid {
        /// Its lengths.
        sides: Read<Vector>,
        /// Its centre.
        at: Read<Vector>,
    },
    /// A round cylinder.
    Cylinder {
        /// Radius.
        radius: Expr,
        /// The centre of one end.
        from: Read<Vector>,
        /// The centre of the other end.
        to: Read<Vector>,
    },
    /// A ball.
    Sphere {
        /// Radius.
        radius: Expr,
        /// Its centre.
        at: Read<Vector>,
    },
}

/// `robot: urdf("path", limits, without dry_friction),`
#[derive(Debug)]
pub(crate) struct Robot {
    /// Where its file is.
    pub path: String,
    /// Where that is written.
    pub span: Span,
    /// Whether the limits of its joints are stops.
    pub limits: bool,
    /// Whether its joints have no dry friction.
    pub without_dry_friction: bool,
    /// What was wrong with the file: some of its bodies may be missing.
    pub unread: Option<Reported>,
}

/// `body name on parent: shape { .. }`
#[derive(Debug)]
pub(crate) struct Body {
    /// Name.
    pub name: Ident,
    /// The body that carries it, or `ground`.
    pub parent: Read<Ident>,
    /// The shape it takes.
    pub shape: Option<Ident>,
    /// What stands in the braces.
    pub fields: BodyFields,
    /// The error in a field that could not be read, if there is one: something may be missing.
    pub unread: Option<Reported>,
}

/// The fields of a body.
#[derive(Debug, Default)]
pub(crate) struct BodyFields {
    /// Its own mass properties.
    pub properties: Properties,
    /// How it hangs on its parent.
    pub joint: Option<Joint>,
    /// Name of the coordinate.
    pub coordinate: Option<Ident>,
    /// Name of the orientation of a joint that turns freely.
    pub orientation: Option<Ident>,
    /// Name of the position of a joint that moves freely.
    pub position: Option<Ident>,
    /// Whether the coordinate is measured from ground: the word `absolute`.
    pub absolute: Option<Ident>,
    /// Whether closed loops determine the coordinate: the word `depends`.
    pub depends: Option<Ident>,
    /// The coordinate where the loops are assembled.
    pub near: Option<Expr>,
    /// Roll, pitch and yaw of the orientation there.
    pub turned: Option<Vector>,
    /// The position there.
    pub placed: Option<Vector>,
    /// The coordinate as a function of time, of a joint that is driven.
    pub motion: Option<Expr>,
    /// Viscous friction.
    pub friction: Option<Expr>,
    /// Stiffness and rest position.
    pub spring: Option<(Expr, Expr)>,
    /// Joint force.
    pub torque: Option<Expr>,
    /// Dry friction.
    pub dry_friction: Option<Expr>,
    /// Dry friction at rest.
    pub static_friction: Option<Expr>,
    /// Limits of the coordinate.
    pub stop: Option<Stop>,
}

impl BodyFields {
    /// The names of the coordinates that the joint may bring into the state, as the layout of the state has them, each
    /// with the word it is named after.
    pub(crate) fn slots(&self) -> Vec<(&Ident, String)> {
        let plain = self.coordinate.iter().chain(&self.orientation);
        let axes = ["x", "y", "z"];
        let position = self.position.iter();
        let of_position = position.flat_map(|p| axes.map(|axis| (p, format!("{p}.{axis}"))));
        of_position.chain(plain.map(|name| (name, name.to_string()))).collect()
    }

    /// Whether the joint has coordinates.
    pub(crate) fn moves(&self) -> bool {
        self.coordinate.is_some() || self.orientation.is_some() || self.position.is_some()
    }

    /// What acts along the joint, if anything does: it must move by itself.
    pub(crate) fn acting(&self) -> Option<&TokenStream> {
        let spring = self.spring.as_ref().map(|(stiffness, _)| stiffness);
        let forces = [
            self.friction.as_ref(),
            spring,
            self.torque.as_ref(),
            self.dry_friction.as_ref(),
            self.static_friction.as_ref(),
        ];
        forces.into_iter().flatten().map(|force| &force.tokens).next()
    }
}

/// `kind(arguments) at point rpy angles`
#[derive(Debug)]
pub(crate) struct Joint {
    /// How it moves.
    pub kind: Read<JointKind>,
    /// Where it sits in the parent's frame.
    pub at: Option<Vector>,
    /// How its frame is turned.
    pub rpy: Option<Vector>,
}

impl Joint {
    /// Whether it does not move.
    pub(crate) fn is_fixed(&self) -> bool {
        matches!(self.kind, Ok(JointKind::Fixed))
    }

    /// Whether it turns about all axes, so that it has an orientation and no coordinate.
    pub(crate) fn turns_freely(&self) -> bool {
        matches!(self.kind, Ok(JointKind::Ball | JointKind::Free))
    }
}

/// How a joint moves.
#[derive(Debug)]
pub(crate) enum JointKind {
    /// It turns about an axis.
    Revolute(Read<Axis>),
    /// It slides along an axis.
    Prismatic(Read<Axis>),
    /// It turns about an axis and slides along it.
    Helical {
        /// The axis.
        axis: Read<Axis>,
        /// How far it slides in a radian.
        pitch: Expr,
    },
    /// It moves along any screw.
    Screw {
        /// The angular part of the screw, then the linear one.
        components: Box<[Expr; 6]>,
        /// Their text.
        tokens: TokenStream,
    },
    /// It turns about all axes.
    Ball,
    /// It turns about all axes, and slides along all.
    Free,
    /// It does not move.
    Fixed,
}

/// The axis of a joint.
#[derive(Debug)]
pub(crate) enum Axis {
    /// A coordinate axis.
    Unit {
        /// 0, 1 or 2 for x, y or z.
        number: usize,
        /// Whether it points backwards.
        negative: bool,
    },
    /// A direction.
    Vector(Box<Vector>),
}

/// Three components.
#[derive(Debug)]
pub(crate) struct Vector {
    /// The components.
    pub components: [Expr; 3],
    /// The text.
    pub tokens: TokenStream,
}

/// An expression with its text.
#[derive(Debug)]
pub(crate) struct Expr {
    /// The outermost operation.
    pub kind: ExprKind,
    /// The text.
    pub tokens: TokenStream,
}

/// An operation of the language of expressions.
#[derive(Debug)]
pub(crate) enum ExprKind {
    /// A number, exactly.
    Number(Rational),
    /// `90 deg`.
    Measured(Box<Measured>),
    /// A name.
    Name(Ident),
    /// `point.x`: a point, an orientation or a position, and the word behind the dot.
    Component(Ident, Ident),
    /// `dot(orientation).x`, likewise.
    RateComponent(Ident, Ident),
    /// `function(arguments)`.
    Call(Ident, Vec<Expr>),
    /// `-a`.
    Neg(Box<Expr>),
    /// `a + b` and so on.
    Binary(Operator, Box<Expr>, Box<Expr>),
    /// `a^b`.
    Power(Box<Expr>, Box<Expr>),
}

/// A number with a unit.
#[derive(Debug)]
pub(crate) struct Measured {
    /// The number as it is written.
    pub digits: String,
    /// The number, exactly, in that unit.
    pub number: Rational,
    /// The unit.
    pub unit: Unit,
}

/// As it is written.
impl std::fmt::Display for Measured {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", self.digits, self.unit.text)
    }
}

/// An operator between two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operator {
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
}

impl Items {
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

impl Expr {
    /// Whether an operation, or one of some names, stands in the expression.
    fn uses(&self, names: &[&Ident], operation: &impl Fn(&ExprKind) -> bool) -> bool {
        let of = |e: &Self| e.uses(names, operation);
        let in_parts = match &self.kind {
            ExprKind::Name(name) => names.contains(&name),
            ExprKind::Call(_, arguments) => arguments.iter().any(of),
            ExprKind::Neg(a) => of(a),
            ExprKind::Binary(_, a, b) | ExprKind::Power(a, b) => of(a) || of(b),
            ExprKind::Number(_) | ExprKind::Measured(..) | ExprKind::Component(..) | ExprKind::RateComponent(..) => {
                false
            }
        };
        in_parts || operation(&self.kind)
    }
}

impl ToTokens for Expr {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.tokens.to_tokens(tokens);
    }
}

impl ToTokens for Vector {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.tokens.to_tokens(tokens);
    }
}

impl Expr {
    /// Where the expression begins.
    pub(crate) fn span(&self) -> Span {
        self.tokens
            .clone()
            .into_iter()
            .next()
            .map_or_else(Span::call_site, |token| token.span())
    }
}
