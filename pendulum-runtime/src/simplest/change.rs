//! Changes that make a declaration simpler.

use std::fmt;
use std::ops::Range;

use super::outline::{Outline, Part};

/// Fields of a body that act along its joint, which a fixed joint cannot have.
const ALONG: [&str; 6] = [
    "friction",
    "spring",
    "torque",
    "dry_friction",
    "static_friction",
    "stop",
];

/// A change of a declaration, by the names in it, so that several can follow each other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Change {
    /// Leaves out fields of a body.
    WithoutField { body: String, kind: Force },
    /// Leaves out an item: a damper between points, or a dissipation.
    WithoutItem { word: String, rest: String, value: String },
    /// Fixes a joint at the start.
    Fixed { body: String },
    /// Fixes a joint where its spring is at rest.
    Rigid { body: String },
}

/// Friction of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Force {
    Viscous,
    Dry,
}

impl Force {
    const fn fields(self) -> &'static [&'static str] {
        match self {
            Self::Viscous => &["friction"],
            Self::Dry => &["dry_friction", "static_friction"],
        }
    }
}

/// A coordinate that no longer is one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Lost {
    pub(super) coordinate: String,
    /// Parameter with its value relative to the parent, if it is fixed at the start.
    pub(super) parameter: Option<String>,
    /// Coordinate of the parent, if it is measured from ground.
    pub(super) from: Option<String>,
}

impl Change {
    /// All changes that could be made to a declaration.
    pub(super) fn all(outline: &Outline) -> Vec<Self> {
        let mut changes = Vec::new();
        for body in outline.of("body") {
            let name = || body.name().to_owned();
            for kind in [Force::Viscous, Force::Dry] {
                if body.field(kind.fields()[0]).is_some() {
                    changes.push(Self::WithoutField { body: name(), kind });
                }
            }
            if body.field("coordinate").is_some() {
                changes.push(Self::Fixed { body: name() });
                if body.field("spring").is_some() {
                    changes.push(Self::Rigid { body: name() });
                }
            }
        }
        let dampers = outline.of("damper").chain(outline.of("dissipation"));
        changes.extend(dampers.map(|item| Self::WithoutItem {
            word: item.word.clone(),
            rest: item.rest.clone(),
            value: outline.at(&item.value).to_owned(),
        }));
        changes
    }

    /// True if this change leaves nothing of what another one changes.
    pub(super) fn covers(&self, other: &Self) -> bool {
        let joint = |change: &Self| match change {
            Self::Fixed { body } | Self::Rigid { body } => Some(body.clone()),
            _ => None,
        };
        let of = match other {
            Self::WithoutField { body, .. } => Some(body.clone()),
            _ => joint(other),
        };
        joint(self).is_some_and(|body| of == Some(body))
    }

    /// The text with the change, and the coordinate that is lost; or why it cannot be made. The parameter at
    /// which a joint is fixed has this value.
    pub(super) fn make(
        &self,
        outline: &Outline,
        start: impl Fn(&Lost) -> f64,
    ) -> Result<(String, Option<Lost>), String> {
        match self {
            Self::WithoutField { body, kind } => {
                let body = outline.body(body).ok_or("it has no body of this name")?;
                let fields = kind.fields().iter().filter_map(|word| body.field(word));
                Ok((outline.with(fields.map(|field| outline.without(field)).collect()), None))
            }
            Self::WithoutItem { word, rest, value } => {
                let is_it = |item: &&Part| item.rest == *rest && outline.at(&item.value) == value;
                let item = outline.of(word).find(is_it).ok_or("it has no such item")?;
                Ok((outline.with(vec![outline.without(item)]), None))
            }
            Self::Fixed { body } => fix(outline, body, None, start),
            Self::Rigid { body } => {
                let spring = outline
                    .body(body)
                    .and_then(|body| body.field("spring"))
                    .ok_or("it has no spring")?;
                let law = outline.at(&spring.value);
                let rest = rest_of(law).ok_or("its spring has no position at rest")?;
                fix(outline, body, Some(rest), start)
            }
        }
    }
}

/// Second of two expressions in parentheses.
fn rest_of(law: &str) -> Option<&str> {
    let inside = law.trim().strip_prefix('(')?.strip_suffix(')')?;
    let mut depth = 0;
    let comma = inside.char_indices().find(|(_, c)| {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            _ => {}
        }
        *c == ',' && depth == 0
    })?;
    Some(inside[comma.0 + 1..].trim().trim_end_matches(','))
}

