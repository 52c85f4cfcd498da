//! Where bodies and their points are.

use super::{Body, Heading, Tree};
use crate::expr::{Expr, Graph};
use crate::model::BodyId;
use crate::screw::{Mat3, Transform, Twist, Vec3};

/// Poses and screws of the bodies of a tree, each written in the station of its body.
///
/// In a station, parallel joints turn by sums of angles, and what lies below the station does not appear at all.
#[derive(Debug)]
pub(crate) struct Poses<'g> {
    graph: &'g Graph,
    /// Where each body is.
    pub poses: Vec<Transform<'g>>,
    /// The screw of each joint; none for a fixed one.
    pub screws: Vec<Option<Twist<'g>>>,
    /// The station of each body; none for ground.
    pub stations: Vec<Option<BodyId>>,
}

impl<'g> Poses<'g> {
    /// The poses of a tree.
    pub(crate) fn new(tree: &Tree<'g>) -> Self {
        let mut poses: Vec<Transform<'g>> = Vec::new();
        let mut screws = Vec::new();
        for body in &tree.bodies {
            let base = match body.parent {
                Some(parent) if body.heading.station != Some(parent) => poses[parent],
                _ => Transform::identity(tree.graph),
            };
            let rotation = orientation(&body.heading, tree.position_of(&body.heading.turn));
            let (translation, screw) = place(&base, body, rotation, tree.position_of(&body.motion));
            poses.push(Transform { rotation, translation });
            screws.push(screw);
        }
        Self {
            graph: tree.graph,
            poses,
            screws,
            stations: tree.bodies.iter().map(|body| body.heading.station).collect(),
        }
    }

    /// A point of a body, or of ground, in the ground frame.
    pub(crate) fn point(&self, body: Option<BodyId>, at: Vec3<'g>) -> Vec3<'g> {
        self.stations_below(body)
            .fold(at, |at, body| self.poses[body].point(at))
    }

    /// A direction of a body, or of ground, in the ground frame.
    pub(crate) fn direction(&self, body: Option<BodyId>, direction: Vec3<'g>) -> Vec3<'g> {
        let turned = |v, body: BodyId| self.poses[body].rotation * v;
        self.stations_below(body).fold(direction, turned)
    }

    /// The axes of a body in the ground frame, as columns.
    pub(crate) fn rotation(&self, body: Option<BodyId>) -> Mat3<'g> {
        let turned = |m, body: BodyId| self.poses[body].rotation * m;
        self.stations_below(body).fold(Mat3::identity(self.graph), turned)
    }

    /// The body, its station, the station of that, and so on to ground.
    fn stations_below(&self, body: Option<BodyId>) -> impl Iterator<Item = BodyId> {
        std::iter::successors(body, |&body| self.stations[body])
    }
}

/// Where two bodies are in the frame of the last body that carries both, or that is one of them.
///
/// Where they turn about one axis, that body included, its own turn is taken off the sums of angles, so it does not
/// occur.
pub(crate) fn between<'g>(tree: &Tree<'g>, bodies: [Option<BodyId>; 2]) -> [Transform<'g>; 2] {
    let carrier = carrier(tree, bodies);
    bodies.map(|body| in_frame_of(tree, carrier, body))
}

/// The last body that carries both, or that is one of them; none for ground.
pub(super) fn carrier(tree: &Tree<'_>, [first, second]: [Option<BodyId>; 2]) -> Option<BodyId> {
    let below = |body: Option<BodyId>| std::iter::successors(body, |&body| tree.bodies[body].parent);
    below(first).find(|&body| below(second).any(|other| other == body))
}

/// Where a body is in the frame of one that carries it.
fn in_frame_of<'g>(tree: &Tree<'g>, carrier: Option<BodyId>, body: Option<BodyId>) -> Transform<'g> {
    let Some(at) = body.filter(|_| body != carrier) else {
        return Transform::identity(tree.graph);
    };
    let own = &tree.bodies[at];
    let base = in_frame_of(tree, carrier, own.parent);
    let carried = carrier.map(|carrier| &tree.bodies[carrier].heading);
    let mut heading = own.heading.clone();
    let before = match carried {
        // all turn in the frame of a body below
        Some(carried) if carried.station == heading.station => {
            heading.turn = heading.turn.plus_scaled(-1, &carried.turn);
            Some(carried.rest.transpose())
        }
        _ => {
            let station = heading.station.filter(|_| heading.station != carrier);
            station.map(|station| in_frame_of(tree, carrier, Some(station)).rotation)
        }
    };
    let turned = orientation(&heading, tree.position_of(&heading.turn));
    let rotation = before.map_or(turned, |before| before * turned);
    let joint = base * own.placement;
    let translation = match own.screw {
        None => joint.translation,
        Some(screw) if !screw.turns() => joint.point(tree.position_of(&own.motion) * screw.linear),
        Some(Twist { angular: w, linear: v }) => {
            let (pitch, arm) = (w.dot(v), w.cross(v));
            joint.point(arm + (pitch * tree.position_of(&own.motion)) * w) - rotation * arm
        }
    };
    Transform { rotation, translation }
}

fn orientation<'g>(heading: &Heading<'g>, angle: Expr<'g>) -> Mat3<'g> {
    match heading.axis {
        None => heading.rest,
        Some(axis) => Mat3::rotation(axis, angle) * heading.rest,
    }
}

/// Where a body's origin is and what the screw of its joint is, in the frame in which its parent stands at `base`.
fn place<'g>(
    base: &Transform<'g>,
    body: &Body<'g>,
    turned: Mat3<'g>,
    position: Expr<'g>,
) -> (Vec3<'g>, Option<Twist<'g>>) {
    let joint = *base * body.placement;
    let Some(screw) = body.screw else {
        return (joint.translation, None);
    };
    if !screw.turns() {
        return (joint.point(position * screw.linear), Some(joint.twist(&screw)));
    }
    let Twist { angular: w, linear: v } = screw;
    // a turn does not move its own axis, so the axis needs the constant rotation only
    let angular = body.heading.rest * w;
    let twist = Twist {
        angular,
        linear: joint.rotation * v + joint.translation.cross(angular),
    };
    // exp(s q) moves the origin by (1 - R) (w x v) + w (w . v) q
    let (pitch, arm) = (w.dot(v), w.cross(v));
    let along = (pitch * position) * angular;
    (joint.point(arm) - turned * arm + along, Some(twist))
}
