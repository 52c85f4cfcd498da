//! Eigenvalues and modes of a real matrix.

use nalgebra::linalg::balancing::balance_parlett_reinsch;
use nalgebra::{Complex, DMatrix, DVector, SMatrix, SVector, Schur};

use super::StabilityError;

/// Eigenvalues and eigenvectors of a real matrix: a Jacobian at an equilibrium, or a monodromy matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum<const N: usize> {
    modes: Vec<Eigenmode<N>>,
}

/// An eigenvalue with its eigenvector. For a linear system `x' = A x` it represents the motion
/// `x(t) = Re(shape exp(eigenvalue t))`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eigenmode<const N: usize> {
    /// Eigenvalue, in 1/s for a Jacobian.
    pub eigenvalue: Complex<f64>,
    /// Eigenvector, scaled so that its largest component is 1.
    pub shape: SVector<Complex<f64>, N>,
    /// Condition number: the amplification of small errors of the matrix in the eigenvalue. Infinite for a defective
    /// double eigenvalue.
    pub condition: f64,
    /// Bound on the change of the eigenvalue by rounding errors: rounding errors of the matrix times the condition
    /// number, which is large near a double eigenvalue.
    pub uncertainty: f64,
}

impl<const N: usize> Spectrum<N> {
    /// Computes the eigenvalues of `matrix` by the QR algorithm on the balanced matrix, and each eigenvector as a null
    /// vector of `matrix - eigenvalue I`. Equal eigenvalues have orthogonal eigenvectors if there are enough of them.
    ///
    /// G. H. Golub, C. F. Van Loan, "Matrix Computations", 4th ed. (2013), 7.2 and 7.5.
    ///
    /// # Errors
    /// [`StabilityError::NotFinite`] if an entry is not finite, and [`StabilityError::NoConvergence`] if the algorithm
    /// does not converge.
    pub fn of(matrix: &SMatrix<f64, N, N>) -> Result<Self, StabilityError> {
        let modes = pairs(&DMatrix::from_column_slice(N, N, matrix.as_slice()))?;
        let modes = modes.into_iter().map(|mode| mode.placed(|shape| shape)).collect();
        Ok(Self { modes })
    }

    /// Like [`of`](Self::of), restricted to the invariant subspace spanned by the orthonormal columns of `basis`.
    pub(super) fn along(matrix: &SMatrix<f64, N, N>, basis: &DMatrix<f64>) -> Result<Self, StabilityError> {
        let lifted = basis.map(Complex::from);
        let modes = pairs(&(basis.transpose() * (matrix * basis)))?;
        let modes = modes
            .into_iter()
            .map(|mode| mode.placed(|shape| &lifted * shape))
            .collect();
        Ok(Self { modes })
    }

    /// Modes in descending order of the real part of their eigenvalues. In a complex pair, the eigenvalue with positive
    /// imaginary part comes first.
    #[must_use]
    pub fn modes(&self) -> &[Eigenmode<N>] {
        &self.modes
    }

    /// Eigenvalues in the order of the modes.
    pub fn eigenvalues(&self) -> impl ExactSizeIterator<Item = Complex<f64>> {
        self.modes.iter().map(|mode| mode.eigenvalue)
    }
}

impl<const N: usize> Eigenmode<N> {
    /// Real part of the eigenvalue, in 1/s for a Jacobian: the mode grows as `exp(growth_rate t)`, or decays if it is
    /// negative.
    #[must_use]
    pub fn growth_rate(&self) -> f64 {
        self.eigenvalue.re
    }

    /// Absolute value of the imaginary part, in rad/s for a Jacobian: the angular frequency of the mode.
    #[must_use]
    pub fn angular_frequency(&self) -> f64 {
        self.eigenvalue.im.abs()
    }

    /// Damping ratio `-Re / |eigenvalue|`: between 0 and 1 the mode oscillates and decays, at 1 it decays without
    /// oscillation, and below 0 it grows. NaN for the eigenvalue 0.
    #[must_use]
    pub fn damping_ratio(&self) -> f64 {
        -self.eigenvalue.re / self.eigenvalue.norm()
    }
}

/// An eigenvalue with an eigenvector of unit norm; see [`Eigenmode`].
#[derive(Clone, Debug)]
pub(crate) struct Pair {
    pub(crate) eigenvalue: Complex<f64>,
    pub(crate) shape: DVector<Complex<f64>>,
    condition: f64,
    pub(crate) uncertainty: f64,
}

impl Pair {
    /// Mode with the shape of the pair, mapped by `place`.
    fn placed<const N: usize>(
        self,
        place: impl FnOnce(DVector<Complex<f64>>) -> DVector<Complex<f64>>,
    ) -> Eigenmode<N> {
        let shape: SVector<Complex<f64>, N> = SVector::from_column_slice(place(self.shape).as_slice());
        let largest = shape[shape.map(Complex::norm).imax()];
        Eigenmode {
            eigenvalue: self.eigenvalue,
            shape: shape.map(|component| component / largest),
            condition: self.condition,
            uncertainty: self.uncertainty,
        }
    }
}

