//! The frames in which links are computed.
//!
//! A link alone turns its own frame; parallel links in a row share the frame before the first of them, in which their angles add up
//! and nothing has to be turned between them.

use super::links::Link;
use crate::expr::{ExprId, Graph, Unary};
use crate::model::{Combination, Model, combine, plus_scaled};
use crate::screw::{
    MassMoments, Mat3, Symmetric3, Turn, Vec3, Wrench, add, cross, identity, mat_mul, mat_vec, scale, transpose,
};

/// The frame in which a link is computed: at its origin, turned as its station is.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    /// Whether the link before is in the same station.
    same_station: bool,
    /// From the parent's body frame to the station, where that is a new one.
    placement: Mat3,
    /// The turn of the frame itself, where the link is alone in its station.
    own: Option<Turn>,
    /// The turn of the body in its station, where several share it, behind the constant rotation `rest`.
    inside: Option<Turn>,
    rest: Mat3,
    /// The origin of the link from that of its parent, in the parent's frame.
    pub(super) offset: Vec3,
    /// Rate of turning about z.
    pub(super) turning: ExprId,
    /// Rate of sliding along z.
    pub(super) sliding: ExprId,
    /// What moves with the link, in base parameters.
    pub(super) inertia: MassMoments,
}

/// Whether a link turns about the direction of its parent, which turns too.
fn continues(g: &Graph, links: &[Link], n: usize) -> bool {
    let (link, one) = (&links[n], g.one());
    link.turns && link.parent.is_some_and(|p| links[p].turns) && link.placement.rotation[2][2] == one
}

/// The frame of each link.
pub(super) fn frames(model: &Model, links: &[Link]) -> Vec<Frame> {
    let Model {
        graph: g, coordinates, ..
    } = model;
    let follows: Vec<bool> = (0..links.len()).map(|n| continues(g, links, n)).collect();
    let shared = |n: usize| follows[n] || (0..links.len()).any(|m| links[m].parent == Some(n) && follows[m]);
    // the angle of each body in its station, and its constant rotation there
    let mut angles: Vec<Combination> = Vec::new();
    let mut frames: Vec<Frame> = Vec::new();
    for (n, link) in links.iter().enumerate() {
        let (before, rest) = match link.parent {
            Some(parent) if follows[n] => {
                let rest = mat_mul(g, frames[parent].rest, link.placement.rotation);
                (angles[parent].clone(), rest)
            }
            _ => (Combination::new(), identity(g)),
        };
        angles.push(plus_scaled(&before, &link.motion, 1));
        let turn = link.turns.then(|| {
            let angle = combine(g, coordinates, &angles[n], |c| c.position);
            Turn {
                sine: g.unary(Unary::Sin, angle),
                cosine: g.unary(Unary::Cos, angle),
            }
        });
        let (own, inside) = if shared(n) { (None, turn) } else { (turn, None) };
        let position = combine(g, coordinates, &link.motion, |c| c.position);
        let rate = combine(g, coordinates, &link.motion, |c| c.rate);
        let slide = g.mul(link.pitch, position);
        let along = scale(g, slide, link.placement.rotation.map(|row| row[2]));
        let offset = add(g, link.placement.translation, along);
        let offset = link.parent.map_or(offset, |parent| frames[parent].of_body(g, offset));
        let mut frame = Frame {
            same_station: follows[n],
            placement: link.placement.rotation,
            own,
            inside,
            rest,
            offset,
            turning: if link.turns { rate } else { g.zero() },
            sliding: g.mul(link.pitch, rate),
            inertia: link.inertia,
        };
        frame.inertia = MassMoments {
            mass: link.inertia.mass,
            first: frame.of_body(g, link.inertia.first),
            second: frame.tensor_of_body(g, link.inertia.second),
        };
        frames.push(frame);
    }
    frames
}

