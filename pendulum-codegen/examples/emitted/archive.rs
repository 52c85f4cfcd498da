//! FMUs as files: compiles the sources for this platform, and archives all.

use std::env::consts::{ARCH, DLL_EXTENSION, OS};
use std::error::Error;
use std::fs::{self, File};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process::Command;

use pendulum_codegen::Fmu;
use zip::write::SimpleFileOptions;
use zip::{DateTime, ZipWriter};

/// Path in the archive, and contents.
type Entry = (String, Vec<u8>);

/// Writes `<name>.fmu` into a folder, and returns its path. Without a C compiler the archive has no binary.
pub(crate) fn write(fmu: &Fmu, folder: &Path) -> Result<PathBuf, Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    let path = folder.join(format!("{}.fmu", fmu.name));
    let built = folder.join(format!(".{}", fmu.identifier));
    let binary = compile(fmu, &built);
    fs::remove_dir_all(&built)?;
    let binary = binary?;
    let mut archive = ZipWriter::new(File::create(&path)?);
    // the same bytes for the same contents
    let options = SimpleFileOptions::default().last_modified_time(DateTime::default());
    let texts = fmu
        .files
        .iter()
        .map(|(name, text)| (name.clone(), text.clone().into_bytes()));
    for (name, bytes) in texts.chain(binary) {
        archive.start_file(name, options)?;
        archive.write_all(&bytes)?;
    }
    archive.finish()?;
    Ok(path)
}

/// Compiles the sources in a new folder. Returns the binary and its path in the archive, or none without a compiler.
fn compile(fmu: &Fmu, folder: &Path) -> Result<Option<Entry>, Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    let library = format!("{}.{DLL_EXTENSION}", fmu.identifier);
    let mut command = Command::new("cc");
    command.args([
        "-shared",
        "-fPIC",
        "-std=c99",
        "-O2",
        "-ffp-contract=off",
        "-fvisibility=hidden",
    ]);
    for (path, text) in &fmu.files {
        let Some(name) = path.strip_prefix("sources/") else {
            continue;
        };
        fs::write(folder.join(name), text)?;
        command.args(name.ends_with(".c").then_some(name));
    }
    command.arg("-lm").arg("-o").arg(&library).current_dir(folder);
    match command.status() {
        Err(error) if error.kind() == ErrorKind::NotFound => {
            eprintln!(
                "`{}.fmu` has no binary: there is no C compiler `cc`. Install one, or compile the sources in your \
                 simulation tool",
                fmu.name
            );
            return Ok(None);
        }
        status => {
            if !status?.success() {
                return Err(format!("`cc` cannot compile `{}`", fmu.name).into());
            }
        }
    }
    // FMI writes `darwin` for macOS
    let system = if OS == "macos" { "darwin" } else { OS };
    let binary = fs::read(folder.join(&library))?;
    Ok(Some((format!("binaries/{ARCH}-{system}/{library}"), binary)))
}
