//! The matrix of the iterations of a Radau method.

use nalgebra::{SMatrix, SVector};

use super::RadauIIA;
use crate::linear::Singular;
use crate::method::collocation::Pencil;
use crate::method::scheme::Stalled;
use crate::real::Float;
use crate::statistics::Statistics;
use crate::system::Jacobian;
use crate::tableau::HasRadauTableau;

/// Relative difference in length up to which steps share a factored matrix. It bounds the rate of convergence.
const SAME_LENGTH: f64 = 1e-6;

/// Matrix of the iterations, as long as it serves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Matrix<T, const STAGES: usize, const PAIRS: usize, const N: usize> {
    /// Derivative of the right-hand side by the state.
    pub(super) jacobian: SMatrix<T, N, N>,
    /// True if the Jacobian was evaluated at the start of the next step, false if earlier.
    pub(super) is_current: bool,
    /// Matrix with this Jacobian, and the length of the steps it was factored for.
    pub(super) factored: Option<(T, Pencil<T, STAGES, PAIRS, N>)>,
}

impl<T: Float, const STAGES: usize, const PAIRS: usize, const N: usize> Matrix<T, STAGES, PAIRS, N>
where
    RadauIIA<STAGES, PAIRS>: HasRadauTableau<STAGES, PAIRS>,
{
    /// Evaluates the derivative, which is returned, and a new Jacobian.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn renew<S>(&mut self, system: &S, t: T, x: &SVector<T, N>, work: &mut Statistics) -> SVector<T, N>
    where
        S: Jacobian<T, N> + ?Sized,
    {
        work.evaluations += 1;
        work.jacobians += 1;
        let (slope, jacobian) = system.rhs_and_jacobian(t, x);
        self.set(jacobian);
        slope
    }

    /// Continues with the Jacobian at the start of the next step.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn set(&mut self, jacobian: SMatrix<T, N, N>) {
        (self.jacobian, self.is_current, self.factored) = (jacobian, true, None);
    }

    /// Factors the matrix for a step of length `h`, unless it has been for the same length.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn factor(
        &mut self,
        h: T,
        active: usize,
        work: &mut Statistics,
    ) -> Result<&Pencil<T, STAGES, PAIRS, N>, Stalled> {
        let is_kept = match &self.factored {
            Some((length, _)) => (h - *length).abs() <= T::from_f64(SAME_LENGTH) * h.abs(),
            None => false,
        };
        if !is_kept {
            let identity = SMatrix::from_fn(|i, j| T::from_f64(if i == j { 1.0 } else { 0.0 }));
            let modes = const { &RadauIIA::<STAGES, PAIRS>::TABLEAU.modes };
            let pencil = Pencil::new(modes, h, [&identity, &self.jacobian], active).map_err(|Singular| Stalled)?;
            work.factorizations += pencil.factorizations();
            self.factored = Some((h, pencil));
        }
        match &self.factored {
            Some((_, pencil)) => Ok(pencil),
            None => Err(Stalled),
        }
    }
}
