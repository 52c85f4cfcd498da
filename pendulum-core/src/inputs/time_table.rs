//! Inputs given by samples.

use std::cell::Cell;
use std::fmt;
use std::sync::Arc;

use nalgebra::SVector;

use super::InputLaw;
use crate::error::SampleError;
use crate::real::Real;

/// A law for `M` inputs that are given by samples, such as recorded torques.
///
/// Between the samples the inputs are held, or interpolated linearly or by cubic splines. Before the first sample and
/// after the last one they keep its value. Times may be uneven. A copy shares the samples.
///
/// ```
/// use pendulum_core::inputs::TimeTable;
/// use pendulum_core::prelude::*;
///
/// mechanism! {
///     pub Cart {
///         input push: N,
///         body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, torque: push }
///     }
/// }
///
/// let push = TimeTable::linear(&[0.0, 1.0, 2.0], [&[0.0, 4.0, 0.0]])?;
/// let cart = Cart::new(CartParams {})?.with_law(push);
/// let x = Rk4::new(0.1).solve(&cart, 0.0, 3.0, [0.0, 0.0])?.end();
/// assert!((x[Cart::DOT_S] - 2.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// A method meets a jump of held inputs, or a kink of interpolated ones, at each sample. Steps as long as the intervals
/// between the samples are a good choice, such as those of [`Rk4`](crate::Rk4).
#[derive(Clone)]
pub struct TimeTable<const M: usize> {
    pieces: Arc<Pieces<M>>,
}

/// The inputs before the first sample, between samples, and after the last one.
#[derive(PartialEq)]
struct Pieces<const M: usize> {
    /// Times of the samples.
    times: Vec<f64>,
    /// For each piece, the coefficients of the powers of the time since its start: 0, 1, 2, 3.
    coefficients: Vec<[[f64; 4]; M]>,
    /// False if the coefficients of the powers 2 and 3 are zero.
    are_cubic: bool,
    /// For equal divisions of the span, the number of samples before the end of each.
    before: Vec<usize>,
    /// Number of divisions per unit of time.
    density: f64,
}

/// Most times that are searched one after the other.
const FEW: usize = 8;

impl<const M: usize> TimeTable<M> {
    /// Holds each sample until the next one.
    ///
    /// # Errors
    /// If there is no sample, if a list of samples has another length than the times, if a number is not finite, or if
    /// the times do not ascend.
    pub fn hold(times: &[f64], samples: [&[f64]; M]) -> Result<Self, SampleError> {
        Self::new(times, samples, 1, |_, samples| {
            samples.iter().map(|&value| [value, 0.0, 0.0, 0.0]).collect()
        })
    }

    /// Interpolates linearly.
    ///
    /// # Errors
    /// As for [`hold`](Self::hold), and if there is a single sample.
    pub fn linear(times: &[f64], samples: [&[f64]; M]) -> Result<Self, SampleError> {
        Self::new(times, samples, 2, |times, samples| {
            let ends = times.windows(2).zip(samples.windows(2));
            ends.map(|(t, y)| [y[0], (y[1] - y[0]) / (t[1] - t[0]), 0.0, 0.0])
                .collect()
        })
    }

    /// Interpolates by natural cubic splines, whose second derivatives are continuous, and zero at both ends.
    ///
    /// J. Stoer, R. Bulirsch, "Introduction to Numerical Analysis", 3rd ed. (2002), 2.4.
    ///
    /// # Errors
    /// As for [`linear`](Self::linear).
    pub fn cubic(times: &[f64], samples: [&[f64]; M]) -> Result<Self, SampleError> {
        Self::new(times, samples, 2, spline)
    }

