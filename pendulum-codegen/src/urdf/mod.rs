//! Robots from URDF files: a file is translated into bodies in the text of the language, and these are parsed as if
//! they were part of the scene.

mod attribute;
mod declare;
mod inertia;
mod massless;
mod matrix;
mod merge;
mod names;
mod number;
mod read;
mod robot;
mod tree;

use std::collections::BTreeSet;
use std::path::Path;

use proc_macro2::{Group, Span, TokenStream, TokenTree};
use quote::quote;

use crate::ast::{self, Body, BodyFields, MOST_BODIES, Scene};
use crate::error::{Code, Errors, Reported};
use crate::parse;
use declare::Replaced;
use names::identifier;
use robot::{Joint, Robot};

/// Function that returns the text of a file by its name.
pub type Files<'f> = dyn Fn(&str) -> Result<String, Unreadable> + 'f;
/// Reason why a file cannot be read, and a help text.
pub type Unreadable = (String, &'static str);

/// Adds the bodies of the robot to a scene that has one.
pub(crate) fn read(scene: &mut Scene, files: &Files<'_>, errors: &mut Errors) -> Result<(), Reported> {
    let added = add(scene, files, errors);
    if let Some(robot) = &mut scene.items.robot {
        robot.unread = added.err();
    }
    added
}

fn add(scene: &mut Scene, files: &Files<'_>, errors: &mut Errors) -> Result<(), Reported> {
    let Some(robot) = &scene.items.robot else { return Ok(()) };
    let (name, span) = (robot.path.clone(), robot.span);
    let text = files(&name).map_err(|(fact, help)| errors.at(Code::NoFile, span, fact, help))?;
    let (mut found, mut wrong) = read::read(&text, robot.strict);
    if found.links.len() > MOST_BODIES {
        let fact = format_args!(
            "`{name}` has {} links, but at most {MOST_BODIES} are supported",
            found.links.len()
        );
        let help = "merge links that are fixed to each other";
        return Err(errors.at(Code::TooLong, span, fact, help));
    }
    // errors in the declaration count only if the whole file could be read
    let mut ignored = Vec::new();
    let undeclared = if wrong.is_empty() { &mut wrong } else { &mut ignored };
    let replaced = replaced(&scene.items.bodies);
    let (repaired, declared) = translated(&mut found, robot, (&scene.items.bodies, &replaced), undeclared);
    let report = |wrong: read::Wrong| errors.at(wrong.code, span, wrong.fact_in(&name), wrong.help);
    if let Some(reported) = wrong.into_iter().map(report).last() {
        // known coordinates stay declared, so that their uses are not reported too
        let links = declared
            .parse()
            .map_or(Ok(Vec::new()), |tokens| parse::bodies(tokens, &mut Errors::default()));
        let own = std::mem::take(&mut scene.items.bodies);
        scene.items.bodies = merge::merged(links.unwrap_or_default(), own, &mut Errors::default());
        return Err(reported);
    }
    note_left_out(&mut found, robot);
    let tokens: TokenStream = declared.parse().map_err(|error| {
        let fact = format_args!("`{name}` cannot be converted to Rust tokens: {error}");
        errors.at(Code::NotUrdf, span, fact, "check for unusual names and numbers")
    })?;
    errors.read_from(span, &name);
    let mut links = parse::bodies(at(span, tokens), errors)?;
    let inertias = links
        .iter_mut()
        .filter_map(|link| link.fields.properties.inertia.as_mut());
    inertias.for_each(|inertia| inertia.judged = true);
    scene.head.docs.extend(docs(&name, &found, &repaired));
    if let Some(robot) = &mut scene.items.robot {
        robot.repaired = repaired;
        robot.most = declare::most(&found, &replaced);
    }
    let own = std::mem::take(&mut scene.items.bodies);
    scene.items.bodies = merge::merged(links, own, errors);
    Ok(())
}

/// Returns the repairs of a robot, and the declarations of its bodies, for a scene with these bodies and changes.
fn translated(
    found: &mut Robot,
    robot: &ast::Robot,
    (own, replaced): (&[Body], &[Replaced]),
    wrong: &mut Vec<read::Wrong>,
) -> (Vec<String>, String) {
    if !tree::is_tree(found, wrong) {
        return (Vec::new(), String::new());
    }
    let mut repaired = inertia::check(found, replaced, robot.repair, wrong);
    if robot.repair {
        let carriers = carriers(own, found);
        repaired.extend(massless::hold(found, replaced, &carriers));
    }
    let declared = declare::declare(found, robot, replaced, wrong);
    (repaired, declared)
}

/// Returns the bodies of the robot of a declaration, as text in place of the item `robot`: a line for each. `None` if
/// there is no robot, if its file cannot be read, or if the declaration changes its links.
#[must_use]
pub fn robot_bodies(declaration: TokenStream, files: &Files<'_>) -> Option<String> {
    let (scene, _) = parse::parse(declaration);
    let items = scene?.items;
    let robot = items.robot.as_ref()?;
    let (mut found, mut wrong) = read::read(&files(&robot.path).ok()?, robot.strict);
    let is_link = |body: &Body| found.links.iter().any(|link| body.name == identifier(&link.name));
    if items.bodies.iter().any(is_link) {
        return None;
    }
    let (_, declared) = translated(&mut found, robot, (&items.bodies, &[]), &mut wrong);
    wrong.is_empty().then_some(declared)
}

/// Lists limits and friction among the elements that are left out, where the scene does not take them.
fn note_left_out(found: &mut Robot, robot: &ast::Robot) {
    // a stop limits a single coordinate of the state
    let has_stop = |joint: &Joint| robot.limits && !joint.kind.has_many() && joint.mimic.is_none();
    if found
        .joints
        .iter()
        .any(|joint| joint.limits.is_some() && !has_stop(joint))
    {
        found.left_out.insert("limit".to_owned());
    }
    if robot.without_dry_friction && found.joints.iter().any(|joint| joint.friction.is_some()) {
        found.left_out.insert("friction".to_owned());
    }
}

/// Returns the links that carry bodies declared in the scene.
fn carriers(own: &[Body], robot: &Robot) -> BTreeSet<String> {
    let links: BTreeSet<String> = robot.links.iter().map(|link| identifier(&link.name)).collect();
    let new = own.iter().filter(|body| !links.contains(&body.name.to_string()));
    let carriers = new.filter_map(|body| body.parent.as_ref().ok());
    carriers.map(ToString::to_string).collect()
}

/// Returns the changes that a scene makes to links and joints.
fn replaced(own: &[Body]) -> Vec<Replaced> {
    let changes =
        |fields: &BodyFields| fields.joint.is_some() || fields.coordinate.is_some() || fields.motion.is_some();
    let weighs = |body: &Body| {
        let given = &body.fields.properties;
        let weighs = given.mass.is_some() || given.inertia.is_some() || given.com.is_some() || given.solids.is_some();
        weighs || body.shape.is_some()
    };
    let replaced = own.iter().filter(|body| changes(&body.fields) || weighs(body));
    let replaced = replaced.map(|body @ Body { name, fields, .. }| Replaced {
        body: name.to_string(),
        joint: changes(fields),
        moves: fields
            .joint
            .as_ref()
            .map(|joint| !joint.is_fixed() || fields.motion.is_some()),
        placed: fields.joint.as_ref().is_some_and(ast::Joint::is_placed),
        weighs: weighs(body),
        coordinate: fields.coordinate.as_ref().map(ToString::to_string),
        held: fields.motion.is_some()
            || fields
                .joint
                .as_ref()
                .is_some_and(|joint| joint.is_fixed() || joint.turns_freely()),
    });
    replaced.collect()
}

/// Returns the documentation of the robot for the docs of the model.
fn docs(name: &str, robot: &Robot, repaired: &[String]) -> Vec<String> {
    let left: Vec<String> = robot.left_out.iter().map(|element| format!("`{element}`")).collect();
    let left = match &left[..] {
        [] => String::new(),
        _ => format!(" Left out: {}.", left.join(", ")),
    };
    let mut docs = vec![String::new(), format!(" Links and joints from `{name}`.{left}")];
    if !repaired.is_empty() {
        docs.push(String::new());
        docs.push(" Repaired, as no body can have or move what the file gives:".to_owned());
        docs.push(String::new());
        docs.extend(repaired.iter().map(|change| format!(" * {change}")));
    }
    docs
}

/// Sets the span of all tokens.
fn at(span: Span, tokens: TokenStream) -> TokenStream {
    let placed = |token| match token {
        TokenTree::Group(group) => {
            let mut group = Group::new(group.delimiter(), at(span, group.stream()));
            group.set_span(span);
            TokenTree::Group(group)
        }
        mut token => {
            token.set_span(span);
            token
        }
    };
    tokens.into_iter().map(placed).collect()
}

/// Returns an item that makes cargo rebuild when the file of a robot changes. It refers to the folder of the manifest
/// by a compile-time variable, so that it is the same on every machine.
pub(crate) fn tracked(name: &str) -> TokenStream {
    let path = match Path::new(name).is_absolute() {
        true => quote!(#name),
        false => quote!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), "/", #name)),
    };
    quote!(
        const _: &[u8] = ::core::include_bytes!(#path);
    )
}
