//! The method of Levenberg and Marquardt for the starts of all windows and the free parameters.
//!
//! K. Madsen, H. B. Nielsen, O. Tingleff, "Methods for Non-Linear Least Squares Problems", 2nd ed. (2004), 3.2.

use std::ops::ControlFlow;

use nalgebra::DMatrix;

use super::Progress;
use super::elimination::{Block, Damping, Eliminated, within};
use super::loss::Loss;
use super::search::{Point, Search};

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
    /// Minimises the loss from a point on.
    pub(super) fn minimise(
        &mut self,
        mut point: Point,
        progress: &mut dyn FnMut(&Progress<'_>) -> ControlFlow<()>,
    ) -> (Point, End) {
        // robust losses with different noise cannot be compared
        if self.loss == Loss::Squares || !self.has_noise {
            self.estimate_noise(&point);
        }
        point.loss = self.loss_of(&point);
        let mut descent = Descent::new(self, &point);
        loop {
            if self.iterations >= self.max_iterations {
                return (point, End::OutOfIterations);
            }
            self.iterations += 1;
            let step = descent.step(self, &point);
            if let Some(end) = descent.end(&step, self.enough) {
                return (point, end);
            }
            let next = self.after(&point, &step).filter(|next| next.loss < point.loss);
            match next.and_then(|next| self.complete(next).ok()) {
                Some(next) if descent.loses_influence(self, &point, &next) => {}
                Some(next) => {
                    let gain = (point.loss - next.loss) / step.predicted;
                    point = next;
                    if self.loss == Loss::Squares {
                        self.estimate_noise(&point);
                    }
                    descent.accept(self, &point, gain);
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
                    if let Some(end) = descent.reject(&step) {
                        return (point, end);
                    }
                }
            }
        }
    }

    /// The point after a step, not yet [complete](Self::complete), unless a window cannot be integrated there.
    fn after(&mut self, point: &Point, step: &Step) -> Option<Point> {
        let mut parameters = point.parameters.clone();
        for ((&n, change), [low, high]) in self.free.iter().zip(&step.parameters).zip(&self.bounds) {
            parameters[n] = (parameters[n] + change).clamp(*low, *high);
        }
        let mut starts = point.starts.clone();
        for ((start, changes), window) in starts.iter_mut().zip(&step.starts).zip(&self.windows) {
            if !window.known {
                start.iter_mut().zip(changes).for_each(|(x, change)| *x += change);
                self.shooting.project(window, start, &parameters);
            }
        }
        self.begin_at(parameters, starts).ok()
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
}

/// Changes by a step, and the decrease of the linearised loss.
struct Step {
    parameters: Vec<f64>,
    starts: Vec<Vec<f64>>,
    predicted: f64,
}

/// The linear model at a point, and its damping.
struct Descent {
    blocks: Vec<Block>,
    /// Lengths of the columns of the Jacobian, the largest so far.
    lengths: Damping,
    damping: f64,
    /// Factor by which the damping grows at the next rejection.
    growth: f64,
    /// The losses of all points so far.
    losses: Vec<f64>,
    /// Loss of one residual.
    unit: f64,
    /// Number of computed outputs.
    samples: usize,
    /// True for parameters that lose their influence at a bound, such as dry friction of zero: they approach it in
    /// parts.
    lost: Vec<bool>,
}

impl Descent {
    fn new(search: &Search<'_>, point: &Point) -> Self {
        let blocks = search.blocks(point, search.loss);
        Self {
            lengths: search.lengths(&blocks),
            blocks,
            damping: FIRST_DAMPING,
            growth: 2.0,
            losses: vec![point.loss],
            unit: search.mean_square(point),
            samples: point.shots.iter().map(|shot| shot.outputs.len()).sum(),
            lost: vec![false; search.free.len()],
        }
    }

    fn step(&self, search: &Search<'_>, point: &Point) -> Step {
        let root = self.damping.sqrt();
        let scaled = |of: &Vec<f64>| of.iter().map(|length| root * length).collect();
        let damped = Damping {
            starts: self.lengths.starts.iter().map(scaled).collect(),
            parameters: scaled(&self.lengths.parameters),
        };
        let eliminated = Eliminated::new(&self.blocks, [search.n, search.free.len()], &damped);
        let room = search.free.iter().zip(&search.bounds).zip(&self.lost);
        let room = room.map(|((&n, &[low, high]), &is_lost)| {
            let value = point.parameters[n];
            let low = if is_lost { low.max(LEFT * value) } else { low };
            [low, high].map(|bound| bound - value)
        });
        let parameters = within(&eliminated.parameters.upper(), &room.collect::<Vec<_>>());
        let starts = eliminated.starts(&parameters);
        let predicted = predicted_decrease(&self.blocks, &starts, &parameters, search.n);
        Step {
            parameters,
            starts,
            predicted,
        }
    }

    /// The end of the search, if no step is worth its work: `enough` is the least decrease of the loss that is worth a
    /// step, as a part of the loss of one residual.
    fn end(&self, step: &Step, enough: f64) -> Option<End> {
        let enough = enough.max(ROUNDING * self.samples as f64) * self.unit;
        if step.predicted * (1.0 + self.damping) <= enough {
            return Some(End::Converged);
        }
        let mut last = self.losses.iter().rev();
        let is_stalled = match (last.next(), last.nth(LAST - 1)) {
            (Some(now), Some(before)) => before - now <= STALLED * self.unit,
            _ => false,
        };
        is_stalled.then_some(End::Kink)
    }

    /// True if a step takes a parameter to where it has no influence for the first time.
    fn loses_influence(&mut self, search: &Search<'_>, point: &Point, next: &Point) -> bool {
        let loses = |j: usize| !self.lost[j] && search.influences(point, j) && !search.influences(next, j);
        let loses = (0..self.lost.len()).any(loses);
        if loses {
            let lost = self.lost.iter_mut().enumerate();
            lost.for_each(|(j, lost)| *lost |= !search.influences(next, j));
        }
        loses
    }

    /// Continues at a point that a step reached with this part of the predicted decrease.
    fn accept(&mut self, search: &Search<'_>, point: &Point, gain: f64) {
        self.unit = search.mean_square(point);
        self.losses.push(point.loss);
        self.blocks = search.blocks(point, search.loss);
        let now = search.lengths(&self.blocks);
        let starts = self.lengths.starts.iter_mut().flatten();
        let lengths = starts.chain(&mut self.lengths.parameters);
        for (most, now) in lengths.zip(now.starts.iter().flatten().chain(&now.parameters)) {
            *most = most.max(*now);
        }
        let excess = 2.0 * gain - 1.0;
        self.damping *= (1.0 - excess * excess * excess).max(if gain > 0.9 { 0.1 } else { 1.0 / 3.0 });
        self.growth = 2.0;
    }

    /// Raises the damping after a step that does not decrease the loss, or ends the search.
    fn reject(&mut self, step: &Step) -> Option<End> {
        if step.predicted * (1.0 + self.damping) <= KINK * self.unit {
            return Some(End::Kink);
        }
        self.damping *= self.growth;
        self.growth *= 2.0;
        (self.damping > MOST_DAMPING).then_some(End::Stuck)
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
