//! First guesses of the states at the starts of windows.

use std::ops::Range;

use nalgebra::{DMatrix, DVector};

use super::elimination::Echelon;
use super::measurement::Column;

/// Number of samples of the shortest polynomial.
const FEW: usize = 12;
/// A longer polynomial is used while its median residual is at most this many times that of the shortest.
const AS_GOOD: f64 = 1.5;

/// Value and rate of a measured column at the first of some samples, by a cubic polynomial over as many samples as it
/// describes; `None` if all values are missing, and without a rate if there is only one.
pub(super) fn value_and_rate(times: &[f64], column: &Column, samples: Range<usize>) -> Option<(f64, Option<f64>)> {
    let known: Vec<[f64; 2]> = samples
        .clone()
        .map(|n| [times[n] - times[samples.start], column.values[n]])
        .filter(|[_, value]| !value.is_nan())
        .collect();
    let mut count = FEW.min(known.len());
    let (mut best, least) = cubic(&known[..count])?;
    while count < known.len() {
        count = (2 * count).min(known.len());
        let Some((longer, residual)) = cubic(&known[..count]) else {
            break;
        };
        if residual > AS_GOOD * least {
            break;
        }
        best = longer;
    }
    Some((best[0], (known.len() > 1).then_some(best[1])))
}

/// Value and rate, at time zero, of the cubic polynomial with the least sum of absolute residuals, which outliers
/// hardly move, and the median of these; of a lower degree if there are few points. The sum is minimised by
/// iteratively reweighted least squares.
fn cubic(points: &[[f64; 2]]) -> Option<([f64; 2], f64)> {
    const ITERATIONS: usize = 20;
    let [scale, _] = *points.last()?;
    let scale = if scale > 0.0 { scale } else { 1.0 };
    let degree = (points.len() - 1).min(3);
    let powers = DMatrix::from_fn(points.len(), degree + 1, |i, k| {
        (0..k).fold(1.0, |power, _| power * points[i][0] / scale)
    });
    let values = DVector::from_iterator(points.len(), points.iter().map(|point| point[1]));
    let mut weights = DVector::from_element(points.len(), 1.0);
    let mut solution = vec![0.0; degree + 1];
    let mut median = 0.0;
    for _ in 0..ITERATIONS {
        let rows = DMatrix::from_fn(points.len(), degree + 2, |i, k| {
            weights[i] * if k <= degree { powers[(i, k)] } else { values[i] }
        });
        solution = Echelon::new(rows, degree + 1).solve(&[]);
        let residuals = (&powers * DVector::from_column_slice(&solution) - &values).abs();
        let mut sorted: Vec<f64> = residuals.iter().copied().collect();
        sorted.sort_by(f64::total_cmp);
        median = sorted[sorted.len() / 2];
        let least = (1e-3 * residuals.mean()).max(f64::MIN_POSITIVE);
        weights = residuals.map(|residual| 1.0 / residual.max(least).sqrt());
    }
    let rate = if degree > 0 { solution[1] / scale } else { 0.0 };
    Some(([solution[0], rate], median))
}

#[cfg(test)]
mod tests {
    use super::value_and_rate;
    use crate::fit::measurement::Column;

    #[test]
    fn a_smooth_column_gives_value_and_rate() {
        let times: Vec<f64> = (0..400).map(|n| 0.005 * f64::from(n)).collect();
        let mut seed = 7_u64;
        let mut uniform = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let values = times
            .iter()
            .map(|t| (5.0 * t).sin() + 0.002 * 12_f64.sqrt() * uniform())
            .collect();
        let mut column = Column {
            name: String::new(),
            values,
            noise: None,
        };
        column.values[100] = f64::NAN;
        column.values[106] += 1.0;
        let (value, rate) = value_and_rate(&times, &column, 100..400).expect("values");
        let rate = rate.expect("a rate");
        assert!(
            (value - 2.5_f64.sin()).abs() < 0.02 && (rate - 5.0 * 2.5_f64.cos()).abs() < 0.5,
            "{value} {rate}"
        );
        assert_eq!(value_and_rate(&times, &column, 100..101), None);
        let (_, rate) = value_and_rate(&times, &column, 100..102).expect("a value");
        assert_eq!(rate, None);
    }
}
