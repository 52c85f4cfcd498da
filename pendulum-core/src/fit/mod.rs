//! Parameters from measurements: least squares on sampled outputs.
//!
//! A [`Fit`] adjusts parameters of a scene so that its motions agree with [measurements](Measurement) of its outputs.
//! The states at the starts need not be known, and inputs may be [recorded](crate::inputs::TimeTable). The result has
//! confidence intervals, the combinations of parameters that the measurements do not determine, and the residuals.
//!
//! ```
//! use pendulum_core::fit::{Experiment, Fit, Measurement};
//! use pendulum_core::prelude::*;
//!
//! mechanism! {
//!     pub Swing {
//!         params { l: m = 1, damping: N m s = 0.1, zero: rad = 0 }
//!         gravity: [0, -9.81, 0],
//!         output encoder: theta + zero,
//!         body bob on ground {
//!             solids: [point(1, [0, -l, 0])], joint: revolute(z), coordinate: theta, friction: damping,
//!         }
//!     }
//! }
//!
//! // a simulated measurement, at 100 Hz
//! let truth = Swing::new(SwingParams { l: 0.8, damping: 0.05, zero: 0.02 })?;
//! let motion = Vern9::new().rtol(1e-10).atol(1e-10).solve(&truth, 0.0, 5.0, [1.2, 0.0])?;
//! let times: Vec<f64> = (0..500).map(|n| 0.01 * f64::from(n)).collect();
//! let angles: Vec<f64> = times.iter().map(|&t| motion.at(t).map(|x| truth.encoder(t, &x))).collect::<Result<_, _>>()?;
//! let measurement = Measurement::new(&times)?.output("encoder", &angles)?;
//!
//! let rough = Swing::new(SwingParams::default())?;
//! let fitted = Fit::new(Vern9::new().rtol(1e-9).atol(1e-9)).run(&[Experiment::new(&rough, &measurement)])?;
//! let params = SwingParams::from_array(fitted.parameters);
//! assert!((params.l - 0.8).abs() < 1e-6 && (params.damping - 0.05).abs() < 1e-6 && (params.zero - 0.02).abs() < 1e-6);
//! println!("{fitted}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Method
//!
//! The sum of the squares of all residuals, each divided by the standard deviation of its noise, is minimised by the
//! method of Gauss and Newton with the damping of Levenberg and Marquardt. [Derivatives](crate::sensitivity) by starts
//! and parameters are those of the method of integration, also through mode switches and impacts. The starts are
//! eliminated from each linear problem, so that its size does not grow with their number.
//!
//! By default each experiment is one trajectory (single shooting). Far from the solution, and where motions are
//! chaotic, it is better split into [windows](Fit::windows): the fit begins with separate windows, whose starts follow
//! the measurement, and joins them (multiple shooting). [Separate windows](Fit::separate_windows) remain separate. They
//! also tolerate disturbances that a scene does not model. A window that contains an impact is harder to fit than the
//! whole trajectory, if the impact is sensitive to its start.
//!
//! Noise of unknown size is estimated for each output, which maximises the likelihood. Deviations of the estimates are
//! scaled by the residuals in any case.
//!
//! H. G. Bock, "Recent advances in parameter identification techniques for O.D.E." (1983); L. Ljung, "System
//! Identification", 2nd ed. (1999).

mod descent;
mod elimination;
mod error;
mod fitted;
mod guess;
mod likelihood;
mod loss;
mod measurement;
mod parallel;
mod report;
mod search;
mod shooting;
mod starts;
mod table;
mod windows;

use std::ops::ControlFlow;

use nalgebra::SVector;

pub use error::FitError;
pub use fitted::{Combination, Estimate, Fitted, FittedWindow, Residuals, Status, Warning};
pub use likelihood::{Comparison, Likelihood};
pub use loss::Loss;
pub use measurement::Measurement;
pub use table::{Table, TableError};

use crate::dual::Dual;
use crate::method::Method;
use crate::system::{IntoState, Parametric, System};
use descent::{ENOUGH, ENOUGH_WITH_SWITCHES, End};
use measurement::Column;
use search::{Joints, Point, Search};
use shooting::{PART, Trajectories, sources};

/// Weights of the gaps between joined windows, in standard deviations of their starts, one after the other: the last
/// one closes them to about 1e-8 deviations.
const JOINING: [f64; 3] = [1.0, 1e2, 1e4];
/// With a robust loss, estimates of the noise change by less than this part in the end.
const NOISE_IS_FOUND: f64 = 1e-3;
/// Maximum number of estimates of the noise.
const MAX_NOISES: usize = 20;
/// Number of attempts to leave a kink by fitting each start alone.
const KINKS: usize = 5;

