//! States of rest, exponents and tangents of scenes with dry friction, stops and walls.

use std::f64::consts::{PI, TAU};

use nalgebra::SVector;
use pendulum_core::hybrid::Status;
use pendulum_core::prelude::*;
use pendulum_core::stability::{Lyapunov, Resting, Shooting, Stability, StabilityError, resting, transition};

mechanism! {
    pub Block {
        params { mu: N = 2 }
        body block on ground { mass: 1, joint: prismatic(x), coordinate: s, dry_friction: mu }
    }
}

mechanism! {
    /// A block pushed against a stop by a force, unless friction holds it.
    pub Stopped {
        params { force: N = -2, mu: N = 0, e: 1 = 0.5 }
        body block on ground {
            mass: 1, joint: prismatic(x), coordinate: s, torque: force,
            dry_friction: mu, stop: [0, 1] restitution(e),
        }
    }
}

mechanism! {
    /// A block held by friction, and an undamped pendulum.
    pub Two {
        params { mu: N = 2 }
        gravity: [0, -9.81, 0],
        body block on ground { mass: 1, joint: prismatic(x), coordinate: s, dry_friction: mu }
        body rod on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a }
    }
}

mechanism! {
    /// A cart with dry friction, and a pendulum on it without.
    pub Cart {
        params { mu: N = 2 }
        gravity: [0, -9.81, 0],
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: s, dry_friction: mu }
        body rod on cart { solids: [rod(1, [0, 0, 0], [0, -1, 0])], joint: revolute(z), coordinate: a }
    }
}

mechanism! {
    pub Rusty {
        params { mu: N m = 1 }
        gravity: [0, -9.81, 0],
        body rod on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, dry_friction: mu, stop: [-10 rad, 10 rad],
        }
    }
}

mechanism! {
    /// A pendulum pulled against a wall by gravity.
    pub Tilted {
        params { mu: N m = 0.5, tilt: rad = 0.3, high: rad = 3 }
        gravity: [9.81*sin(tilt), -9.81*cos(tilt), 0],
        point tip on rod at [0, -1, 0],
        wall side { gap: 0.2 - tip.x }
        body rod on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, dry_friction: mu, stop: [-1, high],
        }
    }
}

mechanism! {
    /// A ball above a shaking table.
    pub Table {
        params { a: m = 0.01, w: rad/s = 30, e: 1 = 0.5 }
        gravity: [0, -9.81, 0],
        wall table { gap: y - a*sin(w*t), restitution: e }
        body ball on ground { mass: 1, joint: prismatic(y), coordinate: y }
    }
}

mechanism! {
    /// A bead on a bowl, and a free one beside it.
    pub Bowl {
        params { k: 1/m = 2 }
        gravity: [0, -9.81, 0],
        wall bowl { gap: y - k*x^2/2 }
        body across on ground { mass: 1, joint: prismatic(x), coordinate: x, spring: (3, 0.5) }
        body bead on across { mass: 1, joint: prismatic(y), coordinate: y }
    }
}

fn block() -> Block {
    Block::new(BlockParams::default()).expect("physical")
}

fn stopped(force: f64, mu: f64) -> Stopped {
    Stopped::new(StoppedParams { force, mu, e: 0.5 }).expect("physical")
}

fn two() -> Two {
    Two::new(TwoParams::default()).expect("physical")
}

fn cart() -> Cart {
    Cart::new(CartParams::default()).expect("physical")
}

fn tilted(mu: f64, high: f64) -> Tilted {
    let params = TiltedParams {
        mu,
        high,
        ..TiltedParams::default()
    };
    Tilted::new(params).expect("physical")
}

fn exponents<const N: usize>(system: &impl Jacobian<f64, N>, transient: f64, start: [f64; N]) -> [f64; N] {
    let measured = Lyapunov::new().transient(transient).duration(50.0);
    measured.exponents::<N, N>(system, start).expect("regular").values
}

const LOST: f64 = f64::NEG_INFINITY;

