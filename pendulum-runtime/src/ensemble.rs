//! Integration of many trajectories on all processors.

use std::sync::atomic::{AtomicBool, Ordering};

use nalgebra::SVector;
use pendulum_core::dense::Dense;
use pendulum_core::inputs::TimeTable;
use pendulum_core::{EnsembleError, Need, ObservedEnsemble, Observer, Reason};
use rayon::prelude::*;

use crate::error::Error;
use crate::method::{Method, TaskInLanes};
use crate::motion::Stopped;
use crate::padded::{LONGEST, Padded, Smooth, active, follow, padded};
use crate::sampler::{Sampler, check_times};
use crate::solve::{self, Options};

/// Most trajectories that are integrated together in lanes.
const MOST: usize = 256;
/// Fewest, where there are enough: they fill the lanes.
const FEWEST: usize = 32;

/// Longest state in lanes.
const MOST_IN_LANES: usize = if cfg!(feature = "full") { LONGEST } else { 16 };

/// Members of an ensemble.
#[derive(Clone, Copy, Debug)]
pub struct Members<'a> {
    /// Initial states, one after the other.
    pub starts: &'a [f64],
    /// Parameters of each member, one after the other; `None` for those of the model.
    pub parameters: Option<&'a [f64]>,
    /// Laws of inputs, one for each member; those of the model where an input is not named.
    pub laws: &'a [(&'a str, Vec<TimeTable<1>>)],
    /// Times at which states are kept, in the direction of the integration.
    pub times: &'a [f64],
    /// Ends the integration when it becomes true; members that have not ended are then stopped.
    pub cancel: Option<&'a AtomicBool>,
}

/// States of many trajectories.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct Ensemble {
    /// Final states, one after the other; the last valid one of a trajectory that stopped.
    pub ends: Vec<f64>,
    /// States at the times: for each trajectory, for each time, a state. NaN after a trajectory stopped.
    pub samples: Vec<f64>,
    /// Trajectories that stopped early: index, last valid time, and reason.
    pub stopped: Vec<(usize, f64, Error)>,
}

impl Ensemble {
    /// Adds the members of another ensemble, whose states have this length, at the end.
    fn extend(&mut self, other: Self, length: usize) {
        let before = self.ends.len() / length;
        self.ends.extend(other.ends);
        self.samples.extend(other.samples);
        let stopped = other.stopped.into_iter();
        self.stopped
            .extend(stopped.map(|(n, t, reason)| (before + n, t, reason)));
    }

    /// Adds a member.
    fn push(&mut self, end: Vec<f64>, samples: &[f64], times: usize) {
        let missing = times * end.len() - samples.len();
        self.samples.extend_from_slice(samples);
        self.samples.extend(std::iter::repeat_n(f64::NAN, missing));
        self.ends.extend(end);
    }
}

/// Samples of a member.
struct Samples<'a> {
    sampler: Sampler<'a>,
    cancel: Option<&'a AtomicBool>,
}

impl<const N: usize> Observer<f64, N> for Samples<'_> {
    fn start(&mut self, t: f64, x: &SVector<f64, N>) {
        self.sampler.start(t, x);
    }

    fn needs(&self, _t0: f64, t1: f64) -> Need {
        match self.sampler.has_any_until(t1) {
            true => Need::Inside,
            false => Need::Nothing,
        }
    }

    fn is_cancelled(&self) -> bool {
        self.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed))
    }

    fn step(&mut self, dense: &Dense<'_, f64, N>) {
        self.sampler.step(dense);
    }
}

/// Trajectories that are integrated together in lanes.
struct Batch<'a, const N: usize> {
    models: &'a [Smooth<N>],
    starts: &'a [f64],
    span: [f64; 2],
    members: &'a Members<'a>,
}

impl<const N: usize> TaskInLanes<N> for &Batch<'_, N> {
    type Output = Result<Ensemble, Reason>;

    fn by(self, method: impl ObservedEnsemble<Smooth<N>, f64, N> + Sync) -> Self::Output {
        let &Batch {
            models,
            starts,
            span,
            members,
        } = self;
        let length = models[0].tape().length();
        let starts: Vec<SVector<f64, N>> = starts.chunks(length).map(padded).collect();
        let samples = starts.iter().map(|_| Samples {
            sampler: Sampler::new(members.times, span, length),
            cancel: members.cancel,
        });
        let mut samples: Vec<_> = samples.collect();
        let ended = method.observe(models, (span[0], span[1]), &starts, |_| &[], &mut samples);
        let (ends, stopped) = match ended {
            Ok(ends) => (ends, Vec::new()),
            Err(EnsembleError::Stopped { stopped, x }) => (x, stopped),
            Err(EnsembleError::InvalidInput(reason)) => return Err(reason),
            Err(_) => return Err(Reason::Cancelled),
        };
        let mut ensemble = Ensemble::default();
        for (end, samples) in ends.into_iter().zip(&samples) {
            ensemble.push(active(end, length), &samples.sampler.x, members.times.len());
        }
        let stopped = stopped.into_iter().map(|own| (own.index, own.t, own.reason.into()));
        ensemble.stopped.extend(stopped);
        Ok(ensemble)
    }
}

