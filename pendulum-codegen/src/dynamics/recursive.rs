//! Recursive dynamics, faster for large scenes: the bias by the recursive Newton-Euler algorithm, the mass matrix by
//! composite bodies.
//!
//! Luh, Walker and Paul (1980) and Walker and Orin (1982), on links in base parameters. Each quantity of a link is
//! expressed in its [frame](Frame), about its origin; `X` transforms motions of the parent to it, and `X^T` wrenches
//! back.

use super::actions::{is_wrench, wrenches};
use super::flight::Flights;
use super::frames::{Frame, frames};
use super::joint::{Entry, JointId};
use super::joints::AlongJoints;
use super::links::{Link, links};
use super::motion::{Motion, inertial_moment, motions};
use super::tangent::Tangent;
use crate::expr::Expr;
use crate::model::{Action, Floating, Model};
use crate::screw::{MassMoments, Vec3, Wrench};

/// Computes the dynamics along the joints of the links. If `pushed` is set, the result includes forces less the actions
/// that are wrenches on the links. The slides of `floating` bodies are along their own axes, and gravity does not act
/// on the links that they carry.
///
/// Inertial forces come from the recursion itself if `by_recursion` is set, else from the product with the mass matrix.
/// The two differ off the unit sphere of a quaternion.
pub(super) fn along_joints<'g>(
    model: &Model<'g>,
    pushed: bool,
    floating: &[Floating<'g>],
    by_recursion: bool,
) -> AlongJoints<'g> {
    let g = model.graph;
    let links = links(model);
    let frames = frames(model, &links.links);
    let flights = Flights::new(&links, &frames, floating);
    let actions: Vec<&Action<'g>> = model.actions.iter().filter(|action| is_wrench(action)).collect();
    let given = pushed.then(|| wrenches(model, &links, &frames, &actions));
    let links = links.links;
    let still: Vec<Expr<'g>> = links
        .iter()
        .map(|link| model.driven_acceleration_of(&link.motion))
        .collect();
    let taken = |frames: &[Frame<'g>], gravity: Vec3<'g>, second_rates: &[Expr<'g>], given: Option<&[Wrench<'g>]>| {
        let motions = motions(&links, frames, &flights, gravity, second_rates);
        let wrenches = wrenches_of(&links, frames, &motions, given);
        let forces = forces(&links, &flights, &wrenches, second_rates);
        (motions, wrenches, forces)
    };
    let (.., bias) = taken(&frames, model.gravity, &still, None);
    let second_rates: Vec<Expr<'g>> = links.iter().map(|link| model.acceleration_of(&link.motion)).collect();
    let (motions, wrenches, inertial) = taken(&frames, model.gravity, &second_rates, None);
    let pushed = given.map(|given| {
        [&still, &second_rates].map(|second_rates| taken(&frames, model.gravity, second_rates, Some(&given)).2)
    });
    let composites = composites(&links, &frames);
    let mass_matrix = mass_matrix(&links, &frames, &flights, &composites);
    // Derivatives by the orientation of a body are known only if nothing depends on it, as in free fall. Each flight
    // has three of the links that turn as an orientation.
    let turning = links.iter().filter(|link| link.spin.is_some()).count();
    let tangent = (turning == 3 * flights.all().count())
        .then(|| Tangent::new(&links, &frames, &flights, &composites, &motions, &wrenches));
    // at rest and without gravity, accelerations equal to the rates require forces equal to the momenta
    let resting: Vec<Frame<'g>> = frames.iter().map(Frame::at_rest).collect();
    let rates: Vec<Expr<'g>> = links.iter().map(|link| model.rate_of(&link.motion)).collect();
    let (.., momenta) = taken(&resting, Vec3::zero(g), &rates, None);
    AlongJoints {
        motions: links.into_iter().map(|link| link.motion).collect(),
        mass_matrix,
        bias,
        momenta: Some(momenta),
        inertial: by_recursion.then_some(inertial),
        tangent,
        pushed,
        floating: floating.to_vec(),
    }
}

