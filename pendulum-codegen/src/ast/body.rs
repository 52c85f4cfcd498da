//! Bodies with their joints, shapes and solids, and robots from files.

use proc_macro2::{Span, TokenStream};
use syn::Ident;

use super::expr::{Expr, Read, Vector};
use crate::error::Reported;

/// `[low, high] restitution(e, slow)`
#[derive(Debug)]
pub(crate) struct Stop {
    /// Lower and upper limit of the coordinate.
    pub limits: [Expr; 2],
    /// Source text of the limits.
    pub tokens: TokenStream,
    /// Coefficient of restitution, and the impact rate below which there is no rebound.
    pub restitution: Option<(Expr, Option<Expr>)>,
}

/// `shape name { .. }`
#[derive(Debug)]
pub(crate) struct Shape {
    pub name: Ident,
    /// Mass properties that bodies of this shape take.
    pub properties: Properties,
    /// Error in a field that could not be parsed; some properties may be missing.
    pub unread: Option<Reported>,
}

/// Mass properties: either mass, centre of mass and inertia, or solids.
#[derive(Debug, Default)]
pub(crate) struct Properties {
    pub mass: Option<Expr>,
    /// Centre of mass in the body frame.
    pub com: Option<Vector>,
    /// Rotational inertia.
    pub inertia: Option<Inertia>,
    /// Solids whose mass properties add up.
    pub solids: Option<Vec<Read<Solid>>>,
}

/// `inertia: e`, `[xx, yy, zz]` or `[xx, yy, zz, xy, xz, yz]`, optionally `about joint`
#[derive(Debug)]
pub(crate) struct Inertia {
    /// One, three or six entries.
    pub entries: Vec<Expr>,
    /// Roll, pitch and yaw of the axes of the entries in the body frame.
    pub rpy: Option<Vector>,
    /// True if taken about the origin of the body frame rather than the centre of mass.
    pub about_joint: bool,
    /// True if already checked, together with the links fixed to this body.
    pub judged: bool,
    /// Source text of the entries.
    pub tokens: TokenStream,
}

/// `kind(mass, arguments)`
#[derive(Debug)]
pub(crate) struct Solid {
    /// `point`, `rod`, `disk`, ...
    pub word: Ident,
    pub mass: Expr,
    /// Kind of solid, with the other arguments.
    pub kind: Read<SolidKind>,
}

/// A solid of uniform density.
#[derive(Debug)]
pub(crate) enum SolidKind {
    /// A point mass.
    Point {
        /// Position.
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
        radius: Expr,
        /// Centre.
        at: Read<Vector>,
    },
    /// A thin plate in the xy plane.
    Plate {
        /// Corners, in order.
        corners: Vec<Read<[Expr; 2]>>,
        /// Source text of the corners.
        tokens: TokenStream,
    },
    /// A cuboid along the axes.
    Cuboid {
        /// Side lengths.
        sides: Read<Vector>,
        /// Centre.
        at: Read<Vector>,
    },
    /// A round cylinder.
    Cylinder {
        radius: Expr,
        /// Centre of one end.
        from: Read<Vector>,
        /// Centre of the other end.
        to: Read<Vector>,
    },
    /// A ball.
    Sphere {
        radius: Expr,
        /// Centre.
        at: Read<Vector>,
    },
}

/// `robot: urdf("path", limits, without dry_friction),`
#[derive(Debug)]
pub(crate) struct Robot {
    /// Path of the URDF file.
    pub path: String,
    /// Span of the path.
    pub span: Span,
    /// True if the limits of the joints become stops.
    pub limits: bool,
    /// True if the dry friction of the joints is left out.
    pub without_dry_friction: bool,
    /// True if unknown elements of the file are errors.
    pub strict: bool,
    /// True if inertias that no rigid body can have are replaced by the nearest possible ones.
    pub repair: bool,
    /// Descriptions of the repairs.
    pub repaired: Vec<String>,
    /// Maximum force and rate of coordinates for which the file gives at least one of them; a missing one is infinite.
    pub most: Vec<(String, [f64; 2])>,
    /// Error in the file; some bodies may be missing.
    pub unread: Option<Reported>,
}

/// `body name on parent: shape { .. }`
#[derive(Debug)]
pub(crate) struct Body {
    pub name: Ident,
    /// The parent body, or `ground`.
    pub parent: Read<Ident>,
    /// Name of the shape that gives its mass properties.
    pub shape: Option<Ident>,
    /// Fields in the braces.
    pub fields: BodyFields,
    /// Error in a field that could not be parsed; some fields may be missing.
    pub unread: Option<Reported>,
}

