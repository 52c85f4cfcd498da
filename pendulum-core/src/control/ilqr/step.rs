//! One step of the motion, by the explicit midpoint rule where a model has no other, and its derivatives.

use core::convert::Infallible;
use core::fmt;

use nalgebra::{SMatrix, SVector};

use super::IlqrError;
use super::matrix::{plus_product, scaled};
use crate::error::{Name, Reason};
use crate::hybrid::MAX_CONSTRAINTS;
use crate::inputs::Controlled;
use crate::real::Float;
use crate::system::ActsWith;

/// A model whose motion [`Ilqr`](super::Ilqr) plans, as a map from the state at the start of a step to that at its end,
/// under inputs that are held over it.
///
/// Every [`Controlled`] model without mode switches is one, by a step of the explicit midpoint rule.
/// [`Integrated`](super::Integrated) is one by a method of integration.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model with {N} state components and {M} inputs whose motion can be planned",
    note = "`mechanism!` implements `Controlled` for scenes with inputs where `generate` has `rhs`"
)]
pub trait StepMap<T: Float, const N: usize, const M: usize> {
    /// True if steps go through mode switches, so that the cost of a motion has kinks. Default: false.
    const HAS_KINKS: bool = false;

    /// Reason why a step fails; [`Infallible`] if none does.
    type Error: fmt::Debug + Into<Reason>;

    /// State at the end of a step of length `h` from the state `x` at `t`.
    ///
    /// # Errors
    /// If the step cannot be integrated.
    fn step(&self, t: T, h: T, x: &SVector<T, N>, u: &[T; M]) -> Result<SVector<T, N>, Self::Error>;

    /// Derivatives of [`step`](Self::step).
    ///
    /// # Errors
    /// If the step cannot be integrated, or has no derivatives.
    fn step_derivatives(
        &self,
        t: T,
        h: T,
        x: &SVector<T, N>,
        u: &[T; M],
    ) -> Result<StepDerivatives<T, N, M>, Self::Error>;

    /// Checks before a search if steps can be taken, from the state `x` at `t` on. By default, nothing is wrong.
    ///
    /// # Errors
    /// Those of the model: [`IlqrError::ModeSwitches`] and the like.
    fn check(&self, _t: T, _x: &SVector<T, N>) -> Result<(), IlqrError> {
        Ok(())
    }
}

/// Derivatives of the state at the end of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepDerivatives<T, const N: usize, const M: usize> {
    /// With respect to the state at its start: one column per component.
    pub a: SMatrix<T, N, N>,
    /// With respect to the inputs: one column per input.
    pub b: SMatrix<T, N, M>,
}

impl<S, T, const N: usize, const M: usize> StepMap<T, N, M> for S
where
    S: Controlled<T, N, M>,
    T: Float,
{
    type Error = Infallible;

    #[inline(always)]
    fn step(&self, t: T, h: T, x: &SVector<T, N>, u: &[T; M]) -> Result<SVector<T, N>, Self::Error> {
        let given = S::Given::with(S::Inputs::from(*u), &[T::default(); MAX_CONSTRAINTS]);
        let half = T::from_f64(0.5) * h;
        let middle = advanced(x, half, &self.eval(t, x, &given));
        let mut end = advanced(x, h, &self.eval(t + half, &middle, &given));
        self.project(t + h, &mut end);
        Ok(end)
    }

    /// By the chain rule through both evaluations and the normalisation of quaternions.
    #[inline(always)]
    fn step_derivatives(
        &self,
        t: T,
        h: T,
        x: &SVector<T, N>,
        u: &[T; M],
    ) -> Result<StepDerivatives<T, N, M>, Self::Error> {
        let inputs = S::Inputs::from(*u);
        let given = S::Given::with(inputs, &[T::default(); MAX_CONSTRAINTS]);
        let half = T::from_f64(0.5) * h;
        let (rate, by_state) = self.eval_with_jacobian(t, x, &given);
        let by_inputs = self.input_jacobian(t, x, &inputs);
        let middle = advanced(x, half, &rate);
        let (middle_rate, middle_by_state) = self.eval_with_jacobian(t + half, &middle, &given);
        let middle_by_inputs = self.input_jacobian(t + half, &middle, &inputs);

        let a = plus_product(middle_by_state, &middle_by_state, &scaled(half, &by_state));
        let b = plus_product(middle_by_inputs, &middle_by_state, &scaled(half, &by_inputs));
        let (mut a, mut b) = (scaled(h, &a), scaled(h, &b));
        for n in 0..N {
            a.data.0[n][n] += T::from_f64(1.0);
        }
        if let Some(layout) = self.layout() {
            for places in layout.quaternions() {
                let end = advanced(x, h, &middle_rate);
                normalise(&mut a, &end, places.start);
                normalise(&mut b, &end, places.start);
            }
        }
        Ok(StepDerivatives { a, b })
    }

    fn check(&self, t: T, x: &SVector<T, N>) -> Result<(), IlqrError> {
        if let Some(constraint) = self.constraints().first() {
            let constraint = Name::from(constraint.name);
            return Err(IlqrError::ModeSwitches { constraint });
        }
        check_loops(self, t, x)
    }
}

