//! One accepted step, and the states within it.

use nalgebra::SVector;

use crate::real::Float;

/// An accepted step from `(t0, x0)` to `(t1, x1)`.
#[derive(Clone, Copy, Debug)]
pub struct Step<'a, const N: usize, T = f64> {
    /// The time at which the step starts.
    pub t0: T,
    /// The time at which it ends.
    pub t1: T,
    /// Its length `t1 - t0`; negative when going backward in time.
    pub h: T,
    /// The state at its start.
    pub x0: SVector<T, N>,
    /// The state at its end.
    pub x1: SVector<T, N>,
    pub(crate) stages: &'a [SVector<T, N>],
    /// The polynomials of the dense output, row by row, each as long as `stages`.
    pub(crate) weights: &'static [f64],
}

impl<const N: usize, T: Float> Step<'_, N, T> {
    /// The derivative of the state at the start of the step.
    #[must_use]
    pub fn slope0(&self) -> SVector<T, N> {
        self.stages[0]
    }

    /// The derivative of the state at the end of the step.
    #[must_use]
    pub fn slope1(&self) -> SVector<T, N> {
        self.stages[self.stages.len() - 1]
    }

    /// The state at the time `t`, by the dense output of the method; a `t` outside of the step extrapolates.
    #[must_use]
    pub fn at(&self, t: T) -> SVector<T, N> {
        if t == self.t1 {
            return self.x1;
        }
        let theta = (t - self.t0) / self.h;
        let mut x = SVector::from_element(T::default());
        for coefficient in self.coefficients().rev() {
            x = (x + coefficient) * theta;
        }
        x + self.x0
    }

    /// The vectors `c_1, c_2, ..` of the dense output `x0 + c_1 theta + c_2 theta^2 + ..`, `theta` the fraction of the step.
    pub(crate) fn coefficients(&self) -> impl DoubleEndedIterator<Item = SVector<T, N>> {
        self.weights.chunks_exact(self.stages.len()).map(|row| {
            let mut sum = SVector::from_element(T::default());
            for (&weight, stage) in row.iter().zip(self.stages) {
                sum += stage * T::from_f64(weight);
            }
            sum * self.h
        })
    }
}
