//! Poses of bodies in their stations, and the screws that move them.

use rustc_hash::FxHashMap;

use crate::expr::{Expr, Graph};
use crate::model::{BodyId, Model, Poses};
use crate::screw::{SpatialInertia, Transform, Twist, Vec3};

/// Poses, screws and inertias of a model, each expressed in the station of its body.
///
/// All scalars of the dynamics are invariant under a change of frame, so each can be computed in the frame where it is
/// shortest. In a station, parallel joints turn by sums of angles, and nothing below the station appears.
#[derive(Debug)]
pub(crate) struct Kinematics<'g> {
    graph: &'g Graph,
    poses: Vec<Transform<'g>>,
    screws: Vec<Option<Twist<'g>>>,
    composites: Vec<SpatialInertia<'g>>,
    stations: Vec<Option<BodyId>>,
    parents: Vec<Option<BodyId>>,
    gravity: Vec3<'g>,
    seen: FxHashMap<(BodyId, BodyId), Twist<'g>>,
}

impl<'g> Kinematics<'g> {
    /// Computes the kinematics of a model: poses and screws in stations, and the composite inertias
    /// `N_x^+ = N_x + sum N_y^+` over the bodies y that x carries, each transformed to the station of x.
    pub(crate) fn new(model: &Model<'g>) -> Self {
        let Poses {
            poses,
            screws,
            stations,
            ..
        } = Poses::new(model);
        let mut composites: Vec<SpatialInertia<'g>> = poses
            .iter()
            .zip(&model.bodies)
            .map(|(pose, body)| pose.inertia(&body.inertia))
            .collect();
        for (n, body) in model.bodies().rev() {
            let Some(parent) = body.parent else { continue };
            let carried = if body.heading.station == Some(parent) {
                poses[parent].inertia(&composites[n])
            } else {
                composites[n]
            };
            composites[parent] = composites[parent] + carried;
        }
        Self {
            graph: model.graph,
            poses,
            screws,
            composites,
            stations,
            parents: model.bodies.iter().map(|body| body.parent).collect(),
            gravity: model.gravity,
            seen: FxHashMap::default(),
        }
    }

    /// True if body `inner` carries body `outer`, or is the same body.
    pub(crate) fn carries(&self, inner: BodyId, outer: BodyId) -> bool {
        std::iter::successors(Some(outer), |&n| self.parents[n]).any(|n| n == inner)
    }

    /// Composite inertia `N_x^+` of a body and all bodies that it carries, in its station.
    pub(crate) fn composite(&self, body: BodyId) -> SpatialInertia<'g> {
        self.composites[body]
    }

    /// Screw of the joint of body `joint`, in the station of `body`: `Ad^-1 s` through the stations between. `joint`
    /// must carry `body` or be the same body. Returns `None` for a fixed joint.
    pub(crate) fn screw(&mut self, joint: BodyId, body: BodyId) -> Option<Twist<'g>> {
        let own = self.screws[joint]?;
        let (Some(base), true) = (self.stations[body], self.stations[joint] != self.stations[body]) else {
            return Some(own);
        };
        if let Some(&seen) = self.seen.get(&(joint, base)) {
            return Some(seen);
        }
        let below = self.screw(joint, base)?;
        let twist = self.poses[base].twist_back(&below);
        self.seen.insert((joint, base), twist);
        Some(twist)
    }

    /// Acceleration of gravity in the station of a body.
    pub(crate) fn gravity(&self, body: BodyId) -> Vec3<'g> {
        match self.stations[body] {
            None => self.gravity,
            Some(base) => self.poses[base].rotation.transpose() * self.gravity(base),
        }
    }

    /// Potential energy of all bodies in gravity, `-g . sum m r`: zero if all mass is at the origin of ground.
    pub(crate) fn potential(&self) -> Expr<'g> {
        let roots = self
            .composites
            .iter()
            .zip(&self.parents)
            .filter(|(_, parent)| parent.is_none());
        let moment = roots.fold(Vec3::zero(self.graph), |sum, (composite, _)| sum + composite.moment);
        -self.gravity.dot(moment)
    }
}
