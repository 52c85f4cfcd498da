//! Energy of motions without friction.

use nalgebra::{DMatrix, DVector, SMatrix, SVector};
use pendulum_core::prelude::*;
use pendulum_core::stability::{Complex, StabilityFunction, equilibrium};

use super::row::{Claim, Row, Size};
use super::scenes::{Points, PointsParams};
use crate::scenes::DoublePendulum;
use crate::scenes::double_pendulum;

pub const REGULAR: [f64; 4] = [0.3, 0.4, 0.0, 0.0];
pub const CHAOTIC: [f64; 4] = [2.0, 2.5, 0.0, 0.0];
/// A tenth of `REGULAR`, with the same linear motion.
const SMALL: [f64; 4] = [0.03, 0.04, 0.0, 0.0];

/// Step size, in s.
pub const H: f64 = 0.02;
/// Duration, in s.
pub const TIME: f64 = 500.0;

/// Energy relative to hanging at rest.
fn energy(model: &impl Energy<f64, 4>, x: &SVector<f64, 4>) -> f64 {
    model.energy(0.0, x) - model.energy(0.0, &SVector::zeros())
}

/// Times and relative energy errors at the steps of a method.
pub fn errors<S>(method: &impl Method<S, f64, 4>, model: &S, x0: [f64; 4]) -> Vec<(f64, f64)>
where
    S: System<f64, 4> + Energy<f64, 4>,
{
    let start = energy(model, &x0.into());
    let mut stepper = method.stepper(model, 0.0, TIME, x0).expect("valid");
    let mut errors = Vec::new();
    while let Some(step) = stepper.step().expect("regular") {
        errors.push((step.t1, energy(model, &step.x1) / start - 1.0));
    }
    errors
}

fn largest(errors: &[(f64, f64)]) -> f64 {
    errors.iter().fold(0.0, |largest, (_, error)| error.abs().max(largest))
}

/// Relative energy error that the stability function predicts for small motions: each step multiplies each mode by
/// `R(h lambda)`.
fn of_modes(method: &impl StabilityFunction, model: &DoublePendulum, x0: [f64; 4]) -> f64 {
    let hanging = equilibrium(model, [0.0; 4]).expect("it hangs");
    let modes = hanging.spectrum.modes();
    let shapes = DMatrix::from_fn(4, 4, |i, k| modes[k].shape[i]);
    let start = DVector::from_fn(4, |i, _| Complex::new(x0[i], 0.0));
    let amplitudes = shapes.clone().lu().solve(&start).expect("independent modes");
    let steps = (TIME / H).round() as i32;
    let grown = DVector::from_fn(4, |k, _| {
        amplitudes[k] * method.stability_function(modes[k].eigenvalue * H).powi(steps)
    });
    let end = shapes * grown;
    let end = SVector::<f64, 4>::from_fn(|i, _| end[i].re);
    // in the limit of small motions
    let small = |x: &SVector<f64, 4>| energy(model, &(x * 1e-3));
    small(&end) / small(&x0.into()) - 1.0
}

/// Sum of the relative energy errors of single [`Rk4`] steps along the true motion.
fn along<S: System<f64, 4> + Energy<f64, 4>>(model: &S, x0: [f64; 4]) -> f64 {
    let method = Vern9::new().rtol(1e-10).atol(1e-10);
    let mut exact = method.stepper(model, 0.0, TIME, x0).expect("valid");
    let (mut sum, mut n) = (0.0, 0_u32);
    while exact.step().expect("regular").is_some() {
        let end = exact.t();
        let dense = exact.dense();
        while H * f64::from(n) < end {
            let x = dense.at(H * f64::from(n));
            let after = Rk4::new(H).stepper(model, 0.0, H, x).and_then(|mut step| step.run());
            sum += energy(model, &after.expect("regular")) - energy(model, &x);
            n += 1;
        }
    }
    sum / energy(model, &x0.into())
}

/// The classical Runge-Kutta method loses energy steadily.
pub fn runge_kutta(_: Size) -> Row {
    let (model, method) = (double_pendulum(0.0), Rk4::new(H));
    let regular = errors(&method, &model, REGULAR);
    let [half, whole] = [regular.len() / 2, regular.len()].map(|n| -regular[n - 1].1);
    let small = errors(&method, &model, SMALL);
    let points = Points::new(PointsParams::default()).expect("physical");
    let chaotic = errors(&method, &points, CHAOTIC);
    Row {
        in_book: true,
        case: "Energy of Rk4, h = 0.02 s, after 500 s",
        claims: vec![
            Claim::close(
                "regular motion: fraction lost",
                -of_modes(&method, &model, REGULAR),
                whole,
                0.1,
            ),
            Claim::close("of which in the first half", 0.5 * whole, half, 0.01),
            Claim::close(
                "a tenth of that swing: part that is lost",
                -of_modes(&method, &model, REGULAR),
                -small[small.len() - 1].1,
                0.02,
            ),
            Claim::alike(
                "two points, chaotic: part that is lost",
                -along(&points, CHAOTIC),
                -chaotic[chaotic.len() - 1].1,
                1.5,
            ),
        ],
        survives: "Gauss; tight tolerances for a while",
    }
}

