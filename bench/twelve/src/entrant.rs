//! Method of a library on a problem.

use std::hint::black_box;

use nalgebra::SVector;

use crate::flops::Flops;

/// Method of a library on a problem.
pub struct Entrant {
    pub by: &'static str,
    pub method: &'static str,
    /// Integrates from the start to the end, and returns the last end, or why it failed.
    pub integrate: Box<Integrate>,
}

pub type Integrate = dyn Fn(Request) -> Result<End, String>;

/// Integrations to make.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    /// Relative tolerance; the absolute one is that times [`Problem::absolute`](crate::Problem::absolute).
    pub tolerance: f64,
    /// Number of integrations in a row.
    pub times: usize,
    /// Number of [`output_times`].
    pub outputs: usize,
}

/// End of an integration.
#[derive(Clone, Debug)]
pub struct End {
    pub t: f64,
    pub x: Vec<f64>,
    /// Evaluations of the right-hand side, if the library counts them; of Taylor methods, series.
    pub evaluations: Option<usize>,
    /// Additions and multiplications of all evaluations and Jacobians, if the library counts them.
    pub operations: Option<f64>,
    /// States at the output times by dense output; none if the method has no dense output.
    pub along: Vec<Vec<f64>>,
}

/// Times at equal distances within a span from 0 to `t1`.
pub fn output_times(t1: f64, outputs: usize) -> Vec<f64> {
    let between = t1 / (outputs + 1) as f64;
    (1..=outputs).map(|n| n as f64 * between).collect()
}

/// Motion to integrate.
pub(crate) struct Motion<S, const N: usize> {
    pub model: S,
    pub x0: SVector<f64, N>,
    pub t1: f64,
    /// Absolute tolerance over the relative one.
    pub absolute: f64,
    pub flops: Flops,
}

pub(crate) type Task<S, const N: usize> = &'static Motion<S, N>;

/// [`End`] of a state whose length is known.
pub(crate) struct Reached<const N: usize> {
    pub t: f64,
    pub x: [f64; N],
    pub evaluations: Option<usize>,
    pub operations: Option<f64>,
    pub along: Vec<[f64; N]>,
}

impl Entrant {
    /// Makes an entrant from a function that integrates once to `t1`, with a tolerance and output times.
    pub(crate) fn new<const N: usize>(
        by: &'static str,
        method: &'static str,
        t1: f64,
        once: impl Fn(f64, &[f64]) -> Result<Reached<N>, String> + 'static,
    ) -> Self {
        let integrate = move |request: Request| {
            let outputs = output_times(t1, request.outputs);
            for _ in 1..request.times {
                black_box(once(black_box(request.tolerance), &outputs)?);
            }
            let reached = once(black_box(request.tolerance), &outputs)?;
            Ok(End {
                t: reached.t,
                x: reached.x.to_vec(),
                evaluations: reached.evaluations,
                operations: reached.operations,
                along: reached.along.iter().map(|x| x.to_vec()).collect(),
            })
        };
        Self {
            by,
            method,
            integrate: Box::new(integrate),
        }
    }
}

/// The first of the output times that has no state yet, if it is at most `t`.
pub(crate) fn due<X>(outputs: &[f64], along: &[X], t: f64) -> Option<f64> {
    outputs.get(along.len()).copied().filter(|&output| output <= t)
}
