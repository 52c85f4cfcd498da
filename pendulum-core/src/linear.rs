//! Small systems of linear equations, real and complex, solved on the stack.

mod field;
mod pivots;

use nalgebra::{SMatrix, SVector};

use crate::cost::Operations;
use crate::real::{Float, Real};
pub(crate) use field::{Complex, Field};
#[cfg(feature = "std")]
pub(crate) use pivots::PerLane;
pub(crate) use pivots::{Alone, Pivots};

/// An LU factorisation with row pivoting, `P A = L U`, of one matrix or of one matrix per lane, each with its own
/// pivots.
///
/// Gaussian elimination with partial pivoting (G. H. Golub, C. F. Van Loan, "Matrix Computations", 4th ed., 3.4), for
/// small matrices: all storage is in arrays of constant length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lu<F, const N: usize, P = Alone<N>> {
    /// Columns of `L` below the diagonal (without its unit diagonal), reciprocals of the pivots on the diagonal, and
    /// `U` above.
    factors: [[F; N]; N],
    pivots: P,
}

/// The matrix is singular within the range of its number type, or has an entry that is not finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Singular;

impl<F: Field<Size: Float>, const N: usize> Lu<F, N> {
    /// Factors the first `active` rows and columns of a matrix given by its columns.
    ///
    /// # Errors
    /// If a pivot is zero, not finite, or so small or large that its reciprocal is out of the range of the type.
    #[inline(always)]
    pub(crate) fn new(columns: [[F; N]; N], active: usize) -> Result<Self, Singular> {
        Self::of(columns, active)
    }
}

impl<F: Field, P: Pivots<F, N>, const N: usize> Lu<F, N, P> {
    /// Factors a matrix like [`new`](Lu::new), or one matrix per lane.
    #[inline(always)]
    pub(crate) fn of(columns: [[F; N]; N], active: usize) -> Result<Self, Singular> {
        let (mut a, n) = (columns, active.min(N));
        let mut pivots = P::in_order();
        for k in 0..n {
            // Each row is compared and swapped in turn, so that indices are constants in unrolled loops and the factors
            // stay in registers.
            for i in k + 1..n {
                pivots.compare(&mut a, k, i);
            }
            let over_pivot = a[k][k].reciprocal();
            pivots.take(a[k][k], over_pivot);
            a[k][k] = over_pivot;
            for entry in &mut a[k][k + 1..n] {
                *entry = *entry * over_pivot;
            }
            for j in k + 1..n {
                for i in k + 1..n {
                    a[j][i] = a[j][i].minus_product(a[k][i], a[j][k]);
                }
            }
        }
        // Numbers that are not finite propagate to a pivot of a later column.
        if pivots.are_regular() {
            Ok(Self { factors: a, pivots })
        } else {
            Err(Singular)
        }
    }

    /// See [`Pivots::defect`].
    #[inline(always)]
    pub(crate) fn defect(&self) -> F {
        self.pivots.defect()
    }

    /// Solves `A x = b` for `x`, in the rows that were factored; the others stay those of `b`.
    #[inline(always)]
    #[must_use]
    pub(crate) fn solve(&self, b: &[F; N], active: usize) -> [F; N] {
        let [x] = Self::solve_each(core::array::from_ref(self), core::array::from_ref(b), active);
        x
    }

    /// Solves several systems of equations like [`solve`](Self::solve), side by side, since each operation waits for
    /// the one before it.
    #[inline(always)]
    #[must_use]
    pub(crate) fn solve_each<const M: usize>(each: &[Self; M], b: &[[F; N]; M], active: usize) -> [[F; N]; M] {
        let (mut x, n) = (*b, active.min(N));
        for m in 0..M {
            x[m] = each[m].pivots.sorted(&b[m]);
        }
        for k in 0..n {
            for i in k + 1..n {
                for m in 0..M {
                    x[m][i] = x[m][i].minus_product(each[m].factors[k][i], x[m][k]);
                }
            }
        }
        for k in (0..n).rev() {
            for m in 0..M {
                x[m][k] = x[m][k] * each[m].factors[k][k];
            }
            for i in 0..k {
                for m in 0..M {
                    x[m][i] = x[m][i].minus_product(each[m].factors[k][i], x[m][k]);
                }
            }
        }
        x
    }
}

