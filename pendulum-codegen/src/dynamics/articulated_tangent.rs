//! Derivatives of the accelerations of articulated bodies, link by link.
//!
//! A change of a joint coordinate, or of its rate, changes the motion that arrives at the link of the joint (see
//! [`tangent`](super::tangent)). The links above it yield at their joints: they respond as one articulated body, to the
//! change of acceleration with their articulated inertia `I`, and to the change of spin with a matrix `B`, which is
//! accumulated inwards like `I`. The velocities in `B` are those relative to the first link of the tree, so that a
//! change of spin arrives at all links alike:
//!
//! ```text
//! inwards    b = s^T B,  B_parent += X^T (B - U b / d) X
//! column     p = B spin + I (twist; push) at the joint, then inwards and outwards as for the accelerations
//! ```
//!
//! A column takes a number of operations that is linear in the number of joints.

use num_traits::Zero;

use super::Balance;
use super::articulated::Articulation;
use super::flight::Flights;
use super::frames::{Frame, frames};
use super::jacobian::StateVariable;
use super::joint::JointId;
use super::links::{Link, links};
use super::motion::{Motion, motions};
use super::recursive::wrenches_of;
use super::solve::Inverse;
use super::tangent::{Flow, Variation, seen_below, velocity_of_origin};
use crate::expr::{Derivative, Expr};
use crate::model::{Coordinate, Floating, Model};
use crate::screw::{Twist, Vec3, Wrench};

/// Derivatives of the accelerations of a model.
#[derive(Debug)]
pub(crate) struct ArticulatedTangent<'g> {
    articulation: Articulation<'g>,
    /// `B` of each link, with its own joint locked: the wrench for a unit of spin about each axis.
    spun: Vec<[Wrench<'g>; 3]>,
    /// Changes of the motion at each joint, by its coordinate and by its rate; none by coordinates of orientations, and
    /// for slides of flights.
    changes: Vec<[Option<Change<'g>>; 2]>,
}

/// Change of the motion at a joint.
#[derive(Clone, Copy, Debug)]
struct Change<'g> {
    variation: Variation<'g>,
    /// Change of the wrench on the parent, at fixed motion of the link.
    turned: Wrench<'g>,
}

impl<'g> Change<'g> {
    /// Changes by the coordinate of a joint and by its rate. `wrench` is that of the link with all links that it
    /// carries, `velocity` that of its origin relative to the first link of the tree.
    fn by_position_and_rate(
        link: &Link<'g>,
        motion: &Motion<'g>,
        wrench: &Wrench<'g>,
        velocity: Vec3<'g>,
    ) -> [Option<Self>; 2] {
        let zero = Vec3::zero(velocity[0].graph());
        let (moment, force) = (zero, zero);
        let still = Wrench { moment, force };
        let [by_position, by_rate] = Variation::by_position_and_rate(link, motion).map(|variation| Variation {
            push: variation.push - 2 * variation.spin.cross(velocity),
            ..variation
        });
        let by_position = Self {
            variation: by_position,
            turned: seen_below(&link.screw, wrench, &still),
        };
        let by_rate = Self {
            variation: by_rate,
            turned: still,
        };
        // an orientation has no coordinates
        [Some(by_position).filter(|_| link.spin.is_none()), Some(by_rate)]
    }
}

