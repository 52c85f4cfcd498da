//! Minima of convex quadratic functions in a box, by projected Newton steps.
//!
//! D. P. Bertsekas, SIAM J. Control Optim. 20 (1982) 221; Y. Tassa, N. Mansard, E. Todorov, "Control-limited
//! differential dynamic programming", ICRA (2014) 1168.

use nalgebra::SMatrix;

use crate::real::{Float, ulps};

/// Maximum number of Newton steps beyond one for each input.
const EXTRA_STEPS: usize = 20;
/// Maximum number of halvings of a step.
const HALVINGS: usize = 20;
/// Share of the decrease to first order that a step has to reach.
const SUFFICIENT: f64 = 0.1;
/// Gradient put down to rounding, in ulps of its terms.
const ROUNDING_ULPS: f64 = 16.0;

/// Cholesky factor of the rows and columns of a matrix that are free. In all others it is the identity.
#[derive(Clone, Copy, Debug)]
pub(super) struct Factor<T, const M: usize> {
    free: [bool; M],
    /// Lower triangle, one row each; the diagonal holds reciprocals.
    rows: [[T; M]; M],
}

impl<T: Float, const M: usize> Factor<T, M> {
    /// Returns `None` unless the matrix is positive definite in the free rows.
    #[inline(always)]
    pub(super) fn new(matrix: &SMatrix<T, M, M>, free: [bool; M]) -> Option<Self> {
        let mut rows = [[T::default(); M]; M];
        for i in 0..M {
            for j in 0..=i {
                let is_free = free[i] && free[j];
                let mut entry = match (is_free, i == j) {
                    (true, _) => matrix.data.0[j][i],
                    (false, true) => T::from_f64(1.0),
                    (false, false) => T::default(),
                };
                for (a, b) in rows[i][..j].iter().zip(&rows[j][..j]) {
                    entry -= *a * *b;
                }
                rows[i][j] = if i == j {
                    // also false for NaN
                    if !(entry > T::MIN_POSITIVE && entry.is_finite()) {
                        return None;
                    }
                    T::from_f64(1.0) / entry.sqrt()
                } else {
                    entry * rows[j][j]
                };
            }
        }
        Some(Self { free, rows })
    }

    /// Solves for the rows of `of`, with a minus sign: the result times the matrix is `-of` in the free columns, and 0
    /// in the others.
    #[inline(always)]
    pub(super) fn minus_solved<const N: usize>(&self, of: &SMatrix<T, N, M>) -> SMatrix<T, N, M> {
        let mut columns = of.data.0;
        for i in 0..M {
            let sign = T::from_f64(if self.free[i] { -1.0 } else { 0.0 });
            let mut column = T::scale_each(columns[i], sign);
            for (factor, solved) in self.rows[i][..i].iter().zip(&columns) {
                subtract(&mut column, *factor, solved);
            }
            columns[i] = T::scale_each(column, self.rows[i][i]);
        }
        for i in (0..M).rev() {
            let mut column = columns[i];
            for (row, solved) in self.rows.iter().zip(&columns).skip(i + 1) {
                subtract(&mut column, row[i], solved);
            }
            columns[i] = T::scale_each(column, self.rows[i][i]);
        }
        SMatrix::from_array_storage(nalgebra::ArrayStorage(columns))
    }
}

/// Subtracts the product of a factor and a column.
#[inline(always)]
fn subtract<T: Float, const N: usize>(from: &mut [T; N], factor: T, column: &[T; N]) {
    for (entry, of_column) in from.iter_mut().zip(column) {
        *entry -= factor * *of_column;
    }
}

/// A minimum, and the factor of the matrix in the inputs that are not held by a limit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Minimum<T, const M: usize> {
    pub(super) at: [T; M],
    pub(super) factor: Factor<T, M>,
}

