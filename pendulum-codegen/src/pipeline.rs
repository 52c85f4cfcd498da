//! The whole path on one screen: tokens, syntax tree, model, dynamics, program, code.

use proc_macro2::TokenStream;

use crate::ast::Scene;
use crate::dynamics::Dynamics;
use crate::emit::rust;
use crate::error::Errors;
use crate::model::Model;
use crate::program::{NotFinite, Program};
use crate::{check, lower, parse};

/// Expands a declaration into Rust items, or into its compile errors and a stand-in for the items.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let (scene, errors) = parse::parse(tokens);
    let Some(scene) = scene else {
        return errors.to_compile_errors();
    };
    match compile(&scene, errors) {
        Ok(program) => rust::items(&scene.head, &program),
        Err(errors) => {
            let mut tokens = errors.to_compile_errors();
            tokens.extend(rust::stub(&scene));
            tokens
        }
    }
}

/// The program of a declaration, or all that is wrong with it.
pub fn program(tokens: TokenStream) -> Result<Program, Errors> {
    let (scene, errors) = parse::parse(tokens);
    match scene {
        Some(scene) => compile(&scene, errors),
        None => Err(errors),
    }
}

/// The meaning of a declaration, or all that is wrong with it. Physical checks that need the dynamics are not made yet.
pub fn model(tokens: TokenStream) -> Result<Model, Errors> {
    let (scene, errors) = parse::parse(tokens);
    match scene {
        Some(scene) => lower::lower(&scene, errors),
        None => Err(errors),
    }
}

fn compile(scene: &Scene, errors: Errors) -> Result<Program, Errors> {
    let model = lower::lower(scene, errors)?;
    let dynamics = Dynamics::new(&model);
    check::check(scene, &model, &dynamics)?;
    let head = (scene.head.name.to_string(), scene.head.docs.clone());
    Program::new(head, &model, &dynamics).map_err(|NotFinite(constant)| {
        let fact = format!("the constant `{constant}` has no finite value in double precision");
        let help = "choose other units or other numbers: it overflows, or divides by something that vanishes";
        Errors::one(scene.head.name.span(), fact, help)
    })
}
