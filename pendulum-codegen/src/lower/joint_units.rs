//! Units of the quantities of a joint, by its kind of motion.

use num_traits::Zero;

use super::measure::Measure;
use crate::ast::{self, Expr, ExprKind, JointKind};

/// Kind of motion of a joint, which determines its units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum JointUnits {
    /// Its coordinate is an angle.
    Turns,
    /// Its coordinate is a length.
    Slides,
    /// There is no joint with one coordinate, or it could not be parsed.
    Unknown,
}

impl JointUnits {
    /// Kind of motion of the joint of a body.
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

    /// Unit of the coordinate.
    pub(super) fn coordinate(self) -> Option<&'static str> {
        self.choose("rad", "m")
    }

    /// Unit of the rate.
    pub(super) fn rate(self) -> Option<&'static str> {
        self.choose("rad/s", "m/s")
    }

    /// Unit of a force along the joint.
    pub(super) fn force(self) -> Option<&'static str> {
        self.choose("N m", "N")
    }

    /// Unit of a stiffness: force per unit of the coordinate.
    pub(super) fn stiffness(self) -> Option<&'static str> {
        self.choose("N m/rad", "N/m")
    }

    /// Unit of a friction coefficient: force per unit of the rate.
    pub(super) fn friction(self) -> Option<&'static str> {
        self.choose("N m s/rad", "N s/m")
    }

    /// Measure of the coordinate.
    pub(super) fn measure(self) -> Measure {
        self.coordinate().map_or(Measure::Unknown, Measure::of)
    }

    /// Corresponding unit of a joint with the other kind of motion, and the verb for that motion.
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

/// True if an expression is the number zero.
pub(super) fn is_zero(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Number(n) => n.is_zero(),
        ExprKind::Measured(measured) => measured.number.is_zero(),
        ExprKind::Neg(a) => is_zero(a),
        _ => false,
    }
}
