//! Rounding errors that remain if methods make no errors.

use nalgebra::SVector;
use pendulum_core::prelude::*;

use super::energy::REGULAR;
use super::row::{Claim, Row, Size};
use crate::scenes::double_pendulum;

/// Relative change of the energy since the start, computed without cancellation of large terms.
fn relative_energy(x: &SVector<f64, 4>, x0: &SVector<f64, 4>) -> f64 {
    let energy = |x: &SVector<f64, 4>| {
        let lift = |angle: f64, weight: f64| 2.0 * weight * (0.5 * angle).sin().powi(2);
        let turning = 1.5 * x[2] * x[2] + x[3] * x[3] + (x[0] - x[1]).cos() * x[2] * x[3];
        turning + lift(x[0], 19.6) + lift(x[1], 9.8)
    };
    (energy(x) - energy(x0)) / energy(x0)
}

/// Step size, in s, so short that the errors of the method are below those of rounding.
const H: f64 = 0.01;

/// Root mean square energy error of [`Gauss6`] after `early` and after `late` steps, over an ensemble of small swings.
fn walks(early: u32, late: u32, starts: u32) -> [f64; 2] {
    let model = double_pendulum(0.0);
    let mut squares = [0.0; 2];
    for n in 0..starts {
        let x0 = SVector::from([0.09, 0.12, 0.0, 0.0]) * (1.0 + 0.01 * f64::from(n));
        let mut stepper = Gauss6::new(H)
            .stepper(&model, 0.0, H * f64::from(late), x0)
            .expect("regular");
        // average over the last tenth, since the rounding of each state hides the walk
        let mut means = [0.0; 2];
        for step in 1..=late {
            let x = stepper.step().expect("regular").expect("not at the end").x1;
            for (mean, end) in means.iter_mut().zip([early, late]) {
                if step <= end && step > end - end / 10 {
                    *mean += relative_energy(&x, &x0) / f64::from(end / 10);
                }
            }
        }
        for (square, mean) in squares.iter_mut().zip(means) {
            *square += mean * mean / f64::from(starts);
        }
    }
    squares.map(f64::sqrt)
}

/// Brouwer's law: if steps make only rounding errors, these are a random walk, so the energy error grows with the
/// square root of the time. A bias would grow linearly.
pub fn random_walk(size: Size) -> Row {
    let (early, late, starts) = match size {
        Size::Small => (500, 5000, 16),
        Size::Full => (8000, 128_000, 16),
    };
    let [before, after] = walks(early, late, starts);
    // The increment of a step is rounded; it is about h omega times the variables at the frequency omega of 3 rad/s.
    let walk = f64::from(late).sqrt() * f64::EPSILON * H * 3.0;
    Row {
        in_book: false,
        case: "Rounding errors of the energy, Gauss6",
        claims: vec![
            Claim::alike(
                format!("growth from {early} to {late} steps"),
                f64::from(late / early).sqrt(),
                after / before,
                2.0,
            ),
            Claim::at_most("relative error at the end", walk, after),
        ],
        survives: "Gauss6, whose sums are compensated",
    }
}

/// Over many swings the energy error of [`Gauss16`], in long steps, is the random walk of rounding errors.
pub fn many_swings(size: Size) -> Row {
    const LONG: f64 = 0.3;
    let swings = match size {
        Size::Small => 1e3,
        Size::Full => 1e5,
    };
    let (model, x0) = (double_pendulum(0.0), SVector::from(REGULAR));
    // a swing takes about two seconds
    let method = Gauss16::new(LONG);
    let mut stepper = method.stepper(&model, 0.0, 2.0 * swings, x0).expect("regular");
    let mut largest = 0.0_f64;
    while let Some(step) = stepper.step().expect("regular") {
        largest = largest.max(relative_energy(&step.x1, &x0).abs());
    }
    let steps = stepper.statistics().accepted as f64;
    Row {
        in_book: false,
        case: "Energy over many swings, Gauss16",
        claims: vec![Claim::at_most(
            format!("h = {LONG} s: largest relative error in {swings:.0} swings"),
            steps.sqrt() * f64::EPSILON,
            largest,
        )],
        survives: "Gauss16; the errors of methods with a tolerance add up",
    }
}