    /// `interpolate` returns the polynomials of one input from each sample on; that of the last one may be missing.
    fn new(
        times: &[f64],
        samples: [&[f64]; M],
        least: usize,
        interpolate: impl Fn(&[f64], &[f64]) -> Vec<[f64; 4]>,
    ) -> Result<Self, SampleError> {
        SampleError::check_times(times, least)?;
        let mut coefficients = vec![[[0.0; 4]; M]; times.len() + 1];
        for (m, samples) in samples.into_iter().enumerate() {
            let name = format!("input {m}");
            SampleError::check_length(&name, samples.len(), times.len())?;
            if let Some((index, &value)) = samples.iter().enumerate().find(|(_, value)| !value.is_finite()) {
                return Err(SampleError::Value { name, index, value });
            }
            for (piece, of_input) in coefficients[1..].iter_mut().zip(interpolate(times, samples)) {
                piece[m] = of_input;
            }
            coefficients[0][m][0] = samples[0];
            coefficients[times.len()][m] = [samples[times.len() - 1], 0.0, 0.0, 0.0];
        }
        let (first, last) = (times[0], times[times.len() - 1]);
        let width = (last - first) / times.len() as f64;
        let before = (1..=times.len())
            .map(|end| times.partition_point(|&time| time < first + width * end as f64))
            .collect();
        Ok(Self {
            pieces: Arc::new(Pieces {
                times: times.to_vec(),
                are_cubic: coefficients.iter().flatten().any(|of_input| of_input[2..] != [0.0; 2]),
                coefficients,
                before,
                density: times.len() as f64 / (last - first),
            }),
        })
    }

    /// Times of the samples, in s.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        &self.pieces.times
    }

    /// True if the samples determine the inputs from one time to another, so that no value is kept beyond them. Inputs
    /// that are held are determined for as long after the last sample as between the last two, and by a single sample
    /// at all times.
    #[must_use]
    pub fn covers(&self, from: f64, to: f64) -> bool {
        let (from, to) = (from.min(to), from.max(to));
        let Pieces {
            times, coefficients, ..
        } = &*self.pieces;
        let are_held = coefficients.iter().flatten().all(|of_input| of_input[1..] == [0.0; 3]);
        match times[..] {
            [_] => true,
            [first, .., before, last] => {
                let end = if are_held { last + (last - before) } else { last };
                first <= from && to <= end
            }
            _ => false,
        }
    }
}

impl TimeTable<1> {
    /// The input at a time, by the table of each lane.
    #[inline(always)]
    pub(crate) fn by_lane<'a, T: Real>(t: T, table: impl Fn(usize) -> &'a Self) -> T {
        let pieces = |lane| &*table(lane).pieces;
        let [piece] = t.piecewise_by_lane(|lane, t| [pieces(lane).samples_until(t) as f64]);
        let polynomial = piece.piecewise_by_lane(|lane, piece| pieces(lane).of(piece as usize, 0));
        value_of(polynomial, t, (0..T::LANES).any(|lane| pieces(lane).are_cubic))
    }
}

impl<const M: usize> Pieces<M> {
    /// Start and coefficients of one input, in the piece after a number of samples.
    fn of(&self, piece: usize, input: usize) -> [f64; 5] {
        let start = self.times[piece.max(1) - 1];
        let [c0, c1, c2, c3] = self.coefficients[piece][input];
        [start, c0, c1, c2, c3]
    }

    /// Number of samples at or before the time `t`.
    fn samples_until(&self, t: f64) -> usize {
        let (first, count) = (self.times[0], self.times.len());
        let last = self.times[count - 1];
        if t >= last {
            return count;
        }
        if t < first || t.is_nan() {
            return 0;
        }
        let division = ((t - first) * self.density) as usize;
        let division = division.min(count - 1);
        // rounding may misplace a time by one division
        let from = division.checked_sub(2).map_or(0, |division| self.before[division]);
        let to = self.before[(division + 1).min(count - 1)];
        let near = &self.times[from..to];
        let is_past = |time: &&f64| **time <= t;
        from + if near.len() <= FEW {
            near.iter().take_while(is_past).count()
        } else {
            near.partition_point(|time| is_past(&time))
        }
    }
}

/// Value of a polynomial, given by its start and coefficients.
#[inline(always)]
fn value_of<T: Real>([start, c0, c1, c2, c3]: [T; 5], t: T, is_cubic: bool) -> T {
    let (s, is_constant) = (t - start, t.is_constant());
    let times = |slope: T| if is_constant { slope.scaled(s) } else { s * slope };
    let highest = if is_cubic { times(c2 + times(c3)) } else { T::default() };
    c0 + times(c1 + highest)
}

