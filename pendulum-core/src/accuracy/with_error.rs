//! Solutions with an estimate of their error.

use nalgebra::SVector;

use crate::error::{Reason, SolveError};
use crate::method::{Adaptive, Fixed, Method, Scheme, Stepper};
use crate::real::Float;
use crate::solution::Solution;
use crate::statistics::Statistics;
use crate::step_size::Estimates;
use crate::system::{IntoState, System};

/// A method that can repeat an integration more accurately.
pub trait Refine: Sized {
    /// The method with a tolerance a hundred times smaller, or with half the step. For numbers of the type `T` the
    /// tolerance remains at least 10 ulps, the least that methods accept.
    #[must_use]
    fn refined<T: Float>(&self) -> Self;

    /// The method as one that estimates the error of its solutions: see [`WithError`].
    #[must_use]
    fn with_error(self) -> WithError<Self> {
        WithError(self)
    }
}

/// A method that estimates the global errors of its solutions; `A` is the method.
///
/// The tolerance of a method bounds the error of each step; the error of the solution is their sum, carried along
/// the trajectory. The estimate is the difference from a second integration, by the [refined](Refine::refined) method,
/// which stops at each point of the first one. It takes two to three times as long as the solution alone.
///
/// ```
/// use pendulum_core::prelude::*;
///
/// let swing = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0].sin()]));
/// let method = Tsit5::new().rtol(1e-6).atol(1e-6).with_error();
/// let swung = method.solve(&swing, 0.0, 100.0, [1.0, 0.0])?;
/// let (x, error) = (swung.solution.end(), swung.error());
/// assert!(error[0] > 1e-6, "a hundred times the tolerance: {error}");
///
/// let known = Vern9::new().rtol(1e-13).atol(1e-13).solve(&swing, 0.0, 100.0, [1.0, 0.0])?.end();
/// assert!(((x - known)[0] / error[0] - 1.0).abs() < 0.05);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Near the rounding errors, with tolerances below 1e-13 or after many turns, an estimate is right in magnitude only,
/// because the errors of the second integration are as large. Errors common to both are not seen, such as a pulse that
/// both step over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WithError<A>(A);

/// A solution with an estimate of its error, computed by [`WithError`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SolutionWithError<T, const N: usize> {
    /// The solution, as the method computes it alone.
    pub solution: Solution<T, N>,
    /// Estimated error at each of [`Solution::t`], in the units of the state: the solution minus a more accurate one.
    ///
    /// Around an impact it is the error of either the state before or the state after it, whichever is less: the time
    /// of the impact has an error, too.
    pub errors: Vec<SVector<T, N>>,
    /// Work of the second integration; the solution has the work of the first.
    pub statistics: Statistics,
}

impl<T: Float, const N: usize> SolutionWithError<T, N> {
    /// Estimated error at the end.
    #[must_use]
    pub fn error(&self) -> SVector<T, N> {
        self.errors[self.errors.len() - 1]
    }

    /// Largest estimated error of each component over all points, without sign.
    #[must_use]
    pub fn largest(&self) -> SVector<T, N> {
        let zeros = SVector::repeat(T::default());
        self.errors.iter().fold(zeros, |most, error| {
            most.zip_map(error, |most, error| most.max(error.abs()))
        })
    }
}

impl<A: Refine> WithError<A> {
    /// Like [`Method::solve`], with an estimate of the error.
    ///
    /// # Errors
    /// Errors of [`Method::solve`]. If only the second integration stops, the error contains the point at which it
    /// does, instead of a solution.
    pub fn solve<S, T, const N: usize>(
        &self,
        system: &S,
        t0: T,
        t1: T,
        x0: impl IntoState<T, N>,
    ) -> Result<SolutionWithError<T, N>, SolveError<T, N>>
    where
        A: Method<S, T, N>,
        S: System<T, N>,
        T: Float,
    {
        let x0 = x0.into_state();
        let solution = self.0.solve(system, t0, t1, x0)?;
        let refined = self.0.refined::<T>();
        let stepper = refined.stepper(system, t0, t1, x0);
        let mut stepper = stepper.map_err(|reason| SolveError::at_start(reason, t0, x0))?;
        match differences(&solution, &mut stepper) {
            Ok(errors) => Ok(SolutionWithError {
                solution,
                errors,
                statistics: stepper.statistics(),
            }),
            Err(reason) => Err(SolveError::at_start(reason, stepper.t(), stepper.x())),
        }
    }
}

/// Differences of the points of a solution from the states of a stepper at the same times.
fn differences<C, S, T, const N: usize>(
    solution: &Solution<T, N>,
    stepper: &mut Stepper<'_, C, S, T, N>,
) -> Result<Vec<SVector<T, N>>, Reason>
where
    C: Scheme<S, T, N>,
    S: System<T, N>,
    T: Float,
{
    let times = solution.t();
    let is_forward = times[0] <= times[times.len() - 1];
    let mut errors = Vec::<SVector<T, N>>::with_capacity(times.len());
    for (n, (t, x)) in solution.points().enumerate() {
        stepper.stop_at(t);
        while if is_forward { stepper.t() < t } else { stepper.t() > t } {
            stepper.step()?;
        }
        // steps of fixed length go on to the next time of their grid
        let known = if stepper.t() == t {
            stepper.x()
        } else {
            stepper.dense().at(t)
        };
        let error = x - known;
        // states before and after an impact
        let before = n.checked_sub(1).filter(|&before| times[before] == t);
        if let Some(before) = before {
            let least = if largest(&errors[before]) <= largest(&error) {
                errors[before]
            } else {
                error
            };
            errors[before] = least;
            errors.push(least);
        } else {
            errors.push(error);
        }
    }
    Ok(errors)
}

fn largest<T: Float, const N: usize>(x: &SVector<T, N>) -> T {
    x.iter().fold(T::default(), |largest, x| largest.max(x.abs()))
}

impl<F: Estimates + Clone> Refine for Adaptive<F> {
    fn refined<T: Float>(&self) -> Self {
        self.clone().tightened::<T>(REFINEMENT)
    }
}

impl<F: Clone> Refine for Fixed<F> {
    fn refined<T: Float>(&self) -> Self {
        Self {
            h: 0.5 * self.h,
            family: self.family.clone(),
        }
    }
}

/// Factor of the tolerances, with which the errors of the second integration are some percent of those of the first.
const REFINEMENT: f64 = 0.01;
