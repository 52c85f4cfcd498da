//! Declares a robot as bodies of a scene, in the text of the language.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::names::{TURN, check_names, identifier, part_of};
use super::number::{ZERO, are_zero};
use super::read::Wrong;
use super::robot::{Joint, Kind, Link, Mimic, Origin, Robot};
use super::tree::carrier;
use crate::ast;
use crate::error::Code;
use crate::lower::reserved;
use crate::words;

/// Changes that a scene makes to a link and its joint.
#[derive(Debug)]
pub(super) struct Replaced {
    /// Body of the link.
    pub(super) body: String,
    /// Name of the coordinate, if the scene gives one.
    pub(super) coordinate: Option<String>,
    /// True if the joint is fixed or driven, or has an orientation, and thus no coordinate.
    pub(super) held: bool,
    /// True if the scene gives a joint, a coordinate or a motion.
    pub(super) joint: bool,
    /// True if the joint moves; `None` if the scene gives no joint.
    pub(super) moves: Option<bool>,
    /// True if the scene gives a joint with a place of its own.
    pub(super) placed: bool,
    /// True if the scene gives mass properties.
    pub(super) weighs: bool,
}

/// Declares the bodies of a robot: first the root, which is fixed to the ground, then one body for each link, in the
/// order of the joints that carry them. For joints that are `replaced`, it does not matter what they mimic.
pub(super) fn declare(robot: &Robot, item: &ast::Robot, replaced: &[Replaced], wrong: &mut Vec<Wrong>) -> String {
    let mut text = String::new();
    check_names(robot, wrong);
    check_reserved(robot, replaced, wrong);
    let carrier = carrier(robot);
    let is_root = |link: &&Link| !carrier.contains_key(link.name.as_str());
    let links: BTreeMap<&str, &Link> = robot.links.iter().map(|link| (link.name.as_str(), link)).collect();
    for link in robot.links.iter().filter(is_root) {
        writeln!(text, "body {} on ground {{ {} }}", identifier(&link.name), mass(link)).expect("memory");
    }
    for joint in &robot.joints {
        let Some(&link) = links.get(joint.child.as_str()) else {
            continue;
        };
        let is_replaced = find(replaced, &link.name).is_some();
        if joint.kind == Kind::Planar || joint.kind == Kind::Floats && !is_replaced {
            require_bare(joint, item, wrong);
        }
        let mut carrier = Carrier {
            body: identifier(&joint.parent),
            place: place(&joint.origin),
        };
        let moving = match joint.kind {
            Kind::Fixed => "joint: fixed".to_owned(),
            Kind::Floats => floats(joint),
            Kind::Planar => {
                slides_in_plane(joint, &mut carrier, &mut text);
                turns_in_plane(joint)
            }
            Kind::Turns | Kind::Slides => {
                let moves = match &joint.mimic {
                    None => format!("coordinate: {},", identifier(&joint.name)),
                    Some(_) if is_replaced => String::new(),
                    Some(mimic) => followed(robot, joint, mimic, replaced, item).unwrap_or_else(|refused| {
                        wrong.push(refused);
                        String::new()
                    }),
                };
                let word = if joint.kind == Kind::Turns {
                    "revolute"
                } else {
                    "prismatic"
                };
                format!("{moves} joint: {word}({})", list(&joint.axis))
            }
        };
        let (body, mass, forces) = (identifier(&link.name), mass(link), forces(joint, item));
        let Carrier { body: parent, place } = carrier;
        writeln!(text, "body {body} on {parent} {{ {mass} {moving} {place}, {forces} }}").expect("memory");
    }
    text
}

/// Returns the change that the scene makes to the joint of a link.
fn find<'r>(replaced: &'r [Replaced], link: &str) -> Option<&'r Replaced> {
    let link = identifier(link);
    replaced.iter().find(|own| own.joint && own.body == link)
}

