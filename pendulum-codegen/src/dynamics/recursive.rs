//! The faster form for large scenes: the bias by Newton and Euler's recursion, the mass matrix by composite bodies.
//!
//! Luh, Walker and Paul (1980) and Walker and Orin (1982), on links in base parameters.

use super::frames::{Frame, frames};
use super::links::{Link, links};
use super::tangent::Tangent;
use super::{AlongJoints, Entry, Inertial};
use crate::expr::{ExprId, Graph};
use crate::model::{Model, combine};
use crate::screw::{MassMoments, Mat3, Symmetric3, Vec3, Wrench, add, cross, mat_vec, scale, sum};

/// The dynamics along the joints of the links.
pub(super) fn along_joints(model: &Model) -> AlongJoints {
    let links = links(model);
    let frames = frames(model, &links);
    let Model {
        graph: g,
        coordinates,
        gravity,
        ..
    } = model;
    let still = vec![g.zero(); links.len()];
    let (_, wrenches) = inverse_dynamics(g, &links, &frames, *gravity, &still);
    let bias = forces(g, &links, &frames, &wrenches);
    let second_rates: Vec<ExprId> = links
        .iter()
        .map(|link| combine(g, coordinates, &link.motion, |c| c.acceleration))
        .collect();
    let (motions, wrenches) = inverse_dynamics(g, &links, &frames, *gravity, &second_rates);
    let inertial = forces(g, &links, &frames, &wrenches);
    let composites = composites(g, &links, &frames);
    let mass_matrix = mass_matrix(g, &links, &frames, &composites);
    let tangent = Tangent::new(g, &links, &frames, &composites, &motions, &wrenches);
    // from rest and without gravity, accelerations equal to the rates take forces equal to the momenta
    let weightless = [g.zero(); 3];
    let resting: Vec<Frame> = frames.iter().map(|frame| frame.at_rest(g)).collect();
    let rates: Vec<ExprId> = links
        .iter()
        .map(|link| combine(g, coordinates, &link.motion, |c| c.rate))
        .collect();
    let (_, momenta) = inverse_dynamics(g, &links, &resting, weightless, &rates);
    let momenta = forces(g, &links, &frames, &momenta);
    AlongJoints {
        motions: links.into_iter().map(|link| link.motion).collect(),
        mass_matrix,
        bias,
        inertial: Some(Inertial {
            forces: inertial,
            tangent,
            momenta,
        }),
    }
}

/// `U` with `U r` the acceleration of a point at `r` against the origin: `alpha x r + w x (w x r)`.
pub(super) fn acceleration_field(g: &Graph, w: Vec3, alpha: Vec3) -> Mat3 {
    let square = w.map(|x| g.powi(x, 2));
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            if i == j {
                let both = g.add(square[(i + 1) % 3], square[(i + 2) % 3]);
                return g.neg(both);
            }
            let product = g.mul(w[i], w[j]);
            let turning = alpha[3 - i - j];
            if (i + 1) % 3 == j {
                g.sub(product, turning)
            } else {
                g.add(product, turning)
            }
        })
    })
}

/// The moment `integral r x (U r) dm`, from the second moments of mass.
pub(super) fn inertial_moment(g: &Graph, u: &Mat3, second: Symmetric3) -> Vec3 {
    let s = second.full();
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
        // sum_k U_jk S_ik - U_ik S_jk; the two terms in S_ij go together
        let k = 3 - i - j;
        let outer = [(j, i, i, i), (j, k, i, k)].map(|(a, b, c, d)| g.mul(u[a][b], s[c][d]));
        let inner = [(i, j, j, j), (i, k, j, k)].map(|(a, b, c, d)| g.mul(u[a][b], s[c][d]));
        let difference = g.sub(u[j][j], u[i][i]);
        let both = g.mul(difference, s[i][j]);
        let (outer, inner) = (sum(g, outer), sum(g, inner));
        let rest = g.sub(outer, inner);
        g.add(rest, both)
    })
}

/// How a link moves, in its frame.
#[derive(Debug)]
pub(super) struct Motion {
    /// Angular velocity.
    pub(super) w: Vec3,
    alpha: Vec3,
    /// Acceleration of the origin, in a frame that falls upwards with gravity.
    pub(super) a: Vec3,
    /// The acceleration of every other point against the origin.
    pub(super) field: Mat3,
}