#[test]
fn what_is_held_from_the_start_is_lost() {
    assert_eq!(exponents(&block(), 0.0, [0.0, 0.0]), [0.0, LOST]);
    // it slides for half a second
    assert_eq!(exponents(&block(), 5.0, [0.0, 1.0]), [0.0, LOST]);
    let [first, second] = exponents(&block(), 0.0, [0.0, 1.0]);
    assert!(first.abs() < 0.05 && second == LOST, "{first} {second}");
    // at a stop the memory of positions is lost too
    for start in [[0.0, 0.0], [0.5, 0.0]] {
        assert_eq!(exponents(&stopped(-2.0, 0.0), 0.0, start), [LOST; 2]);
        assert_eq!(exponents(&stopped(-2.0, 0.0), 10.0, start), [LOST; 2]);
    }
    for (transient, rate) in [(0.0, 0.0), (0.0, 1.0), (3.0, 1.0)] {
        let [a, b, c, d] = exponents(&two(), transient, [0.1, 0.5, rate, 0.0]);
        assert!(a.abs() + b.abs() + c.abs() < 0.3 && d == LOST, "{a} {b} {c} {d}");
    }
}

#[test]
fn what_a_wall_that_moves_holds_is_lost() {
    let table = Table::new(TableParams::default()).expect("physical");
    assert_eq!(exponents(&table, 0.0, [0.05, 0.0]), [LOST; 2]);
    // a bead stays on a curved wall: two directions of four
    let bowl = Bowl::new(BowlParams::default()).expect("physical");
    let [a, b, c, d] = exponents(&bowl, 0.0, [0.2, 0.04, 0.0, 0.0]);
    assert!(a.abs() + b.abs() < 0.2, "{a} {b}");
    assert_eq!([c, d], [LOST; 2]);
}

#[test]
fn neighbours_of_what_is_pressed_to_a_limit_go_there() {
    let matrix = |system: &Stopped, start| transition(system, 0.0, 5.0, start, 1e-10).expect("regular").1;
    for start in [[0.0, 0.0], [0.5, 0.0]] {
        assert_eq!(
            matrix(&stopped(-2.0, 0.0), start),
            SMatrix::<f64, 2, 2>::zeros(),
            "from {start:?}"
        );
        assert_eq!(
            matrix(&stopped(-2.0, 1.0), start),
            SMatrix::<f64, 2, 2>::zeros(),
            "from {start:?}"
        );
    }
    // displacements persist where friction holds, and where no force acts
    let stays = SMatrix::<f64, 2, 2>::from([[1.0, 0.0], [0.0, 0.0]]);
    assert_eq!(matrix(&stopped(-2.0, 3.0), [0.0, 0.0]), stays);
    assert_eq!(matrix(&stopped(0.0, 0.0), [0.0, 0.0]), stays);
    assert_eq!(
        transition(&block(), 0.0, 5.0, [0.0, 0.0], 1e-10).expect("regular").1,
        stays
    );
    let table = Table::new(TableParams::default()).expect("physical");
    let orbit = Shooting::new()
        .forced(&table, [0.0, 0.3], TAU / 30.0)
        .expect("it is carried");
    assert!(orbit.monodromy.amax() < 1e-12, "{}", orbit.monodromy);
    assert_eq!(orbit.stability(), Stability::AsymptoticallyStable);
}

#[test]
fn tangents_on_a_wall_are_those_of_neighbours_that_fall_on_it() {
    let bowl = Bowl::new(BowlParams::default()).expect("physical");
    let start = SVector::from([0.3, 0.09, 0.5, 0.3]);
    let end = |x: SVector<f64, 4>| {
        let solution = Vern9::new().rtol(1e-13).atol(1e-13).solve(&bowl, 0.0, 0.7, x);
        solution.expect("regular").end()
    };
    let (x, matrix) = transition(&bowl, 0.0, 0.7, start, 1e-12).expect("regular");
    assert_eq!(bowl.constraints().len(), 1);
    // one-sided differences: neighbours above or leaving the wall fall; the error is of the order of the square root
    for (component, reach) in [(1, 1e-8), (3, 1e-8)] {
        let mut moved = start;
        moved[component] += reach;
        let change = (end(moved) - x) / reach;
        let column = matrix.column(component);
        assert!((change - column).amax() < 1e-2, "{component}: {change} for {column}");
        assert!(column.amax() > 1e-2, "{component}: {column}");
    }
}

fn at_rest<S: Jacobian<f64, N>, const N: usize>(system: &S, seed: [f64; N]) -> Resting<N> {
    let found = resting(system, seed).unwrap_or_else(|error| panic!("from {seed:?}: {error}"));
    assert!(found.x.iter().skip(N / 2).all(|&rate| rate == 0.0), "{}", found.x);
    // it stays there
    let solution = Tsit5::new().solve(system, 0.0, 0.5, found.x).expect("regular");
    assert!(
        (solution.end() - found.x).amax() < 1e-10,
        "{} {}",
        found.x,
        solution.end()
    );
    found
}

