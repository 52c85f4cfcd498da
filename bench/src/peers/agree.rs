//! Check before the timing that all candidates give the same results.

use super::candidate::{Candidate, Function, MODELS, OURS};
use super::contest::states;

/// Maximum difference relative to the largest entry of a result: rounding of some ten thousand operations.
const TOLERANCE: f64 = 1e-9;
/// Number of states of each model.
const SAMPLES: usize = 64;

/// Returns the largest difference from the generated code, or an error for a candidate that differs too much.
pub(crate) fn check(candidates: &[Candidate]) -> Result<f64, String> {
    let mut worst = 0.0_f64;
    for (model, _) in MODELS {
        for &function in Function::of(model) {
            worst = worst.max(largest(candidates, model, function)?);
        }
    }
    Ok(worst)
}

/// Returns the largest difference for one function of one model.
fn largest(candidates: &[Candidate], model: &str, function: Function) -> Result<f64, String> {
    let of = |function| {
        candidates
            .iter()
            .filter(move |candidate| candidate.model == model && candidate.function == function)
    };
    // Compare accelerations without Jacobian with those of the combined function.
    let whole = match function {
        Function::Rhs if Function::of(model).contains(&Function::Jacobian) => Function::Jacobian,
        _ => function,
    };
    let what = function.title();
    let reference = of(whole)
        .find(|candidate| candidate.peer == OURS)
        .ok_or_else(|| format!("{model}, {what}: there is no reference"))?;
    let (length, all) = states(model, SAMPLES)?;
    let (values, by) = function.shape(length / 2);
    let mut worst = 0.0_f64;
    // Two states at a time: in sequence the second depends on the result of the first.
    for x in all.chunks_exact(2 * length) {
        let expected = (reference.program.value)(x);
        let (first, derivatives) = expected[..values * (1 + by)].split_at(values);
        for candidate in of(function) {
            let error = difference(&(candidate.program.value)(x), &[first, derivatives]);
            if error.is_nan() || error > TOLERANCE {
                let Candidate { peer, form, order, .. } = candidate;
                let order = order.title();
                return Err(format!(
                    "{model}, {what}, {order}: {peer} ({form}) differs by {error:.1e} at {x:?}"
                ));
            }
            worst = worst.max(error);
        }
    }
    Ok(worst)
}

/// The larger of the relative differences of the two parts; infinite if the lengths differ, NaN if an entry is.
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
