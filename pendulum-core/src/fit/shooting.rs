//! Trajectories in windows, as functions of their starts and the parameters.

use std::ops::Range;

use nalgebra::{DMatrix, SVector};

use super::measurement::Measurement;
use super::windows::Window;
use super::{Experiment, FitError, nearest};
use crate::dense::Dense;
use crate::dual::Dual;
use crate::error::{ParameterError, Reason};
use crate::hybrid::place_inside;
use crate::method::Method;
use crate::real::Real;
use crate::solution::{Need, Observer};
use crate::system::{Parametric, System};

/// Number of variables of a dual number: as many as a vector register holds. More variables are computed in parts, each
/// in the same steps.
pub(super) const PART: usize = 8;

/// A trajectory in a window, with its derivatives by variables: its start and the free parameters.
#[derive(Clone, Debug)]
pub(super) struct Shot {
    /// Outputs: all columns of the first sample, then those of the next.
    pub(super) outputs: Vec<f64>,
    /// A row for each output.
    pub(super) by: DMatrix<f64>,
    /// State at the end of the window.
    pub(super) end: Vec<f64>,
    /// A row for each component.
    pub(super) end_by: DMatrix<f64>,
}

impl Shot {
    /// Appends the derivatives of another one.
    pub(super) fn append(&mut self, others: &Self) {
        for (by, others) in [(&mut self.by, &others.by), (&mut self.end_by, &others.end_by)] {
            by.extend(others.as_slice().iter().copied());
        }
    }
}

/// Models and methods behind plain numbers, so that the search is compiled once.
pub(super) trait Shooting: Sync {
    /// Integrates a window, with derivatives by some of the variables: the start, and the parameters of the indices
    /// `by`. Those by a known start are zero.
    fn shoot(
        &self,
        window: &Window,
        start: &[f64],
        parameters: &[f64],
        by: &[usize],
        variables: Range<usize>,
    ) -> Result<Shot, Reason>;

    /// Projects a start onto the constraints of the model, and into its limits.
    fn project(&self, window: &Window, start: &mut [f64], parameters: &[f64]);

    /// Checks the parameters.
    fn check(&self, parameters: &[f64]) -> Result<(), ParameterError>;
}

/// Source of a measured output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Source {
    /// Component of the state.
    Component(usize),
    /// Output, by its index among all.
    Output(usize),
}

/// The trajectories of experiments with a model of `P` parameters.
pub(super) struct Trajectories<'a, X, M, const N: usize, const P: usize> {
    pub(super) method: &'a X,
    pub(super) experiments: &'a [Experiment<'a, M, N>],
    /// Sources of the columns of each experiment.
    pub(super) sources: Vec<Vec<Source>>,
    /// Indices of the parameters that the experiments share.
    pub(super) free: Vec<usize>,
}

/// Sources of the columns of a measurement.
pub(super) fn sources<M, const N: usize, const P: usize>(
    model: &M,
    measurement: &Measurement,
) -> Result<Vec<Source>, FitError>
where
    M: Parametric<N, P>,
{
    let model = model.cast::<f64>();
    let components = model.layout().map_or_else(Vec::new, |layout| layout.components());
    let mut outputs = Vec::new();
    // only names are of interest, whatever the values
    model.each_output(0.0, &SVector::zeros(), &mut |name, _| outputs.push(name.to_owned()));
    let names = measurement.names().map(|name| {
        let output = outputs.iter().position(|own| own == name).map(Source::Output);
        let component = || components.iter().position(|own| own == name).map(Source::Component);
        output.or_else(component).ok_or_else(|| {
            let known = || outputs.iter().chain(&components).map(String::as_str);
            FitError::UnknownOutput {
                name: name.to_owned(),
                nearest: nearest(name, known()),
                outputs: known().map(str::to_owned).collect(),
            }
        })
    });
    names.collect()
}