/// Minimizes `u . matrix u / 2 + slope . u` for `low <= u <= high`, beginning near `start`. Returns `None` unless the
/// matrix is positive definite in the free inputs.
#[inline(always)]
pub(super) fn minimize<T: Float, const M: usize>(
    matrix: &SMatrix<T, M, M>,
    slope: &[T; M],
    [low, high]: [&[T; M]; 2],
    start: &[T; M],
) -> Option<Minimum<T, M>> {
    let mut at = limited(start, [low, high]);
    let mut known: Option<Factor<T, M>> = None;
    for _ in 0..M + EXTRA_STEPS {
        let (gradient, sizes) = gradient(matrix, slope, &at);
        let (mut free, mut is_level) = ([true; M], true);
        for i in 0..M {
            let is_held =
                at[i] <= low[i] && gradient[i] >= T::default() || at[i] >= high[i] && gradient[i] <= T::default();
            free[i] = !is_held;
            let rounding = ulps(ROUNDING_ULPS, sizes[i]);
            is_level &= is_held || gradient[i].abs() <= rounding;
        }
        let factor = match known {
            Some(factor) if factor.free == free => factor,
            _ => Factor::new(matrix, free)?,
        };
        known = Some(factor);
        if is_level {
            break;
        }
        let newton = factor.minus_solved(&SMatrix::<T, 1, M>::from_row_slice(&gradient));
        let (mut next, length) = searched(matrix, (&at, &gradient), &newton, [low, high]);
        if next == at {
            // a step of any length crosses a limit that is all but reached: that input is held from now on
            for i in 0..M {
                let reached = at[i] + length * newton.data.0[i][0];
                if reached > high[i] && gradient[i] < T::default() {
                    next[i] = high[i];
                } else if reached < low[i] && gradient[i] > T::default() {
                    next[i] = low[i];
                }
            }
        }
        if next == at {
            break;
        }
        at = next;
    }
    known.map(|factor| Minimum { at, factor })
}

/// Longest share of a Newton step, out of halved ones, that decreases the function enough: the point there, or `at` if
/// none does, and the share.
#[inline(always)]
fn searched<T: Float, const M: usize>(
    matrix: &SMatrix<T, M, M>,
    (at, gradient): (&[T; M], &[T; M]),
    newton: &SMatrix<T, 1, M>,
    limits: [&[T; M]; 2],
) -> ([T; M], T) {
    let mut length = T::from_f64(1.0);
    for _ in 0..HALVINGS {
        let mut reached = *at;
        for (reached, [newton]) in reached.iter_mut().zip(newton.data.0) {
            *reached += length * newton;
        }
        reached = limited(&reached, limits);
        let (mut promised, mut change) = (T::default(), T::default());
        for i in 0..M {
            let moved = reached[i] - at[i];
            let mut bent = T::default();
            for j in 0..M {
                bent += matrix.data.0[j][i] * (reached[j] - at[j]);
            }
            promised += gradient[i] * moved;
            change += moved * (gradient[i] + T::from_f64(0.5) * bent);
        }
        if change <= T::from_f64(SUFFICIENT) * promised {
            return (reached, length);
        }
        length *= T::from_f64(0.5);
    }
    (*at, length)
}

/// Gradient, and the sums of the magnitudes of its terms.
#[inline(always)]
fn gradient<T: Float, const M: usize>(matrix: &SMatrix<T, M, M>, slope: &[T; M], at: &[T; M]) -> ([T; M], [T; M]) {
    let (mut gradient, mut sizes) = (*slope, [T::default(); M]);
    for i in 0..M {
        sizes[i] = slope[i].abs();
    }
    for (j, factor) in at.iter().enumerate() {
        for i in 0..M {
            let term = matrix.data.0[j][i] * *factor;
            gradient[i] += term;
            sizes[i] += term.abs();
        }
    }
    (gradient, sizes)
}

