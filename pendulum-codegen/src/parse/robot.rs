//! Robots from files.

use syn::parse::ParseStream;
use syn::{Ident, LitStr, Token};

use super::token::{end_of, identifier, parentheses};
use crate::ast::Robot;
use crate::error::{Code, at};

/// `urdf("path", words)`
pub(super) fn robot(input: ParseStream) -> syn::Result<Robot> {
    const FORM: &str = "robot: urdf(\"robot.urdf\")";
    let help = format!("write `{FORM}`");
    let word = identifier(input, "`urdf`", FORM)?;
    if word != "urdf" {
        let fact = format_args!("unknown robot format `{word}`");
        return Err(at(Code::UnknownWord, word.span(), fact, help));
    }
    let inner = parentheses(input)?
        .ok_or_else(|| at(Code::Arguments, word.span(), "`urdf` takes the path of a file", &help))?;
    let path: LitStr = inner.parse().map_err(|error| {
        let fact = "expected the path of a URDF file in quotes";
        at(Code::Syntax, error.span(), fact, &help)
    })?;
    let mut robot = Robot {
        path: path.value(),
        span: path.span(),
        limits: false,
        without_dry_friction: false,
        strict: false,
        repair: false,
        repaired: Vec::new(),
        most: Vec::new(),
        unread: None,
    };
    while inner.parse::<Option<Token![,]>>()?.is_some() && !inner.is_empty() {
        let word = identifier(&inner, "`limits`", "robot: urdf(\"robot.urdf\", limits)")?;
        let what: Option<Ident> = inner.parse()?;
        match (word.to_string().as_str(), what) {
            ("limits", None) => robot.limits = true,
            ("strict", None) => robot.strict = true,
            ("repair", None) => robot.repair = true,
            ("without", Some(what)) if what == "dry_friction" => robot.without_dry_friction = true,
            ("without", Some(what)) if what == "limits" => {
                let help = "remove it: limits of joints become stops only with `limits` after the path";
                return Err(at(
                    Code::UnknownWord,
                    what.span(),
                    "limits are ignored by default",
                    help,
                ));
            }
            _ => {
                let help = "known here: `limits` (joint limits become stops), `without dry_friction`, `repair` \
                            (changes inertias that no rigid body has), `strict` (rejects unknown elements)";
                let fact = format_args!("unknown option `{word}`");
                return Err(at(Code::UnknownWord, word.span(), fact, help));
            }
        }
    }
    end_of(&inner)?;
    Ok(robot)
}
