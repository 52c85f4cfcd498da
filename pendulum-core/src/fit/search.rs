//! The method of Levenberg and Marquardt for the starts of all windows and the free parameters.
//!
//! K. Madsen, H. B. Nielsen, O. Tingleff, "Methods for Non-Linear Least Squares Problems", 2nd ed. (2004), 3.2.

use std::ops::{ControlFlow, Range};

use nalgebra::DMatrix;

use super::elimination::{Block, Damping, Echelon, Eliminated, within};
use super::loss::Loss;
use super::measurement::Measurement;
use super::parallel::Work;
use super::shooting::{PART, Shooting, Shot};
use super::windows::Window;
use super::{FitError, Progress};

/// First damping, relative to the lengths of the columns of the Jacobian.
const FIRST_DAMPING: f64 = 1e-3;
/// No step decreases the loss if one with this damping does not.
const MOST_DAMPING: f64 = 1e8;
/// The search ends where a step would decrease the loss by less than this part of that of one residual: parameters are
/// then within 1e-4 of their standard deviations.
pub(super) const ENOUGH: f64 = 1e-8;
/// The search also ends after `LAST` steps that decrease the loss by less than this part of that of one residual, such
/// as along a kink of the loss where joints begin to slip.
const STALLED: f64 = 1e-2;
const LAST: usize = 3;
/// At a kink, steps in the direction of the derivatives increase the loss however close the optimum is: the search also
/// ends where such a step promised a decrease by less than this part of that of one residual.
const KINK: f64 = 0.1;
/// A step leaves at least this part of a parameter that would lose its influence at zero.
const LEFT: f64 = 0.1;
/// Rounding errors of the loss, as a part of it.
const ROUNDING: f64 = 1e-14;
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
    /// For each window, the mean square of its residuals where it was last fitted from other starts; 0 if it was not.
    pub(super) tried: Vec<f64>,
    /// Least decrease of the loss that is worth a step, as a part of that of one residual.
    pub(super) enough: f64,
    pub(super) max_iterations: usize,
    pub(super) iterations: usize,
    pub(super) shots: usize,
    pub(super) work: Works,
}

/// Work on all windows.
#[derive(Debug, Default)]
pub(super) struct Works {
    shots: Work,
    blocks: Work,
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

/// End of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    Converged,
    /// A step that the derivatives suggest does not decrease the loss, but it would not decrease it noticeably.
    Kink,
    /// No step that the derivatives suggest decreases the loss.
    Stuck,
    OutOfIterations,
    Stopped,
}

