//! Emitted C code against the values of the program's statements, bit for bit.

use std::fs;

use pendulum_codegen::program::Program;

use super::evaluate::{Evaluator, Place};
use crate::c_code::{ORDER, folder, results};

/// Compares the results at these places and at rest. Returns false if there is no compiler.
///
/// # Errors
/// Returns the first result that differs.
pub(super) fn same(name: &str, program: &Program, parameters: &[f64], places: &[Place]) -> Result<bool, String> {
    let Some(folder) = folder(name) else {
        return Ok(false);
    };
    let resting = [0.0, -0.0].map(|zero| Place {
        t: zero,
        state: vec![zero; program.layout.len()],
        accelerations: vec![zero; program.layout.dof()],
        inputs: vec![zero; program.inputs.len()],
    });
    let places = [places, &resting].concat();
    let given: Vec<Vec<f64>> = places.iter().map(Place::numbers).collect();
    let evaluator = Evaluator::new(program, parameters);
    let of_c = results(&folder, program, &pendulum_codegen::c(program), &given);
    for (place, of_c) in places.iter().zip(of_c) {
        let series = evaluator.series(place, ORDER).map(|series| series[1..].concat());
        let own = [evaluator.all(place), series.unwrap_or_default()].concat();
        assert_eq!(own.len(), of_c.len(), "every routine");
        for (n, (own, of_c)) in own.into_iter().zip(of_c).enumerate() {
            if own.to_bits() != of_c.to_bits() && !(own.is_nan() && of_c.is_nan()) {
                return Err(format!("result {n} is {of_c:e} in C, not {own:e}, at {place:?}"));
            }
        }
    }
    fs::remove_dir_all(folder).expect("a folder");
    Ok(true)
}