/// Returns the maximum force and rate of each coordinate for which the file gives a finite one.
pub(super) fn most(robot: &Robot, replaced: &[Replaced]) -> Vec<(String, [f64; 2])> {
    let mut all = Vec::new();
    for joint in robot
        .joints
        .iter()
        .filter(|joint| matches!(joint.kind, Kind::Turns | Kind::Slides))
    {
        let own = find(replaced, &joint.child);
        let renamed = own.and_then(|own| own.coordinate.clone());
        // skip joints that mimic another, and joints that the scene replaces
        let is_there = joint.mimic.is_none() || renamed.is_some();
        let is_same = own.is_none_or(|own| !own.held && own.moves.is_none());
        if is_there && is_same && joint.most.iter().any(|most| most.is_finite()) {
            all.push((renamed.unwrap_or_else(|| identifier(&joint.name)), joint.most));
        }
    }
    all
}

/// Body that carries a joint, and the place on it.
struct Carrier {
    body: String,
    place: String,
}

/// Returns the names and the joint of a floating body.
fn floats(joint: &Joint) -> String {
    let [position, orientation] = ["position", "orientation"].map(|part| part_of(joint, part));
    format!("position: {position}, orientation: {orientation}, joint: free")
}

/// Declares the massless bodies that slide in the plane of a joint; the last one becomes the carrier.
fn slides_in_plane(joint: &Joint, carrier: &mut Carrier, text: &mut String) {
    for axis in joint.in_plane() {
        let slide = part_of(joint, axis);
        let moving = format!("coordinate: {slide}, joint: prismatic({axis})");
        let Carrier { body, place } = &carrier;
        writeln!(text, "body {slide} on {body} {{ {moving} {place}, }}").expect("memory");
        *carrier = Carrier {
            body: slide,
            place: String::new(),
        };
    }
}

/// Returns the coordinate and the joint of the rotation in a plane.
fn turns_in_plane(joint: &Joint) -> String {
    format!(
        "coordinate: {}, joint: revolute({})",
        part_of(joint, TURN),
        list(&joint.axis)
    )
}

/// Rejects attributes that a joint with several coordinates cannot have.
fn require_bare(joint: &Joint, item: &ast::Robot, wrong: &mut Vec<Wrong>) {
    let Joint { name, kind, axis, .. } = joint;
    let is_planar = *kind == Kind::Planar;
    if is_planar && axis.iter().filter(|number| *number == ZERO).count() != 2 {
        wrong.push(Wrong {
            code: Code::FileJoint,
            line: Some(joint.line),
            fact: format!(
                "joint `{name}` is `planar`, but its axis {} is not an axis of its frame",
                list(axis)
            ),
            help: "use `1 0 0`, `0 1 0` or `0 0 1`, and rotate the frame by the `rpy` of `origin`".to_owned(),
        });
    }
    let word = if is_planar { "planar" } else { "floating" };
    let dry = dry_friction(joint, item);
    for (attribute, force) in [("damping", joint.damping.as_ref()), ("friction", dry)] {
        if force.is_some() {
            wrong.push(Wrong {
                code: Code::FileJoint,
                line: Some(joint.line),
                fact: format!(
                    "joint `{name}` is `{word}`, so its `{attribute}` cannot be one number: the joint slides and \
                     turns"
                ),
                help: format!("remove it, and {}", instead_of_friction(joint)),
            });
        }
    }
    if let Some(mimic) = &joint.mimic {
        wrong.push(Wrong {
            code: Code::FileJoint,
            line: Some(joint.line),
            fact: format!("joint `{name}` is `{word}`, so it cannot mimic `{}`", mimic.joint),
            help: "remove `mimic`, or make the joint `revolute` or `prismatic`".to_owned(),
        });
    }
}

/// Returns the help text on replacing the friction of a joint with several coordinates.
fn instead_of_friction(joint: &Joint) -> String {
    if joint.kind != Kind::Planar {
        return "write drag as `force on point: ..`".to_owned();
    }
    let [first, second] = joint.in_plane().map(|axis| part_of(joint, axis));
    let body = identifier(&joint.child);
    format!("give a `friction` to the bodies `{first}`, `{second}` and `{body}` in the scene")
}

