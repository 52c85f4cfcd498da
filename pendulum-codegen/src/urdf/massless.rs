//! Joints that move no mass: their coordinates have no equation of motion.

use std::collections::{BTreeMap, BTreeSet};

use super::declare::Replaced;
use super::names::identifier;
use super::robot::{Joint, Kind, Robot};
use super::tree::carrier;

/// Fixes each joint that moves no mass, unless a joint that moves mass mimics it; returns a message for each. Joints
/// that the scene changes are left alone, and so are joints of links that carry bodies of the scene.
pub(super) fn hold(robot: &mut Robot, replaced: &[Replaced], carriers: &BTreeSet<String>) -> Vec<String> {
    let heavy = heavy(robot, replaced, carriers);
    let moves_mass = |joint: &Joint| heavy.contains(&joint.child);
    let is_changed = |joint: &Joint| {
        let child = identifier(&joint.child);
        replaced.iter().any(|own| own.joint && own.body == child)
    };
    let stays = |joint: &Joint| joint.kind == Kind::Fixed || moves_mass(joint) || is_changed(joint);
    // a joint also moves the mass of joints that mimic it
    let leaders: BTreeMap<&str, &str> = robot
        .joints
        .iter()
        .filter_map(|joint| Some((&*joint.name, &*joint.mimic.as_ref()?.joint)))
        .collect();
    let mut needed = BTreeSet::new();
    for joint in robot.joints.iter().filter(|joint| stays(joint)) {
        let mut at = leaders.get(&*joint.name);
        while let Some(leader) = at
            && needed.insert((*leader).to_owned())
        {
            at = leaders.get(leader);
        }
    }
    let held: Vec<bool> = robot
        .joints
        .iter()
        .map(|joint| !stays(joint) && !needed.contains(&joint.name))
        .collect();
    let mut messages = Vec::new();
    for (joint, _) in robot.joints.iter_mut().zip(held).filter(|(_, held)| *held) {
        joint.kind = Kind::Fixed;
        joint.mimic = None;
        joint.damping = None;
        joint.friction = None;
        messages.push(format!(
            "joint `{}`, which moves no mass, is held",
            identifier(&joint.name)
        ));
    }
    messages
}

/// Returns the links with mass, and those that carry them.
fn heavy(robot: &Robot, replaced: &[Replaced], carriers: &BTreeSet<String>) -> BTreeSet<String> {
    let carrier = carrier(robot);
    let mut heavy = BTreeSet::new();
    for link in &robot.links {
        let name = identifier(&link.name);
        let weighs = replaced.iter().any(|own| own.weighs && own.body == name);
        let mut at = Some(&*link.name).filter(|_| link.inertial.is_some() || weighs || carriers.contains(&name));
        while let Some(link) = at
            && heavy.insert(link.to_owned())
        {
            at = carrier.get(link).map(|joint| &*joint.parent);
        }
    }
    heavy
}
