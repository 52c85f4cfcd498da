//! Linear least-squares problems of shooting: the corrections of the starts are eliminated window by window, so that a
//! small problem for the corrections of the parameters remains.
//!
//! The correction `d` minimises `|J d - r|`, with the derivatives `J` and the residuals `r`. Each row depends on the
//! start of one window, or, where a trajectory continues, on those of two, and on the parameters. Orthogonal
//! transformations bring the rows of a window to echelon form in its start. The rows below hold what remains for the
//! next window and the parameters.
//!
//! H. G. Bock, "Recent advances in parameter identification techniques for O.D.E." (1983); G. H. Golub, C. F. Van Loan,
//! "Matrix Computations", 4th ed. (2013), 5.2.

use nalgebra::{DMatrix, DVector};

use crate::real::lanes::{Isa, Routine};

/// A column whose remainder is below this part of its length depends on the columns before it, up to rounding errors.
const DEPENDENT: f64 = 1e-12;

/// Scalar product, in parts that vector registers sum side by side.
#[inline(always)]
fn product(a: &[f64], b: &[f64]) -> f64 {
    let ((a, a_left), (b, b_left)) = (a.as_chunks::<8>(), b.as_chunks::<8>());
    let mut sums = [0.0; 8];
    for (a, b) in a.iter().zip(b) {
        for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
            *sum += a * b;
        }
    }
    let mut sum = 0.0;
    for part in sums {
        sum += part;
    }
    for (a, b) in a_left.iter().zip(b_left) {
        sum += a * b;
    }
    sum
}

/// Reflects the last rows of columns by a normal of these rows.
struct Reflect {
    /// Number of all rows.
    height: usize,
    /// Half the square of the length of the normal.
    square: f64,
}

impl Routine<[f64], [f64]> for Reflect {
    type Output = ();

    #[inline(always)]
    fn run(self, columns: &mut [f64], normal: &[f64]) {
        for column in columns.chunks_exact_mut(self.height) {
            let part = &mut column[self.height - normal.len()..];
            let factor = product(normal, part) / self.square;
            for (entry, n) in part.iter_mut().zip(normal) {
                *entry -= factor * n;
            }
        }
    }
}

/// Rows `[J, r]` of a least-squares problem, in echelon form in their first columns.
#[derive(Clone, Debug)]
pub(super) struct Echelon {
    rows: DMatrix<f64>,
    /// The row with the pivot of each of the first columns; `None` where the column depends on those before it.
    pivots: Vec<Option<usize>>,
}

impl Echelon {
    /// Brings the first `columns` columns to echelon form by Householder reflections.
    pub(super) fn new(mut rows: DMatrix<f64>, columns: usize) -> Self {
        let height = rows.nrows();
        let lengths: Vec<f64> = (0..columns).map(|c| rows.column(c).norm()).collect();
        let mut pivots = vec![None; columns];
        let mut next = 0;
        for (column, pivot) in pivots.iter_mut().enumerate() {
            if next == height {
                break;
            }
            let entries = rows.as_mut_slice();
            let (done, others) = entries.split_at_mut((column + 1) * height);
            let part = &mut done[column * height + next..];
            let length = product(part, part).sqrt();
            if length <= DEPENDENT * lengths[column] {
                part.fill(0.0);
                continue;
            }
            // the reflection takes the column to a multiple of the first unit vector
            let target = if part[0] > 0.0 { -length } else { length };
            part[0] -= target;
            let square = -target * part[0];
            Isa::run_routine(Reflect { height, square }, others, part);
            part[0] = target;
            // the rows further below are not read again
            let most_pivots = part.len().min(columns - next);
            part[1..most_pivots].fill(0.0);
            *pivot = Some(next);
            next += 1;
        }
        Self { rows, pivots }
    }

    /// Number of rows with a pivot.
    pub(super) fn rank(&self) -> usize {
        self.pivots.iter().flatten().count()
    }

    /// The rows with a pivot.
    pub(super) fn upper(&self) -> DMatrix<f64> {
        self.rows.rows(0, self.rank()).into_owned()
    }

