//! Results with their uncertainty.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, StudentsT};

use super::FitError;
use super::descent::End;
use super::elimination::Echelon;
use super::fitted::{Combination, Estimate, Fitted, FittedWindow, Residuals, Status, Warning};
use super::likelihood::Likelihood;
use super::loss::Loss;
use super::measurement::Measurement;
use super::search::{Point, Search};
use super::shooting::{Shot, padded};
use crate::layout::StateVariable;

/// Singular values below this part of the largest are rounding errors.
const SINGULAR: f64 = 1e-10;
/// A combination is undetermined if its relative deviation is larger.
const UNDETERMINED: f64 = 1.0;
/// Proportions in an undetermined combination below this are left out.
const NEGLIGIBLE: f64 = 0.02;
/// Residuals with a larger correlation from sample to sample are reported.
const CORRELATED: f64 = 0.3;
/// Residuals larger than this many times their noise are reported.
const MISFIT: f64 = 1.5;
/// Neighbouring trajectories that part by less than this factor have no horizon of prediction.
const PARTS: f64 = 100.0;
/// Gaps between windows larger than this many deviations are reported.
const OPEN: f64 = 1e-2;
/// First-order states are reported whose starts have deviations larger than this many times their size.
const UNMEASURED: f64 = 10.0;

/// Names of the outputs, the index of the output of each column of each measurement, and the given deviations of their
/// noise. A column with a noise of its own counts as another output.
pub(super) fn sensors(measurements: &[&Measurement]) -> (Vec<String>, Vec<Vec<usize>>, Vec<Option<f64>>) {
    let mut sensors: Vec<(&str, Option<f64>)> = Vec::new();
    let mut of_columns = Vec::with_capacity(measurements.len());
    for measurement in measurements {
        let of_column = measurement.columns.iter().map(|column| {
            let own = (column.name.as_str(), column.noise);
            sensors.iter().position(|known| *known == own).unwrap_or_else(|| {
                sensors.push(own);
                sensors.len() - 1
            })
        });
        let of_column = of_column.collect();
        of_columns.push(of_column);
    }
    let (names, noise) = sensors
        .into_iter()
        .map(|(name, noise)| (name.to_owned(), noise))
        .unzip();
    (names, of_columns, noise)
}

