//! Checks that the links of a robot form a tree.

use std::collections::{BTreeMap, BTreeSet};

use super::read::Wrong;
use super::robot::{Joint, Link, Robot};
use crate::error::Code;

/// Checks that at most one joint carries each link, and that all links hang on one root. Adds errors to `wrong`.
pub(super) fn is_tree(robot: &Robot, wrong: &mut Vec<Wrong>) -> bool {
    let unknown = unknown_ends(robot);
    let carriers = carriers(robot);
    // a misspelt link in a joint would make another link appear as a root
    let roots = if unknown.is_empty() {
        roots(robot, &carriers)
    } else {
        None
    };
    let before = wrong.len();
    wrong.extend(unknown);
    wrong.extend(loops(robot, &carriers));
    wrong.extend(roots);
    wrong.len() == before
}

/// Returns the joint that carries each link of a tree except the root.
pub(super) fn carrier(robot: &Robot) -> BTreeMap<&str, &Joint> {
    robot.joints.iter().map(|joint| (&*joint.child, joint)).collect()
}

/// Returns the joints that carry each link.
fn carriers(robot: &Robot) -> BTreeMap<&str, Vec<&Joint>> {
    let mut carriers: BTreeMap<&str, Vec<&Joint>> = BTreeMap::new();
    for joint in &robot.joints {
        carriers.entry(&joint.child).or_default().push(joint);
    }
    carriers
}

/// Returns errors for ends of joints that are no links.
fn unknown_ends(robot: &Robot) -> Vec<Wrong> {
    let known: BTreeSet<&str> = robot.links.iter().map(|link| link.name.as_str()).collect();
    let mut found = Vec::new();
    for joint in &robot.joints {
        for end in [&joint.parent, &joint.child]
            .into_iter()
            .filter(|end| !known.contains(end.as_str()))
        {
            found.push(Wrong {
                code: Code::FileTree,
                line: Some(joint.line),
                fact: format!("joint `{}` refers to `{end}`, which is not a link", joint.name),
                help: format!("add `<link name=\"{end}\"/>`, or correct the name"),
            });
        }
    }
    found
}

/// Returns errors for links that hang on more than one joint.
fn loops(robot: &Robot, carriers: &BTreeMap<&str, Vec<&Joint>>) -> Vec<Wrong> {
    let mut found = Vec::new();
    for Link { name, line, .. } in &robot.links {
        let carriers = carriers.get(name.as_str()).into_iter().flatten();
        let parents: Vec<&str> = carriers.map(|joint| joint.parent.as_str()).collect();
        if parents.len() > 1 {
            found.push(Wrong {
                code: Code::FileTree,
                line: Some(*line),
                fact: format!(
                    "link `{name}` has more than one parent, `{}`: a loop",
                    parents.join("` and `")
                ),
                help: "a URDF file describes a tree: remove all but one of its joints".to_owned(),
            });
        }
    }
    found
}

/// Returns an error if there is more than one root, or none, or a link that hangs on no root.
fn roots(robot: &Robot, carriers: &BTreeMap<&str, Vec<&Joint>>) -> Option<Wrong> {
    let known: BTreeSet<&str> = robot.links.iter().map(|link| link.name.as_str()).collect();
    let roots: BTreeSet<&str> = known
        .iter()
        .copied()
        .filter(|link| !carriers.contains_key(link))
        .collect();
    let line = |name: &str| robot.links.iter().find(|link| link.name == name).map(|link| link.line);
    let (line, fact, help) = if known.is_empty() {
        (None, "the file has no link".to_owned(), "add `<link name=\"..\"/>`")
    } else if let (Some(root), Some(other)) = (roots.first(), roots.iter().nth(1)) {
        (
            line(other),
            format!("`{root}` and `{other}` have no parent, so there is more than one root link"),
            "connect one of them to a parent link by a joint of type `fixed`",
        )
    } else {
        let reached = reached(robot, roots);
        let link = known.difference(&reached).next()?;
        (
            line(link),
            format!("the parents of link `{link}` form a cycle"),
            "each chain of parents must end at the root link",
        )
    };
    let help = help.to_owned();
    Some(Wrong {
        code: Code::FileTree,
        line,
        fact,
        help,
    })
}

/// Returns the links that hang on the roots, including the roots.
fn reached<'r>(robot: &'r Robot, roots: BTreeSet<&'r str>) -> BTreeSet<&'r str> {
    let mut children: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for joint in &robot.joints {
        children.entry(&joint.parent).or_default().push(&joint.child);
    }
    let mut next: Vec<&str> = roots.iter().copied().collect();
    let mut reached = roots;
    while let Some(link) = next.pop() {
        let children = children.get(link).into_iter().flatten();
        next.extend(children.filter(|child| reached.insert(child)));
    }
    reached
}
