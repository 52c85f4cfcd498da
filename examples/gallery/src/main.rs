//! Runs the systems of the gallery: checks each, and draws it into `out/gallery/`.
//!
//! ```sh
//! cargo run --release -p gallery                          # all of them
//! cargo run --release -p gallery -- kapitza furuta        # some of them
//! cargo run --release -p gallery -- --animate kapitza     # with an animation
//! ```

use std::error::Error;
use std::path::Path;

use gallery::{SYSTEMS, System};

fn main() -> Result<(), Box<dyn Error>> {
    let (flags, names): (Vec<String>, Vec<String>) = std::env::args()
        .skip(1)
        .partition(|argument| argument.starts_with("--"));
    let known = || SYSTEMS.iter().map(|system| system.name).collect::<Vec<_>>().join(", ");
    if let Some(flag) = flags.iter().find(|flag| *flag != "--animate") {
        return Err(format!("unknown option `{flag}`: the only one is --animate").into());
    }
    if let Some(name) = names
        .iter()
        .find(|name| !SYSTEMS.iter().any(|system| system.name == *name))
    {
        return Err(format!("no system `{name}`; there are {}", known()).into());
    }
    let wanted = |system: &&System| names.is_empty() || names.iter().any(|name| name == system.name);
    let (mut wrong, mut files) = (0, Vec::new());
    for system in SYSTEMS.iter().filter(wanted) {
        let run = (system.run)()?;
        println!("{}", system.name);
        for check in &run.checks {
            println!("    {check}");
            wrong += usize::from(!check.holds());
        }
        files.extend(run.draw(&Path::new("out/gallery").join(system.name), !flags.is_empty())?);
    }
    for file in files {
        println!("{}", file.display());
    }
    if wrong > 0 {
        return Err(format!("{wrong} checks failed").into());
    }
    Ok(())
}
