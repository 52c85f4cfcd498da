//! The fastest method for an error.

use pendulum_core::accuracy::{Alternative, Setting, Tuning};

use crate::error::Error;
use crate::method::Method;
use crate::padded::{Padded, padded};
use crate::worker::Cancel;

/// A method that keeps within an error, with its settings.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Choice {
    /// The method.
    pub method: Method,
    /// Largest error at the end of the pilot runs, relative to the larger of the size of each component and the scale.
    pub error: f64,
    /// Evaluations of the right-hand side for a trajectory, on average.
    pub evaluations: f64,
    /// Time for a trajectory, on average, in s.
    pub time: f64,
}

/// Kinds of methods for which a model has the functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kinds {
    pub(crate) implicit: bool,
    pub(crate) series: bool,
    pub(crate) canonical: bool,
}

/// Methods that keep within the error, the fastest first.
pub(crate) fn tune<const N: usize>(
    model: &Padded<f64, N>,
    span: [f64; 2],
    starts: &[Vec<f64>],
    error: f64,
    scale: f64,
    kinds: Kinds,
    cancel: &Cancel<'_>,
) -> Result<Vec<Choice>, Error> {
    let starts: Vec<_> = starts.iter().map(|start| padded(start)).collect();
    let tuning = Tuning::new(model, (span[0], span[1]), &starts, error);
    let mut tuning = tuning.scale(scale).cancel(cancel).explicit();
    if kinds.series {
        tuning = tuning.series();
    }
    if kinds.implicit {
        tuning = tuning.implicit();
    }
    if kinds.canonical {
        tuning = tuning.canonical();
    }
    tuning.run()?.alternatives.iter().map(choice).collect()
}

fn choice(of: &Alternative) -> Result<Choice, Error> {
    let method = Method::new(of.name)?;
    Ok(Choice {
        method: match of.setting {
            Setting::Tolerance { rtol, atol } => method.rtol(rtol).atol(atol),
            Setting::Step(h) => method.h(h),
            _ => method,
        },
        error: of.error,
        evaluations: of.evaluations,
        time: of.time,
    })
}
