//! Planar loops: vectors that add up to zero.

use crate::expr::{Expr, Normalizer};
use crate::model::{BodyId, Closure, Combination, CoordinateId, Heading, Place, Tie, Tree};
use crate::screw::{Mat3, Vec2, Vec3};

/// Reason why a joint cannot close its loop in a plane.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum NoPlane {
    /// The bodies do not turn about one axis in one frame.
    Axes,
    /// The bodies do, but the joint turns about another axis.
    Joint,
    /// The places lie in different planes, or move out of their plane.
    Apart,
}

/// A vector in the plane of a loop.
#[derive(Clone, Debug)]
pub(crate) struct Piece<'g> {
    /// Angle by which it is turned.
    pub(super) turn: Combination,
    /// The vector before the turn; a unit vector if it slides.
    pub(super) vector: Vec2<Expr<'g>>,
    /// Coordinate by which it slides.
    pub(super) slide: Option<CoordinateId>,
    /// Body in whose frame it is fixed; `None` for the frame of the plane.
    pub(super) body: Option<BodyId>,
}

/// Vectors that add up to zero.
#[derive(Clone, Debug)]
pub(crate) struct Loop<'g>(pub(super) Vec<Piece<'g>>);

/// A vector of three components in the frame of the plane.
struct Step<'g> {
    turn: Combination,
    vector: Vec3<'g>,
    slide: Option<CoordinateId>,
    body: Option<BodyId>,
}

/// Maximum number of products of terms in the normal form of a constant.
const BUDGET: usize = 100_000;

impl<'g> Loop<'g> {
    /// Builds the loop that a joint closes.
    pub(crate) fn new(tree: &Tree<'g>, closure: &Closure<'g>) -> Result<Self, NoPlane> {
        let frame = common_frame(tree, closure).ok_or(NoPlane::Axes)?;
        let axes = closure.ends.each_ref().map(|end| axis_in(tree, end, frame));
        let axis = axes.into_iter().flatten().next().ok_or(NoPlane::Axes)?;
        let steps = steps_around(tree, closure, frame, axis, axes)?;
        check_joint(tree, closure, frame, axis)?;
        Self::flat(tree, axis, steps)
    }

    /// Builds the loop from steps that stay in one plane normal to an axis.
    fn flat(tree: &Tree<'g>, axis: Vec3<'g>, steps: Vec<Step<'g>>) -> Result<Self, NoPlane> {
        let basis = Mat3::with_third_column(axis).transpose();
        let mut height = tree.graph.zero();
        let mut pieces = Vec::new();
        for step in steps {
            let Vec3([x, y, z]) = basis * step.vector;
            if step.slide.is_none() {
                height += z;
            } else if !vanishes(z) {
                return Err(NoPlane::Apart);
            }
            pieces.push(Piece {
                turn: step.turn,
                vector: Vec2([x, y]),
                slide: step.slide,
                body: step.body,
            });
        }
        pieces.retain(|piece| !piece.vector.0.into_iter().all(Expr::is_zero));
        if vanishes(height) {
            Ok(Self(pieces))
        } else {
            Err(NoPlane::Apart)
        }
    }

    /// The loop around both loops: their sum, with the other one times `sign`.
    pub(super) fn joined(&self, other: &Self, sign: i64) -> Self {
        let signed = other.0.iter().map(|piece| Piece {
            vector: piece.vector.times(piece.vector.0[0].graph().integer(sign)),
            ..piece.clone()
        });
        let mut joined = Self(Vec::new());
        for piece in self.0.iter().cloned().chain(signed) {
            let same = |known: &&mut Piece<'g>| known.turn == piece.turn && known.slide == piece.slide;
            match joined.0.iter_mut().find(same) {
                Some(known) if piece.slide.is_none() => known.vector = known.vector + piece.vector,
                Some(known) if known.vector == -piece.vector => known.vector = Vec2::zero(piece.vector.0[0].graph()),
                _ => joined.0.push(piece),
            }
        }
        joined.0.retain(|piece| !piece.vector.0.into_iter().all(vanishes));
        joined
    }
}

/// Frame in which both ends of a loop turn about one axis. One end may be the body in whose frame the other turns.
fn common_frame(tree: &Tree<'_>, closure: &Closure<'_>) -> Option<Option<BodyId>> {
    let [first, second] = closure.ends.each_ref().map(|end| end.body);
    let station = |body: Option<BodyId>| body.and_then(|body| tree.bodies[body].heading.station);
    match [first, second].map(station) {
        [a, b] if a == b => Some(a),
        [a, b] if first == b && a != b => Some(b),
        [a, b] if second == a && a != b => Some(a),
        _ => None,
    }
}

