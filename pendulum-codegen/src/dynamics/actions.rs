//! Actions on a scene beside its joints: as forces along its coordinates, or as wrenches on its links.

use super::frames::Frame;
use super::joint::JointId;
use super::links::Links;
use crate::expr::{Derivative, Expr};
use crate::model::{Action, BodyId, Model, Place, Poses};
use crate::screw::{Vec3, Wrench};

/// Forces of actions along the coordinates, with the drives behind the other coordinates.
pub(super) fn along_coordinates<'g>(model: &Model<'g>, actions: &[&Action<'g>]) -> Vec<Expr<'g>> {
    let g = model.graph;
    let mut forces = vec![g.zero(); model.all_coordinates().count()];
    if actions.is_empty() {
        return forces;
    }
    let poses = Poses::new(model);
    let place = |place: &Place<'g>| poses.point(place.body, place.at);
    for (k, coordinate) in model.all_coordinates().enumerate() {
        let mut by_position = coordinate.derivative().alone();
        let mut by_rate = Derivative::by(coordinate.rate).alone();
        for &action in actions {
            forces[k] += match action {
                Action::Along(own, force, _) if usize::from(*own) == k => *force,
                Action::Along(..) => g.zero(),
                Action::Potential(potential) => -by_position.of(*potential),
                Action::Dissipation(lost) => -by_rate.of(*lost),
                Action::Press(force, value) => by_position.of(*value) * *force,
                Action::Push(push) => {
                    let force = poses.direction(push.frame, push.force);
                    Vec3(place(&push.place).0.map(|x| by_position.of(x))).dot(force)
                }
                Action::Between { ends, factor, .. } => {
                    let [a, b] = ends.each_ref().map(place);
                    let apart = b - a;
                    -(*factor * apart.dot(Vec3(apart.0.map(|x| by_position.of(x)))))
                }
            };
        }
    }
    forces
}

/// True if an action is equivalent to wrenches on links.
pub(super) fn is_wrench(action: &Action<'_>) -> bool {
    matches!(action, Action::Push(_) | Action::Between { .. })
}

/// Wrenches of actions on the links, each in the frame and about the origin of its link: `(r x f, f)` for a force f at
/// r.
pub(super) fn wrenches<'g>(
    model: &Model<'g>,
    links: &Links<'g>,
    frames: &[Frame<'g>],
    actions: &[&Action<'g>],
) -> Vec<Wrench<'g>> {
    let poses = Poses::new(model);
    let zero = Vec3::zero(model.graph);
    let still = Wrench {
        moment: zero,
        force: zero,
    };
    let mut wrenches = vec![still; frames.len()];
    let mut push = |place: &Place<'g>, force: Vec3<'g>, frame: Option<BodyId>| {
        let Some((Some(link), body)) = place.body.map(|body| links.owners[body]) else {
            return;
        };
        let force = match frame.map(|frame| links.owners[frame]) {
            Some((Some(own), frame)) if own == link => frames[link].of_body(frame.rotation * force),
            _ => of_ground(links, frames, link, poses.direction(frame, force)),
        };
        let arm = frames[link].of_body(body.point(place.at));
        let wrench = Wrench {
            moment: arm.cross(force),
            force,
        };
        wrenches[link] = wrenches[link] + wrench;
    };
    for action in actions {
        match action {
            Action::Push(own) => push(&own.place, own.force, own.frame),
            Action::Between {
                ends: [a, b], factor, ..
            } => {
                let pull = *factor * (poses.point(b.body, b.at) - poses.point(a.body, a.at));
                push(a, pull, None);
                push(b, -pull, None);
            }
            Action::Along(..) | Action::Press(..) | Action::Potential(_) | Action::Dissipation(_) => {}
        }
    }
    wrenches
}

/// Rotates a vector of the ground frame into the frame of a link.
fn of_ground<'g>(links: &Links<'g>, frames: &[Frame<'g>], link: JointId, v: Vec3<'g>) -> Vec3<'g> {
    let below = links.links[link]
        .parent
        .map_or(v, |parent| of_ground(links, frames, parent, v));
    frames[link].of_parent(below)
}
