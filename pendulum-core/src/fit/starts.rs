//! Starts of windows, fitted one by one: first guesses, and ways out of kinks.

use std::ops::ControlFlow;

use super::parallel;
use super::search::{Point, Search};
use super::shooting::{Shot, Source, Trajectories};
use super::windows::Window;
use super::{Division, FitError, guess};
use crate::layout::StateLayout;
use crate::system::{Parametric, System};

/// Number of samples that give a first guess of a start, for each component of the state.
const SAMPLES_OF_A_START: usize = 5;
/// Number of iterations for the start of a window alone.
const ITERATIONS_OF_A_START: usize = 20;
/// Least decrease of the loss that is worth a step of a start alone, as a part of that of one residual: starts within a
/// tenth of their standard deviations are good guesses.
const ENOUGH_OF_A_START: f64 = 1e-2;
/// Least such decrease for one of several starts, of which only the best is followed further.
const ENOUGH_OF_ANOTHER_START: f64 = 1.0;
/// A window is bad if the mean square of its residuals is this many times the median of all windows.
const BAD: f64 = 3.0;

/// First guesses of the starts of all windows: from measured components of the state, from the guess or the known state
/// of the experiment, and from the end of the window before. If components are measured indirectly, the start of each
/// window is fitted alone: to its first samples, where the values of the parameters do not matter much, and then to all
/// samples of a window where joints may stick.
pub(super) fn first<X, M, const N: usize, const P: usize>(
    search: &Search<'_>,
    trajectories: &Trajectories<'_, X, M, N, P>,
    parameters: &[f64],
    division: &Division,
) -> Result<Vec<Vec<f64>>, FitError>
where
    M: Parametric<N, P>,
{
    // kinks may keep a search from the modes of the first samples; over a whole trajectory wrong parameters would spoil
    // the start
    let fits_whole_windows = search.hybrid && *division != Division::Whole;
    let mut starts = vec![Vec::new(); search.windows.len()];
    parallel::scope(|scope| {
        let mut before = None;
        for (window, start) in search.windows.iter().zip(&mut starts) {
            (*start, before) = trajectories.guess(search, window, before, parameters)?;
            if fits_whole_windows && !window.known {
                scope.spawn(move |_| {
                    let fitted =
                        search.start_alone(window, start.clone(), parameters, &search.given, ENOUGH_OF_A_START);
                    if let Ok(mut fitted) = fitted {
                        *start = fitted.starts.swap_remove(0);
                    }
                });
            }
        }
        Ok::<_, FitError>(())
    })?;
    Ok(starts)
}

/// The state of zeros, with quaternions of no rotation.
fn origin<S: System<f64, N>, const N: usize>(model: &S, n: usize) -> Vec<f64> {
    let mut origin = vec![0.0; n];
    let quaternions = model.layout().into_iter().flat_map(|layout| layout.quaternions());
    quaternions.for_each(|places| origin[places.start] = 1.0);
    origin
}

