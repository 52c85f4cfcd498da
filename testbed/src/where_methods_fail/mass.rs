//! Masses that are small compared with others, or zero.

use nalgebra::{SMatrix, SVector};
use pendulum_core::SolveError;
use pendulum_core::prelude::*;
use pendulum_core::stability::{equilibrium, max_stable_step};

use super::row::{Claim, Row, Size, kind};
use super::scenes::{Points, PointsParams};

/// Ratio of the upper mass to the lower one.
const LIGHT: f64 = 1e-6;

fn points(m1: f64) -> Points {
    Points::new(PointsParams { m1, m2: 1.0 }).expect("physical")
}

/// Accelerations of two point masses on rods of 1 m, as sums of terms that do not cancel if one mass is small.
fn accelerations(m1: f64, m2: f64, x: &SVector<f64, 4>) -> [f64; 2] {
    const G: f64 = 9.81;
    let (sin, cos) = (x[0] - x[1]).sin_cos();
    let pivot = m1 + m2 * sin * sin;
    let pull = m2 * sin * (G * x[1].cos() + x[3] * x[3] + x[2] * x[2] * cos);
    let push = (m1 + m2) * (x[2] * x[2] + G * x[0].cos()) + m2 * x[3] * x[3] * cos;
    [-(m1 * G * x[0].sin() + pull) / pivot, sin * push / pivot]
}

/// The light mass swings like a bead on the taut rods: the frequency grows with the square root of the mass ratio, and
/// the steps shrink accordingly.
pub fn light(_: Size) -> Row {
    let model = points(LIGHT);
    let hanging = equilibrium(&model, [0.0; 4]).expect("it hangs");
    let frequency = hanging
        .spectrum
        .modes()
        .iter()
        .map(|mode| mode.angular_frequency())
        .fold(0.0, f64::max);
    // the difference of the angles loses some digits
    let x = SVector::from([0.5, 0.5 + 1.0 / 1024.0, 0.3, -0.2]);
    let exact = SVector::from(accelerations(LIGHT, 1.0, &x));
    let error = |ours: SVector<f64, 2>| (ours - exact).amax() / exact.amax();
    let generated = model.rhs(0.0, &x).fixed_rows::<2>(2).into_owned();
    let a12 = (x[0] - x[1]).cos();
    let mass = SMatrix::<f64, 2, 2>::from([[1.0 + LIGHT, a12], [a12, 1.0]]);
    let sin = (x[0] - x[1]).sin();
    let forces = SVector::from([
        -(sin * x[3] * x[3] + (1.0 + LIGHT) * 9.81 * x[0].sin()),
        sin * x[2] * x[2] - 9.81 * x[1].sin(),
    ]);
    let textbook = mass.cholesky().expect("positive definite").solve(&forces);
    let longest = max_stable_step(&Rk4::new(1.0), &hanging.jacobian).expect("finite");
    // Small enough that the tension of the rods stays at its value at rest.
    let start = SVector::from([1e-9, 0.0, 0.0, 0.0]);
    let grows = |h: f64| {
        let mut stepper = Rk4::new(h).stepper(&model, 0.0, 5000.0 * h, start).expect("valid");
        !stepper.run().is_ok_and(|x| x.fixed_rows::<2>(0).amax() < 1e-6)
    };
    let (mut sound, mut broken) = (0.5 * longest, 1.5 * longest);
    for _ in 0..16 {
        let middle = sound.midpoint(broken);
        if grows(middle) {
            broken = middle;
        } else {
            sound = middle;
        }
    }
    let swing = [0.1, 0.1, 0.0, 0.0];
    let vern9 = Vern9::new().rtol(1e-3).atol(1e-3);
    let steps = vern9
        .solve(&model, 0.0, 1.0, swing)
        .expect("regular")
        .statistics()
        .accepted;
    let least = 1.0 / max_stable_step(&vern9, &model.jacobian(0.0, &swing.into())).expect("finite");
    Row {
        in_book: true,
        case: "Nearly singular mass matrix: m1 = 1e-6 m2",
        claims: vec![
            Claim::close(
                "fastest frequency (rad/s)",
                (2.0 * 9.81 / LIGHT).sqrt(),
                frequency,
                1e-5,
            ),
            Claim::close(
                "longest step of Rk4 (s)",
                8.0_f64.sqrt() / (2.0 * 9.81 / LIGHT).sqrt(),
                longest,
                1e-5,
            ),
            Claim::close("and where it breaks (s)", longest, sound, 2e-3),
            Claim::close(
                "steps of Vern9 in 1 s of a small swing, tolerance 1e-3",
                least,
                steps as f64,
                0.03,
            ),
            Claim::at_most("relative error of the generated accelerations", 1e-14, error(generated)),
            Claim::at_least("by Cholesky's factors of the mass matrix", 1e-12, error(textbook)),
        ],
        survives: "the generated solution keeps its digits; steps are short",
    }
}

/// Without the upper mass, the rods in line have no inertia against folding.
pub fn none(_: Size) -> Row {
    let refused = Points::new(PointsParams { m1: 0.0, m2: 1.0 }).expect_err("singular");
    // a positive mass below the range of normal numbers
    let (model, x0) = (points(1e-320), SVector::from([0.5, 0.5, 0.0, 0.0]));
    let ends = |error: SolveError<f64, 4>| {
        let kept = error.t() == 0.0 && error.x() == x0;
        format!(
            "{} at {}",
            kind(error.reason),
            if kept { "the start" } else { "another state" }
        )
    };
    let ends = [
        (
            "Rk4",
            ends(Rk4::new(0.01).solve(&model, 0.0, 1.0, x0).expect_err("singular")),
        ),
        (
            "Vern9",
            ends(Vern9::new().solve(&model, 0.0, 1.0, x0).expect_err("singular")),
        ),
        (
            "Radau5",
            ends(Radau5::new().solve(&model, 0.0, 1.0, x0).expect_err("singular")),
        ),
    ];
    let ends = ends.map(|(name, end)| {
        Claim::same(
            format!("m1 = 1e-320 m2, {name}: it ends in"),
            "NonFinite at the start",
            end,
        )
    });
    let refused = Claim::same("m1 = 0 is refused as", "m1", refused.name);
    Row {
        in_book: false,
        case: "No mass, rods in line",
        claims: [refused].into_iter().chain(ends).collect(),
        survives: "none: an error with a type",
    }
}