impl Search<'_> {
    /// Checks that outputs and their derivatives are finite, that there are enough values, and that each free parameter
    /// has an influence.
    pub(super) fn check_first(&self, point: &Point, names: &[&str]) -> Result<(), FitError> {
        let mut wrong = None;
        for (w, shot) in point.shots.iter().enumerate() {
            let experiment = self.windows[w].experiment;
            let measurement = self.measurements[experiment];
            self.residuals(w, shot, |row, sample, column, residual| {
                let scaled = residual / self.noise_of(w, column);
                if !(scaled * scaled).is_finite() || !shot.by.row(row).iter().all(|slope| slope.is_finite()) {
                    wrong.get_or_insert(FitError::NotFinite {
                        output: measurement.columns[column].name.clone(),
                        experiment,
                        t: measurement.times[sample],
                    });
                }
            });
        }
        wrong.map_or(Ok(()), Err)?;
        let (values, unknowns) = (self.values(point), self.unknowns());
        if values <= unknowns {
            return Err(FitError::TooFewValues { values, unknowns });
        }
        for (j, &parameter) in self.free.iter().enumerate() {
            if !self.influences(point, j) {
                let parameter = names[parameter].to_owned();
                return Err(FitError::NoInfluence { parameter });
            }
        }
        Ok(())
    }

    /// The bound at which a free parameter is, if it is at one.
    fn bound_of(&self, point: &Point, j: usize) -> Option<f64> {
        let value = point.parameters[self.free[j]];
        self.bounds[j].into_iter().find(|&bound| bound == value)
    }

    /// Number of measured values.
    fn values(&self, point: &Point) -> usize {
        let mut count = 0;
        for (w, shot) in point.shots.iter().enumerate() {
            self.residuals(w, shot, |_, _, _, _| count += 1);
        }
        count
    }

    /// Number of free parameters and unknown components of starts.
    fn unknowns(&self) -> usize {
        let unknown = self.windows.iter().filter(|window| !window.known && !window.joined);
        self.free.len() + self.n * unknown.count()
    }

    /// Typical standard deviation of each component of the start of a window.
    pub(super) fn deviations_of_starts(&self, point: &Point) -> Vec<f64> {
        let of_windows = self.eliminated(point).deviations_of_starts();
        let of_component = |i: usize| {
            let mut all: Vec<f64> = of_windows.iter().map(|deviations| deviations[i]).collect();
            all.retain(|deviation| deviation.is_finite());
            all.sort_by(f64::total_cmp);
            let largest = point
                .starts
                .iter()
                .fold(0.0_f64, |most, start| most.max(start[i].abs()));
            let least = 1e-9 * if largest > 0.0 { largest } else { 1.0 };
            all.get(all.len() / 2).map_or(1e6 * least, |median| median.max(least))
        };
        (0..self.n).map(of_component).collect()
    }

    /// First-order states whose starts are not determined in separate windows: they have no influence, or one that
    /// fades faster than the samples follow one another.
    fn unmeasured(&self, point: &Point, states: &[StateVariable<'_>]) -> Vec<Warning> {
        let is_joined = |w: usize| self.windows.get(w).is_some_and(|window| window.joined);
        let mut separate = self.unknown();
        separate.retain(|&w| !is_joined(w) && !is_joined(w + 1));
        if states.is_empty() || separate.is_empty() {
            return Vec::new();
        }
        let blocks = self.blocks(point, Loss::Squares);
        let of_state = |state: &StateVariable<'_>| {
            let mut sizes: Vec<f64> = Vec::new();
            for (start, shot) in point.starts.iter().zip(&point.shots) {
                sizes.extend([start[state.index], shot.end[state.index]].map(f64::abs));
            }
            sizes.sort_by(f64::total_cmp);
            let size = sizes[sizes.len() / 2];
            let most = if size > 0.0 { UNMEASURED * size } else { f64::MAX };
            let deviations = separate
                .iter()
                .map(|&w| (w, blocks[w].deviation_of(state.index, self.n)));
            let large: Vec<_> = deviations.filter(|&(_, deviation)| deviation > most).collect();
            let &(w, deviation) = large.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
            Some(Warning::Unmeasured {
                state: state.name.to_owned(),
                windows: large.len(),
                experiment: self.windows[w].experiment,
                from: self.windows[w].span[0],
                deviation,
            })
        };
        states.iter().filter_map(of_state).collect()
    }

    fn warnings(&self, point: &Point, residuals: &[Residuals], outputs: &[String], names: &[&str]) -> Vec<Warning> {
        let mut warnings = Vec::new();
        for (j, &n) in self.free.iter().enumerate() {
            if let Some(bound) = self.bound_of(point, j) {
                let parameter = names[n].to_owned();
                warnings.push(Warning::AtBound { parameter, bound });
            }
        }
        for (n, output) in outputs.iter().enumerate() {
            // sums of the products of consecutive residuals, and of the squares
            let (mut products, mut squares, mut count) = (0.0, 0.0, 0.0_f64);
            let of_columns = self.sensors.iter().flatten().zip(residuals);
            for (_, residuals) in of_columns.filter(|(sensor, _)| **sensor == n) {
                let known: Vec<f64> = residuals.values.iter().copied().filter(|r| !r.is_nan()).collect();
                products += known.windows(2).map(|pair| pair[0] * pair[1]).sum::<f64>();
                squares += known.iter().map(|r| r * r).sum::<f64>();
                count += known.len() as f64;
            }
            let correlation = products / squares;
            if correlation > CORRELATED.max(3.0 / count.sqrt()) {
                let output = output.clone();
                warnings.push(Warning::Correlated { output, correlation });
            }
            let ratio = (squares / count).sqrt() / self.noise[n];
            if self.given[n] && ratio > MISFIT {
                let output = output.clone();
                warnings.push(Warning::Misfit { output, ratio });
            }
        }
        warnings.extend(self.shooting.check(&point.parameters).err().map(Warning::Impossible));
        warnings.extend(self.horizon(point));
        if self.windows.iter().any(|window| window.joined) {
            let separate = || self.deviations_of_starts(point);
            let joints = self.joints.as_ref();
            let deviations = joints.map_or_else(separate, |joints| joints.deviations.clone());
            let joined = (0..self.windows.len()).filter(|&w| self.windows[w].joined);
            let gaps = joined.flat_map(|w| self.gap(w, point).zip(&deviations));
            let gap = gaps.fold(0.0_f64, |most, (gap, deviation)| most.max((gap / deviation).abs()));
            if gap > OPEN {
                warnings.push(Warning::Gap(gap));
            }
        }
        warnings
    }

    /// The window that is longest in terms of its horizon of prediction, if it is beyond.
    fn horizon(&self, point: &Point) -> Option<Warning> {
        let scales = self.deviations_of_starts(point);
        let of_window = |(w, shot): (usize, &Shot)| {
            let window = &self.windows[w];
            let length = window.span[1] - window.span[0];
            let transition = DMatrix::from_fn(self.n, self.n, |i, j| shot.end_by[(i, j)] * scales[j] / scales[i]);
            if window.known || length <= 0.0 {
                return None;
            }
            let growth = match transition.iter().all(|entry| entry.is_finite()) {
                true => transition.singular_values().max(),
                false => f64::INFINITY,
            };
            let exponent = libm::log(growth) / length;
            // the smallest noise relative to the size of its output
            let columns = &self.measurements[window.experiment].columns;
            let size = columns.iter().enumerate().map(|(c, column)| {
                let known = || {
                    column.values[window.samples.clone()]
                        .iter()
                        .filter(|value| !value.is_nan())
                };
                let [low, high] = [
                    known().copied().fold(f64::INFINITY, f64::min),
                    known().copied().fold(f64::NEG_INFINITY, f64::max),
                ];
                (high - low) / self.noise[self.sensors[window.experiment][c]]
            });
            let size = size.fold(1.0_f64, f64::max);
            let horizon = libm::log(size) / exponent;
            (growth > PARTS && length > horizon).then_some((
                length / horizon,
                Warning::BeyondHorizon {
                    experiment: window.experiment,
                    from: window.span[0],
                    length,
                    exponent,
                    horizon,
                },
            ))
        };
        let beyond = point.shots.iter().enumerate().filter_map(of_window);
        beyond.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, warning)| warning)
    }
}

