//! Poses of bodies, and positions of their points.

use super::{Body, Heading, Tree};
use crate::expr::{Expr, Graph};
use crate::model::BodyId;
use crate::screw::{Mat3, Transform, Twist, Vec3};

/// Poses and screws of the bodies of a tree, each in the station of its body.
///
/// Within a station, parallel joints turn by sums of angles, and coordinates below the station do not occur.
#[derive(Debug)]
pub(crate) struct Poses<'g> {
    graph: &'g Graph,
    /// Pose of each body.
    pub poses: Vec<Transform<'g>>,
    /// Screw of each joint; none for a fixed joint.
    pub screws: Vec<Option<Twist<'g>>>,
    /// Station of each body; none for ground.
    pub stations: Vec<Option<BodyId>>,
}

impl<'g> Poses<'g> {
    /// Computes the poses of a tree.
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

    /// Position in the ground frame of a point of a body, or of ground.
    pub(crate) fn point(&self, body: Option<BodyId>, at: Vec3<'g>) -> Vec3<'g> {
        self.stations_below(body)
            .fold(at, |at, body| self.poses[body].point(at))
    }

    /// Direction in the ground frame of a vector of a body, or of ground.
    pub(crate) fn direction(&self, body: Option<BodyId>, direction: Vec3<'g>) -> Vec3<'g> {
        let turned = |v, body: BodyId| self.poses[body].rotation * v;
        self.stations_below(body).fold(direction, turned)
    }

    /// Axes of a body in the ground frame, as columns.
    pub(crate) fn rotation(&self, body: Option<BodyId>) -> Mat3<'g> {
        let turned = |m, body: BodyId| self.poses[body].rotation * m;
        self.stations_below(body).fold(Mat3::identity(self.graph), turned)
    }

    /// The body, its station, the station of its station, and so on down to ground.
    fn stations_below(&self, body: Option<BodyId>) -> impl Iterator<Item = BodyId> {
        std::iter::successors(body, |&body| self.stations[body])
    }
}

/// Poses of two bodies in the frame of their carrier: the last body that carries both, or is one of them.
///
/// If the bodies turn about the same axis as the carrier, its turn is subtracted from the sums of angles, so that its
/// coordinates do not occur.
pub(crate) fn between<'g>(tree: &Tree<'g>, bodies: [Option<BodyId>; 2]) -> [Transform<'g>; 2] {
    let carrier = carrier(tree, bodies);
    bodies.map(|body| in_frame_of(tree, carrier, body))
}

/// Last body that carries both, or is one of them; none for ground.
pub(super) fn carrier(tree: &Tree<'_>, [first, second]: [Option<BodyId>; 2]) -> Option<BodyId> {
    let below = |body: Option<BodyId>| std::iter::successors(body, |&body| tree.bodies[body].parent);
    below(first).find(|&body| below(second).any(|other| other == body))
}

/// Pose of a body in the frame of a body that carries it.
fn in_frame_of<'g>(tree: &Tree<'g>, carrier: Option<BodyId>, body: Option<BodyId>) -> Transform<'g> {
    let Some(at) = body.filter(|_| body != carrier) else {
        return Transform::identity(tree.graph);
    };
    let own = &tree.bodies[at];
    let base = in_frame_of(tree, carrier, own.parent);
    let carried = carrier.map(|carrier| &tree.bodies[carrier].heading);
    let mut heading = own.heading.clone();
    let before = match carried {
        // both turn about one axis in the same station
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

/// Origin of a body and screw of its joint, in the frame in which `base` is the pose of its parent.
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
    // a turn leaves its own axis fixed, so the axis needs the constant rotation only
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