impl<X, M, const N: usize, const P: usize> Trajectories<'_, X, M, N, P>
where
    M: Parametric<N, P>,
{
    /// First guess of the start of a window, and its end if it follows from that, for the next window. `before` is the
    /// end of the window before.
    fn guess(
        &self,
        search: &Search<'_>,
        window: &Window,
        before: Option<Vec<f64>>,
        parameters: &[f64],
    ) -> Result<(Vec<f64>, Option<Vec<f64>>), FitError> {
        let experiment = &self.experiments[window.experiment];
        let is_first = window.samples.start == 0;
        let mut start = match (experiment.known.filter(|_| window.known), before, experiment.guess) {
            (Some((_, known)), _, _) => known.as_slice()[..search.n].to_vec(),
            (None, Some(before), _) if !is_first => before,
            (None, _, Some(guess)) => guess.as_slice()[..search.n].to_vec(),
            (None, _, None) => origin(&experiment.model.cast::<f64>(), search.n),
        };
        let is_guessed = is_first && experiment.guess.is_some();
        let mut is_complete = window.known;
        if !window.known && !is_guessed {
            is_complete = self.measure(window, &mut start);
            search.shooting.project(window, &mut start, parameters);
        }
        if is_complete {
            return Ok((start, None));
        }
        let beginning = window.beginning(experiment.measurement, SAMPLES_OF_A_START * search.n);
        let mut fitted = search.start_alone(&beginning, start, parameters, &search.given, ENOUGH_OF_A_START)?;
        let start = fitted.starts.swap_remove(0);
        let whole = search.shooting.shoot(window, &start, parameters, &[], 0..0);
        Ok((start, whole.ok().map(|shot| shot.end)))
    }

    /// Replaces measured components of the start of a window, and the rates of measured positions. Returns true if
    /// these are all components.
    fn measure(&self, window: &Window, start: &mut [f64]) -> bool {
        let experiment = &self.experiments[window.experiment];
        let model = experiment.model.cast::<f64>();
        let layout = model.layout();
        let times = &experiment.measurement.times;
        let mut measured = vec![false; start.len()];
        let mut rates = Vec::new();
        for (source, column) in self.sources[window.experiment]
            .iter()
            .zip(&experiment.measurement.columns)
        {
            let Source::Component(n) = *source else {
                continue;
            };
            let Some((value, rate)) = guess::value_and_rate(times, column, window.samples.clone()) else {
                continue;
            };
            (start[n], measured[n]) = (value, true);
            let rate_of = (0..start.len()).find(|&rate| position_of(layout, rate) == Some(n));
            rates.extend(rate_of.zip(rate));
        }
        for (n, rate) in rates {
            if !measured[n] {
                (start[n], measured[n]) = (rate, true);
            }
        }
        measured.iter().all(|&measured| measured)
    }
}

/// Component of the position whose rate is the component `rate`, if it is a single one.
fn position_of(layout: Option<StateLayout<'_>>, rate: usize) -> Option<usize> {
    let mut slots = layout?.slots.iter();
    let slot = slots.find(|slot| slot.rates == (rate..rate + 1) && slot.positions.len() == 1)?;
    Some(slot.positions.start)
}

