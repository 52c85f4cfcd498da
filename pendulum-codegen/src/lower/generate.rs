//! The `generate` list: names of the routines to generate.

use std::collections::BTreeSet;

use super::Lower;
use crate::ast::Items;
use crate::error::Code;
use crate::program;
use crate::words;

/// Features of a scene that some routines require or exclude.
#[derive(Clone, Copy, Debug)]
pub(super) struct Has {
    pub(super) parameters: bool,
    pub(super) inputs: bool,
    pub(super) drives: bool,
    pub(super) loops: bool,
    pub(super) orientations: bool,
    /// Coordinates, or joints that have them.
    pub(super) coordinates: bool,
    pub(super) states: bool,
}

impl Lower<'_> {
    /// Routines to generate, by default if the list is omitted.
    pub(super) fn generate(&mut self, items: &Items, has: Has) -> BTreeSet<&'static str> {
        let Some((word, list)) = &items.generate else {
            let mut words: BTreeSet<&'static str> = ["rhs", "jacobian"].into();
            words.extend(has.coordinates.then_some("energy"));
            return words;
        };
        if list.is_empty() && items.outputs.is_empty() && items.events.is_empty() {
            let help = "write `generate: [rhs, jacobian, energy]`, or leave it out";
            self.errors
                .at(Code::NotGenerated, word.span(), "nothing is generated", help);
        }
        let words = program::words();
        let mut outputs = BTreeSet::new();
        for ident in list {
            let name = ident.to_string();
            let Some(&word) = words.iter().find(|word| **word == name) else {
                let fact = format_args!("`{name}` cannot be generated");
                self.errors
                    .unknown(Code::UnknownWord, ident, fact, words.iter().copied(), words::ROUTINES);
                continue;
            };
            if !outputs.insert(word) {
                self.errors.at(
                    Code::GivenTwice,
                    ident.span(),
                    format_args!("`{name}` is listed twice"),
                    "keep one of the two",
                );
            } else if let Some((fact, help)) = hindrance(word, has) {
                self.errors.at(Code::NotGenerated, ident.span(), fact, help);
            }
        }
        outputs
    }
}

/// Fact and help of the error, if a scene cannot have a routine.
fn hindrance(word: &str, has: Has) -> Option<(String, String)> {
    let (fact, help) = match word {
        "parameter_jacobian" if !has.parameters => (
            "there are no parameters to derive by",
            "declare the quantities of interest in `params { .. }`; numbers are constants",
        ),
        "drive_forces" if !has.drives => (
            "no joint is driven by the time",
            "write a motion with `t`, such as `motion: a*sin(w*t)`, or leave it out",
        ),
        "loop_wrenches" if !has.loops => (
            "no loop is closed",
            "tie two bodies by `close a at [..] to b at [..]: revolute(z)`, or leave it out",
        ),
        "energy" | "mass_matrix" | "bias" | "momentum" | "canonical" | "inverse_dynamics" | "shapes"
            if !has.coordinates && has.states =>
        {
            (
                "no body of the scene moves: it consists of first-order states",
                "leave it out; a quantity of the states is an `output name: e`",
            )
        }
        "canonical" if has.states => (
            "a scene with first-order states has no canonical equations",
            "leave out `canonical`; all methods but `Gauss4` and `Gauss6` integrate such scenes",
        ),
        "canonical" if has.orientations => (
            "a scene with orientations has no canonical equations: angular velocities are the rates of no coordinates",
            "leave out `canonical`; explicit methods, `Rodas5P` and `Taylor` put orientations back to unit length",
        ),
        _ => {
            let what = motion_under_inputs(word).filter(|_| has.inputs)?;
            return Some((
                format!("{what} not known: their law is given after the code is written"),
                format!("leave out `{word}`, or write the law into a `torque` in place of the input"),
            ));
        }
    };
    Some((fact.to_owned(), help.to_owned()))
}

/// Subject of the error for a routine that would need the inputs as functions of time.
fn motion_under_inputs(word: &str) -> Option<&'static str> {
    match word {
        "canonical" => Some("the canonical equations of a motion under inputs are"),
        "taylor" => Some("the Taylor series of a motion under inputs is"),
        _ => None,
    }
}
