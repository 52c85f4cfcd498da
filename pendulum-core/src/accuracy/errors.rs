//! Norms of errors.

use nalgebra::SVector;

use super::reference::{distance, larger};
use crate::accuracy::Reference;
use crate::solution::Solution;

/// Errors of a solution: each the maximum over the components of the state, in their units. The energy error is in
/// units of a given scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Error at the end of the span.
    pub last: f64,
    /// Largest error at the accepted points. `None` if the reference or the method has no states there.
    pub largest: Option<f64>,
    /// Largest error of the dense output, sampled at eight times within each step and at the isolated points of the
    /// reference. `None` under the same conditions as [`largest`](Self::largest).
    pub dense: Option<f64>,
    /// Largest difference in energy from the reference at the accepted points. `None` under the same conditions as
    /// [`largest`](Self::largest), and if the system has no energy or no scale was given.
    pub energy: Option<f64>,
}

/// Number of samples of the dense output per step.
const WITHIN: u32 = 8;

impl Errors {
    /// Computes the errors of `solution`. Returns `None` if the reference does not cover its end.
    #[must_use]
    pub fn of<const N: usize>(solution: &Solution<f64, N>, reference: &Reference<'_, N>) -> Option<Self> {
        let (end, x) = solution.last();
        Some(Self {
            largest: along(solution, reference, |_, x, known| distance(x, known)),
            dense: dense(solution, reference),
            ..Self::at_end(end, &x, reference)?
        })
    }

    /// Computes the error of a final state only.
    pub(super) fn at_end<const N: usize>(t: f64, x: &SVector<f64, N>, reference: &Reference<'_, N>) -> Option<Self> {
        Some(Self {
            last: distance(x, &reference.at(t)?),
            largest: None,
            dense: None,
            energy: None,
        })
    }

    /// Adds the energy error, in units of `scale`.
    ///
    /// `energy(t, x)` is the energy of the system ([`Energy`](crate::Energy)) or another quantity of interest. A
    /// suitable scale is the energy exchanged in the motion: the peak kinetic energy, or weight times height of fall.
    #[must_use]
    pub fn with_energy<const N: usize>(
        mut self,
        solution: &Solution<f64, N>,
        reference: &Reference<'_, N>,
        energy: impl Fn(f64, &SVector<f64, N>) -> f64,
        scale: f64,
    ) -> Self {
        self.energy = along(solution, reference, |t, x, known| {
            (energy(t, x) - energy(t, known)).abs() / scale
        });
        self
    }
}

/// Largest difference at the accepted points, or `None` if the reference does not cover all of them.
fn along<const N: usize>(
    solution: &Solution<f64, N>,
    reference: &Reference<'_, N>,
    difference: impl Fn(f64, &SVector<f64, N>, &SVector<f64, N>) -> f64,
) -> Option<f64> {
    solution.points().try_fold(0.0, |largest, (t, x)| {
        Some(larger(largest, difference(t, x, &reference.at(t)?)))
    })
}

/// Largest error of the dense output.
fn dense<const N: usize>(solution: &Solution<f64, N>, reference: &Reference<'_, N>) -> Option<f64> {
    let steps = if reference.is_curve() { solution.t() } else { &[] };
    let within = steps.windows(2).filter(|ends| ends[0] != ends[1]).flat_map(|ends| {
        let time = |n: u32| ends[0] + (ends[1] - ends[0]) * (f64::from(n) + 0.5) / f64::from(WITHIN);
        (0..WITHIN).map(time)
    });
    let mut largest = None;
    for t in within.chain(reference.times()) {
        if let Ok(x) = solution.at(t) {
            let error = distance(&x, &reference.at(t)?);
            largest = Some(larger(error, largest.unwrap_or(0.0)));
        }
    }
    largest
}