/// Modes in the order of [`Spectrum::modes`].
pub(crate) fn pairs(matrix: &DMatrix<f64>) -> Result<Vec<Pair>, StabilityError> {
    // The balance of a matrix whose squares overflow does not end.
    if !matrix.norm_squared().is_finite() {
        return Err(StabilityError::NotFinite);
    }
    let mut upper = eigenvalues(matrix)?;
    upper.retain(|eigenvalue| eigenvalue.im >= 0.0);
    upper.sort_by(|a, b| b.re.total_cmp(&a.re).then(b.im.total_cmp(&a.im)));
    let mut modes: Vec<Pair> = Vec::new();
    for &eigenvalue in &upper {
        let pair = pair(matrix, eigenvalue, &modes);
        let conjugate = (eigenvalue.im > 0.0).then(|| Pair {
            eigenvalue: eigenvalue.conj(),
            shape: pair.shape.map(|component| component.conj()),
            ..pair
        });
        modes.push(pair);
        modes.extend(conjugate);
    }
    Ok(modes)
}

fn eigenvalues(matrix: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, StabilityError> {
    let mut balanced = matrix.clone();
    balance_parlett_reinsch(&mut balanced);
    let iterations = 100 * matrix.nrows();
    // A subdiagonal entry counts as zero when it is an ulp of its neighbours. Rounding may prevent convergence to this
    // level, so a few ulps are accepted in a second attempt.
    let within = |ulps: f64| Schur::try_new(balanced.clone(), ulps * f64::EPSILON, iterations);
    match within(1.0).or_else(|| within(4.0)) {
        Some(schur) => Ok(schur.complex_eigenvalues().iter().copied().collect()),
        None => Err(StabilityError::NoConvergence {
            iterations,
            residual: f64::NAN,
        }),
    }
}

/// Mode of an eigenvalue, given the modes already known.
fn pair(matrix: &DMatrix<f64>, eigenvalue: Complex<f64>, known: &[Pair]) -> Pair {
    // Bound on the rounding errors of all steps of the algorithm.
    let noise = 8.0 * f64::EPSILON * matrix.norm();
    // Distance below which eigenvalues count as equal.
    let same = 1e2 * noise;
    let entry = |i: usize, j: usize| {
        let shift = if i == j { eigenvalue } else { Complex::ZERO };
        Complex::from(matrix[(i, j)]) - shift
    };
    let shifted = DMatrix::from_fn(matrix.nrows(), matrix.nrows(), entry);
    let left = kernel(shifted.clone(), same);
    let right = kernel(shifted.adjoint(), same);
    // Any vector of the null space is an eigenvector.
    let met: Vec<DVector<Complex<f64>>> = known
        .iter()
        .filter(|mode| (mode.eigenvalue - eigenvalue).norm() <= same)
        .map(|mode| mode.shape.normalize())
        .collect();
    let vector = beside(&met, &right).unwrap_or_else(|| right[0].clone());
    // Rounding also splits equal real eigenvalues into conjugate pairs. Two orthogonal real eigenvectors then combine
    // to a complex vector that is independent of its conjugate. A slow oscillation has such vectors anyway.
    let first = real(&vector);
    let second = beside(&[&met[..], std::slice::from_ref(&first)].concat(), &right)
        .filter(|_| (1e-300..=same).contains(&eigenvalue.im));
    let vector = match second.map(|second| real(&second) * Complex::I) {
        Some(second) => [&first + &second, &first - &second]
            .map(|vector| vector.normalize())
            .into_iter()
            .max_by(|a, b| a.dotc(&vector).norm().total_cmp(&b.dotc(&vector).norm()))
            .unwrap_or(vector),
        None => vector,
    };
    // The norm of the projection onto the left null space is the reciprocal of the condition number.
    let product = left
        .iter()
        .map(|left| left.dotc(&vector).norm_sqr())
        .sum::<f64>()
        .sqrt();
    Pair {
        eigenvalue,
        shape: vector,
        condition: 1.0 / product,
        // A double eigenvalue changes by the square root of the error.
        uncertainty: (noise / product).min((noise * matrix.norm()).sqrt()),
    }
}

/// First direction of the null space that is not in the span of `known`, made orthogonal to it.
fn beside(known: &[DVector<Complex<f64>>], null: &[DVector<Complex<f64>>]) -> Option<DVector<Complex<f64>>> {
    let remainder = |vector: DVector<Complex<f64>>| {
        known.iter().fold(vector, |rest, known| {
            let share = known.dotc(&rest);
            rest - known * share
        })
    };
    let mut remainders = null.iter().cloned().map(remainder);
    let remainder = remainders.find(|remainder| remainder.norm() > 0.1)?;
    Some(remainder.normalize())
}

/// Real or imaginary part of a vector, whichever is longer, normalised.
fn real(vector: &DVector<Complex<f64>>) -> DVector<Complex<f64>> {
    let parts = [
        vector.map(|component| component.re),
        vector.map(|component| component.im),
    ];
    let [re, im] = parts;
    let longer = if re.norm() < im.norm() { im } else { re };
    longer.normalize().map(Complex::from)
}

/// Orthonormal basis of the left null space of a matrix, up to singular values of about `least`; at least one vector.
///
/// By a pivoted QR factorisation (Golub and Van Loan, 5.4.2): zero rows of `R` select columns of `Q`. The left singular
/// vectors of nalgebra are accurate only to some per cent for equal singular values.
fn kernel(matrix: DMatrix<Complex<f64>>, least: f64) -> Vec<DVector<Complex<f64>>> {
    let n = matrix.nrows();
    let factors = matrix.col_piv_qr();
    let (q, r) = (factors.q(), factors.r());
    let least = least.max(r[(n - 1, n - 1)].norm());
    let null = (0..n).rev().take_while(|&k| r[(k, k)].norm() <= least);
    null.map(|k| q.column(k).into_owned()).collect()
}
