//! Complex Schur form with its eigenvalues in a chosen order, and the Lyapunov and Stein equations that it solves.

use nalgebra::{Complex, DMatrix};

/// The form `A = U T U^H` with unitary `U` and upper triangular `T`, whose diagonal holds the eigenvalues.
#[derive(Clone, Debug)]
pub(super) struct Schur {
    /// The matrix `U`.
    pub(super) vectors: DMatrix<Complex<f64>>,
    /// The matrix `T`.
    pub(super) triangle: DMatrix<Complex<f64>>,
}

/// Steps of the QR algorithm for one eigenvalue after which it counts as not converging.
const STEPS: usize = 60;
/// Number of steps after which another shift breaks a cycle of the algorithm.
const EXCEPTIONAL: usize = 10;

impl Schur {
    /// Computes the form by the QR algorithm with single shifts; `None` if it does not converge.
    ///
    /// Complex triangles need no care for pairs of eigenvalues when they are reordered, and the shift of Wilkinson with
    /// exceptional ones does not cycle on permutations, on which the double shift of nalgebra does. G. H. Golub, C. F.
    /// Van Loan, "Matrix Computations", 4th ed. (2013), 7.5.
    pub(super) fn of(matrix: &DMatrix<f64>) -> Option<Self> {
        let size = matrix.norm();
        if !size.is_finite() {
            return None;
        }
        let (vectors, triangle) = match matrix.nrows() {
            n @ (0 | 1) => (DMatrix::identity(n, n), matrix.clone()),
            _ => matrix.clone().hessenberg().unpack(),
        };
        let [vectors, triangle] = [vectors, triangle].map(|matrix| matrix.map(Complex::from));
        let mut schur = Self { vectors, triangle };
        let mut end = matrix.nrows().saturating_sub(1);
        let mut steps = 0;
        while end > 0 {
            let start = schur.start_of_block(end, size);
            if start == end {
                (end, steps) = (end - 1, 0);
                continue;
            }
            steps += 1;
            if steps > STEPS {
                return None;
            }
            let shift = match steps % EXCEPTIONAL {
                0 => schur.triangle[(end, end)] + schur.triangle[(end, end - 1)].norm(),
                _ => schur.shift(end),
            };
            schur.step(start, end, shift);
        }
        schur.triangle.fill_lower_triangle(Complex::ZERO, 1);
        Some(schur)
    }

    /// First index of the unreduced block that ends at `end`, after clearing what is negligible beside it.
    fn start_of_block(&mut self, end: usize, size: f64) -> usize {
        let t = &mut self.triangle;
        for k in (0..end).rev() {
            let neighbours = t[(k, k)].l1_norm() + t[(k + 1, k + 1)].l1_norm();
            let scale = if neighbours > 0.0 { neighbours } else { size };
            if t[(k + 1, k)].l1_norm() <= f64::EPSILON * scale {
                t[(k + 1, k)] = Complex::ZERO;
                return k + 1;
            }
        }
        0
    }

    /// Eigenvalue of the last block of two rows that is closer to its last entry (Wilkinson).
    fn shift(&self, end: usize) -> Complex<f64> {
        let entry = |i: usize, j: usize| self.triangle[(end - 1 + i, end - 1 + j)];
        let half = (entry(0, 0) - entry(1, 1)) * 0.5;
        let product = entry(0, 1) * entry(1, 0);
        let root = (half * half + product).sqrt();
        let larger = if (half + root).norm() > (half - root).norm() {
            half + root
        } else {
            half - root
        };
        if larger == Complex::ZERO {
            entry(1, 1)
        } else {
            entry(1, 1) - product / larger
        }
    }

    /// One step of the algorithm on the rows from `start` to `end`.
    fn step(&mut self, start: usize, end: usize, shift: Complex<f64>) {
        let mut column = [self.triangle[(start, start)] - shift, self.triangle[(start + 1, start)]];
        for k in start..end {
            self.rotate(k, column);
            if k > start {
                // Rounding errors that stay here would keep the entries above from converging.
                self.triangle[(k + 1, k - 1)] = Complex::ZERO;
            }
            if k + 1 < end {
                column = [self.triangle[(k + 1, k)], self.triangle[(k + 2, k)]];
            }
        }
    }

    /// Rotates the axes `k` and `k + 1` so that a vector with these components lies along the first of them.
    fn rotate(&mut self, k: usize, [f, g]: [Complex<f64>; 2]) {
        let length = libm::hypot(f.norm(), g.norm());
        if length == 0.0 {
            return;
        }
        let (f, g) = (f / length, g / length);
        let t = &mut self.triangle;
        for j in 0..t.ncols() {
            let (x, y) = (t[(k, j)], t[(k + 1, j)]);
            (t[(k, j)], t[(k + 1, j)]) = (f.conj() * x + g.conj() * y, f * y - g * x);
        }
        for matrix in [t, &mut self.vectors] {
            for i in 0..matrix.nrows() {
                let (x, y) = (matrix[(i, k)], matrix[(i, k + 1)]);
                (matrix[(i, k)], matrix[(i, k + 1)]) = (f * x + g * y, f.conj() * y - g.conj() * x);
            }
        }
    }

    /// Eigenvalues in the order of the diagonal.
    pub(super) fn eigenvalues(&self) -> Vec<Complex<f64>> {
        self.triangle.diagonal().iter().copied().collect()
    }

