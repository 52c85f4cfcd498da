//! The faster form for large scenes: the bias by Newton and Euler's recursion, the mass matrix by composite bodies.
//!
//! Luh, Walker and Paul (1980) and Walker and Orin (1982), on links in base parameters. A link alone turns its own frame; parallel links in
//! a row share the frame before the first of them, in which their angles add up and nothing has to be turned between them.

use super::links::{Link, links};
use crate::expr::{ExprId, Graph, Unary};
use crate::model::{Combination, Model, combine, plus_scaled};
use crate::screw::{
    MassMoments, Mat3, Symmetric3, Turn, Vec3, Wrench, add, cross, identity, mat_mul, mat_vec, scale, sum, transpose,
};

/// Mass matrix and bias along the joints of the links.
#[derive(Debug)]
pub(super) struct Recursive {
    pub(super) links: Vec<Link>,
    /// `A_ij` for `i <= j`, where link i carries link j or is it.
    pub(super) mass_matrix: Vec<(usize, usize, ExprId)>,
    pub(super) bias: Vec<ExprId>,
    /// `A qdd + bias` with the second rates as symbols: what a motion takes.
    pub(super) inertial: Vec<ExprId>,
}

/// The frame in which a link is computed: at its origin, turned as its station is.
#[derive(Debug)]
struct Frame {
    /// Whether the link before is in the same station.
    same_station: bool,
    /// From the parent's body frame to the station, where that is a new one.
    placement: Mat3,
    /// The turn of the frame itself, where the link is alone in its station.
    own: Option<Turn>,
    /// The turn of the body in its station, where several share it, behind the constant rotation `rest`.
    inside: Option<Turn>,
    rest: Mat3,
    /// The origin of the link from that of its parent, in the parent's frame.
    offset: Vec3,
    /// Rates of turning and sliding along z.
    turning: ExprId,
    sliding: ExprId,
    inertia: MassMoments,
}

impl Recursive {
    pub(super) fn new(model: &mut Model) -> Self {
        let links = links(model);
        let frames = frames(model, &links);
        let Model {
            graph: g,
            coordinates,
            gravity,
            ..
        } = model;
        let still = vec![g.zero(); links.len()];
        let bias = inverse_dynamics(g, &links, &frames, *gravity, &still);
        let second_rates: Vec<ExprId> = links
            .iter()
            .map(|link| combine(g, coordinates, &link.motion, |c| c.acceleration))
            .collect();
        let inertial = inverse_dynamics(g, &links, &frames, *gravity, &second_rates);
        let mass_matrix = mass_matrix(g, &links, &frames);
        Self {
            links,
            mass_matrix,
            bias,
            inertial,
        }
    }
}

/// Whether a link turns about the direction of its parent, which turns too.
fn continues(g: &mut Graph, links: &[Link], n: usize) -> bool {
    let (link, one) = (&links[n], g.one());
    link.turns && link.parent.is_some_and(|p| links[p].turns) && link.placement.rotation[2][2] == one
}

fn frames(model: &mut Model, links: &[Link]) -> Vec<Frame> {
    let Model {
        graph: g, coordinates, ..
    } = model;
    let follows: Vec<bool> = (0..links.len()).map(|n| continues(g, links, n)).collect();
    let shared = |n: usize| follows[n] || (0..links.len()).any(|m| links[m].parent == Some(n) && follows[m]);
    // the angle of each body in its station, and its constant rotation there
    let mut angles: Vec<Combination> = Vec::new();
    let mut frames: Vec<Frame> = Vec::new();
    for (n, link) in links.iter().enumerate() {
        let (before, rest) = match link.parent {
            Some(parent) if follows[n] => {
                let rest = mat_mul(g, frames[parent].rest, link.placement.rotation);
                (angles[parent].clone(), rest)
            }
            _ => (Combination::new(), identity(g)),
        };
        angles.push(plus_scaled(&before, &link.motion, 1));
        let turn = link.turns.then(|| {
            let angle = combine(g, coordinates, &angles[n], |c| c.position);
            Turn {
                sine: g.unary(Unary::Sin, angle),
                cosine: g.unary(Unary::Cos, angle),
            }
        });
        let (own, inside) = if shared(n) { (None, turn) } else { (turn, None) };
        let position = combine(g, coordinates, &link.motion, |c| c.position);
        let rate = combine(g, coordinates, &link.motion, |c| c.rate);
        let slide = g.mul(link.pitch, position);
        let along = scale(g, slide, link.placement.rotation.map(|row| row[2]));
        let offset = add(g, link.placement.translation, along);
        let offset = link.parent.map_or(offset, |parent| frames[parent].of_body(g, offset));
        let mut frame = Frame {
            same_station: follows[n],
            placement: link.placement.rotation,
            own,
            inside,
            rest,
            offset,
            turning: if link.turns { rate } else { g.zero() },
            sliding: g.mul(link.pitch, rate),
            inertia: link.inertia,
        };
        frame.inertia = frame.inertia_of_body(g, &link.inertia);
        frames.push(frame);
    }
    frames
}