/// An experiment: a model, and the measurement of its motion.
///
/// The models of several experiments may have different inputs, and parameters that are not free. The fit begins at the
/// free parameters of the first.
#[derive(Clone, Copy, Debug)]
pub struct Experiment<'a, M, const N: usize> {
    model: &'a M,
    measurement: &'a Measurement,
    guess: Option<SVector<f64, N>>,
    known: Option<(f64, SVector<f64, N>)>,
}

impl<'a, M, const N: usize> Experiment<'a, M, N> {
    /// An experiment with an unknown state at the first sample. Measured coordinates give a first guess of it, also of
    /// their rates. Where other components are not measured themselves, the first samples are fitted, from zero on:
    /// give a guess if this leads to an equilibrium, or if a body turns several times between samples.
    #[must_use]
    pub fn new(model: &'a M, measurement: &'a Measurement) -> Self {
        Self {
            model,
            measurement,
            guess: None,
            known: None,
        }
    }

    /// Sets the first guess of the state at the first sample. The first samples are fitted from there. In windows, the
    /// others start where the one before ends.
    #[must_use]
    pub fn from_guess(mut self, x0: impl IntoState<f64, N>) -> Self {
        self.guess = Some(x0.into_state());
        self
    }

    /// States that the motion begins at `t0`, no later than the first sample, from the known state `x0`.
    #[must_use]
    pub fn from_known(mut self, t0: f64, x0: impl IntoState<f64, N>) -> Self {
        self.known = Some((t0, x0.into_state()));
        self
    }
}

/// Division of experiments into trajectories.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Division {
    Whole,
    Joined(f64),
    Separate(f64),
}

/// A fit: the method of integration, and settings.
#[derive(Clone, Debug)]
pub struct Fit<X> {
    method: X,
    free: Option<Vec<String>>,
    bounds: Vec<(String, [f64; 2])>,
    loss: Loss,
    division: Division,
    max_iterations: usize,
}

/// Progress of a fit, after a step that decreased the loss.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Progress<'a> {
    /// Number of steps so far.
    pub iteration: usize,
    /// Sum of the losses of all residuals.
    pub loss: f64,
    /// All parameters of the scene, in the order of declaration.
    pub parameters: &'a [f64],
}

impl<X> Fit<X> {
    /// A fit by trajectories of this method. All parameters are free.
    ///
    /// Errors of the integration should be well below the noise.
    #[must_use]
    pub fn new(method: X) -> Self {
        Self {
            method,
            free: None,
            bounds: Vec::new(),
            loss: Loss::Squares,
            division: Division::Whole,
            max_iterations: 200,
        }
    }

