//! A model as a chain of links whose joints all turn about, or slide along, their own z axis.
//!
//! Fixed joints vanish, axes of any direction are turned to z once, in constants, and each joint lets its link hand down the
//! part of its inertia that the joint cannot move (base parameters: Gautier and Khalil 1990; Khalil and Dombre, ch. 9).

use crate::expr::{ExprId, Graph};
use crate::model::{Combination, Model, plus_scaled};
use crate::screw::{MassMoments, Mat3, Symmetric3, Transform, Vec3, cross, dot, mat_vec, scale, sub, transpose};

/// A moving joint and all that is fixed to it.
#[derive(Clone, Debug)]
pub(super) struct Link {
    /// The link that carries it; none for ground.
    pub(super) parent: Option<usize>,
    /// The joint frame at coordinate zero, in the frame of the parent: constant.
    pub(super) placement: Transform,
    /// Whether the joint turns.
    pub(super) turns: bool,
    /// How far it slides along z, per unit of its coordinate: 1 for a prismatic joint, the pitch for a helical one.
    pub(super) pitch: ExprId,
    /// What moves with it, in its own frame, in base parameters.
    pub(super) inertia: MassMoments,
    /// The joint coordinate in the coordinates of the scene.
    pub(super) motion: Combination,
    /// The coordinate that the joint brings into the scene: `motion` holds it with factor 1 or -1, and coordinates of links below.
    pub(super) coordinate: usize,
    /// The force along the joint: friction, spring and torque.
    pub(super) force: ExprId,
}

/// The links of a model, each behind its parent.
pub(super) fn links(model: &Model) -> Vec<Link> {
    let mut links: Vec<Link> = Vec::new();
    // for each body the link it belongs to, and where its frame sits in that of the link
    let mut owners: Vec<(Option<usize>, Transform)> = Vec::new();
    let Model { graph: g, bodies, .. } = model;
    for body in bodies.iter() {
        let (owner, base) = match body.parent {
            Some(parent) => owners[parent],
            None => (None, Transform::identity(g)),
        };
        let joint = base.then(g, &body.placement);
        let (Some(screw), Some(coordinate)) = (body.screw, body.coordinate) else {
            if let Some(owner) = owner {
                let carried = joint.inertia(g, &body.inertia);
                let carried = MassMoments::new(g, &carried);
                links[owner].inertia = links[owner].inertia.plus(g, &carried);
            }
            owners.push((owner, joint));
            continue;
        };
        let turns = screw.angular != [g.zero(); 3];
        let mut direction = if turns { screw.angular } else { screw.linear };
        let (mut motion, mut force) = (body.motion.clone(), body.force);
        // an axis against that of the parent is turned round, together with its coordinate, so that the two are parallel
        let [_, _, along] = mat_vec(g, joint.rotation, direction);
        if turns && along == g.integer(-1) {
            direction = direction.map(|x| g.neg(x));
            motion = plus_scaled(&Vec::new(), &motion, -1);
            force = g.neg(force);
        }
        // the axis passes through w x v; a slide has no place
        let place = if turns {
            cross(g, screw.angular, screw.linear)
        } else {
            [g.zero(); 3]
        };
        let pitch = if turns {
            dot(g, screw.angular, screw.linear)
        } else {
            g.one()
        };
        let aligned = Transform {
            rotation: with_third_column(g, direction),
            translation: place,
        };
        let back = inverse(g, &aligned);
        let own = back.inertia(g, &body.inertia);
        links.push(Link {
            parent: owner,
            placement: joint.then(g, &aligned),
            turns,
            pitch,
            inertia: MassMoments::new(g, &own),
            motion,
            coordinate,
            force,
        });
        owners.push((Some(links.len() - 1), back));
    }
    hand_down(g, &mut links);
    links
}

/// Each link keeps only what its joint can move against its parent; the rest is carried by the parent just as well.
///
/// A turn about z does not move a line of mass on the z axis: the mass, and the first and the second moment along z. A slide does
/// not turn: all second moments.
fn hand_down(g: &Graph, links: &mut [Link]) {
    let zero = g.zero();
    for n in (0..links.len()).rev() {
        let MassMoments {
            mass,
            first: [hx, hy, hz],
            second: Symmetric3([xx, yy, zz, xy, xz, yz]),
        } = links[n].inertia;
        let (kept, given) = match (links[n].turns, g.is_zero(links[n].pitch)) {
            (true, true) => (
                MassMoments {
                    mass: zero,
                    first: [hx, hy, zero],
                    second: Symmetric3([xx, yy, zero, xy, xz, yz]),
                },
                MassMoments {
                    mass,
                    first: [zero, zero, hz],
                    second: Symmetric3([zero, zero, zz, zero, zero, zero]),
                },
            ),
            (false, _) => (
                MassMoments {
                    mass,
                    first: [hx, hy, hz],
                    second: Symmetric3::zero(g),
                },
                MassMoments {
                    mass: zero,
                    first: [zero; 3],
                    second: links[n].inertia.second,
                },
            ),
            // a helical joint moves the line along itself
            (true, false) => continue,
        };
        links[n].inertia = kept;
        if let Some(parent) = links[n].parent {
            let Transform { rotation, translation } = links[n].placement;
            let carried = given.rotated(g, rotation).moved(g, translation);
            links[parent].inertia = links[parent].inertia.plus(g, &carried);
        }
    }
}

/// A rotation whose third column is a unit vector: a permutation where that is a coordinate axis.
fn with_third_column(g: &Graph, z: Vec3) -> Mat3 {
    let (zero, one) = (g.zero(), g.one());
    let axis = (0..3).find(|&k| (0..3).all(|i| i == k || g.is_zero(z[i])));
    let x = match axis {
        // any coordinate axis at a right angle will do
        Some(k) => std::array::from_fn(|i| if i == (k + 1) % 3 { one } else { zero }),
        None => {
            // the part of a coordinate axis that is at a right angle to z, normalised; the axis where z is zero is best
            let k = (0..3).find(|&k| g.is_zero(z[k])).unwrap_or(0);
            let unit: Vec3 = std::array::from_fn(|i| if i == k { one } else { zero });
            let along = scale(g, z[k], z);
            let across = sub(g, unit, along);
            let square = dot(g, across, across);
            let length = g.power(square, crate::expr::ratio(-1, 2));
            scale(g, length, across)
        }
    };
    let y = cross(g, z, x);
    transpose([x, y, z])
}

fn inverse(g: &Graph, t: &Transform) -> Transform {
    let rotation = transpose(t.rotation);
    let moved = mat_vec(g, rotation, t.translation);
    Transform {
        rotation,
        translation: moved.map(|x| g.neg(x)),
    }
}
