//! A robot as bodies of a scene: text of the language.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use super::read::{Joint, Kind, Link, Mimic, Origin, Robot, Wrong, ZERO};
use crate::ast;

/// The bodies of a robot: one for each link, in the order of the joints that carry them; first the root, which stands
/// on the ground. The joints of some links are `replaced`, so it does not matter what they follow.
pub(super) fn declare(robot: &Robot, item: &ast::Robot, replaced: &[String], wrong: &mut Vec<Wrong>) -> String {
    let mut text = String::new();
    if !is_tree(robot, wrong) {
        return text;
    }
    let links = named(robot.links.iter().map(|link| &link.name), "link", wrong);
    let joints = named(robot.joints.iter().map(|joint| &joint.name), "joint", wrong);
    let is_root = |link: &&Link| carried_by(robot, &link.name).next().is_none();
    for link in robot.links.iter().filter(is_root) {
        writeln!(text, "body {} on ground {{ {} }}", links[&link.name], mass(link)).expect("memory");
    }
    for joint in &robot.joints {
        let Some(link) = robot.links.iter().find(|link| link.name == joint.child) else {
            continue;
        };
        let moving = match (joint.kind, &joint.mimic) {
            (Kind::Fixed, _) => String::new(),
            (_, None) => format!("coordinate: {},", joints[&joint.name]),
            (_, Some(_)) if replaced.contains(&links[&link.name]) => String::new(),
            (_, Some(mimic)) => followed(robot, joint, mimic, &joints, wrong),
        };
        let (body, parent) = (&links[&link.name], &links[&joint.parent]);
        let (mass, forces) = (mass(link), forces(joint, item));
        let joint = placed(joint);
        writeln!(text, "body {body} on {parent} {{ {mass} {joint} {moving} {forces} }}").expect("memory");
    }
    text
}

/// The joints that carry a link.
fn carried_by<'r>(robot: &'r Robot, link: &str) -> impl Iterator<Item = &'r Joint> {
    robot.joints.iter().filter(move |joint| joint.child == link)
}

/// Whether each link hangs on one joint at most, and all of them on one root.
fn is_tree(robot: &Robot, wrong: &mut Vec<Wrong>) -> bool {
    let mut found = Vec::new();
    let mut push = |fact: String, help: &str| {
        let help = help.to_owned();
        found.push(Wrong { fact, help });
    };
    let known: BTreeSet<&str> = robot.links.iter().map(|link| link.name.as_str()).collect();
    for joint in &robot.joints {
        for end in [&joint.parent, &joint.child] {
            if !known.contains(end.as_str()) {
                let fact = format!("joint `{}` is tied to `{end}`, which is no link", joint.name);
                push(fact, &format!("add `<link name=\"{end}\"/>`, or mend the name"));
            }
        }
    }
    let mut roots: BTreeSet<&str> = BTreeSet::new();
    for link in &robot.links {
        let parents: Vec<&str> = carried_by(robot, &link.name)
            .map(|joint| joint.parent.as_str())
            .collect();
        if parents.is_empty() {
            roots.insert(&link.name);
        } else if parents.len() > 1 {
            let fact = format!("link `{}` hangs on `{}`: a loop", link.name, parents.join("` and on `"));
            push(fact, "a URDF file describes a tree: remove all but one of its joints");
        }
    }
    if known.is_empty() {
        push("it has no link".to_owned(), "add `<link name=\"..\"/>`");
    } else if let (Some(root), Some(other)) = (roots.first(), roots.iter().nth(1)) {
        let fact = format!("both `{root}` and `{other}` hang on nothing, so there is more than one root");
        push(fact, "hang one of them on another link, by a joint of type `fixed`");
    } else {
        let mut reached = roots;
        let next = |reached: &BTreeSet<&str>| {
            let leads_on = |joint: &&Joint| reached.contains(&*joint.parent) && !reached.contains(&*joint.child);
            robot.joints.iter().find(leads_on)
        };
        while let Some(joint) = next(&reached) {
            reached.insert(&joint.child);
        }
        if let Some(link) = known.difference(&reached).next() {
            let fact = format!("link `{link}` hangs on itself, by way of the links that carry it");
            push(fact, "follow the parents: each chain must end on one root");
        }
    }
    let is_tree = found.is_empty();
    wrong.append(&mut found);
    is_tree
}

