//! Entry points that read the files named in a declaration, relative to a folder.

use std::env;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use proc_macro2::TokenStream;

use crate::error::Errors;
use crate::pipeline::{self, Wanted};
use crate::program::Program;
use crate::urdf::{self, Files, Unreadable};

/// Expands a declaration into Rust items, or into its compile errors and a stand-in for the items.
///
/// Paths are relative to the folder of the manifest, `CARGO_MANIFEST_DIR`. The items include the file of a robot, so
/// that cargo rebuilds when it changes.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let folder = manifest_folder();
    let (mut items, robot) = pipeline::expand(tokens, &|name| text_of(&folder, name));
    // a missing file has been reported; without a manifest, there is no cargo that could rebuild
    if let Some(robot) = robot.filter(|name| env::var_os(MANIFEST).is_some() && folder.join(name).is_file()) {
        items.extend(urdf::tracked(&robot));
    }
    items
}

/// Like [`expand`], but with paths relative to `folder`; the items do not include the file of a robot.
pub fn expand_in(folder: &Path, tokens: TokenStream) -> TokenStream {
    expand_with(tokens, &|name| text_of(folder, name))
}

/// Like [`expand_in`], but reads the file of a robot by a function, as [`program_with`] does.
pub fn expand_with(tokens: TokenStream, files: &Files<'_>) -> TokenStream {
    pipeline::expand(tokens, files).0
}

/// Compiles a declaration into a program, or returns all of its errors.
///
/// Paths are relative to the folder of the manifest, `CARGO_MANIFEST_DIR`, or to the working directory if that variable
/// is not set.
pub fn program(tokens: TokenStream) -> Result<Program, Errors> {
    program_in(&manifest_folder(), tokens)
}

/// Like [`program()`], but with paths relative to `folder`.
pub fn program_in(folder: &Path, tokens: TokenStream) -> Result<Program, Errors> {
    pipeline::program(tokens, Wanted::Also(&[]), &|name| text_of(folder, name))
}

/// Like [`program()`], but generates what `wanted` says, and reads the file of a robot by the function `files`, which
/// returns the text of a file by its name, or why it cannot be read and a help text.
pub fn program_with(tokens: TokenStream, wanted: Wanted<'_>, files: &Files<'_>) -> Result<Program, Errors> {
    pipeline::program(tokens, wanted, files)
}

const MANIFEST: &str = "CARGO_MANIFEST_DIR";

fn manifest_folder() -> PathBuf {
    env::var_os(MANIFEST).map(PathBuf::from).unwrap_or_default()
}

/// Returns the text of a file, or why it cannot be read and a help text.
fn text_of(folder: &Path, name: &str) -> Result<String, Unreadable> {
    let begins = "the path is relative to the folder of `Cargo.toml`";
    if name.trim().is_empty() {
        let help = "write the path of a file, as in `urdf(\"src/robot.urdf\")`, relative to the folder of \
                    `Cargo.toml`";
        return Err(("the path of the robot is empty".to_owned(), help));
    }
    let path = folder.join(name);
    if path.is_dir() {
        return Err((format!("`{name}` is a folder"), "write the path of a URDF file in it"));
    }
    std::fs::read_to_string(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound | ErrorKind::NotADirectory => (format!("there is no file `{name}`"), begins),
        ErrorKind::InvalidData => (format!("`{name}` is not valid UTF-8"), "save it as UTF-8"),
        _ => (format!("`{name}` cannot be read: {error}"), begins),
    })
}
