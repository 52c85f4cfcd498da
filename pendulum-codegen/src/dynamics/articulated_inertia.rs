//! The inertia of articulated bodies, in the notation of `articulated.rs`.

use std::ops::{Add, Mul};

use super::frames::Frame;
use super::links::Link;
use crate::expr::Expr;
use crate::screw::{MassMoments, Mat3, Symmetric3, Twist, Wrench};

/// The inertia of a link whose outer joints give way: `moment = rotation alpha + coupling a`, `force = coupling^T alpha
/// + translation a`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Articulated<'g> {
    rotation: Symmetric3<'g>,
    coupling: Mat3<'g>,
    pub(super) translation: Symmetric3<'g>,
}

/// What a joint gives way by.
#[derive(Clone, Copy, Debug)]
pub(super) struct Joint<'g> {
    /// The articulated inertia times the joint's screw.
    pub(super) momentum: Wrench<'g>,
    /// One over the inertia along the joint.
    pub(super) mobility: Expr<'g>,
}

impl<'g> Articulated<'g> {
    /// `[J, [h]; -[h], m 1]` of a link alone.
    pub(super) fn rigid(inertia: &MassMoments<'g>) -> Self {
        Self {
            rotation: inertia.rotational(),
            coupling: Mat3::cross(inertia.first),
            translation: Symmetric3::diagonal([inertia.mass; 3]),
        }
    }

    /// `U = I s` and `1 / s^T U`.
    pub(super) fn give_way(&self, link: &Link<'g>) -> Joint<'g> {
        let momentum = *self * link.screw;
        Joint {
            momentum,
            mobility: momentum.power(&link.screw).recip(),
        }
    }

    /// The inertia that is left when the joint gives way: `I_a = I - U U^T / d`.
    pub(super) fn without(&self, link: &Link<'g>, joint: &Joint<'g>) -> Self {
        let Wrench { moment, force } = joint.momentum;
        let given = joint.mobility * joint.momentum;
        // a push along the joint meets no resistance any more: exactly, and not up to rounding
        let (no_turn, no_slide) = (link.turns() && link.pitch().is_zero(), !link.turns());
        let less = |entry: Expr<'g>, a: Expr<'g>, b: Expr<'g>, vanishes: bool| {
            let product = a * b;
            if vanishes {
                entry.graph().zero()
            } else {
                entry - product
            }
        };
        let (rotation, coupling, translation) = (self.rotation.full(), self.coupling, self.translation.full());
        Self {
            rotation: Symmetric3::from_fn(|i, j| less(rotation[i][j], moment[i], given.moment[j], no_turn && j == 2)),
            translation: Symmetric3::from_fn(|i, j| {
                less(translation[i][j], force[i], given.force[j], no_slide && j == 2)
            }),
            coupling: Mat3::from_fn(|i, j| {
                let vanishes = (no_turn && i == 2) || (no_slide && j == 2);
                less(coupling[i][j], moment[i], given.force[j], vanishes)
            }),
        }
    }

    /// The same inertia about the origin of the parent, in its frame: `X^T I X`.
    pub(super) fn to_parent(self, frame: &Frame<'g>) -> Self {
        let [rotation, translation] = [self.rotation, self.translation].map(|tensor| frame.tensor_to_parent(tensor));
        let coupling = frame.matrix_to_parent(self.coupling);
        // with [o] the cross product by the offset: H' = H + [o] M, J' = J - H [o] + [o] H'^T
        let o = Mat3::cross(frame.offset);
        let moved = coupling + o * translation.full();
        let (left, right) = (coupling * o, o * moved.transpose());
        Self {
            rotation: rotation + Symmetric3::from_fn(|i, j| right[i][j] - left[i][j]),
            coupling: moved,
            translation,
        }
    }
}

impl Add for Articulated<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            rotation: self.rotation + other.rotation,
            coupling: self.coupling + other.coupling,
            translation: self.translation + other.translation,
        }
    }
}

/// The wrench that an acceleration takes.
impl<'g> Mul<Twist<'g>> for Articulated<'g> {
    type Output = Wrench<'g>;
    fn mul(self, Twist { angular, linear }: Twist<'g>) -> Wrench<'g> {
        let (turned, coupled) = (self.rotation * angular, self.coupling * linear);
        let (swept, moved) = (self.coupling.transpose() * angular, self.translation * linear);
        Wrench {
            moment: turned + coupled,
            force: swept + moved,
        }
    }
}
