//! Ball and free joints: required and unsupported fields.

use std::borrow::Cow;

use proc_macro2::{Ident, TokenStream};

use super::Lower;
use crate::ast::{self, JointKind};
use crate::error::{Code, Reported};
use crate::parse::HINGES;

/// Name of the orientation field, and help if it is missing.
pub(super) const ORIENTATION: [&str; 2] = ["orientation", "add `orientation: o`, a name for its unit quaternion"];
/// Name of the position field, and help if it is missing.
const POSITION: [&str; 2] = ["position", "add `position: p`, a name for the position of its frame"];

/// `Some(false)` for a ball joint, `Some(true)` for a free joint, which slides as well, and none for any other joint.
pub(super) fn freedom(body: &ast::Body) -> Option<bool> {
    match body.fields.joint.as_ref()?.kind {
        Ok(JointKind::Ball) => Some(false),
        Ok(JointKind::Free) => Some(true),
        _ => None,
    }
}

impl<'g> Lower<'g> {
    /// Rejects names of orientations and positions on joints that have none.
    pub(super) fn require_no_freedom(&mut self, body: &ast::Body) -> Result<(), Reported> {
        let names = [
            (
                &body.fields.orientation,
                "neither `ball` nor `free`, so it has no orientation",
            ),
            (&body.fields.position, "not `free`, so it has no position"),
        ];
        let given = names.into_iter().find_map(|(name, what)| Some((name.as_ref()?, what)));
        let Some((name, what)) = given else { return Ok(()) };
        match (&body.fields.joint, body.unread) {
            (Some(joint), _) if joint.kind.is_err() => return Ok(()),
            // the joint may be the field that could not be parsed
            (None, Some(reported)) => return Err(reported),
            _ => {}
        }
        let fact = format_args!("the joint of `{}` is {what}", body.name);
        let help =
            "`joint: ball` has an `orientation`, `joint: free` also a `position`, and other joints a `coordinate`";
        Err(self.errors.at(Code::JointCoordinate, name.span(), fact, help))
    }

    /// Checks that a ball or free joint has its required fields, and rejects unsupported ones.
    pub(super) fn check_freedom(&mut self, body: &ast::Body, slides: bool) -> Result<(), Reported> {
        let named = self.check_orientation(body);
        let placed = self.check_position(body, slides);
        let kind = if slides { "free" } else { "ball" };
        let mut fits = named.and(placed);
        for (tokens, what, help) in senseless(body, slides) {
            if let Some(tokens) = tokens {
                let fact = format_args!("the {kind} joint of `{}` {what}", body.name);
                fits = fits.and(Err(self.errors.on(Code::FreeRotation, tokens, fact, help)));
            }
        }
        fits
    }

    /// Reports the coordinate of a ball or free joint, which has none.
    pub(super) fn refuse_coordinate(&mut self, body: &ast::Body, slides: bool, coordinate: &Ident) -> Reported {
        let (fields, name) = (&body.fields, &body.name);
        let kind = if slides { "free" } else { "ball" };
        let joint = format!("the {kind} joint of `{name}` has an orientation");
        if let Some(depends) = &fields.depends {
            let fact = format_args!("{joint}, which cannot be marked `depends`");
            return self.errors.at(Code::FreeRotation, depends.span(), fact, HINGES);
        }
        let help = match (&fields.orientation, slides) {
            (Some(_), _) => "leave out `coordinate`",
            (None, true) => "write `orientation: o, position: p`; components are `o.w` and `p.x`",
            (None, false) => "write `orientation: o`; its components are `o.w`, `o.x`, `o.y` and `o.z`",
        };
        let fact = format_args!("{joint}, not a coordinate");
        self.errors.at(Code::FreeRotation, coordinate.span(), fact, help)
    }

    fn check_orientation(&mut self, body: &ast::Body) -> Result<(), Reported> {
        let fields = &body.fields;
        if let Some(coordinate) = &fields.coordinate {
            return self
                .broken
                .get(&coordinate.to_string())
                .map_or(Ok(()), |reported| Err(*reported));
        }
        if fields.orientation.is_none() && fields.motion.is_none() {
            return Err(self.missing(body, ORIENTATION));
        }
        Ok(())
    }

    fn check_position(&mut self, body: &ast::Body, slides: bool) -> Result<(), Reported> {
        let fields = &body.fields;
        match &fields.position {
            Some(position) if !slides => {
                let fact = format_args!(
                    "the ball joint of `{}` does not translate, so it has no position",
                    body.name
                );
                let help = "remove it, or make the joint `free`";
                Err(self.errors.at(Code::JointCoordinate, position.span(), fact, help))
            }
            None if slides && fields.coordinate.is_none() && fields.motion.is_none() => {
                Err(self.missing(body, POSITION))
            }
            _ => Ok(()),
        }
    }

    /// Reports a missing field, unless it may be one that could not be parsed.
    pub(super) fn missing(&mut self, body: &ast::Body, [what, help]: [&str; 2]) -> Reported {
        body.unread.unwrap_or_else(|| {
            let fact = format_args!("missing `{what}` for the joint of `{}`", body.name);
            self.errors.at(Code::JointCoordinate, body.name.span(), fact, help)
        })
    }
}

/// Unsupported fields of a ball or free joint: tokens, fact and help of each.
fn senseless(body: &ast::Body, slides: bool) -> [(Option<&TokenStream>, &'static str, Cow<'static, str>); 7] {
    fn tokens(e: &Option<ast::Expr>) -> Option<&TokenStream> {
        e.as_ref().map(|e| &e.tokens)
    }
    let (fields, name) = (&body.fields, &body.name);
    let orientation = fields.orientation.as_ref().map_or("o".to_owned(), ToString::to_string);
    let moment = format!(
        "write `dissipation: -m*dot({orientation}).x,` for a moment `m` about the x axis of the body, or `force on \
         tip: [fx, fy, fz] in {name},` for a force on a point, in the body frame"
    );
    [
        (
            tokens(&fields.motion),
            "cannot follow a motion",
            "drive a chain of joints with one coordinate each".into(),
        ),
        (
            fields.spring.as_ref().map(|(stiffness, _)| &stiffness.tokens),
            "cannot have a spring",
            "write `spring between a and b: (k, l),` between points, or a `potential`".into(),
        ),
        (tokens(&fields.torque), "cannot have a scalar torque", moment.into()),
        (
            tokens(&fields.friction).filter(|_| slides),
            "cannot have friction",
            "write drag as `force on point: ..`".into(),
        ),
        (
            tokens(&fields.dry_friction),
            "cannot have dry friction",
            "use viscous friction, `friction: e`".into(),
        ),
        (
            tokens(&fields.static_friction),
            "cannot have dry friction",
            "use viscous friction, `friction: e`".into(),
        ),
        (
            fields.stop.as_ref().map(|stop| &stop.tokens),
            "cannot have a stop",
            "use a `potential` that rises steeply at the limit".into(),
        ),
    ]
}
