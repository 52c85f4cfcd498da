//! Results of fits.

use std::fmt;

use nalgebra::{DMatrix, SVector};

use super::likelihood::Likelihood;
use crate::error::{ParameterError, messages};

/// The result of a fit. `N` is the length of the state, `P` the number of parameters of the scene.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Fitted<const N: usize, const P: usize> {
    /// All parameters of the scene, in the order of declaration: `NameParams::from_array(fitted.parameters)`.
    pub parameters: [f64; P],
    /// The free parameters, in the order of declaration.
    pub estimates: Vec<Estimate>,
    /// Covariance of the estimates, for residuals without correlation; infinite where the measurements have no
    /// influence, and zero for parameters at a bound.
    pub covariance: DMatrix<f64>,
    /// Combinations of free parameters that the measurements do not determine.
    pub undetermined: Vec<Combination>,
    /// Trajectories, in the order of the experiments and of time: one for each window.
    pub windows: Vec<FittedWindow<N>>,
    /// Residuals of each output of each experiment.
    pub residuals: Vec<Residuals>,
    /// Standard deviation of the noise of each output, given or estimated.
    pub noise: Vec<(String, f64)>,
    /// Likelihood of the measurements, to compare models.
    pub likelihood: Likelihood,
    /// Reasons to doubt the result.
    pub warnings: Vec<Warning>,
    /// Way in which the fit ended. The parameters are the best found in any case.
    pub status: Status,
    /// Number of steps of the search.
    pub iterations: usize,
    /// Number of windows that were integrated.
    pub integrations: usize,
}

/// The estimate of a parameter.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Estimate {
    /// Name of the parameter.
    pub name: String,
    /// Estimated value.
    pub value: f64,
    /// Its standard deviation.
    pub deviation: f64,
    /// Confidence interval of 95 %, by Student's distribution.
    pub interval: [f64; 2],
}

/// A combination of parameters that the measurements do not determine: relative changes of the parameters in these
/// proportions have less influence than the noise, even as large as the parameters themselves.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Combination {
    /// Names and proportions, the largest first, which is 1.
    pub terms: Vec<(String, f64)>,
    /// Standard deviation of the relative change; infinite without any influence.
    pub deviation: f64,
}

/// A trajectory in a window.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FittedWindow<const N: usize> {
    /// Index of the experiment.
    pub experiment: usize,
    /// Time at its start.
    pub t0: f64,
    /// Time at its end.
    pub t1: f64,
    /// State at its start.
    pub start: SVector<f64, N>,
    /// State at its end.
    pub end: SVector<f64, N>,
}

/// Residuals of an output in an experiment.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Residuals {
    /// Index of the experiment.
    pub experiment: usize,
    /// Name of the output.
    pub output: String,
    /// Measured minus computed values at the times of the measurement; NaN where missing.
    pub values: Vec<f64>,
}

impl Residuals {
    /// Root mean square.
    #[must_use]
    pub fn rms(&self) -> f64 {
        let known = || self.values.iter().filter(|value| !value.is_nan());
        (known().map(|value| value * value).sum::<f64>() / known().count() as f64).sqrt()
    }
}

/// Way in which a fit ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Status {
    /// No step decreases the loss noticeably.
    Converged,
    /// No step that the derivatives suggest decreases the loss, although it should. The best point may be far away:
    /// begin at other parameters, split the motion into [windows](super::Fit::windows), or choose a finer method.
    Stuck,
    /// The maximum number of iterations was reached.
    OutOfIterations,
    /// The caller stopped the fit.
    Stopped,
}

/// A reason to doubt a fit.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// A window is longer than the horizon of prediction: the noise at its start grows to the size of the motion.
    /// Choose [shorter windows](super::Fit::windows).
    BeyondHorizon {
        /// Index of the experiment.
        experiment: usize,
        /// Time at the start of the window.
        from: f64,
        /// Length of the window.
        length: f64,
        /// Mean rate at which neighbouring trajectories part, in 1/s.
        exponent: f64,
        /// Horizon of prediction, in s.
        horizon: f64,
    },
    /// A parameter is at one of its bounds; its deviation is zero, and those of the others hold for this value.
    AtBound {
        /// Name of the parameter.
        parameter: String,
        /// The bound.
        bound: f64,
    },
    /// A model with the best parameters is impossible, such as one with an inertia that no body can have: the scene
    /// misses something, or the measurement does not determine the parameters of the error. Fix or bound some of these.
    Impossible(ParameterError),
    /// Residuals of an output are correlated from sample to sample: the scene or its inputs miss something, the method
    /// is too coarse, or another point is better. The deviations of the estimates are too small.
    Correlated {
        /// Name of the output.
        output: String,
        /// Correlation of consecutive residuals.
        correlation: f64,
    },
    /// Residuals of an output are larger than its stated noise.
    Misfit {
        /// Name of the output.
        output: String,
        /// Their root mean square over the standard deviation of the noise.
        ratio: f64,
    },
    /// The windows of a trajectory do not join: the largest gap, relative to the deviation of a start.
    Gap(f64),
    /// The start of a first-order state is not determined in separate windows: its deviation is more than ten times the
    /// size of the state, so that it follows the errors of the scene there, or keeps its first guess. Measure the state
    /// itself by [`output_with_noise`](super::Measurement::output_with_noise), as zero with a deviation of its size, at
    /// the first sample of each window, and as NaN elsewhere. A start that is known is one by
    /// [`from_known`](super::Experiment::from_known).
    Unmeasured {
        /// Name of the state.
        state: String,
        /// Number of windows in which it is not determined.
        windows: usize,
        /// Index of the experiment with the largest deviation.
        experiment: usize,
        /// Time at the start of the window with the largest deviation.
        from: f64,
        /// The largest deviation, for given parameters and in the unit of the state; infinite if the window does not
        /// determine it.
        deviation: f64,
    },
}