/// Fixes the joint of a body where its spring is at rest, or else at a parameter.
fn fix(
    outline: &Outline,
    body: &str,
    rest: Option<&str>,
    start: impl Fn(&Lost) -> f64,
) -> Result<(String, Option<Lost>), String> {
    let body = outline.body(body).ok_or("it has no body of this name")?;
    let field = body.field("coordinate").ok_or("it has no coordinate")?;
    let words = outline.at(&field.value);
    let coordinate = first_word(words).to_owned();
    if words.contains(" depends") {
        return Err("the loops determine it".to_owned());
    }
    let slides = axis(outline, body).is_some_and(|axis| axis.starts_with("prismatic"));
    let from = match words.ends_with("absolute") {
        true => measured_from(outline, body)?,
        false => None,
    };
    // where it is measured from ground, the name stands for a sum
    let parameter = match &from {
        Some(_) => format!("{coordinate}_fixed"),
        None => coordinate.clone(),
    };
    let lost = Lost {
        coordinate: coordinate.clone(),
        parameter: rest.is_none().then(|| parameter.clone()),
        from,
    };
    let mut edits: Vec<(Range<usize>, String)> = Vec::new();
    let mut new = String::new();
    match rest {
        Some(rest) => new += &format!("    let {parameter} = {rest},\n"),
        None => {
            let unit = match (outline.is_without_units(), slides) {
                (true, _) => "",
                (false, true) => ": m",
                (false, false) => ": rad",
            };
            let own = format!("{parameter}{unit} = {:?}", start(&lost));
            match outline.of("params").next() {
                Some(params) => edits.push((params.value.start..params.value.start, format!(" {own},"))),
                None => new += &format!("    params {{ {own} }}\n"),
            }
        }
    }
    let rate = match &lost.from {
        Some(from) => {
            new += &format!("    let {coordinate} = {from} + {parameter},\n");
            format!("dot({from})")
        }
        // a zero with a unit of which no name can be that of a parameter
        None if outline.is_without_units() => "0".to_owned(),
        None => (if slides { "(0 km/h)" } else { "(0 rpm)" }).to_owned(),
    };
    if !new.is_empty() {
        edits.push((outline.begin..outline.begin, format!("\n{}", new.trim_end())));
    }
    edits.extend(outline.rates_of(&coordinate).map(|place| (place, rate.clone())));
    edits.push((field.place.clone(), format!("motion: {parameter},")));
    let forces = ALONG.iter().filter_map(|word| body.field(word));
    let along = outline.of("force").filter(|force| force.rest == coordinate);
    edits.extend(forces.chain(along).map(|part| outline.without(part)));
    Ok((outline.with(edits), Some(lost)))
}

/// The coordinate from which one that is measured from ground differs by the angle of its joint; none on the ground.
fn measured_from(outline: &Outline, body: &Part) -> Result<Option<String>, String> {
    let parent = parent_of(body);
    if parent == "ground" {
        return Ok(None);
    }
    let known = outline.body(parent).and_then(|parent| {
        let coordinate = outline.at(&parent.field("coordinate")?.value);
        let from_ground = coordinate.ends_with("absolute") || parent_of(parent) == "ground";
        (from_ground && axis(outline, parent)? == axis(outline, body)?).then(|| first_word(coordinate).to_owned())
    });
    let unknown = || "its angle is measured from ground, and that of its parent is not".to_owned();
    known.map(Some).ok_or_else(unknown)
}

/// Name of the body that carries a body.
fn parent_of(body: &Part) -> &str {
    body.rest.split(' ').nth(2).unwrap_or_default()
}

/// Kind and axis of a joint: `revolute(z`.
fn axis<'o>(outline: &'o Outline, body: &Part) -> Option<&'o str> {
    outline.at(&body.field("joint")?.value).split(')').next()
}

fn first_word(text: &str) -> &str {
    text.split_whitespace().next().unwrap_or_default()
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::WithoutField {
                body,
                kind: Force::Viscous,
            } => write!(f, "without the friction of `{body}`"),
            Self::WithoutField { body, kind: Force::Dry } => write!(f, "without the dry friction of `{body}`"),
            Self::WithoutItem { word, rest, .. } if rest.is_empty() => write!(f, "without the {word}"),
            Self::WithoutItem { word, rest, .. } => write!(f, "without the {word} {rest}"),
            Self::Fixed { body } => write!(f, "with the joint of `{body}` fixed"),
            Self::Rigid { body } => write!(f, "with a rigid spring of `{body}`"),
        }
    }
}
