//! Time to reach a given error on twelve problems: our methods beside other libraries.
//!
//! Peers in C, C++ and Python use the emitted C, those in Rust the generated Rust. Only heyoka takes expressions.

mod cells;
mod chart;
mod compiled;
mod emitted;
mod entrant;
mod foreign;
mod measured;
mod results;
mod sweep;
mod write;

use std::error::Error;
use std::fs;
use std::path::Path;

use emitted::Emitted;
use entrant::Entrant;
use measured::Measured;
use results::Measure;
use write::Results;

use crate::machine::{self, locked};

pub(crate) fn measure() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (out, build) = (root.join("out/twelve"), root.join("out/build"));
    fs::create_dir_all(&build)?;
    let (mut header, mut notes) = (machine::describe(), Vec::new());
    header.extend(["ode_solvers", "differential-equations", "diffsol"].map(|name| format!("{name} {}", locked(name))));
    println!("computing references");
    let mut problems = twelve::problems()?;
    let mut entrants: Vec<Vec<Entrant>> = problems
        .iter_mut()
        .map(|problem| problem.entrants.drain(..).map(Entrant::from).collect())
        .collect();
    println!("compiling C and C++");
    let emitted: Vec<Emitted> = problems
        .iter()
        .map(|problem| Emitted::new(root, &build, problem))
        .collect::<Result<_, _>>()?;
    compiled::enter(root, &problems, &emitted, &mut entrants, [&mut header, &mut notes])?;
    foreign::enter(root, &problems, &emitted, &mut entrants, [&mut header, &mut notes])?;
    notes.iter().for_each(|note| println!("left out: {note}"));
    let mut results = Results {
        header,
        notes,
        problems: Vec::new(),
    };
    for (problem, entrants) in problems.into_iter().zip(&entrants) {
        println!("timing {}", problem.title);
        let (curves, settings) = sweep::sweep(&problem, entrants);
        let measures = [
            (Measure::End, problem.uncertainty),
            (Measure::Along, problem.uncertainty_along),
        ];
        let [cells, cells_along] =
            measures.map(|(measure, uncertainty)| cells::cells(&curves, &settings, measure, uncertainty));
        results.problems.push(Measured {
            problem,
            curves,
            settings,
            cells,
            cells_along,
        });
    }
    for path in write::all(&results, &out)? {
        println!("{}", path.display());
    }
    Ok(())
}
