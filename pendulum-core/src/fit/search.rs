//! The problem of a fit: residuals, their noise, the loss, and its linear model.

use std::ops::Range;

use nalgebra::DMatrix;

use super::FitError;
use super::elimination::{Block, Damping, Echelon, Eliminated};
use super::loss::Loss;
use super::measurement::Measurement;
use super::parallel;
use super::shooting::{PART, Shooting, Shot};
use super::windows::Window;

/// Residuals without noise have this variance at least.
const LEAST_VARIANCE: f64 = 1e-200;
/// Median of the absolute value of a normal variable with standard deviation 1.
const MEDIAN: f64 = 0.674_489_750_196_081_7;

/// Numbers that the search adjusts, and the trajectories there.
#[derive(Clone)]
pub(super) struct Point {
    pub(super) parameters: Vec<f64>,
    pub(super) starts: Vec<Vec<f64>>,
    pub(super) shots: Vec<Shot>,
    /// Twice the negative logarithm of the likelihood, up to a constant: the losses of all residuals of known noise, `n
    /// ln s^2` for `n` residuals of mean square `s^2` whose noise is not known, and the squares of the weighted gaps
    /// between joined windows.
    pub(super) loss: f64,
}

/// Problem and progress of a search.
pub(super) struct Search<'a> {
    pub(super) shooting: &'a dyn Shooting,
    pub(super) measurements: Vec<&'a Measurement>,
    pub(super) windows: Vec<Window>,
    /// For each column of each measurement, the index of its noise.
    pub(super) sensors: Vec<Vec<usize>>,
    /// Standard deviations of the noise, given or estimated from the residuals.
    pub(super) noise: Vec<f64>,
    /// True for the noise that is given.
    pub(super) given: Vec<bool>,
    /// True once the noise is estimated.
    pub(super) has_noise: bool,
    /// Indices of the free parameters.
    pub(super) free: Vec<usize>,
    /// Bounds of the free parameters.
    pub(super) bounds: Vec<[f64; 2]>,
    pub(super) loss: Loss,
    /// Length of a state.
    pub(super) n: usize,
    /// True if modes may switch, so that the loss has kinks.
    pub(super) hybrid: bool,
    /// Weights of the gaps between joined windows; none while windows are separate.
    pub(super) joints: Option<Joints>,
    /// For each window, the mean square of its residuals over that of the median window, when it was last fitted from
    /// other starts; 0 if it was not.
    pub(super) tried: Vec<f64>,
    /// True if the search is interrupted near its end for windows that are bad.
    pub(super) leaves_bad_windows: bool,
    /// Least decrease of the loss that is worth a step, as a part of that of one residual.
    pub(super) enough: f64,
    pub(super) max_iterations: usize,
    pub(super) iterations: usize,
    pub(super) shots: usize,
}

/// Weights of the gaps between joined windows.
#[derive(Clone, Debug)]
pub(super) struct Joints {
    /// Standard deviation of the start of a separate window, for each component.
    pub(super) deviations: Vec<f64>,
    /// Weight of a gap of one deviation.
    pub(super) weight: f64,
}

impl Joints {
    fn weights(&self) -> impl Iterator<Item = f64> {
        self.deviations.iter().map(|deviation| self.weight / deviation)
    }
}

