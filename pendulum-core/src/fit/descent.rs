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
/// With mode switches, where the loss is less smooth: parameters are within 3e-3 of their standard deviations.
pub(super) const ENOUGH_WITH_SWITCHES: f64 = 1e-5;
/// A search whose steps promise less than this part of the loss of one residual is interrupted for bad windows.
const NEAR: f64 = 10.0;
/// The search also ends after `LAST` steps that decrease the loss by less than this part of that of one residual, such
/// as along a kink of the loss where joints begin to slip.
const STALLED: f64 = 1e-2;
const LAST: usize = 3;
/// At a kink, steps in the direction of the derivatives increase the loss however close the optimum is: the search also
/// ends where such a step promised a decrease by less than this part of that of one residual.
const KINK: f64 = 0.1;
/// The next step is shortened if the loss is this many times as curved along a step as its linear model, by the
/// curvature of the residuals: steps would lead beyond the minimum, one after the other.
const CURVED: f64 = 1.25;
/// Damping is enough to shorten a step whose slope is this many times its curvature.
const DAMPED: f64 = 1.1;
/// Least part of a step that is taken.
const SHORTEST: f64 = 0.3;
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
    /// A window is much worse than others, and has not been fitted from other starts.
    BadWindow,
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
            if step.model.at(1.0) <= NEAR * descent.unit && self.leaves_bad_windows && self.has_bad(&point) {
                return (point, End::BadWindow);
            }
            let next = self.after(&point, &step).filter(|next| next.loss < point.loss);
            match next.and_then(|next| self.complete(next).ok()) {
                Some(next) if descent.loses_influence(self, &point, &next) => {}
                Some(next) => {
                    let decrease = point.loss - next.loss;
                    point = next;
                    if self.loss == Loss::Squares {
                        self.estimate_noise(&point);
                    }
                    descent.accept(self, &point, &step, decrease);
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

/// Changes by a step, which may be a part of the step to the minimum of the linearised loss.
struct Step {
    parameters: Vec<f64>,
    starts: Vec<Vec<f64>>,
    part: f64,
    model: Parabola,
}

/// Decrease of the loss by a part `s` of a step: `2 s slope - s^2 curvature`.
struct Parabola {
    slope: f64,
    curvature: f64,
}

impl Parabola {
    fn at(&self, part: f64) -> f64 {
        part * (2.0 * self.slope - part * self.curvature)
    }
}

/// The linear model at a point, and its damping.
struct Descent {
    blocks: Vec<Block>,
    /// Lengths of the columns of the Jacobian, the largest so far.
    lengths: Damping,
    damping: f64,
    /// Factor by which the damping grows at the next rejection.
    growth: f64,
    /// Curvature of the loss along the last step, over that of its linear model.
    curved: f64,
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
            curved: 1.0,
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
        let room: Vec<_> = room.collect();
        let mut parameters = within(&eliminated.parameters.upper(), &room);
        let mut starts = eliminated.starts(&parameters);
        let model = parabola(&self.blocks, &starts, &parameters, search.n);
        // a part of a step to a bound would not reach it
        let mut changes = parameters.iter().zip(&room);
        let to_a_bound = changes.any(|(change, room)| *change != 0.0 && room.contains(change));
        let part = if to_a_bound || self.curved < CURVED {
            1.0
        } else {
            (model.slope / (self.curved * model.curvature)).clamp(SHORTEST, 1.0)
        };
        let changes = parameters.iter_mut().chain(starts.iter_mut().flatten());
        changes.for_each(|change| *change *= part);
        Step {
            parameters,
            starts,
            part,
            model,
        }
    }

    /// The end of the search, if no step is worth its work: `enough` is the least decrease of the loss that is worth a
    /// step, as a part of the loss of one residual.
    fn end(&self, step: &Step, enough: f64) -> Option<End> {
        let enough = enough.max(ROUNDING * self.samples as f64) * self.unit;
        if step.model.at(1.0) * (1.0 + self.damping) <= enough {
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

    /// Continues at a point that a step reached with this decrease of the loss.
    fn accept(&mut self, search: &Search<'_>, point: &Point, step: &Step, decrease: f64) {
        self.unit = search.mean_square(point);
        self.losses.push(point.loss);
        self.blocks = search.blocks(point, search.loss);
        let now = search.lengths(&self.blocks);
        let starts = self.lengths.starts.iter_mut().flatten();
        let lengths = starts.chain(&mut self.lengths.parameters);
        for (most, now) in lengths.zip(now.starts.iter().flatten().chain(&now.parameters)) {
            *most = most.max(*now);
        }
        let Step { part, model, .. } = step;
        let gain = decrease / model.at(*part);
        self.curved = if model.slope < DAMPED * model.curvature {
            (2.0 * part * model.slope - decrease) / (part * part * model.curvature)
        } else {
            1.0
        };
        let excess = 2.0 * gain - 1.0;
        self.damping *= (1.0 - excess * excess * excess).max(if gain > 0.9 { 0.1 } else { 1.0 / 3.0 });
        self.growth = 2.0;
    }

    /// Raises the damping after a step that does not decrease the loss, or ends the search.
    fn reject(&mut self, step: &Step) -> Option<End> {
        if step.model.at(1.0) * (1.0 + self.damping) <= KINK * self.unit {
            return Some(End::Kink);
        }
        self.damping *= self.growth;
        self.growth *= 2.0;
        (self.damping > MOST_DAMPING).then_some(End::Stuck)
    }
}

/// Decrease of the linearised loss by parts of a step.
fn parabola(blocks: &[Block], starts: &[Vec<f64>], parameters: &[f64], n: usize) -> Parabola {
    let mut sum = Parabola {
        slope: 0.0,
        curvature: 0.0,
    };
    let mut add = |rows: &DMatrix<f64>, changes: &[&[f64]]| {
        let last = rows.ncols() - 1;
        for i in 0..rows.nrows() {
            let change = changes.iter().flat_map(|changes| changes.iter()).enumerate();
            let change: f64 = change.map(|(j, change)| rows[(i, j)] * change).sum();
            // now^2 - (now - s change)^2
            sum.slope += change * rows[(i, last)];
            sum.curvature += change * change;
        }
    };
    for (w, block) in blocks.iter().enumerate() {
        debug_assert_eq!(starts[w].len(), n);
        add(&block.rows, &[&starts[w], parameters]);
        if let Some(joint) = &block.joint {
            add(joint, &[&starts[w - 1], &starts[w], parameters]);
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use std::ops::{ControlFlow, Range};

    use nalgebra::DMatrix;

    use super::End;
    use crate::error::{ParameterError, Reason};
    use crate::fit::measurement::Measurement;
    use crate::fit::search::Search;
    use crate::fit::shooting::{Shooting, Shot};
    use crate::fit::windows::Window;

    /// Number of samples.
    const COUNT: usize = 1000;

    /// Residuals `x + 1` and `c x^2 + x - 1` of each sample, with the optimum at zero, to which steps of Gauss and
    /// Newton converge by a factor of `c` each. J. E. Dennis, R. B. Schnabel, "Numerical Methods for Unconstrained
    /// Optimization" (1983), 10.2.
    struct Curved(f64);

    impl Shooting for Curved {
        fn shoot(
            &self,
            _: &Window,
            start: &[f64],
            parameters: &[f64],
            _: &[usize],
            variables: Range<usize>,
        ) -> Result<Shot, Reason> {
            let (c, x) = (self.0, parameters[0]);
            let of = |row: usize, [a, b]: [f64; 2]| if row.is_multiple_of(2) { a } else { b };
            let slopes = [-1.0, -2.0 * c * x - 1.0];
            Ok(Shot {
                outputs: (0..2 * COUNT)
                    .map(|row| of(row, [-x - 1.0, 1.0 - x - c * x * x]))
                    .collect(),
                by: DMatrix::from_fn(2 * COUNT, variables.len(), |row, column| {
                    let is_parameter = variables.start + column == 1;
                    of(row, slopes) * f64::from(u8::from(is_parameter))
                }),
                end: start.to_vec(),
                end_by: DMatrix::zeros(1, variables.len()),
            })
        }

        fn project(&self, _: &Window, _: &mut [f64], _: &[f64]) {}

        fn check(&self, _: &[f64]) -> Result<(), ParameterError> {
            Ok(())
        }
    }

    #[test]
    fn curved_residuals_take_few_steps() {
        let times: Vec<f64> = (0..COUNT).map(|n| n as f64).collect();
        let measurement = Measurement::new(&times).expect("times");
        let measurement = measurement.output_with_noise("a", &[0.0; COUNT], 1.0).expect("values");
        let measurement = measurement.output_with_noise("b", &[0.0; COUNT], 1.0).expect("values");
        let window = Window {
            experiment: 0,
            samples: 0..COUNT,
            span: [0.0; 2],
            joined: false,
            known: true,
        };
        let mut search = Search::of_noise_1(&Curved(-0.8), &measurement, vec![window]);
        (search.free, search.bounds) = (vec![0], vec![[f64::NEG_INFINITY, f64::INFINITY]]);
        let point = search.at(vec![0.05], vec![vec![0.0]]).expect("a point");
        let (point, end) = search.minimise(point, &mut |_| ControlFlow::Continue(()));
        assert_eq!(end, End::Converged);
        assert!(point.parameters[0].abs() < 1e-4, "{:?}", point.parameters);
        assert!(search.iterations <= 8, "{}", search.iterations);
    }
}