/// Steps from the origin of a frame to the first end, and back from the second end, as turns about one axis.
fn steps_around<'g>(
    tree: &Tree<'g>,
    closure: &Closure<'g>,
    frame: Option<BodyId>,
    axis: Vec3<'g>,
    axes: [Option<Vec3<'g>>; 2],
) -> Result<Vec<Step<'g>>, NoPlane> {
    let mut steps = Vec::new();
    for ((end, own), towards) in closure.ends.iter().zip(axes).zip([1, -1]) {
        let sign = own.map_or(Some(1), |own| parallel(axis, own)).ok_or(NoPlane::Axes)?;
        steps.extend(steps_to(tree, end, frame).into_iter().map(|step| Step {
            turn: step.turn.scaled(sign),
            vector: towards * step.vector,
            ..step
        }));
    }
    Ok(steps)
}

/// Checks that the closing joint lets the loop turn about the axis of the other joints.
fn check_joint<'g>(
    tree: &Tree<'g>,
    closure: &Closure<'g>,
    frame: Option<BodyId>,
    axis: Vec3<'g>,
) -> Result<(), NoPlane> {
    let own = match closure.tie {
        Tie::Ball => return Ok(()),
        Tie::Prismatic(_) | Tie::Fixed => return Err(NoPlane::Joint),
        Tie::Revolute(own) => own,
    };
    let is_along = |(end, axes): (&Place<'g>, Mat3<'g>)| {
        let own = match end.body.filter(|_| end.body != frame) {
            Some(body) => tree.bodies[body].heading.rest * (axes * own),
            None => axes * own,
        };
        parallel(axis, own).is_some()
    };
    let mut ends = closure.ends.iter().zip(closure.axes);
    ends.all(is_along).then_some(()).ok_or(NoPlane::Joint)
}

/// Axis about which a body turns in a frame, if it turns there.
fn axis_in<'g>(tree: &Tree<'g>, place: &Place<'g>, frame: Option<BodyId>) -> Option<Vec3<'g>> {
    let body = place.body.filter(|_| place.body != frame)?;
    tree.bodies[body].heading.axis
}

/// Steps from the origin of a frame to a place on a body that turns in it, as vectors of the frame.
fn steps_to<'g>(tree: &Tree<'g>, place: &Place<'g>, frame: Option<BodyId>) -> Vec<Step<'g>> {
    let still = |vector: Vec3<'g>| Step {
        turn: Combination::default(),
        vector,
        slide: None,
        body: None,
    };
    let inside = |at: Option<BodyId>| at.filter(|_| at != frame);
    let held = |at: Option<BodyId>, vector: Vec3<'g>| match inside(at) {
        None => still(vector),
        Some(body) => {
            let Heading { turn, rest, .. } = &tree.bodies[body].heading;
            Step {
                turn: turn.clone(),
                vector: *rest * vector,
                slide: None,
                body: Some(body),
            }
        }
    };
    let mut steps = vec![held(place.body, place.at)];
    let mut at = inside(place.body);
    while let Some(body) = at {
        let own = &tree.bodies[body];
        let joint = own.placement;
        steps.push(held(own.parent, joint.translation));
        if let Some(screw) = own.screw {
            let (arm, pitch) = (screw.angular.cross(screw.linear), screw.angular.dot(screw.linear));
            let along = if screw.turns() {
                pitch * screw.angular
            } else {
                screw.linear
            };
            steps.push(Step {
                slide: own.coordinate,
                ..held(own.parent, joint.rotation * along)
            });
            steps.push(held(own.parent, joint.rotation * arm));
            steps.push(held(at, -arm));
        }
        at = inside(own.parent);
    }
    steps.retain(|step| !step.vector.is_zero());
    steps
}

/// Returns 1 if two unit vectors are equal for all parameters, -1 if they are opposite, and `None` if neither can be
/// proved.
pub(crate) fn parallel<'g>(a: Vec3<'g>, b: Vec3<'g>) -> Option<i64> {
    let vanish = |v: Vec3<'g>| v.0.into_iter().all(vanishes);
    if vanish(a - b) {
        return Some(1);
    }
    vanish(a + b).then_some(-1)
}

fn vanishes(x: Expr<'_>) -> bool {
    Normalizer::new(x.graph(), BUDGET).is_zero(x) == Ok(true)
}
