//! Right-hand sides and Jacobians of several mechanisms, and the flange of one, compared with other software.
//!
//! First all forms of each peer compete with each other; then the best of each competes with the generated code.

mod agree;
mod candidate;
mod contest;
mod entrants;
mod generate;
mod ours;
mod results;
mod write;

use std::error::Error;
use std::path::Path;

use candidate::{Function, MODELS, Order};
use results::Results;

use crate::machine;

pub(crate) fn measure() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let out = root.join("out");
    let mut header = machine::describe();
    header.iter().for_each(|line| println!("{line}"));
    println!("generating and compiling the peers; the first time takes minutes");
    let mut generated = generate::generate(root, &out.join("build"))?;
    let mut candidates = ours::candidates(root, &out.join("build"))?;
    candidates.extend(entrants::compiled(&mut generated, &out.join("build"), &mut header)?);
    header.extend(generated.versions.iter().map(|version| format!("peer: {version}")));
    for note in &generated.notes {
        println!("left out: {note}");
    }
    let worst = agree::check(&candidates)?;
    header.push(format!(
        "largest difference between any two results, of the largest entry: {worst:.0e}"
    ));
    let mut rows = Vec::new();
    for (model, _) in MODELS {
        for &function in Function::of(model) {
            for order in Order::ALL {
                println!("timing {model}, {}, {}", function.title(), order.title());
                rows.extend(contest::hold(&candidates, model, function, order)?);
            }
        }
    }
    let results = Results {
        header,
        notes: generated.notes,
        rows,
    };
    for path in write::all(&results, &out)? {
        println!("{}", path.display());
    }
    Ok(())
}
