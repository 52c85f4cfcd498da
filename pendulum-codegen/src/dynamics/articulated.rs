//! Accelerations by articulated bodies (Featherstone 1983; 2008, Sec. 7.3): the form whose length grows with the number of joints only.
//!
//! The links above a joint answer a push through it as one body that gives way at its own joints. No mass matrix is formed.

use std::ops::{Add, Mul};

use super::actions::{along_coordinates, is_wrench, wrenches};
use super::frames::{Frame, frames};
use super::joints::JointId;
use super::links::{Link, links};
use super::motion::{acceleration_field, inertial_moment};
use crate::expr::Expr;
use crate::model::{Action, Model};
use crate::screw::{MassMoments, Mat3, Symmetric3, Twist, Vec3, Wrench};

/// The inertia of a link whose outer joints give way: `moment = rotation alpha + coupling a`, `force = coupling^T alpha + translation a`.
#[derive(Clone, Copy, Debug)]
struct Articulated<'g> {
    rotation: Symmetric3<'g>,
    coupling: Mat3<'g>,
    translation: Symmetric3<'g>,
}

/// What a joint gives way by.
#[derive(Clone, Copy, Debug)]
struct Joint<'g> {
    /// The articulated inertia times the joint's screw.
    momentum: Wrench<'g>,
    /// One over the inertia along the joint.
    mobility: Expr<'g>,
    /// The force along the joint that is left to accelerate it.
    force: Expr<'g>,
}

/// The accelerations of the coordinates of a scene; with what acts on it as wrenches on the links, where `pushed`.
pub(super) fn accelerations<'g>(model: &Model<'g>, pushed: bool) -> Vec<Expr<'g>> {
    let g = model.graph;
    let links = links(model);
    let frames = frames(model, &links.links);
    let (as_wrenches, others): (Vec<&Action<'g>>, Vec<_>) =
        model.actions.iter().partition(|action| pushed && is_wrench(action));
    let given = wrenches(model, &links, &frames, &as_wrenches);
    let mut links = links.links;
    along_links(&mut links, along_coordinates(model, &others));
    let spins = spins(&links, &frames);
    let mut inertias: Vec<Articulated<'g>> = Vec::new();
    let mut wrenches: Vec<Wrench<'g>> = Vec::new();
    for (frame, &w) in frames.iter().zip(&spins) {
        inertias.push(Articulated::rigid(&frame.inertia));
        let field = acceleration_field(w, Vec3::zero(g));
        wrenches.push(Wrench {
            moment: inertial_moment(&field, frame.inertia.second),
            force: field * frame.inertia.first,
        });
    }
    for (wrench, given) in wrenches.iter_mut().zip(given) {
        *wrench = *wrench - given;
    }
    let drifts: Vec<Twist<'g>> = JointId::all(links.len())
        .map(|k| drift(&links[k], &frames[k], spins[k], &spins))
        .collect();
    let is_driven = |link: &Link<'g>| model.is_driven(link.coordinate);
    // along a driven joint, of which the coordinate is the drive alone
    let second_rate = |link: &Link<'g>| model.driven_acceleration_of(&link.motion);
    let mut joints: Vec<Option<Joint<'g>>> = Vec::new();
    for k in JointId::all(links.len()).rev() {
        let (link, frame) = (&links[k], &frames[k]);
        let joint = (!is_driven(link)).then(|| inertias[k].give_way(link, &wrenches[k]));
        joints.push(joint);
        let Some(parent) = link.parent else { continue };
        let (carried, wrench) = match joint {
            Some(joint) => {
                let carried = inertias[k].without(link, &joint);
                let left = joint.force * (joint.mobility * joint.momentum);
                (carried, wrenches[k] + carried * drifts[k] + left)
            }
            // a drive does not give way: what it carries is accelerated as it prescribes
            None => (
                inertias[k],
                wrenches[k] + inertias[k] * (drifts[k] + second_rate(link) * link.screw),
            ),
        };
        wrenches[parent] = wrenches[parent] + frame.wrench_to_parent(&wrench);
        inertias[parent] = inertias[parent] + carried.to_parent(frame);
    }
    joints.reverse();
    let mut accelerations = vec![g.zero(); model.dof() + model.drives.len()];
    let mut motions: Vec<Twist<'g>> = Vec::new();
    for (k, (link, joint)) in JointId::all(links.len()).zip(links.iter().zip(&joints)) {
        let frame = &frames[k];
        let below = match link.parent.map(|parent| motions[parent]) {
            Some(below) => Twist {
                angular: below.angular,
                linear: below.linear + below.angular.cross(frame.offset),
            },
            None => Twist {
                angular: Vec3::zero(g),
                linear: -model.gravity,
            },
        };
        let arriving = Twist {
            angular: frame.of_parent(below.angular),
            linear: frame.of_parent(below.linear),
        };
        let arriving = arriving + drifts[k];
        let Some(joint) = joint else {
            motions.push(arriving + second_rate(link) * link.screw);
            accelerations[link.coordinate] = model.coordinate(link.coordinate).acceleration;
            continue;
        };
        let second_rate = (joint.force - joint.momentum.power(&arriving)) * joint.mobility;
        motions.push(arriving + second_rate * link.screw);
        // q_k = factor * own + others, where the others are coordinates of links below
        let others = link.motion.without(link.coordinate);
        let own = others
            .terms()
            .fold(second_rate, |own, (other, factor)| own - factor * accelerations[other]);
        accelerations[link.coordinate] = link.motion.factor(link.coordinate) * own;
    }
    accelerations.truncate(model.dof());
    accelerations
}