impl<X, M, const N: usize, const P: usize> Shooting for Trajectories<'_, X, M, N, P>
where
    M: Parametric<N, P> + Sync,
    X: Method<M::In<Dual<f64, PART>>, Dual<f64, PART>, N> + Sync,
{
    fn shoot(
        &self,
        window: &Window,
        start: &[f64],
        parameters: &[f64],
        by: &[usize],
        variables: Range<usize>,
    ) -> Result<Shot, Reason> {
        let experiment = &self.experiments[window.experiment];
        let sources = &self.sources[window.experiment];
        let times = &experiment.measurement.times[window.samples.clone()];
        let [t0, t1] = window.span.map(Dual::constant);
        let rows = times.len() * sources.len();
        let n = start.len();
        let mut shot = Shot {
            outputs: vec![0.0; rows],
            by: DMatrix::zeros(rows, variables.len()),
            end: vec![0.0; n],
            end_by: DMatrix::zeros(n, variables.len()),
        };
        // without variables, once for the outputs
        for part in (0..variables.len().max(1)).step_by(PART) {
            let columns = part..variables.len().min(part + PART);
            let first = variables.start + part;
            let seed = |value: f64, variable: Option<usize>| {
                let place = variable.and_then(|variable| variable.checked_sub(first));
                match place.filter(|&place| place < PART) {
                    Some(place) => Dual::variable(value, place),
                    None => Dual::constant(value),
                }
            };
            let values = own(experiment.model, parameters, &self.free);
            let model = experiment
                .model
                .with_parameters::<Dual<f64, PART>>(std::array::from_fn(|p| {
                    let place = by.iter().position(|&by| by == p);
                    seed(values[p], place.map(|place| n + place))
                }));
            let mut x0 = padded::<N>(start).map(Dual::constant);
            if !window.known {
                (0..n).for_each(|i| x0[i] = seed(start[i], Some(i)));
            }
            let mut sampler = Sampler {
                model: &model,
                sources,
                times,
                next: 0,
                outputs: Vec::with_capacity(rows),
            };
            let end = if t0.value == t1.value {
                sampler.sample(t0, &x0);
                x0
            } else {
                // any observer, so that other users of these derivatives share the code
                let mut observer: &mut dyn Observer<_, N> = &mut sampler;
                self.method.follow(&model, t0, t1, x0, &[], &mut observer)?
            };
            for (row, output) in sampler.outputs.iter().enumerate() {
                shot.outputs[row] = output.value;
                for column in columns.clone() {
                    shot.by[(row, column)] = output.slopes[column - part];
                }
            }
            for (row, component) in end.iter().take(n).enumerate() {
                shot.end[row] = component.value;
                for column in columns.clone() {
                    shot.end_by[(row, column)] = component.slopes[column - part];
                }
            }
        }
        Ok(shot)
    }

    fn project(&self, window: &Window, start: &mut [f64], parameters: &[f64]) {
        let model = self.experiments[window.experiment].model;
        let model = model.with_parameters(own(model, parameters, &self.free));
        let mut x = padded::<N>(start);
        model.project(window.span[0], &mut x);
        if let Some(hybrid) = model.hybrid() {
            place_inside(hybrid, window.span[0], &mut x);
        }
        if x.iter().all(|x| x.is_finite()) {
            start.copy_from_slice(&x.as_slice()[..start.len()]);
        }
    }

    fn check(&self, parameters: &[f64]) -> Result<(), ParameterError> {
        let mut models = self.experiments.iter().map(|experiment| experiment.model);
        models.try_for_each(|model| model.check_parameters(&own(model, parameters, &self.free)))
    }
}

/// Parameters of an experiment: its own, but for those that are free.
fn own<M, const N: usize, const P: usize>(model: &M, parameters: &[f64], free: &[usize]) -> [f64; P]
where
    M: Parametric<N, P>,
{
    let mut own = model.parameters();
    free.iter().for_each(|&n| own[n] = parameters[n]);
    own
}

/// State with these components, and zero in those that are padding.
pub(super) fn padded<const N: usize>(x: &[f64]) -> SVector<f64, N> {
    SVector::from_fn(|n, _| x.get(n).copied().unwrap_or_default())
}

/// Evaluates the measured outputs at the times of the samples.
struct Sampler<'a, S, T, const N: usize> {
    model: &'a S,
    sources: &'a [Source],
    times: &'a [f64],
    /// Index of the next sample.
    next: usize,
    outputs: Vec<T>,
}

impl<S, T: Real, const N: usize> Sampler<'_, S, T, N>
where
    S: System<T, N>,
{
    fn sample(&mut self, t: T, x: &SVector<T, N>) {
        self.next += 1;
        let first = self.outputs.len();
        for source in self.sources {
            self.outputs.push(match *source {
                Source::Component(n) => x[n],
                Source::Output(_) => T::default(),
            });
        }
        if self.sources.iter().all(|source| matches!(source, Source::Component(_))) {
            return;
        }
        let (mut index, outputs) = (0, &mut self.outputs[first..]);
        self.model.each_output(t, x, &mut |_, value| {
            for (output, source) in outputs.iter_mut().zip(self.sources) {
                if *source == Source::Output(index) {
                    *output = value;
                }
            }
            index += 1;
        });
    }
}

impl<S, const N: usize, const K: usize> Observer<Dual<f64, K>, N> for Sampler<'_, S, Dual<f64, K>, N>
where
    S: System<Dual<f64, K>, N>,
{
    fn needs(&self, _t0: Dual<f64, K>, t1: Dual<f64, K>) -> Need {
        match self.times.get(self.next) {
            Some(&t) if t <= t1.value => Need::Inside,
            _ => Need::Nothing,
        }
    }

    fn step(&mut self, dense: &Dense<'_, Dual<f64, K>, N>) {
        let end = dense.step().t1.value;
        while let Some(&t) = self.times.get(self.next).filter(|&&t| t <= end) {
            let t = Dual::constant(t);
            self.sample(t, &dense.at(t));
        }
    }
}