/// Polynomials of a natural cubic spline between its samples.
fn spline(times: &[f64], samples: &[f64]) -> Vec<[f64; 4]> {
    let intervals: Vec<(f64, f64)> = times
        .windows(2)
        .zip(samples.windows(2))
        .map(|(t, y)| (t[1] - t[0], (y[1] - y[0]) / (t[1] - t[0])))
        .collect();
    // Halves of the second derivatives m satisfy h0 m0 + 2 (h0 + h1) m1 + h1 m2 = 3 (s1 - s0), with the slopes s of the
    // chords, and zero at both ends: a tridiagonal system, solved by elimination from left to right.
    let mut eliminated = vec![(0.0, 0.0)];
    for pair in intervals.windows(2) {
        let [(h0, s0), (h1, s1)] = [pair[0], pair[1]];
        let (factor, right) = eliminated[eliminated.len() - 1];
        let pivot = 2.0 * (h0 + h1) - h0 * factor;
        eliminated.push((h1 / pivot, (3.0 * (s1 - s0) - h0 * right) / pivot));
    }
    let mut polynomials = vec![[0.0; 4]; intervals.len()];
    let mut next = 0.0;
    for (n, &(h, slope)) in intervals.iter().enumerate().rev() {
        let (factor, right) = eliminated[n];
        let here = right - factor * next;
        polynomials[n] = [
            samples[n],
            slope - h * (2.0 * here + next) / 3.0,
            here,
            (next - here) / (3.0 * h),
        ];
        next = here;
    }
    polynomials
}

impl<const M: usize> PartialEq for TimeTable<M> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.pieces, &other.pieces) || self.pieces == other.pieces
    }
}

impl<const N: usize, const M: usize> InputLaw<N, M> for TimeTable<M> {
    #[inline]
    fn inputs<T: Real>(&self, t: T, _x: &SVector<T, N>) -> [T; M] {
        // all inputs, and usually all lanes, need the piece at the same time
        let last = Cell::new((f64::NAN, 0));
        let piece_at = |t: f64| {
            if last.get().0 != t {
                last.set((t, self.pieces.samples_until(t)));
            }
            last.get().1
        };
        let mut inputs = [T::default(); M];
        for (input, value) in inputs.iter_mut().enumerate() {
            let polynomial = t.piecewise(|t| self.pieces.of(piece_at(t), input));
            *value = value_of(polynomial, t, self.pieces.are_cubic);
        }
        inputs
    }
}

