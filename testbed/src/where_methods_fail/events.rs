//! Events that are hard to locate, and endless rebounds.

use pendulum_core::prelude::*;

use super::row::{Claim, Row, Size, kind};

/// Times at which `g` crosses zero between 0 and 1, located on four steps.
fn passages(g: impl Fn(f64) -> f64) -> Vec<f64> {
    let clock = FnSystem(|_t: f64, _x: &SVector<f64, 1>| SVector::from([1.0]));
    let event = Event::new(move |t, _x: &SVector<f64, 1>| g(t));
    let solution = Rk4::new(0.25)
        .solve_with(&clock, 0.0, 1.0, [0.0], &[event])
        .expect("regular");
    solution.events().iter().map(|event| event.t).collect()
}

pub fn grazing(_: Size) -> Row {
    let dip = |depth: f64| passages(move |t| (t - 0.55).powi(2) - depth);
    let once = |zero: f64| format!("{:?}", passages(move |t| t - zero));
    Row {
        in_book: false,
        case: "Events that graze, at the start, and at the end of a step",
        claims: vec![
            Claim::same("passages of a dip 1e-10 deep", 2, dip(1e-10).len()),
            Claim::close("time between them (s)", 2e-5, dip(1e-10)[1] - dip(1e-10)[0], 1e-6),
            Claim::same("passages of a dip that stays 1e-10 above", 0, dip(-1e-10).len()),
            Claim::same("at the start (s)", "[0.0]", once(0.0)),
            Claim::same("at the end of a step (s)", "[0.25]", once(0.25)),
            Claim::same("at the end of all (s)", "[1.0]", once(1.0)),
        ],
        survives: "every method",
    }
}

/// A dropped ball that keeps half of its speed comes to rest after infinitely many rebounds, in finite time.
pub fn rebounds(_: Size) -> Row {
    const KEPT: f64 = 0.5;
    let ball = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -9.81]));
    let floor = Event::new(|_t, x: &SVector<f64, 2>| x[0])
        .falling()
        .reset(|_t, x| SVector::from([x[0], -KEPT * x[1]]));
    let error = Rk45::new()
        .solve_with(&ball, 0.0, 3.0, [1.0, 0.0], &[floor])
        .expect_err("it comes to rest");
    let rest = (2.0_f64 / 9.81).sqrt() * (1.0 + KEPT) / (1.0 - KEPT);
    Row {
        in_book: true,
        case: "Accumulating rebounds (Zeno)",
        claims: vec![
            Claim::same("error", "EventsAccumulate", kind(error.reason)),
            Claim::close("at the time (s)", rest, error.t(), 1e-12),
        ],
        survives: "every method, by `stop` or `wall`",
    }
}
