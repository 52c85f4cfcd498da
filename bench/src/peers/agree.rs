//! Before anything is timed, all must give the same results.

use super::candidate::{Candidate, Function, MODELS, OURS};
use super::contest::states;

/// Of the largest entry of a result: rounding of some ten thousand operations.
const TOLERANCE: f64 = 1e-9;
/// States of each model.
const SAMPLES: usize = 64;

/// The largest difference from the generated code, or which candidate differs from it by too much.
pub(crate) fn check(candidates: &[Candidate]) -> Result<f64, String> {
    let mut worst = 0.0_f64;
    for (model, _) in MODELS {
        let of_model = || candidates.iter().filter(move |candidate| candidate.model == model);
        let reference = of_model()
            .find(|candidate| candidate.peer == OURS && candidate.function == Function::Jacobian)
            .ok_or_else(|| format!("{model} has no reference"))?;
        let (length, all) = states(model, SAMPLES)?;
        for x in all.chunks_exact(length) {
            let expected = (reference.program.value)(x);
            let (rhs, derivatives) = expected.split_at(length / 2);
            for candidate in of_model() {
                let expected = match candidate.function {
                    Function::Rhs => [rhs, &[]],
                    Function::Jacobian => [rhs, derivatives],
                };
                let found = (candidate.program.value)(x);
                let error = difference(&found, &expected);
                if error.is_nan() || error > TOLERANCE {
                    let Candidate {
                        peer, form, function, ..
                    } = candidate;
                    let what = function.title();
                    return Err(format!(
                        "{model}, {what}: {peer} ({form}) differs by {error:.1e} at {x:?}"
                    ));
                }
                worst = worst.max(error);
            }
        }
    }
    Ok(worst)
}

/// The larger of the relative differences of the two parts; infinite where the lengths differ, NaN where an entry is.
fn difference(found: &[f64], expected: &[&[f64]; 2]) -> f64 {
    if found.len() != expected[0].len() + expected[1].len() {
        return f64::INFINITY;
    }
    let (first, second) = found.split_at(expected[0].len());
    let part = |found: &[f64], expected: &[f64]| {
        let scale = expected
            .iter()
            .fold(f64::MIN_POSITIVE, |scale, entry| entry.abs().max(scale));
        let worst = |worst: f64, (a, b): (&f64, &f64)| if (a - b).abs() <= worst { worst } else { (a - b).abs() };
        found.iter().zip(expected).fold(0.0, worst) / scale
    };
    let (a, b) = (part(first, expected[0]), part(second, expected[1]));
    if a.is_nan() || a > b { a } else { b }
}