impl<const M: usize> fmt::Debug for TimeTable<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let times = &self.pieces.times;
        f.debug_struct("TimeTable")
            .field("samples", &times.len())
            .field("span", &[times[0], times[times.len() - 1]])
            .finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::TimeTable;
    use crate::dual::Dual;
    use crate::error::SampleError;
    use crate::inputs::InputLaw;
    use crate::real::lanes::{F64x4, Lanes};

    fn at<const M: usize>(table: &TimeTable<M>, t: f64) -> [f64; M] {
        table.inputs(t, &SVector::<f64, 1>::zeros())
    }

    #[test]
    fn samples_are_met_held_and_joined() {
        let times: Vec<f64> = (0..200).map(|n| f64::from(n) + 0.3 * f64::from(n).sin()).collect();
        // clusters and gaps, beyond what equal divisions resolve
        let uneven: Vec<f64> = times.iter().map(|t| (t / 20.0).exp()).collect();
        for times in [times, uneven] {
            let values: Vec<f64> = times.iter().map(|t| (0.2 * t).cos()).collect();
            let all = [
                TimeTable::hold(&times, [&values, &values]),
                TimeTable::linear(&times, [&values, &values]),
                TimeTable::cubic(&times, [&values, &values]),
            ];
            for (way, table) in all.into_iter().enumerate() {
                let table = table.expect("samples");
                for n in 0..times.len() {
                    let [a, b] = at(&table, times[n]);
                    assert!((a - values[n]).abs() < 1e-14 && a == b);
                }
                for n in 1..times.len() {
                    let t = times[n].next_down();
                    let expected = if way == 0 { values[n - 1] } else { values[n] };
                    assert!((at(&table, t)[0] - expected).abs() < 1e-12, "{way}: {n}");
                }
                let last = values.len() - 1;
                assert_eq!(at(&table, times[0] - 1.0)[0], values[0]);
                assert_eq!(at(&table, times[last] + 1.0)[0], values[last]);
            }
        }
    }

    #[test]
    fn a_spline_converges_with_the_fourth_order_and_has_derivatives() {
        // sin has no second derivative at these ends
        let error = |count: u32| {
            let times: Vec<f64> = (0..=count)
                .map(|n| std::f64::consts::PI * f64::from(n) / f64::from(count))
                .collect();
            let values: Vec<f64> = times.iter().map(|t| t.sin()).collect();
            let table = TimeTable::cubic(&times, [&values]).expect("samples");
            let errors = (0..1000).map(|n| 0.001 * std::f64::consts::PI * f64::from(n)).map(|t| {
                let [y] = table.inputs(Dual::<f64, 1>::variable(t, 0), &SVector::from([Dual::constant(0.0)]));
                [(y.value - t.sin()).abs(), (y.slopes[0] - t.cos()).abs()]
            });
            errors.fold([0.0_f64; 2], |most, e| [most[0].max(e[0]), most[1].max(e[1])])
        };
        let ([coarse, coarse_slope], [fine, fine_slope]) = (error(10), error(20));
        assert!((3.8..4.2).contains(&(coarse / fine).log2()), "{coarse} {fine}");
        assert!((2.8..3.2).contains(&(coarse_slope / fine_slope).log2()));
    }

    #[test]
    fn lanes_may_lie_in_different_pieces() {
        let table = TimeTable::linear(&[0.0, 1.0, 3.0], [&[0.0, 2.0, 4.0]]).expect("samples");
        let times = [-1.0, 0.5, 1.5, 9.0];
        let [inputs] = table.inputs(F64x4::from_fn(|lane| times[lane]), &SVector::from([F64x4::default()]));
        assert!((0..4).all(|lane| inputs.lane(lane) == at(&table, times[lane])[0]));
    }

    #[test]
    fn each_lane_may_have_its_own_table() {
        let (times, samples) = ([0.0, 1.0, 3.0], [&[0.5, 2.0, 4.0][..]]);
        let tables = [
            TimeTable::hold(&times, samples),
            TimeTable::linear(&times, samples),
            TimeTable::cubic(&times, samples),
            TimeTable::linear(&[-1.0, 4.0], [&[1.0, -1.0]]),
        ];
        let tables = tables.map(|table| table.expect("samples"));
        for t in [-0.5, 0.3, 1.0, 2.9, 7.0] {
            let inputs = TimeTable::by_lane(F64x4::from_fn(|lane| t + 0.1 * lane as f64), |lane| &tables[lane]);
            for (lane, table) in tables.iter().enumerate() {
                assert_eq!(inputs.lane(lane), at(table, t + 0.1 * lane as f64)[0]);
            }
        }
    }

    #[test]
    fn samples_cover_the_times_that_they_determine() {
        let (times, samples) = ([0.0, 1.0, 3.0], [&[0.5, 2.0, 4.0][..]]);
        let linear = TimeTable::linear(&times, samples).expect("samples");
        assert!(linear.covers(0.0, 3.0) && !linear.covers(-0.1, 3.0) && !linear.covers(0.0, 3.1));
        let held = TimeTable::hold(&times, samples).expect("samples");
        assert!(held.covers(0.0, 5.0) && !held.covers(-0.1, 3.0) && !held.covers(0.0, 5.1));
        let constant = TimeTable::hold(&[2.0], [&[1.0]]).expect("a sample");
        assert!(constant.covers(-9.0, 9.0));
    }

    #[test]
    fn bad_samples_are_named() {
        let error = |times: &[f64], values: &[f64]| TimeTable::linear(times, [values]).expect_err("samples");
        assert!(matches!(
            error(&[0.0], &[1.0]),
            SampleError::TooFew { given: 1, least: 2 }
        ));
        assert!(matches!(
            error(&[0.0, 0.0], &[1.0, 1.0]),
            SampleError::Order { index: 1, .. }
        ));
        assert!(matches!(
            error(&[0.0, f64::NAN], &[1.0, 1.0]),
            SampleError::Time { index: 1, .. }
        ));
        assert!(matches!(
            error(&[0.0, 1.0], &[1.0]),
            SampleError::Length { given: 1, times: 2, .. }
        ));
        assert!(matches!(
            error(&[0.0, 1.0], &[1.0, f64::NAN]),
            SampleError::Value { index: 1, .. }
        ));
    }
}
