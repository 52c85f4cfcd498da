//! Accelerations by articulated bodies (Featherstone 1983; 2008, Sec. 7.3): the form whose length grows with the number of joints only.
//!
//! The links above a joint answer a push through it as one body that gives way at its own joints. No mass matrix is formed.

use super::frames::{Frame, frames};
use super::links::{Link, links};
use super::recursive::{acceleration_field, inertial_moment};
use crate::expr::{ExprId, Graph};
use crate::model::Model;
use crate::screw::{MassMoments, Mat3, Symmetric3, Vec3, Wrench, add, cross, dot, mat_mul, mat_vec, scale, transpose};

/// The inertia of a link whose outer joints give way: `moment = rotation alpha + coupling a`, `force = coupling^T alpha + translation a`.
#[derive(Clone, Copy, Debug)]
struct Articulated {
    rotation: Symmetric3,
    coupling: Mat3,
    translation: Symmetric3,
}

/// What a joint gives way by.
#[derive(Clone, Copy, Debug)]
struct Joint {
    /// The articulated inertia times the joint's screw.
    momentum: Wrench,
    /// One over the inertia along the joint.
    mobility: ExprId,
    /// The force along the joint that is left to accelerate it.
    force: ExprId,
}

/// Angular acceleration, and acceleration of the origin.
type Acceleration = [Vec3; 2];

/// The accelerations of the coordinates of a scene.
pub(super) fn accelerations(model: &Model) -> Vec<ExprId> {
    let links = links(model);
    let frames = frames(model, &links);
    let (n, gravity) = (model.dof(), model.gravity);
    let g = &model.graph;
    let spins = spins(g, &links, &frames);
    let mut inertias: Vec<Articulated> = Vec::new();
    let mut wrenches: Vec<Wrench> = Vec::new();
    for (frame, &w) in frames.iter().zip(&spins) {
        inertias.push(Articulated::rigid(g, &frame.inertia));
        let still = [g.zero(); 3];
        let field = acceleration_field(g, w, still);
        wrenches.push(Wrench {
            moment: inertial_moment(g, &field, frame.inertia.second),
            force: mat_vec(g, field, frame.inertia.first),
        });
    }
    let drifts: Vec<Acceleration> = (0..links.len()).map(|k| drift(g, &links, &frames, &spins, k)).collect();
    let mut joints: Vec<Joint> = Vec::new();
    for k in (0..links.len()).rev() {
        let (link, frame) = (&links[k], &frames[k]);
        let joint = inertias[k].give_way(g, link, frame, &wrenches[k]);
        joints.push(joint);
        let Some(parent) = link.parent else { continue };
        let carried = inertias[k].without(g, link, &joint);
        let pushed = carried.times(g, &drifts[k]);
        let left = joint.momentum.scaled(g, joint.mobility).scaled(g, joint.force);
        let below = &frames[parent];
        let wrench = wrenches[k].plus(g, &pushed).plus(g, &left);
        let wrench = frame.wrench_to_parent(g, below, &wrench);
        wrenches[parent] = wrenches[parent].plus(g, &wrench);
        let carried = carried.to_parent(g, frame, below);
        inertias[parent] = inertias[parent].plus(g, &carried);
    }
    joints.reverse();
    let mut accelerations = vec![g.zero(); n];
    let mut motions: Vec<Acceleration> = Vec::new();
    for (k, (link, joint)) in links.iter().zip(&joints).enumerate() {
        let parent = link.parent.map(|p| &frames[p]);
        let [alpha, a] = match link.parent.map(|p| motions[p]) {
            Some([alpha, a]) => {
                let swept = cross(g, alpha, frames[k].offset);
                [alpha, add(g, a, swept)]
            }
            None => [[g.zero(); 3], gravity.map(|x| g.neg(x))],
        };
        let arriving = [alpha, a].map(|v| frames[k].of_parent(g, parent, v));
        let [mut alpha, mut a] = [0, 1].map(|part| add(g, arriving[part], drifts[k][part]));
        let (turned, moved) = (dot(g, joint.momentum.moment, alpha), dot(g, joint.momentum.force, a));
        let taken = g.add(turned, moved);
        let left = g.sub(joint.force, taken);
        let second_rate = g.mul(left, joint.mobility);
        if link.turns {
            alpha[2] = g.add(alpha[2], second_rate);
        }
        let slide = g.mul(link.pitch, second_rate);
        a[2] = g.add(a[2], slide);
        motions.push([alpha, a]);
        // q_k = factor * own + others, where the others are coordinates of links below
        let mut own = second_rate;
        for &(other, factor) in link.motion.iter().filter(|(other, _)| *other != link.coordinate) {
            let factor = g.integer(factor);
            let share = g.mul(factor, accelerations[other]);
            own = g.sub(own, share);
        }
        let sign = link
            .motion
            .iter()
            .find(|(k, _)| *k == link.coordinate)
            .map_or(1, |(_, sign)| *sign);
        let sign = g.integer(sign);
        accelerations[link.coordinate] = g.mul(sign, own);
    }
    accelerations
}

/// The angular velocity of each link, in its frame.
fn spins(g: &Graph, links: &[Link], frames: &[Frame]) -> Vec<Vec3> {
    let mut spins: Vec<Vec3> = Vec::new();
    for (link, frame) in links.iter().zip(frames) {
        let mut w = match link.parent {
            Some(parent) => frame.of_parent(g, Some(&frames[parent]), spins[parent]),
            None => [g.zero(); 3],
        };
        w[2] = g.add(w[2], frame.turning);
        spins.push(w);
    }
    spins
}

