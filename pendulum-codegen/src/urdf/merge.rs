//! Merges the bodies of a scene into those of its robot.

use crate::ast::{Body, BodyFields, Joint, JointKind, Properties};
use crate::error::{Code, Errors, Reported};
use crate::words;

/// Returns the bodies of the robot, changed by those of the scene with the same name, and then the other bodies.
pub(super) fn merged(robot: Vec<Body>, own: Vec<Body>, errors: &mut Errors) -> Vec<Body> {
    let mut bodies = robot;
    let mut changed = vec![false; bodies.len()];
    for mut body in own {
        match bodies.iter().position(|link| link.name == body.name) {
            // a repeated name is reported later
            Some(n) if n < changed.len() && !changed[n] => {
                changed[n] = true;
                change(&mut bodies[n], body, errors);
            }
            Some(_) => bodies.push(body),
            None => {
                body.unread = body.unread.or(check_new(&body, &bodies[..changed.len()], errors));
                bodies.push(body);
            }
        }
    }
    bodies
}

/// Rejects a new body that seems to mean a link: it has no joint, and almost the name of a link on the same parent, or
/// the name of that link's joint.
fn check_new(body: &Body, links: &[Body], errors: &mut Errors) -> Option<Reported> {
    let (name, Ok(parent), None) = (&body.name, &body.parent, &body.fields.joint) else {
        return None;
    };
    let mut siblings = links
        .iter()
        .filter(|link| link.parent.as_ref().is_ok_and(|carrier| carrier == parent));
    let names: Vec<String> = siblings.clone().map(|link| link.name.to_string()).collect();
    let near = words::advice(&name.to_string(), names.iter().map(String::as_str), &[]).meant;
    let of_joint = siblings.find(|link| link.fields.coordinate.as_ref() == Some(name));
    let (fact, meant) = match (of_joint, near) {
        (Some(link), _) => (
            format!("`{name}` is a joint of the robot, not a link"),
            link.name.to_string(),
        ),
        (None, Some(near)) => (format!("the robot has no link `{name}`"), near.to_owned()),
        (None, None) => return None,
    };
    let help = format_args!(
        "write `body {meant} on {parent} {{ .. }}` to change that link; to add a body, give it a joint: `joint: \
         fixed`"
    );
    Some(errors.at(Code::FileChange, name.span(), fact, help))
}

/// Replaces the parts of a link that `body` gives.
fn change(link: &mut Body, body: Body, errors: &mut Errors) {
    let Body {
        name,
        parent,
        shape,
        fields,
        unread,
    } = body;
    if let (Ok(parent), Ok(carrier)) = (&parent, &link.parent)
        && parent != carrier
    {
        let fact = format_args!("the parent of `{name}` is `{carrier}` in the robot file");
        let help = format_args!(
            "write `body {name} on {carrier} {{ .. }}` to change it, or choose another name for a new body"
        );
        errors.at(Code::FileChange, parent.span(), fact, help);
    }
    link.name = name;
    link.parent = parent;
    link.unread = unread.or(link.unread);
    let mut old = std::mem::take(&mut link.fields);
    if shape.is_some() || fields.properties.solids.is_some() {
        link.shape = shape;
        old.properties = Properties::default();
    }
    forget(&mut old, &fields);
    link.fields = changed(old, fields);
}

/// Removes the fields of a link that no longer apply to its new joint or coordinate.
fn forget(old: &mut BodyFields, new: &BodyFields) {
    if let Some(joint) = &new.joint {
        if joint.is_fixed() || joint.turns_freely() {
            release(old);
        }
        if joint.kind.is_ok() && !joint.turns_freely() {
            old.orientation = None;
        }
        if matches!(&joint.kind, Ok(kind) if !matches!(kind, JointKind::Free)) {
            old.position = None;
        }
    }
    if new.motion.is_some() {
        release(old);
    }
    if new.coordinate.is_some() {
        old.motion = None;
    }
}

/// Removes the fields of a joint with a free coordinate.
fn release(fields: &mut BodyFields) {
    fields.coordinate = None;
    fields.motion = None;
    fields.friction = None;
    fields.dry_friction = None;
    fields.stop = None;
}

/// Returns the fields of a link, each replaced by the new one if there is one.
fn changed(mut old: BodyFields, new: BodyFields) -> BodyFields {
    // the inertia was checked with the mass and the centre of mass of the file
    if let Some(inertia) = &mut old.properties.inertia
        && (new.properties.mass.is_some() || new.properties.com.is_some())
    {
        inertia.judged = false;
    }
    BodyFields {
        properties: Properties {
            mass: new.properties.mass.or(old.properties.mass),
            com: new.properties.com.or(old.properties.com),
            inertia: new.properties.inertia.or(old.properties.inertia),
            solids: new.properties.solids.or(old.properties.solids),
        },
        joint: placed(old.joint, new.joint),
        coordinate: new.coordinate.or(old.coordinate),
        orientation: new.orientation.or(old.orientation),
        position: new.position.or(old.position),
        absolute: new.absolute.or(old.absolute),
        depends: new.depends.or(old.depends),
        near: new.near.or(old.near),
        turned: new.turned.or(old.turned),
        placed: new.placed.or(old.placed),
        motion: new.motion.or(old.motion),
        friction: new.friction.or(old.friction),
        spring: new.spring.or(old.spring),
        torque: new.torque.or(old.torque),
        dry_friction: new.dry_friction.or(old.dry_friction),
        static_friction: new.static_friction.or(old.static_friction),
        stop: new.stop.or(old.stop),
    }
}

/// Returns the joint of a link: a new joint without a place of its own keeps the place of the old one.
fn placed(old: Option<Joint>, new: Option<Joint>) -> Option<Joint> {
    let Some(mut joint) = new else { return old };
    if let Some(old) = old.filter(|_| !joint.is_placed()) {
        (joint.at, joint.rpy) = (old.at, old.rpy);
    }
    Some(joint)
}
