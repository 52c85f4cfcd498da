//! Contacts that open where their force passes zero. Gap, rate and acceleration are zero there, and the gap grows with
//! the third power of time, below the resolution of a step.

use nalgebra::SVector;
use pendulum_core::hybrid::Status;
use pendulum_core::prelude::*;
use pendulum_core::{Reason, SolveError};
use testbed::random::number;

mechanism! {
    /// A body of 1 kg on a floor at zero, under an oscillating force.
    pub Pressed {
        params { f: N, a: N, w: rad/s = 50 }
        wall floor { gap: y }
        body b on ground { mass: 1, joint: prismatic(y), coordinate: y, torque: a*sin(w*t) - f }
    }
}

mechanism! {
    /// `Pressed` with the stop of a joint instead of the floor.
    pub Stopped {
        params { f: N, a: N, w: rad/s = 50 }
        body b on ground {
            mass: 1, joint: prismatic(y), coordinate: y, torque: a*sin(w*t) - f, stop: [0, 10],
        }
    }
}

mechanism! {
    /// A ball on a shaken table.
    pub Shaken {
        params { a: m = 0.01, w: rad/s, e: 1 }
        gravity: [0, -9.81, 0],
        wall table { gap: y - a*sin(w*t), restitution: e }
        body ball on ground { mass: 1, joint: prismatic(y), coordinate: y }
    }
}

mechanism! {
    /// A ball above a floor at a given height.
    pub Ball {
        params { e: 1, height: m = 1 }
        gravity: [0, -9.81, 0],
        wall floor { gap: y - height, restitution: e }
        body ball on ground { mass: 1, joint: prismatic(y), coordinate: y }
    }
}

mechanism! {
    /// A wall that pushes a body onto a stop and further.
    pub Crushed {
        params { v: m/s = 0.1 }
        wall piston { gap: s - v*t }
        body b on ground { mass: 1, joint: prismatic(x), coordinate: s, stop: [-1, 1] }
    }
}

const GRAVITY: f64 = 9.81;

type Solved = Result<Solution<f64, 2>, SolveError<f64, 2>>;

