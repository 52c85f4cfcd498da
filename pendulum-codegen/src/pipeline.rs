//! The compilation pipeline: tokens, syntax tree, model, dynamics, program, code.

use proc_macro2::TokenStream;

use crate::ast::Scene;
use crate::dynamics::Dynamics;
use crate::emit::rust;
use crate::error::{Code, Errors};
use crate::expr::Graph;
use crate::lower::Lowered;
use crate::program::{Extent, NotFinite, Program};
use crate::urdf::Files;
use crate::{check, lower, parse, urdf};

/// Request for a declaration: what is generated, in words of its list `generate`. Words that the scene cannot have are
/// left out; unknown ones are errors at the name of the scene.
#[derive(Clone, Copy, Debug)]
pub enum Wanted<'a> {
    /// The words that the declaration lists, these, and the equations as text.
    Also(&'a [&'a str]),
    /// `rhs` and these words, without the equations as text.
    Only(&'a [&'a str]),
}

/// Expands a declaration into Rust items, or into its compile errors and a stand-in for the items. Also returns the
/// path of its robot file, if it names one.
pub(crate) fn expand(tokens: TokenStream, files: &Files<'_>) -> (TokenStream, Option<String>) {
    let (scene, errors) = parse::parse(tokens);
    let Some(mut scene) = scene else {
        return (errors.to_compile_errors(), None);
    };
    let items = match compile(&mut scene, files, errors, Extent::Short) {
        Ok(program) => rust::items(&scene.head, &program),
        Err(errors) => {
            let is_possible = scene.items.is_possible();
            let stand_in = is_possible.then(|| rust::stand_in(&scene));
            errors
                .to_compile_errors()
                .into_iter()
                .chain(stand_in.into_iter().flatten())
                .collect()
        }
    };
    (items, scene.items.robot.map(|robot| robot.path))
}

/// Compiles a declaration into a program with what is wanted, or returns all of its errors.
pub(crate) fn program(tokens: TokenStream, wanted: Wanted<'_>, files: &Files<'_>) -> Result<Program, Errors> {
    let (words, extent) = match wanted {
        Wanted::Also(words) => (words, Extent::Full),
        Wanted::Only(words) => (words, Extent::None),
    };
    let (scene, errors) = parse::parse(tokens);
    match scene {
        Some(mut scene) => {
            scene.items.also = words.iter().map(|&word| word.to_owned()).collect();
            scene.items.only = matches!(wanted, Wanted::Only(_));
            compile(&mut scene, files, errors, extent)
        }
        None => Err(errors),
    }
}

fn compile(scene: &mut Scene, files: &Files<'_>, mut errors: Errors, extent: Extent) -> Result<Program, Errors> {
    if urdf::read(scene, files, &mut errors).is_err() {
        return Err(errors);
    }
    let later = errors.afresh();
    let graph = Graph::new();
    let Lowered { model, spans } = lower::lower(&graph, scene, errors)?;
    let dynamics = Dynamics::new(&model);
    check::check(&model, &spans, &dynamics, later)?;
    Program::new(&model, &dynamics, extent).map_err(|NotFinite(constant)| {
        let fact = format!("the constant `{constant}` is out of range in double precision");
        let help = "it overflows or divides by zero: choose other units or numbers";
        Errors::one(Code::NumberRange, scene.head.name.span(), fact, help)
    })
}