impl<'g> ArticulatedTangent<'g> {
    /// The accelerations of `floating` bodies are along their own axes.
    pub(crate) fn new(model: &Model<'g>, floating: &[Floating<'g>]) -> Self {
        let links = links(model);
        let frames = frames(model, &links.links);
        let flights = Flights::new(&links, &frames, floating);
        let links = links.links;
        let second_rates: Vec<Expr<'g>> = links.iter().map(|link| model.acceleration_of(&link.motion)).collect();
        let motions = motions(&links, &frames, &flights, model.gravity, &second_rates);
        let wrenches = wrenches_of(&links, &frames, &motions, None);
        let velocities = velocities(&links, &frames, &flights, &motions);
        let changes = JointId::all(links.len()).map(|j| match flights.is_slide(j) {
            true => [None, None],
            false => Change::by_position_and_rate(&links[j], &motions[j], &wrenches[j], velocities[j]),
        });
        let changes = changes.collect();
        let locked = JointId::all(links.len()).map(|k| {
            let flow = Flow::of_link(&frames[k], &motions[k], velocities[k]);
            let by_spin = |axis| Variation::of_spin(Vec3::unit(model.graph, axis));
            [0, 1, 2].map(|axis| by_spin(axis).taken(&frames[k].inertia, &flow))
        });
        let mut spun: Vec<[Wrench<'g>; 3]> = locked.collect();
        let articulation = Articulation::new(model, links, frames, flights);
        for k in JointId::all(spun.len()).rev() {
            let Some(parent) = articulation.parent_of(k) else {
                continue;
            };
            let (left, frame) = (
                spun[k].map(|wrench| articulation.passed_on(k, wrench)),
                articulation.frame(k),
            );
            for (axis, sum) in spun[parent].iter_mut().enumerate() {
                let wrench = along(left, frame.of_parent(Vec3::unit(model.graph, axis)));
                *sum = *sum + frame.wrench_to_parent(&wrench);
            }
        }
        Self {
            articulation,
            spun,
            changes,
        }
    }

    /// The bodies whose accelerations are derived.
    pub(crate) fn articulation(&self) -> &Articulation<'g> {
        &self.articulation
    }

    /// Derivatives of the accelerations that satisfy a balance: one column for each variable. Those with respect to
    /// quaternions are solved from the derivatives of the balance. Returns `None` if the forces are not known apart.
    pub(crate) fn columns(
        &self,
        balance: &Balance<'g>,
        coordinates: &[Coordinate<'g>],
        variables: &[Expr<'g>],
    ) -> Option<Vec<Vec<Expr<'g>>>> {
        let force = &balance.tangent.as_ref()?.force;
        let column = |&variable: &Expr<'g>| {
            let mut derivative = Derivative::by(variable);
            let mut derived = |rows: &[Expr<'g>]| rows.iter().map(|&row| derivative.of(row)).collect();
            match StateVariable::of(coordinates, variable) {
                Some(variable) => self.column(variable, derived(force)),
                None => self.articulation.solve_negated(&derived(&balance.rows)),
            }
        };
        Some(variables.iter().map(column).collect())
    }

    /// Derivatives of the accelerations by a variable of the state, given those of the forces along the coordinates.
    fn column(&self, variable: StateVariable, mut forces: Vec<Expr<'g>>) -> Vec<Expr<'g>> {
        let g = forces[0].graph();
        forces.resize(forces.len() + self.articulation.drives(), g.zero());
        let (k, by_rate) = match variable {
            StateVariable::Position(k) => (k, false),
            StateVariable::Rate(k) => (k, true),
        };
        let mut load = self.articulation.load(g.zero(), forces);
        let n = self.spun.len();
        let mut spins = vec![Vec3::zero(g); n];
        for (j, link) in JointId::all(n).zip(self.articulation.links()) {
            let factor = link.motion.factor(k);
            let Some(change) = self.changes[j][usize::from(by_rate)].filter(|_| !factor.is_zero()) else {
                continue;
            };
            let factor = g.number(factor);
            let Variation { spin, twist, push } = change.variation;
            spins[j] = factor * spin;
            load.wrenches[j] = load.wrenches[j] + along(self.spun[j], spins[j]);
            load.drifts[j] = factor
                * Twist {
                    angular: twist,
                    linear: push,
                };
            if let Some(parent) = self.articulation.parent_of(j) {
                let turned = self.articulation.frame(j).wrench_to_parent(&(factor * change.turned));
                load.wrenches[parent] = load.wrenches[parent] + turned;
            }
        }
        self.articulation.accelerations_with(&load, |left| {
            for (j, link) in JointId::all(n).zip(self.articulation.links()) {
                let Some(parent) = self.articulation.parent_of(j) else {
                    continue;
                };
                let arriving = self.articulation.frame(j).of_parent(spins[parent]);
                let required = self.spun[j].map(|wrench| wrench.power(&link.screw));
                left[j] -= Vec3(required).dot(arriving);
                spins[j] = spins[j] + arriving;
            }
        })
    }
}

/// Wrench for a spin, from those for a unit about each axis.
fn along<'g>(wrenches: [Wrench<'g>; 3], spin: Vec3<'g>) -> Wrench<'g> {
    let [x, y, z] = wrenches;
    spin[0] * x + spin[1] * y + spin[2] * z
}

/// Velocity of the origin of each link relative to the origin of the first link of its tree, in the frame of the link.
fn velocities<'g>(
    links: &[Link<'g>],
    frames: &[Frame<'g>],
    flights: &Flights<'g>,
    motions: &[Motion<'g>],
) -> Vec<Vec3<'g>> {
    let mut velocities: Vec<Vec3<'g>> = Vec::new();
    for (k, link) in JointId::all(links.len()).zip(links) {
        velocities.push(match link.parent {
            Some(parent) if flights.from(k).is_none() => {
                frames[k].of_parent(velocities[parent] + velocity_of_origin(link, &frames[k], motions))
            }
            _ => Vec3::zero(link.force.graph()),
        });
    }
    velocities
}
