//! A robot: links, and joints that tie them together.

use std::collections::BTreeSet;

use super::number::ZERO;

/// A robot as its file describes it.
#[derive(Debug, Default)]
pub(super) struct Robot {
    pub(super) links: Vec<Link>,
    pub(super) joints: Vec<Joint>,
    /// Elements that say nothing about the motion, and those that are not taken over.
    pub(super) left_out: BTreeSet<String>,
}

/// A link.
#[derive(Debug)]
pub(super) struct Link {
    pub(super) name: String,
    /// The line of its element in the file.
    pub(super) line: usize,
    pub(super) inertial: Option<Inertial>,
}

/// The mass properties of a link.
#[derive(Clone, Debug)]
pub(super) struct Inertial {
    pub(super) origin: Origin,
    pub(super) mass: String,
    /// `[ixx, iyy, izz, ixy, ixz, iyz]`
    pub(super) inertia: [String; 6],
}

/// A place and an orientation.
#[derive(Clone, Debug)]
pub(super) struct Origin {
    pub(super) xyz: [String; 3],
    pub(super) rpy: [String; 3],
}

/// A joint.
#[derive(Debug)]
pub(super) struct Joint {
    pub(super) name: String,
    /// The line of its element in the file.
    pub(super) line: usize,
    pub(super) kind: Kind,
    pub(super) origin: Origin,
    pub(super) parent: String,
    pub(super) child: String,
    pub(super) axis: [String; 3],
    /// The least and the largest coordinate.
    pub(super) limits: Option<[String; 2]>,
    /// The largest force along it, and the largest rate; infinite where none is given.
    pub(super) most: [f64; 2],
    /// Viscous and dry friction.
    pub(super) damping: Option<String>,
    pub(super) friction: Option<String>,
    pub(super) mimic: Option<Mimic>,
}

impl Joint {
    /// The axes along which a planar joint slides; any where its own is none of the three.
    pub(super) fn in_plane(&self) -> [&'static str; 2] {
        match self.axis.each_ref().map(|number| number == ZERO) {
            [false, ..] => ["y", "z"],
            [_, false, _] => ["x", "z"],
            _ => ["x", "y"],
        }
    }
}

/// How a joint moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Fixed,
    Turns,
    Slides,
    /// It moves in all ways.
    Floats,
    /// It moves in the plane across its axis.
    Planar,
}

impl Kind {
    /// Whether it has more than one coordinate.
    pub(super) fn has_many(self) -> bool {
        matches!(self, Self::Floats | Self::Planar)
    }
}

/// A joint that follows another.
#[derive(Debug)]
pub(super) struct Mimic {
    pub(super) joint: String,
    pub(super) multiplier: String,
    pub(super) offset: String,
}