/// Identifiers for names. Two names that have the same one are an error.
fn named<'r>(
    names: impl Iterator<Item = &'r String>,
    what: &str,
    wrong: &mut Vec<Wrong>,
) -> BTreeMap<&'r String, String> {
    let mut taken: BTreeMap<String, &String> = BTreeMap::new();
    let mut named = BTreeMap::new();
    for name in names {
        let identifier = identifier(name);
        if let Some(other) = taken.insert(identifier.clone(), name).filter(|other| *other != name) {
            wrong.push(Wrong {
                fact: format!("the {what}s `{other}` and `{name}` have one name here, `{identifier}`"),
                help: "rename one of the two".to_owned(),
            });
        }
        named.insert(name, identifier);
    }
    named
}

/// Names that mean something else, and keywords that no raw identifier has.
const TAKEN: [&str; 5] = ["ground", "self", "Self", "super", "crate"];

/// A name as an identifier: whatever cannot stand in one becomes `_`.
fn identifier(name: &str) -> String {
    let is_name = |text: &str| syn::parse_str::<syn::Ident>(text).is_ok();
    let plain = |c: char| if is_name(&format!("_{c}")) { c } else { '_' };
    let mut identifier: String = name.chars().map(plain).collect();
    if TAKEN.contains(&identifier.as_str()) {
        identifier.push('_');
    } else if is_name(&format!("r#{identifier}")) && !is_name(&identifier) {
        identifier.insert_str(0, "r#");
    } else if !is_name(&identifier) {
        identifier.insert(0, '_');
    }
    identifier
}

fn mass(link: &Link) -> String {
    let Some(inertial) = &link.inertial else {
        return String::new();
    };
    let Origin { xyz, rpy } = &inertial.origin;
    let mut text = format!("mass: {}, com: {},", inertial.mass, list(xyz));
    if !is_zero(&inertial.inertia) {
        write!(text, " inertia: {}", list(&inertial.inertia)).expect("memory");
        if !is_zero(rpy) {
            write!(text, " rpy {}", list(rpy)).expect("memory");
        }
        text.push(',');
    }
    text
}

fn placed(joint: &Joint) -> String {
    let axis = list(&joint.axis);
    let mut text = match joint.kind {
        Kind::Fixed => "joint: fixed".to_owned(),
        Kind::Turns => format!("joint: revolute({axis})"),
        Kind::Slides => format!("joint: prismatic({axis})"),
    };
    let Origin { xyz, rpy } = &joint.origin;
    for (word, numbers) in [("at", xyz), ("rpy", rpy)] {
        if !is_zero(numbers) {
            write!(text, " {word} {}", list(numbers)).expect("memory");
        }
    }
    text.push(',');
    text
}

/// The motion of a joint that follows another.
fn followed(
    robot: &Robot,
    joint: &Joint,
    mimic: &Mimic,
    names: &BTreeMap<&String, String>,
    wrong: &mut Vec<Wrong>,
) -> String {
    let (name, multiplier) = (&joint.name, &mimic.multiplier);
    let mut refuse = |why: String, help: String| {
        let fact = format!("joint `{name}` mimics `{}`{why}", mimic.joint);
        wrong.push(Wrong { fact, help });
        String::new()
    };
    let another = || "let it mimic a joint that moves by itself".to_owned();
    let Some(leader) = robot.joints.iter().find(|other| other.name == mimic.joint) else {
        return refuse(", which is no joint".to_owned(), another());
    };
    if leader.kind == Kind::Fixed {
        return refuse(", which is fixed".to_owned(), another());
    }
    if leader.mimic.is_some() {
        return refuse(", which itself mimics another".to_owned(), another());
    }
    if multiplier.parse().is_ok_and(|factor: f64| factor.fract() != 0.0) {
        let (body, parent) = (identifier(&joint.child), identifier(&joint.parent));
        let help = format!(
            "factors are whole numbers; hold it by `body {body} on {parent} {{ joint: fixed }}`, \
             or let it move by itself by `coordinate: ..` there"
        );
        return refuse(format!(" by a factor of {multiplier}"), help);
    }
    let unit = match (joint.kind, leader.kind) {
        (Kind::Turns, Kind::Slides) => " * 1 rad/m",
        (Kind::Slides, Kind::Turns) => " * 1 m/rad",
        _ => "",
    };
    let offset = match mimic.offset.as_str() {
        ZERO => String::new(),
        offset => format!(" + {offset}"),
    };
    format!("motion: {multiplier} * {}{unit}{offset},", names[&leader.name])
}

/// What acts along a joint.
fn forces(joint: &Joint, item: &ast::Robot) -> String {
    let mut text = String::new();
    if joint.kind == Kind::Fixed {
        return text;
    }
    let dry = joint.friction.as_ref().filter(|_| !item.without_dry_friction);
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

fn is_zero(numbers: &[String]) -> bool {
    numbers.iter().all(|number| number == ZERO)
}
