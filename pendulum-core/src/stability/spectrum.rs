//! Eigenvalues and modes of a real matrix.

use nalgebra::linalg::balancing::balance_parlett_reinsch;
use nalgebra::{Complex, DMatrix, SMatrix, SVector, Schur};

use super::StabilityError;

/// The eigenvalues of a real matrix, each with its eigenvector: of a Jacobian at an equilibrium, or of a monodromy matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum<const N: usize> {
    modes: Vec<Mode<N>>,
}

/// An eigenvalue with its eigenvector. Of a linear system `x' = A x` that is a motion, `x(t) = Re(shape exp(eigenvalue t))`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode<const N: usize> {
    /// The eigenvalue, in 1/s for a Jacobian.
    pub eigenvalue: Complex<f64>,
    /// The eigenvector; its largest component is 1.
    pub shape: SVector<Complex<f64>, N>,
    /// How far rounding errors may have moved the eigenvalue: those of the matrix times its condition number, which is large where two
    /// eigenvalues nearly meet.
    pub uncertainty: f64,
}

impl<const N: usize> Spectrum<N> {
    /// The eigenvalues of `matrix`, by the QR algorithm on the balanced matrix, and the eigenvectors, each as the null vector of
    /// `matrix - eigenvalue I`. Equal eigenvalues have different vectors if they have as many.
    ///
    /// G. H. Golub, C. F. Van Loan, "Matrix Computations", 4th ed. (2013), 7.2 and 7.5.
    ///
    /// # Errors
    /// [`StabilityError::NotFinite`] if an entry is not finite, and [`StabilityError::NoConvergence`] if the algorithm does not come to
    /// its end.
    pub fn of(matrix: &SMatrix<f64, N, N>) -> Result<Self, StabilityError> {
        if matrix.iter().any(|entry| !entry.is_finite()) {
            return Err(StabilityError::NotFinite);
        }
        let mut eigenvalues = eigenvalues(matrix)?;
        // Pairs have the same real part to the last bit, and so stay together.
        eigenvalues.sort_by(|a, b| {
            let parts = |z: &Complex<f64>| (z.re, z.im.abs(), z.im);
            let ((a1, a2, a3), (b1, b2, b3)) = (parts(a), parts(b));
            b1.total_cmp(&a1).then(b2.total_cmp(&a2)).then(b3.total_cmp(&a3))
        });
        let mut modes: Vec<Mode<N>> = Vec::with_capacity(N);
        for &eigenvalue in &eigenvalues {
            modes.push(mode(matrix, eigenvalue, &modes)?);
        }
        Ok(Self { modes })
    }

    /// The modes, by falling real part of their eigenvalues; of a complex pair, that with the positive imaginary part comes first.
    #[must_use]
    pub fn modes(&self) -> &[Mode<N>] {
        &self.modes
    }

    /// The eigenvalues in the order of the modes.
    pub fn eigenvalues(&self) -> impl ExactSizeIterator<Item = Complex<f64>> {
        self.modes.iter().map(|mode| mode.eigenvalue)
    }
}

impl<const N: usize> Mode<N> {
    /// The real part of the eigenvalue, in 1/s for a Jacobian: the mode grows as `exp(growth_rate t)`, or decays where that is negative.
    #[must_use]
    pub fn growth_rate(&self) -> f64 {
        self.eigenvalue.re
    }

    /// The size of the imaginary part, in rad/s for a Jacobian: the frequency at which the mode swings.
    #[must_use]
    pub fn angular_frequency(&self) -> f64 {
        self.eigenvalue.im.abs()
    }

    /// The damping over the critical one, `-Re / |eigenvalue|`: between 0 and 1 the mode swings and decays, at 1 it creeps, and below 0 it
    /// grows; NaN for the eigenvalue 0.
    #[must_use]
    pub fn damping_ratio(&self) -> f64 {
        -self.eigenvalue.re / self.eigenvalue.norm()
    }
}

fn eigenvalues<const N: usize>(matrix: &SMatrix<f64, N, N>) -> Result<Vec<Complex<f64>>, StabilityError> {
    let mut balanced = DMatrix::from_column_slice(N, N, matrix.as_slice());
    balance_parlett_reinsch(&mut balanced);
    let iterations = 100 * N;
    match Schur::try_new(balanced, f64::EPSILON, iterations) {
        Some(schur) => Ok(schur.complex_eigenvalues().iter().copied().collect()),
        None => Err(StabilityError::NoConvergence {
            iterations,
            residual: f64::NAN,
        }),
    }
}

/// The mode of an eigenvalue, beside those that are known.
fn mode<const N: usize>(
    matrix: &SMatrix<f64, N, N>,
    eigenvalue: Complex<f64>,
    known: &[Mode<N>],
) -> Result<Mode<N>, StabilityError> {
    // More than the rounding errors of all steps of the algorithm.
    let noise = 8.0 * f64::EPSILON * matrix.norm();
    let entry = |i: usize, j: usize| {
        let shift = if i == j { eigenvalue } else { Complex::ZERO };
        Complex::from(matrix[(i, j)]) - shift
    };
    let iterations = 100 * N;
    let Some(svd) = DMatrix::from_fn(N, N, entry).try_svd(true, true, f64::EPSILON, iterations) else {
        return Err(StabilityError::NoConvergence {
            iterations,
            residual: f64::NAN,
        });
    };
    let (Some(left), Some(right)) = (svd.u, svd.v_t) else {
        unreachable!("both were asked for")
    };
    // Singular values fall: the last vector belongs to the least. An eigenvalue met before takes the one before that, if that is null, too.
    let met = known
        .iter()
        .filter(|mode| (mode.eigenvalue - eigenvalue).norm() <= 1e3 * noise)
        .count();
    let null = (0..=met)
        .rev()
        .map(|place| N - 1 - place)
        .find(|&place| svd.singular_values[place] <= 1e4 * noise)
        .unwrap_or(N - 1);
    let vector: SVector<Complex<f64>, N> = SVector::from_fn(|i, _| right[(null, i)].conj());
    let largest = vector[vector.map(Complex::norm).imax()];
    // The left and the right vector, of length 1 both: one over their product is the condition number.
    let product: Complex<f64> = (0..N).map(|i| left[(i, null)].conj() * vector[i]).sum();
    Ok(Mode {
        eigenvalue,
        shape: vector.map(|component| component / largest),
        // A double eigenvalue moves by the root of the errors.
        uncertainty: (noise / product.norm()).min((noise * matrix.norm()).sqrt()),
    })
}