/// How the links move, and the wrench that each takes with all that it carries, by Newton and Euler.
fn inverse_dynamics(
    g: &Graph,
    links: &[Link],
    frames: &[Frame],
    gravity: Vec3,
    second_rates: &[ExprId],
) -> (Vec<Motion>, Vec<Wrench>) {
    let mut motions: Vec<Motion> = Vec::new();
    for ((link, frame), &second_rate) in links.iter().zip(frames).zip(second_rates) {
        let parent = link.parent.map(|p| &frames[p]);
        let (w, alpha, a) = match link.parent.map(|p| &motions[p]) {
            Some(Motion { w, alpha, a, field }) => {
                let moved = mat_vec(g, *field, frame.offset);
                (*w, *alpha, add(g, *a, moved))
            }
            None => ([g.zero(); 3], [g.zero(); 3], gravity.map(|x| g.neg(x))),
        };
        let [mut w, mut alpha, mut a] = [w, alpha, a].map(|v| frame.of_parent(g, parent, v));
        let [x, y, _] = w;
        for (vector, rate, factor) in [(&mut alpha, frame.turning, 1), (&mut a, frame.sliding, 2)] {
            // w x z = (w_y, -w_x, 0)
            let factor = g.integer(factor);
            let rate = g.mul(factor, rate);
            let (along, across) = (g.mul(y, rate), g.mul(x, rate));
            vector[0] = g.add(vector[0], along);
            vector[1] = g.sub(vector[1], across);
        }
        w[2] = g.add(w[2], frame.turning);
        if link.turns {
            alpha[2] = g.add(alpha[2], second_rate);
        }
        let slide = g.mul(link.pitch, second_rate);
        a[2] = g.add(a[2], slide);
        let field = acceleration_field(g, w, alpha);
        motions.push(Motion { w, alpha, a, field });
    }
    let mut wrenches: Vec<Wrench> = Vec::new();
    for (motion, frame) in motions.iter().zip(frames) {
        let MassMoments { mass, first, second } = frame.inertia;
        let (carried, swept) = (scale(g, mass, motion.a), mat_vec(g, motion.field, first));
        let (lever, own) = (cross(g, first, motion.a), inertial_moment(g, &motion.field, second));
        wrenches.push(Wrench {
            moment: add(g, lever, own),
            force: add(g, carried, swept),
        });
    }
    for n in (0..links.len()).rev() {
        let Some(parent) = links[n].parent else { continue };
        let carried = frames[n].wrench_to_parent(g, &frames[parent], &wrenches[n]);
        wrenches[parent] = wrenches[parent].plus(g, &carried);
    }
    (motions, wrenches)
}

/// The forces along the joints.
fn forces(g: &Graph, links: &[Link], frames: &[Frame], wrenches: &[Wrench]) -> Vec<ExprId> {
    (0..links.len())
        .map(|n| frames[n].along_joint(g, &links[n], &wrenches[n]))
        .collect()
}

/// Each link with all that it carries.
fn composites(g: &Graph, links: &[Link], frames: &[Frame]) -> Vec<MassMoments> {
    let mut composites: Vec<MassMoments> = frames.iter().map(|frame| frame.inertia).collect();
    for n in (0..links.len()).rev() {
        let Some(parent) = links[n].parent else { continue };
        let carried = frames[n].inertia_to_parent(g, &frames[parent], &composites[n]);
        composites[parent] = composites[parent].plus(g, &carried);
    }
    composites
}

/// `A_ij`: the momentum of all that link j carries, when its joint alone moves at unit rate, along the joint of each link below.
fn mass_matrix(g: &Graph, links: &[Link], frames: &[Frame], composites: &[MassMoments]) -> Vec<Entry> {
    let mut entries = Vec::new();
    for (j, link) in links.iter().enumerate() {
        let mut wrench = momentum(g, link, &composites[j]);
        let mut at = j;
        loop {
            entries.push((at, j, frames[at].along_joint(g, &links[at], &wrench)));
            let Some(parent) = links[at].parent else { break };
            wrench = frames[at].wrench_to_parent(g, &frames[parent], &wrench);
            at = parent;
        }
    }
    entries
}

/// Momentum and angular momentum at unit rate of a joint.
pub(super) fn momentum(g: &Graph, link: &Link, inertia: &MassMoments) -> Wrench {
    let zero = g.zero();
    let [hx, hy, _] = inertia.first;
    let Symmetric3([xx, yy, _, _, xz, yz]) = inertia.second;
    // a slide along z: m z, and h x z
    let (across, along, carried) = (
        g.mul(link.pitch, hy),
        g.mul(link.pitch, hx),
        g.mul(link.pitch, inertia.mass),
    );
    let slide = Wrench {
        moment: [across, g.neg(along), zero],
        force: [zero, zero, carried],
    };
    if !link.turns {
        return slide;
    }
    // a turn about z: z x h, and J z
    let moment = [g.neg(xz), g.neg(yz), g.add(xx, yy)];
    let force = [g.neg(hy), hx, zero];
    Wrench { moment, force }.plus(g, &slide)
}
