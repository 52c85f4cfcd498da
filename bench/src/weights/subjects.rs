//! Generated functions to be timed.

use std::error::Error;
use std::path::PathBuf;

use pendulum_codegen::program::Operations;

use super::STATES;
use crate::generated::Declaration;
use crate::library::{self, Program};
use crate::rust::Rust;
use testbed::chains::{planar, spatial};
use testbed::source::{MECHANISMS, ROBOTS, SCENES};

/// Compiled model.
pub(crate) struct Subject {
    pub name: String,
    pub dof: usize,
    pub states: Vec<f64>,
    rhs: Operations,
    jacobian: Operations,
    library: PathBuf,
}

/// Operations of a function that are replaced by cheap ones: this isolates their cost better than a comparison with
/// other functions.
#[derive(Clone, Copy)]
pub(crate) struct Variant {
    pub symbol: &'static str,
    pub sines: bool,
    pub divisions: bool,
}

pub(crate) const VARIANTS: [Variant; 4] = [
    variant("both", true, true),
    variant("divisions", false, true),
    variant("sines", true, false),
    variant("neither", false, false),
];

const fn variant(symbol: &'static str, sines: bool, divisions: bool) -> Variant {
    Variant {
        symbol,
        sines,
        divisions,
    }
}

/// Maximum number of joints for Jacobians, as larger ones take long to compile four times.
const LARGEST_JACOBIAN: usize = 6;

impl Subject {
    /// Operation counts of the right-hand side or of the Jacobian, if it is timed.
    pub(crate) fn operations(&self, jacobian: bool) -> Option<Operations> {
        match jacobian {
            false => Some(self.rhs),
            true => (self.dof <= LARGEST_JACOBIAN).then_some(self.jacobian),
        }
    }

    pub(crate) fn load(&self, symbol: &str) -> Result<Program, Box<dyn Error>> {
        library::load(&self.library, symbol, 2 * self.dof, 0)
    }
}

pub(crate) fn all(rust: &Rust) -> Result<Vec<Subject>, Box<dyn Error>> {
    let generate = "rhs, jacobian";
    let mut declarations = Vec::new();
    for (source, names) in [
        (SCENES, &["DoublePendulum"][..]),
        (
            MECHANISMS,
            &[
                "Eq22Joint",
                "IrregularPlates",
                "Chain5",
                "CartPole",
                "Furuta",
                "ScrewJoint",
                "Elbow3",
                "Tree",
                "SpringPendulumRig",
            ],
        ),
        (ROBOTS, &["Ur5", "Panda"]),
    ] {
        for name in names {
            declarations.push(((*name).to_owned(), Declaration::read(source, name, generate)?));
        }
    }
    for n in 3..=8 {
        for (chain, declare) in [("planar", planar as fn(usize, &str) -> String), ("spatial", spatial)] {
            let parameters = match chain {
                "planar" => vec![("g", 9.81), ("m", 1.0), ("c", 0.1)],
                _ => Vec::new(),
            };
            let declaration = Declaration {
                name: "Chain".to_owned(),
                text: declare(n, generate),
                parameters,
            };
            declarations.push((format!("{chain}{n}"), declaration));
        }
    }
    declarations
        .into_iter()
        .map(|(name, declaration)| {
            println!("compiling {name}");
            subject(rust, name, &declaration)
        })
        .collect()
}

fn subject(rust: &Rust, name: String, declaration: &Declaration) -> Result<Subject, Box<dyn Error>> {
    let program = declaration.program()?;
    let operations = |routine| {
        let routine = program.routine(routine).ok_or("a routine is missing")?;
        Ok::<Operations, &str>(routine.cost.operations)
    };
    let items = declaration.expand(std::time::Duration::ZERO)?.0;
    let loops = [
        include_str!("../../peers/ours/src/cheap.rs"),
        include_str!("../../weights/loops.rs"),
    ]
    .map(without_head);
    let source = declaration.source(&items, &[]) + &format!("mod cheap {{ {} }}\n{}", loops[0], loops[1]);
    let (library, _) = rust.library(&format!("weights_{}", name.to_lowercase()), &source)?;
    let dof = program.layout.dof();
    Ok(Subject {
        dof,
        states: (0..2 * dof * STATES).map(|k| (0.37 * k as f64).sin()).collect(),
        rhs: operations("rhs")?,
        jacobian: operations("jacobian")?,
        library,
        name,
    })
}

/// Removes lines that are allowed only at the start of a file.
fn without_head(text: &str) -> String {
    text.lines()
        .filter(|line| !line.starts_with("//!"))
        .collect::<Vec<_>>()
        .join("\n")
}