/// The fields of a body.
#[derive(Debug, Default)]
pub(crate) struct BodyFields {
    /// Mass properties given in the body itself.
    pub properties: Properties,
    /// Joint to the parent.
    pub joint: Option<Joint>,
    /// Name of the coordinate.
    pub coordinate: Option<Ident>,
    /// Name of the orientation of a ball or free joint.
    pub orientation: Option<Ident>,
    /// Name of the position of a free joint.
    pub position: Option<Ident>,
    /// The word `absolute`: the coordinate is measured from ground.
    pub absolute: Option<Ident>,
    /// The word `depends`: closed loops determine the coordinate.
    pub depends: Option<Ident>,
    /// Guess of the coordinate for assembling the loops.
    pub near: Option<Expr>,
    /// Guess of roll, pitch and yaw for assembling the loops.
    pub turned: Option<Vector>,
    /// Guess of the position for assembling the loops.
    pub placed: Option<Vector>,
    /// Prescribed motion: the coordinate as a function of time or of other coordinates.
    pub motion: Option<Expr>,
    /// Viscous friction.
    pub friction: Option<Expr>,
    /// Stiffness and rest position.
    pub spring: Option<(Expr, Expr)>,
    /// Torque or force along the joint.
    pub torque: Option<Expr>,
    /// Dry friction while sliding.
    pub dry_friction: Option<Expr>,
    /// Dry friction at rest.
    pub static_friction: Option<Expr>,
    /// Stops at the limits of the coordinate.
    pub stop: Option<Stop>,
}

impl BodyFields {
    /// Returns the names of the coordinates that the joint may add to the state, in the order of the state layout, each
    /// with the identifier that it derives from.
    pub(crate) fn slots(&self) -> Vec<(&Ident, String)> {
        let plain = self.coordinate.iter().chain(&self.orientation);
        let axes = ["x", "y", "z"];
        let position = self.position.iter();
        let of_position = position.flat_map(|p| axes.map(|axis| (p, format!("{p}.{axis}"))));
        of_position.chain(plain.map(|name| (name, name.to_string()))).collect()
    }

    /// True if the joint has coordinates.
    pub(crate) fn moves(&self) -> bool {
        self.coordinate.is_some() || self.orientation.is_some() || self.position.is_some()
    }

    /// Returns the first force along the joint, if there is one. Fixed and driven joints cannot have any.
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
    pub kind: Read<JointKind>,
    /// Position in the frame of the parent.
    pub at: Option<Vector>,
    /// Roll, pitch and yaw of the joint frame in the frame of the parent.
    pub rpy: Option<Vector>,
}

impl Joint {
    /// True if a position or an orientation is given.
    pub(crate) fn is_placed(&self) -> bool {
        self.at.is_some() || self.rpy.is_some()
    }

    /// True for a fixed joint.
    pub(crate) fn is_fixed(&self) -> bool {
        matches!(self.kind, Ok(JointKind::Fixed))
    }

    /// True for joints that rotate about all axes: they have an orientation in place of a coordinate.
    pub(crate) fn turns_freely(&self) -> bool {
        matches!(self.kind, Ok(JointKind::Ball | JointKind::Free))
    }
}

/// Kind of a joint, with its arguments.
#[derive(Debug)]
pub(crate) enum JointKind {
    /// Rotation about an axis.
    Revolute(Read<Axis>),
    /// Translation along an axis.
    Prismatic(Read<Axis>),
    /// Rotation about an axis with translation along it.
    Helical {
        axis: Read<Axis>,
        /// Translation per radian.
        pitch: Expr,
    },
    /// Motion along a general screw axis.
    Screw {
        /// Angular part of the screw axis, then the linear part.
        components: Box<[Expr; 6]>,
        /// Source text of the components.
        tokens: TokenStream,
    },
    /// Rotation about all axes.
    Ball,
    /// Rotation about all axes, and translation along all axes.
    Free,
    /// No motion.
    Fixed,
}

/// The axis of a joint.
#[derive(Debug)]
pub(crate) enum Axis {
    /// A coordinate axis.
    Unit {
        /// 0, 1 or 2 for x, y or z.
        number: usize,
        /// True for the opposite direction.
        negative: bool,
    },
    /// A general direction.
    Vector(Box<Vector>),
}
