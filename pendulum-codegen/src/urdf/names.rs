//! Names of links and joints as identifiers of the language.

use std::collections::BTreeMap;

use super::read::Wrong;
use super::robot::{Joint, Kind, Robot};
use crate::error::Code;
use crate::parse::is_identifier;

/// Names with another meaning, and keywords that cannot be raw identifiers.
const TAKEN: [&str; 5] = ["ground", "self", "Self", "super", "crate"];

/// Suffix of the coordinate for the angle of a planar joint.
pub(super) const TURN: &str = "turn";

/// Converts a name to an identifier; characters that cannot be part of one become `_`.
pub(super) fn identifier(name: &str) -> String {
    let plain = |c: char| if is_identifier(&format!("_{c}")) { c } else { '_' };
    let mut identifier: String = name.chars().map(plain).collect();
    if TAKEN.contains(&identifier.as_str()) {
        identifier.push('_');
    } else if is_identifier(&format!("r#{identifier}")) && !is_identifier(&identifier) {
        identifier.insert_str(0, "r#");
    } else if !is_identifier(&identifier) {
        identifier.insert(0, '_');
    }
    identifier
}

/// Returns the name of a part of a joint with several coordinates.
pub(super) fn part_of(joint: &Joint, part: &str) -> String {
    identifier(&format!("{}_{part}", joint.name))
}

/// Reports links and joints whose names, or names of parts, become the same identifier.
pub(super) fn check_names(robot: &Robot, wrong: &mut Vec<Wrong>) {
    let planar = robot.joints.iter().filter(|joint| joint.kind == Kind::Planar);
    let slides = planar.flat_map(|joint| joint.in_plane().map(|axis| (joint, part_of(joint, axis))));
    let slides = slides.map(|(joint, slide)| (("joint", &joint.name, joint.line), slide));
    let links = robot.links.iter();
    let bodies = links.map(|link| (("link", &link.name, link.line), identifier(&link.name)));
    let coordinates = robot.joints.iter().flat_map(|joint| {
        let parts = match joint.kind {
            Kind::Floats => vec!["position", "orientation"],
            Kind::Planar => [&joint.in_plane()[..], &[TURN]].concat(),
            _ => return vec![(("joint", &joint.name, joint.line), identifier(&joint.name))],
        };
        let parts = parts
            .into_iter()
            .map(|part| (("joint", &joint.name, joint.line), part_of(joint, part)));
        parts.collect()
    });
    for names in [bodies.chain(slides).collect::<Vec<_>>(), coordinates.collect()] {
        let mut taken = BTreeMap::new();
        for (owner, name) in names {
            let Some(other) = taken.insert(name.clone(), owner).filter(|other| *other != owner) else {
                continue;
            };
            let both = match (other, owner) {
                ((what, a, _), (also, b, _)) if what == also => format!("the {what}s `{a}` and `{b}`"),
                ((what, a, _), (other, b, _)) => format!("the {what} `{a}` and the {other} `{b}`"),
            };
            wrong.push(Wrong {
                code: Code::FileNames,
                line: Some(owner.2),
                fact: format!("{both} both become `{name}`"),
                help: "rename one of the two".to_owned(),
            });
        }
    }
}
