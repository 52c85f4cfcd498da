//! Periodic orbits, and whether they last.

use nalgebra::{Complex, SMatrix, SVector};

use super::{Eigenmode, Spectrum, Stability, StabilityError};

/// A motion that repeats itself, with what becomes of small motions about it in one period (Floquet): `monodromy` times
/// their start.
///
/// G. Floquet, Annales scientifiques de l'Ecole Normale Superieure 12 (1883) 47; P. Hartman, "Ordinary Differential
/// Equations", 2nd ed. (2002), IV.6.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicOrbit<const N: usize> {
    /// The state at the time 0.
    pub x: SVector<f64, N>,
    /// The period, in s.
    pub period: f64,
    /// The full turns that each component makes in a period: 0 but for angles of motions that turn over.
    pub turns: [i32; N],
    /// The derivative of the state after a period with respect to that before.
    pub monodromy: SMatrix<f64, N, N>,
    /// The eigenvalues of the monodromy matrix, the Floquet multipliers, and its eigenvectors, by falling real part.
    pub multipliers: Spectrum<N>,
    nontrivial: Vec<Multiplier>,
    noise: f64,
}

/// A Floquet multiplier: the factor by which a small motion about a periodic orbit grows in a period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multiplier {
    /// The factor.
    pub value: Complex<f64>,
    /// How far the errors of the integration may have moved it.
    pub uncertainty: f64,
}

impl Multiplier {
    /// How far it lies outside the unit circle; negative inside.
    #[must_use]
    pub fn excess(&self) -> f64 {
        self.value.norm() - 1.0
    }
}

impl<const N: usize> PeriodicOrbit<N> {
    /// The orbit through `x`. `along` is the direction of an orbit whose phase is free.
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
                // What the monodromy matrix does across the orbit. Along it 0 takes the place of the multiplier 1, and no other changes; if 1
                // is a double one, that leaves it a simple one, which errors hardly move.
                let across = SMatrix::identity() - along * along.transpose() / along.norm_squared();
                let across = across * monodromy;
                weigh(&Spectrum::of(&across)?, &monodromy, tolerance)
            }
        };
        // Pairs stay together: their moduli are the same, and the sort is stable.
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

    /// The size below which multipliers are noise: what errors of the integration may make of 0. Motions with such
    /// multipliers have decayed within a period, and nothing more is known about them; a smaller tolerance resolves
    /// smaller ones, down to rounding errors of the largest.
    #[must_use]
    pub fn noise(&self) -> f64 {
        self.noise
    }

    /// The multipliers that tell of stability, by falling modulus: all of them for a driven system, and `N - 1` where
    /// the time does not occur. There the multiplier 1 along the orbit, which belongs to a shift in time, is left out.
    #[must_use]
    pub fn nontrivial(&self) -> &[Multiplier] {
        &self.nontrivial
    }

    /// What the nontrivial multipliers tell, as far as the errors of the integration allow: whether small motions about
    /// the orbit (and about all its shifts in time) decay, grow, or neither. Orbits of conservative systems come in
    /// families, with a further multiplier 1, and are unstable or undecided.
    #[must_use]
    pub fn stability(&self) -> Stability {
        let multipliers = self.nontrivial.iter();
        Stability::of(multipliers.map(|multiplier| (multiplier.excess(), multiplier.uncertainty)))
    }
}

/// The eigenvalues of a monodromy matrix, or of a part of it, with how far the tolerance of the integration may have
/// moved them.
fn weigh<const N: usize>(spectrum: &Spectrum<N>, monodromy: &SMatrix<f64, N, N>, tolerance: f64) -> Vec<Multiplier> {
    let noise = NOISE * tolerance * monodromy.norm();
    let weigh = |mode: &Eigenmode<N>| Multiplier {
        value: mode.eigenvalue,
        // In proportion to what rounding errors do; a double multiplier moves by the root of the errors.
        uncertainty: (noise * mode.condition).min((noise * monodromy.norm()).sqrt()),
    };
    spectrum.modes().iter().map(weigh).collect()
}

/// The errors of a period are so many tolerances at most: those of single steps add up.
pub(super) const NOISE: f64 = 100.0;
