//! Prints the code that `mechanism!` generates for a declaration.
//!
//! ```sh
//! cargo run --example emitted                         # the code for the double pendulum of the paper, formatted
//! cargo run --example emitted -- src/lib.rs           # for every declaration of a file, wherever it stands there
//! cargo run --example emitted -- --latex src/lib.rs   # their equations of motion in LaTeX, which needs amsmath
//! cargo run --example emitted -- --c src/lib.rs out   # C: a header and a source for each, in a folder
//! cargo run --example emitted -- --fused src/lib.rs out   # C in fused arithmetic
//! cargo run --example emitted -- --fmu src/lib.rs out   # an FMU for each, for simulation tools with FMI 3.0
//! ```

use std::collections::BTreeSet;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use pendulum_codegen::{Sources, c, c_fused, expand, fmu, program};
use proc_macro2::TokenStream;

use declarations::declarations;

mod archive;
#[path = "../../tests/common/declarations.rs"]
mod declarations;

/// File that is read by default.
const DEFAULT: &str = "testbed/src/scenes.rs";

const USAGE: &str = "usage: emitted [FILE], emitted --latex [FILE], emitted --c [FILE [FOLDER]], emitted --fused [FILE \
                     [FOLDER]] for C in fused arithmetic, or emitted --fmu [FILE [FOLDER]] for FMUs of FMI 3.0";

/// Language of the output.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Output {
    Rust,
    Latex,
    C,
    FusedC,
    Fmu,
}

impl Output {
    /// True if the output is files in a folder.
    fn is_files(self) -> bool {
        matches!(self, Self::C | Self::FusedC | Self::Fmu)
    }
}

struct Arguments {
    output: Output,
    path: String,
    folder: PathBuf,
}

impl Arguments {
    fn read(arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut read = Self {
            output: Output::Rust,
            path: DEFAULT.to_owned(),
            folder: PathBuf::from("out/emitted"),
        };
        let mut named = Vec::new();
        for argument in arguments {
            match argument.as_str() {
                "--latex" => read.output = Output::Latex,
                "--c" => read.output = Output::C,
                "--fused" => read.output = Output::FusedC,
                "--fmu" => read.output = Output::Fmu,
                option if option.starts_with('-') => return Err(USAGE.to_owned()),
                _ => named.push(argument),
            }
        }
        let mut named = named.into_iter();
        read.path = named.next().unwrap_or(read.path);
        let folder = named.next();
        if named.next().is_some() || (folder.is_some() && !read.output.is_files()) {
            return Err(USAGE.to_owned());
        }
        read.folder = folder.map_or(read.folder, PathBuf::from);
        Ok(read)
    }
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let Arguments { output, path, folder } = Arguments::read(std::env::args().skip(1))?;
    let source = std::fs::read_to_string(&path).map_err(|error| format!("cannot read {path}: {error}"))?;
    let tokens: TokenStream = source.parse().map_err(|error| format!("{path}: {error}"))?;
    let declarations = declarations(tokens);
    if declarations.is_empty() {
        return Err(format!("{path} holds no `mechanism! {{ .. }}`").into());
    }
    let (mut wrong, mut written) = (Vec::new(), BTreeSet::new());
    for declaration in declarations {
        match program(declaration.clone()) {
            Err(errors) => wrong.extend(errors.iter().map(|error| {
                let at = error.span().start();
                format!("{path}:{}:{}: {error}", at.line, at.column + 1)
            })),
            Ok(program) => match output {
                Output::Latex => println!("{}", program.equations.latex()),
                Output::C | Output::FusedC | Output::Fmu => {
                    let sources = match output {
                        Output::FusedC => c_fused(&program),
                        _ => c(&program),
                    };
                    let name = &sources.name;
                    if !written.insert(name.clone()) {
                        return Err(
                            format!("two declarations of {path} have the name `{name}` in C; rename one").into(),
                        );
                    }
                    if output != Output::Fmu {
                        write_c(&sources, &folder)?;
                        continue;
                    }
                    match fmu(&program) {
                        Ok(fmu) => println!("{}", archive::write(&fmu, &folder)?.display()),
                        Err(error) => wrong.push(format!("{path}: `{}`: {error}", program.name)),
                    }
                }
                Output::Rust => println!("{}", prettyplease::unparse(&syn::parse2(expand(declaration))?)),
            },
        }
    }
    if wrong.is_empty() {
        Ok(())
    } else {
        Err(wrong.join("\n").into())
    }
}

/// Writes a header and a source file, and prints their paths.
fn write_c(sources: &Sources, folder: &Path) -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all(folder)?;
    for (extension, text) in [("h", &sources.header), ("c", &sources.source)] {
        let path = folder.join(&sources.name).with_extension(extension);
        std::fs::write(&path, text)?;
        println!("{}", path.display());
    }
    Ok(())
}
