//! Accelerations by the articulated-body algorithm (Featherstone 1983; 2008, Sec. 7.3), the form whose length is linear
//! in the number of joints.
//!
//! The links above a joint respond to a push through it as one body that yields at its own joints. No mass matrix is
//! formed.
//!
//! Each quantity of link k is expressed in its [frame](Frame), about its origin; `X_k` transforms motions of the parent
//! to it, and `X_k^T` wrenches back. `s` is the screw of the joint, `tau` the force along it, `v_J` the velocity that
//! it adds, `I` the articulated inertia, `p` the wrench on the link while no joint yields, `c` the velocity-product
//! acceleration:
//!
//! ```text
//! inwards    U = I s,  d = s^T U,  u = tau - s^T p           I_a = I - U U^T / d,  p_a = p + I c + U u / d
//!            I_parent += X^T I_a X,  p_parent += X^T p_a
//! outwards   a' = X a_parent + c,  qdd = (u - U^T a') / d,  a = a' + s qdd
//! ```

use super::actions::{along_coordinates, is_wrench, wrenches};
use super::articulated_inertia::{Articulated, Joint};
use super::flight::Flights;
use super::frames::{Frame, frames};
use super::joint::JointId;
use super::links::{Link, links};
use super::motion::{acceleration_field, inertial_moment};
use super::solve::{Factored, Inverse, Solver};
use crate::expr::Expr;
use crate::model::{Action, Floating, Model};
use crate::screw::{Twist, Vec3, Wrench};

/// A scene with yielding joints, used in place of its mass matrix.
///
/// The joints of a ball yield one after the other, in one frame: together they are a block of three.
#[derive(Debug)]
pub(crate) struct Articulation<'g> {
    links: Vec<Link<'g>>,
    frames: Vec<Frame<'g>>,
    flights: Flights<'g>,
    /// Yielding joints; `None` for drives and for the slides of flights, which yield together.
    joints: Vec<Option<Joint<'g>>>,
    /// Articulated inertia of each link after its joint has yielded.
    carried: Vec<Articulated<'g>>,
    /// Factored mass matrix of each flight along the axes of the body, at the link that the flight begins with.
    floating: Vec<Option<Factored<'g>>>,
    /// Joints above a branching link.
    followers: Vec<Option<Follower<'g>>>,
    drives: usize,
}

/// Joint of a branch. If no force acts on the branch, the joint accelerates by minus the power of the `response` on the
/// acceleration of the link that carries the branch.
#[derive(Clone, Copy, Debug)]
struct Follower<'g> {
    /// The next link below that carries several branches.
    branching: JointId,
    response: Wrench<'g>,
}

/// Forces on the links, and their prescribed motion.
#[derive(Debug)]
pub(super) struct Load<'g> {
    /// Forces along the joints.
    along: Vec<Expr<'g>>,
    /// Wrench that each link requires while no joint yields or accelerates.
    pub(super) wrenches: Vec<Wrench<'g>>,
    /// Acceleration of each link relative to its parent in that case.
    pub(super) drifts: Vec<Twist<'g>>,
    /// Acceleration of the ground.
    ground: Twist<'g>,
    /// Accelerations of the drives.
    drives: Vec<Expr<'g>>,
}