impl Frame {
    /// A vector of the link's body, in the frame of the link.
    fn of_body(&self, g: &mut Graph, v: Vec3) -> Vec3 {
        let Some(turn) = self.inside else { return v };
        let v = mat_vec(g, self.rest, v);
        turn.forward(g, v)
    }

    /// An inertia of the link's body, in the frame of the link.
    fn inertia_of_body(&self, g: &mut Graph, inertia: &MassMoments) -> MassMoments {
        match self.inside {
            Some(turn) => inertia.rotated(g, self.rest).turned(g, turn),
            None => *inertia,
        }
    }

    /// The inverse of [`Frame::of_body`].
    fn to_body(&self, g: &mut Graph, v: Vec3) -> Vec3 {
        let Some(turn) = self.inside else { return v };
        let v = turn.back(g, v);
        mat_vec(g, transpose(self.rest), v)
    }

    /// A vector of the frame of the parent, in this frame.
    fn of_parent(&self, g: &mut Graph, parent: Option<&Frame>, v: Vec3) -> Vec3 {
        if self.same_station {
            return v;
        }
        let v = parent.map_or(v, |parent| parent.to_body(g, v));
        let v = mat_vec(g, transpose(self.placement), v);
        self.own.map_or(v, |turn| turn.back(g, v))
    }

    /// The inverse of [`Frame::of_parent`].
    fn to_parent(&self, g: &mut Graph, parent: &Frame, v: Vec3) -> Vec3 {
        if self.same_station {
            return v;
        }
        let v = self.own.map_or(v, |turn| turn.forward(g, v));
        let v = mat_vec(g, self.placement, v);
        parent.of_body(g, v)
    }

    /// An inertia of this frame, in that of the parent.
    fn inertia_to_parent(&self, g: &mut Graph, parent: &Frame, inertia: &MassMoments) -> MassMoments {
        let mut seen = *inertia;
        if !self.same_station {
            seen = self.own.map_or(seen, |turn| seen.turned(g, turn));
            seen = seen.rotated(g, self.placement);
            seen = parent.inertia_of_body(g, &seen);
        }
        seen.moved(g, self.offset)
    }

    /// A force and a moment about the link's origin, in the frame and about the origin of the parent.
    fn wrench_to_parent(&self, g: &mut Graph, parent: &Frame, wrench: &Wrench) -> Wrench {
        let force = self.to_parent(g, parent, wrench.force);
        let moment = self.to_parent(g, parent, wrench.moment);
        let lever = cross(g, self.offset, force);
        Wrench {
            moment: add(g, moment, lever),
            force,
        }
    }

    /// The part of a wrench that moves the joint of the link.
    fn along_joint(&self, g: &mut Graph, link: &Link, wrench: &Wrench) -> ExprId {
        let slide = g.mul(link.pitch, wrench.force[2]);
        if link.turns {
            g.add(wrench.moment[2], slide)
        } else {
            slide
        }
    }
}

/// `U` with `U r` the acceleration of a point at `r` against the origin: `alpha x r + w x (w x r)`.
fn acceleration_field(g: &mut Graph, w: Vec3, alpha: Vec3) -> Mat3 {
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
fn inertial_moment(g: &mut Graph, u: &Mat3, second: Symmetric3) -> Vec3 {
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

/// What moves one link, and what that takes.
struct Motion {
    w: Vec3,
    alpha: Vec3,
    a: Vec3,
    field: Mat3,
}

/// The force along each joint that a motion takes, by Newton and Euler, in a frame that falls upwards with gravity.
fn inverse_dynamics(
    g: &mut Graph,
    links: &[Link],
    frames: &[Frame],
    gravity: Vec3,
    second_rates: &[ExprId],
) -> Vec<ExprId> {
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
        let Wrench { moment, force } = wrenches[parent];
        wrenches[parent] = Wrench {
            moment: add(g, moment, carried.moment),
            force: add(g, force, carried.force),
        };
    }
    (0..links.len())
        .map(|n| frames[n].along_joint(g, &links[n], &wrenches[n]))
        .collect()
}

/// `A_ij`: the momentum of all that link j carries, when its joint alone moves at unit rate, along the joint of each link below.
fn mass_matrix(g: &mut Graph, links: &[Link], frames: &[Frame]) -> Vec<(usize, usize, ExprId)> {
    let mut composites: Vec<MassMoments> = frames.iter().map(|frame| frame.inertia).collect();
    for n in (0..links.len()).rev() {
        let Some(parent) = links[n].parent else { continue };
        let carried = frames[n].inertia_to_parent(g, &frames[parent], &composites[n]);
        composites[parent] = composites[parent].plus(g, &carried);
    }
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
fn momentum(g: &mut Graph, link: &Link, inertia: &MassMoments) -> Wrench {
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
    Wrench {
        moment: add(g, moment, slide.moment),
        force: add(g, force, slide.force),
    }
}