    /// The rows without a pivot, whose first columns are zero, from these columns on.
    fn below(&self) -> DMatrix<f64> {
        let (rank, columns) = (self.rank(), self.pivots.len());
        let (height, width) = self.rows.shape();
        self.rows
            .view((rank, columns), (height - rank, width - columns))
            .into_owned()
    }

    /// Solves for the corrections of the first columns, given those of the others. Corrections without a pivot are
    /// zero.
    pub(super) fn solve(&self, others: &[f64]) -> Vec<f64> {
        let columns = self.pivots.len();
        let last = self.rows.ncols() - 1;
        let mut solution = vec![0.0; columns];
        solution.extend(others);
        for column in (0..columns).rev() {
            if let Some(row) = self.pivots[column] {
                let known: f64 = (column + 1..last).map(|c| self.rows[(row, c)] * solution[c]).sum();
                solution[column] = (self.rows[(row, last)] - known) / self.rows[(row, column)];
            }
        }
        solution.truncate(columns);
        solution
    }
}

/// The rows of a window in the corrections of its start and of the parameters.
#[derive(Clone, Debug)]
pub(super) struct Block {
    /// In echelon form: start, parameters, residual.
    pub(super) rows: DMatrix<f64>,
    /// The rows by which the window continues the one before, in the start of that one, the start of this one, the
    /// parameters, and the residual; `None` for the first window of a trajectory.
    pub(super) joint: Option<DMatrix<f64>>,
}

impl Block {
    /// Standard deviation of a component of the start, of `n`, for given parameters and in units of the noise; infinite
    /// where the window does not determine it.
    pub(super) fn deviation_of(&self, component: usize, n: usize) -> f64 {
        // last, so that its pivot is the part that others cannot make up for
        let order = (0..n).filter(|&i| i != component).chain([component]);
        let columns: Vec<_> = order.map(|i| self.rows.column(i).into_owned()).collect();
        let start = Echelon::new(DMatrix::from_columns(&columns), n);
        start.pivots[n - 1].map_or(f64::INFINITY, |row| 1.0 / start.rows[(row, n - 1)].abs())
    }
}

/// A least-squares problem of which the starts are eliminated.
pub(super) struct Eliminated {
    /// In echelon form in the corrections of the parameters.
    pub(super) parameters: Echelon,
    /// For each window, the echelon form in the correction of its start. The other columns are the correction of the
    /// next start, and those of the parameters.
    starts: Vec<Echelon>,
    /// True for windows that the next one continues.
    continued: Vec<bool>,
}

/// Rows of a diagonal matrix, from the column `first` on.
fn diagonal(width: usize, first: usize, entries: &[f64]) -> DMatrix<f64> {
    let mut rows = DMatrix::zeros(entries.len(), width);
    for (n, &entry) in entries.iter().enumerate() {
        rows[(n, first + n)] = entry;
    }
    rows
}

/// Some columns of a block, and the first column where they go.
struct Columns {
    from: usize,
    to: usize,
    count: usize,
}

/// Stacks blocks of rows, each at the given columns.
fn stacked(width: usize, blocks: &[(&DMatrix<f64>, &[Columns])]) -> DMatrix<f64> {
    let height = blocks.iter().map(|(block, _)| block.nrows()).sum();
    let mut rows = DMatrix::zeros(height, width);
    let mut top = 0;
    for (block, places) in blocks {
        for &Columns { from, to, count } in *places {
            rows.view_mut((top, to), (block.nrows(), count))
                .copy_from(&block.columns(from, count));
        }
        top += block.nrows();
    }
    rows
}

