//! Errors of loops that do not close, with help.

use proc_macro2::{Ident, Span};

use super::Lower;
use crate::ast::{self, JointKind, Read};
use crate::error::{Code, Reported};
use crate::loops::{Cause, NoPlane};
use crate::parse::HINGES;

impl<'g> Lower<'g> {
    /// Checks that the number of dependent coordinates is `needed`.
    pub(super) fn count(&mut self, items: &ast::Items, needed: usize, at: Span) -> Result<(), Reported> {
        let words = items.bodies.iter().filter_map(|body| body.fields.depends.as_ref());
        let words: Vec<&Ident> = words.collect();
        let given = words.len();
        if let Some(word) = words.get(needed) {
            let many = if needed == 0 {
                "none".to_owned()
            } else {
                needed.to_string()
            };
            let fact = format!("{}, but closed loops determine {many}", depend(given));
            let help = "remove `depends` from an independent coordinate, or close another loop: `close a at [..] to \
                        b at [..]: revolute(z)`";
            return Err(self.errors.at(Code::LoopCount, word.span(), fact, help));
        }
        if given == needed {
            return Ok(());
        }
        let many = if needed == 1 { "coordinate" } else { "coordinates" };
        let fact = match given {
            0 => format!("closed loops determine {needed} {many}, but none is marked `depends`"),
            _ => format!("closed loops determine {needed} {many}, but only {}", depend(given)),
        };
        // orientations cannot depend, so other joints are missing
        let coordinates = items.bodies.iter().filter(|body| body.fields.coordinate.is_some());
        let in_loops: Vec<&ast::Body> = items
            .closures
            .iter()
            .flat_map(|closure| between(closure, &items.bodies))
            .collect();
        let help = if coordinates.count() < needed && has_orientation(&in_loops) {
            HINGES.to_owned()
        } else {
            let independent = in_loops.iter().rev().filter(|body| body.fields.depends.is_none());
            format!(
                "a planar loop determines two, and a spatial one up to six: write `coordinate: {} depends near \
                 0.3`, where the number is a guess that selects the assembly",
                first_coordinate(independent).map_or("phi".to_owned(), Ident::to_string)
            )
        };
        Err(self.errors.at(Code::LoopCount, at, fact, help))
    }

    /// Reports why a loop does not close.
    pub(super) fn open(
        &mut self,
        items: &ast::Items,
        number: usize,
        cause: &Cause,
        no_plane: Option<&NoPlane>,
        at: Span,
    ) -> Reported {
        if let Cause::Determines(needed) = *cause
            && let Err(reported) = self.count(items, needed, at)
        {
            return reported;
        }
        let closure = &items.closures[number];
        let [a, b] = closure.ends.each_ref().map(|end| &end.body);
        let fact = format_args!("the loop from `{a}` to `{b}` {}", cause.fact());
        let help = cause.help(&closure.joint, &between(closure, &items.bodies), no_plane);
        self.errors.at(cause.code(), at, fact, help)
    }
}

/// Bodies between the ends of a loop, from each end to the body that carries both.
fn between<'a>(closure: &ast::Closure, bodies: &'a [ast::Body]) -> Vec<&'a ast::Body> {
    let [first, second] = closure.ends.each_ref().map(|end| {
        let named = |name: &Ident| bodies.iter().position(|body| body.name == *name);
        let carrier = |n: &usize| bodies[*n].parent.as_ref().ok().and_then(named);
        // `take` ends the chain if bodies carry one another in a circle
        let chain = std::iter::successors(named(&end.body), carrier).take(bodies.len());
        chain.collect::<Vec<usize>>()
    });
    let own = first.iter().filter(|n| !second.contains(n));
    let between = own.chain(second.iter().filter(|n| !first.contains(n)));
    between.map(|n| &bodies[*n]).collect()
}

/// Orientation of a body, if it has no guess.
fn unguessed<'a>(body: &&'a ast::Body) -> Option<&'a Ident> {
    body.fields
        .orientation
        .as_ref()
        .filter(|_| body.fields.turned.is_none())
}

/// True if any of the bodies has an orientation, which cannot depend.
fn has_orientation(bodies: &[&ast::Body]) -> bool {
    bodies.iter().any(|body| body.fields.orientation.is_some())
}

fn first_coordinate<'a>(bodies: impl IntoIterator<Item = &'a &'a ast::Body>) -> Option<&'a Ident> {
    bodies.into_iter().find_map(|body| body.fields.coordinate.as_ref())
}

/// Help on how to choose the assembly of a loop: by a coordinate of the state, if it has one.
fn assembled(bodies: &[&ast::Body]) -> String {
    let moves_by_itself = |body: &&&ast::Body| body.fields.depends.is_none() && body.fields.coordinate.is_some();
    let Some(body) = bodies.iter().find(moves_by_itself) else {
        return dependent(bodies);
    };
    let name = first_coordinate([body]).map_or(String::new(), Ident::to_string);
    if body.fields.near.is_some() {
        format!("another number after `near` of `{name}`")
    } else {
        format!("`coordinate: {name} near 0.5`")
    }
}

/// Help on how to declare a dependent coordinate of a loop.
fn dependent(bodies: &[&ast::Body]) -> String {
    let depends = bodies.iter().filter(|body| body.fields.depends.is_some());
    let name = first_coordinate(depends).or_else(|| first_coordinate(bodies));
    let name = name.map_or("phi".to_owned(), Ident::to_string);
    format!("`coordinate: {name} depends near 0.3`")
}