/// Computes the accelerations of the coordinates of a scene. Returns them with the articulation they follow from. If
/// `pushed` is set, forces at points act as wrenches on the links. The accelerations of `floating` bodies are along
/// their axes.
pub(super) fn accelerations<'g>(
    model: &Model<'g>,
    pushed: bool,
    floating: &[Floating<'g>],
) -> (Vec<Expr<'g>>, Articulation<'g>) {
    let g = model.graph;
    let links = links(model);
    let frames = frames(model, &links.links);
    let flights = Flights::new(&links, &frames, floating);
    let (as_wrenches, others): (Vec<&Action<'g>>, Vec<_>) =
        model.actions.iter().partition(|action| pushed && is_wrench(action));
    let given = wrenches(model, &links, &frames, &as_wrenches);
    let links = links.links;
    let spins = spins(&links, &frames);
    let own = frames.iter().zip(&spins).map(|(frame, &w)| {
        let field = acceleration_field(w, Vec3::zero(g));
        Wrench {
            moment: inertial_moment(&field, frame.inertia.second),
            force: field * frame.inertia.first,
        }
    });
    let mut forces = along_coordinates(model, &others);
    floating.iter().for_each(|joint| joint.turn_forces(&mut forces));
    let forces = along_joints(&links, forces);
    let load = Load {
        along: links
            .iter()
            .zip(forces)
            .map(|(link, force)| link.force + force)
            .collect(),
        wrenches: own.zip(given).map(|(own, given)| own - given).collect(),
        drifts: JointId::all(links.len())
            .map(|k| drift(&links[k], &frames[k], spins[k], &spins))
            .collect(),
        ground: Twist {
            angular: Vec3::zero(g),
            linear: -model.gravity,
        },
        drives: model.drives.iter().map(|drive| drive.coordinate.acceleration).collect(),
    };
    let articulation = Articulation::new(model, links, frames, flights);
    (articulation.accelerations(&load), articulation)
}

impl<'g> Articulation<'g> {
    /// Inward pass: `I`, `U` and `1/d` of each joint. A drive does not yield, `I_a = I`; the three slides of a flight
    /// yield together, by the inverse of a matrix.
    pub(super) fn new(model: &Model<'g>, links: Vec<Link<'g>>, frames: Vec<Frame<'g>>, flights: Flights<'g>) -> Self {
        let mut carried: Vec<Articulated<'g>> = frames.iter().map(|frame| Articulated::rigid(&frame.inertia)).collect();
        let mut joints: Vec<Option<Joint<'g>>> = vec![None; links.len()];
        let mut floating: Vec<Option<Factored<'g>>> = links.iter().map(|_| None).collect();
        for k in JointId::all(links.len()).rev() {
            let link = &links[k];
            if flights.is_slide(k) {
                continue;
            }
            if !model.is_driven(link.coordinate) {
                let joint = carried[k].give_way(link);
                joints[k] = Some(joint);
                carried[k] = carried[k].without(link, &joint);
            }
            if let Some(flight) = flights.from(k) {
                let matrix = flight.mass_matrix(carried[k].translation);
                floating[k] = Some(Factored::new(Solver::Ldl, &matrix, None));
            } else if let Some(parent) = link.parent {
                carried[parent] = carried[parent] + carried[k].to_parent(&frames[k]);
            }
        }
        let mut articulation = Self {
            links,
            frames,
            flights,
            joints,
            carried,
            floating,
            followers: Vec::new(),
            drives: model.drives.len(),
        };
        let mut branches = vec![0; articulation.links.len()];
        for parent in articulation.links.iter().filter_map(|link| link.parent) {
            branches[usize::from(parent)] += 1;
        }
        let all = JointId::all(branches.len());
        articulation.followers = all.map(|k| articulation.follower(k, &branches)).collect();
        articulation
    }

    /// Follows the response of a joint inwards, through joints that yield to it, to the next branching link.
    fn follower(&self, k: JointId, branches: &[usize]) -> Option<Follower<'g>> {
        let joint = self.joints[k]?;
        let below = std::iter::successors(self.parent_of(k), |&link| self.parent_of(link));
        let branching = below.into_iter().find(|&link| branches[usize::from(link)] > 1)?;
        let (mut at, mut response) = (k, joint.mobility * joint.momentum);
        loop {
            let parent = self.parent_of(at)?;
            response = self.frames[at].wrench_to_parent(&response);
            if parent == branching {
                return Some(Follower { branching, response });
            }
            self.joints[parent]?;
            response = self.passed_on(parent, response);
            at = parent;
        }
    }

    pub(super) fn drives(&self) -> usize {
        self.drives
    }

    pub(super) fn links(&self) -> &[Link<'g>] {
        &self.links
    }

    pub(super) fn frame(&self, k: JointId) -> &Frame<'g> {
        &self.frames[k]
    }

    /// Link that carries another one and its wrench; none for ground, and where a flight begins.
    pub(super) fn parent_of(&self, k: JointId) -> Option<JointId> {
        self.links[k]
            .parent
            .filter(|_| self.flights.from(k).is_none() && !self.flights.is_slide(k))
    }

    /// Wrench that is left of a wrench on a link when its joint yields to it: `p - U (s^T p) / d`.
    pub(super) fn passed_on(&self, k: JointId, wrench: Wrench<'g>) -> Wrench<'g> {
        match &self.joints[k] {
            Some(joint) => wrench - wrench.power(&self.links[k].screw) * (joint.mobility * joint.momentum),
            None => wrench,
        }
    }

    /// Load by forces along the coordinates, the drives included.
    pub(super) fn load(&self, zero: Expr<'g>, forces: Vec<Expr<'g>>) -> Load<'g> {
        let still = Vec3([zero; 3]);
        let (force, moment, angular, linear) = (still, still, still, still);
        let (twist, n) = (Twist { angular, linear }, self.links.len());
        Load {
            along: along_joints(&self.links, forces),
            wrenches: vec![Wrench { moment, force }; n],
            drifts: vec![twist; n],
            ground: twist,
            drives: vec![zero; self.drives],
        }
    }

    /// Accelerations `qdd` of the coordinates under a load.
    fn accelerations(&self, load: &Load<'g>) -> Vec<Expr<'g>> {
        self.accelerations_with(load, |_| ())
    }

    /// Accelerations of the coordinates under a load. `more` changes the forces along the joints after the inward pass,
    /// when they no longer act on the links below.
    pub(super) fn accelerations_with(&self, load: &Load<'g>, more: impl FnOnce(&mut [Expr<'g>])) -> Vec<Expr<'g>> {
        let zero = load.ground.linear[0].graph().zero();
        let dof = self.joints.iter().flatten().count() + 3 * self.floating.iter().flatten().count();
        let mut accelerations = vec![zero; dof];
        accelerations.extend(&load.drives);
        let mut left = self.left_to_accelerate(load, &accelerations);
        more(&mut left);
        self.accelerate(load, &left, &mut accelerations);
        accelerations.truncate(dof);
        accelerations
    }

    /// Inward pass: `u = tau - s^T p` of each joint, and the accelerations of the slides of flights. The wrench on the
    /// parent is `p_a = p + I c + U u / d`, for a driven joint `p + I (c + s qdd)`.
    fn left_to_accelerate(&self, load: &Load<'g>, drives: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let (mut wrenches, mut left) = (load.wrenches.clone(), load.along.clone());
        for k in JointId::all(self.links.len()).rev() {
            if self.flights.is_slide(k) {
                continue;
            }
            let (link, wrench, carried) = (&self.links[k], wrenches[k], self.carried[k]);
            let wrench = match &self.joints[k] {
                Some(joint) => {
                    left[k] = load.along[k] - wrench.power(&link.screw);
                    wrench + carried * load.drifts[k] + left[k] * (joint.mobility * joint.momentum)
                }
                // a drive does not yield: its link accelerates as prescribed
                None => wrench + carried * (load.drifts[k] + driven(link, drives)),
            };
            if let (Some(flight), Some(matrix)) = (self.flights.from(k), &self.floating[k]) {
                let taken = flight.slides.into_iter().zip(flight.along_axes(wrench.force));
                let taken: Vec<Expr<'g>> = taken.map(|(slide, taken)| taken - load.along[slide]).collect();
                let solved = flight.slides.into_iter().zip(matrix.solve_negated(&taken));
                solved.for_each(|(slide, acceleration)| left[slide] = acceleration);
            } else if let Some(parent) = link.parent {
                wrenches[parent] = wrenches[parent] + self.frames[k].wrench_to_parent(&wrench);
            }
        }
        left
    }

    /// Outward pass: `qdd = (u - U^T a') / d` and `a = a' + s qdd`. If a joint follows others, the contributions of
    /// coordinates below are subtracted from its own acceleration.
    fn accelerate(&self, load: &Load<'g>, left: &[Expr<'g>], accelerations: &mut [Expr<'g>]) {
        let mut motions: Vec<Twist<'g>> = Vec::new();
        // links that only follow the motion of the branching link below them
        let mut follow: Vec<bool> = Vec::new();
        for (k, link) in JointId::all(self.links.len()).zip(&self.links) {
            let parent_follows = self.followers[k].is_some_and(|follower| {
                link.parent == Some(follower.branching) || link.parent.is_some_and(|parent| follow[parent])
            });
            follow.push(parent_follows && left[k].is_zero() && load.drifts[k].is_zero());
            if self.flights.is_slide(k) {
                accelerations[link.coordinate] = left[k];
                motions.push(load.ground);
                continue;
            }
            let arriving = self.arriving(k, &motions, load.ground, left) + load.drifts[k];
            let Some(joint) = &self.joints[k] else {
                motions.push(arriving + driven(link, accelerations));
                continue;
            };
            let second_rate = match self.followers[k].filter(|_| follow[k]) {
                Some(Follower { branching, response }) => -response.power(&motions[branching]),
                None => (left[k] - joint.momentum.power(&arriving)) * joint.mobility,
            };
            motions.push(arriving + second_rate * link.screw);
            // q_k = factor * own + others, where the others are coordinates of links below
            let others = link.motion.without(link.coordinate);
            let own = others
                .terms()
                .fold(second_rate, |own, (other, factor)| own - factor * accelerations[other]);
            accelerations[link.coordinate] = link.motion.factor(link.coordinate) * own;
        }
    }

    /// Acceleration `X a_parent` that arrives at a link: with offset `o`, `alpha = R^T alpha_p` and
    /// `a = R^T (a_p + alpha_p x o)`.
    fn arriving(&self, k: JointId, motions: &[Twist<'g>], ground: Twist<'g>, left: &[Expr<'g>]) -> Twist<'g> {
        if let Some(flight) = self.flights.from(k) {
            return Twist {
                angular: ground.angular,
                linear: flight.of_axes(flight.slides.map(|slide| left[slide])),
            };
        }
        let frame = &self.frames[k];
        let below = match self.links[k].parent.map(|parent| motions[parent]) {
            Some(below) => Twist {
                angular: below.angular,
                linear: below.linear + below.angular.cross(frame.offset),
            },
            None => ground,
        };
        Twist {
            angular: frame.of_parent(below.angular),
            linear: frame.of_parent(below.linear),
        }
    }
}

impl<'g> Inverse<'g> for Articulation<'g> {
    fn solve_negated(&self, r: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let zero = r[0].graph().zero();
        let drives = std::iter::repeat_n(zero, self.drives);
        let forces = r.iter().map(|&x| -x).chain(drives).collect();
        self.accelerations(&self.load(zero, forces))
    }
}

/// Converts forces along the coordinates to forces along the joints: with `q = T theta`, `T^T tau = Q` is solved from
/// the outermost link inwards.
fn along_joints<'g>(links: &[Link<'g>], mut forces: Vec<Expr<'g>>) -> Vec<Expr<'g>> {
    let along = links.iter().rev().map(|link| {
        let along = link.motion.factor(link.coordinate) * forces[link.coordinate];
        for (k, factor) in link.motion.terms() {
            forces[k] += -factor * along;
        }
        along
    });
    let mut along: Vec<Expr<'g>> = along.collect();
    along.reverse();
    along
}

/// Acceleration `s qdd` of a driven joint.
fn driven<'g>(link: &Link<'g>, accelerations: &[Expr<'g>]) -> Twist<'g> {
    let g = link.force.graph();
    link.motion.of(g, |k| accelerations[k]) * link.screw
}

/// Angular velocity of each link, in its frame: `w = R^T w_p + w_J`.
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

/// Velocity-product acceleration `c` of a link, when neither its joint nor the link below accelerates:
/// `alpha = w x w_J`, `a = R^T (w_p x (w_p x o)) + 2 w x v_J`.
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
