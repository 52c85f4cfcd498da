//! Costs of divisions, sines and other functions relative to an addition, in generated code: the origin of the weights
//! of the generator.

mod fit;
mod insertions;
mod subjects;
mod write;

use std::error::Error;
use std::hint::black_box;
use std::path::Path;
use std::time::Duration;

use fit::{Fit, Sample};
use insertions::Insertion;
use serde::Serialize;
use subjects::{Subject, VARIANTS};

use crate::library::Program;
use crate::machine;
use crate::rust::{Processors, Rust};
use crate::timing::{Times, in_turns};

/// Number of states evaluated one after another.
const STATES: usize = 64;
const TURNS: Duration = Duration::from_secs(60);

/// Dependences between evaluations, with the symbols of the loops.
const MODES: [(&str, &str); 3] = [
    ("right-hand sides, each after the last", "after"),
    ("right-hand sides beside each other", "beside"),
    ("Jacobians beside each other", "jacobian"),
];

#[derive(Serialize)]
pub(crate) struct Results {
    pub header: Vec<String>,
    pub fits: Vec<Fit>,
    pub insertions: Vec<Insertion>,
    pub samples: Vec<Sample>,
}

pub(crate) fn measure() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let out = root.join("out");
    let rust = Rust::new(root, &out.join("build"), Processors::This)?;
    let subjects = subjects::all(&rust)?;
    let mut samples = Vec::new();
    let mut runs = Vec::new();
    for (mode, symbol) in MODES {
        for subject in &subjects {
            let Some(operations) = subject.operations(symbol == "jacobian") else {
                continue;
            };
            for variant in VARIANTS {
                samples.push(Sample::new(mode, &subject.name, operations, variant));
                runs.push((subject, subject.load(&format!("{symbol}_{}", variant.symbol))?));
            }
        }
    }
    println!("timing {} functions", runs.len());
    for (sample, times) in samples.iter_mut().zip(time(&runs)) {
        sample.nanoseconds = times.least();
    }
    let fits = MODES
        .iter()
        .map(|(mode, _)| {
            let of_mode: Vec<&Sample> = samples.iter().filter(|sample| sample.mode == *mode).collect();
            Fit::new(mode, &of_mode)
        })
        .collect::<Result<Vec<Fit>, _>>()?;
    let unit = fits.first().map_or(f64::NAN, |fit| fit.addition);
    let insertions = insertions::measure(&subjects, unit)?;
    let results = Results {
        header: machine::describe(),
        fits,
        insertions,
        samples,
    };
    for path in write::all(&results, &out)? {
        println!("{}", path.display());
    }
    Ok(())
}

/// Times all loops in turn, each on states of its subject.
fn time(runs: &[(&Subject, Program)]) -> Vec<Times> {
    let calls: Vec<Box<dyn Fn() + '_>> = runs
        .iter()
        .map(|(subject, program)| Box::new(|| (program.run)(black_box(&subject.states))) as Box<dyn Fn()>)
        .collect();
    let calls: Vec<&dyn Fn()> = calls.iter().map(AsRef::as_ref).collect();
    in_turns(&calls, STATES, TURNS)
}
