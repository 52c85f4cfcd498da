//! Fit of a trajectory by the modes of its linearisation.

use nalgebra::{DMatrix, DVector, SMatrix, SVector};
use pendulum_core::stability::{Complex, Eigenmode, Spectrum, StabilityError};

/// Times, each with the state.
pub type Samples = [(f64, SVector<f64, 4>)];

/// Angles as `sum of Re(amplitude shape exp(eigenvalue t))`.
#[derive(Clone, Debug)]
pub struct ModalFit {
    /// Modes, one of each complex pair, by increasing frequency.
    pub modes: Vec<Eigenmode<4>>,
    /// Amplitude of each mode.
    pub amplitudes: Vec<Complex<f64>>,
}

/// Fits the amplitudes to the angles by least squares, with the eigenvalues and shapes of `spectrum`.
pub fn fit(spectrum: &Spectrum<4>, samples: &Samples) -> ModalFit {
    let modes = swinging(spectrum);
    // The real part of `amplitude z` is linear in the two parts of the amplitude.
    let entry = |row: usize, column: usize| {
        let (t, angle) = (samples[row / 2].0, row % 2);
        let mode = &modes[column / 2];
        let z = mode.shape[angle] * (mode.eigenvalue * t).exp();
        if column.is_multiple_of(2) { z.re } else { -z.im }
    };
    let matrix = DMatrix::from_fn(2 * samples.len(), 2 * modes.len(), entry);
    let angles = DVector::from_fn(2 * samples.len(), |row, _| samples[row / 2].1[row % 2]);
    let parts = matrix
        .svd(true, true)
        .solve(&angles, 0.0)
        .expect("both sides were asked for");
    let amplitudes = parts.as_slice().chunks(2).map(|part| Complex::new(part[0], part[1]));
    ModalFit {
        amplitudes: amplitudes.collect(),
        modes,
    }
}

impl ModalFit {
    /// Contribution of mode `n` to the angles at the time `t`.
    pub fn angles(&self, n: usize, t: f64) -> [f64; 2] {
        let mode = &self.modes[n];
        let z = self.amplitudes[n] * (mode.eigenvalue * t).exp();
        [0, 1].map(|angle| (mode.shape[angle] * z).re)
    }

    /// Residual of the angles at a sample.
    pub fn rest(&self, (t, x): &(f64, SVector<f64, 4>)) -> [f64; 2] {
        let modes = (0..self.modes.len()).map(|n| self.angles(n, *t));
        modes.fold([x[0], x[1]], |[a, b], [first, second]| [a - first, b - second])
    }

    /// Largest residual of all samples.
    pub fn residual(&self, samples: &Samples) -> f64 {
        let rests = samples.iter().flat_map(|sample| self.rest(sample));
        rests.fold(0.0, |most, rest| most.max(rest.abs()))
    }
}

/// Eigenvalues of the motion itself, from evenly spaced samples: of the matrix that best maps each state to the next
/// (P. J. Schmid, "Dynamic mode decomposition of numerical and experimental data", Journal of Fluid Mechanics 656
/// (2010) 5-28).
///
/// # Errors
/// The errors of [`Spectrum::of`].
pub fn eigenvalues_of(samples: &Samples) -> Result<Vec<Complex<f64>>, StabilityError> {
    let spacing = samples[1].0 - samples[0].0;
    let mut squares = SMatrix::<f64, 4, 4>::zeros();
    let mut products = SMatrix::<f64, 4, 4>::zeros();
    for pair in samples.windows(2) {
        let (x, next) = (pair[0].1, pair[1].1);
        squares += x * x.transpose();
        products += next * x.transpose();
    }
    let transition = squares
        .lu()
        .solve(&products.transpose())
        .ok_or(StabilityError::NotFinite)?;
    let modes = swinging(&Spectrum::of(&transition.transpose())?);
    Ok(modes.iter().map(|mode| mode.eigenvalue.ln() / spacing).collect())
}

/// One mode of each complex pair, by increasing frequency.
fn swinging(spectrum: &Spectrum<4>) -> Vec<Eigenmode<4>> {
    let modes = spectrum.modes().iter().copied();
    let mut modes: Vec<_> = modes.filter(|mode| mode.eigenvalue.im > 0.0).collect();
    modes.sort_by(|a, b| {
        a.eigenvalue
            .arg()
            .total_cmp(&b.eigenvalue.arg())
            .then(a.eigenvalue.im.total_cmp(&b.eigenvalue.im))
    });
    modes
}