#[test]
fn rest_is_found_from_anywhere() {
    let rusty = Rusty::new(RustyParams::default()).expect("physical");
    let most = (1.0_f64 / 9.81).asin();
    for seed in [0.0, 0.05, 0.1, 0.11, 0.5, 1.0, -2.0, 2.9, 3.0, 3.1, PI] {
        let found = at_rest(&rusty, [seed, 0.7]);
        let off = found.x[0].rem_euclid(PI);
        assert!(off.min(PI - off) <= most, "{}", found.x);
        assert_eq!(
            found.x[0] == seed,
            seed.sin().abs() <= most.sin(),
            "{seed}: {}",
            found.x
        );
    }
    for seed in [
        [0.3, 0.1, 0.0, 0.0],
        [0.3, 0.5, 1.0, -1.0],
        [0.3, 1e-3, 0.0, 0.0],
        [0.3, PI, 0.0, 0.0],
    ] {
        let found = at_rest(&cart(), seed);
        assert_eq!(found.mode.0[0], Status::Stuck);
        assert!(found.x[1].sin().abs() < 1e-12 && found.margin > 1.0 - 1e-9, "{found:?}");
    }
}

#[test]
fn rest_against_a_limit_is_found() {
    // without friction rest is possible only at the stop
    for (force, end) in [(-2.0, 0.0), (2.0, 1.0)] {
        for mu in [0.0, 1.0] {
            let found = at_rest(&stopped(force, mu), [0.2, 0.0]);
            assert_eq!(found.x, SVector::from([end, 0.0]));
        }
        assert_eq!(at_rest(&stopped(force, 3.0), [0.2, 0.0]).x[0], 0.2);
    }
    // it would hang at 0.3, behind the wall
    let found = at_rest(&tilted(0.5, 3.0), [0.0, 0.0]);
    assert!((found.x[0] - 0.2_f64.asin()).abs() < 1e-14, "{found:?}");
    assert_eq!(found.mode.0[1], Status::Low);
    // or at the stop, if it comes first
    let found = at_rest(&tilted(0.5, 0.1), [0.0, 0.0]);
    assert_eq!((found.x[0], found.mode.0[0]), (0.1, Status::High));
    // standing is beyond a limit that cannot pull: it falls
    let bowl = Bowl::new(BowlParams::default()).expect("physical");
    let found = at_rest(&bowl, [0.4, 2.0, 0.0, 0.0]);
    assert!((found.x[1] - found.x[0].powi(2)).abs() < 1e-14, "{found:?}");
    // 3 (0.5 - x) = 9.81 * 2 x
    assert!((found.x[0] - 1.5 / (3.0 + 2.0 * 9.81)).abs() < 1e-12, "{found:?}");
}

#[test]
fn a_limit_that_would_have_to_pull_is_left() {
    mechanism! {
        pub Standing {
            gravity: [0, -9.81, 0],
            body rod on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, stop: [-2, 3.05] }
        }
    }
    let standing = Standing::new(StandingParams {}).expect("physical");
    let found = at_rest(&standing, [3.0, 0.0]);
    assert!(found.x[0].abs() < 1e-12, "{found:?}");
}

#[test]
fn what_rests_only_here_has_an_interval_of_a_point() {
    let cart = cart();
    let found = at_rest(&cart, [0.3, 0.0, 0.0, 0.0]);
    let [low, high] = found.interval(&cart, 1, 1.0).expect("a coordinate");
    assert!(low <= 0.0 && 0.0 <= high && high - low < 1e-12, "{low:e} {high:e}");
    assert_eq!(found.interval(&cart, 0, 5.0), Ok([f64::NEG_INFINITY, f64::INFINITY]));
    let refused = |coordinate, reach| {
        let Err(error) = found.interval(&cart, coordinate, reach) else {
            panic!("{coordinate} {reach}")
        };
        error.to_string()
    };
    for coordinate in [2, 3, 4, 17] {
        assert!(
            refused(coordinate, 1.0).contains("index of a coordinate"),
            "{coordinate}"
        );
    }
    for reach in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(refused(1, reach).contains("finite and positive"), "{reach}");
    }
    // a system that is not hybrid
    let smooth = FnSystem::with_jacobian(
        |_t, x: &SVector<f64, 2>| -x,
        |_t, _x: &_| -SMatrix::<f64, 2, 2>::identity(),
    );
    let Err(StabilityError::Integration(reason)) = resting(&smooth, [0.0, 0.0]) else {
        panic!("refused")
    };
    assert!(reason.to_string().contains("only a hybrid system"), "{reason}");
}
