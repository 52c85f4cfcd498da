//! The whole path on one screen: tokens, syntax tree, model, dynamics, program, code.

use std::env;
use std::path::{Path, PathBuf};

use proc_macro2::TokenStream;

use crate::ast::Scene;
use crate::dynamics::Dynamics;
use crate::emit::rust;
use crate::error::Errors;
use crate::expr::Graph;
use crate::lower::Lowered;
use crate::program::{NotFinite, Program};
use crate::{check, lower, parse, urdf};

/// Expands a declaration into Rust items, or into its compile errors and a stand-in for the items.
///
/// Files that it names are looked for in the folder of the manifest, `CARGO_MANIFEST_DIR`, and are read by the items
/// too, so that cargo builds them anew when a file changes.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let folder = manifest_folder();
    let (scene, mut items) = expanded(&folder, tokens);
    let robot = scene.and_then(|scene| scene.items.robot);
    // that it is no file, or not there, has been reported; without a manifest there is no cargo, which would build anew
    if let Some(robot) = robot.filter(|robot| env::var_os(MANIFEST).is_some() && folder.join(&robot.path).is_file()) {
        items.extend(urdf::tracked(&robot));
    }
    items
}

/// Expands a declaration whose files are in a folder; the items do not name it.
pub fn expand_in(folder: &Path, tokens: TokenStream) -> TokenStream {
    expanded(folder, tokens).1
}

/// The program of a declaration, or all that is wrong with it. Files that it names are looked for in the folder of the
/// manifest, `CARGO_MANIFEST_DIR`, or where the program runs.
pub fn program(tokens: TokenStream) -> Result<Program, Errors> {
    program_in(&manifest_folder(), tokens)
}

/// The program of a declaration whose files are in a folder, or all that is wrong with it.
pub fn program_in(folder: &Path, tokens: TokenStream) -> Result<Program, Errors> {
    let (scene, errors) = parse::parse(tokens);
    match scene {
        Some(mut scene) => compile(&mut scene, folder, errors),
        None => Err(errors),
    }
}

const MANIFEST: &str = "CARGO_MANIFEST_DIR";

fn manifest_folder() -> PathBuf {
    env::var_os(MANIFEST).map(PathBuf::from).unwrap_or_default()
}

fn expanded(folder: &Path, tokens: TokenStream) -> (Option<Scene>, TokenStream) {
    let (scene, errors) = parse::parse(tokens);
    let Some(mut scene) = scene else {
        return (None, errors.to_compile_errors());
    };
    let items = match compile(&mut scene, folder, errors) {
        Ok(program) => rust::items(&scene.head, &program),
        Err(errors) => {
            let mut tokens = errors.to_compile_errors();
            tokens.extend(rust::stand_in(&scene));
            tokens
        }
    };
    (Some(scene), items)
}

fn compile(scene: &mut Scene, folder: &Path, mut errors: Errors) -> Result<Program, Errors> {
    if urdf::read(scene, folder, &mut errors).is_err() {
        return Err(errors);
    }
    let later = errors.afresh();
    let graph = Graph::new();
    let Lowered { model, spans } = lower::lower(&graph, scene, errors)?;
    let dynamics = Dynamics::new(&model);
    check::check(&model, &spans, &dynamics, later)?;
    Program::new(&model, &dynamics).map_err(|NotFinite(constant)| {
        let fact = format!("the constant `{constant}` has no finite value in double precision");
        let help = "choose other units or other numbers: it overflows, or divides by something that vanishes";
        Errors::one(scene.head.name.span(), fact, help)
    })
}
