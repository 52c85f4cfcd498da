//! The derivatives of inverse dynamics, link by link, without deriving its expressions.
//!
//! The idea of Carpentier and Mansard (2018) and Singh, Russo and Wensing (2022), in the terms of moments of mass: seen from link k,
//! turning its joint, or turning it faster, changes only the motion that arrives from below. The links above answer as one body
//! that holds their composite inertia and the flow of their mass.

use super::Entry;
use super::frames::Frame;
use super::links::Link;
use super::recursive::Motion;
use crate::expr::{ExprId, Graph};
use crate::screw::{MassMoments, Mat3, Vec3, Wrench, add, cross, dot, mat_vec, scale, transpose};

/// Derivatives of the forces along the joints (rows) at fixed second rates.
#[derive(Debug, Default)]
pub(super) struct Tangent {
    /// By the joint coordinates.
    pub(super) by_position: Vec<Entry>,
    /// By their rates.
    pub(super) by_rate: Vec<Entry>,
}

/// How mass flows past the origin of a frame, which moves along: `p = integral v dm` and `P = integral r v^T dm`, where `v` is the
/// velocity against the origin.
#[derive(Clone, Copy, Debug)]
struct Flow {
    momentum: Vec3,
    moments: Mat3,
}

/// A change of the motion that arrives at a link. A point at `r` with velocity `v` against the origin is accelerated by
/// `push + twist x r + 2 spin x v` more.
#[derive(Clone, Copy, Debug)]
struct Variation {
    spin: Vec3,
    twist: Vec3,
    push: Vec3,
}

/// What a variation of the motion of a frame adds to the force along the joint of a link that it carries.
#[derive(Clone, Copy, Debug)]
struct Response {
    /// By push and twist: the momentum at unit rate of that joint.
    wrench: Wrench,
    /// By spin.
    by_spin: Vec3,
}

impl Tangent {
    /// `wrenches` are what the motions take: of each link with all that it carries.
    pub(super) fn new(
        g: &Graph,
        links: &[Link],
        frames: &[Frame],
        composites: &[MassMoments],
        motions: &[Motion],
        wrenches: &[Wrench],
    ) -> Self {
        let two = g.integer(2);
        // velocity of a link's origin against that of its parent, in the frame of the parent
        let velocities: Vec<Vec3> = (0..links.len())
            .map(|n| velocity_of_origin(g, links, frames, motions, n))
            .collect();
        let flows = flows(g, links, frames, composites, motions, &velocities);
        let variations: Vec<[Variation; 2]> = links
            .iter()
            .zip(motions)
            .map(|(link, motion)| variations(g, link, motion))
            .collect();
        let mut tangent = Self::default();
        for (j, link) in links.iter().enumerate() {
            let [by_position, by_rate] = variations[j].map(|variation| variation.taken(g, &composites[j], &flows[j]));
            let mut columns = [seen_below(g, link, &wrenches[j], &by_position), by_rate];
            let mut response = Response::of_joint(g, link, &composites[j], &flows[j]);
            let mut at = j;
            loop {
                let [by_position, by_rate] = columns.map(|wrench| frames[at].along_joint(g, &links[at], &wrench));
                tangent.by_position.push((at, j, by_position));
                tangent.by_rate.push((at, j, by_rate));
                if at != j {
                    let [by_position, by_rate] = variations[at].map(|variation| response.to(g, &variation));
                    tangent.by_position.push((j, at, by_position));
                    tangent.by_rate.push((j, at, by_rate));
                }
                let Some(parent) = links[at].parent else { break };
                columns = columns.map(|wrench| frames[at].wrench_to_parent(g, &frames[parent], &wrench));
                let wrench = frames[at].wrench_to_parent(g, &frames[parent], &response.wrench);
                // push at this origin is push + twist x offset + 2 spin x velocity of that of the parent
                let by_spin = frames[at].to_parent(g, &frames[parent], response.by_spin);
                let carried = cross(g, velocities[at], wrench.force);
                let carried = scale(g, two, carried);
                response = Response {
                    wrench,
                    by_spin: add(g, by_spin, carried),
                };
                at = parent;
            }
        }
        tangent
    }
}

fn velocity_of_origin(g: &Graph, links: &[Link], frames: &[Frame], motions: &[Motion], n: usize) -> Vec3 {
    let Some(parent) = links[n].parent else {
        return [g.zero(); 3];
    };
    let zero = g.zero();
    let carried = cross(g, motions[parent].w, frames[n].offset);
    let slide = frames[n].to_parent(g, &frames[parent], [zero, zero, frames[n].sliding]);
    add(g, carried, slide)
}

