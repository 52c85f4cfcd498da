//! Where bodies are, in their stations, and which screws move them.

use std::collections::HashMap;

use crate::expr::{ExprId, Graph};
use crate::model::{Body, Heading, Model, combine};
use crate::screw::{SpatialInertia, Transform, Twist, Vec3, add, cross, dot, mat_mul, mat_vec, rotation, scale, sub};

/// Poses, screws and inertias of a model, each written in the station of its body.
///
/// All scalars of the dynamics are invariant under a change of frame, so each may be computed where it is shortest. In a
/// station, parallel joints turn by sums of angles and what lies below the station does not appear at all.
#[derive(Debug)]
pub struct Kinematics {
    poses: Vec<Transform>,
    screws: Vec<Option<Twist>>,
    composites: Vec<SpatialInertia>,
    stations: Vec<Option<usize>>,
    parents: Vec<Option<usize>>,
    gravity: Vec3,
    seen: HashMap<(usize, usize), Twist>,
}

impl Kinematics {
    /// The kinematics of a model.
    pub fn new(model: &Model) -> Self {
        let g = &model.graph;
        let mut poses: Vec<Transform> = Vec::new();
        let mut screws = Vec::new();
        for body in &model.bodies {
            let base = match body.parent {
                Some(parent) if body.heading.station != Some(parent) => poses[parent],
                _ => Transform::identity(g),
            };
            let angle = combine(g, &model.coordinates, &body.heading.turn, |c| c.position);
            let turned = orientation(g, &body.heading, angle);
            let position = combine(g, &model.coordinates, &body.motion, |c| c.position);
            let (translation, screw) = place(g, &base, body, turned, position);
            poses.push(Transform {
                rotation: turned,
                translation,
            });
            screws.push(screw);
        }
        let mut composites: Vec<SpatialInertia> = Vec::new();
        for (pose, body) in poses.iter().zip(&model.bodies) {
            composites.push(pose.inertia(g, &body.inertia));
        }
        let stations: Vec<_> = model.bodies.iter().map(|b| b.heading.station).collect();
        for n in (0..model.bodies.len()).rev() {
            let Some(parent) = model.bodies[n].parent else { continue };
            let carried = if stations[n] == Some(parent) {
                poses[parent].inertia(g, &composites[n])
            } else {
                composites[n]
            };
            composites[parent] = composites[parent].plus(g, &carried);
        }
        let parents = model.bodies.iter().map(|b| b.parent).collect();
        Self {
            poses,
            screws,
            composites,
            stations,
            parents,
            gravity: model.gravity,
            seen: HashMap::new(),
        }
    }

    /// Whether body `inner` carries body `outer`, or is it.
    pub fn carries(&self, inner: usize, outer: usize) -> bool {
        std::iter::successors(Some(outer), |&n| self.parents[n]).any(|n| n == inner)
    }

    /// The inertia of a body and all that it carries, in its station: `N_x^+`.
    pub fn composite(&self, body: usize) -> &SpatialInertia {
        &self.composites[body]
    }

    /// The screw of the joint of `joint`, in the station of `body`, which it carries or is. A fixed joint has none.
    pub fn screw(&mut self, g: &Graph, joint: usize, body: usize) -> Option<Twist> {
        let own = self.screws[joint]?;
        let (Some(base), true) = (self.stations[body], self.stations[joint] != self.stations[body]) else {
            return Some(own);
        };
        if let Some(&seen) = self.seen.get(&(joint, base)) {
            return Some(seen);
        }
        let below = self.screw(g, joint, base)?;
        let twist = self.poses[base].twist_back(g, &below);
        self.seen.insert((joint, base), twist);
        Some(twist)
    }

    /// The acceleration of gravity in the station of a body.
    pub fn gravity(&self, g: &Graph, body: usize) -> Vec3 {
        match self.stations[body] {
            None => self.gravity,
            Some(base) => {
                let below = self.gravity(g, base);
                self.poses[base].vector_back(g, below)
            }
        }
    }

    /// Potential energy of all bodies in gravity, zero where all mass is at the origin of ground.
    pub fn potential(&self, g: &Graph) -> ExprId {
        let mut moment = [g.zero(); 3];
        for root in (0..self.parents.len()).filter(|&n| self.parents[n].is_none()) {
            moment = add(g, moment, self.composites[root].moment);
        }
        let work = dot(g, self.gravity, moment);
        g.neg(work)
    }
}

fn orientation(g: &Graph, heading: &Heading, angle: ExprId) -> [Vec3; 3] {
    match heading.axis {
        None => heading.rest,
        Some(axis) => {
            let turn = rotation(g, axis, angle);
            mat_mul(g, turn, heading.rest)
        }
    }
}

/// Where a body's origin is and what the screw of its joint is, in the frame in which its parent stands at `base`.
fn place(g: &Graph, base: &Transform, body: &Body, turned: [Vec3; 3], position: ExprId) -> (Vec3, Option<Twist>) {
    let joint = base.then(g, &body.placement);
    let Some(screw) = body.screw else {
        return (joint.translation, None);
    };
    let zero = g.zero();
    if screw.angular == [zero; 3] {
        let slide = scale(g, position, screw.linear);
        return (joint.point(g, slide), Some(joint.twist(g, &screw)));
    }
    // a turn does not move its own axis, so the axis needs the constant rotation only
    let angular = mat_vec(g, body.heading.rest, screw.angular);
    let linear = mat_vec(g, joint.rotation, screw.linear);
    let moment = cross(g, joint.translation, angular);
    let twist = Twist {
        angular,
        linear: add(g, linear, moment),
    };
    // exp(s q) moves the origin by (1 - R) (w x v) + w (w . v) q
    let pitch = dot(g, screw.angular, screw.linear);
    let arm = cross(g, screw.angular, screw.linear);
    let advance = g.mul(pitch, position);
    let along = scale(g, advance, angular);
    let before = joint.point(g, arm);
    let after = mat_vec(g, turned, arm);
    let moved = sub(g, before, after);
    (add(g, moved, along), Some(twist))
}
