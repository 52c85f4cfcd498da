//! The units of what belongs to a joint, by how it moves.

use num_traits::Zero;

use super::measure::Measure;
use crate::ast::{self, Expr, ExprKind, JointKind};

/// How a joint moves, as far as its units go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum JointUnits {
    /// Its coordinate is an angle.
    Turns,
    /// Its coordinate is a length.
    Slides,
    /// It has no joint that moves, or one that could not be read.
    Unknown,
}

impl JointUnits {
    /// Those of the joint of a body.
    pub(super) fn of(body: &ast::Body) -> Self {
        let kind = body.fields.joint.as_ref().map(|joint| joint.kind.as_ref());
        match kind {
            Some(Ok(JointKind::Revolute(_) | JointKind::Helical { .. })) => Self::Turns,
            Some(Ok(JointKind::Prismatic(_))) => Self::Slides,
            Some(Ok(JointKind::Screw { components, .. })) => {
                let [wx, wy, wz, ..] = &**components;
                if [wx, wy, wz].into_iter().all(is_zero) {
                    Self::Slides
                } else {
                    Self::Turns
                }
            }
            _ => Self::Unknown,
        }
    }

    /// That of the coordinate.
    pub(super) fn coordinate(self) -> Option<&'static str> {
        self.choose("rad", "m")
    }

    /// That of the rate.
    pub(super) fn rate(self) -> Option<&'static str> {
        self.choose("rad/s", "m/s")
    }

    /// That of a force along it.
    pub(super) fn force(self) -> Option<&'static str> {
        self.choose("N m", "N")
    }

    /// That of a force for each unit of the coordinate.
    pub(super) fn stiffness(self) -> Option<&'static str> {
        self.choose("N m/rad", "N/m")
    }

    /// That of a force for each unit of the rate.
    pub(super) fn friction(self) -> Option<&'static str> {
        self.choose("N m s/rad", "N s/m")
    }

    /// What the coordinate is measured in.
    pub(super) fn measure(self) -> Measure {
        self.coordinate().map_or(Measure::Unknown, Measure::of)
    }

    /// The unit in the place of one that a joint has, if it moved the other way, and how that is.
    pub(super) fn other(unit: &str) -> Option<(&'static str, &'static str)> {
        let pairs = [Self::stiffness, Self::friction].map(|of| [of(Self::Turns), of(Self::Slides)]);
        pairs.into_iter().find_map(|[turning, sliding]| {
            if turning == Some(unit) {
                Some((sliding?, "slide"))
            } else {
                (sliding == Some(unit)).then_some((turning?, "turn"))
            }
        })
    }

    fn choose(self, turning: &'static str, sliding: &'static str) -> Option<&'static str> {
        match self {
            Self::Turns => Some(turning),
            Self::Slides => Some(sliding),
            Self::Unknown => None,
        }
    }
}

/// Whether an expression is the number zero.
pub(super) fn is_zero(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Number(n) => n.is_zero(),
        ExprKind::Measured(measured) => measured.number.is_zero(),
        ExprKind::Neg(a) => is_zero(a),
        _ => false,
    }
}
