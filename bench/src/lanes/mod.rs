//! Many trajectories on one core: double pendulums in the lanes of each instruction set, compared with C++ with AVX-512
//! intrinsics and SLEEF.

mod disassembly;
mod sides;
mod write;

use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::time::Duration;

use serde::Serialize;
use sides::Side;

use crate::machine;
use crate::timing::in_turns;

/// Number of trajectories: twice as many as the widest interleaved lanes hold.
const COUNT: usize = 64;
const STEPS: usize = 1000;
const START: [f64; 4] = [2.0, 2.5, 0.0, 0.0];
const BUDGET: Duration = Duration::from_secs(40);

/// Maximum difference of final states between the C++ side and the scalar one, relative to the largest entry. C++
/// rounds differently, and in 10 s the motion magnifies a difference some hundred thousand times.
const BOUND: f64 = 1e-9;

#[derive(Serialize)]
pub(crate) struct Results {
    pub header: Vec<String>,
    pub notes: Vec<String>,
    pub rows: Vec<Row>,
}

/// Throughput of a side, in million trajectory steps per second.
#[derive(Serialize)]
pub(crate) struct Row {
    pub side: String,
    pub number: &'static str,
    pub most: f64,
    pub median: f64,
    /// Ratio to one trajectory at a time, in the same number type: median over the rounds.
    pub ratio: f64,
    /// Ratio of the highest throughputs.
    pub ratio_of_most: f64,
    /// Largest difference from the final state of a single trajectory, relative to the largest entry.
    pub difference: f64,
    /// True if another interleaving of the same side was faster.
    pub slower: bool,
}

pub(crate) fn measure() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (out, build) = (root.join("out"), root.join("out/build"));
    fs::create_dir_all(&build)?;
    let mut header = machine::describe();
    header.retain(|line| !line.starts_with("Rust"));
    header.push(format!(
        "Rust: {}, as a plain `cargo build --release` compiles it",
        machine::says("rustc", &["--version"])
    ));
    let mut notes = Vec::new();
    let (mut sides, library) = sides::ours(root, &build)?;
    match sides::sleef(root, &build) {
        Ok((theirs, compiler)) => {
            sides.extend(theirs);
            header.push(compiler);
        }
        Err(why) => notes.push(why),
    }
    match disassembly::intrinsics_are_inlined(&library) {
        Ok(found) => header.push(found),
        Err(why) => notes.push(why),
    }
    notes.iter().for_each(|note| println!("left out: {note}"));
    let starts: Vec<f64> = START.repeat(COUNT);
    let differences = agree(&sides, &starts)?;
    let runs: Vec<Box<dyn Fn() + '_>> = sides
        .iter()
        .map(|side| Box::new(|| (side.program.run)(black_box(&starts))) as Box<dyn Fn()>)
        .collect();
    let runs: Vec<&dyn Fn()> = runs.iter().map(AsRef::as_ref).collect();
    let times = in_turns(&runs, COUNT * STEPS, BUDGET);
    // from nanoseconds per step to million steps per second
    let speed = |nanoseconds: f64| 1e3 / nanoseconds;
    let mut rows = Vec::new();
    for (n, side) in sides.iter().enumerate() {
        let alone = sides::alone(&sides, side.number).ok_or("no trajectory alone")?;
        let rivals = (0..sides.len()).filter(|&k| sides[k].name == side.name && sides[k].number == side.number);
        rows.push(Row {
            side: side.title(),
            number: side.number,
            most: speed(times[n].least()),
            median: speed(times[n].median()),
            ratio: times[alone].over(&times[n]),
            ratio_of_most: times[alone].least() / times[n].least(),
            difference: differences[n],
            slower: rivals.into_iter().any(|k| times[k].least() < times[n].least()),
        });
    }
    for path in write::all(&Results { header, notes, rows }, &out)? {
        println!("{}", path.display());
    }
    Ok(())
}

/// Compares all final states with the ones of single trajectories: ours must agree bit for bit, others to the bound.
fn agree(sides: &[Side], starts: &[f64]) -> Result<Vec<f64>, String> {
    let mut differences = Vec::new();
    for side in sides {
        let alone = sides::alone(sides, side.number).ok_or("no trajectory alone")?;
        let expected = (sides[alone].program.value)(starts);
        let found = (side.program.value)(starts);
        let scale = expected.iter().fold(0.0_f64, |scale, entry| scale.max(entry.abs()));
        let worst =
            found.iter().zip(&expected).fold(
                0.0_f64,
                |worst, (a, b)| if (a - b).abs() <= worst { worst } else { (a - b).abs() },
            );
        let difference = worst / scale;
        let bound = if side.ours { 0.0 } else { BOUND };
        if found.len() != expected.len() || difference.is_nan() || difference > bound {
            return Err(format!(
                "{}, {}: ends differ by {difference:.1e}",
                side.title(),
                side.number
            ));
        }
        differences.push(difference);
    }
    Ok(differences)
}
