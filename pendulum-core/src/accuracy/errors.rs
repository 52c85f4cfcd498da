//! Norms of errors.

use nalgebra::SVector;

use crate::accuracy::Reference;
use crate::solution::Solution;

/// The errors of a solution: of the largest component of the state each, in its units; the energy's in units of a given scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// At the end of the span.
    pub last: f64,
    /// The largest at the accepted points; `None` where the reference, or the method, has no states there.
    pub largest: Option<f64>,
    /// The largest of the dense output, at eight times within each step and at the points that the reference has by themselves;
    /// `None` as above.
    pub dense: Option<f64>,
    /// The largest difference of the energy from that of the reference at the accepted points; `None` as above, and where the system has
    /// no energy or no scale was given.
    pub energy: Option<f64>,
}

/// At how many times within a step the dense output is compared.
const WITHIN: u32 = 8;

impl Errors {
    /// The errors of `solution`, or `None` where the reference does not know its end.
    #[must_use]
    pub fn of<const N: usize>(solution: &Solution<f64, N>, reference: &Reference<'_, N>) -> Option<Self> {
        let (end, x) = solution.last();
        Some(Self {
            largest: along(solution, reference, |_, x, known| distance(x, known)),
            dense: dense(solution, reference),
            ..Self::at_end(end, &x, reference)?
        })
    }

    /// The error of a final state alone.
    pub(super) fn at_end<const N: usize>(t: f64, x: &SVector<f64, N>, reference: &Reference<'_, N>) -> Option<Self> {
        Some(Self {
            last: distance(x, &reference.at(t)?),
            largest: None,
            dense: None,
            energy: None,
        })
    }

    /// The same errors and that of the energy, in units of `scale`.
    ///
    /// `energy(t, x)` is that of [`Energy`](crate::Energy), or another quantity of interest. Take as its scale what the motion turns over: the kinetic
    /// energy of its fastest moment, or the height it falls through times its weight.
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

/// The larger of two numbers; infinite if one is none, which must not pass for a small one.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::INFINITY
    } else {
        a.max(b)
    }
}

/// The largest difference of a component.
pub(super) fn distance<const N: usize>(a: &SVector<f64, N>, b: &SVector<f64, N>) -> f64 {
    (a - b)
        .iter()
        .fold(0.0, |largest, difference| larger(largest, difference.abs()))
}

/// The largest difference at the accepted points, if the reference knows them all.
fn along<const N: usize>(
    solution: &Solution<f64, N>,
    reference: &Reference<'_, N>,
    difference: impl Fn(f64, &SVector<f64, N>, &SVector<f64, N>) -> f64,
) -> Option<f64> {
    solution.points().try_fold(0.0, |largest, (t, x)| {
        Some(larger(largest, difference(t, x, &reference.at(t)?)))
    })
}

/// The largest error of the dense output.
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
