//! Two edges of a tile at once: joints that stick or hit together, and events at only one of them.

use std::f64::consts::PI;

use nalgebra::SVector;
use pendulum_core::hybrid::{Mode, Status};
use pendulum_core::prelude::*;

mechanism! {
    /// A tile that slides on a table, with friction along both edges, into a corner of two walls.
    pub Tile {
        params { mu: N = 1, e: 1 = 1, pull: N = 0 }
        generate: [rhs, jacobian, energy],
        wall east { gap: 1 - x, restitution: e }
        wall north { gap: 1 - y, restitution: e }
        body slide on ground { joint: prismatic(x), coordinate: x, dry_friction: mu, torque: pull }
        body tile on slide { mass: 1, joint: prismatic(y), coordinate: y, dry_friction: mu }
    }
}

pub(crate) fn tile(mu: f64, e: f64, pull: f64) -> Tile {
    Tile::new(TileParams { mu, e, pull }).expect("physical")
}

#[test]
fn both_edges_come_to_rest_at_the_same_instant() {
    let solution = Tsit5::new()
        .solve(&tile(1.0, 1.0, 0.0), 0.0, 3.0, [0.0, 0.0, 1.0, 1.0])
        .expect("a motion");
    assert_eq!(solution.modes().len(), 2);
    let (t, mode) = solution.modes()[1];
    assert!(
        (t - 1.0).abs() < 1e-12 && mode.0[..2] == [Status::Stuck; 2],
        "{t} {mode:?}"
    );
    assert_eq!(solution.end().rows(2, 2), SVector::<f64, 2>::zeros());
}

#[test]
fn a_corner_reverses_both_rates_and_keeps_the_energy() {
    let model = tile(0.0, 1.0, 0.0);
    let solution = Vern9::new()
        .solve(&model, 0.0, 1.0, [0.0, 0.0, 2.0, 2.0])
        .expect("a motion");
    assert_eq!(solution.modes().len(), 2);
    let end = solution.end();
    assert!((end - SVector::from([0.0, 0.0, -2.0, -2.0])).amax() < 1e-14, "{end}");
}

#[test]
fn a_wall_reached_at_rest_is_not_an_impact() {
    // decelerates to rest after 1 m, exactly at the wall
    let model = tile(0.5, 1.0, 0.0);
    for x in [0.0, 1e-14, -1e-14] {
        let solution = Vern7::new()
            .solve(&model, 0.0, 4.0, [x, 0.0, 1.0, 0.0])
            .expect("a motion");
        let end = solution.end();
        assert!((end[0] - 1.0).abs() < 1e-13 && end[2] == 0.0, "{end}");
    }
}

#[test]
fn friction_at_its_limit_holds() {
    let solution = Tsit5::new()
        .solve(&tile(1.0, 0.0, 1.0), 0.0, 4.0, [0.0; 4])
        .expect("a motion");
    assert_eq!(solution.end(), SVector::from([0.0; 4]));
    assert_eq!(solution.modes().len(), 1);
}

#[test]
fn what_grazes_a_wall_goes_on_along_it() {
    let solution = Tsit5::new()
        .solve(&tile(0.0, 1.0, 0.0), 0.0, 4.0, [1.0, -2.0, 0.0, 0.5])
        .expect("a motion");
    assert!(
        (solution.end() - SVector::from([1.0, 0.0, 0.0, 0.5])).amax() < 1e-14,
        "{}",
        solution.end()
    );
}

mechanism! {
    /// A block that sticks in front of a wall that moves to and fro.
    Knocked {
        params { w: rad/s, near: m }
        generate: [rhs, jacobian],
        wall lid { gap: 0.1 m + near - x + 0.1 m*sin(w*t), restitution: 0 }
        body block on ground { mass: 1, joint: prismatic(x), coordinate: x, dry_friction: 5 N }
    }
}

/// Only the wall moves, so steps are as long as the span: it approaches repeatedly between two sampled points.
#[test]
fn a_wall_that_moves_hits_what_sticks() {
    for w in [1.0, 6.0, 7.5, 23.0] {
        let first_hit = |near| {
            let model = Knocked::new(KnockedParams { w, near }).expect("physical");
            let solution = Vern9::new().solve(&model, 0.0, 20.0, [0.0; 2]).expect("a motion");
            solution.modes().get(1).map(|&(t, _)| t)
        };
        let expected = (PI + (1.0 - 1e-3_f64).asin()) / w;
        let hit = first_hit(-1e-4).expect("a hit");
        assert!((hit - expected).abs() < 1e-12, "{hit} {expected}");
        assert_eq!(first_hit(1e-4), None);
    }
}

mechanism! {
    /// A block with friction beside a wall, pressed against it and pulled away in turn.
    Pressed {
        params { mu: N, more: N }
        generate: [rhs, jacobian],
        wall side { gap: 1 - x, restitution: 0 }
        body block on ground {
            mass: 1, joint: prismatic(x), coordinate: x, dry_friction: mu, static_friction: mu + more,
            torque: 2 N*sin(1 rad/s*t),
        }
    }
}

/// Friction holds the force up to its limit, then the wall does: the block rests throughout.
#[test]
fn a_wall_takes_over_from_friction() {
    for more in [0.0, 0.25] {
        let model = Pressed::new(PressedParams { mu: 1.0, more }).expect("physical");
        let leaves = PI + ((1.0 + more) / 2.0).asin();
        for solution in [
            Vern9::new().solve(&model, 0.0, 4.5, [1.0, 0.0]),
            Radau5::new().solve(&model, 0.0, 4.5, [1.0, 0.0]),
        ] {
            let solution = solution.expect("a motion");
            let rests = |(_, mode): &&(f64, Mode)| mode.0[0] == Status::Stuck;
            let resting = solution.modes().iter().take_while(rests).count();
            let (t, mode) = solution.modes()[resting];
            assert!(resting > 1 && (t - leaves).abs() < 1e-12, "{resting}: {t} {mode:?}");
            assert_eq!(mode.0[..2], [Status::Backward, Status::Free]);
        }
    }
}