/// Operations of [`Lu::new`] for `n` rows.
pub(crate) const fn factoring<F: Field>(n: usize) -> Operations {
    let mut operations = Operations::ZERO;
    let mut below = n;
    while below > 0 {
        below -= 1;
        let pivot = F::SIZE.times(2 * below + 1).and(F::RECIPROCAL);
        let multipliers = F::PRODUCT.times(below).with_chain(F::PRODUCT.chain);
        let term = F::PRODUCT.and(F::SUM);
        let rest = term.times(below * below).with_chain(term.chain);
        operations = operations.and(pivot).and(multipliers).and(rest);
    }
    operations
}

/// Operations of [`Lu::solve`] for `n` rows.
pub(crate) const fn solving<F: Field>(n: usize) -> Operations {
    let term = F::PRODUCT.and(F::SUM);
    let operations = term.times(n * n.saturating_sub(1)).and(F::PRODUCT.times(n));
    operations.with_chain((2 * term.chain + F::PRODUCT.chain) * n)
}

/// Product of a matrix and a vector. The one of nalgebra requires more traits than [`Real`] provides.
#[inline(always)]
pub(crate) fn image<T: Real, const N: usize>(matrix: &SMatrix<T, N, N>, vector: &SVector<T, N>) -> SVector<T, N> {
    let mut image = [T::default(); N];
    for (column, &factor) in matrix.data.0.iter().zip(&vector.data.0[0]) {
        for (image, &entry) in image.iter_mut().zip(column) {
            *image += entry * factor;
        }
    }
    SVector::from(image)
}

/// Squared Euclidean norm of a vector.
#[inline(always)]
pub(crate) fn square<T: Real, const N: usize>(vector: &SVector<T, N>) -> T {
    vector.iter().fold(T::default(), |sum, &v| sum + v * v)
}

#[cfg(test)]
pub(crate) mod tests {
    use super::{Complex, Field, Lu, Singular};
    use crate::real::Float;