    /// Sorts the eigenvalues by ascending `key`: exchanges of neighbours by rotations (Golub and Van Loan, 7.6.2).
    pub(super) fn sort_by(&mut self, key: impl Fn(Complex<f64>) -> f64) {
        let mut keys: Vec<f64> = self.eigenvalues().into_iter().map(key).collect();
        for sorted in 1..keys.len() {
            for k in (0..sorted).rev() {
                if keys[k] <= keys[k + 1] {
                    break;
                }
                let t = &self.triangle;
                let (first, second) = (t[(k, k)], t[(k + 1, k + 1)]);
                self.rotate(k, [t[(k, k + 1)], second - first]);
                let t = &mut self.triangle;
                (t[(k, k)], t[(k + 1, k + 1)], t[(k + 1, k)]) = (second, first, Complex::ZERO);
                keys.swap(k, k + 1);
            }
        }
    }

    /// Solves `A^T X + X A = -F` for symmetric `F` (R. H. Bartels, G. W. Stewart, Comm. ACM 15 (1972) 820).
    pub(super) fn lyapunov(&self, f: &DMatrix<f64>) -> DMatrix<f64> {
        self.solve(
            f,
            |known, coefficients| known * coefficients,
            |diagonal, entry| (entry, diagonal),
        )
    }

    /// Solves `A^T X A - X = -F` for symmetric `F` (G. Kitagawa, Int. J. Control 25 (1977) 745).
    pub(super) fn stein(&self, f: &DMatrix<f64>) -> DMatrix<f64> {
        let adjoint = self.triangle.adjoint();
        self.solve(
            f,
            |known, coefficients| &adjoint * (known * coefficients),
            |diagonal, entry| (diagonal * entry, Complex::from(-1.0)),
        )
    }

    /// Column by column: `Y = U^H X U` satisfies an equation whose column `j` depends on the columns before it by
    /// `before`, and whose matrix is triangular. `entry` maps an entry of `T^H` to one of this matrix, and gives the
    /// term that is added to its diagonal.
    fn solve(
        &self,
        f: &DMatrix<f64>,
        before: impl Fn(&DMatrix<Complex<f64>>, &nalgebra::DVector<Complex<f64>>) -> nalgebra::DVector<Complex<f64>>,
        entry: impl Fn(Complex<f64>, Complex<f64>) -> (Complex<f64>, Complex<f64>),
    ) -> DMatrix<f64> {
        let (u, t, n) = (&self.vectors, &self.triangle, f.nrows());
        let right = -(u.adjoint() * f.map(Complex::from) * u);
        let mut y = DMatrix::zeros(n, n);
        for j in 0..n {
            let mut above = t.column(j).into_owned();
            above.rows_range_mut(j..).fill(Complex::ZERO);
            let mut column = right.column(j) - before(&y, &above);
            for i in 0..n {
                for k in 0..i {
                    let known = column[k];
                    column[i] -= entry(t[(j, j)], t[(k, i)].conj()).0 * known;
                }
                let (factor, added) = entry(t[(j, j)], t[(i, i)].conj());
                column[i] /= factor + added;
            }
            y.set_column(j, &column);
        }
        let x = (u * y * u.adjoint()).map(|entry| entry.re);
        (&x + x.transpose()) * 0.5
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Complex, DMatrix};

    use super::Schur;

    fn noise(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// Largest entry of `U T U^H - A` and of `U^H U - I`.
    fn error(schur: &Schur, matrix: &DMatrix<f64>) -> f64 {
        let Schur { vectors, triangle } = schur;
        let back = vectors * triangle * vectors.adjoint() - matrix.map(Complex::from);
        let unit = vectors.adjoint() * vectors - DMatrix::identity(matrix.nrows(), matrix.nrows());
        back.iter()
            .chain(unit.iter())
            .map(|entry| entry.norm())
            .fold(0.0, f64::max)
    }

    #[test]
    fn sorted_forms_are_those_of_the_matrix() {
        let mut seed = 1;
        let cycle = DMatrix::from_fn(7, 7, |i, j| if i == (j + 1) % 7 { 1.0 } else { 0.0 });
        let random = (1..=28).map(|n| DMatrix::from_fn(n, n, |_, _| noise(&mut seed)));
        for matrix in random.chain([cycle, DMatrix::zeros(4, 4), DMatrix::identity(3, 3)]) {
            let mut schur = Schur::of(&matrix).expect("convergence");
            assert!(error(&schur, &matrix) < 1e-13, "{}", matrix.nrows());
            schur.sort_by(|eigenvalue| eigenvalue.re);
            assert!(error(&schur, &matrix) < 1e-13, "{}", matrix.nrows());
            assert!(schur.eigenvalues().is_sorted_by(|a, b| a.re <= b.re + 1e-12));
        }
    }

    #[test]
    fn equations_of_lyapunov_and_stein_are_solved() {
        let mut seed = 2;
        for n in 1..=14 {
            let a = DMatrix::from_fn(n, n, |i, j| noise(&mut seed) - if i == j { 4.0 } else { 0.0 });
            let f = DMatrix::from_fn(n, n, |_, _| noise(&mut seed));
            let f = &f + f.transpose();
            let schur = Schur::of(&a).expect("convergence");
            let x = schur.lyapunov(&f);
            assert!((a.transpose() * &x + &x * &a + &f).amax() < 1e-12);
            let x = schur.stein(&f);
            assert!((a.transpose() * &x * &a - &x + &f).amax() < 1e-11 * (1.0 + x.amax()));
        }
    }
}
