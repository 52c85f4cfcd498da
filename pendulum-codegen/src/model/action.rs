//! What acts on a scene beside its joints.

use super::{BodyId, CoordinateId};
use crate::expr::{Expr, Formula};
use crate::screw::Vec3;

/// A place on a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place<'g> {
    /// The body; none for ground.
    pub body: Option<BodyId>,
    /// Where in its frame.
    pub at: Vec3<'g>,
}

/// A force at a place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Push<'g> {
    /// Where it acts.
    pub place: Place<'g>,
    /// The force.
    pub force: Vec3<'g>,
    /// The body in whose frame the force is given; none for ground.
    pub frame: Option<BodyId>,
}

/// What acts on a scene.
#[derive(Clone, Debug)]
pub(crate) enum Action<'g> {
    /// A force along a coordinate, and how it was written.
    Along(CoordinateId, Expr<'g>, Formula),
    /// Minus the slope of a potential energy by each coordinate.
    Potential(Expr<'g>),
    /// Minus the slope of a function by each rate.
    Dissipation(Expr<'g>),
    /// A force along a value, and that value.
    Press(Expr<'g>, Expr<'g>),
    /// A force at a place.
    Push(Push<'g>),
    /// A spring or a damper between two places `a` and `b`: the force `factor (b - a)` on the first, and its opposite
    /// on the second.
    Between {
        /// The two places.
        ends: [Place<'g>; 2],
        /// The force for each unit of distance.
        factor: Expr<'g>,
        /// The potential energy of a spring.
        potential: Option<Expr<'g>>,
    },
}

impl<'g> Action<'g> {
    /// Its potential energy, if it has one.
    pub(crate) fn potential(&self) -> Option<Expr<'g>> {
        match *self {
            Self::Potential(potential) => Some(potential),
            Self::Between { potential, .. } => potential,
            _ => None,
        }
    }

    /// The expressions that it is made of.
    pub(super) fn expressions(&mut self) -> Vec<&mut Expr<'g>> {
        match self {
            Self::Along(_, x, _) | Self::Potential(x) | Self::Dissipation(x) => vec![x],
            Self::Press(force, value) => vec![force, value],
            Self::Push(push) => push.force.0.iter_mut().collect(),
            Self::Between { factor, potential, .. } => potential.iter_mut().chain([factor]).collect(),
        }
    }
}
