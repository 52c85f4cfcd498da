//! Inertia of articulated bodies, in the notation of `articulated.rs`.

use std::ops::{Add, Mul};

use super::frames::Frame;
use super::links::Link;
use crate::expr::Expr;
use crate::screw::{MassMoments, Mat3, Symmetric3, Twist, Wrench};

/// Inertia of a link whose outer joints yield: `moment = rotation alpha + coupling a`,
/// `force = coupling^T alpha + translation a`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Articulated<'g> {
    rotation: Symmetric3<'g>,
    coupling: Mat3<'g>,
    pub(super) translation: Symmetric3<'g>,
}

/// Projection of an articulated inertia on a joint.
#[derive(Clone, Copy, Debug)]
pub(super) struct Joint<'g> {
    /// Articulated inertia times the screw of the joint, `U`.
    pub(super) momentum: Wrench<'g>,
    /// Reciprocal of the inertia along the joint, `1/d`.
    pub(super) mobility: Expr<'g>,
}

impl<'g> Articulated<'g> {
    /// Inertia `[J, [h]; -[h], m 1]` of a single link.
    pub(super) fn rigid(inertia: &MassMoments<'g>) -> Self {
        Self {
            rotation: inertia.rotational(),
            coupling: Mat3::cross(inertia.first),
            translation: Symmetric3::diagonal([inertia.mass; 3]),
        }
    }

    /// Computes `U = I s` and `1 / s^T U`.
    pub(super) fn give_way(&self, link: &Link<'g>) -> Joint<'g> {
        let momentum = *self * link.screw;
        Joint {
            momentum,
            mobility: momentum.power(&link.screw).recip(),
        }
    }

    /// Inertia that remains when the joint yields: `I_a = I - U U^T / d`.
    pub(super) fn without(&self, link: &Link<'g>, joint: &Joint<'g>) -> Self {
        let Wrench { moment, force } = joint.momentum;
        let given = joint.mobility * joint.momentum;
        // the inertia along the joint vanishes exactly, and not only up to rounding
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

    /// Transforms the inertia to the frame and the origin of the parent: `X^T I X`.
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

/// Wrench required for an acceleration.
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
