//! Reference solutions.

use std::fmt;

use nalgebra::SVector;

use crate::error::SolveError;
use crate::method::{Method, Vern7, Vern9};
use crate::solution::{OutsideSpan, Solution};
use crate::system::{IntoState, System};

/// A reference solution with an estimate of its own uncertainty.
///
/// The reference is a function, a computed solution, or a set of points; [`with_points`](Self::with_points) adds points
/// of higher accuracy.
pub struct Reference<'a, const N: usize> {
    curve: Option<ReferenceCurve<'a, N>>,
    /// Points at which the state is more accurate than the curve.
    points: Vec<(f64, SVector<f64, N>)>,
    uncertainty: Uncertainty,
}

/// Solution between the points.
enum ReferenceCurve<'a, const N: usize> {
    Function(Box<dyn Fn(f64) -> SVector<f64, N> + 'a>),
    Solution(Box<Solution<f64, N>>),
}

/// Bounds on the error of the largest component of the state.
#[derive(Clone, Copy, Debug, Default)]
struct Uncertainty {
    curve: f64,
    points: f64,
}

impl<'a, const N: usize> Reference<'a, N> {
    /// An exact solution as a function of time. Its uncertainty is set to 0; rounding of the function is not counted.
    pub fn exact(function: impl Fn(f64) -> SVector<f64, N> + 'a) -> Self {
        Self::along(ReferenceCurve::Function(Box::new(function)), 0.0)
    }

    /// States at isolated times, for example published values, with the largest error of their components. The
    /// reference is undefined between them.
    pub fn points(points: impl IntoIterator<Item = (f64, SVector<f64, N>)>, uncertainty: f64) -> Self {
        Self {
            curve: None,
            points: points.into_iter().collect(),
            uncertainty: Uncertainty {
                curve: f64::INFINITY,
                points: uncertainty,
            },
        }
    }

    /// The solution `best`, with an uncertainty estimated by comparison with `other`. Compute `other` with a different
    /// tolerance or, better, a different method.
    ///
    /// The uncertainty is the largest component of their difference at the accepted points of `other`, where `best` is
    /// interpolated. Errors common to both go undetected.
    ///
    /// # Errors
    /// If they do not cover the same span.
    pub fn solutions(best: Solution<f64, N>, other: &Solution<f64, N>) -> Result<Self, OutsideSpan> {
        other.sample([best.t()[0], best.last().0])?;
        let mut uncertainty = 0.0_f64;
        for (t, x) in other.points() {
            uncertainty = uncertainty.max(distance(&best.at(t)?, x));
        }
        Ok(Self::along(ReferenceCurve::Solution(Box::new(best)), uncertainty))
    }

    /// The solution of [`Vern7`] from the state `x0` at `t0` to `t1` with tolerances of 1e-14, with an uncertainty
    /// estimated by comparison with [`Vern9`].
    ///
    /// These explicit methods are slow on stiff systems: compute two solutions with implicit methods and call
    /// [`solutions`](Self::solutions) instead.
    ///
    /// # Errors
    /// See [`Method::solve`].
    pub fn integrate(
        system: &impl System<f64, N>,
        t0: f64,
        t1: f64,
        x0: impl IntoState<f64, N>,
    ) -> Result<Self, SolveError<f64, N>> {
        let x0 = x0.into_state();
        // The dense output of order 9 has large weights of both signs and amplifies rounding errors about a
        // hundredfold, so the order-7 solution is the one to interpolate.
        let best = Vern7::new().rtol(TIGHT).atol(TIGHT).solve(system, t0, t1, x0)?;
        let other = Vern9::new().rtol(TIGHT).atol(TIGHT).solve(system, t0, t1, x0)?;
        Ok(Self::solutions(best, &other).expect("both go from t0 to t1"))
    }

    /// Adds points of higher accuracy. At their times they replace the curve, with their own uncertainty.
    #[must_use]
    pub fn with_points(mut self, points: impl IntoIterator<Item = (f64, SVector<f64, N>)>, uncertainty: f64) -> Self {
        self.points = points.into_iter().collect();
        self.uncertainty.points = uncertainty;
        self
    }

    /// State at the time `t`, or `None` if the reference does not cover `t`.
    #[must_use]
    pub fn at(&self, t: f64) -> Option<SVector<f64, N>> {
        self.point(t).copied().or_else(|| match &self.curve {
            Some(ReferenceCurve::Function(function)) => Some(function(t)),
            Some(ReferenceCurve::Solution(solution)) => solution.at(t).ok(),
            None => None,
        })
    }

    /// Error bound for the largest component of the state at the time `t`, in the units of the state; infinite if the
    /// reference does not cover `t`. Measured errors are meaningful only well above this bound.
    #[must_use]
    pub fn uncertainty(&self, t: f64) -> f64 {
        match (self.point(t), self.at(t)) {
            (Some(_), _) => self.uncertainty.points,
            (None, Some(_)) => self.uncertainty.curve,
            (None, None) => f64::INFINITY,
        }
    }

    /// Times of the isolated points.
    pub(super) fn times(&self) -> impl Iterator<Item = f64> {
        self.points.iter().map(|(t, _)| *t)
    }

    /// True if the reference is defined between the points.
    pub(super) fn is_curve(&self) -> bool {
        self.curve.is_some()
    }

    fn along(curve: ReferenceCurve<'a, N>, uncertainty: f64) -> Self {
        Self {
            curve: Some(curve),
            points: Vec::new(),
            uncertainty: Uncertainty {
                curve: uncertainty,
                points: 0.0,
            },
        }
    }

    fn point(&self, t: f64) -> Option<&SVector<f64, N>> {
        self.points.iter().find(|(time, _)| *time == t).map(|(_, x)| x)
    }
}

/// Relative and absolute tolerance of [`Reference::integrate`]: some ulps, so that rounding errors dominate.
const TIGHT: f64 = 1e-14;

impl<const N: usize> fmt::Debug for Reference<'_, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Reference")
            .field("points", &self.points.len())
            .field("uncertainty", &self.uncertainty)
            .finish_non_exhaustive()
    }
}

/// Maximum of two numbers. NaN counts as infinite, so that it cannot pass for a small error.
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::INFINITY
    } else {
        a.max(b)
    }
}

/// Largest absolute difference of a component.
pub(super) fn distance<const N: usize>(a: &SVector<f64, N>, b: &SVector<f64, N>) -> f64 {
    (a - b)
        .iter()
        .fold(0.0, |largest, difference| larger(largest, difference.abs()))
}
