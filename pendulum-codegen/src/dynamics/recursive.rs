//! The faster form for large scenes: the bias by Newton and Euler's recursion, the mass matrix by composite bodies.
//!
//! Luh, Walker and Paul (1980) and Walker and Orin (1982), on links in base parameters.

use super::actions::{is_wrench, wrenches};
use super::frames::{Frame, frames};
use super::joints::{AlongJoints, Entry, Inertial, JointId};
use super::links::{Link, Links, links};
use super::motion::{Motion, inertial_moment, motions};
use super::tangent::Tangent;
use crate::expr::Expr;
use crate::model::{Action, Floating, Model};
use crate::screw::{MassMoments, Vec3, Wrench};

/// A slide of a floating body, whose force is taken along an axis of the body instead.
#[derive(Clone, Copy, Debug)]
struct OfBody<'g> {
    /// The link of the body that is turned first, and the axis in its frame.
    link: JointId,
    axis: Vec3<'g>,
}

/// The dynamics along the joints of the links; with what acts on the scene as wrenches on the links, where `pushed`. Of the bodies that
/// are `floating` the slides are along their own axes, and gravity does not act on what they carry.
pub(super) fn along_joints<'g>(model: &Model<'g>, pushed: bool, floating: &[Floating<'g>]) -> AlongJoints<'g> {
    let g = model.graph;
    let links = links(model);
    let frames = frames(model, &links.links);
    let slides = slides(&links, &frames, floating);
    let gravity = |slide: &Option<OfBody<'g>>| slide.map_or(model.gravity, |_| Vec3::zero(g));
    let gravity: Vec<Vec3<'g>> = slides.iter().map(gravity).collect();
    let actions: Vec<&Action<'g>> = model.actions.iter().filter(|action| is_wrench(action)).collect();
    let given = pushed.then(|| wrenches(model, &links, &frames, &actions));
    let links = links.links;
    let still: Vec<Expr<'g>> = links
        .iter()
        .map(|link| model.driven_acceleration_of(&link.motion))
        .collect();
    let (_, wrenches) = inverse_dynamics(&links, &frames, &gravity, &still, None);
    let bias = forces(&links, &slides, &wrenches);
    let second_rates: Vec<Expr<'g>> = links.iter().map(|link| model.acceleration_of(&link.motion)).collect();
    let (motions, wrenches) = inverse_dynamics(&links, &frames, &gravity, &second_rates, None);
    let inertial = forces(&links, &slides, &wrenches);
    let pushed = given.map(|given| {
        [&still, &second_rates].map(|second_rates| {
            let (_, left) = inverse_dynamics(&links, &frames, &gravity, second_rates, Some(&given));
            forces(&links, &slides, &left)
        })
    });
    let composites = composites(&links, &frames);
    let mass_matrix = mass_matrix(&links, &frames, &slides, &composites);
    let tangent = Tangent::new(&links, &frames, &composites, &motions, &wrenches);
    // from rest and without gravity, accelerations equal to the rates take forces equal to the momenta
    let resting: Vec<Frame<'g>> = frames.iter().map(Frame::at_rest).collect();
    let rates: Vec<Expr<'g>> = links.iter().map(|link| model.rate_of(&link.motion)).collect();
    let weightless = vec![Vec3::zero(g); links.len()];
    let (_, wrenches) = inverse_dynamics(&links, &resting, &weightless, &rates, None);
    let momenta = forces(&links, &slides, &wrenches);
    // Off the unit sphere of a quaternion, where stages of methods are, only what is made of one matrix and one bias agrees:
    // there the Jacobian must be that of the right-hand side too.
    let agrees = !model.has_orientations();
    let inertial = Inertial {
        forces: inertial,
        tangent,
    };
    AlongJoints {
        motions: links.into_iter().map(|link| link.motion).collect(),
        mass_matrix,
        bias,
        momenta: Some(momenta),
        inertial: agrees.then_some(inertial),
        pushed,
        floating: floating.to_vec(),
    }
}

/// How the links move, and the wrench that each takes with all that it carries, by Newton and Euler: beside those that are `given`.
fn inverse_dynamics<'g>(
    links: &[Link<'g>],
    frames: &[Frame<'g>],
    gravity: &[Vec3<'g>],
    second_rates: &[Expr<'g>],
    given: Option<&[Wrench<'g>]>,
) -> (Vec<Motion<'g>>, Vec<Wrench<'g>>) {
    let motions = motions(links, frames, gravity, second_rates);
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
    (motions, wrenches)
}

/// Which links are slides of floating bodies.
fn slides<'g>(links: &Links<'g>, frames: &[Frame<'g>], floating: &[Floating<'g>]) -> Vec<Option<OfBody<'g>>> {
    let mut slides = vec![None; frames.len()];
    for joint in floating {
        let ((Some(slide), _), (Some(link), back)) = (links.owners[joint.slide], links.owners[joint.turn]) else {
            continue;
        };
        for n in 0..3 {
            let axis = Vec3::unit(joint.gravity[0].graph(), n);
            let axis = frames[link].of_body(back.rotation * axis);
            slides[usize::from(slide) + n] = Some(OfBody { link, axis });
        }
    }
    slides
}

/// The forces along the joints.
fn forces<'g>(links: &[Link<'g>], slides: &[Option<OfBody<'g>>], wrenches: &[Wrench<'g>]) -> Vec<Expr<'g>> {
    let along_joint = |((link, slide), wrench): ((&Link<'g>, &Option<OfBody<'g>>), &Wrench<'g>)| match slide {
        None => wrench.power(&link.screw),
        Some(slide) => wrenches[slide.link].force.dot(slide.axis),
    };
    links.iter().zip(slides).zip(wrenches).map(along_joint).collect()
}

/// Each link with all that it carries.
fn composites<'g>(links: &[Link<'g>], frames: &[Frame<'g>]) -> Vec<MassMoments<'g>> {
    let mut composites: Vec<MassMoments<'g>> = frames.iter().map(|frame| frame.inertia).collect();
    for n in JointId::all(links.len()).rev() {
        if let Some(parent) = links[n].parent {
            composites[parent] = composites[parent] + frames[n].inertia_to_parent(&composites[n]);
        }
    }
    composites
}

/// `A_ij`: the momentum of all that link j carries, when its joint alone moves at unit rate, along the joint of each link below.
fn mass_matrix<'g>(
    links: &[Link<'g>],
    frames: &[Frame<'g>],
    slides: &[Option<OfBody<'g>>],
    composites: &[MassMoments<'g>],
) -> Vec<Entry<'g>> {
    let mut entries = Vec::new();
    for j in JointId::all(links.len()) {
        if slides[j].is_some() {
            entries.push((j, j, composites[j].mass));
            continue;
        }
        let mut wrench = composites[j] * links[j].screw;
        let mut at = j;
        loop {
            entries.push((at, j, wrench.power(&links[at].screw)));
            let own = JointId::all(links.len()).zip(slides);
            let own = own.filter_map(|(n, slide)| Some((n, slide.filter(|slide| slide.link == at)?)));
            entries.extend(own.map(|(n, slide)| (n, j, wrench.force.dot(slide.axis))));
            let Some(parent) = links[at].parent.filter(|&parent| slides[parent].is_none()) else {
                break;
            };
            wrench = frames[at].wrench_to_parent(&wrench);
            at = parent;
        }
    }
    entries
}