messages! {
    [] Warning;
    Self::BeyondHorizon { experiment, from, length, exponent, horizon } =>
        "experiment {experiment}: the window of {length:.3} s from t = {from:.3} is longer than the horizon of \
         prediction, {horizon:.2} s at an exponent of {exponent:.2}/s; choose shorter windows";
    Self::Impossible(error) => "the best parameters are impossible, fix or bound some: {error}";
    Self::AtBound { parameter, bound } => "`{parameter}` is at its bound {bound}";
    Self::Correlated { output, correlation } =>
        "residuals of `{output}` are correlated ({correlation:.2} from sample to sample): the scene misses something, \
         the method is too coarse, or the fit is not the best one; deviations are too small";
    Self::Misfit { output, ratio } => "residuals of `{output}` are {ratio:.3e} times its noise";
    Self::Gap(gap) => "windows do not join: the largest gap is {gap:.1e} deviations of a start";
    Self::Unmeasured { state, windows, experiment, from, deviation } =>
        "the start of the state `{state}` is not determined in {windows} of the windows, least of all in experiment \
         {experiment} from t = {from:.3} ({by}); measure `{state}` as 0 at the first sample of each, with a deviation \
         of its size, and as NaN elsewhere",
        by = if deviation.is_finite() { format!("deviation {deviation:.1e}") } else { "not at all".to_owned() };
}

impl fmt::Display for Combination {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("not determined: relative changes of")?;
        for (n, (name, part)) in self.terms.iter().enumerate() {
            let join = if n == 0 { "" } else { "," };
            write!(f, "{join} {part:+.2} `{name}`")?;
        }
        if self.deviation.is_finite() {
            write!(f, " (deviation {:.0} %)", 100.0 * self.deviation)
        } else {
            f.write_str(" (no influence)")
        }
    }
}

impl<const N: usize, const P: usize> Fitted<N, P> {
    /// The estimate of a free parameter.
    #[must_use]
    pub fn estimate(&self, name: &str) -> Option<&Estimate> {
        self.estimates.iter().find(|estimate| estimate.name == name)
    }

    /// Standard deviation of the noise of an output, given or estimated.
    #[must_use]
    pub fn noise_of(&self, output: &str) -> Option<f64> {
        let found = self.noise.iter().find(|(name, _)| name == output);
        found.map(|&(_, deviation)| deviation)
    }

    /// Root mean square of all residuals of an output; NaN if it is not measured.
    #[must_use]
    pub fn rms(&self, output: &str) -> f64 {
        let of_output = self.residuals.iter().filter(|residuals| residuals.output == output);
        let known = || {
            let values = of_output.clone().flat_map(|residuals| &residuals.values);
            values.filter(|value| !value.is_nan())
        };
        (known().map(|value| value * value).sum::<f64>() / known().count() as f64).sqrt()
    }
}

/// A number with three digits of its deviation.
fn rounded(number: f64, deviation: f64) -> String {
    let size = if deviation > 0.0 && deviation.is_finite() {
        deviation
    } else {
        1e-6 * number.abs()
    };
    if !(size > 0.0 && number.is_finite()) {
        return number.to_string();
    }
    let place = libm::log10(size).floor() as i32 - 2;
    if (-9..=0).contains(&place) {
        return format!("{number:.*}", place.unsigned_abs() as usize);
    }
    let digits = libm::log10(number.abs().max(size)).floor() as i32 - place;
    format!("{number:.*e}", digits.clamp(2, 16) as usize)
}

/// A table of the estimates, with warnings.
impl<const N: usize, const P: usize> fmt::Display for Fitted<N, P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = self.estimates.iter().map(|estimate| estimate.name.chars().count());
        let width = names.max().unwrap_or(0).max("parameter".len());
        if !self.estimates.is_empty() {
            writeln!(
                f,
                "{:width$}  {:>12}  {:>9}  interval of 95 %",
                "parameter", "estimate", "deviation"
            )?;
        }
        for estimate in &self.estimates {
            let [value, low, high] = [estimate.value, estimate.interval[0], estimate.interval[1]]
                .map(|number| rounded(number, estimate.deviation));
            writeln!(
                f,
                "{:width$}  {value:>12}  {:>9.1e}  {low} to {high}",
                estimate.name, estimate.deviation
            )?;
        }
        for (output, noise) in &self.noise {
            writeln!(
                f,
                "residuals of `{output}`: {:.2e}, noise {noise:.2e}",
                self.rms(output)
            )?;
        }
        for combination in &self.undetermined {
            writeln!(f, "{combination}")?;
        }
        for warning in &self.warnings {
            writeln!(f, "warning: {warning}")?;
        }
        match self.status {
            Status::Converged => write!(f, "converged after {} iterations", self.iterations),
            Status::Stuck => write!(
                f,
                "stuck after {} iterations: no step decreases the loss",
                self.iterations
            ),
            Status::OutOfIterations => write!(f, "not converged after {} iterations", self.iterations),
            Status::Stopped => write!(f, "stopped after {} iterations", self.iterations),
        }
    }
}
