//! One method of one library on one problem.

use std::time::Instant;

use twelve::{End, Request};

/// Method of a library on a problem.
pub(crate) struct Entrant {
    pub by: &'static str,
    pub method: &'static str,
    pub run: Box<dyn Fn(Request) -> Run>,
}

/// Last end of the integrations, or why one failed, with the nanoseconds for a trajectory.
pub(crate) struct Run {
    pub end: Result<End, String>,
    pub nanoseconds: f64,
}

impl Entrant {
    /// Makes an entrant from a function that is timed here.
    pub(crate) fn timed(
        by: &'static str,
        method: &'static str,
        integrate: impl Fn(Request) -> Result<End, String> + 'static,
    ) -> Self {
        let run = move |request: Request| {
            let start = Instant::now();
            let end = integrate(request);
            let nanoseconds = 1e9 * start.elapsed().as_secs_f64() / request.times as f64;
            Run { end, nanoseconds }
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
