//! Stability limits of the step size for linear motions.

use pendulum_core::method::{Explicit, Fixed, Gauss, OneStep, PowerSeries, RadauIIA, Rosenbrock};
use pendulum_core::prelude::*;
use pendulum_core::stability::{Complex, StabilityFunction, imaginary_limit, real_limit};
use pendulum_core::tableau::{self, DormandPrince5, Kutta4, Tsitouras5, Verner7, Verner9};

use super::row::{Claim, Row, Size};
use super::scenes::{Cart, cart};

/// Makes a claim for each explicit method.
macro_rules! each_explicit {
    ($claim:ident) => {
        vec![
            $claim::<Explicit<Kutta4, 5>>("Rk4"),
            $claim::<Explicit<DormandPrince5, 7>>("Rk45"),
            $claim::<Explicit<Tsitouras5, 7>>("Tsit5"),
            $claim::<Explicit<Verner7, 11>>("Vern7"),
            $claim::<Explicit<Verner9, 17>>("Vern9"),
            $claim::<PowerSeries>("Taylor, order 20"),
        ]
    };
}

/// State after `steps` steps.
fn left<F: OneStep<Cart, f64, 2> + Default>(model: &Cart, h: f64, steps: u32, x0: [f64; 2]) -> SVector<f64, 2> {
    let mut stepper = Fixed::<F>::new(h)
        .stepper(model, 0.0, h * f64::from(steps), x0)
        .expect("valid");
    stepper.run().unwrap_or_else(|_| SVector::repeat(f64::INFINITY))
}

/// Longest step for which `size`, the size of an initial state of size 1 after many steps, does not exceed 1.
fn longest(size: impl Fn(f64) -> f64, (mut stable, mut unstable): (f64, f64)) -> f64 {
    for _ in 0..24 {
        let middle = stable.midpoint(unstable);
        if size(middle) <= 1.0 + f64::from(STEPS) * GROWTH {
            stable = middle;
        } else {
            unstable = middle;
        }
    }
    stable
}

const STEPS: u32 = 500;
/// Growth per step that still counts as neutral, as in the computed limits.
const GROWTH: f64 = 1e-9;

/// `v' = -v`.
pub fn real_axis(_: Size) -> Row {
    fn claim<F: OneStep<Cart, f64, 2> + Default>(name: &str) -> Claim
    where
        Fixed<F>: StabilityFunction,
    {
        let predicted = real_limit(&Fixed::<F>::new(1.0));
        let brake = cart(0.0, 1.0);
        let size = |h: f64| left::<F>(&brake, h, STEPS, [0.0, 1.0])[1].abs();
        Claim::close(name, predicted, longest(size, (0.5 * predicted, 1.5 * predicted)), 1e-6)
    }
    Row {
        in_book: true,
        case: "Longest stable step on the real axis, |h λ|",
        claims: each_explicit!(claim),
        survives: "Rodas, Radau, Gauss: no limit",
    }
}

/// `x'' = -x`.
pub fn imaginary_axis(_: Size) -> Row {
    fn claim<F: OneStep<Cart, f64, 2> + Default>(name: &str) -> Claim
    where
        Fixed<F>: StabilityFunction,
    {
        let predicted = imaginary_limit(&Fixed::<F>::new(1.0));
        let spring = cart(1.0, 0.0);
        let size = |h: f64| left::<F>(&spring, h, STEPS, [1.0, 0.0]).norm();
        Claim::close(name, predicted, longest(size, (0.5 * predicted, 1.5 * predicted)), 1e-6)
    }
    Row {
        in_book: true,
        case: "Longest stable step on the imaginary axis, |h λ|",
        claims: each_explicit!(claim),
        survives: "Rodas, Radau, Gauss: no limit",
    }
}

/// One step of a billion time constants.
pub fn infinity(_: Size) -> Row {
    const FAR: f64 = 1e9;
    fn claim<F: OneStep<Cart, f64, 2> + Default>(name: &str, leaves_nothing: bool) -> Claim
    where
        Fixed<F>: StabilityFunction,
    {
        let method = Fixed::<F>::new(1.0);
        let predicted = method.stability_function(Complex::new(-FAR, 0.0)).re;
        let after = left::<F>(&cart(0.0, FAR), 1.0, 1, [0.0, 1.0])[1];
        let what = format!("{name}: amplification factor of one step");
        if leaves_nothing {
            Claim::at_most(what, 1e-6, after.abs())
        } else {
            Claim::close(what, predicted, after, 1e-6)
        }
    }
    Row {
        in_book: true,
        case: "Step size far beyond the time scale of a stiff mode, h λ = −1e9",
        claims: vec![
            claim::<Gauss<3>>("Gauss6", false),
            claim::<Gauss<8, 4>>("Gauss16", false),
            claim::<Gauss<2>>("Gauss4", false),
            claim::<RadauIIA>("Radau5", true),
            claim::<RadauIIA<5, 2>>("Radau9", true),
            claim::<RadauIIA<7, 3>>("Radau13", true),
            claim::<Rosenbrock<tableau::HairerWanner4, 6>>("Rodas4", true),
            claim::<Rosenbrock<tableau::Steinebach5, 8>>("Rodas5P", true),
            claim::<Explicit<Kutta4, 5>>("Rk4", false),
        ],
        survives: "Rodas, Radau damp the mode; with Gauss4 it persists, with Gauss6 it oscillates",
    }
}
