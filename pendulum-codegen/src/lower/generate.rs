//! The `generate` list: names of the routines to generate.

use std::collections::BTreeSet;

use proc_macro2::Span;

use super::Lower;
use crate::ast::{Items, Scene};
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
    /// Routines to generate: those listed, or the default ones if the list is omitted, and those added to it that the
    /// scene can have; or `rhs` and the added ones only. Errors in the added ones are at the name of the scene.
    pub(super) fn generate(&mut self, scene: &Scene, has: Has) -> BTreeSet<&'static str> {
        let items = &scene.items;
        let mut words = self.listed(items, has);
        if items.only {
            words = ["rhs"].into();
        }
        let also = items.also.iter();
        let known = also.filter_map(|name| self.routine(name, scene.head.name.span()));
        words.extend(known.filter(|word| hindrance(word, has).is_none()));
        words
    }

    /// Word of `generate` of this name; reports a name that is none.
    fn routine(&mut self, name: &str, span: Span) -> Option<&'static str> {
        let words = program::words();
        let word = words.iter().copied().find(|word| *word == name);
        if word.is_none() {
            let fact = format_args!("`{name}` cannot be generated");
            let help = words::advice(name, words, words::ROUTINES).help;
            self.errors.at(Code::UnknownWord, span, fact, help);
        }
        word
    }

    fn listed(&mut self, items: &Items, has: Has) -> BTreeSet<&'static str> {
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
        let mut outputs = BTreeSet::new();
        for ident in list {
            let name = ident.to_string();
            let Some(word) = self.routine(&name, ident.span()) else {
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
            "there are no parameters for `parameter_jacobian`",
            "declare the quantities of interest in `params { .. }`; numbers are constants",
        ),
        "drive_forces" if !has.drives => (
            "no joint has a prescribed motion",
            "drive a joint by a function of `t`, such as `motion: a*sin(w*t)`, or leave out `drive_forces`",
        ),
        "loop_wrenches" if !has.loops => (
            "there are no closed loops",
            "close one by `close a at [..] to b at [..]: revolute(z)`, or leave out `loop_wrenches`",
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
            "leave out `canonical`; all methods but `Gauss4`, `Gauss6` and `Gauss16` integrate such scenes",
        ),
        "canonical" if has.orientations => (
            "canonical equations are not available with ball or free joints: angular velocities are not rates of \
             coordinates",
            "leave out `canonical`; explicit methods, `Rodas5P` and `Taylor` normalise orientations",
        ),
        _ => {
            let (what, instead) = motion_under_inputs(word).filter(|_| has.inputs)?;
            return Some((
                format!("{what} not available with inputs: their values are given at run time"),
                format!("leave out `{word}`, and use {instead}; or write the law as a `torque` instead of an input"),
            ));
        }
    };
    Some((fact.to_owned(), help.to_owned()))
}

/// Subject of the error for a routine that would need the inputs as functions of time, and methods without it.
fn motion_under_inputs(word: &str) -> Option<(&'static str, &'static str)> {
    match word {
        "canonical" => Some(("canonical equations are", "`Vern9`, or `Rodas5P` for stiff motions")),
        "taylor" => Some(("the Taylor series is", "`Vern9` at tight tolerances")),
        _ => None,
    }
}
