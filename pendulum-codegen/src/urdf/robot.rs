//! Links of a robot, and joints that connect them.

use std::collections::BTreeSet;

use super::number::ZERO;

/// A robot as its file describes it.
#[derive(Debug, Default)]
pub(super) struct Robot {
    pub(super) links: Vec<Link>,
    pub(super) joints: Vec<Joint>,
    /// Names of the elements that are left out, because they do not affect the motion or are not used.
    pub(super) left_out: BTreeSet<String>,
}

#[derive(Debug)]
pub(super) struct Link {
    pub(super) name: String,
    /// Line of the element in the file.
    pub(super) line: usize,
    pub(super) inertial: Option<Inertial>,
}

/// Mass properties of a link.
#[derive(Clone, Debug)]
pub(super) struct Inertial {
    pub(super) origin: Origin,
    pub(super) mass: String,
    /// `[ixx, iyy, izz, ixy, ixz, iyz]`
    pub(super) inertia: [String; 6],
}

/// Position and orientation of a frame.
#[derive(Clone, Debug)]
pub(super) struct Origin {
    pub(super) xyz: [String; 3],
    pub(super) rpy: [String; 3],
}

#[derive(Debug)]
pub(super) struct Joint {
    pub(super) name: String,
    /// Line of the element in the file.
    pub(super) line: usize,
    pub(super) kind: Kind,
    pub(super) origin: Origin,
    pub(super) parent: String,
    pub(super) child: String,
    pub(super) axis: [String; 3],
    /// Lower and upper limit of the coordinate.
    pub(super) limits: Option<[String; 2]>,
    /// Maximum force and rate; infinite if the file gives none.
    pub(super) most: [f64; 2],
    /// Viscous friction.
    pub(super) damping: Option<String>,
    /// Dry friction.
    pub(super) friction: Option<String>,
    pub(super) mimic: Option<Mimic>,
}

impl Joint {
    /// Returns the axes along which a planar joint slides; an arbitrary pair if its own axis is no coordinate axis.
    pub(super) fn in_plane(&self) -> [&'static str; 2] {
        match self.axis.each_ref().map(|number| number == ZERO) {
            [false, ..] => ["y", "z"],
            [_, false, _] => ["x", "z"],
            _ => ["x", "y"],
        }
    }
}

/// Kind of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Fixed,
    Turns,
    Slides,
    /// Rotation about all axes, and translation along all axes.
    Floats,
    /// Motion in the plane normal to the axis.
    Planar,
}

impl Kind {
    /// True if the joint has more than one coordinate.
    pub(super) fn has_many(self) -> bool {
        matches!(self, Self::Floats | Self::Planar)
    }
}

/// Relation of a joint to the one it follows: `multiplier * joint + offset`.
#[derive(Debug)]
pub(super) struct Mimic {
    pub(super) joint: String,
    pub(super) multiplier: String,
    pub(super) offset: String,
}
