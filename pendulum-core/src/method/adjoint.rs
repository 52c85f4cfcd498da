//! Discrete adjoints of explicit Runge-Kutta methods.

use nalgebra::SVector;

use crate::dual::{Dual, variables};
use crate::method::stages::shifted_by_sum;
use crate::method::{Adaptive, Explicit, Fixed};
use crate::real::Float;
use crate::sensitivity::Cost;
use crate::system::{Adjoint, System};
use crate::tableau::Tableau;

/// A method with a discrete adjoint: the transposed derivative of its steps.
pub trait DiscreteAdjoint {
    /// Kind of method.
    type Family: AdjointStep;

    /// The kind of method, with its settings.
    fn family(&self) -> &Self::Family;
}

/// A kind of method whose steps have a transposed derivative.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no discrete adjoint",
    note = "explicit Runge-Kutta methods have one: `Rk4`, `Rk45`, `Tsit5`, `Vern7`, `Vern9`",
    note = "`sensitivity::solve` computes derivatives forward, with every method"
)]
pub trait AdjointStep {
    /// Repeats the step `(t, h)`, of length `h` from the state `x` at `t`, and returns the state at its end.
    fn repeated<S, T, const N: usize>(&self, system: &S, step: (T, T), x: &SVector<T, N>) -> SVector<T, N>
    where
        S: System<T, N>,
        T: Float;

    /// Takes derivatives of a cost backward through the step `(t, h)`, of length `h` from the state `x` at `t`.
    ///
    /// The first of `derivatives` are those with respect to the state: at the end of the step before the call, at its
    /// start after it. To the second, those with respect to the parameters, the share of the step is added. Returns the
    /// integral of the running cost over the step.
    fn backward<M, C, T, const N: usize, const P: usize>(
        &self,
        model: (&M, &C),
        step: (T, T),
        x: &SVector<T, N>,
        derivatives: (&mut SVector<T, N>, &mut SVector<T, P>),
    ) -> T
    where
        M: Adjoint<T, N, P>,
        C: Cost<N>,
        T: Float;
}

/// States at the stages of a step, and at its end before the projection. The last stage belongs to the next step.
#[inline]
fn stages<B, S, T, const STAGES: usize, const N: usize>(
    system: &S,
    (t, h): (T, T),
    x: &SVector<T, N>,
) -> ([SVector<T, N>; STAGES], SVector<T, N>)
where
    B: Tableau<STAGES>,
    S: System<T, N>,
    T: Float,
{
    let tableau = const { &B::TABLEAU };
    let zero = SVector::from([T::default(); N]);
    let [mut states, mut rates] = [[zero; STAGES]; 2];
    for i in 0..STAGES - 1 {
        states[i] = shifted_by_sum((x, h), (&tableau.a[i], i), &rates);
        rates[i] = system.rhs(t + h * T::from_f64(tableau.c[i]), &states[i]);
    }
    let end = shifted_by_sum((x, h), (&tableau.b, STAGES - 1), &rates);
    (states, end)
}

impl<B: Tableau<STAGES>, const STAGES: usize> AdjointStep for Explicit<B, STAGES> {
    fn repeated<S, T, const N: usize>(&self, system: &S, (t, h): (T, T), x: &SVector<T, N>) -> SVector<T, N>
    where
        S: System<T, N>,
        T: Float,
    {
        let (_, mut end) = stages::<B, S, T, STAGES, N>(system, (t, h), x);
        system.project(t + h, &mut end);
        end
    }

    /// With the stages `X_i = x + h sum_j a_ij f(X_j)` of `x + h sum_i b_i f(X_i)`, and derivatives `w` at the end,
    /// those with respect to the stages are `v_i = J_i^T h (b_i w + sum_j a_ji v_j)`, from the last one to the first,
    /// and those at the start `w + sum_i v_i` (W. W. Hager, Numer. Math. 87 (2000) 247).
    fn backward<M, C, T, const N: usize, const P: usize>(
        &self,
        (model, cost): (&M, &C),
        (t, h): (T, T),
        x: &SVector<T, N>,
        (weights, by_parameters): (&mut SVector<T, N>, &mut SVector<T, P>),
    ) -> T
    where
        M: Adjoint<T, N, P>,
        C: Cost<N>,
        T: Float,
    {
        let tableau = const { &B::TABLEAU };
        let (states, end) = stages::<B, M, T, STAGES, N>(model, (t, h), x);
        model.project_adjoint(t + h, &end, weights);
        let zero = SVector::from([T::default(); N]);
        let (mut by_stages, mut by_start, mut integral) = ([zero; STAGES], *weights, T::default());
        for i in (0..STAGES - 1).rev() {
            let time = t + h * T::from_f64(tableau.c[i]);
            let weight = h * T::from_f64(tableau.b[i]);
            let mut by_rate = weights.map(|by_end| weight * by_end);
            for (a, by_stage) in tableau.a[..STAGES - 1].iter().zip(&by_stages).skip(i + 1) {
                if a[i] != 0.0 {
                    let factor = h * T::from_f64(a[i]);
                    by_rate.zip_apply(by_stage, |sum, by_stage| *sum += factor * by_stage);
                }
            }
            let (mut by_state, own) = model.adjoint(time, &states[i], &by_rate);
            by_parameters.zip_apply(&own, |sum, own| *sum += own);
            if let Some(running) = cost.running(Dual::constant(time), &variables(&states[i])) {
                integral += weight * running.value;
                for (by_state, slope) in by_state.iter_mut().zip(running.slopes) {
                    *by_state += weight * slope;
                }
            }
            by_start.zip_apply(&by_state, |sum, by_state| *sum += by_state);
            by_stages[i] = by_state;
        }
        *weights = by_start;
        integral
    }
}

impl<F: AdjointStep> DiscreteAdjoint for Fixed<F> {
    type Family = F;

    fn family(&self) -> &F {
        &self.family
    }
}

impl<F: AdjointStep> DiscreteAdjoint for Adaptive<F> {
    type Family = F;

    fn family(&self) -> &F {
        &self.family
    }
}