/// Wrench required by each link with all links that it carries, by Newton-Euler, less the `given` wrenches.
///
/// For mass m, first moment h and accelerations `a + U r`, `f = m a + U h`, `n = h x a + integral r x (U r) dm`; and
/// `F_parent += X^T F`.
pub(super) fn wrenches_of<'g>(
    links: &[Link<'g>],
    frames: &[Frame<'g>],
    motions: &[Motion<'g>],
    given: Option<&[Wrench<'g>]>,
) -> Vec<Wrench<'g>> {
    let own = |(motion, frame): (&Motion<'g>, &Frame<'g>)| {
        let MassMoments {
            mass: m,
            first: h,
            second,
        } = frame.inertia;
        Wrench {
            force: m * motion.a + motion.field * h,
            moment: h.cross(motion.a) + inertial_moment(&motion.field, second),
        }
    };
    let mut wrenches: Vec<Wrench<'g>> = motions.iter().zip(frames).map(own).collect();
    for (wrench, &given) in wrenches.iter_mut().zip(given.into_iter().flatten()) {
        *wrench = *wrench - given;
    }
    for n in JointId::all(links.len()).rev() {
        if let Some(parent) = links[n].parent {
            wrenches[parent] = wrenches[parent] + frames[n].wrench_to_parent(&wrenches[n]);
        }
    }
    wrenches
}

/// Forces along the joints: `tau = s^T F`. For the slides of a flight they are along the axes of the body and include
/// the mass that moves with the slides alone: `e^T f + m qdd`.
fn forces<'g>(
    links: &[Link<'g>],
    flights: &Flights<'g>,
    wrenches: &[Wrench<'g>],
    second_rates: &[Expr<'g>],
) -> Vec<Expr<'g>> {
    let along_joint = |(link, wrench): (&Link<'g>, &Wrench<'g>)| wrench.power(&link.screw);
    let mut forces: Vec<Expr<'g>> = links.iter().zip(wrenches).map(along_joint).collect();
    for (link, flight) in flights.all() {
        for (slide, force) in flight.slides.into_iter().zip(flight.along_axes(wrenches[link].force)) {
            forces[slide] = force + flight.mass * second_rates[slide];
        }
    }
    forces
}

/// Composite inertia of each link with all links that it carries: `I_parent += X^T I X`.
fn composites<'g>(links: &[Link<'g>], frames: &[Frame<'g>]) -> Vec<MassMoments<'g>> {
    let mut composites: Vec<MassMoments<'g>> = frames.iter().map(|frame| frame.inertia).collect();
    for n in JointId::all(links.len()).rev() {
        if let Some(parent) = links[n].parent {
            composites[parent] = composites[parent] + frames[n].inertia_to_parent(&composites[n]);
        }
    }
    composites
}

/// Mass matrix `A_ij = s_i^T (X^T .. I_j s_j)`: the momentum of link j and all links that it carries, when its joint
/// alone moves at unit rate, along the joint of each link i below.
fn mass_matrix<'g>(
    links: &[Link<'g>],
    frames: &[Frame<'g>],
    flights: &Flights<'g>,
    composites: &[MassMoments<'g>],
) -> Vec<Entry<'g>> {
    let mut entries = Vec::new();
    for j in JointId::all(links.len()) {
        if flights.is_slide(j) {
            entries.push((j, j, composites[j].mass));
            continue;
        }
        let mut wrench = composites[j] * links[j].screw;
        let mut at = j;
        loop {
            entries.push((at, j, wrench.power(&links[at].screw)));
            if let Some(flight) = flights.from(at) {
                let along = flight.slides.into_iter().zip(flight.along_axes(wrench.force));
                entries.extend(along.map(|(slide, entry)| (slide, j, entry)));
                break;
            }
            let Some(parent) = links[at].parent else { break };
            wrench = frames[at].wrench_to_parent(&wrench);
            at = parent;
        }
    }
    entries
}
