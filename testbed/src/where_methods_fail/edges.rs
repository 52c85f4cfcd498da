//! Limits of floating-point resolution.

use std::f64::consts::PI;

use pendulum_core::Reason;
use pendulum_core::prelude::*;
use pendulum_core::stability::equilibrium;

use super::row::{Claim, Row, Size, kind};
use crate::scenes::DoublePendulum;
use crate::scenes::double_pendulum;

mechanism! {
    /// A pendulum whose angle is measured from the upright position.
    Inverted {
        gravity: [0, -9.81, 0],
        body bob on ground { mass: 1, com: [0, 1, 0], joint: revolute(z), coordinate: angle }
    }
}

/// Inputs beyond the resolution of numbers are rejected; within it, results are correct to the last digits.
pub fn resolution(_: Size) -> Row {
    let (model, x0) = (double_pendulum(0.1), [1.0, -1.0, 0.0, 0.0]);
    let refused = |reason: Reason| match reason {
        Reason::InvalidInput { what, .. } => what,
        _ => "nothing",
    };
    let narrow = Vern9::new()
        .rtol(9.0 * f64::EPSILON)
        .solve(&model, 0.0, 1.0, x0)
        .expect_err("no number has such digits");
    let short = Rk4::new(1e-7)
        .solve(&model, 1e9, 1e9 + 1.0, x0)
        .expect_err("no time has such digits");
    // steps and times that are sums of powers of two
    let h = 1.0 / 128.0;
    let late = f64::from(1 << 30);
    let end = |t0: f64| Rk4::new(h).solve(&model, t0, t0 + 2.0, x0).expect("regular").end();
    // far from zero an angle has fewer digits
    let far = 1e5_f64;
    let swing = double_pendulum(0.0);
    let slope = |angle: f64| swing.rhs(0.0, &SVector::from([angle, angle, 0.0, 0.0]))[2];
    // both in line: 3 a1 + a2 = -19.6 sin, a1 + 2 a2 = -9.8 sin
    let exact = -(2.0 * 19.6 - 9.8) / 5.0 * far.sin();
    Row {
        in_book: false,
        case: "Tolerances, steps, times and angles at the limits of double precision",
        claims: vec![
            Claim::same("a tolerance of 9 ulps is refused as", "rtol", refused(narrow.reason)),
            Claim::same("steps of 1e-7 s at 1e9 s are refused as", "h", refused(short.reason)),
            Claim::at_most(
                "difference of motions from 0 and 2^30 s",
                0.0,
                (end(late) - end(0.0)).amax(),
            ),
            Claim::at_most(
                "error of the acceleration at 1e5 rad, in ulps",
                4.0,
                (slope(far) / exact - 1.0).abs() / f64::EPSILON,
            ),
        ],
        survives: "every method, by an error with a type",
    }
}

/// Right-hand sides that are not finite after 1 s.
pub fn not_finite(_: Size) -> Row {
    let claims = [("NaN", f64::NAN), ("infinity", f64::INFINITY)].map(|(name, end)| {
        let system = FnSystem(move |t: f64, x: &SVector<f64, 1>| SVector::from([if t > 1.0 { end } else { -x[0] }]));
        let error = Vern9::new().solve(&system, 0.0, 2.0, [1.0]).expect_err("it ends");
        [
            Claim::same(format!("{name}: it ends in"), "NonFinite", kind(error.reason)),
            Claim::close(
                format!("{name}: the last good state is of (s)"),
                1.0,
                error.t(),
                16.0 * f64::EPSILON,
            ),
            Claim::close(format!("{name}: that state"), (-1.0_f64).exp(), error.x()[0], 1e-6),
        ]
    });
    Row {
        in_book: false,
        case: "Right-hand sides that are not finite",
        claims: claims.into_iter().flatten().collect(),
        survives: "every method, by an error with the last good state",
    }
}

/// Forward and backward in time: the way back makes errors of its own.
pub fn back_in_time(_: Size) -> Row {
    const TOLERANCE: f64 = 1e-10;
    fn distance(method: &impl Method<DoublePendulum, f64, 4>) -> f64 {
        let model = double_pendulum(0.0);
        let x0 = SVector::from([2.0, 2.5, 0.0, 0.0]);
        let there = method.solve(&model, 0.0, 2.0, x0).expect("regular").end();
        let back = method.solve(&model, 2.0, 0.0, there).expect("regular").end();
        (back - x0).amax()
    }
    Row {
        in_book: false,
        case: "Forth and back in time",
        claims: vec![
            Claim::at_most(
                "distance from the start, Rk45",
                5.0 * TOLERANCE,
                distance(&Rk45::new().rtol(TOLERANCE).atol(TOLERANCE)),
            ),
            Claim::at_most(
                "Vern9",
                TOLERANCE,
                distance(&Vern9::new().rtol(TOLERANCE).atol(TOLERANCE)),
            ),
            Claim::at_most(
                "Taylor",
                TOLERANCE,
                distance(&Taylor::new().rtol(TOLERANCE).atol(TOLERANCE)),
            ),
            Claim::at_most(
                "Radau5, whose estimate is far above its error",
                0.01 * TOLERANCE,
                distance(&Radau5::new().rtol(TOLERANCE).atol(TOLERANCE)),
            ),
            Claim::at_most("Gauss6, whose way back is the same", 1e-13, distance(&Gauss6::new(0.1))),
        ],
        survives: "every method; Gauss up to rounding",
    }
}

/// Upright: an exact equilibrium persists, and a perturbation grows at the rate of the linear theory.
pub fn upright(_: Size) -> Row {
    let inverted = Inverted::new(InvertedParams {}).expect("physical");
    let stays = Vern9::new().solve(&inverted, 0.0, 1000.0, [0.0, 0.0]).expect("regular");
    let model = double_pendulum(0.1);
    let standing = equilibrium(&model, [PI, PI, 0.0, 0.0]).expect("it stands");
    let fastest = standing.spectrum.modes()[0];
    let x0 = standing.x + fastest.shape.map(|component| component.re) * 1e-7;
    let method = Vern9::new().rtol(1e-14).atol(1e-14);
    let motion = method.solve(&model, 0.0, 2.0, x0).expect("regular");
    let apart = |t: f64| (motion.at(t).expect("within") - standing.x).norm();
    Row {
        in_book: false,
        case: "Upright",
        claims: vec![
            Claim::at_most("exactly upright, way in 1000 s (rad)", 0.0, stays.end().amax()),
            Claim::close(
                "off by 1e-7, rate of growth over 2 s (1/s)",
                fastest.growth_rate(),
                (apart(2.0) / apart(0.0)).ln() / 2.0,
                1e-6,
            ),
        ],
        survives: "every method",
    }
}