/// Checks that all loops of a model have closed forms.
pub(super) fn check_loops<S, T, const N: usize, const M: usize>(
    model: &S,
    t: T,
    x: &SVector<T, N>,
) -> Result<(), IlqrError>
where
    S: Controlled<T, N, M>,
    T: Float,
{
    let mut bodies = None;
    model.gaps(t, x, &mut |[a, b], _| bodies = Some([Name::from(a), Name::from(b)]));
    match bodies {
        Some(bodies) => Err(IlqrError::ClosedLoop { bodies }),
        None => Ok(()),
    }
}

/// Derivative of the normalised quaternion at the components from `start`, in place of that of the quaternion.
#[inline(always)]
fn normalise<T: Float, const N: usize, const C: usize>(
    derivative: &mut SMatrix<T, N, C>,
    end: &SVector<T, N>,
    start: usize,
) {
    let mut square = T::default();
    for n in start..start + 4 {
        square += end[n] * end[n];
    }
    let scale = T::from_f64(1.0) / square.sqrt();
    for column in &mut derivative.data.0 {
        let mut along = T::default();
        for n in start..start + 4 {
            along += end[n] * column[n];
        }
        for n in start..start + 4 {
            column[n] = scale * (column[n] - along / square * end[n]);
        }
    }
}

#[inline(always)]
fn advanced<T: Float, const N: usize>(x: &SVector<T, N>, h: T, rate: &SVector<T, N>) -> SVector<T, N> {
    let mut end = *x;
    for n in 0..N {
        end.data.0[0][n] = h.mul_add(rate.data.0[0][n], end.data.0[0][n]);
    }
    end
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};

    use super::{StepDerivatives, StepMap};
    use crate::dual::Dual;
    use crate::inputs::Controlled;
    use crate::layout::{Slot, SlotKind, StateLayout};
    use crate::real::Real;
    use crate::system::{Plant, PlantJacobian};

    /// A body in flight under three torques; the first moment of inertia follows the time.
    struct Top;

    const SLOTS: [Slot<'static>; 1] = [Slot::new("o", SlotKind::Quaternion, 0..4, 4..7)];

    impl<T: Real> Plant<T, 7> for Top {
        type Given = [T; 3];

        fn eval(&self, t: T, x: &SVector<T, 7>, u: &[T; 3]) -> SVector<T, 7> {
            let [w, a, b, c, p, q, r] = (*x).into();
            let [half, i, j, k] = [0.5, 1.0, 2.0, 2.5].map(T::from_f64);
            let i = i + half * t;
            SVector::from([
                -half * (a * p + b * q + c * r),
                half * (w * p + b * r - c * q),
                half * (w * q + c * p - a * r),
                half * (w * r + a * q - b * p),
                (u[0] - (k - j) * q * r) / i,
                (u[1] - (i - k) * r * p) / j,
                (u[2] - (j - i) * p * q) / k,
            ])
        }

        fn dof(&self) -> usize {
            3
        }

        fn orientations(&self) -> &[[usize; 2]] {
            &[[0, 4]]
        }
    }

    impl<T: Real> PlantJacobian<T, 7> for Top {
        fn eval_with_jacobian(&self, t: T, x: &SVector<T, 7>, u: &[T; 3]) -> (SVector<T, 7>, SMatrix<T, 7, 7>) {
            let variables = SVector::<Dual<T, 7>, 7>::from_fn(|n, _| Dual::variable(x[n], n));
            let rates = self.eval(Dual::constant(t), &variables, &u.map(Dual::constant));
            (
                rates.map(|rate| rate.value),
                SMatrix::from_fn(|i, j| rates[i].slopes[j]),
            )
        }
    }

    impl<T: Real> Controlled<T, 7, 3> for Top {
        type Inputs = [T; 3];

        fn input_jacobian(&self, t: T, x: &SVector<T, 7>, u: &[T; 3]) -> SMatrix<T, 7, 3> {
            let mut inputs = u.map(Dual::<T, 3>::constant);
            for m in 0..3 {
                inputs[m] = Dual::variable(u[m], m);
            }
            let rates = self.eval(Dual::constant(t), &x.map(Dual::constant), &inputs);
            SMatrix::from_fn(|i, j| rates[i].slopes[j])
        }

        fn layout(&self) -> Option<StateLayout<'_>> {
            Some(StateLayout::new(&SLOTS))
        }

        fn project(&self, _t: T, x: &mut SVector<T, 7>) {
            let norm = (x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]).sqrt();
            for n in 0..4 {
                x[n] /= norm;
            }
        }
    }

    #[test]
    fn derivatives_of_a_step_are_those_of_dual_numbers() {
        let (t, h, u) = (0.3, 0.2, [1.0, -2.0, 0.5]);
        let x = SVector::from([0.8, 0.0, 0.6, 0.0, 1.0, -2.0, 3.0]);
        let of_x = SVector::<Dual<f64, 10>, 7>::from_fn(|n, _| Dual::variable(x[n], n));
        let of_u = [0, 1, 2].map(|m| Dual::variable(u[m], 7 + m));
        let Ok(end) = Top.step(Dual::constant(t), Dual::constant(h), &of_x, &of_u);
        let Ok(StepDerivatives { a, b }) = Top.step_derivatives(t, h, &x, &u);
        for i in 0..7 {
            for j in 0..7 {
                assert!((a[(i, j)] - end[i].slopes[j]).abs() < 1e-14, "by the state: {i}, {j}");
            }
            for m in 0..3 {
                assert!(
                    (b[(i, m)] - end[i].slopes[7 + m]).abs() < 1e-14,
                    "by the inputs: {i}, {m}"
                );
            }
        }
    }
}
