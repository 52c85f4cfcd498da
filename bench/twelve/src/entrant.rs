//! Method of a library on a problem.

use std::hint::black_box;

use nalgebra::SVector;

/// Method of a library on a problem.
pub struct Entrant {
    pub by: &'static str,
    pub method: &'static str,
    /// Integrates from the start to the end with a relative tolerance as often as told, and returns the last end, or why
    /// it failed. The absolute tolerance is that times [`Problem::absolute`](crate::Problem::absolute).
    pub integrate: Box<Integrate>,
}

pub type Integrate = dyn Fn(f64, usize) -> Result<End, String>;

/// End of an integration.
#[derive(Clone, Debug)]
pub struct End {
    pub t: f64,
    pub x: Vec<f64>,
    /// Evaluations of the right-hand side, if the library counts them.
    pub evaluations: Option<usize>,
}

/// Motion to integrate.
pub(crate) struct Motion<S, const N: usize> {
    pub model: S,
    pub x0: SVector<f64, N>,
    pub t1: f64,
    /// Absolute tolerance over the relative one.
    pub absolute: f64,
}

pub(crate) type Task<S, const N: usize> = &'static Motion<S, N>;

/// Time and state at the end, and the number of evaluations.
pub(crate) type Reached<const N: usize> = (f64, [f64; N], Option<usize>);

impl Entrant {
    /// Makes an entrant from a function that integrates once.
    pub(crate) fn new<const N: usize>(
        by: &'static str,
        method: &'static str,
        once: impl Fn(f64) -> Result<Reached<N>, String> + 'static,
    ) -> Self {
        let integrate = move |tolerance: f64, times: usize| {
            for _ in 1..times {
                black_box(once(black_box(tolerance))?);
            }
            let (t, x, evaluations) = once(black_box(tolerance))?;
            let x = x.to_vec();
            Ok(End { t, x, evaluations })
        };
        Self {
            by,
            method,
            integrate: Box::new(integrate),
        }
    }
}