/// Step of the Gauss method of order 4 in the state `[q; qd]`.
fn gauss_in_rates(model: &impl System<f64, 4>, x: &SVector<f64, 4>, h: f64) -> SVector<f64, 4> {
    let off = 3.0_f64.sqrt() / 6.0;
    let mut slopes = [model.rhs(0.0, x); 2];
    loop {
        let [a, b] = slopes;
        slopes = [
            model.rhs(0.0, &(x + (a * 0.25 + b * (0.25 - off)) * h)),
            model.rhs(0.0, &(x + (a * (0.25 + off) + b * 0.25) * h)),
        ];
        if (slopes[0] - a).amax().max((slopes[1] - b).amax()) < 1e-14 {
            return x + (slopes[0] + slopes[1]) * (0.5 * h);
        }
    }
}

/// Largest entry of `M^T J M - J` for the derivative `M` of a step in `(q, p)`, expressed in the state `[q; qd]`, in
/// which the two-form `J` depends on the state; 0 for a canonical map.
fn defect(model: &DoublePendulum, step: impl Fn(SVector<f64, 4>) -> SVector<f64, 4>) -> f64 {
    let x = SVector::from([2.0, 2.5, 1.0, -2.0]);
    let form = |x: &SVector<f64, 4>| {
        let (canonical, _) = model.canonical_jacobian(0.0, x);
        let mut j = SMatrix::<f64, 4, 4>::zeros();
        for k in 0..2 {
            j[(k, k + 2)] = 1.0;
            j[(k + 2, k)] = -1.0;
        }
        canonical.transpose() * j * canonical
    };
    let columns: [_; 4] = std::array::from_fn(|k| {
        let unit = SVector::<f64, 4>::from_fn(|i, _| f64::from(u8::from(i == k)));
        // central differences over four points, whose error is of fourth order
        let at = |d: f64| step(x + unit * d);
        let d = 1e-3;
        ((at(d) - at(-d)) * 8.0 - (at(2.0 * d) - at(-2.0 * d))) / (12.0 * d)
    });
    let of_step = SMatrix::<f64, 4, 4>::from_columns(&columns);
    (of_step.transpose() * form(&step(x)) * of_step - form(&x)).amax()
}

/// Gauss methods keep the energy bounded, and are canonical in coordinates and momenta, but not in coordinates and
/// rates.
pub fn gauss(_: Size) -> Row {
    const LONG: f64 = 0.1;
    fn one(method: &impl Method<DoublePendulum, f64, 4>, model: &DoublePendulum) -> f64 {
        defect(model, |x| {
            let mut step = method.stepper(model, 0.0, LONG, x).expect("valid");
            step.run().expect("regular")
        })
    }
    let model = double_pendulum(0.0);
    let regular = errors(&Gauss4::new(H), &model, REGULAR);
    let chaotic = errors(&Gauss4::new(H), &model, CHAOTIC);
    let tenth = regular.len() / 10;
    Row {
        in_book: true,
        case: "Energy with symplectic methods",
        claims: vec![
            Claim::at_most(
                "Gauss4, h = 0.02 s, regular motion: relative energy error in 500 s",
                1e-9,
                largest(&regular),
            ),
            Claim::close(
                "of which in the first 50 s",
                largest(&regular),
                largest(&regular[..tenth]),
                0.01,
            ),
            Claim::at_most("chaotic", 1e-5, largest(&chaotic)),
            Claim::at_most(
                "|Mᵀ J M − J| of a step of 0.1 s in (θ, p), Gauss4",
                1e-10,
                one(&Gauss4::new(LONG), &model),
            ),
            Claim::at_most("Gauss6", 1e-10, one(&Gauss6::new(LONG), &model)),
            Claim::at_least(
                "the formulas of Gauss4 in (θ, ω)",
                1e-6,
                defect(&model, |x| gauss_in_rates(&model, &x, LONG)),
            ),
            Claim::at_least("Rk4", 1e-6, one(&Rk4::new(LONG), &model)),
        ],
        survives: "Gauss4, Gauss6",
    }
}
