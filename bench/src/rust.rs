//! Compilation of Rust into shared libraries by calls of `rustc` alone, with prebuilt dependencies.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use serde::Deserialize;

/// Target processors of compiled code.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Processors {
    /// All processors of this architecture, as in a plain `cargo build --release`.
    All,
    /// The processor of this machine, as in the other measurements.
    This,
}

/// Compiler with `pendulum_core` as a dependency.
pub(crate) struct Rust {
    folder: PathBuf,
    core: PathBuf,
    processors: Processors,
}

/// Line of cargo's JSON messages.
#[derive(Deserialize)]
struct Message {
    #[serde(default)]
    target: Target,
    #[serde(default)]
    filenames: Vec<PathBuf>,
}

#[derive(Default, Deserialize)]
struct Target {
    name: String,
}

impl Processors {
    fn name(self) -> &'static str {
        match self {
            Self::All => "all",
            Self::This => "this",
        }
    }

    fn flags(self) -> &'static str {
        match self {
            Self::All => "",
            Self::This => "-Ctarget-cpu=native",
        }
    }
}

impl Rust {
    /// Builds `pendulum_core` in release mode, in a separate crate below `build`, unless it exists from an earlier run.
    pub(crate) fn new(root: &Path, build: &Path, processors: Processors) -> Result<Self, Box<dyn Error>> {
        let folder = build.join("rust").join(processors.name());
        fs::create_dir_all(folder.join("src"))?;
        fs::write(folder.join("src/lib.rs"), "")?;
        let manifest = format!(
            "[workspace]\n[package]\nname = \"base\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\
             [dependencies]\npendulum-core = {{ path = {:?} }}\n\
             [profile.release.build-override]\nopt-level = 2\n",
            root.join("../pendulum-core").canonicalize()?
        );
        fs::write(folder.join("Cargo.toml"), manifest)?;
        // same versions as in the measurements
        fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock"))?;
        Ok(Self {
            core: build_with_cargo(&folder, &folder.join("target"), processors, "pendulum_core", "rlib")?,
            folder,
            processors,
        })
    }

    /// Compiles the shared library `name` from a source; also returns the time of the compiler.
    pub(crate) fn library(&self, name: &str, source: &str) -> Result<(PathBuf, Duration), Box<dyn Error>> {
        let (input, library) = (
            self.folder.join(format!("{name}.rs")),
            self.folder.join(format!("{name}.so")),
        );
        fs::write(&input, source)?;
        let dependencies = self.core.parent().unwrap_or(&self.folder);
        let mut command = Command::new("rustc");
        command
            .args(["--edition", "2024", "--crate-type", "cdylib", "--crate-name", name])
            .args(["-Copt-level=3", "-Cembed-bitcode=no", "--cap-lints", "allow"])
            .args(Some(self.processors.flags()).filter(|flags| !flags.is_empty()))
            .arg("-L")
            .arg(format!("dependency={}", dependencies.display()))
            .arg("--extern")
            .arg(format!("pendulum_core={}", self.core.display()))
            .arg(&input)
            .arg("-o")
            .arg(&library)
            .current_dir(&self.folder);
        // Remove the file first: overwriting it would corrupt a library that this process has loaded.
        match fs::remove_file(&library) {
            Err(error) if error.kind() != std::io::ErrorKind::NotFound => return Err(error.into()),
            _ => {}
        }
        let start = Instant::now();
        run(&mut command)?;
        Ok((library, start.elapsed()))
    }
}

/// Builds the shared library of the package in `folder`, in release mode.
pub(crate) fn package(folder: &Path, build: &Path, processors: Processors) -> Result<PathBuf, Box<dyn Error>> {
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    let target = build.join("rust").join(&*name).join(processors.name());
    build_with_cargo(folder, &target, processors, &name, "so")
}

/// Builds the package in `folder`; returns the file of the library `name` with the given extension.
fn build_with_cargo(
    folder: &Path,
    target: &Path,
    processors: Processors,
    name: &str,
    extension: &str,
) -> Result<PathBuf, Box<dyn Error>> {
    let mut command = Command::new("cargo");
    command
        .args(["build", "--release", "--message-format=json"])
        .env("RUSTFLAGS", processors.flags())
        .env("CARGO_TARGET_DIR", target)
        .current_dir(folder);
    let output = run(&mut command)?;
    let file = String::from_utf8_lossy(&output.stdout)
        .lines()
        .filter_map(|line| serde_json::from_str::<Message>(line).ok())
        .filter(|message| message.target.name == name)
        .flat_map(|message| message.filenames)
        .find(|file| file.extension().is_some_and(|ending| ending == extension));
    Ok(file.ok_or_else(|| format!("cargo does not say where {name} is"))?)
}

fn run(command: &mut Command) -> Result<Output, Box<dyn Error>> {
    let program = command.get_program().to_string_lossy().into_owned();
    let output = command.output().map_err(|error| format!("{program}: {error}"))?;
    if output.status.success() {
        Ok(output)
    } else {
        Err(format!("{program}:\n{}", String::from_utf8_lossy(&output.stderr)).into())
    }
}