#[inline(always)]
pub(super) fn limited<T: Float, const M: usize>(inputs: &[T; M], [low, high]: [&[T; M]; 2]) -> [T; M] {
    let mut limited = *inputs;
    for i in 0..M {
        limited[i] = limited[i].at_least(low[i]).at_most(high[i]);
    }
    limited
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};

    use super::minimize;
    use crate::linear::tests::noise;

    /// The minimum among all choices of the inputs that are held at a limit.
    fn by_enumeration(
        matrix: &SMatrix<f64, 3, 3>,
        slope: &SVector<f64, 3>,
        [low, high]: [&[f64; 3]; 2],
    ) -> (f64, SVector<f64, 3>) {
        let mut best = (f64::INFINITY, SVector::zeros());
        for choice in 0..27 {
            let (mut rows, mut right) = (*matrix, -slope);
            for (m, place) in [choice % 3, choice / 3 % 3, choice / 9].into_iter().enumerate() {
                if place < 2 {
                    rows.set_row(m, &SMatrix::<f64, 3, 3>::identity().row(m));
                    right[m] = [low, high][place][m];
                }
            }
            let at = rows.lu().solve(&right).expect("regular");
            let value = 0.5 * at.dot(&(matrix * at)) + slope.dot(&at);
            let is_inside = (0..3).all(|m| low[m] - 1e-12 <= at[m] && at[m] <= high[m] + 1e-12);
            if is_inside && value < best.0 {
                best = (value, at);
            }
        }
        best
    }

    #[test]
    fn minima_in_a_box_are_those_of_an_enumeration() {
        let mut seed = 1;
        for case in 0..1000 {
            let factor = SMatrix::<f64, 3, 3>::from_fn(|_, _| noise(&mut seed));
            let matrix = factor * factor.transpose() + SMatrix::identity() * 0.01;
            let slope = SVector::<f64, 3>::from_fn(|_, _| noise(&mut seed));
            let low = [(); 3].map(|()| noise(&mut seed));
            // some boxes are flat
            let high = [0, 1, 2].map(|m| low[m] + noise(&mut seed).max(0.0));
            let start = [(); 3].map(|()| noise(&mut seed));
            let found = minimize(&matrix, &slope.into(), [&low, &high], &start).expect("convex");
            let (value, at) = by_enumeration(&matrix, &slope, [&low, &high]);
            let found = SVector::from(found.at);
            assert!((found - at).amax() < 1e-10, "{case}: {found} is not {at}");
            let reached = 0.5 * found.dot(&(matrix * found)) + slope.dot(&found);
            assert!((reached - value).abs() < 1e-12, "{case}");
            assert!((0..3).all(|m| low[m] <= found[m] && found[m] <= high[m]), "{case}");
        }
    }

    #[test]
    fn an_input_that_has_almost_reached_its_limit_is_held_there() {
        let matrix = SMatrix::<f64, 2, 2>::new(1.0, 0.9, 0.9, 1.0);
        let (slope, low, high) = ([0.0, -1.0], [-10.0, -10.0], [10.0, 0.0]);
        for gap in [0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1.0] {
            for turned in [false, true] {
                let turn = |pair: [f64; 2]| if turned { pair.map(|entry| -entry) } else { pair };
                let [low, high] = if turned { [turn(high), turn(low)] } else { [low, high] };
                let found = minimize(&matrix, &turn(slope), [&low, &high], &turn([0.0, -gap])).expect("convex");
                assert_eq!(
                    (found.at, found.factor.free),
                    (turn([0.0, 0.0]), [true, false]),
                    "{gap}"
                );
            }
        }
    }

    #[test]
    fn a_matrix_that_is_not_positive_has_no_minimum() {
        let matrix = SMatrix::<f64, 2, 2>::new(1.0, 2.0, 2.0, 1.0);
        let [low, high] = [[-1.0; 2], [1.0; 2]];
        assert!(minimize(&matrix, &[0.0, 0.0], [&low, &high], &[0.0; 2]).is_none());
        let matrix = SMatrix::<f64, 2, 2>::new(1.0, f64::NAN, f64::NAN, 1.0);
        assert!(minimize(&matrix, &[0.0, 0.0], [&low, &high], &[0.0; 2]).is_none());
    }
}