impl Search<'_> {
    /// Integrates all windows.
    ///
    /// # Errors
    /// The first window that cannot be integrated.
    pub(super) fn at(&mut self, parameters: Vec<f64>, starts: Vec<Vec<f64>>) -> Result<Point, FitError> {
        let point = self.begin_at(parameters, starts)?;
        self.complete(point)
    }

    /// Integrates all windows, with derivatives by the first variables alone: the others only matter where the loss
    /// decreases.
    pub(super) fn begin_at(&mut self, parameters: Vec<f64>, starts: Vec<Vec<f64>>) -> Result<Point, FitError> {
        let shots = self.shoot(&parameters, &starts, 0..PART.min(self.variables()))?;
        self.shots += shots.len();
        let mut point = Point {
            parameters,
            starts,
            shots,
            loss: 0.0,
        };
        point.loss = self.loss_of(&point);
        Ok(point)
    }

    /// Adds the derivatives by the other variables.
    pub(super) fn complete(&self, mut point: Point) -> Result<Point, FitError> {
        if self.variables() > PART {
            let others = self.shoot(&point.parameters, &point.starts, PART..self.variables())?;
            for (shot, others) in point.shots.iter_mut().zip(&others) {
                shot.append(others);
            }
        }
        Ok(point)
    }

    /// Windows whose start is not known.
    pub(super) fn unknown(&self) -> Vec<usize> {
        (0..self.windows.len()).filter(|&w| !self.windows[w].known).collect()
    }

    /// Number of variables of a window: its start, and the free parameters.
    pub(super) fn variables(&self) -> usize {
        self.n + self.free.len()
    }

    /// True if an output depends on a free parameter.
    pub(super) fn influences(&self, point: &Point, j: usize) -> bool {
        let of = |shot: &Shot| shot.by.column(self.n + j).iter().any(|&slope| slope != 0.0);
        point.shots.iter().any(of)
    }

    /// Integrates all windows, on all cores, with derivatives by some of the variables. The results do not depend on
    /// the number of cores.
    fn shoot(&self, parameters: &[f64], starts: &[Vec<f64>], variables: Range<usize>) -> Result<Vec<Shot>, FitError> {
        let shoot = |w: usize| {
            let window = &self.windows[w];
            let shot = (self.shooting).shoot(window, &starts[w], parameters, &self.free, variables.clone());
            shot.map_err(|reason| FitError::Integration {
                experiment: window.experiment,
                from: window.span[0],
                reason: Box::new(reason),
            })
        };
        parallel::each(self.windows.len(), shoot).into_iter().collect()
    }

    /// Calls `each` for each residual of a window: its row, its sample, its column and measured minus computed value.
    pub(super) fn residuals(&self, w: usize, shot: &Shot, mut each: impl FnMut(usize, usize, usize, f64)) {
        let window = &self.windows[w];
        let columns = &self.measurements[window.experiment].columns;
        let mut row = 0;
        for sample in window.samples.clone() {
            for (c, column) in columns.iter().enumerate() {
                let residual = column.values[sample] - shot.outputs[row];
                if !column.values[sample].is_nan() {
                    each(row, sample, c, residual);
                }
                row += 1;
            }
        }
    }

    /// Standard deviation of the noise of a column in a window.
    pub(super) fn noise_of(&self, w: usize, column: usize) -> f64 {
        self.noise[self.sensors[self.windows[w].experiment][column]]
    }

    /// The end of the window before minus the start of a window that continues it.
    pub(super) fn gap<'p>(&self, w: usize, point: &'p Point) -> impl Iterator<Item = f64> + 'p {
        let ends = point.shots[w - 1].end.iter().zip(&point.starts[w]);
        ends.map(|(end, start)| end - start)
    }

    pub(super) fn loss_of(&self, point: &Point) -> f64 {
        // for each output of unknown noise, the sum of squares and the number of values
        let mut squares = vec![[0.0; 2]; self.noise.len()];
        let mut sum = 0.0;
        for (w, shot) in point.shots.iter().enumerate() {
            let sensors = &self.sensors[self.windows[w].experiment];
            self.residuals(w, shot, |_, _, column, residual| {
                let sensor = sensors[column];
                if self.given[sensor] || self.loss != Loss::Squares {
                    sum += self.loss.of(residual / self.noise[sensor])[0];
                } else {
                    squares[sensor][0] += residual * residual;
                    squares[sensor][1] += 1.0;
                }
            });
            if let Some(joints) = self.joints.as_ref().filter(|_| self.windows[w].joined) {
                let gaps = self.gap(w, point).zip(joints.weights());
                sum += gaps.map(|(gap, weight)| weight * gap * weight * gap).sum::<f64>();
            }
        }
        let unknown = squares.iter().filter(|[_, count]| *count > 0.0);
        sum += unknown
            .map(|[sum, count]| count * libm::log((sum / count).max(LEAST_VARIANCE)))
            .sum::<f64>();
        if sum.is_nan() { f64::INFINITY } else { sum }
    }

    /// Estimates unknown noise from the residuals: their root mean square, which maximises the likelihood, or for a
    /// robust loss their median, which outliers hardly move. Returns the largest relative change.
    pub(super) fn estimate_noise(&mut self, point: &Point) -> f64 {
        self.has_noise = true;
        if !self.given.contains(&false) {
            return 0.0;
        }
        let mut largest = 0.0_f64;
        let mut squares = vec![Vec::new(); self.noise.len()];
        for (w, shot) in point.shots.iter().enumerate() {
            let sensors = &self.sensors[self.windows[w].experiment];
            self.residuals(w, shot, |_, _, column, residual| {
                squares[sensors[column]].push(residual * residual);
            });
        }
        for (n, squares) in squares.iter_mut().enumerate() {
            if self.given[n] || squares.is_empty() {
                continue;
            }
            let variance = if self.loss == Loss::Squares {
                squares.iter().sum::<f64>() / squares.len() as f64
            } else {
                squares.sort_by(f64::total_cmp);
                squares[squares.len() / 2] / (MEDIAN * MEDIAN)
            };
            let deviation = variance.max(LEAST_VARIANCE).sqrt();
            largest = largest.max((deviation / self.noise[n] - 1.0).abs());
            self.noise[n] = deviation;
        }
        largest
    }

    /// Sum of the losses of the residuals in a window, each divided by its noise, and their number.
    pub(super) fn weighted_squares(&self, w: usize, shot: &Shot) -> [f64; 2] {
        let (mut sum, mut count) = (0.0, 0.0);
        self.residuals(w, shot, |_, _, column, residual| {
            sum += self.loss.of(residual / self.noise_of(w, column))[0];
            count += 1.0;
        });
        [sum, count]
    }

    /// Mean of the weighted squares of all residuals: 1 where the noise is estimated.
    pub(super) fn mean_square(&self, point: &Point) -> f64 {
        let of_windows = point
            .shots
            .iter()
            .enumerate()
            .map(|(w, shot)| self.weighted_squares(w, shot));
        let [sum, count] = of_windows.fold([0.0; 2], |all, own| [all[0] + own[0], all[1] + own[1]]);
        sum / f64::max(count, 1.0)
    }

    /// The linearised problem, with the weights of a loss.
    pub(super) fn blocks(&self, point: &Point, loss: Loss) -> Vec<Block> {
        let (n, p) = (self.n, self.free.len());
        let block = |w: usize| {
            let shot = &point.shots[w];
            // missing values have no weight
            let mut roots = vec![0.0; shot.outputs.len()];
            let mut residuals = roots.clone();
            self.residuals(w, shot, |row, _, column, residual| {
                let deviation = self.noise_of(w, column);
                roots[row] = loss.of(residual / deviation)[1].sqrt() / deviation;
                residuals[row] = roots[row] * residual;
            });
            let mut rows = Vec::with_capacity(roots.len() * (n + p + 1));
            for slopes in shot.by.as_slice().chunks_exact(roots.len().max(1)).take(n + p) {
                rows.extend(slopes.iter().zip(&roots).map(|(slope, root)| root * slope));
            }
            rows.extend(residuals);
            let rows = DMatrix::from_vec(roots.len(), n + p + 1, rows);
            let joint = self.joints.as_ref().filter(|_| self.windows[w].joined).map(|joints| {
                let (before, mut gap) = (&point.shots[w - 1], self.gap(w, point));
                let mut rows = DMatrix::zeros(n, 2 * n + p + 1);
                for (i, weight) in joints.weights().enumerate() {
                    for variable in 0..n + p {
                        let place = if variable < n { variable } else { variable + n };
                        rows[(i, place)] = weight * before.end_by[(i, variable)];
                    }
                    rows[(i, n + i)] = -weight;
                    rows[(i, 2 * n + p)] = -weight * gap.next().unwrap_or_default();
                }
                rows
            });
            Block {
                rows: Echelon::new(rows, n + p).upper(),
                joint,
            }
        };
        parallel::each(point.shots.len(), block)
    }

    /// The problem without starts, for standard deviations: all residuals have the same weight.
    pub(super) fn eliminated(&self, point: &Point) -> Eliminated {
        let blocks = self.blocks(point, Loss::Squares);
        let none = Damping {
            starts: vec![vec![0.0; self.n]; blocks.len()],
            parameters: vec![0.0; self.free.len()],
        };
        Eliminated::new(&blocks, [self.n, self.free.len()], &none)
    }
}

#[cfg(test)]
impl<'a> Search<'a> {
    /// Search for states of one component in a smooth scene, with noise of deviation 1 and without free parameters.
    pub(super) fn of_noise_1(shooting: &'a dyn Shooting, measurement: &'a Measurement, windows: Vec<Window>) -> Self {
        let sensors = measurement.columns.len();
        Self {
            shooting,
            measurements: vec![measurement],
            sensors: vec![(0..sensors).collect()],
            noise: vec![1.0; sensors],
            given: vec![true; sensors],
            has_noise: true,
            free: Vec::new(),
            bounds: Vec::new(),
            loss: Loss::Squares,
            n: 1,
            hybrid: false,
            joints: None,
            tried: vec![0.0; windows.len()],
            windows,
            leaves_bad_windows: false,
            enough: super::descent::ENOUGH,
            max_iterations: 100,
            iterations: 0,
            shots: 0,
        }
    }
}