/// Rejects words of the language as names of coordinates, unless the scene renames them.
fn check_reserved(robot: &Robot, replaced: &[Replaced], wrong: &mut Vec<Wrong>) {
    for joint in &robot.joints {
        let is_renamed = |replaced: &Replaced| replaced.coordinate.is_some() || replaced.held;
        let (coordinate, instead) = match joint.kind {
            Kind::Turns => (identifier(&joint.name), "angle"),
            Kind::Slides => (identifier(&joint.name), "pos"),
            _ => continue,
        };
        let Some(meaning) = reserved(&coordinate) else { continue };
        if joint.mimic.is_some() || find(replaced, &joint.child).is_some_and(is_renamed) {
            continue;
        }
        let (body, parent) = (identifier(&joint.child), identifier(&joint.parent));
        wrong.push(Wrong {
            code: Code::FileNames,
            line: Some(joint.line),
            fact: format!("the name of joint `{coordinate}` is a reserved word: {meaning}"),
            help: format!("rename it by `body {body} on {parent} {{ coordinate: {instead} }}` in the scene"),
        });
    }
}

fn mass(link: &Link) -> String {
    let Some(inertial) = &link.inertial else {
        return String::new();
    };
    let Origin { xyz, rpy } = &inertial.origin;
    let mut text = match inertial.mass.as_str() {
        ZERO => String::new(),
        mass => format!("mass: {mass}, com: {},", list(xyz)),
    };
    if !are_zero(&inertial.inertia) {
        write!(text, " inertia: {}", list(&inertial.inertia)).expect("memory");
        if !are_zero(rpy) {
            write!(text, " rpy {}", list(rpy)).expect("memory");
        }
        text.push(',');
    }
    text
}

/// Returns the place of a joint, which follows its kind.
fn place(origin: &Origin) -> String {
    let mut text = String::new();
    for (word, numbers) in [("at", &origin.xyz), ("rpy", &origin.rpy)] {
        if !are_zero(numbers) {
            write!(text, " {word} {}", list(numbers)).expect("memory");
        }
    }
    text
}

/// Returns the motion of a joint that mimics another.
fn followed(
    robot: &Robot,
    joint: &Joint,
    mimic: &Mimic,
    replaced: &[Replaced],
    item: &ast::Robot,
) -> Result<String, Wrong> {
    let mut followers = vec![(joint, mimic)];
    let (leader, replaced) = loop {
        let (last, mimic) = followers[followers.len() - 1];
        let Some(leader) = robot.joints.iter().find(|other| other.name == mimic.joint) else {
            let help = match nearest_leader(robot, last, mimic) {
                Some(meant) => format!("did you mean `{meant}`? {ANOTHER}"),
                None => ANOTHER.to_owned(),
            };
            return Err(refused(last, mimic, ", which is not a joint", &help));
        };
        let replaced = find(replaced, &leader.child);
        match &leader.mimic {
            // follow the chain up to a joint that moves by itself, or once around a cycle
            Some(next)
                if matches!(leader.kind, Kind::Turns | Kind::Slides)
                    && replaced.is_none()
                    && followers.len() <= robot.joints.len() =>
            {
                followers.push((leader, next));
            }
            _ => break (leader, replaced),
        }
    };
    if let Some((why, help)) = obstacle(joint, leader, replaced, item) {
        return Err(refused(joint, mimic, why, help));
    }
    let mut motion = replaced
        .and_then(|replaced| replaced.coordinate.clone())
        .unwrap_or_else(|| identifier(&leader.name));
    let mut kind = leader.kind;
    for (follower, Mimic { multiplier, offset, .. }) in followers.into_iter().rev() {
        let unit = match (follower.kind, kind) {
            (Kind::Turns, Kind::Slides) => " * 1 rad/m",
            (Kind::Slides, Kind::Turns) => " * 1 m/rad",
            _ => "",
        };
        let offset = match offset.as_str() {
            ZERO => String::new(),
            offset => format!(" + {offset}"),
        };
        motion = format!("{multiplier} * ({motion}){unit}{offset}");
        kind = follower.kind;
    }
    Ok(format!("motion: {motion},"))
}

