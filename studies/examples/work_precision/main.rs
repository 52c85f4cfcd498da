//! Work-precision study: errors of all methods over time and operations, and errors of simpler models over their cost.
//!
//! `cargo run --release -p studies --example work_precision` measures a regular, a chaotic and a stiff motion of the
//! double pendulum, and the small-motion model over the amplitude. It prints the tables of the book, and writes charts
//! and a page with all charts and tables, on which hovering shows values. It takes half a minute.

mod figures;
mod methods;
mod page;
mod scenes;
mod simpler;
mod table;

use std::error::Error;
use std::path::Path;

use charts::page::Picture;

const OUT: &str = "out/work_precision";

fn main() -> Result<(), Box<dyn Error>> {
    let [regular, chaotic, stiff] = scenes::scenes()?;
    let mut measured = Vec::new();
    for scene in [&regular, &chaotic] {
        eprintln!("measuring: {} ..", scene.title);
        measured.push((scene, methods::measure(scene)));
    }
    eprintln!("measuring: {} ..", stiff.title);
    measured.push((&stiff, methods::measure_stiff(&stiff)));
    eprintln!("measuring: simpler models ..");
    let simpler = simpler::measure()?;

    let folder = Path::new(OUT);
    let charts = [
        (
            "methods",
            "Operations are the additions and multiplications of the model and of the method, counted one by one: \
             those of power series and of linear systems, too. The control of the step size is not counted.",
            figures::methods(&measured[..2]),
        ),
        (
            "lanes",
            "With AVX-512 eight trajectories share a register, with AVX2 four. Each takes its own steps, and ends \
             bit for bit where it ends alone.",
            figures::lanes(&measured[..2]),
        ),
        (
            "dense_and_energy",
            "Methods differ in their accuracy between the steps: the dense output of `Vern9` stops at 1e-13, \
             because its weights are large and of both signs. The energy of the small swing is a small difference \
             of large numbers: rounding stops it at 1e-12.",
            figures::dense_and_energy(&measured[..2]),
        ),
        (
            "stiff",
            "Friction forces short steps on explicit methods, whatever the tolerance. `Auto` notices and switches \
             to an implicit method.",
            figures::stiff(&measured[2..]),
        ),
        (
            "simpler_models",
            "Where the linear model is good enough, the state at any time is one product with a matrix: \
             nanoseconds instead of microseconds. Leaving out friction saves no time.",
            simpler.figure(),
        ),
    ];
    let mut files = Vec::new();
    for (stem, _, figure) in &charts {
        files.extend(figure.save(&folder.join(stem))?);
    }
    let table = [&measured[..2], &measured[2..]].map(table::markdown).join("\n\n");
    println!("{table}\n\n{simpler}\n");
    let page = page::page(&charts, &measured, &simpler, &table);
    files.push(page.save(&folder.join("index"))?);
    for path in files {
        println!("{}", path.display());
    }
    Ok(())
}
