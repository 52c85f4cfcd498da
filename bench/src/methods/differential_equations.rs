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
use pendulum_core::{Jacobian, System};

use super::entrant::{End, Entrant, Scenes};
use super::pendulum::DoublePendulum;
use super::scene::Scene;

struct Model<'a>(&'a DoublePendulum);

impl ODE<f64, [f64; 4]> for Model<'_> {
    fn diff(&self, t: f64, x: &[f64; 4], slope: &mut [f64; 4]) {
        *slope = self.0.rhs(t, &SVector::from(*x)).data.0[0];
    }

    fn jacobian(&self, t: f64, x: &[f64; 4], jacobian: &mut Matrix<f64>) {
        let entries = self.0.jacobian(t, &SVector::from(*x));
        for row in 0..4 {
            for column in 0..4 {
                jacobian[(row, column)] = entries[(row, column)];
            }
        }
    }
}

/// Output that stores no intermediate points.
struct Nothing;

impl Solout<f64, [f64; 4]> for Nothing {
    fn solout<I>(
        &mut self,
        _: f64,
        _: f64,
        _: &[f64; 4],
        _: &[f64; 4],
        _: &mut I,
        _: &mut Solution<f64, [f64; 4]>,
    ) -> ControlFlag<f64, [f64; 4]>
    where
        I: Interpolation<f64, [f64; 4]> + ?Sized,
    {
        ControlFlag::Continue
    }
}

/// Maximum number of steps, more than any method needs.
const STEPS: usize = 1_000_000;

macro_rules! once {
    ($family:ident::$method:ident) => {
        |scene: &Scene, tolerance: f64| {
            let mut method = $family::$method().rtol(tolerance).atol(tolerance).max_steps(STEPS);
            let model = Model(&scene.model);
            let solution = solve_ode(&mut method, &model, 0.0, scene.t1, &scene.x0, &mut Nothing);
            let solution = solution.map_err(|error| format!("{error:?}"))?;
            Ok(End {
                t: method.t(),
                x: *method.y(),
                evaluations: Some(solution.evals.function),
            })
        }
    };
}

pub(crate) fn entrants() -> Vec<Entrant> {
    use Scenes::{Smooth, Stiff};
    let by = "differential-equations";
    vec![
        Entrant::new(by, "DOPRI5", Smooth, once!(ExplicitRungeKutta::dopri5)),
        Entrant::new(by, "DOP853", Smooth, once!(ExplicitRungeKutta::dop853)),
        Entrant::new(by, "RKV655e", Smooth, once!(ExplicitRungeKutta::rkv655e)),
        Entrant::new(by, "RKV766e", Smooth, once!(ExplicitRungeKutta::rkv766e)),
        Entrant::new(by, "RKV877e", Smooth, once!(ExplicitRungeKutta::rkv877e)),
        Entrant::new(by, "RKV988e", Smooth, once!(ExplicitRungeKutta::rkv988e)),
        Entrant::new(
            by,
            "Kvaerno 4(3)",
            Stiff,
            once!(DiagonallyImplicitRungeKutta::kvaerno423),
        ),
        Entrant::new(
            by,
            "Kvaerno 7(4)5",
            Stiff,
            once!(DiagonallyImplicitRungeKutta::kvaerno745),
        ),
        Entrant::new(by, "Radau5", Stiff, once!(ImplicitRungeKutta::radau5)),
        Entrant::new(by, "BDF", Stiff, once!(BackwardDifferentiationFormula::adaptive)),
    ]
}