impl Frame {
    /// The same place, with nothing moving.
    pub(super) fn at_rest(&self, g: &Graph) -> Self {
        let (turning, sliding) = (g.zero(), g.zero());
        Self {
            turning,
            sliding,
            ..self.clone()
        }
    }

    /// A vector of the link's body, in the frame of the link.
    fn of_body(&self, g: &Graph, v: Vec3) -> Vec3 {
        let Some(turn) = self.inside else { return v };
        let v = mat_vec(g, self.rest, v);
        turn.forward(g, v)
    }

    /// A symmetric tensor of the link's body, in the frame of the link.
    fn tensor_of_body(&self, g: &Graph, tensor: Symmetric3) -> Symmetric3 {
        let Some(turn) = self.inside else { return tensor };
        let tensor = tensor.rotated(g, self.rest);
        turn.forward_tensor(g, tensor)
    }

    /// The inverse of [`Frame::of_body`].
    fn to_body(&self, g: &Graph, v: Vec3) -> Vec3 {
        let Some(turn) = self.inside else { return v };
        let v = turn.back(g, v);
        mat_vec(g, transpose(self.rest), v)
    }

    /// A vector of the frame of the parent, in this frame.
    pub(super) fn of_parent(&self, g: &Graph, parent: Option<&Frame>, v: Vec3) -> Vec3 {
        if self.same_station {
            return v;
        }
        let v = parent.map_or(v, |parent| parent.to_body(g, v));
        let v = mat_vec(g, transpose(self.placement), v);
        self.own.map_or(v, |turn| turn.back(g, v))
    }

    /// The inverse of [`Frame::of_parent`].
    pub(super) fn to_parent(&self, g: &Graph, parent: &Frame, v: Vec3) -> Vec3 {
        if self.same_station {
            return v;
        }
        let v = self.own.map_or(v, |turn| turn.forward(g, v));
        let v = mat_vec(g, self.placement, v);
        parent.of_body(g, v)
    }

    /// A tensor of this frame, in that of the parent: turned in its rows, then in its columns.
    pub(super) fn matrix_to_parent(&self, g: &Graph, parent: &Frame, tensor: Mat3) -> Mat3 {
        let rows = tensor.map(|row| self.to_parent(g, parent, row));
        let columns = transpose(rows).map(|column| self.to_parent(g, parent, column));
        transpose(columns)
    }

    /// A symmetric tensor of this frame, in that of the parent.
    pub(super) fn tensor_to_parent(&self, g: &Graph, parent: &Frame, tensor: Symmetric3) -> Symmetric3 {
        if self.same_station {
            return tensor;
        }
        let tensor = self.own.map_or(tensor, |turn| turn.forward_tensor(g, tensor));
        let tensor = tensor.rotated(g, self.placement);
        parent.tensor_of_body(g, tensor)
    }

    /// An inertia of this frame, in that of the parent.
    pub(super) fn inertia_to_parent(&self, g: &Graph, parent: &Frame, inertia: &MassMoments) -> MassMoments {
        let turned = MassMoments {
            mass: inertia.mass,
            first: self.to_parent(g, parent, inertia.first),
            second: self.tensor_to_parent(g, parent, inertia.second),
        };
        turned.moved(g, self.offset)
    }

    /// A force and a moment about the link's origin, in the frame and about the origin of the parent.
    pub(super) fn wrench_to_parent(&self, g: &Graph, parent: &Frame, wrench: &Wrench) -> Wrench {
        let force = self.to_parent(g, parent, wrench.force);
        let moment = self.to_parent(g, parent, wrench.moment);
        let lever = cross(g, self.offset, force);
        Wrench {
            moment: add(g, moment, lever),
            force,
        }
    }

    /// The part of a wrench that moves the joint of the link.
    pub(super) fn along_joint(&self, g: &Graph, link: &Link, wrench: &Wrench) -> ExprId {
        let slide = g.mul(link.pitch, wrench.force[2]);
        if link.turns {
            g.add(wrench.moment[2], slide)
        } else {
            slide
        }
    }
}