/// The acceleration of a link when neither its joint nor the link below accelerates: what the rates alone bring.
fn drift(g: &Graph, links: &[Link], frames: &[Frame], spins: &[Vec3], k: usize) -> Acceleration {
    let zero = g.zero();
    let frame = &frames[k];
    let Some(parent) = links[k].parent else {
        return [[zero; 3]; 2];
    };
    let field = acceleration_field(g, spins[parent], [zero; 3]);
    let swept = mat_vec(g, field, frame.offset);
    let swept = frame.of_parent(g, Some(&frames[parent]), swept);
    let [x, y, _] = spins[k];
    let across = [y, g.neg(x), zero];
    let two = g.integer(2);
    let twice = g.mul(two, frame.sliding);
    let (angular, sliding) = (scale(g, frame.turning, across), scale(g, twice, across));
    [angular, add(g, swept, sliding)]
}

impl Articulated {
    fn rigid(g: &Graph, inertia: &MassMoments) -> Self {
        Self {
            rotation: inertia.rotational(g),
            coupling: crossing(g, inertia.first),
            translation: Symmetric3::diagonal(g, [inertia.mass; 3]),
        }
    }

    fn give_way(&self, g: &Graph, link: &Link, frame: &Frame, wrench: &Wrench) -> Joint {
        let slid = Wrench {
            moment: self.coupling.map(|row| row[2]),
            force: self.translation.full()[2],
        };
        let mut momentum = slid.scaled(g, link.pitch);
        if link.turns {
            let turned = Wrench {
                moment: self.rotation.full()[2],
                force: self.coupling[2],
            };
            momentum = momentum.plus(g, &turned);
        }
        let (inertia, taken) = (
            frame.along_joint(g, link, &momentum),
            frame.along_joint(g, link, wrench),
        );
        let one = g.one();
        Joint {
            momentum,
            mobility: g.div(one, inertia),
            force: g.sub(link.force, taken),
        }
    }

    /// The inertia that is left when the joint gives way.
    fn without(&self, g: &Graph, link: &Link, joint: &Joint) -> Self {
        let Wrench { moment, force } = joint.momentum;
        let given = joint.momentum.scaled(g, joint.mobility);
        let zero = g.zero();
        // a push along the joint meets no resistance any more: exactly, and not up to rounding
        let (no_turn, no_slide) = (link.turns && g.is_zero(link.pitch), !link.turns);
        let less = |entry: ExprId, a: ExprId, b: ExprId, vanishes: bool| {
            let product = g.mul(a, b);
            if vanishes { zero } else { g.sub(entry, product) }
        };
        let (mut rotation, mut coupling, mut translation) = (self.rotation, self.coupling, self.translation);
        for (entry, (i, j)) in Symmetric3::PLACES.into_iter().enumerate() {
            rotation.0[entry] = less(rotation.0[entry], moment[i], given.moment[j], no_turn && j == 2);
            translation.0[entry] = less(translation.0[entry], force[i], given.force[j], no_slide && j == 2);
        }
        for (i, row) in coupling.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                let vanishes = (no_turn && i == 2) || (no_slide && j == 2);
                *entry = less(*entry, moment[i], given.force[j], vanishes);
            }
        }
        Self {
            rotation,
            coupling,
            translation,
        }
    }

    /// The wrench that an acceleration takes.
    fn times(&self, g: &Graph, [alpha, a]: &Acceleration) -> Wrench {
        let (turned, coupled) = (mat_vec(g, self.rotation.full(), *alpha), mat_vec(g, self.coupling, *a));
        let (swept, moved) = (
            mat_vec(g, transpose(self.coupling), *alpha),
            mat_vec(g, self.translation.full(), *a),
        );
        Wrench {
            moment: add(g, turned, coupled),
            force: add(g, swept, moved),
        }
    }

    /// The same inertia about the origin of the parent, in its frame.
    fn to_parent(self, g: &Graph, frame: &Frame, parent: &Frame) -> Self {
        let [rotation, translation] =
            [self.rotation, self.translation].map(|tensor| frame.tensor_to_parent(g, parent, tensor));
        let coupling = frame.matrix_to_parent(g, parent, self.coupling);
        // with [o] the cross product by the offset: H' = H + [o] M, J' = J - H [o] + [o] H'^T
        let o = crossing(g, frame.offset);
        let swept = mat_mul(g, o, translation.full());
        let moved = plus(g, coupling, swept);
        let (left, right) = (mat_mul(g, coupling, o), mat_mul(g, o, transpose(moved)));
        let change = Symmetric3(Symmetric3::PLACES.map(|(i, j)| g.sub(right[i][j], left[i][j])));
        Self {
            rotation: rotation.plus(g, change),
            coupling: moved,
            translation,
        }
    }

    fn plus(&self, g: &Graph, other: &Self) -> Self {
        Self {
            rotation: self.rotation.plus(g, other.rotation),
            coupling: plus(g, self.coupling, other.coupling),
            translation: self.translation.plus(g, other.translation),
        }
    }
}

/// The matrix of the vector product by `v`.
fn crossing(g: &Graph, [x, y, z]: Vec3) -> Mat3 {
    let zero = g.zero();
    let [nx, ny, nz] = [x, y, z].map(|x| g.neg(x));
    [[zero, nz, y], [z, zero, nx], [ny, x, zero]]
}

fn plus(g: &Graph, a: Mat3, b: Mat3) -> Mat3 {
    std::array::from_fn(|i| add(g, a[i], b[i]))
}
