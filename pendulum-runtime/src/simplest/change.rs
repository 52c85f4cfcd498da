//! Changes that make a declaration simpler.

use super::outline::{ALONG, Edit, Outline, Part};
use std::cmp::Reverse;
use std::fmt;

/// A change of a declaration, by the names in it, so that several can follow each other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Change {
    /// Leaves out fields of a body.
    WithoutField { body: String, kind: Friction },
    /// Leaves out an item: a damper between points, or a dissipation, by its number among those of the word.
    WithoutItem {
        word: &'static str,
        number: usize,
        shown: String,
    },
    /// Fixes a joint at the start.
    Fixed { body: String },
    /// Fixes a joint where its spring is at rest.
    Rigid { body: String },
}

/// Friction of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Friction {
    Viscous,
    Dry,
}

impl Friction {
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
    /// All changes that could be made to a declaration. The bodies of a robot whose file is not written out stay as
    /// they are: a field that is left out would be that of the file.
    pub(super) fn all(outline: &Outline) -> Vec<Self> {
        let mut changes = Vec::new();
        let has_robot = outline.of("robot").next().is_some();
        for body in outline.of("body").filter(|_| !has_robot) {
            let name = || body.name().to_owned();
            for kind in [Friction::Viscous, Friction::Dry] {
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
        for word in ["damper", "dissipation"] {
            changes.extend(outline.of(word).enumerate().map(|(number, item)| Self::WithoutItem {
                word,
                number,
                shown: match word {
                    "damper" => item.rest(),
                    _ => format!("`{}`", outline.value(item)),
                },
            }));
        }
        changes
    }

    /// Order in which changes are made: items keep their numbers until joints are fixed, and a joint is fixed before
    /// the one that carries it, from which its angle may be measured.
    pub(super) fn order(&self, outline: &Outline) -> (usize, Reverse<usize>) {
        let of = |name: &str| outline.of("body").position(|body| body.name() == name).unwrap_or(0);
        match self {
            Self::WithoutItem { number, .. } => (0, Reverse(*number)),
            Self::WithoutField { .. } => (1, Reverse(0)),
            Self::Fixed { body } | Self::Rigid { body } => (2, Reverse(of(body))),
        }
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
            Self::WithoutItem { word, number, .. } => {
                let item = outline.of(word).nth(*number).ok_or("it has no such item")?;
                Ok((outline.with(vec![outline.without(item)]), None))
            }
            Self::Fixed { body } => fix(outline, body, None, start),
            Self::Rigid { body } => {
                let spring = outline.body(body).and_then(|body| body.field("spring"));
                let rest = spring.and_then(|spring| spring.fields.get(1));
                fix(
                    outline,
                    body,
                    Some(rest.ok_or("its spring has no position at rest")?),
                    start,
                )
            }
        }
    }
}

/// Fixes the joint of a body where its spring is at rest, or else at a parameter.
fn fix(
    outline: &Outline,
    body: &str,
    rest: Option<&Part>,
    start: impl Fn(&Lost) -> f64,
) -> Result<(String, Option<Lost>), String> {
    let body = outline.body(body).ok_or("it has no body of this name")?;
    let field = body.field("coordinate").ok_or("it has no coordinate")?;
    let coordinate = field.value.first().map(|(name, _)| name.clone()).unwrap_or_default();
    if field.has("depends") {
        return Err("the loops determine it".to_owned());
    }
    let slides = body.field("joint").is_some_and(|joint| joint.has("prismatic"));
    let from = match field.has("absolute") {
        true => measured_from(outline, body)?,
        false => None,
    };
    // where it is measured from ground, the name stands for a sum
    let parameter = match &from {
        Some(_) => outline.fresh(format!("{coordinate}_fixed")),
        None => coordinate.clone(),
    };
    let lost = Lost {
        coordinate: coordinate.clone(),
        parameter: rest.is_none().then(|| parameter.clone()),
        from,
    };
    let mut edits: Vec<Edit> = Vec::new();
    let mut new = String::new();
    match rest {
        Some(rest) => {
            let rest = &outline.text[rest.own.clone()];
            // a bare number would take any unit where the name is used
            let is_number = rest.trim_start_matches('-').parse::<f64>().is_ok();
            let unit = if is_number && !slides && !outline.is_without_units() {
                " rad"
            } else {
                ""
            };
            new += &format!("let {parameter} = {rest}{unit},\n    ");
        }
        None => {
            // in rad, an angle of more than a turn is accepted
            let (unit, of_value) = match (outline.is_without_units(), slides) {
                (true, _) => ("", ""),
                (false, true) => (": m", ""),
                (false, false) => (": rad", " rad"),
            };
            let own = format!("{parameter}{unit} = {:?}{of_value}", start(&lost));
            match outline.of("params").next() {
                Some(params) => edits.push((params.inside.start..params.inside.start, format!(" {own},"))),
                None => edits.push((outline.begin..outline.begin, format!("\n    params {{ {own} }}"))),
            }
        }
    }
    let rate = match &lost.from {
        Some(from) => {
            new += &format!("let {coordinate} = {from} + {parameter},\n    ");
            format!("dot({from})")
        }
        // a zero with a unit, whose names no parameter can have
        None if outline.is_without_units() => "0".to_owned(),
        None => (if slides { "(0 km/h)" } else { "(0 rpm)" }).to_owned(),
    };
    if !new.is_empty() {
        // a `let` stands before its uses
        let uses = outline.of("let").find(|item| outline.is_used_in(&coordinate, item));
        let before = uses.map_or(body.place.start, |item| item.place.start.min(body.place.start));
        edits.push((before..before, new));
    }
    edits.extend(outline.rates_of(&coordinate).map(|place| (place, rate.clone())));
    edits.push((field.place.clone(), format!("motion: {parameter},")));
    let forces = ALONG.iter().filter_map(|word| body.field(word));
    edits.extend(forces.map(|part| outline.without(part)));
    for force in outline.of("force").filter(|force| force.rest() == coordinate) {
        edits.push(match &lost.from {
            // a moment from ground acts on what carries the body
            Some(from) => (force.head[0].1.clone(), from.clone()),
            None => outline.without(force),
        });
    }
    Ok((outline.with(edits), Some(lost)))
}

/// The coordinate from which one that is measured from ground differs by the angle of its joint; none on the ground.
fn measured_from(outline: &Outline, body: &Part) -> Result<Option<String>, String> {
    let parent = parent_of(body);
    if parent == "ground" {
        return Ok(None);
    }
    let joint = |body: &Part| -> Option<Vec<String>> {
        let joint = body.field("joint")?.value.iter().map(|(word, _)| word.clone());
        Some(joint.take(2).collect())
    };
    let is_turned = body.field("joint").is_some_and(|joint| joint.has("rpy"));
    let known = outline.body(parent).and_then(|parent| {
        let coordinate = parent.field("coordinate")?;
        let from_ground = coordinate.has("absolute") || parent_of(parent) == "ground";
        let is_same = !is_turned && joint(parent)? == joint(body)?;
        (from_ground && is_same).then(|| coordinate.value[0].0.clone())
    });
    let unknown = || "its angle is measured from ground, and its parent has no such angle about this axis".to_owned();
    known.map(Some).ok_or_else(unknown)
}

/// Name of the body that carries a body.
fn parent_of(body: &Part) -> &str {
    body.head.get(2).map_or("", |(parent, _)| parent)
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::WithoutField {
                body,
                kind: Friction::Viscous,
            } => write!(f, "without the friction of `{body}`"),
            Self::WithoutField {
                body,
                kind: Friction::Dry,
            } => write!(f, "without the dry friction of `{body}`"),
            Self::WithoutItem { word, shown, .. } => write!(f, "without the {word} {shown}"),
            Self::Fixed { body } => write!(f, "with the joint of `{body}` fixed"),
            Self::Rigid { body } => write!(f, "with a rigid spring of `{body}`"),
        }
    }
}
