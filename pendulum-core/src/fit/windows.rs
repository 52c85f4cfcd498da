//! Division of experiments into windows.

use std::ops::Range;

use super::measurement::Measurement;
use super::{Division, Experiment, FitError};

/// Minimum number of values in a window, for each component of the state.
const VALUES_OF_A_WINDOW: usize = 2;

/// Part of an experiment.
#[derive(Clone, Debug)]
pub(super) struct Window {
    pub(super) experiment: usize,
    /// Indices of its samples.
    pub(super) samples: Range<usize>,
    /// Its start and end.
    pub(super) span: [f64; 2],
    /// True if it continues the window before.
    pub(super) joined: bool,
    /// True if the state at its start is known.
    pub(super) known: bool,
}

impl Window {
    /// The first `count` samples with a value.
    pub(super) fn beginning(&self, measurement: &Measurement, count: usize) -> Self {
        let has_a_value = |&n: &usize| values(measurement, n) > 0;
        let last = self.samples.clone().filter(has_a_value).take(count).last();
        let last = last.unwrap_or(self.samples.start);
        Self {
            samples: self.samples.start..last + 1,
            span: [self.span[0], measurement.times[last]],
            ..self.clone()
        }
    }
}

/// Number of values of a sample that are not missing.
fn values(measurement: &Measurement, sample: usize) -> usize {
    let columns = measurement.columns.iter();
    columns.filter(|column| !column.values[sample].is_nan()).count()
}

/// Splits experiments into windows. A window ends at the sample with which the next one starts. `n` is the length of a
/// state without padding.
pub(super) fn divide<M, const N: usize>(
    experiments: &[Experiment<'_, M, N>],
    division: Division,
    n: usize,
) -> Result<Vec<Window>, FitError> {
    let (length, joined) = match division {
        Division::Whole => (f64::INFINITY, false),
        Division::Joined(length) => (length, true),
        Division::Separate(length) => (length, false),
    };
    let mut windows = Vec::new();
    for (number, experiment) in experiments.iter().enumerate() {
        let times = &experiment.measurement.times;
        let [Some(&first), Some(&last)] = [times.first(), times.last()] else {
            return Err(FitError::TooFewValues { values: 0, unknowns: n });
        };
        let begins = match experiment.known {
            Some((t, _)) if t > first || t.is_nan() => {
                let experiment = number;
                return Err(FitError::StartsLate { experiment, t, first });
            }
            Some((t, _)) => t,
            None => first,
        };
        let count = ((last - begins) / length).ceil().clamp(1.0, times.len() as f64);
        let width = (last - begins) / count;
        let least = VALUES_OF_A_WINDOW * n;
        // first sample of the window, its number of values, and its end as a multiple of the width
        let (mut from, mut inside, mut edge) = (0, 0, 1.0);
        for to in 1..=times.len() {
            inside += values(experiment.measurement, to - 1);
            let next = times.get(to).copied();
            if let Some(t) = next {
                let enough_left = || {
                    let after = (to..times.len()).map(|sample| values(experiment.measurement, sample));
                    after.take(least).sum::<usize>() >= least
                };
                if t < begins + width * edge || inside < least || !enough_left() {
                    continue;
                }
                edge = ((t - begins) / width + 1e-9).floor() + 1.0;
            }
            windows.push(Window {
                experiment: number,
                samples: from..to,
                span: [if from == 0 { begins } else { times[from] }, next.unwrap_or(last)],
                joined: joined && from > 0,
                known: from == 0 && experiment.known.is_some(),
            });
            (from, inside) = (to, 0);
        }
    }
    Ok(windows)
}
