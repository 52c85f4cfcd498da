//! Derivatives of inverse dynamics, link by link, without differentiating its expressions.
//!
//! The method of Carpentier and Mansard (2018) and Singh, Russo and Wensing (2022), in terms of moments of mass: in the
//! frame of link k, a change of its joint coordinate or of its rate changes only the motion that arrives from below.
//! The links above respond as one body with their composite inertia and the flow of their mass.

use super::flight::Flights;
use super::frames::Frame;
use super::joint::{Entry, JointId};
use super::links::Link;
use super::motion::Motion;
use crate::expr::Expr;
use crate::screw::{MassMoments, Mat3, Twist, Vec3, Wrench};

/// Derivatives of the forces along the joints (rows) at fixed joint accelerations.
#[derive(Debug, Default)]
pub(super) struct Tangent<'g> {
    /// With respect to the joint coordinates.
    pub(super) by_position: Vec<Entry<'g>>,
    /// With respect to their rates.
    pub(super) by_rate: Vec<Entry<'g>>,
}

/// Flow of mass relative to the origin of a frame, which moves along: `p = integral v dm` and `P = integral r v^T dm`,
/// where `v` is the velocity relative to the origin.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flow<'g> {
    momentum: Vec3<'g>,
    moments: Mat3<'g>,
}

/// Variation of the motion that arrives at a link. It adds `push + twist x r + 2 spin x v` to the acceleration of a
/// point at `r` with velocity `v` relative to the origin.
#[derive(Clone, Copy, Debug)]
pub(super) struct Variation<'g> {
    pub(super) spin: Vec3<'g>,
    pub(super) twist: Vec3<'g>,
    pub(super) push: Vec3<'g>,
}

/// Response of the force along the joint of a link to a variation of the motion of a frame that carries it.
#[derive(Clone, Copy, Debug)]
struct Response<'g> {
    /// Response to push and twist: the momentum at unit rate of the joint.
    wrench: Wrench<'g>,
    /// Response to spin.
    by_spin: Vec3<'g>,
}

