//! Whether the links of a robot hang on each other as a tree.

use std::collections::BTreeSet;

use super::read::Wrong;
use super::robot::{Joint, Link, Robot};

/// Whether each link hangs on one joint at most, and all of them on one root.
pub(super) fn is_tree(robot: &Robot, wrong: &mut Vec<Wrong>) -> bool {
    let unknown = unknown_ends(robot);
    // what hangs on a link by its misspelt name seems to hang on nothing
    let roots = if unknown.is_empty() { roots(robot) } else { None };
    let before = wrong.len();
    wrong.extend(unknown);
    wrong.extend(loops(robot));
    wrong.extend(roots);
    wrong.len() == before
}

/// Ends of joints that are no links.
fn unknown_ends(robot: &Robot) -> Vec<Wrong> {
    let known = |end: &str| robot.links.iter().any(|link| link.name == end);
    let mut found = Vec::new();
    for joint in &robot.joints {
        for end in [&joint.parent, &joint.child].into_iter().filter(|end| !known(end)) {
            found.push(Wrong {
                fact: format!("joint `{}` is tied to `{end}`, which is no link", joint.name),
                help: format!("add `<link name=\"{end}\"/>`, or mend the name"),
            });
        }
    }
    found
}

/// Links that hang on more than one joint.
fn loops(robot: &Robot) -> Vec<Wrong> {
    let mut found = Vec::new();
    for Link { name, .. } in &robot.links {
        let parents: Vec<&str> = carried_by(robot, name).map(|joint| joint.parent.as_str()).collect();
        if parents.len() > 1 {
            found.push(Wrong {
                fact: format!("link `{name}` hangs on `{}`: a loop", parents.join("` and on `")),
                help: "a URDF file describes a tree: remove all but one of its joints".to_owned(),
            });
        }
    }
    found
}

/// More roots than one, or none, or links that hang on none.
fn roots(robot: &Robot) -> Option<Wrong> {
    let known: BTreeSet<&str> = robot.links.iter().map(|link| link.name.as_str()).collect();
    let is_root = |link: &&str| carried_by(robot, link).next().is_none();
    let roots: BTreeSet<&str> = known.iter().copied().filter(is_root).collect();
    let (fact, help) = if known.is_empty() {
        ("it has no link".to_owned(), "add `<link name=\"..\"/>`")
    } else if let (Some(root), Some(other)) = (roots.first(), roots.iter().nth(1)) {
        (
            format!("both `{root}` and `{other}` hang on nothing, so there is more than one root"),
            "hang one of them on another link, by a joint of type `fixed`",
        )
    } else {
        let reached = reached(robot, roots);
        let link = known.difference(&reached).next()?;
        (
            format!("link `{link}` hangs on itself, by way of the links that carry it"),
            "follow the parents: each chain must end on one root",
        )
    };
    let help = help.to_owned();
    Some(Wrong { fact, help })
}

/// The links that hang on some, and these.
fn reached<'r>(robot: &'r Robot, mut reached: BTreeSet<&'r str>) -> BTreeSet<&'r str> {
    let next = |reached: &BTreeSet<&str>| {
        let leads_on = |joint: &&Joint| reached.contains(&*joint.parent) && !reached.contains(&*joint.child);
        robot.joints.iter().find(leads_on)
    };
    while let Some(joint) = next(&reached) {
        reached.insert(&joint.child);
    }
    reached
}

/// The joints that carry a link.
pub(super) fn carried_by<'r>(robot: &'r Robot, link: &str) -> impl Iterator<Item = &'r Joint> {
    robot.joints.iter().filter(move |joint| joint.child == link)
}
