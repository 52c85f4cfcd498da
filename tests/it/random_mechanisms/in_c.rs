//! Emitted C against the numbers that the statements of the program give, bit for bit.

use std::fs;

use pendulum_codegen::program::Program;

use super::evaluate::{Evaluator, Place};
use crate::c_code::{ORDER, folder, results};

/// Whether C code computes the same in these places; none where no compiler is.
pub(super) fn same(name: &str, program: &Program, parameters: &[f64], places: &[Place]) -> Option<Result<(), String>> {
    let folder = folder(name)?;
    let evaluator = Evaluator::new(program, parameters);
    // also where everything is zero, of either sign
    let resting = [0.0, -0.0].map(|zero| Place {
        t: zero,
        state: vec![zero; program.layout.len()],
        accelerations: vec![zero; program.layout.dof()],
        inputs: vec![zero; program.inputs.len()],
    });
    let places = [places, &resting].concat();
    let given: Vec<Vec<f64>> = places.iter().map(Place::numbers).collect();
    let theirs = results(&folder, program, &pendulum_codegen::c(program), &given);
    for (place, theirs) in places.iter().zip(theirs) {
        let series = evaluator.series(place, ORDER).map(|series| series[1..].concat());
        let ours = [evaluator.all(place), series.unwrap_or_default()].concat();
        assert_eq!(ours.len(), theirs.len(), "every routine");
        let same = |ours: f64, theirs: f64| ours.to_bits() == theirs.to_bits() || ours.is_nan() && theirs.is_nan();
        if let Some(n) = ours
            .iter()
            .zip(&theirs)
            .position(|(ours, theirs)| !same(*ours, *theirs))
        {
            let (ours, theirs) = (ours[n], theirs[n]);
            return Some(Err(format!(
                "result {n} is {theirs:e} in C, not {ours:e}, at {place:?}"
            )));
        }
    }
    fs::remove_dir_all(folder).expect("a folder");
    Some(Ok(()))
}
