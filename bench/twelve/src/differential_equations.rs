//! The crate `differential-equations`.

use differential_equations::control::ControlFlag;
use differential_equations::interpolate::Interpolation;
use differential_equations::linalg::Matrix;
use differential_equations::methods::{
    BackwardDifferentiationFormula, DiagonallyImplicitRungeKutta, ExplicitRungeKutta, ImplicitRungeKutta,
};
use differential_equations::ode::{ODE, OrdinaryNumericalMethod, solve_ode};
use differential_equations::solout::Solout;
use differential_equations::solution::Solution;
use nalgebra::SVector;
use pendulum_core::Jacobian;

use crate::entrant::{Entrant, Reached, Task, due};

struct Slopes<S: 'static, const N: usize>(Task<S, N>);

impl<S: Jacobian<f64, N>, const N: usize> ODE<f64, [f64; N]> for Slopes<S, N> {
    fn diff(&self, t: f64, x: &[f64; N], slope: &mut [f64; N]) {
        *slope = self.0.model.rhs(t, &SVector::from(*x)).data.0[0];
    }

    fn jacobian(&self, t: f64, x: &[f64; N], jacobian: &mut Matrix<f64>) {
        let entries = self.0.model.jacobian(t, &SVector::from(*x));
        for row in 0..N {
            for column in 0..N {
                jacobian[(row, column)] = entries[(row, column)];
            }
        }
    }
}

/// States at output times. Without them it stores nothing.
struct Outputs<'a, const N: usize> {
    times: &'a [f64],
    along: Vec<[f64; N]>,
}

impl<const N: usize> Solout<f64, [f64; N]> for Outputs<'_, N> {
    fn solout<I>(
        &mut self,
        t: f64,
        _: f64,
        _: &[f64; N],
        _: &[f64; N],
        step: &mut I,
        _: &mut Solution<f64, [f64; N]>,
    ) -> ControlFlag<f64, [f64; N]>
    where
        I: Interpolation<f64, [f64; N]> + ?Sized,
    {
        while let Some(output) = due(self.times, &self.along, t) {
            self.along.push(step.interpolate(output).unwrap_or([f64::NAN; N]));
        }
        ControlFlag::Continue
    }
}

/// Maximum number of steps, more than any useful setting needs.
const STEPS: usize = 1_000_000;

macro_rules! entrants {
    ($task:ident; $($name:literal: $family:ident::$method:ident,)*) => {
        vec![$(Entrant::new("differential-equations", $name, $task.t1, move |tolerance, outputs| {
            let absolute = $task.absolute * tolerance;
            let mut method = $family::$method().rtol(tolerance).atol(absolute).max_steps(STEPS);
            let start = $task.x0.data.0[0];
            let mut outputs = Outputs { times: outputs, along: Vec::new() };
            let solution = solve_ode(&mut method, &Slopes($task), 0.0, $task.t1, &start, &mut outputs);
            let solution = solution.map_err(|error| format!("{error:?}"))?;
            let calls = solution.evals;
            Ok(Reached {
                t: method.t(),
                x: *method.y(),
                evaluations: Some(calls.function),
                operations: Some($task.flops.of(calls.function, calls.jacobian)),
                along: outputs.along,
            })
        }),)*]
    };
}

pub(crate) fn smooth<S: Jacobian<f64, N>, const N: usize>(task: Task<S, N>) -> Vec<Entrant> {
    entrants! { task;
        "DOP853": ExplicitRungeKutta::dop853,
        "RKV877e": ExplicitRungeKutta::rkv877e,
        "RKV988e": ExplicitRungeKutta::rkv988e,
    }
}

pub(crate) fn stiff<S: Jacobian<f64, N>, const N: usize>(task: Task<S, N>) -> Vec<Entrant> {
    entrants! { task;
        "Kvaerno 7(4)5": DiagonallyImplicitRungeKutta::kvaerno745,
        "Radau5": ImplicitRungeKutta::radau5,
        "BDF": BackwardDifferentiationFormula::adaptive,
    }
}
