//! A robot as bodies of a scene: text of the language.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use super::read::{Joint, Kind, Link, Mimic, Origin, Robot, Wrong, ZERO};
use crate::ast;

/// What a scene says of the joint of a link.
#[derive(Debug)]
pub(super) struct Replaced {
    /// The body of the link.
    pub(super) body: String,
    /// The coordinate, where it has another name.
    pub(super) coordinate: Option<String>,
    /// Whether the joint is fixed, or driven.
    pub(super) held: bool,
}

/// The bodies of a robot: one for each link, in the order of the joints that carry them; first the root, which stands
/// on the ground. The joints of some links are `replaced`, so it does not matter what they follow.
pub(super) fn declare(robot: &Robot, item: &ast::Robot, replaced: &[Replaced], wrong: &mut Vec<Wrong>) -> String {
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
        let is_replaced = |link: &String| replaced.iter().find(|replaced| replaced.body == links[link]);
        let moving = match (joint.kind, &joint.mimic) {
            (Kind::Fixed, _) => String::new(),
            (_, None) => format!("coordinate: {},", joints[&joint.name]),
            (_, Some(_)) if is_replaced(&link.name).is_some() => String::new(),
            (_, Some(mimic)) => {
                let leader = robot.joints.iter().find(|other| other.name == mimic.joint);
                let leader = leader.map(|leader| Leader {
                    joint: leader,
                    name: &joints[&leader.name],
                    replaced: is_replaced(&leader.child),
                });
                followed(joint, mimic, leader, wrong)
            }
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

/// A joint that another one follows.
struct Leader<'r> {
    joint: &'r Joint,
    name: &'r str,
    replaced: Option<&'r Replaced>,
}

/// The motion of a joint that follows another.
fn followed(joint: &Joint, mimic: &Mimic, leader: Option<Leader<'_>>, wrong: &mut Vec<Wrong>) -> String {
    let (body, parent) = (identifier(&joint.child), identifier(&joint.parent));
    let mut refuse = |why: &str, help: &str| {
        let fact = format!("joint `{}` mimics `{}`{why}", joint.name, mimic.joint);
        let instead = format!(
            "or write `body {body} on {parent} {{ joint: fixed }}` to hold it, `{{ coordinate: .. }}` to let it move"
        );
        let help = format!("{help}, {instead}");
        wrong.push(Wrong { fact, help });
        String::new()
    };
    let another = "let it mimic a joint that moves by itself";
    let Some(Leader {
        joint: leader,
        name,
        replaced,
    }) = leader
    else {
        return refuse(", which is no joint", another);
    };
    if leader.kind == Kind::Fixed {
        return refuse(", which is fixed", another);
    }
    if leader.mimic.is_some() {
        return refuse(", which itself mimics another", another);
    }
    if replaced.is_some_and(|replaced| replaced.held) {
        return refuse(", which the scene holds or drives", another);
    }
    let multiplier = &mimic.multiplier;
    if multiplier.parse().is_ok_and(|factor: f64| factor.fract() != 0.0) {
        return refuse(&format!(" by a factor of {multiplier}"), "let it be a whole number");
    }
    let name = replaced
        .and_then(|replaced| replaced.coordinate.as_deref())
        .unwrap_or(name);
    let unit = match (joint.kind, leader.kind) {
        (Kind::Turns, Kind::Slides) => " * 1 rad/m",
        (Kind::Slides, Kind::Turns) => " * 1 m/rad",
        _ => "",
    };
    let offset = match mimic.offset.as_str() {
        ZERO => String::new(),
        offset => format!(" + {offset}"),
    };
    format!("motion: {multiplier} * {name}{unit}{offset},")
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