/// Integrates trajectories one by one.
fn alone<const N: usize>(
    models: &[Padded<f64, N>],
    method: &Method,
    span: [f64; 2],
    starts: &[f64],
    members: &Members<'_>,
) -> Result<Ensemble, Error> {
    let length = models[0].tape().length();
    let mut ensemble = Ensemble::default();
    let is_cancelled = || members.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed));
    let options = Options {
        times: Some(members.times.to_vec()),
        cancel: Some(&is_cancelled),
        ..Options::default()
    };
    for (n, x0) in starts.chunks(length).enumerate() {
        let model = models.get(n).unwrap_or(&models[0]);
        let motion = match solve::solve(model, method, span, x0, &options) {
            Ok(motion) => motion,
            Err(Stopped {
                error,
                motion: Some(motion),
            }) => {
                ensemble.stopped.push((n, motion.end().0, *error));
                *motion
            }
            // a start is invalid, unless the settings are
            Err(Stopped { error, motion: None }) if x0.iter().all(|x| x.is_finite()) => return Err(*error),
            Err(Stopped { error, motion: None }) => {
                ensemble.stopped.push((n, span[0], *error));
                ensemble.push(x0.to_vec(), &[], members.times.len());
                continue;
            }
        };
        ensemble.push(motion.end().1.to_vec(), motion.x(), members.times.len());
    }
    Ok(ensemble)
}

pub(crate) fn ensemble<const N: usize>(
    model: &Padded<f64, N>,
    method: &Method,
    span: [f64; 2],
    members: &Members<'_>,
) -> Result<Ensemble, Error> {
    let (length, params) = (model.tape().length(), model.params().len());
    check_times(members.times, span)?;
    let count = members.starts.len() / length;
    Error::check_length("the list of initial states", members.starts.len(), count * length)?;
    let mut models: Vec<Padded<f64, N>> = match members.parameters {
        None if members.laws.is_empty() => vec![model.clone()],
        None => vec![model.clone(); count],
        Some(all) => {
            Error::check_length("the list of parameters", all.len(), count * params)?;
            let own = (0..count).map(|n| {
                let with = model.with_params(&all[n * params..(n + 1) * params]);
                with.map_err(|error| Error::setting(&format!("the parameters of trajectory {n}"), error.to_string()))
            });
            own.collect::<Result<_, Error>>()?
        }
    };
    let inputs = model.tape().inputs().iter().map(|input| input.name);
    for (name, laws) in members.laws {
        let input = Error::index_of("input", name, inputs.clone())?;
        Error::check_length(&format!("the list of laws of `{name}`"), laws.len(), count)?;
        for (model, law) in models.iter_mut().zip(laws) {
            follow(model, [(input, law.clone())]);
        }
    }
    // as many as fill the lanes, but something to do for each thread
    let size = count.div_ceil(rayon::current_num_threads()).clamp(FEWEST, MOST);
    let smooth: Option<Vec<Smooth<N>>> = models.iter().map(Padded::smooth).collect();
    let parts: Vec<Ensemble> = members
        .starts
        .par_chunks(size * length)
        .enumerate()
        .map(|(n, starts)| {
            let own = match models.len() {
                1 => 0..1,
                all => n * size..(n * size + starts.len() / length).min(all),
            };
            if let Some(smooth) = &smooth
                && const { N <= MOST_IN_LANES }
            {
                let batch = Batch {
                    models: &smooth[own.clone()],
                    starts,
                    span,
                    members,
                };
                if let Ok(ensemble) = method.run_in_lanes(&batch) {
                    return Ok(ensemble?);
                }
            }
            alone(&models[own], method, span, starts, members)
        })
        .collect::<Result<_, Error>>()?;
    let mut ensemble = Ensemble::default();
    parts.into_iter().for_each(|part| ensemble.extend(part, length));
    Ok(ensemble)
}