/// Help on the number of coordinates that a loop-closing joint determines, in a plane and in space.
fn counted(joint: &str, [in_plane, in_space]: [&str; 2], assembled: &str) -> String {
    format!(
        "`{joint}` determines {in_plane} coordinates of a planar loop, and {in_space} of a spatial one: mark as \
         many `depends`, and change the guess if needed: {assembled}"
    )
}

/// Number of dependent coordinates, in words.
fn depend(count: usize) -> String {
    match count {
        1 => "1 coordinate is marked `depends`".to_owned(),
        _ => format!("{count} coordinates are marked `depends`"),
    }
}

/// Formats a positive number to three digits, with an exponent in place of many zeros.
fn readable(number: f64) -> String {
    let rounded = format!("{number:.2e}");
    let exponent = rounded.split_once('e').and_then(|(_, exponent)| exponent.parse().ok());
    match exponent {
        Some(exponent @ -4..=5) => format!("{number:.*}", usize::try_from(2 - exponent).unwrap_or(0)),
        _ => rounded,
    }
}

impl Cause {
    fn code(&self) -> Code {
        match self {
            Self::TooShort { .. } | Self::AlwaysOpen { .. } | Self::ClosedByChance | Self::NotAssembled { .. } => {
                Code::OpenLoop
            }
            Self::Undecided | Self::Turned { .. } => Code::AmbiguousLoop,
            Self::AtToggle => Code::SingularLoop,
            Self::Determines(_) | Self::DeterminesOthers => Code::LoopCount,
        }
    }

    /// Predicate of the sentence that has the loop as its subject.
    fn fact(&self) -> String {
        match *self {
            Self::TooShort { by } => format!(
                "cannot close: its sides miss each other by {} m at the guess",
                readable(by)
            ),
            Self::AtToggle => "is singular at the guess (a toggle position)".to_owned(),
            Self::Undecided => "has two assemblies, equally near to the guess".to_owned(),
            Self::AlwaysOpen { by, unit } => format!(
                "cannot close: its ends are {} {unit} apart in every position",
                readable(by)
            ),
            Self::ClosedByChance => "closes only for the default values of the parameters".to_owned(),
            Self::NotAssembled { by, unit } => format!(
                "cannot be assembled near the guess: its ends stay {} {unit} apart",
                readable(by)
            ),
            Self::Turned { by } => format!(
                "closes near the guess, but with an angle of {} rad between its ends",
                readable(by)
            ),
            Self::Determines(_) | Self::DeterminesOthers => {
                "does not determine the coordinates marked `depends`".to_owned()
            }
        }
    }

    /// Help for a loop of these bodies that `joint` does not close.
    fn help(&self, joint: &Read<JointKind>, bodies: &[&ast::Body], no_plane: Option<&NoPlane>) -> String {
        let dependent = dependent(bodies);
        match self {
            Self::TooShort { .. } | Self::AlwaysOpen { .. } | Self::NotAssembled { .. } => match no_plane {
                Some(no_plane) => no_plane.help(joint, bodies),
                None => format!(
                    "check lengths and positions, or change the guess: {}",
                    assembled(bodies)
                ),
            },
            Self::AtToggle => format!(
                "it does not determine the dependent coordinates there; change the guess: {}",
                assembled(bodies)
            ),
            Self::Undecided => format!("select one by a guess for each coordinate of the loop: {dependent}"),
            Self::ClosedByChance => "use the same parameter for lengths or angles that must be equal for the loop \
                                     to close"
                .to_owned(),
            Self::Turned { .. } if matches!(joint, Ok(JointKind::Revolute(_))) => format!(
                "give a guess where its axes have the same direction: {dependent}, or turn one end over with `rpy \
                 [..]` after its position"
            ),
            Self::Turned { .. } => format!("give a guess where the two frames coincide: {dependent}"),
            Self::Determines(_) | Self::DeterminesOthers => format!(
                "mark coordinates of joints in the loop `depends`, with a guess away from its toggle: {dependent}"
            ),
        }
    }
}

impl NoPlane {
    /// Help for a loop in space that does not close and may be intended as planar.
    fn help(&self, joint: &Read<JointKind>, bodies: &[&ast::Body]) -> String {
        let assembled = assembled(bodies);
        match (self, joint) {
            _ if has_orientation(bodies) => match bodies.iter().find_map(unguessed) {
                Some(name) => format!(
                    "`{name}` has no guess: give one, `orientation: {name} near [roll, pitch, yaw]` in rad. Or, if \
                     the loop determines it, {HINGES}"
                ),
                None => HINGES.to_owned(),
            },
            (Self::Axes, _) => "check lengths, positions, axes and the guesses of all coordinates of the loop; if \
                                these are right, mark more of them `depends`"
                .to_owned(),
            (Self::Joint, Ok(JointKind::Fixed)) => counted("fixed", ["three", "six"], &assembled),
            (Self::Joint, Ok(JointKind::Prismatic(_))) => counted("prismatic", ["two", "five"], &assembled),
            (Self::Joint, _) => format!(
                "give the joint that closes the loop the axis of the other joints, or change the guess: {assembled}"
            ),
            (Self::Apart, _) => "check positions along the joint axes, and sliding directions: the ends do not lie \
                                 in one plane"
                .to_owned(),
        }
    }
}
