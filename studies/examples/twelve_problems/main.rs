//! Methods on twelve problems: errors at the end, over time and of the dense output, over time, operations and
//! tolerance, alone and in lanes. Explicit methods are left out on stiff problems, Gauss methods on all but the three
//! that keep their energy: the large swing, Pleiades, Hénon and Heiles.
//!
//! `cargo run --release -p studies --features long --example twelve_problems` builds for fifteen minutes and runs for
//! four. It prints tables of the fastest methods, and writes charts, a page on which hovering shows values, and all
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
    let tables = [table::alone(problems), table::in_lanes(problems)];
    println!("{}\n", tables.join("\n\n"));
    let mut page = Report::new("Twelve problems").text(
        "Times are the shortest of several rounds, for one trajectory of which only the end is kept, all methods in \
         turns on one core; in lanes they are for one of 64 trajectories from starts a little apart. Errors are those \
         of the largest component of the state, over the largest component at the end. Runs that failed have no dot; \
         the lists below say why.",
    );
    for table in &tables {
        page = page.table(table);
    }
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