impl Eliminated {
    /// Eliminates starts of length `n` from the blocks, with `p` parameters. `damping` has a factor for each component
    /// of each start, and for each parameter: the corrections times these factors are further residuals.
    pub(super) fn new(blocks: &[Block], [n, p]: [usize; 2], damping: &Damping) -> Self {
        // start, next start, parameters, residual
        let width = 2 * n + p + 1;
        let mut carried = DMatrix::zeros(0, n + p + 1);
        let mut of_parameters = diagonal(p + 1, 0, &damping.parameters);
        let mut starts = Vec::with_capacity(blocks.len());
        let mut continued = Vec::with_capacity(blocks.len());
        for (w, block) in blocks.iter().enumerate() {
            let next = blocks.get(w + 1).and_then(|next| next.joint.as_ref());
            let none = DMatrix::zeros(0, width);
            let damped = diagonal(width, 0, &damping.starts[w]);
            let columns = |from, to, count| Columns { from, to, count };
            let (whole, own) = ([columns(0, 0, width)], [columns(0, 0, n), columns(n, 2 * n, p + 1)]);
            // large entries first, for small rounding errors
            let rows = stacked(
                width,
                &[
                    (next.unwrap_or(&none), &whole),
                    (&carried, &own),
                    (&block.rows, &own),
                    (&damped, &whole),
                ],
            );
            let start = Echelon::new(rows, n);
            // next start, parameters, residual
            let below = start.below();
            if next.is_some() {
                carried = Echelon::new(below, n + p).upper();
            } else {
                let rows = stacked(
                    p + 1,
                    &[
                        (&of_parameters, &[columns(0, 0, p + 1)]),
                        (&below, &[columns(n, 0, p + 1)]),
                    ],
                );
                of_parameters = Echelon::new(rows, p).upper();
                carried = DMatrix::zeros(0, n + p + 1);
            }
            continued.push(next.is_some());
            starts.push(start);
        }
        Self {
            parameters: Echelon::new(of_parameters, p),
            starts,
            continued,
        }
    }

    /// Corrections of the starts, given those of the parameters.
    pub(super) fn starts(&self, parameters: &[f64]) -> Vec<Vec<f64>> {
        let mut corrections: Vec<Vec<f64>> = Vec::with_capacity(self.starts.len());
        for (start, &continued) in self.starts.iter().zip(&self.continued).rev() {
            let mut others = vec![0.0; start.pivots.len()];
            if let Some(next) = corrections.last().filter(|_| continued) {
                others.copy_from_slice(next);
            }
            others.extend(parameters);
            corrections.push(start.solve(&others));
        }
        corrections.reverse();
        corrections
    }

    /// Standard deviations of the start of each window, for given parameters and in units of the noise, if the windows
    /// are not joined; infinite where it is not determined.
    pub(super) fn deviations_of_starts(&self) -> Vec<Vec<f64>> {
        let of = |start: &Echelon| {
            let n = start.pivots.len();
            if start.rank() < n {
                return vec![f64::INFINITY; n];
            }
            let root = start.rows.view((0, 0), (n, n)).into_owned();
            deviations(&root)
        };
        self.starts.iter().map(of).collect()
    }
}

/// Factors that damp the corrections.
pub(super) struct Damping {
    pub(super) starts: Vec<Vec<f64>>,
    pub(super) parameters: Vec<f64>,
}

/// Square roots of the diagonal of `inverse(root^T root)`, of a triangular matrix.
fn deviations(root: &DMatrix<f64>) -> Vec<f64> {
    let n = root.nrows();
    match root.solve_upper_triangular(&DMatrix::identity(n, n)) {
        Some(inverse) => (0..n).map(|i| inverse.row(i).norm()).collect(),
        None => vec![f64::INFINITY; n],
    }
}

