//! Measurements of the generated code and of the methods compared with their peers, each written as a table and a chart
//! into `out/`.

mod compile;
mod control;
mod generated;
mod lanes;
mod library;
mod linkages;
mod machine;
mod peers;
mod python;
mod questions;
mod report;
mod robots;
mod rust;
mod scaling;
mod sweeps;
mod timing;
mod twelve;
mod weights;

use std::error::Error;
use std::process::ExitCode;

type Measurement = fn() -> Result<(), Box<dyn Error>>;

/// All measurements: `cargo run --release -- NAME`.
const MEASUREMENTS: [(&str, Measurement); 10] = [
    ("peers", peers::measure),
    ("lanes", lanes::measure),
    ("scaling", scaling::measure),
    ("weights", weights::measure),
    ("twelve", twelve::measure),
    ("sweeps", sweeps::measure),
    ("linkages", linkages::measure),
    ("robots", robots::measure),
    ("control", control::measure),
    ("questions", questions::measure),
];

fn main() -> ExitCode {
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    if let Some(name) = wanted
        .iter()
        .find(|name| MEASUREMENTS.iter().all(|(known, _)| known != name))
    {
        let known: Vec<&str> = MEASUREMENTS.iter().map(|&(known, _)| known).collect();
        eprintln!("no measurement named `{name}`; there is {}", known.join(", "));
        return ExitCode::FAILURE;
    }
    for (name, measure) in MEASUREMENTS {
        if !wanted.is_empty() && !wanted.iter().any(|wanted| wanted == name) {
            continue;
        }
        if let Err(error) = measure() {
            eprintln!("{name}: {error}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
