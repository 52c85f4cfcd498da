//! Solutions to measure against.

use std::fmt;

use nalgebra::SVector;

use super::errors::distance;
use crate::error::SolveError;
use crate::method::{Method, Vern7, Vern9};
use crate::solution::{OutsideSpan, Solution};
use crate::system::{IntoState, System};

/// A trusted solution, which tells how far it can be trusted.
///
/// It is a function, a computed solution, or some points; [`with_points`](Self::with_points) adds points that are better known.
pub struct Reference<'a, const N: usize> {
    curve: Option<ReferenceCurve<'a, N>>,
    /// Where the state is known better than by the curve.
    points: Vec<(f64, SVector<f64, N>)>,
    uncertainty: Uncertainty,
}

/// What is known between points.
enum ReferenceCurve<'a, const N: usize> {
    Function(Box<dyn Fn(f64) -> SVector<f64, N> + 'a>),
    Solution(Box<Solution<f64, N>>),
}

/// How far the largest component of the state may be wrong.
#[derive(Clone, Copy, Debug, Default)]
struct Uncertainty {
    curve: f64,
    points: f64,
}

impl<'a, const N: usize> Reference<'a, N> {
    /// An exact solution as a function of time. Its uncertainty is taken as 0, though the function rounds.
    pub fn exact(function: impl Fn(f64) -> SVector<f64, N> + 'a) -> Self {
        Self::along(ReferenceCurve::Function(Box::new(function)), 0.0)
    }

    /// States at some times, for example published ones, with the largest error that their components may have. Nothing is known
    /// between.
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

    /// The solution `best`, trusted as far as the solution `other` agrees with it: take another tolerance, or better another method.
    ///
    /// The uncertainty is the largest component of their difference at the accepted points of `other`, where `best` interpolates. Errors
    /// that both share do not show.
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

    /// The solution of [`Vern7`] from the state `x0` at `t0` to `t1` with tolerances of 1e-14, trusted as far as [`Vern9`] agrees.
    ///
    /// For a stiff system these explicit methods are slow: take [`solutions`](Self::solutions) of implicit ones.
    ///
    /// # Errors
    /// As for [`Method::solve`].
    pub fn integrate(
        system: &impl System<f64, N>,
        t0: f64,
        t1: f64,
        x0: impl IntoState<f64, N>,
    ) -> Result<Self, SolveError<f64, N>> {
        let x0 = x0.into_state();
        // Not the other way round: the dense output of order 9 has large weights of both signs, and rounds a hundred times worse.
        let best = Vern7::new().rtol(TIGHT).atol(TIGHT).solve(system, t0, t1, x0)?;
        let other = Vern9::new().rtol(TIGHT).atol(TIGHT).solve(system, t0, t1, x0)?;
        Ok(Self::solutions(best, &other).expect("both go from t0 to t1"))
    }

    /// The same reference, and points that are better known: at their times they count, with their own uncertainty.
    #[must_use]
    pub fn with_points(mut self, points: impl IntoIterator<Item = (f64, SVector<f64, N>)>, uncertainty: f64) -> Self {
        self.points = points.into_iter().collect();
        self.uncertainty.points = uncertainty;
        self
    }

    /// The state at the time `t`, or `None` where it is not known.
    #[must_use]
    pub fn at(&self, t: f64) -> Option<SVector<f64, N>> {
        self.point(t).copied().or_else(|| match &self.curve {
            Some(ReferenceCurve::Function(function)) => Some(function(t)),
            Some(ReferenceCurve::Solution(solution)) => solution.at(t).ok(),
            None => None,
        })
    }

    /// How far the largest component of the state at the time `t` may be wrong, in the units of the state; infinite where nothing is
    /// known. Errors that are not well above it tell nothing.
    #[must_use]
    pub fn uncertainty(&self, t: f64) -> f64 {
        match (self.point(t), self.at(t)) {
            (Some(_), _) => self.uncertainty.points,
            (None, Some(_)) => self.uncertainty.curve,
            (None, None) => f64::INFINITY,
        }
    }

    /// The times of the points that are known by themselves.
    pub(super) fn times(&self) -> impl Iterator<Item = f64> {
        self.points.iter().map(|(t, _)| *t)
    }

    /// Whether states are known between the points.
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

/// The tolerances of [`Reference::integrate`]: some ulps, so that rounding decides.
const TIGHT: f64 = 1e-14;

impl<const N: usize> fmt::Debug for Reference<'_, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Reference")
            .field("points", &self.points.len())
            .field("uncertainty", &self.uncertainty)
            .finish_non_exhaustive()
    }
}
