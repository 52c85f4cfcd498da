//! Chaos and the horizon of prediction.

use pendulum_core::prelude::*;
use pendulum_core::stability::{Exponents, Lyapunov, StabilityError};

use super::row::{Claim, Row, Size};
use super::scenes::{Points, PointsParams};

fn points() -> Points {
    Points::new(PointsParams::default()).expect("physical")
}

/// Compares Lyapunov exponents with reference values from two trajectories that are renormalised repeatedly, by `Rk4`
/// with steps of 5e-4 s over 4e4 s.
pub fn exponents(size: Size) -> Row {
    // The scatter decreases with the square roots of the time and of the number of starts: 1.2 % and 0.7 %.
    let (starts, duration, within) = match size {
        Size::Small => (4, 3000.0, 0.05),
        Size::Full => (1, 4e4, 0.02),
    };
    let regular = 0.2 * duration;
    let exponent = |angles: [f64; 2], starts: u32, duration: f64| {
        let method = Lyapunov::new().tolerance(1e-6).duration(duration);
        let alone = |n: u32| {
            let start = [angles[0] + 1e-3 * f64::from(n), angles[1], 0.0, 0.0];
            method.largest(&points(), start).expect("regular").values[0]
        };
        (0..starts).map(alone).sum::<f64>() / f64::from(starts)
    };
    Row {
        in_book: true,
        case: "Lyapunov exponent of two point masses, m = l = 1, g = 9.81",
        claims: vec![
            Claim::close(
                "from (2, 2.5) (1/s)",
                1.45,
                exponent([2.0, 2.5], starts, duration),
                within,
            ),
            Claim::close(
                "from (1.5, 1.5) (1/s)",
                0.82,
                exponent([1.5, 1.5], starts, duration),
                within,
            ),
            Claim::at_most(
                "from (0.5, 0.7), regular: it falls as ln(t) / t (1/s)",
                regular.ln() / regular,
                exponent([0.5, 0.7], 1, regular),
            ),
        ],
        survives: "every method, for the mean; none for a single trajectory over long times",
    }
}

const START: [f64; 4] = [2.0, 2.5, 0.0, 0.0];
/// Error at which a prediction is lost, in rad or rad/s.
pub const LOST: f64 = 0.1;
/// Time for which trajectories are followed at most, in s.
const LONG: f64 = 40.0;

/// Largest exponent of the motion to be predicted.
pub fn exponents_of_start(duration: f64) -> Result<Exponents<1, 4>, StabilityError> {
    Lyapunov::new()
        .tolerance(1e-6)
        .duration(duration)
        .largest(&points(), START)
}

/// Time for which a method at a tolerance follows the motion, averaged over neighbouring initial conditions.
pub fn horizon(tolerance: f64, starts: u32) -> f64 {
    let model = points();
    let mut sum = 0.0;
    for n in 0..starts {
        let mut x0 = SVector::from(START);
        x0[0] += 1e-2 * f64::from(n);
        let exact = Taylor::new()
            .rtol(3e-15)
            .atol(3e-15)
            .solve(&model, 0.0, LONG, x0)
            .expect("regular");
        let mut stepper = Vern7::new()
            .rtol(tolerance)
            .atol(tolerance)
            .stepper(&model, 0.0, LONG, x0)
            .expect("valid");
        while let Some(step) = stepper.step().expect("regular") {
            if (step.x1 - exact.at(step.t1).expect("within")).amax() > LOST {
                break;
            }
        }
        sum += stepper.t();
    }
    sum / f64::from(starts)
}

/// Errors grow by a factor of e in the time `1 / exponent`, so each digit of accuracy adds the same time.
pub fn horizons(size: Size) -> Row {
    let (starts, duration) = match size {
        Size::Small => (8, 1000.0),
        Size::Full => (64, 4e4),
    };
    let exponents = exponents_of_start(duration).expect("regular");
    let [loose, tight] = [1e-4, 1e-12];
    let gain = horizon(tight, starts) - horizon(loose, starts);
    Row {
        in_book: true,
        case: "Horizon of prediction",
        claims: vec![Claim::close(
            "gain from tolerance 1e-4 to 1e-12 (s)",
            exponents.horizon(tight, loose),
            gain,
            0.1,
        )],
        survives: "none: eight more digits gain about 13 s",
    }
}
