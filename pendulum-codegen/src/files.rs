//! What is outside of a declaration: the files that it names, and the folder in which they are looked for.

use std::env;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use proc_macro2::TokenStream;

use crate::error::Errors;
use crate::pipeline;
use crate::program::Program;
use crate::urdf::{self, Unreadable};

/// Expands a declaration into Rust items, or into its compile errors and a stand-in for the items.
///
/// Files that it names are looked for in the folder of the manifest, `CARGO_MANIFEST_DIR`, and are read by the items
/// too, so that cargo builds them anew when a file changes.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let folder = manifest_folder();
    let (mut items, robot) = pipeline::expand(tokens, &|name| text_of(&folder, name));
    // that it is no file, or not there, has been reported; without a manifest there is no cargo, which would build anew
    if let Some(robot) = robot.filter(|name| env::var_os(MANIFEST).is_some() && folder.join(name).is_file()) {
        items.extend(urdf::tracked(&robot));
    }
    items
}

/// Expands a declaration whose files are in a folder; the items do not name it.
pub fn expand_in(folder: &Path, tokens: TokenStream) -> TokenStream {
    pipeline::expand(tokens, &|name| text_of(folder, name)).0
}

/// The program of a declaration, or all that is wrong with it. Files that it names are looked for in the folder of the
/// manifest, `CARGO_MANIFEST_DIR`, or where the program runs.
pub fn program(tokens: TokenStream) -> Result<Program, Errors> {
    program_in(&manifest_folder(), tokens)
}

/// The program of a declaration whose files are in a folder, or all that is wrong with it.
pub fn program_in(folder: &Path, tokens: TokenStream) -> Result<Program, Errors> {
    pipeline::program(tokens, &|name| text_of(folder, name))
}

const MANIFEST: &str = "CARGO_MANIFEST_DIR";

fn manifest_folder() -> PathBuf {
    env::var_os(MANIFEST).map(PathBuf::from).unwrap_or_default()
}

/// The text of a file, or what is wrong and what to do about it.
fn text_of(folder: &Path, name: &str) -> Result<String, Unreadable> {
    let begins = "the path begins at the folder in which `Cargo.toml` is";
    if name.trim().is_empty() {
        let help =
            "write that of a file, as in `urdf(\"src/robot.urdf\")`; it begins at the folder in which `Cargo.toml` is";
        return Err(("the path of the robot is empty".to_owned(), help));
    }
    let path = folder.join(name);
    if path.is_dir() {
        return Err((format!("`{name}` is a folder"), "name the URDF file in it"));
    }
    std::fs::read_to_string(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound | ErrorKind::NotADirectory => (format!("there is no file `{name}`"), begins),
        ErrorKind::InvalidData => (
            format!("`{name}` is not in UTF-8"),
            "save it in that encoding, which is the usual one",
        ),
        _ => (format!("`{name}` cannot be read: {error}"), begins),
    })
}
