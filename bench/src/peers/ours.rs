//! The generated code, and hand-written code, in the libraries of the package `ours`.

use std::error::Error;
use std::path::Path;

use ours::{Solo, Xarm7};
use pendulum_core::{Cost, FunctionCost};
use testbed::robots::{Panda, Ur5, Ur5Flange};
use testbed::scenes::DoublePendulum;

use super::candidate::{BATCH, BY_HAND, Candidate, FUSED, Function, OURS, Order, PLAIN};
use super::entrants::sizes;
use crate::library::load;
use crate::rust::{Processors, package};

const COSTS: [(&str, Cost); 5] = [
    ("eq22", DoublePendulum::COST),
    ("ur5", Ur5::COST),
    ("panda", Panda::COST),
    ("xarm7", Xarm7::COST),
    ("solo", Solo::COST),
];

pub(crate) fn candidates(root: &Path, build: &Path) -> Result<Vec<Candidate>, Box<dyn Error>> {
    let mut all = Vec::new();
    for processors in [Processors::This, Processors::All] {
        // endings of symbols, and names
        let entrants: &[(&str, &str)] = match processors {
            Processors::This => &[("", OURS)],
            Processors::All => &[("", PLAIN), ("_fused", FUSED), ("_batch", BATCH)],
        };
        let library = package(&root.join("peers/ours"), build, processors)?;
        for (model, cost) in COSTS {
            for &function in Function::of(model) {
                let cost = match function {
                    Function::Rhs => cost["rhs"],
                    Function::Jacobian => cost["jacobian"],
                    Function::Point => Ur5Flange::COST["flange_and_jacobian"],
                };
                let is_entered = |peer: &str| peer != BATCH || function != Function::Point;
                for &(ending, peer) in entrants.iter().filter(|(_, peer)| is_entered(peer)) {
                    let code = format!("{model}_{}{ending}", function.name());
                    add(&mut all, &library, &code, model, function, peer, Some(cost))?;
                }
            }
        }
        if processors == Processors::This {
            for &function in Function::of("eq22") {
                let code = format!("by_hand_{}", function.name());
                add(&mut all, &library, &code, "eq22", function, BY_HAND, None)?;
            }
        }
    }
    Ok(all)
}

/// Adds a function in both orders, or in the only one; `code` is the name of its symbol for states side by side.
fn add(
    all: &mut Vec<Candidate>,
    library: &Path,
    code: &str,
    model: &str,
    function: Function,
    peer: &str,
    cost: Option<FunctionCost>,
) -> Result<(), Box<dyn Error>> {
    let (states, results) = sizes(model, function)?;
    let program = |ending| load(library, &format!("{code}{ending}"), states, results);
    for order in Order::ALL {
        let (ending, cheap) = match order {
            Order::SideBySide if [FUSED, BATCH].contains(&peer) => ("", None),
            Order::SideBySide => ("", Some(program("_cheap")?)),
            Order::InSequence if peer == BATCH => continue,
            Order::InSequence => ("_in_sequence", None),
        };
        all.push(Candidate {
            model: model.to_owned(),
            function,
            order,
            peer: peer.to_owned(),
            form: cost.map_or(String::new(), |cost| cost.form.to_owned()),
            operations: cost.map(|cost| cost.operations),
            program: program(ending)?,
            cheap,
            job: None,
        });
    }
    Ok(())
}
