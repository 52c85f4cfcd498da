//! One method of one library on one problem.

use std::time::Instant;

use twelve::End;

/// Method of a library on a problem.
pub(crate) struct Entrant {
    pub by: &'static str,
    pub method: &'static str,
    /// Integrates with a relative tolerance as often as told.
    pub run: Box<dyn Fn(f64, usize) -> Result<Run, String>>,
}

/// Last end, with the nanoseconds for a trajectory.
pub(crate) struct Run {
    pub end: End,
    pub nanoseconds: f64,
}

impl Entrant {
    /// Makes an entrant from a function that integrates as often as told, and is timed here.
    pub(crate) fn timed(
        by: &'static str,
        method: &'static str,
        integrate: impl Fn(f64, usize) -> Result<End, String> + 'static,
    ) -> Self {
        let run = move |tolerance: f64, times: usize| {
            let start = Instant::now();
            let end = integrate(tolerance, times)?;
            let nanoseconds = 1e9 * start.elapsed().as_secs_f64() / times as f64;
            Ok(Run { end, nanoseconds })
        };
        Self {
            by,
            method,
            run: Box::new(run),
        }
    }
}

impl From<twelve::Entrant> for Entrant {
    fn from(entrant: twelve::Entrant) -> Self {
        Self::timed(entrant.by, entrant.method, entrant.integrate)
    }
}
