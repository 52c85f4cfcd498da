//! Forces, potentials and dissipation other than those of the joints.

use super::{BodyId, CoordinateId};
use crate::expr::{Expr, Formula};
use crate::screw::Vec3;

/// A point fixed to a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place<'g> {
    /// Body; none for ground.
    pub body: Option<BodyId>,
    /// Position in the frame of the body.
    pub at: Vec3<'g>,
}

/// A force at a point of a body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Push<'g> {
    /// Point of application.
    pub place: Place<'g>,
    /// Force.
    pub force: Vec3<'g>,
    /// Body in whose frame the force is given; none for ground.
    pub frame: Option<BodyId>,
}

/// A force, potential energy or dissipation of a scene, other than those of its joints.
#[derive(Clone, Debug)]
pub(crate) enum Action<'g> {
    /// Force along a coordinate of the state, and its formula as written.
    Along(CoordinateId, Expr<'g>, Formula),
    /// Potential energy; minus its derivative by a coordinate is the force along it.
    Potential(Expr<'g>),
    /// Dissipation function; minus its derivative by a rate is the force along that coordinate.
    Dissipation(Expr<'g>),
    /// Force along a value, and the value: the power is the force times the rate of the value.
    Press(Expr<'g>, Expr<'g>),
    /// Force at a point.
    Push(Push<'g>),
    /// Spring or damper between points `a` and `b`: the force `factor (b - a)` on `a`, and its opposite on `b`.
    Between {
        /// End points `a` and `b`.
        ends: [Place<'g>; 2],
        /// Force per unit of distance, in N/m.
        factor: Expr<'g>,
        /// Potential energy of a spring; none for a damper.
        potential: Option<Expr<'g>>,
    },
}

impl<'g> Action<'g> {
    /// Potential energy, if it has one.
    pub(crate) fn potential(&self) -> Option<Expr<'g>> {
        match *self {
            Self::Potential(potential) => Some(potential),
            Self::Between { potential, .. } => potential,
            _ => None,
        }
    }

    /// Mutable references to all its expressions except places, which depend on parameters only.
    pub(super) fn expressions(&mut self) -> Vec<&mut Expr<'g>> {
        match self {
            Self::Along(_, x, _) | Self::Potential(x) | Self::Dissipation(x) => vec![x],
            Self::Press(force, value) => vec![force, value],
            Self::Push(push) => push.force.0.iter_mut().collect(),
            Self::Between { factor, potential, .. } => potential.iter_mut().chain([factor]).collect(),
        }
    }
}
