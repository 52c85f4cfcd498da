//! Periodic orbits and their stability.

use nalgebra::{Complex, SMatrix, SVector};

use super::{Eigenmode, Spectrum, Stability, StabilityError};

/// A periodic orbit with its monodromy matrix, which maps perturbations at the start to perturbations after one period
/// (Floquet theory).
///
/// G. Floquet, Annales scientifiques de l'Ecole Normale Superieure 12 (1883) 47; P. Hartman, "Ordinary Differential
/// Equations", 2nd ed. (2002), IV.6.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicOrbit<const N: usize> {
    /// State at the time 0.
    pub x: SVector<f64, N>,
    /// Period, in s.
    pub period: f64,
    /// Full turns of each component in a period; nonzero only for angles of motions that turn over.
    pub turns: [i32; N],
    /// Derivative of the state after a period with respect to the state before.
    pub monodromy: SMatrix<f64, N, N>,
    /// Eigenvalues (the Floquet multipliers) and eigenvectors of the monodromy matrix, in descending order of the real
    /// part.
    pub multipliers: Spectrum<N>,
    nontrivial: Vec<Multiplier>,
    noise: f64,
}

/// A Floquet multiplier: the growth factor of a perturbation of a periodic orbit in one period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multiplier {
    /// Value of the multiplier.
    pub value: Complex<f64>,
    /// Bound on the change of the multiplier by integration errors.
    pub uncertainty: f64,
}

impl Multiplier {
    /// Distance outside of the unit circle; negative inside.
    #[must_use]
    pub fn excess(&self) -> f64 {
        self.value.norm() - 1.0
    }
}

impl<const N: usize> PeriodicOrbit<N> {
    /// Orbit through `x`. If its phase is free, `along` is the direction of the motion.
    pub(super) fn new(
        (x, period, turns): (SVector<f64, N>, f64, [i32; N]),
        monodromy: SMatrix<f64, N, N>,
        along: Option<SVector<f64, N>>,
        tolerance: f64,
    ) -> Result<Self, StabilityError> {
        let multipliers = Spectrum::of(&monodromy)?;
        let mut nontrivial = match along {
            None => weigh(&multipliers, &monodromy, tolerance),
            Some(along) => {
                // Monodromy matrix projected across the orbit. The multiplier 1 along the orbit becomes 0, and no other
                // changes. A double multiplier 1 becomes a simple one, which is insensitive to errors.
                let across = SMatrix::identity() - along * along.transpose() / along.norm_squared();
                let across = across * monodromy;
                weigh(&Spectrum::of(&across)?, &monodromy, tolerance)
            }
        };
        // Conjugate pairs stay adjacent: their moduli are equal, and the sort is stable.
        nontrivial.sort_by(|a, b| b.value.norm().total_cmp(&a.value.norm()));
        if along.is_some() {
            nontrivial.pop();
        }
        Ok(Self {
            x,
            period,
            turns,
            monodromy,
            multipliers,
            nontrivial,
            noise: NOISE * tolerance * monodromy.norm(),
        })
    }

    /// Magnitude below which multipliers are noise of the integration. Perturbations with such multipliers decay within
    /// a period, and no more is known about them. A smaller tolerance resolves smaller multipliers, down to rounding
    /// errors of the largest.
    #[must_use]
    pub fn noise(&self) -> f64 {
        self.noise
    }

    /// Multipliers that determine stability, in descending order of modulus: all of them for a driven system, `N - 1`
    /// for an autonomous one. The latter excludes the multiplier 1 along the orbit, which belongs to a shift in time.
    #[must_use]
    pub fn nontrivial(&self) -> &[Multiplier] {
        &self.nontrivial
    }

    /// Stability according to the nontrivial multipliers, within integration errors: of the orbit together with all its
    /// shifts in time. Orbits of conservative systems form families with a further multiplier 1, and are unstable or
    /// undecided.
    #[must_use]
    pub fn stability(&self) -> Stability {
        let multipliers = self.nontrivial.iter();
        Stability::of(multipliers.map(|multiplier| (multiplier.excess(), multiplier.uncertainty)))
    }
}

/// Eigenvalues of a monodromy matrix, or of a projection of it, with error bounds for the tolerance of the integration.
fn weigh<const N: usize>(spectrum: &Spectrum<N>, monodromy: &SMatrix<f64, N, N>, tolerance: f64) -> Vec<Multiplier> {
    let noise = NOISE * tolerance * monodromy.norm();
    let weigh = |mode: &Eigenmode<N>| Multiplier {
        value: mode.eigenvalue,
        // Proportional to the condition number; a double multiplier changes by the square root of the error.
        uncertainty: (noise * mode.condition).min((noise * monodromy.norm()).sqrt()),
    };
    spectrum.modes().iter().map(weigh).collect()
}

/// Bound on the error of a period in units of the tolerance, since the errors of single steps add up.
pub(super) const NOISE: f64 = 100.0;