impl Search<'_> {
    /// Search for the start of a window alone, with the noise that is `given`.
    fn alone(&self, window: &Window, given: &[bool], enough: f64) -> Self {
        Self {
            measurements: self.measurements.clone(),
            windows: vec![Window {
                joined: false,
                ..window.clone()
            }],
            sensors: self.sensors.clone(),
            noise: self.noise.clone(),
            given: given.to_vec(),
            has_noise: self.has_noise,
            free: Vec::new(),
            bounds: Vec::new(),
            joints: None,
            tried: Vec::new(),
            leaves_bad_windows: false,
            enough,
            max_iterations: ITERATIONS_OF_A_START,
            iterations: 0,
            shots: 0,
            ..*self
        }
    }

    /// Fits the start of a window alone, with the noise that is `given`.
    fn start_alone(
        &self,
        window: &Window,
        start: Vec<f64>,
        parameters: &[f64],
        given: &[bool],
        enough: f64,
    ) -> Result<Point, FitError> {
        let mut alone = self.alone(window, given, enough);
        let point = alone.at(parameters.to_vec(), vec![start])?;
        Ok(alone.minimise(point, &mut |_| ControlFlow::Continue(())).0)
    }

    /// Fits the start of a window alone on from a point of this window, with all noise given.
    fn refine(&self, w: usize, point: Point) -> Point {
        let mut alone = self.alone(&self.windows[w], &vec![true; self.given.len()], ENOUGH_OF_A_START);
        alone.minimise(point, &mut |_| ControlFlow::Continue(())).0
    }

    /// Mean squares of the residuals of all windows, over that of the median window.
    fn mean_squares(&self, point: &Point) -> Vec<f64> {
        let mean_square = |(w, shot): (usize, &Shot)| {
            let [sum, count] = self.weighted_squares(w, shot);
            sum / count.max(1.0)
        };
        let mut all: Vec<f64> = point.shots.iter().enumerate().map(mean_square).collect();
        let mut sorted = all.clone();
        sorted.sort_by(f64::total_cmp);
        let median = sorted[sorted.len() / 2];
        all.iter_mut().for_each(|square| *square /= median);
        all
    }

    /// True for windows that are much worse than others, such as where a joint sticks in vain, and much worse than when
    /// they were last fitted from other starts.
    fn bad(&self, mean_squares: &[f64]) -> Vec<bool> {
        let all = mean_squares.iter().zip(&self.tried);
        all.map(|(&square, tried)| square > BAD.max(BAD * tried)).collect()
    }

    /// True if there are [bad](Self::bad) windows.
    pub(super) fn has_bad(&self, point: &Point) -> bool {
        self.bad(&self.mean_squares(point)).contains(&true)
    }

    /// Other starts of some windows: where the window before ends, which may be on the other side of an impact, and
    /// their own starts with each component changed by its mean size.
    fn other_starts(&self, point: &Point, of: &[bool]) -> Vec<(usize, Vec<f64>)> {
        let sizes: Vec<f64> = (0..self.n)
            .map(|i| point.starts.iter().map(|start| start[i].abs()).sum::<f64>() / point.starts.len() as f64)
            .collect();
        let mut others = Vec::new();
        for w in self.unknown().into_iter().filter(|&w| of[w]) {
            let window = &self.windows[w];
            let before = w
                .checked_sub(1)
                .filter(|&before| self.windows[before].experiment == window.experiment);
            others.extend(before.map(|before| (w, point.shots[before].end.clone())));
            for (i, side) in (0..self.n).flat_map(|i| [(i, 1.0), (i, -1.0)]) {
                let mut other = point.starts[w].clone();
                other[i] += side * sizes[i];
                self.shooting.project(window, &mut other, &point.parameters);
                others.push((w, other));
            }
        }
        others
    }

    /// For each of some windows, the best fit of its start from [others](Self::other_starts).
    fn best_of_others(&self, point: &Point, of: &[bool]) -> Vec<Option<Point>> {
        let given = vec![true; self.given.len()];
        let others = self.other_starts(point, of);
        let fitted = parallel::each(others.len(), |n| {
            let (w, start) = &others[n];
            let window = &self.windows[*w];
            let fitted = self.start_alone(
                window,
                start.clone(),
                &point.parameters,
                &given,
                ENOUGH_OF_ANOTHER_START,
            );
            fitted.ok()
        });
        let mut best: Vec<Option<Point>> = vec![None; self.windows.len()];
        for ((w, _), fitted) in others.into_iter().zip(fitted) {
            if let Some(fitted) = fitted
                && best[w].as_ref().is_none_or(|best| fitted.loss < best.loss)
            {
                best[w] = Some(fitted);
            }
        }
        best
    }

    /// Fits the start of each window by itself, which kinks in other windows cannot prevent: of all windows if the
    /// search ended at a kink, otherwise of the [bad](Self::bad) ones only. Bad ones are also fitted from other starts.
    /// True if the loss decreases noticeably.
    pub(super) fn relax(&mut self, point: &mut Point, at_a_kink: bool) -> bool {
        let mean_squares = self.mean_squares(point);
        let is_bad = self.bad(&mean_squares);
        if !at_a_kink && !is_bad.contains(&true) {
            return false;
        }
        for (w, square) in mean_squares.into_iter().enumerate() {
            if is_bad[w] {
                self.tried[w] = square;
            }
        }
        let others = self.best_of_others(point, &is_bad);
        let mut unknown = self.unknown();
        unknown.retain(|&w| at_a_kink || is_bad[w]);
        // bad windows take longest
        unknown.sort_by_key(|&w| !is_bad[w]);
        let refined = parallel::each(unknown.len(), |n| {
            let w = unknown[n];
            let own = Point {
                parameters: point.parameters.clone(),
                starts: vec![point.starts[w].clone()],
                shots: vec![point.shots[w].clone()],
                loss: 0.0,
            };
            let own = self.refine(w, own);
            let other = others[w].clone().map(|other| self.refine(w, other));
            let mut refined = other.filter(|other| other.loss < own.loss).unwrap_or(own);
            let start = refined.starts.swap_remove(0);
            if start == point.starts[w] {
                return None;
            }
            let variables = 0..self.variables();
            let shot = (self.shooting).shoot(&self.windows[w], &start, &point.parameters, &self.free, variables);
            Some((w, start, shot.ok()?))
        });
        let mut relaxed = point.clone();
        for (w, start, shot) in refined.into_iter().flatten() {
            self.shots += 1;
            (relaxed.starts[w], relaxed.shots[w]) = (start, shot);
        }
        relaxed.loss = self.loss_of(&relaxed);
        let is_better = relaxed.loss < point.loss - self.mean_square(point);
        if is_better {
            *point = relaxed;
        }
        is_better
    }
}

