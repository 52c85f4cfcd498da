//! Growth of the generator's time and of its code with the number of joints, for planar and spatial chains.

mod results;
mod write;

use std::error::Error;
use std::hint::black_box;
use std::path::Path;
use std::time::Duration;

use pendulum_codegen::program::Cost;
use results::{Counted, Results, Robot, Row};

use crate::generated::Declaration;
use crate::library;
use crate::machine;
use crate::rust::{Processors, Rust};
use crate::timing::in_turns;
use testbed::chains::{planar, spatial};

const LENGTHS: std::ops::RangeInclusive<usize> = 2..=12;
/// Generated functions: the `generate` list, the function that is measured, and its title.
pub(crate) const FUNCTIONS: [(&str, &str, &str); 2] = [
    ("rhs", "rhs", "right-hand side"),
    ("rhs, jacobian", "jacobian", "with Jacobian"),
];
/// Time budgets per scene for repeated expansion and for repeated compilation.
const BUDGETS: [Duration; 2] = [Duration::from_secs(2), Duration::from_secs(3)];
/// Time budget for all evaluations, in turn.
const TURNS: Duration = Duration::from_secs(30);
/// Number of states evaluated one after another.
const STATES: usize = 64;

const ROBOTS: &str = testbed::source::ROBOTS;

pub(crate) fn measure() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let out = root.join("out");
    let rust = Rust::new(root, &out.join("build"), Processors::This)?;
    let (mut rows, mut runs) = (Vec::new(), Vec::new());
    for (chain, declare) in [("planar", planar as fn(usize, &str) -> String), ("spatial", spatial)] {
        for (generate, function, title) in FUNCTIONS {
            for n in LENGTHS {
                let declaration = Declaration {
                    name: "Chain".to_owned(),
                    text: declare(n, generate),
                    parameters: match chain {
                        "planar" => vec![("g", 9.81), ("m", 1.0), ("c", 0.1)],
                        _ => Vec::new(),
                    },
                };
                let (row, run) = row(&rust, &declaration, (chain, n), (function, title))?;
                println!(
                    "{chain}, {n}, {title}: {} operations, expanded in {:.3} s, compiled in {:.2} s",
                    row.operations, row.expansion, row.compilation
                );
                rows.push(row);
                runs.push(run);
            }
        }
    }
    let calls: Vec<&dyn Fn()> = runs.iter().map(AsRef::as_ref).collect();
    for (row, times) in rows.iter_mut().zip(in_turns(&calls, STATES, TURNS)) {
        row.nanoseconds = times.least();
    }
    let robots = [("Ur5", "UR5"), ("Panda", "Panda")]
        .into_iter()
        .map(|(name, title)| robot(&rust, name, title))
        .collect::<Result<_, _>>()?;
    let header = machine::describe();
    for path in write::all(&Results { header, rows, robots }, &out)? {
        println!("{}", path.display());
    }
    Ok(())
}

/// Evaluates some states.
type Run = Box<dyn Fn()>;

/// A row without the evaluation time, and a function that evaluates some states.
fn row(
    rust: &Rust,
    declaration: &Declaration,
    (chain, n): (&'static str, usize),
    (function, title): (&str, &'static str),
) -> Result<(Row, Run), Box<dyn Error>> {
    let program = declaration.program()?;
    let cost = &program.routine(function).ok_or("a routine is missing")?.cost;
    let (items, expansion) = declaration.expand(BUDGETS[0])?;
    let wanted: Vec<&str> = program.routines.iter().map(|routine| routine.name.as_str()).collect();
    let source = declaration.source(&items, &wanted);
    let name = format!("{chain}_{n}_{}", function);
    let (library, compilation) = declaration.compile(rust, &name, &source, BUDGETS[1])?;
    let states: Vec<f64> = (0..2 * n * STATES).map(|k| (0.37 * k as f64).sin()).collect();
    let results = if function == "rhs" { 2 * n } else { 4 * n * n };
    let program = library::load(&library, function, 2 * n, results)?;
    let row = Row {
        chain,
        joints: n,
        function: title,
        form: cost.form.clone(),
        operations: cost.operations.additions + cost.operations.multiplications,
        divisions: cost.operations.divisions,
        bases: bases(cost),
        expansion: expansion.as_secs_f64(),
        compilation: compilation.as_secs_f64(),
        nanoseconds: f64::NAN,
    };
    Ok((row, Box::new(move || (program.run)(black_box(&states)))))
}

/// Prefixes of the names of forms.
const BASES: [&str; 4] = ["closed form", "A, B and C", "recursion", "articulated bodies"];

/// Additions and multiplications of the best form on each basis; all closed forms are one basis.
fn bases(cost: &Cost) -> Vec<Counted> {
    let mut bases: Vec<Counted> = Vec::new();
    for Cost { form, operations, .. } in std::iter::once(cost).chain(&cost.others) {
        let Some(basis) = BASES.into_iter().find(|basis| form.starts_with(basis)) else {
            continue;
        };
        // They are sorted, the shortest first.
        if bases.iter().all(|known| known.basis != basis) {
            bases.push(Counted {
                basis,
                operations: operations.additions + operations.multiplications,
            });
        }
    }
    bases
}

/// Times of a robot with Jacobian: by separate steps, and by one call of the compiler including the macro.
fn robot(rust: &Rust, name: &str, title: &'static str) -> Result<Robot, Box<dyn Error>> {
    let declaration = Declaration::read(ROBOTS, name, "rhs, jacobian")?;
    let (items, expansion) = declaration.expand(4 * BUDGETS[0])?;
    let functions = FUNCTIONS.map(|(_, function, _)| function);
    let budget = 4 * BUDGETS[1];
    let source = declaration.source(&items, &functions);
    let (_, compilation) = declaration.compile(rust, &name.to_lowercase(), &source, budget)?;
    let call = format!("pendulum_core::mechanism! {{ {} }}", declaration.text);
    let source = declaration.source(&call, &functions);
    let (_, together) = declaration.compile(rust, &format!("{}_macro", name.to_lowercase()), &source, budget)?;
    Ok(Robot {
        name: title,
        expansion: expansion.as_secs_f64(),
        compilation: compilation.as_secs_f64(),
        together: together.as_secs_f64(),
    })
}
