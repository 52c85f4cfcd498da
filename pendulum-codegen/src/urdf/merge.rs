//! Bodies of a scene that change bodies of its robot.

use crate::ast::{Body, BodyFields, Joint, JointKind, Properties};
use crate::error::{Errors, Reported};
use crate::words;

/// The bodies of a scene: those of its robot, changed by those of the same name, and then the others.
pub(super) fn merged(robot: Vec<Body>, own: Vec<Body>, errors: &mut Errors) -> Vec<Body> {
    let mut bodies = robot;
    let mut changed = vec![false; bodies.len()];
    for mut body in own {
        match bodies.iter().position(|link| link.name == body.name) {
            // twice is an error of its own
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

/// Refuses a new body that seems to mean a link: one without a joint, beside the link whose name or whose joint's it
/// almost has.
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
        "write `body {meant} on {parent} {{ .. }}` to change that link; a new body here has a joint: `joint: fixed`"
    );
    Some(errors.at(name.span(), fact, help))
}

/// Replaces what `body` names in a link.
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
        let fact = format_args!("`{name}` hangs on `{carrier}` in the file of the robot");
        let help = format_args!(
            "write `body {name} on {carrier} {{ .. }}` to change it, or choose another name for a new body"
        );
        errors.at(parent.span(), fact, help);
    }
    link.name = name;
    link.parent = parent;
    link.unread = unread.or(link.unread);
    let BodyFields {
        properties,
        joint,
        coordinate,
        orientation,
        position,
        absolute,
        depends,
        near,
        turned,
        placed,
        motion,
        friction,
        spring,
        torque,
        dry_friction,
        static_friction,
        stop,
    } = fields;
    if shape.is_some() || properties.solids.is_some() {
        link.shape = shape;
        link.fields.properties = properties;
    } else {
        let Properties { mass, com, inertia, .. } = properties;
        replace(&mut link.fields.properties.mass, mass);
        replace(&mut link.fields.properties.com, com);
        replace(&mut link.fields.properties.inertia, inertia);
    }
    let old = &mut link.fields;
    if let Some(joint) = &joint {
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
    if let Some(Joint { kind, at, rpy }) = joint {
        let place = old.joint.take();
        let (old_at, old_rpy) = place.map(|place| (place.at, place.rpy)).unwrap_or_default();
        // a joint without a place of its own stays where it is
        let stays = at.is_none() && rpy.is_none();
        let (at, rpy) = if stays { (old_at, old_rpy) } else { (at, rpy) };
        old.joint = Some(Joint { kind, at, rpy });
    }
    if motion.is_some() {
        release(old);
    }
    if coordinate.is_some() {
        old.motion = None;
    }
    replace(&mut old.orientation, orientation);
    replace(&mut old.position, position);
    replace(&mut old.depends, depends);
    replace(&mut old.near, near);
    replace(&mut old.turned, turned);
    replace(&mut old.placed, placed);
    replace(&mut old.coordinate, coordinate);
    replace(&mut old.absolute, absolute);
    replace(&mut old.motion, motion);
    replace(&mut old.friction, friction);
    replace(&mut old.spring, spring);
    replace(&mut old.torque, torque);
    replace(&mut old.dry_friction, dry_friction);
    replace(&mut old.static_friction, static_friction);
    replace(&mut old.stop, stop);
}

/// Forgets what a joint of one coordinate has that moves by itself.
fn release(fields: &mut BodyFields) {
    fields.coordinate = None;
    fields.motion = None;
    fields.friction = None;
    fields.dry_friction = None;
    fields.stop = None;
}

fn replace<T>(old: &mut Option<T>, new: Option<T>) {
    if new.is_some() {
        *old = new;
    }
}