impl<'g> Tangent<'g> {
    /// Computes the derivatives of `tau_i = s_i^T F_i` for all pairs of links on one path. `wrenches` are the `F` of
    /// the motions: of each link with all links that it carries.
    ///
    /// For a link i below j, column j of row i is the additional wrench that the composite of j requires, transformed
    /// to i, along `s_i`. Column i of row j is the response of joint j to the variation of the motion that arrives
    /// through joint i.
    pub(super) fn new(
        links: &[Link<'g>],
        frames: &[Frame<'g>],
        flights: &Flights<'g>,
        composites: &[MassMoments<'g>],
        motions: &[Motion<'g>],
        wrenches: &[Wrench<'g>],
    ) -> Self {
        let joints = || JointId::all(links.len());
        let velocities: Vec<Vec3<'g>> = joints()
            .map(|n| velocity_of_origin(&links[n], &frames[n], motions))
            .collect();
        let flows = flows(links, frames, composites, motions, &velocities);
        let variations: Vec<[Variation<'g>; 2]> = links
            .iter()
            .zip(motions)
            .map(|(link, motion)| Variation::by_position_and_rate(link, motion))
            .collect();
        let mut tangent = Self::default();
        for j in joints().filter(|&j| !flights.is_slide(j)) {
            let screw = &links[j].screw;
            let [by_position, by_rate] = variations[j].map(|variation| variation.taken(&composites[j], &flows[j]));
            let mut columns = [seen_below(screw, &wrenches[j], &by_position), by_rate];
            let mut response = Response::of_joint(screw, &composites[j], &flows[j]);
            let mut at = j;
            loop {
                let [by_position, by_rate] = columns.map(|wrench| wrench.power(&links[at].screw));
                tangent.by_position.push((at, j, by_position));
                tangent.by_rate.push((at, j, by_rate));
                if at != j {
                    let [by_position, by_rate] = variations[at].map(|variation| response.to(&variation));
                    tangent.by_position.push((j, at, by_position));
                    tangent.by_rate.push((j, at, by_rate));
                }
                if let Some(flight) = flights.from(at) {
                    let [by_position, by_rate] = columns.map(|wrench| flight.along_axes(wrench.force));
                    let entry = |(slide, force)| (slide, j, force);
                    let entries = |along: [Expr<'g>; 3]| flight.slides.into_iter().zip(along).map(entry);
                    tangent.by_position.extend(entries(by_position));
                    tangent.by_rate.extend(entries(by_rate));
                    break;
                }
                let Some(parent) = links[at].parent else { break };
                columns = columns.map(|wrench| frames[at].wrench_to_parent(&wrench));
                response = response.to_parent(&frames[at], velocities[at]);
                at = parent;
            }
        }
        tangent
    }
}

/// Velocity of a link's origin relative to its parent's origin, in the frame of the parent.
pub(super) fn velocity_of_origin<'g>(link: &Link<'g>, frame: &Frame<'g>, motions: &[Motion<'g>]) -> Vec3<'g> {
    match link.parent {
        Some(parent) => motions[parent].w.cross(frame.offset) + frame.to_parent(frame.velocity.linear),
        None => Vec3::zero(link.force.graph()),
    }
}

/// Flow of each link with all links that it carries. With v the velocity of the link's origin relative to its parent's,
/// and o its offset, `p' = R p + m v` is added to p of the parent, and `R P R^T + (R h) v^T + o p'^T` to P.
fn flows<'g>(
    links: &[Link<'g>],
    frames: &[Frame<'g>],
    composites: &[MassMoments<'g>],
    motions: &[Motion<'g>],
    velocities: &[Vec3<'g>],
) -> Vec<Flow<'g>> {
    let own = |(frame, motion): (&Frame<'g>, &Motion<'g>)| {
        Flow::of_link(frame, motion, Vec3::zero(frame.inertia.mass.graph()))
    };
    let mut flows: Vec<Flow<'g>> = frames.iter().zip(motions).map(own).collect();
    for n in JointId::all(links.len()).rev() {
        let Some(parent) = links[n].parent else { continue };
        let (frame, v, below) = (&frames[n], velocities[n], flows[parent]);
        let first = frame.to_parent(composites[n].first);
        let momentum = frame.to_parent(flows[n].momentum) + composites[n].mass * v;
        let turned = frame.matrix_to_parent(flows[n].moments);
        let moments = Mat3::from_fn(|i, j| {
            below.moments[i][j] + (turned[i][j] + (first[i] * v[j] + frame.offset[i] * momentum[j]))
        });
        flows[parent] = Flow {
            momentum: below.momentum + momentum,
            moments,
        };
    }
    flows
}

impl<'g> Variation<'g> {
    /// Change of the spin alone.
    pub(super) fn of_spin(spin: Vec3<'g>) -> Self {
        let zero = Vec3::zero(spin[0].graph());
        let (twist, push) = (zero, zero);
        Self { spin, twist, push }
    }

    /// Variations of the motion that arrives at the link of a joint with the screw (s_w, s_v). With respect to its
    /// coordinate: spin `w x s_w`, twist `U s_w`, push `a x s_w + U s_v`; with respect to its rate: `s_w`, `2 w x s_w`,
    /// `2 w x s_v`.
    ///
    /// The angular velocity of a floating body is given along its own axes, which turn with it: its twist by a rate is
    /// `w x s_w`.
    pub(super) fn by_position_and_rate(link: &Link<'g>, motion: &Motion<'g>) -> [Self; 2] {
        let Twist { angular, linear } = link.screw;
        let times = if link.spin.is_some() { 1 } else { 2 };
        let Motion { w, a, field, .. } = *motion;
        let by_position = Self {
            spin: w.cross(angular),
            twist: field * angular,
            push: a.cross(angular) + field * linear,
        };
        let by_rate = Self {
            spin: angular,
            twist: times * w.cross(angular),
            push: 2 * w.cross(linear),
        };
        [by_position, by_rate]
    }

    /// Additional wrench that a composite requires: the force `m push + twist x h + 2 spin x p` and the moment
    /// `h x push + J twist + 2 G^T spin`, with the [gyration](Flow::gyration) G.
    pub(super) fn taken(&self, inertia: &MassMoments<'g>, flow: &Flow<'g>) -> Wrench<'g> {
        let Self { spin, twist, push } = *self;
        let (m, h) = (inertia.mass, inertia.first);
        Wrench {
            force: m * push + twist.cross(h) + 2 * spin.cross(flow.momentum),
            moment: h.cross(push) + inertia.rotational() * twist + 2 * (flow.gyration().transpose() * spin),
        }
    }
}

impl<'g> Flow<'g> {
    /// Flow of a link about its origin, which moves with the velocity `v`.
    pub(super) fn of_link(frame: &Frame<'g>, motion: &Motion<'g>, v: Vec3<'g>) -> Self {
        let MassMoments { mass, first, second } = frame.inertia;
        let moments = second.full().map_rows(|row| motion.w.cross(row));
        Self {
            momentum: motion.w.cross(first) + mass * v,
            moments: Mat3::from_fn(|i, j| moments[i][j] + first[i] * v[j]),
        }
    }

    /// Gyration `tr(P) 1 - P`, with `integral r x (spin x v) dm = (tr(P) 1 - P^T) spin`.
    fn gyration(&self) -> Mat3<'g> {
        let p = self.moments;
        Mat3::from_fn(|i, j| {
            if i == j {
                p[(i + 1) % 3][(i + 1) % 3] + p[(i + 2) % 3][(i + 2) % 3]
            } else {
                -p[i][j]
            }
        })
    }
}

impl<'g> Response<'g> {
    /// Response of a joint with the screw (s_w, s_v): the wrench `I s`, and `2 (p x s_v + G s_w)` to spin.
    fn of_joint(screw: &Twist<'g>, inertia: &MassMoments<'g>, flow: &Flow<'g>) -> Self {
        Self {
            by_spin: 2 * (flow.momentum.cross(screw.linear) + flow.gyration() * screw.angular),
            wrench: *inertia * *screw,
        }
    }

    /// Additional force along the joint for a variation.
    fn to(&self, variation: &Variation<'g>) -> Expr<'g> {
        let Wrench { moment, force } = self.wrench;
        moment.dot(variation.twist) + force.dot(variation.push) + self.by_spin.dot(variation.spin)
    }

    /// Transforms the response to variations of the motion of the parent, where `velocity` is the velocity of the
    /// frame's origin relative to the parent's. A variation of the parent arrives here with the push
    /// `push + twist x offset + 2 spin x velocity`.
    fn to_parent(self, frame: &Frame<'g>, velocity: Vec3<'g>) -> Self {
        let wrench = frame.wrench_to_parent(&self.wrench);
        Self {
            wrench,
            by_spin: frame.to_parent(self.by_spin) + 2 * velocity.cross(wrench.force),
        }
    }
}

/// Derivative of a wrench on a link with respect to its coordinate, relative to the link below: the additional wrench
/// `taken`, and the wrench itself turned and moved along, `s_w x n + s_v x f` and `s_w x f`.
pub(super) fn seen_below<'g>(screw: &Twist<'g>, wrench: &Wrench<'g>, taken: &Wrench<'g>) -> Wrench<'g> {
    let Twist { angular, linear } = *screw;
    let Wrench { moment, force } = *wrench;
    Wrench {
        moment: taken.moment + linear.cross(force) + angular.cross(moment),
        force: taken.force + angular.cross(force),
    }
}