    /// Pseudorandom number between -1 and 1 (the generator of MMIX).
    pub(crate) fn noise(seed: &mut u64) -> f64 {
        *seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn product<F: Field, const N: usize>(columns: &[[F; N]; N], x: &[F; N]) -> [F; N] {
        let term = |i: usize, j: usize| columns[j][i] * x[j];
        core::array::from_fn(|i| (0..N).fold(F::default(), |sum, j| sum + term(i, j)))
    }

    /// Largest residual of `solve(A x)` in ulps, over 200 random matrices.
    fn error<F: Field<Size: Float>, const N: usize>(mut entry: impl FnMut() -> F) -> f64 {
        let mut worst = 0.0_f64;
        for _ in 0..200 {
            let columns: [[F; N]; N] = core::array::from_fn(|_| core::array::from_fn(|_| entry()));
            let x = core::array::from_fn(|_| entry());
            let lu = Lu::new(columns, N).expect("regular");
            // The residual is bounded independently of the condition number; the error of x is not.
            let residual = product(&columns, &lu.solve(&product(&columns, &x), N));
            let error = |(a, b): (F, F)| (a - b).size().to_f64() / F::Size::EPSILON.to_f64();
            worst = core::iter::zip(residual, product(&columns, &x))
                .map(error)
                .fold(worst, f64::max);
        }
        worst
    }

    #[test]
    fn a_solution_fulfils_its_equations() {
        let mut seed = 1;
        let mut real = || noise(&mut seed);
        assert!(error::<f64, 1>(&mut real) < 2.0);
        assert!(error::<f64, 4>(&mut real) < 200.0);
        assert!(error::<f64, 14>(&mut real) < 2000.0);
        assert!(error::<f32, 6>(|| real() as f32) < 500.0);
        assert!(error::<Complex<f64>, 4>(|| Complex::new(real(), real())) < 500.0);
        assert!(error::<Complex<f64>, 12>(|| Complex::new(real(), real())) < 2000.0);
    }

    #[test]
    fn a_zero_on_the_diagonal_is_no_obstacle() {
        let lu = Lu::new([[0.0, 0.0, 2.0], [1.0, 0.0, 0.0], [0.0, 4.0, 0.0]], 3).expect("a permutation");
        assert_eq!(lu.solve(&[1.0, 2.0, 3.0], 3), [1.5, 1.0, 0.5]);
    }

    #[test]
    fn the_largest_pivot_is_taken() {
        // With the small pivot x_0 would be 0 instead of 1: Golub and Van Loan, 3.3.
        let lu = Lu::new([[1e-20, 1.0], [1.0, 1.0]], 2).expect("regular");
        assert_eq!(lu.solve(&[1.0, 2.0], 2), [1.0, 1.0]);
        let i = Complex::new(0.0, 1.0);
        let one = Complex::new(1.0, 0.0);
        let lu = Lu::new([[Complex::new(1e-20, 0.0), i], [one, one]], 2).expect("regular");
        // x = (1, 1) to 20 digits, since b = A (1, 1)
        assert_eq!(lu.solve(&[one, one + i], 2), [one, one]);
    }

    /// Random matrices whose lanes need different pivots, some of them singular.
    #[cfg(feature = "std")]
    #[test]
    fn each_lane_has_the_pivots_that_it_has_alone() {
        use super::PerLane;
        use crate::real::Real;
        use crate::real::lanes::{F32x8, F64x4, Lanes};

        fn check<V: Lanes, const N: usize>(seed: &mut u64) -> [usize; 2] {
            let (mut regular, mut singular) = (0, 0);
            for round in 0..200 {
                // rounding produces equal entries and zeros
                let coarse =
                    |number: f64| V::Scalar::from_f64(if round % 2 == 0 { (2.0 * number).round() } else { number });
                let mut entries = || -> [[V; N]; N] {
                    core::array::from_fn(|_| core::array::from_fn(|_| V::from_fn(|_| coarse(noise(seed)))))
                };
                let (columns, b) = (entries(), entries()[0]);
                let lu = Lu::<V, N, PerLane<V, N>>::of(columns, N).expect("in lanes");
                let x = lu.solve(&b, N);
                for lane in 0..V::LANES {
                    let own = columns.map(|column| column.map(|entry| entry.lane(lane)));
                    match Lu::new(own, N) {
                        Ok(alone) => {
                            regular += 1;
                            assert!(lu.defect().lane(lane).is_finite(), "{own:?}");
                            let alone = alone.solve(&b.map(|b| b.lane(lane)), N).map(|x| x.to_f64().to_bits());
                            assert_eq!(x.map(|x| x.lane(lane).to_f64().to_bits()), alone, "{own:?}");
                        }
                        Err(Singular) => {
                            singular += 1;
                            assert!(!lu.defect().lane(lane).is_finite(), "{own:?}");
                        }
                    }
                }
            }
            [regular, singular]
        }
        let mut seed = 1;
        for [regular, singular] in [
            check::<F64x4, 2>(&mut seed),
            check::<F64x4, 4>(&mut seed),
            check::<F32x8, 5>(&mut seed),
        ] {
            assert!(regular > 100 && singular > 10, "{regular} {singular}");
        }
    }

    #[cfg(feature = "std")]
    #[test]
    fn a_lane_is_singular_where_no_reciprocal_exists() {
        use super::PerLane;
        use crate::real::lanes::{F64x4, Lanes};

        let pivots = [
            f64::MAX,
            f64::MIN_POSITIVE,
            5e-324,
            0.0,
            -0.0,
            f64::INFINITY,
            f64::NAN,
            1.0,
        ];
        for pivots in pivots.chunks(4) {
            let lu =
                Lu::<F64x4, 1, PerLane<F64x4, 1>>::of([[F64x4::from_fn(|lane| pivots[lane])]], 1).expect("in lanes");
            for (lane, &pivot) in pivots.iter().enumerate() {
                assert_eq!(
                    lu.defect().lane(lane).is_finite(),
                    Lu::new([[pivot]], 1).is_ok(),
                    "{pivot}"
                );
            }
        }
    }

    #[test]
    fn singular_matrices_are_refused() {
        assert_eq!(Lu::new([[1.0, 2.0], [2.0, 4.0]], 2).err(), Some(Singular));
        assert_eq!(Lu::new([[0.0]], 1).err(), Some(Singular));
        let (one, i) = (Complex::new(1.0, 0.0), Complex::new(0.0, 1.0));
        assert_eq!(Lu::new([[one, i], [i, -one]], 2).err(), Some(Singular));
    }

    #[test]
    fn entries_that_are_not_finite_are_refused_wherever_they_are() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for place in 0..9 {
                let mut columns = [[4.0, 1.0, 0.0], [0.0, 3.0, 1.0], [2.0, 0.0, 5.0]];
                columns[place / 3][place % 3] = bad;
                assert_eq!(Lu::new(columns, 3).err(), Some(Singular), "{bad} at {place}");
            }
        }
    }
}