/// Motion by each method.
fn by_each<S: Jacobian<f64, 2>>(model: &S, t1: f64, start: [f64; 2]) -> [(&'static str, Solved); 8] {
    macro_rules! by {
        ($method:ident) => {{
            let method = $method::new().rtol(1e-9).atol(1e-9).max_steps(20_000);
            (stringify!($method), method.solve(model, 0.0, t1, start))
        }};
    }
    [
        by!(Tsit5),
        by!(Rk45),
        by!(Vern7),
        by!(Vern9),
        by!(Rodas5P),
        by!(Radau5),
        by!(Auto),
        ("Rk4", Rk4::new(1e-4).solve(model, 0.0, t1, start)),
    ]
}

fn statuses(solution: &Solution<f64, 2>) -> Vec<Status> {
    solution.modes().iter().map(|(_, mode)| mode.0[0]).collect()
}

/// First zero of a function that is positive at first.
fn zero(f: impl Fn(f64) -> f64, from: f64, by: f64) -> f64 {
    let mut t = (1..)
        .map(|n| from + f64::from(n) * by)
        .find(|&t| f(t) < 0.0)
        .expect("a zero")
        - by;
    let mut step = by;
    for _ in 0..60 {
        step *= 0.5;
        if f(t + step) > 0.0 {
            t += step;
        }
    }
    t
}

#[test]
fn what_a_swinging_force_lifts_flies_and_lands() {
    let (f, w) = (GRAVITY, 50.0_f64);
    for n in 0..25 {
        let a = 10.0 + 1.37 * f64::from(n);
        let lifts = (f / a).asin() / w;
        let flight = |t: f64| {
            let [(sin0, cos0), (sin, cos)] = [lifts, t].map(|t| (w * t).sin_cos());
            let since = t - lifts;
            let y = a / w * cos0 * since - a / (w * w) * (sin - sin0) - 0.5 * f * since * since;
            [y, a / w * (cos0 - cos) - f * since]
        };
        let lands = zero(|t| flight(t)[0], lifts, 1e-3);
        let then = if a * (w * lands).sin() < f {
            Status::Low
        } else {
            Status::Free
        };
        let (pressed, stopped) = (PressedParams { f, a, w }, StoppedParams { f, a, w });
        let (pressed, stopped) = (
            Pressed::new(pressed).expect("physical"),
            Stopped::new(stopped).expect("physical"),
        );
        let all = [
            by_each(&pressed, lands + 1e-4, [0.0; 2]),
            by_each(&stopped, lands + 1e-4, [0.0; 2]),
        ];
        for (method, solution) in all.into_iter().flatten() {
            let solution = solution.unwrap_or_else(|error| panic!("{method}, {a}: {error}"));
            assert_eq!(statuses(&solution), [Status::Low, Status::Free, then], "{method}, {a}");
            let [lifted, landed] = [1, 2].map(|n| solution.modes()[n].0);
            assert!((lifted - lifts).abs() < 1e-15, "{method}, {a}: {lifted} {lifts}");
            assert!((landed - lands).abs() < 1e-8, "{method}, {a}: {landed} {lands}");
            for (t, x) in solution.points().filter(|&(t, _)| (lifts..lands - 1e-8).contains(&t)) {
                let apart = (x - SVector::from(flight(t))).amax();
                assert!(x[0] >= -1e-15 && apart < 2e-8, "{method}, {a} at {t}: {apart:e}");
            }
        }
    }
}

#[test]
fn a_ball_leaves_a_shaken_table_where_that_falls_faster() {
    for w in [20.0_f64, 31.3, 31.4, 40.0, 90.0] {
        let falls = GRAVITY / (0.01 * w * w);
        for e in [0.0, 0.5] {
            let table = Shaken::new(ShakenParams { a: 0.01, w, e }).expect("physical");
            for (method, solution) in by_each(&table, 0.26, [0.0, 0.01 * w]) {
                let solution = solution.unwrap_or_else(|error| panic!("{method}, {w}: {error}"));
                let leaves = solution.modes().get(1).map(|&(t, _)| t);
                assert_eq!(leaves.is_some(), falls < 1.0, "{method}, {w}");
                let apart = leaves.map_or(0.0, |t| (t - falls.asin() / w).abs());
                assert!(apart < 1e-14, "{method}, {w}: {apart:e}");
            }
        }
    }
}

#[test]
fn a_ball_on_a_shaken_table_flies_and_rests_by_turns() {
    for n in 0..40 {
        let w = 32.0 + 2.17 * f64::from(n);
        for (e, most) in [(0.0, 40), (0.5, 300)] {
            let table = Shaken::new(ShakenParams { a: 0.01, w, e }).expect("physical");
            macro_rules! by {
                ($method:ident) => {{
                    let method = $method::new().rtol(1e-9).atol(1e-9).max_steps(20_000);
                    let solution = method.solve(&table, 0.0, 2.0, [0.06, 0.0]);
                    solution.unwrap_or_else(|error| panic!("{}, {w}, {e}: {error}", stringify!($method)))
                }};
            }
            for solution in [by!(Vern7), by!(Tsit5), by!(Rodas5P)] {
                let count = solution.modes().len();
                assert!(count <= most, "{w}, {e}: {count} modes");
                for (t, x) in solution.points() {
                    let [gap, _] = table.measures(t, x)[0];
                    assert!(gap >= -1e-14, "{w}, {e} at {t}: {gap:e}");
                }
            }
        }
    }
}

/// The table swings up to eight times between the sampled points of a step, and the first of its crests that meets the
/// ball must be found. The reference takes steps so short that the table swings by at most a radian in each. The
/// comparison ends where the reference becomes uncertain: rebounds multiply errors, as the reference for a slightly
/// larger swing of the table shows. `PENDULUM_ROUGH` tries more tables.
#[test]
#[ignore = "takes long"]
fn a_table_that_swings_within_a_step_hits_as_soon_as_it_must() {
    let others = (0..number("PENDULUM_ROUGH", 0)).map(|n| 20.0 + 180.0 * (n as f64 * 0.618_033_988_749_895).fract());
    let start = [0.06, 0.0];
    for w in [37.1, 84.35, 101.45, 116.3].into_iter().chain(others) {
        for e in [0.0, 0.5] {
            let [table, larger] =
                [0.01, 0.01 * (1.0 + 1e-8)].map(|a| Shaken::new(ShakenParams { a, w, e }).expect("physical"));
            let shortly = Vern9::new().rtol(1e-13).atol(1e-13).h_max(1.0 / w).max_steps(100_000);
            let [exact, neighbour] = [&table, &larger].map(|table| {
                let solution = shortly.solve(table, 0.0, 2.0, start);
                solution.unwrap_or_else(|error| panic!("{w}, {e}: {error}"))
            });
            for (method, solution) in by_each(&table, 2.0, start) {
                let solution = solution.unwrap_or_else(|error| panic!("{method}, {w}, {e}: {error}"));
                // accumulated errors of many steps, each within 1e-9
                let mut certain = 1e-8_f64;
                for (t, ours) in solution.points() {
                    let [exact, neighbour] = [&exact, &neighbour].map(|solution| solution.at(t).expect("inside")[0]);
                    certain = certain.max((neighbour - exact).abs());
                    if certain > 1e-5 {
                        break;
                    }
                    let apart = (ours[0] - exact).abs();
                    assert!(
                        apart < 100.0 * certain,
                        "{method}, {w}, {e} at {t}: {apart:e} of {certain:e}"
                    );
                }
            }
        }
    }
}

#[test]
fn fixed_steps_end_on_a_shaken_table() {
    for e in [0.0, 0.5] {
        let table = Shaken::new(ShakenParams { a: 0.01, w: 50.0, e }).expect("physical");
        let by_rk4 = Rk4::new(0.002).solve(&table, 0.0, 2.0, [0.06, 0.0]).expect("an end");
        let by_vern9 = Vern9::new()
            .rtol(1e-12)
            .atol(1e-12)
            .solve(&table, 0.0, 2.0, [0.06, 0.0])
            .expect("an end");
        assert_eq!(statuses(&by_rk4), statuses(&by_vern9), "{e}");
    }
}

#[test]
fn contacts_that_contradict_each_other_are_an_error_at_once() {
    let crushed = Crushed::new(CrushedParams::default()).expect("physical");
    for (method, solution) in by_each(&crushed, 20.0, [0.5, 0.0]) {
        let error = solution.expect_err("nothing can go on");
        assert!(
            matches!(error.reason, Reason::ModesAccumulate { .. }),
            "{method}: {error}"
        );
        assert!((error.t() - 10.0).abs() < 1e-6, "{method}: {error}");
        assert!(error.to_string().contains("let one of the two yield"), "{error}");
    }
}

#[test]
fn rebounds_far_shorter_than_a_fixed_step_are_an_error() {
    // a floor at zero, where rounding errors do not hide how low rebounds are; those that lose energy come to rest
    let floor = |e| Ball::new(BallParams { e, height: 0.0 }).expect("physical");
    let error = Rk4::new(0.01)
        .solve(&floor(1.0), 0.0, 5.0, [0.0, 1e-9])
        .expect_err("no end");
    assert_eq!(
        error.reason,
        Reason::ModesAccumulate {
            constraint: "floor".into()
        }
    );
    let e = 0.995;
    let solution = Rk4::new(0.01).solve(&floor(e), 0.0, 200.0, [1.0, 0.0]).expect("rests");
    let rests = (2.0 / GRAVITY).sqrt() * (1.0 + 2.0 * e / (1.0 - e));
    let &(t, mode) = solution.modes().last().expect("a mode");
    assert!(mode.is_held(0) && (t - rests).abs() < 1e-6, "{t} {rests}");
}

#[test]
fn rebounds_that_are_too_low_end_at_once_where_no_energy_is_lost() {
    let ball = Ball::new(BallParams { e: 1.0, height: 1.0 }).expect("physical");
    let solution = Vern7::new().solve(&ball, 0.0, 1.0, [1.0 + 5e-14, 0.0]).expect("rests");
    assert_eq!(statuses(&solution), [Status::Free, Status::Low]);
    assert!(solution.modes()[1].0 < 1e-6, "{:?}", solution.modes());
}
