//! Eigenvalues and modes of a real matrix.

use nalgebra::linalg::balancing::balance_parlett_reinsch;
use nalgebra::{Complex, DMatrix, DVector, SMatrix, SVector, Schur};

use super::StabilityError;

/// The eigenvalues of a real matrix, each with its eigenvector: of a Jacobian at an equilibrium, or of a monodromy matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum<const N: usize> {
    modes: Vec<Eigenmode<N>>,
}

/// An eigenvalue with its eigenvector. Of a linear system `x' = A x` that is a motion, `x(t) = Re(shape exp(eigenvalue t))`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eigenmode<const N: usize> {
    /// The eigenvalue, in 1/s for a Jacobian.
    pub eigenvalue: Complex<f64>,
    /// The eigenvector; its largest component is 1.
    pub shape: SVector<Complex<f64>, N>,
    /// How many times small errors of the matrix are magnified in the eigenvalue; infinite where it is double and has one eigenvector.
    pub condition: f64,
    /// How far rounding errors may have moved the eigenvalue: those of the matrix times its condition number, which is large where two
    /// eigenvalues nearly meet.
    pub uncertainty: f64,
}

impl<const N: usize> Spectrum<N> {
    /// The eigenvalues of `matrix`, by the QR algorithm on the balanced matrix, and the eigenvectors, each as the null vector of
    /// `matrix - eigenvalue I`. Equal eigenvalues have orthogonal vectors if they have as many.
    ///
    /// G. H. Golub, C. F. Van Loan, "Matrix Computations", 4th ed. (2013), 7.2 and 7.5.
    ///
    /// # Errors
    /// [`StabilityError::NotFinite`] if an entry is not finite, and [`StabilityError::NoConvergence`] if the algorithm does not come to
    /// its end.
    pub fn of(matrix: &SMatrix<f64, N, N>) -> Result<Self, StabilityError> {
        let modes = modes(&DMatrix::from_column_slice(N, N, matrix.as_slice()))?;
        let modes = modes.into_iter().map(|mode| mode.placed(|shape| shape)).collect();
        Ok(Self { modes })
    }

    /// The same of small motions along the columns of `basis`, which are orthonormal and which the matrix does not leave.
    pub(super) fn along(matrix: &SMatrix<f64, N, N>, basis: &DMatrix<f64>) -> Result<Self, StabilityError> {
        let lifted = basis.map(Complex::from);
        let modes = modes(&(basis.transpose() * (matrix * basis)))?;
        let modes = modes
            .into_iter()
            .map(|mode| mode.placed(|shape| &lifted * shape))
            .collect();
        Ok(Self { modes })
    }

    /// The modes, by falling real part of their eigenvalues; of a complex pair, that with the positive imaginary part comes first.
    #[must_use]
    pub fn modes(&self) -> &[Eigenmode<N>] {
        &self.modes
    }

    /// The eigenvalues in the order of the modes.
    pub fn eigenvalues(&self) -> impl ExactSizeIterator<Item = Complex<f64>> {
        self.modes.iter().map(|mode| mode.eigenvalue)
    }
}

impl<const N: usize> Eigenmode<N> {
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

/// An eigenvalue with its eigenvector, whose length is any.
#[derive(Clone, Debug)]
struct Pair {
    eigenvalue: Complex<f64>,
    shape: DVector<Complex<f64>>,
    condition: f64,
    uncertainty: f64,
}

impl Pair {
    /// The mode whose shape is that of the pair at another place.
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

/// The modes in their order.
fn modes(matrix: &DMatrix<f64>) -> Result<Vec<Pair>, StabilityError> {
    if matrix.iter().any(|entry| !entry.is_finite()) {
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
    // An entry below the diagonal is zero beside its neighbours when it is an ulp of them. Rounding may hold it at some
    // more, for ever.
    let within = |ulps: f64| Schur::try_new(balanced.clone(), ulps * f64::EPSILON, iterations);
    match within(1.0).or_else(|| within(4.0)) {
        Some(schur) => Ok(schur.complex_eigenvalues().iter().copied().collect()),
        None => Err(StabilityError::NoConvergence {
            iterations,
            residual: f64::NAN,
        }),
    }
}

/// The mode of an eigenvalue, beside those that are known.
fn pair(matrix: &DMatrix<f64>, eigenvalue: Complex<f64>, known: &[Pair]) -> Pair {
    // More than the rounding errors of all steps of the algorithm.
    let noise = 8.0 * f64::EPSILON * matrix.norm();
    // Eigenvalues no further apart are equal.
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
    // Rounding makes pairs of equal real eigenvalues, too: of their vectors each pair of orthogonal real ones gives a
    // vector and its conjugate that are independent. Those of a slow oscillation are such a pair.
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
    // One over the part of the vector that lies in the left null space is the condition number of the eigenvalue.
    let product = left
        .iter()
        .map(|left| left.dotc(&vector).norm_sqr())
        .sum::<f64>()
        .sqrt();
    Pair {
        eigenvalue,
        shape: vector,
        condition: 1.0 / product,
        // A double eigenvalue moves by the root of the errors.
        uncertainty: (noise / product).min((noise * matrix.norm()).sqrt()),
    }
}

/// The first direction in the null space of which the vectors that are known leave something, orthogonal to them.
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

/// The real part of a vector or its imaginary part, whichever is longer, at length 1.
fn real(vector: &DVector<Complex<f64>>) -> DVector<Complex<f64>> {
    let parts = [
        vector.map(|component| component.re),
        vector.map(|component| component.im),
    ];
    let [re, im] = parts;
    let longer = if re.norm() < im.norm() { im } else { re };
    longer.normalize().map(Complex::from)
}

/// An orthonormal basis of the vectors whose adjoints a matrix takes from the left to zero, or to no more than `least`;
/// at least the one that it takes nearest to it.
///
/// By a factorisation `Q R` with pivots (Golub and Van Loan, 5.4.2): the rows of `R` that are zero leave these columns
/// of `Q`. The left singular vectors of nalgebra are good to some per cent only where singular values are equal.
fn kernel(matrix: DMatrix<Complex<f64>>, least: f64) -> Vec<DVector<Complex<f64>>> {
    let n = matrix.nrows();
    let factors = matrix.col_piv_qr();
    let (q, r) = (factors.q(), factors.r());
    let least = least.max(r[(n - 1, n - 1)].norm());
    let null = (0..n).rev().take_while(|&k| r[(k, k)].norm() <= least);
    null.map(|k| q.column(k).into_owned()).collect()
}
