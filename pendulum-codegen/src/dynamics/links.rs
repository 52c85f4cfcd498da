//! A model as a chain of links, with each joint turning about, or sliding along, its own z axis.
//!
//! Fixed joints vanish, axes of any direction are rotated to z once, in constants, and each link passes to its parent
//! the part of its inertia that its joint cannot move (base parameters: Gautier and Khalil 1990; Khalil and Dombre, ch.
//! 9).

use super::joint::JointId;
use crate::expr::Expr;
use crate::model::{Combination, CoordinateId, Model};
use crate::screw::{MassMoments, Mat3, Symmetric3, Transform, Twist, Vec3};

/// A moving joint with all bodies fixed to it.
#[derive(Clone, Debug)]
pub(super) struct Link<'g> {
    /// Link that carries it; `None` for ground.
    pub(super) parent: Option<JointId>,
    /// Joint frame at coordinate zero, in the frame of the parent: constant, except for the first joint of an
    /// orientation.
    pub(super) placement: Transform<'g>,
    /// Screw axis of the joint in the frame of the link: a rotation about z that may slide along it, or a slide along
    /// z.
    pub(super) screw: Twist<'g>,
    /// Inertia that moves with the link, in its own frame, in base parameters.
    pub(super) inertia: MassMoments<'g>,
    /// Joint coordinate in terms of the coordinates of the scene.
    pub(super) motion: Combination,
    /// Coordinate that the joint adds to the scene: `motion` contains it with factor 1 or -1, besides coordinates of
    /// links below. A joint that follows others uses one of their coordinates.
    pub(super) coordinate: CoordinateId,
    /// Force along the joint: friction, spring and torque.
    pub(super) force: Expr<'g>,
    /// For the three joints of an orientation, the angular velocity that each adds, in the frame of the link: the
    /// first, whose placement is turned, adds all of it, and the others none.
    pub(super) spin: Option<Vec3<'g>>,
}

impl<'g> Link<'g> {
    /// Velocity that the joint adds.
    pub(super) fn velocity(&self, model: &Model<'g>) -> Twist<'g> {
        match self.spin {
            None => model.rate_of(&self.motion) * self.screw,
            Some(angular) => Twist {
                angular,
                linear: Vec3::zero(model.graph),
            },
        }
    }

    /// True if the joint turns.
    pub(super) fn turns(&self) -> bool {
        self.screw.turns()
    }

    /// Distance that it slides along z per unit of its coordinate: 1 for a prismatic joint, the pitch for a helical
    /// one.
    pub(super) fn pitch(&self) -> Expr<'g> {
        self.screw.linear[2]
    }
}

/// Links of a model.
#[derive(Clone, Debug)]
pub(super) struct Links<'g> {
    /// Links, each behind its parent.
    pub(super) links: Vec<Link<'g>>,
    /// Link that each body belongs to (`None` for ground), and the pose of the body in the frame of that link.
    pub(super) owners: Vec<(Option<JointId>, Transform<'g>)>,
}

/// Converts a model to links.
pub(super) fn links<'g>(model: &Model<'g>) -> Links<'g> {
    let g = model.graph;
    let mut links: Vec<Link<'g>> = Vec::new();
    let mut owners: Vec<(Option<JointId>, Transform<'g>)> = Vec::new();
    for body in &model.bodies {
        let (owner, base) = match body.parent {
            Some(parent) => owners[parent],
            None => (None, Transform::identity(g)),
        };
        let joint = base * body.placement;
        // a joint that follows others uses the coordinate of one of them
        let coordinate = body.coordinate.or_else(|| body.motion.terms().next().map(|(k, _)| k));
        let (Some(screw), Some(coordinate)) = (body.screw, coordinate) else {
            if let Some(owner) = owner {
                let carried = MassMoments::from(joint.inertia(&body.inertia));
                links[owner].inertia = links[owner].inertia + carried;
            }
            owners.push((owner, joint));
            continue;
        };
        let turns = screw.turns();
        let mut direction = if turns { screw.angular } else { screw.linear };
        let (mut motion, mut force) = (body.motion.clone(), body.force);
        // an axis opposite to the parent's is reversed, together with its coordinate, so that the two are parallel
        let along = (joint.rotation * direction)[2];
        if turns && along == g.integer(-1) {
            direction = -direction;
            motion = motion.scaled(-1);
            force = -force;
        }
        let (aligned, screw) = aligned(screw, direction);
        let back = aligned.inverse();
        let inertia = back.inertia(&body.inertia).into();
        links.push(Link {
            parent: owner,
            placement: joint * aligned,
            screw,
            inertia,
            motion,
            coordinate,
            force,
            spin: body.spin.map(|spin| back.rotation * spin),
        });
        owners.push((Some(JointId::new(links.len() - 1)), back));
    }
    hand_down(&mut links);
    Links { links, owners }
}

/// Frame with its z axis on the axis of a screw, in the given direction, and the screw in that frame.
fn aligned<'g>(screw: Twist<'g>, direction: Vec3<'g>) -> (Transform<'g>, Twist<'g>) {
    let g = direction[2].graph();
    let (zero, z) = (Vec3::zero(g), Vec3::z(g));
    let Twist { angular: w, linear: v } = screw;
    // the axis of a rotation passes through w x v; a slide has no location
    let (translation, angular, linear) = if screw.turns() {
        (w.cross(v), z, w.dot(v) * z)
    } else {
        (zero, zero, z)
    };
    let rotation = Mat3::with_third_column(direction);
    (Transform { rotation, translation }, Twist { angular, linear })
}

/// Reduces each link to the inertia that its joint can move relative to its parent, and adds the rest to the parent.
fn hand_down(links: &mut [Link<'_>]) {
    for n in JointId::all(links.len()).rev() {
        let Some((kept, given)) = links[n].divided() else {
            continue;
        };
        links[n].inertia = kept;
        if let Some(parent) = links[n].parent {
            let Transform { rotation, translation } = links[n].placement;
            links[parent].inertia = links[parent].inertia + given.rotated(rotation).moved(translation);
        }
    }
}

impl<'g> Link<'g> {
    /// Splits the inertia into the part that the joint can move relative to its parent, and the rest.
    ///
    /// A rotation about z does not move a line of mass on the z axis: the rest is the mass, and the first and the
    /// second moment along z. A slide does not rotate: the rest is all second moments. A helical joint moves the line
    /// along itself: there is no rest.
    fn divided(&self) -> Option<(MassMoments<'g>, MassMoments<'g>)> {
        let MassMoments { mass, first, second } = self.inertia;
        let none = MassMoments::zero(mass.graph());
        let zero = mass.graph().zero();
        if !self.turns() {
            let kept = MassMoments {
                second: none.second,
                ..self.inertia
            };
            return Some((kept, MassMoments { second, ..none }));
        }
        if self.spin.is_some() {
            // three rotations move everything but the mass at their centre
            let kept = MassMoments {
                mass: zero,
                ..self.inertia
            };
            return Some((kept, MassMoments { mass, ..none }));
        }
        let (Vec3([hx, hy, hz]), Symmetric3([xx, yy, zz, xy, xz, yz])) = (first, second);
        let kept = MassMoments {
            mass: zero,
            first: Vec3([hx, hy, zero]),
            second: Symmetric3([xx, yy, zero, xy, xz, yz]),
        };
        let line = MassMoments {
            mass,
            first: Vec3([zero, zero, hz]),
            second: Symmetric3([zero, zero, zz, zero, zero, zero]),
        };
        self.pitch().is_zero().then_some((kept, line))
    }
}
