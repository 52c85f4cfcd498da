//! Least-squares fit of the time of each kind of operation.

use nalgebra::{Matrix4, Vector4};
use pendulum_codegen::program::Operations;
use serde::Serialize;

use super::subjects::Variant;

/// Timed function with its operations as executed: replacements of a division or a sine-cosine pair are counted as
/// such.
#[derive(Serialize)]
pub(crate) struct Sample {
    pub mode: &'static str,
    pub subject: String,
    pub variant: &'static str,
    pub flops: usize,
    pub divisions: usize,
    pub sincos: usize,
    pub nanoseconds: f64,
}

impl Sample {
    pub(crate) fn new(mode: &'static str, subject: &str, operations: Operations, variant: Variant) -> Self {
        let Operations {
            additions,
            multiplications,
            divisions,
            sincos,
            ..
        } = operations;
        let replaced = if variant.divisions { 0 } else { divisions } + if variant.sines { 0 } else { 2 * sincos };
        Self {
            mode,
            subject: subject.to_owned(),
            variant: variant.symbol,
            flops: additions + multiplications + replaced,
            divisions: if variant.divisions { divisions } else { 0 },
            sincos: if variant.sines { sincos } else { 0 },
            nanoseconds: f64::NAN,
        }
    }

    fn counts(&self) -> Vector4<f64> {
        Vector4::new(self.flops as f64, self.divisions as f64, self.sincos as f64, 1.0)
    }
}

/// Fitted times: an addition or multiplication in nanoseconds, the other operations in units of it.
#[derive(Serialize)]
pub(crate) struct Fit {
    pub mode: &'static str,
    pub functions: usize,
    pub addition: f64,
    pub division: Weight,
    pub sincos: Weight,
    /// Overhead of a call, in nanoseconds.
    pub constant: f64,
    /// Root mean square of the relative errors.
    pub error: f64,
}

#[derive(Serialize)]
pub(crate) struct Weight {
    pub value: f64,
    /// Minimum and maximum of the fits that leave out one model each.
    pub range: [f64; 2],
}

impl Fit {
    /// Fits relative errors, so that the large functions do not dominate.
    pub(crate) fn new(mode: &'static str, samples: &[&Sample]) -> Result<Self, String> {
        let all = solve(samples)?;
        let mut subjects: Vec<&str> = samples.iter().map(|sample| sample.subject.as_str()).collect();
        subjects.dedup();
        let mut without = Vec::new();
        for subject in subjects {
            let rest: Vec<&Sample> = samples
                .iter()
                .copied()
                .filter(|sample| sample.subject != subject)
                .collect();
            without.push(solve(&rest)?);
        }
        let weight = |k: usize| {
            let values = || without.iter().map(|times| times[k] / times[0]);
            Weight {
                value: all[k] / all[0],
                range: [
                    values().fold(f64::INFINITY, f64::min),
                    values().fold(f64::NEG_INFINITY, f64::max),
                ],
            }
        };
        let errors = samples
            .iter()
            .map(|sample| all.dot(&sample.counts()) / sample.nanoseconds - 1.0);
        let error = (errors.map(|error| error * error).sum::<f64>() / samples.len() as f64).sqrt();
        Ok(Self {
            mode,
            functions: samples.len(),
            addition: all[0],
            division: weight(1),
            sincos: weight(2),
            constant: all[3],
            error,
        })
    }
}

fn solve(samples: &[&Sample]) -> Result<Vector4<f64>, String> {
    let (mut matrix, mut right) = (Matrix4::zeros(), Vector4::zeros());
    for sample in samples {
        let row = sample.counts() / sample.nanoseconds;
        matrix += row * row.transpose();
        right += row;
    }
    matrix
        .try_inverse()
        .map(|inverse| inverse * right)
        .ok_or_else(|| "the counts do not tell the operations apart".to_owned())
}
