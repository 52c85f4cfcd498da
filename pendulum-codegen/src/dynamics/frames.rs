//! Frames in which links are computed.
//!
//! A link on its own has a frame that turns with it. Parallel links in a row share the frame before the first of them,
//! in which their angles add up and no rotation is needed between them.

use super::joint::JointId;
use super::links::Link;
use crate::model::{Combination, Model};
use crate::screw::{MassMoments, Mat3, Symmetric3, Turn, Twist, Vec3, Wrench};

/// Frame in which a link is computed: at its origin, in the orientation of its station.
#[derive(Clone, Debug)]
pub(super) struct Frame<'g> {
    /// Rotation relative to the frame of the parent; `None` if the two share a station.
    turned: Option<Turned<'g>>,
    /// Rotation of the body of the link in this frame, if several links share the station.
    inside: Option<Inside<'g>>,
    /// Origin of the link relative to the origin of its parent, in the parent's frame.
    pub(super) offset: Vec3<'g>,
    /// Velocity that the joint adds, in this frame.
    pub(super) velocity: Twist<'g>,
    /// Inertia that moves with the link, in base parameters.
    pub(super) inertia: MassMoments<'g>,
}

/// Rotation of the station of a link relative to the frame of its parent.
#[derive(Clone, Copy, Debug)]
struct Turned<'g> {
    /// Rotation of the parent's body in its own frame.
    below: Option<Inside<'g>>,
    /// Rotation of the station in the parent's body, at angle zero.
    placement: Mat3<'g>,
    /// Turn of the joint, if the link is alone in its station.
    own: Option<Turn<'g>>,
}

/// Rotation of a body in its station: the constant rotation `rest`, then a turn.
#[derive(Clone, Copy, Debug)]
struct Inside<'g> {
    turn: Turn<'g>,
    rest: Mat3<'g>,
}

/// Computes the frame of each link.
pub(super) fn frames<'g>(model: &Model<'g>, links: &[Link<'g>]) -> Vec<Frame<'g>> {
    let g = model.graph;
    let follows: Vec<bool> = links.iter().map(|link| continues(links, link)).collect();
    let shared = |n: JointId| follows[n] || JointId::all(links.len()).any(|m| links[m].parent == Some(n) && follows[m]);
    // the angle of each body in its station, and its constant rotation there
    let mut angles: Vec<(Combination, Mat3<'g>)> = Vec::new();
    let mut frames: Vec<Frame<'g>> = Vec::new();
    for (n, link) in JointId::all(links.len()).zip(links) {
        let (before, rest) = match link.parent {
            Some(parent) if follows[n] => {
                let (angle, rest) = &angles[parent];
                (angle.clone(), *rest * link.placement.rotation)
            }
            _ => (Combination::default(), Mat3::identity(g)),
        };
        let angle = before.plus_scaled(1, &link.motion);
        let turn = link.turns().then(|| Turn::by(model.position_of(&angle)));
        angles.push((angle, rest));
        let (own, inside) = if shared(n) {
            (None, turn.map(|turn| Inside { turn, rest }))
        } else {
            (turn, None)
        };
        let below = link.parent.and_then(|parent| frames[parent].inside);
        let placement = link.placement.rotation;
        let slide = link.pitch() * model.position_of(&link.motion);
        let velocity = link.velocity(model);
        let offset = link.placement.translation + slide * placement.column(2);
        frames.push(Frame {
            turned: (!follows[n]).then_some(Turned { below, placement, own }),
            inside,
            offset: Inside::forward(below, offset),
            velocity,
            inertia: MassMoments {
                mass: link.inertia.mass,
                first: Inside::forward(inside, link.inertia.first),
                second: Inside::tensor(inside, link.inertia.second),
            },
        });
    }
    frames
}

/// True if a link turns about the same direction as its parent, and the parent turns.
fn continues(links: &[Link<'_>], link: &Link<'_>) -> bool {
    let parent_turns = link.parent.is_some_and(|parent| links[parent].turns());
    link.turns() && parent_turns && link.placement.rotation[2][2].is_one()
}

impl<'g> Inside<'g> {
    /// Rotates a vector of the body into the frame.
    fn forward(this: Option<Self>, v: Vec3<'g>) -> Vec3<'g> {
        this.map_or(v, |Self { turn, rest }| turn * (rest * v))
    }

    /// Rotates a symmetric tensor of the body into the frame.
    fn tensor(this: Option<Self>, tensor: Symmetric3<'g>) -> Symmetric3<'g> {
        this.map_or(tensor, |Self { turn, rest }| turn.tensor(tensor.rotated(rest)))
    }

    /// Rotates a vector of the frame into the body.
    fn back(this: Option<Self>, v: Vec3<'g>) -> Vec3<'g> {
        this.map_or(v, |Self { turn, rest }| rest.transpose() * (turn.inverse() * v))
    }
}

impl<'g> Frame<'g> {
    /// This frame with zero velocity.
    pub(super) fn at_rest(&self) -> Self {
        Self {
            velocity: Twist::zero(self.inertia.mass.graph()),
            ..self.clone()
        }
    }

    /// Rotates a vector of the link into this frame.
    pub(super) fn of_body(&self, v: Vec3<'g>) -> Vec3<'g> {
        Inside::forward(self.inside, v)
    }

    /// Rotates a vector of the parent's frame into this frame.
    pub(super) fn of_parent(&self, v: Vec3<'g>) -> Vec3<'g> {
        let Some(Turned { below, placement, own }) = self.turned else {
            return v;
        };
        let v = placement.transpose() * Inside::back(below, v);
        own.map_or(v, |turn| turn.inverse() * v)
    }

    /// Inverse of [`Frame::of_parent`].
    pub(super) fn to_parent(&self, v: Vec3<'g>) -> Vec3<'g> {
        let Some(Turned { below, placement, own }) = self.turned else {
            return v;
        };
        let v = own.map_or(v, |turn| turn * v);
        Inside::forward(below, placement * v)
    }

    /// Rotates a tensor of this frame into the parent's frame: its rows, then its columns.
    pub(super) fn matrix_to_parent(&self, tensor: Mat3<'g>) -> Mat3<'g> {
        let turned = |row| self.to_parent(row);
        tensor.map_rows(turned).transpose().map_rows(turned).transpose()
    }

    /// Rotates a symmetric tensor of this frame into the parent's frame.
    pub(super) fn tensor_to_parent(&self, tensor: Symmetric3<'g>) -> Symmetric3<'g> {
        let Some(Turned { below, placement, own }) = self.turned else {
            return tensor;
        };
        let tensor = own.map_or(tensor, |turn| turn.tensor(tensor));
        Inside::tensor(below, tensor.rotated(placement))
    }

    /// Transforms an inertia of this frame to the frame and the origin of the parent.
    pub(super) fn inertia_to_parent(&self, inertia: &MassMoments<'g>) -> MassMoments<'g> {
        let turned = MassMoments {
            mass: inertia.mass,
            first: self.to_parent(inertia.first),
            second: self.tensor_to_parent(inertia.second),
        };
        turned.moved(self.offset)
    }

    /// Transforms a wrench about the link's origin to the frame and the origin of the parent.
    pub(super) fn wrench_to_parent(&self, wrench: &Wrench<'g>) -> Wrench<'g> {
        let force = self.to_parent(wrench.force);
        Wrench {
            moment: self.to_parent(wrench.moment) + self.offset.cross(force),
            force,
        }
    }
}