/// Returns the joint with the name most similar to the one mimicked, among those that can lead.
fn nearest_leader<'r>(robot: &'r Robot, joint: &Joint, mimic: &Mimic) -> Option<&'r str> {
    let leads = |other: &&Joint| {
        let moves = matches!(other.kind, Kind::Turns | Kind::Slides) && other.mimic.is_none();
        moves && other.name != joint.name
    };
    let leaders = robot.joints.iter().filter(leads).map(|other| other.name.as_str());
    words::advice(&mimic.joint, leaders, &[]).meant
}

/// Help text for a joint that cannot lead.
const ANOTHER: &str = "let it mimic an independent joint";

/// Returns why a joint cannot follow another, and a help text.
fn obstacle(
    joint: &Joint,
    leader: &Joint,
    replaced: Option<&Replaced>,
    item: &ast::Robot,
) -> Option<(&'static str, &'static str)> {
    Some(if leader.name == joint.name {
        ("", "name the joint that it follows")
    } else if leader.kind == Kind::Fixed {
        (", which is fixed", ANOTHER)
    } else if leader.kind.has_many() {
        (", which has more than one coordinate", ANOTHER)
    } else if leader.mimic.is_some() && replaced.is_none() {
        (", which mimics itself through other joints", ANOTHER)
    } else if replaced.is_some_and(|replaced| replaced.held) {
        (", which the scene fixes, drives or makes `free`", ANOTHER)
    } else if dry_friction(joint, item).is_some() {
        (
            ", so it cannot have dry `friction` of its own",
            "move it to the joint that is mimicked, or leave out all dry friction by `urdf(\"..\", without \
             dry_friction)`",
        )
    } else {
        return None;
    })
}

/// Returns the error for a joint that cannot follow the one it mimics.
fn refused(joint: &Joint, mimic: &Mimic, why: &str, help: &str) -> Wrong {
    let (body, parent) = (identifier(&joint.child), identifier(&joint.parent));
    let whom = if mimic.joint == joint.name {
        "itself".to_owned()
    } else {
        format!("`{}`", mimic.joint)
    };
    let instead = format!(
        "or write `body {body} on {parent} {{ joint: fixed }}` to fix it, or `{{ coordinate: .. }}` to make it \
         independent"
    );
    Wrong {
        code: Code::FileJoint,
        line: Some(joint.line),
        fact: format!("joint `{}` mimics {whom}{why}", joint.name),
        help: format!("{help}, {instead}"),
    }
}

/// Returns the dry friction of a joint, unless the scene leaves it out.
fn dry_friction<'j>(joint: &'j Joint, item: &ast::Robot) -> Option<&'j String> {
    joint.friction.as_ref().filter(|_| !item.without_dry_friction)
}

/// Returns the friction and the stop of a joint.
fn forces(joint: &Joint, item: &ast::Robot) -> String {
    let mut text = String::new();
    if joint.kind == Kind::Fixed || joint.kind.has_many() {
        return text;
    }
    let dry = dry_friction(joint, item);
    for (word, force) in [("friction", joint.damping.as_ref()), ("dry_friction", dry)] {
        if let Some(force) = force {
            write!(text, "{word}: {force}, ").expect("memory");
        }
    }
    if let (true, Some(limits), None) = (item.limits, &joint.limits, &joint.mimic) {
        write!(text, "stop: {},", list(limits)).expect("memory");
    }
    text
}

fn list(numbers: &[String]) -> String {
    format!("[{}]", numbers.join(", "))
}
