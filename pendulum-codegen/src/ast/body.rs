//! Bodies with their joints, shapes and solids, and the robot that brings bodies of its own.

use proc_macro2::{Span, TokenStream};
use syn::Ident;

use super::expr::{Expr, Read, Vector};
use crate::error::Reported;

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
    /// Whether it has been judged, beside that of what moves with it.
    pub judged: bool,
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
    /// Whether each element of its file must be known.
    pub strict: bool,
    /// Whether inertias that no body can have become the nearest that one can.
    pub repair: bool,
    /// What was repaired.
    pub repaired: Vec<String>,
    /// The largest force and rate that its file gives for coordinates, infinite where it gives one alone.
    pub most: Vec<(String, [f64; 2])>,
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
    /// Whether it says where it is.
    pub(crate) fn is_placed(&self) -> bool {
        self.at.is_some() || self.rpy.is_some()
    }

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