    /// Sets the free parameters. The others keep their values. Without free parameters only the starts are fitted, for
    /// example to predict a measurement.
    #[must_use]
    pub fn free<'n>(mut self, names: impl IntoIterator<Item = &'n str>) -> Self {
        self.free = Some(names.into_iter().map(str::to_owned).collect());
        self
    }

    /// Sets the bounds of a parameter, which may be infinite. By default what must not be negative, such as friction,
    /// is bounded by zero, and a restitution by one as well.
    #[must_use]
    pub fn bounds(mut self, name: &str, low: f64, high: f64) -> Self {
        self.bounds.push((name.to_owned(), [low, high]));
        self
    }

    /// Sets the loss of the residuals. Default: [`Loss::Squares`].
    #[must_use]
    pub fn loss(mut self, loss: Loss) -> Self {
        self.loss = loss;
        self
    }

    /// Splits each experiment into windows of about this length, which are joined in the end: multiple shooting. The
    /// result is that of a single trajectory, found from farther away. A window has at least twice as many values as a
    /// state has components.
    #[must_use]
    pub fn windows(mut self, length: f64) -> Self {
        self.division = Division::Joined(length);
        self
    }

    /// Splits each experiment into windows of about this length, with a start of its own for each. A window has at
    /// least twice as many values as a state has components.
    #[must_use]
    pub fn separate_windows(mut self, length: f64) -> Self {
        self.division = Division::Separate(length);
        self
    }

    /// Sets the maximum number of steps of the search. Default: 200.
    #[must_use]
    pub fn max_iterations(mut self, count: usize) -> Self {
        self.max_iterations = count;
        self
    }

    /// Fits the free parameters and the unknown starts to the experiments.
    ///
    /// # Errors
    /// If names, settings or measurements are invalid, or if the model cannot be integrated at its own parameters. A
    /// fit that began returns the best parameters found, with its [`Status`].
    pub fn run<M, const N: usize, const P: usize>(
        &self,
        experiments: &[Experiment<'_, M, N>],
    ) -> Result<Fitted<N, P>, FitError>
    where
        M: Parametric<N, P> + Sync,
        X: Method<M::In<Dual<f64, PART>>, Dual<f64, PART>, N> + Sync,
    {
        self.run_with(experiments, |_| ControlFlow::Continue(()))
    }

    /// Like [`run`](Self::run), and reports the progress to a function, which may stop the fit.
    ///
    /// # Errors
    /// As for [`run`](Self::run).
    pub fn run_with<M, const N: usize, const P: usize>(
        &self,
        experiments: &[Experiment<'_, M, N>],
        mut progress: impl FnMut(&Progress<'_>) -> ControlFlow<()>,
    ) -> Result<Fitted<N, P>, FitError>
    where
        M: Parametric<N, P> + Sync,
        X: Method<M::In<Dual<f64, PART>>, Dual<f64, PART>, N> + Sync,
    {
        let [first, ..] = experiments else {
            return Err(FitError::NoExperiment);
        };
        let sources = experiments.iter().enumerate().map(|(n, experiment)| {
            check_measurement(n, experiment.measurement)?;
            sources::<M, N, P>(experiment.model, experiment.measurement)
        });
        let sources = sources.collect::<Result<_, _>>()?;
        let (names, model) = (first.model.parameter_names(), first.model.cast::<f64>());
        let active = model.active();
        let (free, bounds) = self.parameters(first.model)?;
        self.check_settings()?;
        let windows = windows::divide(experiments, self.division, active)?;
        let trajectories = Trajectories::<X, M, N, P> {
            method: &self.method,
            experiments,
            sources,
            free: free.clone(),
        };
        let measurements: Vec<_> = experiments.iter().map(|experiment| experiment.measurement).collect();
        let (outputs, sensors, given) = report::sensors(&measurements);
        let (tried, hybrid) = (vec![0.0; windows.len()], model.hybrid().is_some());
        let mut search = Search {
            shooting: &trajectories,
            measurements,
            windows,
            sensors,
            tried,
            noise: given.iter().map(|given| given.unwrap_or(1.0)).collect(),
            given: given.iter().map(Option::is_some).collect(),
            has_noise: false,
            free,
            bounds,
            loss: self.loss,
            n: active,
            hybrid,
            joints: None,
            leaves_bad_windows: hybrid,
            enough: if hybrid { ENOUGH_WITH_SWITCHES } else { ENOUGH },
            max_iterations: self.max_iterations,
            iterations: 0,
            shots: 0,
        };
        let parameters = first.model.parameters().to_vec();
        let starts = starts::first(&search, &trajectories, &parameters, &self.division)?;
        let point = search.at(parameters, starts)?;
        search.check_first(&point, &names)?;
        let (point, end) = self.find(&mut search, point, &mut progress);
        let states = model.layout().map_or(&[][..], |layout| layout.states);
        Ok(report::fitted(&search, &point, end, &names, &outputs, states))
    }

    /// Indices of the free parameters, and their bounds.
    fn parameters<M, const N: usize, const P: usize>(&self, model: &M) -> Result<(Vec<usize>, Vec<[f64; 2]>), FitError>
    where
        M: Parametric<N, P>,
    {
        let (names, values) = (model.parameter_names(), model.parameters());
        let index = |name: &str| {
            let found = names.iter().position(|own| *own == name);
            found.ok_or_else(|| FitError::UnknownParameter {
                name: name.to_owned(),
                nearest: nearest(name, names.iter().copied()),
                parameters: names.iter().map(|&name| name.to_owned()).collect(),
            })
        };
        let mut free = match &self.free {
            Some(free) => free.iter().map(|name| index(name)).collect::<Result<_, _>>()?,
            None => (0..names.len()).collect::<Vec<_>>(),
        };
        free.sort_unstable();
        free.dedup();
        let mut of_all: Vec<_> = (0..P).map(|n| rules(model, n)).collect();
        for (name, bounds) in &self.bounds {
            let n = index(name)?;
            if bounds[0] > bounds[1] || bounds.iter().any(|bound| bound.is_nan()) {
                return Err(FitError::Bounds {
                    parameter: name.clone(),
                    bounds: *bounds,
                });
            }
            of_all[n] = *bounds;
            if free.contains(&n) && !(bounds[0] <= values[n] && values[n] <= bounds[1]) {
                return Err(FitError::OutsideBounds {
                    parameter: name.clone(),
                    value: values[n],
                    bounds: *bounds,
                });
            }
        }
        let bounds = free.iter().map(|&n| of_all[n]).collect();
        Ok((free, bounds))
    }

    fn check_settings(&self) -> Result<(), FitError> {
        let positive = |what, value: f64| {
            let rule = "it must be positive";
            (value > 0.0)
                .then_some(())
                .ok_or(FitError::Setting { what, value, rule })
        };
        if let Division::Joined(length) | Division::Separate(length) = self.division {
            positive("the length of the windows", length)?;
        }
        match self.loss.threshold() {
            Some(threshold) => positive("the threshold of the loss", threshold),
            None => Ok(()),
        }
    }

    /// Searches with separate windows first, then with joined ones.
    fn find(
        &self,
        search: &mut Search<'_>,
        mut point: Point,
        progress: &mut dyn FnMut(&Progress<'_>) -> ControlFlow<()>,
    ) -> (Point, End) {
        let mut end;
        (point, end) = search.minimise(point, progress);
        search.leaves_bad_windows = false;
        for _ in 0..KINKS {
            let at_a_kink = matches!(end, End::Kink | End::Stuck);
            if end.is_final() || !search.relax(&mut point, at_a_kink) && end != End::BadWindow {
                break;
            }
            (point, end) = search.minimise(point, progress);
        }
        if matches!(self.division, Division::Joined(_)) {
            let deviations = search.deviations_of_starts(&point);
            for weight in JOINING {
                if end.is_final() {
                    return (point, end);
                }
                search.joints = Some(Joints {
                    deviations: deviations.clone(),
                    weight,
                });
                (point, end) = search.minimise(point, progress);
            }
        }
        if self.loss != Loss::Squares {
            for _ in 0..MAX_NOISES {
                if end.is_final() || search.estimate_noise(&point) < NOISE_IS_FOUND {
                    break;
                }
                (point, end) = search.minimise(point, progress);
            }
        }
        (point, end)
    }
}

/// Checks that an experiment has outputs, and each of them a value.
fn check_measurement(experiment: usize, measurement: &Measurement) -> Result<(), FitError> {
    if measurement.columns.is_empty() {
        return Err(FitError::NoOutput { experiment });
    }
    let is_missing = |column: &&Column| column.values.iter().all(|value| value.is_nan());
    let missing = measurement.columns.iter().find(is_missing);
    missing.map_or(Ok(()), |column| {
        let output = column.name.clone();
        Err(FitError::NoValues { output })
    })
}

/// Bounds of a parameter by the rules of the model: zero for what must not be negative, and one for what must not be
/// larger, such as a restitution.
fn rules<M, const N: usize, const P: usize>(model: &M, n: usize) -> [f64; 2]
where
    M: Parametric<N, P>,
{
    let mut parameters = model.parameters();
    let value = parameters[n];
    let mut allows = |value| {
        parameters[n] = value;
        model.check_parameters(&parameters).is_ok()
    };
    let tiny = 1e-6 * if value == 0.0 { 1.0 } else { value.abs() };
    let low = match [allows(-tiny), allows(0.0), allows(tiny)] {
        [false, true, true] => 0.0,
        [false, false, true] => tiny,
        _ => f64::NEG_INFINITY,
    };
    let high = match [allows(1.0), allows(1.0 + 1e-6)] {
        [true, false] => 1.0,
        _ => f64::INFINITY,
    };
    [low, high]
}

/// The most similar of some names, if one is similar.
fn nearest<'n>(name: &str, names: impl Iterator<Item = &'n str>) -> Option<String> {
    let similar = |own: &str| {
        let [a, b] = [name, own].map(str::to_lowercase);
        let distance = strsim::damerau_levenshtein(&a, &b);
        // a name without its unit, or a part of it
        let contained = a.len() > 1 && b.len() > 1 && (a.contains(&b) || b.contains(&a));
        (distance <= 1 + a.len() / 4 || contained).then_some(distance)
    };
    let by_distance = names.filter_map(|own| Some((similar(own)?, own)));
    by_distance
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, own)| own.to_owned())
}