impl End {
    /// True if the search must not go on.
    pub(super) fn is_final(self) -> bool {
        matches!(self, Self::OutOfIterations | Self::Stopped)
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
    fn begin_at(&mut self, parameters: Vec<f64>, starts: Vec<Vec<f64>>) -> Result<Point, FitError> {
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
    fn complete(&self, mut point: Point) -> Result<Point, FitError> {
        if self.variables() > PART {
            let others = self.shoot(&point.parameters, &point.starts, PART..self.variables())?;
            for (shot, others) in point.shots.iter_mut().zip(&others) {
                shot.append(others);
            }
        }
        Ok(point)
    }

    /// Number of variables of a window: its start, and the free parameters.
    fn variables(&self) -> usize {
        self.n + self.free.len()
    }

    /// True if an output depends on a free parameter.
    pub(super) fn influences(&self, point: &Point, j: usize) -> bool {
        let of = |shot: &Shot| shot.by.column(self.n + j).iter().any(|&slope| slope != 0.0);
        point.shots.iter().any(of)
    }

    /// Integrates all windows, on all cores, with derivatives by some of the variables. The results do not depend on the
    /// number of cores.
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
        self.work.shots.each(self.windows.len(), shoot).into_iter().collect()
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
    fn blocks(&self, point: &Point, loss: Loss) -> Vec<Block> {
        let (n, p) = (self.n, self.free.len());
        let block = |w: usize| {
            let shot = &point.shots[w];
            let mut rows = DMatrix::zeros(shot.outputs.len(), n + p + 1);
            // missing values have no weight
            let mut roots = vec![0.0; shot.outputs.len()];
            self.residuals(w, shot, |row, _, column, residual| {
                let deviation = self.noise_of(w, column);
                let root = loss.of(residual / deviation)[1].sqrt() / deviation;
                roots[row] = root;
                rows[(row, n + p)] = root * residual;
            });
            let slopes = shot.by.as_slice().chunks_exact(roots.len().max(1)).take(n + p);
            for (weighted, slopes) in rows.as_mut_slice().chunks_exact_mut(roots.len().max(1)).zip(slopes) {
                for ((weighted, slope), root) in weighted.iter_mut().zip(slopes).zip(&roots) {
                    *weighted = root * slope;
                }
            }
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
        self.work.blocks.each(point.shots.len(), block)
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

    /// Lengths of the columns of the Jacobian. Those of the starts are means over all windows: where a joint sticks, a
    /// window hardly depends on its start, and its own length would allow a step of any size.
    fn lengths(&self, blocks: &[Block]) -> Damping {
        let (n, p) = (self.n, self.free.len());
        // what has no influence has no corrections
        let length = |column: usize| {
            let squares = blocks.iter().map(|block| block.rows.column(column).norm_squared());
            let length = squares.sum::<f64>().sqrt();
            if length > 0.0 { length } else { 1.0 }
        };
        let mean = (blocks.len() as f64).sqrt();
        let start: Vec<f64> = (0..n).map(|column| length(column) / mean).collect();
        Damping {
            starts: vec![start; blocks.len()],
            parameters: (n..n + p).map(length).collect(),
        }
    }

    /// Minimises the loss from a point on.
    pub(super) fn minimise(
        &mut self,
        mut point: Point,
        progress: &mut dyn FnMut(&Progress<'_>) -> ControlFlow<()>,
    ) -> (Point, End) {
        let p = self.free.len();
        let samples: usize = point.shots.iter().map(|shot| shot.outputs.len()).sum();
        let (mut damping, mut growth) = (FIRST_DAMPING, 2.0);
        // robust losses with different noise cannot be compared
        if self.loss == Loss::Squares || !self.has_noise {
            self.estimate_noise(&point);
        }
        point.loss = self.loss_of(&point);
        let mut blocks = self.blocks(&point, self.loss);
        let mut lengths = self.lengths(&blocks);
        let mut losses = vec![point.loss];
        let mut unit = self.mean_square(&point);
        // parameters that lose their influence at a bound, such as dry friction of zero, approach it in parts
        let mut lost = vec![false; p];
        loop {
            if self.iterations >= self.max_iterations {
                return (point, End::OutOfIterations);
            }
            self.iterations += 1;
            let root = damping.sqrt();
            let scaled = |of: &Vec<f64>| of.iter().map(|length| root * length).collect();
            let damped = Damping {
                starts: lengths.starts.iter().map(scaled).collect(),
                parameters: scaled(&lengths.parameters),
            };
            let eliminated = Eliminated::new(&blocks, [self.n, p], &damped);
            let room: Vec<[f64; 2]> = (0..p)
                .map(|j| {
                    let (value, [low, high]) = (point.parameters[self.free[j]], self.bounds[j]);
                    let low = if lost[j] { low.max(LEFT * value) } else { low };
                    [low, high].map(|bound| bound - value)
                })
                .collect();
            let change = within(&eliminated.parameters.upper(), &room);
            let changes = eliminated.starts(&change);
            let predicted = predicted_decrease(&blocks, &changes, &change, self.n);
            let enough = self.enough.max(ROUNDING * samples as f64) * unit;
            let stalled = losses.len() > LAST && losses[losses.len() - 1 - LAST] - point.loss <= STALLED * unit;
            if predicted * (1.0 + damping) <= enough {
                return (point, End::Converged);
            }
            if stalled {
                return (point, End::Kink);
            }
            let mut parameters = point.parameters.clone();
            for ((&n, change), [low, high]) in self.free.iter().zip(&change).zip(&self.bounds) {
                parameters[n] = (parameters[n] + change).clamp(*low, *high);
            }
            let mut starts = point.starts.clone();
            for ((start, changes), window) in starts.iter_mut().zip(&changes).zip(&self.windows) {
                if !window.known {
                    start.iter_mut().zip(changes).for_each(|(x, change)| *x += change);
                    self.shooting.project(window, start, &parameters);
                }
            }
            let next = self.begin_at(parameters, starts).ok();
            let better = next.filter(|next| next.loss < point.loss);
            match better.and_then(|next| self.complete(next).ok()) {
                Some(next) if (0..p).any(|j| !lost[j] && self.influences(&point, j) && !self.influences(&next, j)) => {
                    (0..p).for_each(|j| lost[j] |= !self.influences(&next, j));
                }
                Some(next) => {
                    let gain = (point.loss - next.loss) / predicted;
                    point = next;
                    if self.loss == Loss::Squares {
                        self.estimate_noise(&point);
                    }
                    unit = self.mean_square(&point);
                    losses.push(point.loss);
                    blocks = self.blocks(&point, self.loss);
                    let now = self.lengths(&blocks);
                    for (most, now) in lengths.starts.iter_mut().flatten().zip(now.starts.iter().flatten()) {
                        *most = most.max(*now);
                    }
                    for (most, now) in lengths.parameters.iter_mut().zip(now.parameters) {
                        *most = most.max(now);
                    }
                    let excess = 2.0 * gain - 1.0;
                    damping *= (1.0 - excess * excess * excess).max(if gain > 0.9 { 0.1 } else { 1.0 / 3.0 });
                    growth = 2.0;
                    let report = Progress {
                        iteration: self.iterations,
                        loss: point.loss,
                        parameters: &point.parameters,
                    };
                    if progress(&report).is_break() {
                        return (point, End::Stopped);
                    }
                }
                None => {
                    if predicted * (1.0 + damping) <= KINK * unit {
                        return (point, End::Kink);
                    }
                    damping *= growth;
                    growth *= 2.0;
                    if damping > MOST_DAMPING {
                        return (point, End::Stuck);
                    }
                }
            }
        }
    }
}

/// Decrease of the linearised loss by corrections.
fn predicted_decrease(blocks: &[Block], starts: &[Vec<f64>], parameters: &[f64], n: usize) -> f64 {
    let of = |rows: &DMatrix<f64>, changes: &[&[f64]]| {
        let last = rows.ncols() - 1;
        let of_row = |i: usize| {
            let now = rows[(i, last)];
            let change = changes.iter().flat_map(|changes| changes.iter()).enumerate();
            let change: f64 = change.map(|(j, change)| rows[(i, j)] * change).sum();
            // now^2 - (now - change)^2
            change * (2.0 * now - change)
        };
        (0..rows.nrows()).map(of_row).sum::<f64>()
    };
    let mut sum = 0.0;
    for (w, block) in blocks.iter().enumerate() {
        debug_assert_eq!(starts[w].len(), n);
        sum += of(&block.rows, &[&starts[w], parameters]);
        if let Some(joint) = &block.joint {
            sum += of(joint, &[&starts[w - 1], &starts[w], parameters]);
        }
    }
    sum
}