#[cfg(test)]
mod tests {
    use std::ops::{ControlFlow, Range};

    use nalgebra::DMatrix;

    use crate::error::{ParameterError, Reason};
    use crate::fit::Fit;
    use crate::fit::measurement::Measurement;
    use crate::fit::search::Search;
    use crate::fit::shooting::{Shooting, Shot};
    use crate::fit::windows::Window;

    /// Number of samples of a window.
    const COUNT: usize = 100;

    /// Outputs `(x - 1) ((x - 3)^2 + 1)` of a start `x`: zero at 1, with a minimum of 1.85 at 8/3.
    struct Dented;

    impl Shooting for Dented {
        fn shoot(
            &self,
            _: &Window,
            start: &[f64],
            _: &[f64],
            _: &[usize],
            variables: Range<usize>,
        ) -> Result<Shot, Reason> {
            let x = start[0];
            Ok(Shot {
                outputs: vec![(x - 1.0) * ((x - 3.0) * (x - 3.0) + 1.0); COUNT],
                by: DMatrix::from_element(COUNT, variables.len(), 3.0 * x * x - 14.0 * x + 16.0),
                end: start.to_vec(),
                end_by: DMatrix::identity(1, variables.len()),
            })
        }

        fn project(&self, _: &Window, _: &mut [f64], _: &[f64]) {}

        fn check(&self, _: &[f64]) -> Result<(), ParameterError> {
            Ok(())
        }
    }

    #[test]
    fn starts_leave_poor_minima_in_smooth_scenes() {
        const WINDOWS: usize = 5;
        let times: Vec<f64> = (0..WINDOWS * COUNT).map(|n| n as f64).collect();
        let values: Vec<f64> = (0..times.len())
            .map(|n| if n.is_multiple_of(2) { 0.1 } else { -0.1 })
            .collect();
        let measurement = Measurement::new(&times).expect("times");
        let measurement = measurement.output_with_noise("a", &values, 1.0).expect("values");
        let window = |w: usize| Window {
            experiment: 0,
            samples: w * COUNT..(w + 1) * COUNT,
            span: [times[w * COUNT]; 2],
            joined: false,
            known: false,
        };
        let mut search = Search::of_noise_1(&Dented, &measurement, (0..WINDOWS).map(window).collect());
        let mut starts = vec![vec![1.1]; WINDOWS];
        starts[2][0] = 8.0 / 3.0;
        let point = search.at(Vec::new(), starts).expect("a point");
        let (point, _) = Fit::new(()).find(&mut search, point, &mut |_| ControlFlow::Continue(()));
        assert!(
            point.starts.iter().all(|start| (start[0] - 1.0).abs() < 1e-3),
            "{:?}",
            point.starts
        );
    }
}