/// The flow of each link with all that it carries.
fn flows(
    g: &Graph,
    links: &[Link],
    frames: &[Frame],
    composites: &[MassMoments],
    motions: &[Motion],
    velocities: &[Vec3],
) -> Vec<Flow> {
    let mut flows: Vec<Flow> = Vec::new();
    for (frame, motion) in frames.iter().zip(motions) {
        let rows = frame.inertia.second.full();
        flows.push(Flow {
            momentum: cross(g, motion.w, frame.inertia.first),
            moments: rows.map(|row| cross(g, motion.w, row)),
        });
    }
    for n in (0..links.len()).rev() {
        let Some(parent) = links[n].parent else { continue };
        let (frame, below) = (&frames[n], &frames[parent]);
        let first = frame.to_parent(g, below, composites[n].first);
        let momentum = frame.to_parent(g, below, flows[n].momentum);
        let own = scale(g, composites[n].mass, velocities[n]);
        let momentum = add(g, momentum, own);
        let turned = frame.matrix_to_parent(g, below, flows[n].moments);
        let moments: Mat3 = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let (carried, swept) = (g.mul(first[i], velocities[n][j]), g.mul(frame.offset[i], momentum[j]));
                let both = g.add(carried, swept);
                let sum = g.add(turned[i][j], both);
                g.add(flows[parent].moments[i][j], sum)
            })
        });
        flows[parent] = Flow {
            momentum: add(g, flows[parent].momentum, momentum),
            moments,
        };
    }
    flows
}

/// What the coordinate of a joint, and its rate, change in the motion that its link sees arriving.
fn variations(g: &Graph, link: &Link, motion: &Motion) -> [Variation; 2] {
    let (zero, one, two) = (g.zero(), g.one(), g.integer(2));
    let along = motion.field.map(|row| row[2]);
    let [across, swept] = [motion.w, motion.a].map(|[x, y, _]| [y, g.neg(x), zero]);
    let twice = scale(g, two, across);
    let (moved, faster) = (scale(g, link.pitch, along), scale(g, link.pitch, twice));
    if link.turns {
        [
            Variation {
                spin: across,
                twist: along,
                push: add(g, swept, moved),
            },
            Variation {
                spin: [zero, zero, one],
                twist: twice,
                push: faster,
            },
        ]
    } else {
        [moved, faster].map(|push| Variation {
            spin: [zero; 3],
            twist: [zero; 3],
            push,
        })
    }
}

impl Variation {
    /// The force and the moment that a composite takes more.
    fn taken(&self, g: &Graph, inertia: &MassMoments, flow: &Flow) -> Wrench {
        let two = g.integer(2);
        let pushed = scale(g, inertia.mass, self.push);
        let twisted = cross(g, self.twist, inertia.first);
        let spun = cross(g, self.spin, flow.momentum);
        let spun = scale(g, two, spun);
        let force = add(g, pushed, twisted);
        let lever = cross(g, inertia.first, self.push);
        let rotational = inertia.rotational(g);
        let about_origin = mat_vec(g, rotational.full(), self.twist);
        let gyration = flow.gyration(g);
        let gyrated = mat_vec(g, transpose(gyration), self.spin);
        let gyrated = scale(g, two, gyrated);
        let moment = add(g, lever, about_origin);
        Wrench {
            moment: add(g, moment, gyrated),
            force: add(g, force, spun),
        }
    }
}

impl Flow {
    /// `tr(P) 1 - P`, with `integral r x (spin x v) dm = (tr(P) 1 - P^T) spin`.
    fn gyration(&self, g: &Graph) -> Mat3 {
        let p = self.moments;
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                if i == j {
                    g.add(p[(i + 1) % 3][(i + 1) % 3], p[(i + 2) % 3][(i + 2) % 3])
                } else {
                    g.neg(p[i][j])
                }
            })
        })
    }
}

impl Response {
    fn of_joint(g: &Graph, link: &Link, inertia: &MassMoments, flow: &Flow) -> Self {
        let (two, zero) = (g.integer(2), g.zero());
        let [px, py, _] = flow.momentum;
        let sliding = [py, g.neg(px), zero];
        let mut by_spin = scale(g, link.pitch, sliding);
        if link.turns {
            let turning = flow.gyration(g).map(|row| row[2]);
            by_spin = add(g, by_spin, turning);
        }
        Self {
            wrench: super::recursive::momentum(g, link, inertia),
            by_spin: scale(g, two, by_spin),
        }
    }

    /// The force along the joint that a variation takes more.
    fn to(&self, g: &Graph, variation: &Variation) -> ExprId {
        let twisted = dot(g, self.wrench.moment, variation.twist);
        let pushed = dot(g, self.wrench.force, variation.push);
        let spun = dot(g, self.by_spin, variation.spin);
        let sum = g.add(twisted, pushed);
        g.add(sum, spun)
    }
}

/// What the link below sees change in the wrench on a link whose coordinate changes: the wrench itself is turned and moved along.
fn seen_below(g: &Graph, link: &Link, wrench: &Wrench, taken: &Wrench) -> Wrench {
    let zero = g.zero();
    let [turned_moment, turned_force] = [wrench.moment, wrench.force].map(|[x, y, _]| [g.neg(y), x, zero]);
    let lever = scale(g, link.pitch, turned_force);
    let moment = add(g, taken.moment, lever);
    if !link.turns {
        return Wrench { moment, ..*taken };
    }
    Wrench {
        moment: add(g, moment, turned_moment),
        force: add(g, taken.force, turned_force),
    }
}