/// The result at a point.
pub(super) fn fitted<const N: usize, const P: usize>(
    search: &Search<'_>,
    point: &Point,
    end: End,
    names: &[&str],
    outputs: &[String],
    states: &[StateVariable<'_>],
) -> Fitted<N, P> {
    let (values, unknowns) = (search.values(point), search.unknowns());
    let left = values.saturating_sub(unknowns).max(1) as f64;
    let (residuals, squares, [sum, curvature]) = residuals_of(search, point);
    // for robust losses by Huber's formula; the mean curvature is 1 for squares
    let curvature = curvature / values as f64;
    let variance = sum / (left * curvature * curvature);
    let (covariance, undetermined) = covariance(search, point, variance, names);
    let quantile = StudentsT::new(0.0, 1.0, left).map_or(f64::NAN, |student| student.inverse_cdf(0.975));
    let estimates = search.free.iter().enumerate().map(|(j, &n)| {
        let deviation = covariance[(j, j)].sqrt();
        estimate(names[n], point.parameters[n], deviation, quantile)
    });
    let windows = search.windows.iter().enumerate().map(|(w, window)| FittedWindow {
        experiment: window.experiment,
        t0: window.span[0],
        t1: window.span[1],
        start: padded(&point.starts[w]),
        end: padded(&point.shots[w].end),
    });
    // without the bias of the estimate that maximises the likelihood
    let spared = (values as f64 / left).sqrt();
    let noise = outputs.iter().zip(&search.noise).zip(&search.given);
    let noise = noise.map(|((name, noise), given)| (name.clone(), if *given { *noise } else { noise * spared }));
    let mut warnings = search.warnings(point, &residuals, outputs, names);
    warnings.extend(search.unmeasured(point, states));
    let logarithm = squares
        .iter()
        .zip(&search.noise)
        .map(|(&[sum, count], deviation)| -0.5 * (sum + count * libm::log(TAU * deviation * deviation)));
    Fitted {
        parameters: std::array::from_fn(|n| point.parameters[n]),
        estimates: estimates.collect(),
        covariance,
        undetermined,
        windows: windows.collect(),
        noise: noise.collect(),
        likelihood: Likelihood {
            logarithm: if search.loss == Loss::Squares {
                logarithm.sum()
            } else {
                f64::NAN
            },
            unknowns: unknowns + search.given.iter().filter(|given| !**given).count(),
            values,
        },
        warnings,
        residuals,
        status: match end {
            End::Converged | End::Kink => Status::Converged,
            // a search goes on after it was interrupted
            End::Stuck | End::BadWindow => Status::Stuck,
            End::OutOfIterations => Status::OutOfIterations,
            End::Stopped => Status::Stopped,
        },
        iterations: search.iterations,
        integrations: search.shots,
    }
}

/// Estimate with its confidence interval, by a quantile of the distribution of its error over its deviation.
fn estimate(name: &str, value: f64, deviation: f64, quantile: f64) -> Estimate {
    let reach = if deviation > 0.0 { quantile * deviation } else { 0.0 };
    Estimate {
        name: name.to_owned(),
        value,
        deviation,
        interval: [value - reach, value + reach],
    }
}

/// Covariance of the free parameters, and their combinations that are not determined.
fn covariance(search: &Search<'_>, point: &Point, variance: f64, names: &[&str]) -> (DMatrix<f64>, Vec<Combination>) {
    let root = search.eliminated(point).parameters.upper();
    let p = search.free.len();
    // parameters at a bound do not vary
    let inner: Vec<usize> = (0..p).filter(|&j| search.bound_of(point, j).is_none()).collect();
    let scales: Vec<f64> = inner
        .iter()
        .map(|&j| point.parameters[search.free[j]].abs())
        .map(|size| if size > 0.0 { size } else { 1.0 })
        .collect();
    let scaled = DMatrix::from_fn(root.nrows(), inner.len(), |i, k| root[(i, inner[k])] * scales[k]);
    let (relative, undetermined) = uncertainty(scaled, variance, |k| names[search.free[inner[k]]]);
    let mut covariance = DMatrix::zeros(p, p);
    for (a, &i) in inner.iter().enumerate() {
        for (b, &j) in inner.iter().enumerate() {
            covariance[(i, j)] = relative[(a, b)] * scales[a] * scales[b];
        }
    }
    (covariance, undetermined)
}

/// Residuals of each column; for each output the sum of the squares over its noise, and the number of values; and the
/// sums of the squares of the slopes of half the losses, and of their curvatures.
fn residuals_of(search: &Search<'_>, point: &Point) -> (Vec<Residuals>, Vec<[f64; 2]>, [f64; 2]) {
    let mut of_loss = [0.0; 2];
    let mut residuals: Vec<Vec<Residuals>> = Vec::new();
    for (experiment, measurement) in search.measurements.iter().enumerate() {
        let of_column = measurement.columns.iter().map(|column| Residuals {
            experiment,
            output: column.name.clone(),
            values: vec![f64::NAN; measurement.times.len()],
        });
        residuals.push(of_column.collect());
    }
    let mut squares = vec![[0.0; 2]; search.noise.len()];
    for (w, shot) in point.shots.iter().enumerate() {
        let experiment = search.windows[w].experiment;
        search.residuals(w, shot, |_, sample, column, residual| {
            residuals[experiment][column].values[sample] = residual;
            let sensor = search.sensors[experiment][column];
            let z = residual / search.noise[sensor];
            squares[sensor][0] += z * z;
            squares[sensor][1] += 1.0;
            let slope = search.loss.of(z)[1] * z;
            of_loss[0] += slope * slope;
            of_loss[1] += search.loss.curvature(z);
        });
    }
    (residuals.into_iter().flatten().collect(), squares, of_loss)
}

/// Covariance of relative changes, from a square root of the information matrix, and the combinations that are not
/// determined.
fn uncertainty<'n>(
    root: DMatrix<f64>,
    variance: f64,
    name: impl Fn(usize) -> &'n str,
) -> (DMatrix<f64>, Vec<Combination>) {
    let p = root.ncols();
    let mut undetermined = Vec::new();
    let mut covariance = DMatrix::zeros(p, p);
    if p == 0 {
        return (covariance, undetermined);
    }
    // square, so that there are as many singular values as parameters
    let square = Echelon::new(root, p).upper().resize(p, p, 0.0);
    if square.iter().any(|entry| !entry.is_finite()) {
        covariance.fill(f64::NAN);
        return (covariance, undetermined);
    }
    let svd = square.svd(false, true);
    let Some(directions) = &svd.v_t else {
        return (covariance, undetermined);
    };
    let least = SINGULAR * svd.singular_values.max();
    let mut free: Vec<DVector<f64>> = Vec::new();
    for (value, direction) in svd.singular_values.iter().zip(directions.row_iter()) {
        let direction: DVector<f64> = direction.transpose();
        if *value <= least {
            free.push(direction);
            continue;
        }
        let deviation = variance.sqrt() / value;
        covariance += &direction * direction.transpose() * (deviation * deviation);
        if deviation > UNDETERMINED {
            let combination = combination(&direction, deviation, &name);
            // one parameter alone is known to be near zero
            if combination.terms.len() > 1 {
                undetermined.push(combination);
            }
        }
    }
    sparse(&mut free);
    for direction in &free {
        for (i, a) in direction.iter().enumerate() {
            for (j, b) in direction.iter().enumerate() {
                if a.abs() > NEGLIGIBLE && b.abs() > NEGLIGIBLE {
                    covariance[(i, j)] += f64::INFINITY * (a * b).signum();
                }
            }
        }
        undetermined.push(combination(direction, f64::INFINITY, &name));
    }
    (covariance, undetermined)
}