/// Corrections within `bounds` that minimise `|J d - r|`, where `rows` are `[J, r]` in echelon form.
///
/// Corrections that leave their bounds are set to these, the one that is furthest outside first, until all others are
/// inside.
pub(super) fn within(rows: &DMatrix<f64>, bounds: &[[f64; 2]]) -> Vec<f64> {
    let p = bounds.len();
    let mut fixed: Vec<Option<f64>> = vec![None; p];
    loop {
        let free: Vec<usize> = (0..p).filter(|&j| fixed[j].is_none()).collect();
        let mut right = rows.column(p).into_owned();
        for (j, value) in fixed.iter().enumerate() {
            if let Some(value) = *value {
                right.axpy(-value, &rows.column(j), 1.0);
            }
        }
        let mut columns: Vec<DVector<f64>> = free.iter().map(|&j| rows.column(j).into_owned()).collect();
        columns.push(right);
        let solution = Echelon::new(DMatrix::from_columns(&columns), free.len()).solve(&[]);
        let outside = |(&j, &value): (&usize, &f64)| {
            let [low, high] = bounds[j];
            let nearest = value.clamp(low, high);
            // relative to the room between the bounds, if there is any
            let by = (value - nearest).abs() / (high - low).clamp(f64::MIN_POSITIVE, 1e300);
            (nearest != value).then_some((by, j, nearest))
        };
        let worst = free.iter().zip(&solution).filter_map(outside);
        match worst.max_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((_, j, nearest)) => fixed[j] = Some(nearest),
            None => {
                let mut all: Vec<f64> = fixed.iter().map(|value| value.unwrap_or(0.0)).collect();
                free.iter().zip(solution).for_each(|(&j, value)| all[j] = value);
                return all;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector};

    use super::{Block, Damping, Echelon, Eliminated, within};

    /// Numbers without a pattern.
    fn matrix(rows: usize, columns: usize, seed: &mut u64) -> DMatrix<f64> {
        DMatrix::from_fn(rows, columns, |_, _| {
            *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        })
    }

    #[test]
    fn elimination_solves_the_whole_problem() {
        let (n, p, seed) = (3, 2, &mut 1);
        // two trajectories, of three windows and of one
        let joined = [false, true, true, false];
        let blocks: Vec<Block> = joined
            .iter()
            .map(|&joined| Block {
                rows: matrix(4, n + p + 1, seed),
                joint: joined.then(|| 1e4 * matrix(n, 2 * n + p + 1, seed)),
            })
            .collect();
        let unknowns = joined.len() * n + p;
        let damping = Damping {
            starts: vec![vec![0.3, 0.0, 0.1]; joined.len()],
            parameters: vec![0.2, 0.0],
        };
        let mut whole = DMatrix::zeros(0, unknowns + 1);
        let mut add = |block: &DMatrix<f64>, first: usize, starts: usize| {
            let top = whole.nrows();
            whole.resize_vertically_mut(top + block.nrows(), 0.0);
            for row in 0..block.nrows() {
                for column in 0..block.ncols() {
                    let place = if column < starts {
                        first + column
                    } else {
                        joined.len() * n + column - starts
                    };
                    whole[(top + row, place)] = block[(row, column)];
                }
            }
        };
        for (w, block) in blocks.iter().enumerate() {
            add(&block.rows, w * n, n);
            add(&super::diagonal(n + p + 1, 0, &damping.starts[w]), w * n, n);
            block.joint.iter().for_each(|joint| add(joint, (w - 1) * n, 2 * n));
        }
        add(&super::diagonal(p + 1, 0, &damping.parameters), 0, 0);
        let expected = whole.columns(0, unknowns).into_owned();
        let expected = expected
            .svd(true, true)
            .solve(&whole.column(unknowns), 0.0)
            .expect("vectors");

        let eliminated = Eliminated::new(&blocks, [n, p], &damping);
        let parameters = eliminated.parameters.solve(&[]);
        let mut solution: Vec<f64> = eliminated.starts(&parameters).concat();
        solution.extend(parameters);
        assert!((DVector::from(solution) - &expected).norm() < 1e-10 * expected.norm());
    }

    #[test]
    fn dependent_columns_lose_no_rows() {
        // the second column is twice the first
        let rows = DMatrix::from_row_slice(3, 4, &[1., 2., 1., 3., 1., 2., 0., 2., 0., 0., 1., 1.]);
        let solution = Echelon::new(rows, 3).solve(&[]);
        assert!((solution[0] - 2.0).abs() < 1e-14 && solution[1] == 0.0 && (solution[2] - 1.0).abs() < 1e-14);
        assert_eq!(Echelon::new(DMatrix::zeros(2, 2), 1).rank(), 0);
    }

    #[test]
    fn bounds_hold_and_the_rest_adapts() {
        // (a + b - 4)^2 + (a - 3)^2
        let rows = Echelon::new(DMatrix::from_row_slice(2, 3, &[1., 1., 4., 1., 0., 3.]), 2).upper();
        let free = [f64::NEG_INFINITY, f64::INFINITY];
        let solution = within(&rows, &[[0.0, 2.0], free]);
        assert!((solution[0] - 2.0).abs() < 1e-14 && (solution[1] - 2.0).abs() < 1e-14);
        let solution = within(&rows, &[free, [2.0, 2.0]]);
        assert!((solution[0] - 2.5).abs() < 1e-14 && solution[1] == 2.0);
    }
}
