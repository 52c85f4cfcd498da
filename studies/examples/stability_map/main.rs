//! Stability maps over the friction of both joints, over the initial angles at rest, and over the amplitude; and
//! Poincare sections.
//!
//! `cargo run --release -p studies --example stability_map` computes and draws them on all cores, in about a minute of
//! processor time. `-- --size N` computes N cells along each side of a map instead of 270; most of the time is
//! proportional to the square of N. A page with all charts shows values where the pointer hovers.

mod amplitude;
mod friction;
mod progress;
mod scene;
mod sections;
mod starts;

use std::error::Error;
use std::ops::RangeInclusive;
use std::path::Path;
use std::process::ExitCode;

use charts::page::Picture;
use charts::report::Report;

const OUT: &str = "out/stability_map";
/// Default number of cells along each side of a map.
const SIZE: usize = 270;
const SIZES: RangeInclusive<usize> = 4..=2160;

fn main() -> ExitCode {
    match size(std::env::args().skip(1)).and_then(run) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("stability_map: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Parses the number of cells from the arguments.
fn size(mut arguments: impl Iterator<Item = String>) -> Result<usize, Box<dyn Error>> {
    let size = match arguments.next().as_deref() {
        None => return Ok(SIZE),
        Some("--size") => arguments.next().ok_or("--size needs a number of cells")?,
        Some(other) => return Err(format!("unknown argument `{other}`; the only option is `--size N`").into()),
    };
    if let Some(more) = arguments.next() {
        return Err(format!("unknown argument `{more}`; the only option is `--size N`").into());
    }
    match size.parse() {
        Ok(size) if SIZES.contains(&size) => Ok(size),
        _ => Err(format!(
            "--size is `{size}`, but must be a whole number from {} to {}",
            SIZES.start(),
            SIZES.end()
        )
        .into()),
    }
}

fn run(size: usize) -> Result<(), Box<dyn Error>> {
    let folder = Path::new(OUT);
    let frictions = friction::measure(size)?;
    println!("{frictions}\n");
    let starts = starts::measure(size)?;
    println!("{starts}\n");
    let amplitudes = amplitude::measure(size)?;
    println!("{amplitudes}\n");
    let sections = sections::measure()?;
    println!("{sections}\n");

    let (friction, start, amplitude, section) = (
        frictions.atlas(),
        starts.atlas(),
        amplitudes.figure(),
        sections.figure(),
    );
    let mut files = vec![
        friction.save_png(&folder.join("friction"))?,
        start.save_png(&folder.join("starts"))?,
        section.save_png(&folder.join("sections"))?,
    ];
    files.extend(amplitude.save(&folder.join("exponents"))?);
    let report = Report::new("Stability of the double pendulum")
        .chart(&start)
        .listing(&starts.to_string())
        .chart(&friction)
        .listing(&frictions.to_string())
        .chart(&amplitude)
        .listing(&amplitudes.to_string())
        .chart(&section)
        .listing(&sections.to_string());
    files.push(report.save(&folder.join("index"))?);
    for path in files {
        println!("{}", path.display());
    }
    Ok(())
}
