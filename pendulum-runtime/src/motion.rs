//! Trajectories.

use std::fmt;

use pendulum_core::{Solution, Statistics};

use crate::error::Error;
use crate::padded::active;

/// A trajectory.
pub struct Motion {
    pub(crate) t: Vec<f64>,
    /// States, one after the other.
    pub(crate) x: Vec<f64>,
    pub(crate) length: usize,
    pub(crate) end: (f64, Vec<f64>),
    pub(crate) occurrences: Vec<Occurrence>,
    pub(crate) modes: Vec<(f64, String)>,
    pub(crate) impacts: Vec<Impact>,
    pub(crate) warnings: Vec<String>,
    pub(crate) statistics: Statistics,
    pub(crate) ended_by: Option<usize>,
    pub(crate) between: Option<Box<dyn Between>>,
}

/// An event that occurred.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Occurrence {
    /// Index of the event among those given.
    pub index: usize,
    /// Time.
    pub t: f64,
    /// State.
    pub x: Vec<f64>,
}

/// An impact at a stop or a wall.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Impact {
    /// Time.
    pub t: f64,
    /// State before.
    pub before: Vec<f64>,
    /// State after.
    pub after: Vec<f64>,
    /// Names of the constraints that push, and their impulses in N s or N m s.
    pub impulses: Vec<(String, f64)>,
}

/// States between the ends of steps.
pub(crate) trait Between: Send + Sync {
    fn at(&self, t: f64, length: usize) -> Result<Vec<f64>, Error>;
}

impl<const N: usize> Between for Solution<f64, N> {
    fn at(&self, t: f64, length: usize) -> Result<Vec<f64>, Error> {
        Ok(active(Self::at(self, t)?, length))
    }
}

impl Motion {
    /// Times of the states that were kept.
    #[must_use]
    pub fn t(&self) -> &[f64] {
        &self.t
    }

    /// States that were kept, one after the other.
    #[must_use]
    pub fn x(&self) -> &[f64] {
        &self.x
    }

    /// The `n`th state that was kept.
    #[must_use]
    pub fn state(&self, n: usize) -> &[f64] {
        &self.x[n * self.length..(n + 1) * self.length]
    }

    /// Last time and state.
    #[must_use]
    pub fn end(&self) -> (f64, &[f64]) {
        (self.end.0, &self.end.1)
    }

    /// State at a time of the motion.
    ///
    /// # Errors
    /// If the time lies outside of the motion, or if only the states at given times were kept.
    pub fn at(&self, t: f64) -> Result<Vec<f64>, Error> {
        let rule = "only the states at these times were kept; solve without them for states at any time";
        let only = || Error::setting("times", rule);
        self.between.as_ref().ok_or_else(only)?.at(t, self.length)
    }

    /// Events that occurred, in order of time.
    #[must_use]
    pub fn occurrences(&self) -> &[Occurrence] {
        &self.occurrences
    }

    /// Mode switches, each with its time and the constraints that stick or touch from then on.
    #[must_use]
    pub fn modes(&self) -> &[(f64, String)] {
        &self.modes
    }

    /// Impacts, in order of time.
    #[must_use]
    pub fn impacts(&self) -> &[Impact] {
        &self.impacts
    }

    /// Reasons to doubt the motion: events that may have been missed, simultaneous impacts whose order is unknown.
    #[must_use]
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Numbers of evaluations, steps and so on.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// Index of the terminal event that ended the motion.
    #[must_use]
    pub fn ended_by(&self) -> Option<usize> {
        self.ended_by
    }
}

impl fmt::Debug for Motion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Motion")
            .field("end", &self.end)
            .field("points", &self.t.len())
            .finish_non_exhaustive()
    }
}

/// Error: an integration did not start, or stopped early.
#[derive(Debug)]
#[non_exhaustive]
pub struct Stopped {
    /// Reason.
    pub error: Box<Error>,
    /// Motion up to there, if it started.
    pub motion: Option<Box<Motion>>,
}

impl<E: Into<Error>> From<E> for Stopped {
    fn from(error: E) -> Self {
        Self {
            error: Box::new(error.into()),
            motion: None,
        }
    }
}

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.motion {
            Some(motion) => write!(f, "stopped at t = {:?}: {}", motion.end.0, self.error),
            None => self.error.fmt(f),
        }
    }
}

impl std::error::Error for Stopped {}