/// Combines directions so that each has few parts: subtracts multiples of others while this removes parts.
fn sparse(directions: &mut [DVector<f64>]) {
    let parts = |direction: &DVector<f64>| {
        let least = NEGLIGIBLE * direction.amax();
        direction.iter().filter(|part| part.abs() > least).count()
    };
    let count = directions.len();
    let mut better = count > 1;
    while better {
        better = false;
        for (a, b) in (0..count)
            .flat_map(|a| (0..count).map(move |b| (a, b)))
            .filter(|(a, b)| a != b)
        {
            for k in 0..directions[a].len() {
                let [from, by] = [directions[a][k], directions[b][k]];
                if by.abs() <= NEGLIGIBLE * directions[b].amax() {
                    continue;
                }
                let fewer = &directions[a] - &directions[b] * (from / by);
                if fewer.amax() > NEGLIGIBLE && parts(&fewer) < parts(&directions[a]) {
                    directions[a] = fewer.normalize();
                    better = true;
                }
            }
        }
    }
}

/// A combination of parameters, with the largest part first.
fn combination<'n>(direction: &DVector<f64>, deviation: f64, name: impl Fn(usize) -> &'n str) -> Combination {
    let parts = direction.iter().enumerate();
    let mut terms: Vec<(String, f64)> = parts.map(|(k, &part)| (name(k).to_owned(), part)).collect();
    terms.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
    let largest = terms[0].1;
    terms.iter_mut().for_each(|(_, part)| *part /= largest);
    terms.retain(|(_, part)| part.abs() >= NEGLIGIBLE);
    Combination { terms, deviation }
}
