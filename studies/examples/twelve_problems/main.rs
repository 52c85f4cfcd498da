//! Methods on twelve problems: errors over time, operations and tolerance. Explicit methods are left out on stiff
//! problems, Gauss methods on all but the three that keep their energy: the large swing, Pleiades, Hénon and Heiles.
//!
//! `cargo run --release -p studies --features long --example twelve_problems` builds for ten minutes and runs for four.
//! It prints a table of the fastest methods, and writes charts, a page on which hovering shows values, and all
//! measurements as JSON.

mod figures;
mod json;
mod measure;
mod table;

use std::error::Error;
use std::fs;
use std::path::Path;

use charts::page::Picture;
use charts::report::Report;
use testbed::problems;

const OUT: &str = "out/twelve_problems";

fn main() -> Result<(), Box<dyn Error>> {
    let mut measured = measure::Measured::default();
    problems::each(&mut measured)?;
    let problems = &measured.0;

    let folder = Path::new(OUT);
    let figures = figures::all(problems);
    let mut files = Vec::new();
    for (stem, figure) in &figures {
        files.extend(figure.save(&folder.join(stem))?);
    }
    let table = table::markdown(problems);
    println!("{table}\n");
    let mut page = Report::new("Twelve problems").text(
        "Times are the shortest of several rounds, for one trajectory of which only the end is kept, all methods in \
         turns on one core. Errors are those of the largest component of the state at the end, over the largest \
         component. Runs that failed have no dot; the lists below say why.",
    );
    page = page.table(&table);
    for (_, figure) in &figures {
        page = page.chart(figure);
    }
    for problem in problems {
        let report = problem.measurement.report.to_string();
        page = page
            .heading(&format!("All settings: {}", problem.title))
            .listing(&report);
    }
    files.push(page.save(&folder.join("index"))?);
    let raw = folder.join("measurements.json");
    fs::write(&raw, serde_json::to_string_pretty(&json::of(problems))?)?;
    files.push(raw);
    for path in files {
        println!("{}", path.display());
    }
    Ok(())
}
