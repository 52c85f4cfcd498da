//! Change of units. A correct formula is invariant: its value in new units is its value in the old ones, converted.

use nalgebra::{SMatrix, SVector};

use testbed::printed::Pendulum;

/// Number of the new units per kilogram, metre and second.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Units {
    pub(crate) mass: f64,
    pub(crate) length: f64,
    pub(crate) time: f64,
}

/// Grams, centimetres, and 0.7 s: a round number could hide a power.
pub(crate) const OTHER: Units = Units {
    mass: 1e3,
    length: 1e2,
    time: 1.0 / 0.7,
};

impl Units {
    /// Converts a pendulum, with friction in N m s (per rad).
    pub(crate) fn pendulum(&self, p: &Pendulum) -> Pendulum {
        let friction = self.mass * self.length.powi(2) / self.time;
        Pendulum {
            gamma1: p.gamma1 * friction,
            gamma2: p.gamma2 * friction,
            ..self.pendulum_without_unit_of_friction(p)
        }
    }

    /// Converts a pendulum as if friction had no unit.
    pub(crate) fn pendulum_without_unit_of_friction(&self, p: &Pendulum) -> Pendulum {
        Pendulum {
            m: p.m * self.mass,
            inertia: p.inertia * self.mass * self.length.powi(2),
            d: p.d * self.length,
            g: p.g * self.length / self.time.powi(2),
            ..*p
        }
    }

    /// Converts a state.
    pub(crate) fn state(&self, x: &SVector<f64, 4>) -> SVector<f64, 4> {
        SVector::from([x[0], x[1], x[2] / self.time, x[3] / self.time])
    }

    /// Converts the derivative of a state.
    pub(crate) fn rate(&self, rate: &SVector<f64, 4>) -> SVector<f64, 4> {
        self.state(rate) / self.time
    }

    /// Converts the matrix of `dx/dt = matrix x`.
    pub(crate) fn matrix(&self, matrix: &SMatrix<f64, 4, 4>) -> SMatrix<f64, 4, 4> {
        let unit = |i: usize| if i < 2 { 1.0 } else { 1.0 / self.time };
        SMatrix::from_fn(|i, j| matrix[(i, j)] * unit(i) / unit(j) / self.time)
    }
}

/// Largest difference, relative to the largest entry.
pub(crate) fn apart<const R: usize, const C: usize>(a: &SMatrix<f64, R, C>, b: &SMatrix<f64, R, C>) -> f64 {
    (a - b).amax() / b.amax()
}