/// Adds forces along the coordinates to those along the joints: with `q = T theta`, `T^T tau = Q` is solved from the outermost link on.
fn along_links<'g>(links: &mut [Link<'g>], mut forces: Vec<Expr<'g>>) {
    for link in links.iter_mut().rev() {
        let along = link.motion.factor(link.coordinate) * forces[link.coordinate];
        for (k, factor) in link.motion.terms() {
            forces[k] += -factor * along;
        }
        link.force += along;
    }
}

/// The angular velocity of each link, in its frame.
fn spins<'g>(links: &[Link<'g>], frames: &[Frame<'g>]) -> Vec<Vec3<'g>> {
    let mut spins: Vec<Vec3<'g>> = Vec::new();
    for (link, frame) in links.iter().zip(frames) {
        let own = frame.velocity.angular;
        spins.push(match link.parent {
            Some(parent) => frame.of_parent(spins[parent]) + own,
            None => own,
        });
    }
    spins
}

/// The acceleration of a link when neither its joint nor the link below accelerates: what the rates alone bring.
fn drift<'g>(link: &Link<'g>, frame: &Frame<'g>, w: Vec3<'g>, spins: &[Vec3<'g>]) -> Twist<'g> {
    let g = link.force.graph();
    let Some(parent) = link.parent else {
        return Twist::zero(g);
    };
    let field = acceleration_field(spins[parent], Vec3::zero(g));
    let swept = frame.of_parent(field * frame.offset);
    let Twist { angular, linear } = frame.velocity;
    Twist {
        angular: w.cross(angular),
        linear: swept + w.cross(2 * linear),
    }
}

impl<'g> Articulated<'g> {
    fn rigid(inertia: &MassMoments<'g>) -> Self {
        Self {
            rotation: inertia.rotational(),
            coupling: Mat3::cross(inertia.first),
            translation: Symmetric3::diagonal([inertia.mass; 3]),
        }
    }

    fn give_way(&self, link: &Link<'g>, wrench: &Wrench<'g>) -> Joint<'g> {
        let momentum = *self * link.screw;
        let (inertia, taken) = (momentum.power(&link.screw), wrench.power(&link.screw));
        Joint {
            momentum,
            mobility: inertia.recip(),
            force: link.force - taken,
        }
    }

    /// The inertia that is left when the joint gives way.
    fn without(&self, link: &Link<'g>, joint: &Joint<'g>) -> Self {
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

    /// The same inertia about the origin of the parent, in its frame.
    fn to_parent(self, frame: &Frame<'g>) -> Self {
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
