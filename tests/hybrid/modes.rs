//! Ends of modes and their successors, in closed form: friction that breaks loose, contacts that open, limits reached
//! at rest or grazed, and simultaneous events.

use std::f64::consts::PI;

use nalgebra::SVector;
use pendulum_core::hybrid::{Mode, Status};
use pendulum_core::prelude::*;
use pendulum_core::{Canonical, Solution, TaylorSeries};

mechanism! {
    /// A block on a straight track between two stops, under a force that grows.
    pub Track {
        generate: [rhs, jacobian, energy, taylor, canonical],
        params { mu: N = 0, at_rest: N = 0, pull: N = 0, growth: N/s = 0, low: m = -1, high: m = 1, e: 1 = 0 }
        body block on ground {
            mass: 1, joint: prismatic(x), coordinate: s, torque: pull + growth*t,
            dry_friction: mu, static_friction: at_rest, stop: [low, high] restitution(e),
        }
    }
}

fn track(params: TrackParams) -> Track {
    Track::new(params).expect("physical")
}

/// Motion by methods of all kinds, at a tolerance of 1e-13 if the method is adaptive.
fn by_each<S, const N: usize>(model: &S, t1: f64, start: [f64; N]) -> [(&'static str, Solution<f64, N>); 8]
where
    S: Jacobian<f64, N> + TaylorSeries<f64, N> + Canonical<f64, N>,
{
    macro_rules! by {
        ($($method:ident $given:expr),*) => {
            [$((stringify!($method), $given.solve(model, 0.0, t1, start).expect(stringify!($method)))),*]
        };
    }
    macro_rules! tight {
        ($method:ident) => {
            $method::new().rtol(1e-13).atol(1e-13)
        };
    }
    by!(
        Rk4 Rk4::new(1.0 / 64.0), Tsit5 tight!(Tsit5), Vern9 tight!(Vern9), Rodas5P tight!(Rodas5P),
        Radau5 tight!(Radau5), Auto tight!(Auto), Taylor tight!(Taylor),
        Gauss6 Gauss6::new(1.0 / 64.0)
    )
}

/// Mode switches after the start: their times, and the new modes.
fn changes<const N: usize>(solution: &Solution<f64, N>) -> Vec<(f64, Mode)> {
    solution.modes()[1..].to_vec()
}

#[track_caller]
fn assert_near(ours: f64, theirs: f64, allowed: f64, what: &str) {
    let error = (ours - theirs).abs();
    assert!(error <= allowed, "{what}: {ours:e}, not {theirs:e}, {error:e} apart");
}

#[track_caller]
fn assert_state<const N: usize>(ours: SVector<f64, N>, theirs: [f64; N], allowed: f64, what: &str) {
    let error = (ours - SVector::from(theirs)).amax();
    assert!(error <= allowed, "{what}: {ours} for {theirs:?}, {error:e} apart");
}

// Growing forces

#[test]
fn friction_at_rest_breaks_loose_when_a_growing_force_reaches_it() {
    let (mu, at_rest, growth) = (1.5, 2.0, 0.5);
    for side in [1.0, -1.0] {
        let growth = side * growth;
        let model = track(TrackParams {
            mu,
            at_rest,
            growth,
            ..TrackParams::default()
        });
        let (breaks, t) = (at_rest / growth.abs(), 5.0_f64);
        let since = t - breaks;
        // integrals of `growth t - mu`
        let rate = 0.5 * growth.abs() * (t * t - breaks * breaks) - mu * since;
        let place = growth.abs() / 6.0 * (t.powi(3) - breaks.powi(3))
            - 0.5 * growth.abs() * breaks * breaks * since
            - 0.5 * mu * since * since;
        for (name, solution) in by_each(&model, t, [0.0; 2]) {
            let changes = changes(&solution);
            assert_eq!(changes.len(), 1, "{name}");
            assert_near(changes[0].0, breaks, 1e-12, name);
            let slips = if side > 0.0 { Status::Forward } else { Status::Backward };
            assert_eq!(changes[0].1.0[0], slips, "{name}");
            assert_eq!(
                solution.at(0.9 * breaks).expect("inside"),
                SVector::from([0.0; 2]),
                "{name}"
            );
            assert_state(solution.end(), [side * place, side * rate], 1e-12, name);
        }
    }
}

/// A force that grows from zero opens the contact at once; one that pushes at first opens it when its sign changes.
#[test]
fn a_contact_opens_when_nothing_pushes_any_longer() {
    for (side, opens) in [(1.0, 0.0), (-1.0, 0.0), (1.0, 1.5), (-1.0, 1.5)] {
        let growth = 0.5;
        let model = track(TrackParams {
            pull: -side * growth * opens,
            growth: side * growth,
            e: 1.0,
            ..TrackParams::default()
        });
        for (name, solution) in by_each(&model, opens + 2.0, [-side, 0.0]) {
            let changes = changes(&solution);
            assert_eq!(changes.len(), 1, "{name} {changes:?}");
            assert_near(changes[0].0, opens, 1e-12, name);
            assert_eq!(changes[0].1.0[0], Status::Free, "{name}");
            let end = [side * (-1.0 + growth * 8.0 / 6.0), side * 0.5 * growth * 4.0];
            assert_state(solution.end(), end, 1e-12, name);
        }
    }
}

mechanism! {
    /// A pendulum that hangs at a wall, with all values zero: no value gives a scale for rounding errors.
    pub Hanging {
        params { growth: N m/s = 0.5 }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, taylor, canonical],
        point tip on bob at [0, -1, 0],
        wall side { gap: tip.x }
        body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, torque: growth*t }
    }
}

#[test]
fn a_contact_at_zero_opens_at_once() {
    let model = Hanging::new(HangingParams::default()).expect("physical");
    for (name, solution) in by_each(&model, 1.0, [0.0; 2]) {
        let changes = changes(&solution);
        assert_eq!(changes.len(), 1, "{name} {changes:?}");
        assert_near(changes[0].0, 0.0, 1e-15, name);
        assert_eq!(changes[0].1.0[0], Status::Free, "{name}");
        let x = solution.at(0.1).expect("inside");
        assert_near(x[0], 0.5 * 0.1_f64.powi(3) / 6.0, 1e-6, name);
    }
}

#[test]
fn what_stands_at_a_stop_under_no_force_stays_there() {
    for (mu, side) in [(0.0, 1.0), (0.0, -1.0), (0.5, 1.0), (0.5, -1.0)] {
        let model = track(TrackParams {
            mu,
            at_rest: mu,
            e: 1.0,
            ..TrackParams::default()
        });
        for (name, solution) in by_each(&model, 3.0, [side, 0.0]) {
            assert_eq!(solution.modes().len(), 1, "{name}");
            assert!(solution.modes()[0].1.is_held(0), "{name}");
            assert_eq!(solution.end(), SVector::from([side, 0.0]), "{name}");
        }
    }
}

/// A joint that sticks at its stop: friction helps against a force that pulls it off.
#[test]
fn friction_holds_what_a_growing_force_pulls_off_a_stop() {
    let (mu, at_rest, growth) = (0.5, 0.75, 0.5);
    for side in [1.0, -1.0] {
        let model = track(TrackParams {
            mu,
            at_rest,
            growth: -side * growth,
            ..TrackParams::default()
        });
        let (breaks, t) = (at_rest / growth, 2.5_f64);
        let rate = 0.5 * growth * (t * t - breaks * breaks) - mu * (t - breaks);
        for (name, solution) in by_each(&model, t, [side, 0.0]) {
            let changes = changes(&solution);
            assert_eq!(changes.len(), 1, "{name}");
            assert_near(changes[0].0, breaks, 1e-12, name);
            assert_near(solution.end()[1], -side * rate, 1e-12, name);
        }
    }
}

mechanism! {
    /// A block moved to and fro by a force.
    pub Shaken {
        generate: [rhs, jacobian, energy, taylor, canonical],
        params { mu: N = 0.9, most: N = 1 }
        body block on ground {
            mass: 1, joint: prismatic(x), coordinate: s, torque: most*sin(1 rad/s*t), dry_friction: mu,
        }
    }
}

/// A force that exceeds the limit only briefly is found within a step, although steps at rest are long.
#[test]
fn a_short_peak_of_a_force_breaks_friction_loose() {
    for (mu, t1) in [(0.9, 2.5), (0.99, 2.5), (0.99, 10.0)] {
        let model = Shaken::new(ShakenParams { mu, most: 1.0 }).expect("physical");
        let breaks = f64::asin(mu);
        for (name, solution) in by_each(&model, t1, [0.0; 2]) {
            assert_near(changes(&solution)[0].0, breaks, 1e-12, name);
        }
    }
}

// Limits reached at rest, and grazed

#[test]
fn a_stop_is_reached_at_rest() {
    for side in [1.0, -1.0] {
        // stopped by friction, which then holds
        let model = track(TrackParams {
            mu: 0.5,
            at_rest: 0.5,
            e: 1.0,
            ..TrackParams::default()
        });
        for (name, solution) in by_each(&model, 4.0, [0.0, side]) {
            assert_state(solution.end(), [side, 0.0], 1e-13, name);
            assert_eq!(solution.end()[1], 0.0, "{name}");
            assert_near(solution.modes().last().expect("a mode").0, 2.0, 1e-7, name);
        }
        // turned back by a force
        let model = track(TrackParams {
            pull: -0.5 * side,
            e: 1.0,
            ..TrackParams::default()
        });
        for (name, solution) in by_each(&model, 3.0, [0.0, side]) {
            assert_state(solution.end(), [0.75 * side, -0.5 * side], 1e-7, name);
        }
    }
}

#[test]
fn rebounds_end_at_their_stop_to_the_last_bit() {
    let (height, pull) = (0.7, 9.0);
    let fall = (2.0_f64 * height / pull).sqrt();
    for (side, e) in [(1.0, 0.0), (-1.0, 0.0), (1.0, 0.5), (-1.0, 0.5)] {
        let [low, high] = if side > 0.0 { [-1.0, 0.0] } else { [0.0, 1.0] };
        let model = track(TrackParams {
            pull: side * pull,
            low,
            high,
            e,
            ..TrackParams::default()
        });
        for (name, solution) in by_each(&model, 2.0, [-side * height, 0.0]) {
            assert_eq!(solution.end(), SVector::from([0.0; 2]), "{name}");
            let (rests, _) = *solution.modes().last().expect("a mode");
            assert_near(rests, fall * (1.0 + 2.0 * e / (1.0 - e)), 1e-12, name);
            let beyond = solution.x().iter().map(|x| side * x[0]).fold(0.0, f64::max);
            assert!(beyond < 1e-14, "{name}: {beyond:e}");
        }
    }
}

mechanism! {
    /// A stone under a ceiling.
    pub Thrown {
        generate: [rhs, jacobian, energy, taylor, canonical],
        params { top: m = 1, e: 1 = 0.5 }
        gravity: [0, -9.81, 0],
        point head on stone,
        wall ceiling { gap: top - head.y, restitution: e }
        body across on ground { joint: prismatic(x), coordinate: x }
        body stone on across { mass: 1, joint: prismatic(y), coordinate: y }
    }
}

#[test]
fn a_parabola_grazes_a_ceiling() {
    let (rises, t) = ((2.0 * 9.81_f64).sqrt(), 0.8);
    let free = rises * t - 0.5 * 9.81 * t * t;
    let falls = rises - 9.81 * t;
    for gap in [1e-9, -1e-9, 0.0] {
        let model = Thrown::new(ThrownParams { top: 1.0 + gap, e: 0.5 }).expect("physical");
        for (name, solution) in by_each(&model, t, [0.0, 0.0, 3.0, rises]) {
            let what = format!("{name}, {gap:e} below");
            let impacts = changes(&solution).len();
            if gap > 0.0 {
                assert_eq!(impacts, 0, "{what}");
                assert_state(solution.end(), [3.0 * t, free, 3.0, falls], 1e-12, &what);
            } else if gap < 0.0 {
                assert_eq!(impacts, 1, "{what}");
                let at = (2.0 * -gap * 9.81).sqrt();
                let (hits, since) = ((rises - at) / 9.81, t - (rises - at) / 9.81);
                let back = -0.5 * at;
                let end = [
                    3.0 * t,
                    1.0 + gap + back * since - 0.5 * 9.81 * since * since,
                    3.0,
                    back - 9.81 * since,
                ];
                // heights have errors of some ulps, which take this time at the rate of 1.4e-4 m/s
                assert_near(changes(&solution)[0].0, hits, 1e-10, &what);
                assert_state(solution.end(), end, 1e-9, &what);
            } else {
                // errors of 1e-13 m decide if it touches, at the rate that corresponds to this height
                assert!(impacts <= 1, "{what}");
                let least = (2.0 * 9.81 * 1e-13_f64).sqrt();
                assert_state(solution.end(), [3.0 * t, free, 3.0, falls], 1.5 * least, &what);
            }
        }
    }
}

mechanism! {
    /// A pendulum whose tip swings up to a wall.
    pub Grazing {
        generate: [rhs, jacobian, energy, taylor, canonical],
        params { room: m, e: 1 = 0.5 }
        gravity: [0, -9.81, 0],
        point tip on bob at [0, -1, 0],
        wall side { gap: room - tip.x, restitution: e }
        body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a }
    }
}

#[test]
fn a_pendulum_grazes_a_wall() {
    let swing = 0.5_f64;
    for gap in [1e-9, -1e-9, 0.0] {
        let model = Grazing::new(GrazingParams {
            room: swing.sin() + gap,
            e: 0.5,
        })
        .expect("physical");
        for (name, solution) in by_each(&model, 1.2, [-swing, 0.0]) {
            let what = format!("{name}, {gap:e} below");
            let impacts = changes(&solution).len();
            let energy = model.energy(0.0, &solution.end()) - model.energy(0.0, &[-swing, 0.0]);
            let (count, lost) = match gap {
                gap if gap > 0.0 => (0..=0, 0.0),
                gap if gap < 0.0 => (1..=1, 0.75 * 9.81 * 1e-9 * swing.tan()),
                _ => (0..=1, 0.0),
            };
            // the fixed steps have errors larger than the gap
            if name != "Rk4" {
                assert!(count.contains(&impacts), "{what}: {impacts}");
                assert_near(energy, -lost, 1e-11, &what);
            }
        }
    }
}

// Simultaneous events

mechanism! {
    /// Two blocks side by side, one with friction and the other with a stop.
    pub Apart {
        generate: [rhs, jacobian, energy, taylor, canonical],
        body first on ground { mass: 1, joint: prismatic(x), coordinate: a, dry_friction: 0.5 }
        body second on ground { mass: 3, joint: prismatic(x), coordinate: b, stop: [-1, 1] restitution(0.5) }
    }
}

#[test]
fn one_sticks_at_the_instant_at_which_another_rebounds() {
    let model = Apart::new(ApartParams {}).expect("physical");
    for side in [1.0, -1.0] {
        for (name, solution) in by_each(&model, 3.0, [0.0, 0.0, side, 0.5 * side]) {
            let changes = changes(&solution);
            assert_eq!(changes.len(), 1, "{name}");
            assert_near(changes[0].0, 2.0, 1e-12, name);
            assert_eq!(changes[0].1.0[..2], [Status::Stuck, Status::Free], "{name}");
            assert_state(solution.end(), [side, 0.75 * side, 0.0, -0.25 * side], 1e-12, name);
        }
    }
}

mechanism! {
    /// A block in a box that itself slides between stops, 1 kg each.
    pub Boxed {
        generate: [rhs, jacobian, energy, taylor, canonical],
        params { e: 1 = 0.5, inner_e: 1 = 0.5, pull: N = 0, inner: N = 0 }
        body outer on ground {
            mass: 1, joint: prismatic(x), coordinate: a, torque: pull, stop: [-1, 1] restitution(e),
        }
        body block on outer {
            mass: 1, joint: prismatic(x), coordinate: b, torque: inner, stop: [-1, 1] restitution(inner_e),
        }
    }
}

/// The box hits its upper stop and the block its lower one, or the reverse.
#[test]
fn two_impacts_at_one_instant() {
    let (e, inner_e) = (0.25, 0.75);
    let model = Boxed::new(BoxedParams {
        e,
        inner_e,
        ..BoxedParams::default()
    })
    .expect("physical");
    let cases = [
        // both contacts push: each opens with the smaller restitution
        ([1.0, -1.5], [-e, 1.5 * e]),
        // the impact of the box lifts the block off, since its stop cannot pull
        ([1.0, -0.5], [-e, -0.5 + 1.0 + e]),
    ];
    for side in [1.0, -1.0] {
        for (before, after) in cases {
            let start = [1.0, -1.0, before[0], before[1]].map(|x| side * x);
            let t = 0.5;
            let end = [1.0 + t * after[0], -1.0 + t * after[1], after[0], after[1]].map(|x| side * x);
            for (name, solution) in by_each(&model, t, start) {
                assert_eq!(solution.modes().len(), 1, "{name}");
                assert_state(solution.end(), end, 1e-14, name);
            }
        }
    }
}

/// Alone, the box would be pressed against its lower stop; the block, which presses upwards, takes it along.
#[test]
fn of_two_contacts_one_opens() {
    for side in [1.0, -1.0] {
        let (pull, inner) = (0.8 * side, 0.9 * side);
        let model = Boxed::new(BoxedParams {
            pull,
            inner,
            ..BoxedParams::default()
        })
        .expect("physical");
        for (name, solution) in by_each(&model, 2.0, [-side, side, 0.0, 0.0]) {
            assert_eq!(solution.modes().len(), 1, "{name}");
            let rate = 0.5 * 0.8 * 2.0;
            assert_state(
                solution.end(),
                [side * (rate - 1.0), side, side * rate, 0.0],
                1e-12,
                name,
            );
        }
    }
}

/// A body that hits a stop without restitution and without force stays there exactly.
#[test]
fn an_impact_without_restitution_ends_at_rest() {
    for side in [1.0, -1.0] {
        let model = Boxed::new(BoxedParams {
            e: 0.0,
            inner_e: 0.0,
            ..BoxedParams::default()
        })
        .expect("physical");
        for (name, solution) in by_each(&model, 3.0, [0.1, 0.0, 0.7 * side, -0.7 * side]) {
            let end = solution.end();
            assert_eq!([end[0], end[2]], [side, 0.0], "{name}");
        }
    }
}

mechanism! {
    /// Two blocks on one rough track; the first may run into the second.
    pub Chain {
        generate: [rhs, jacobian, energy, taylor, canonical],
        params { m: kg = 1, mu: N = 0.5, at_rest: N = 0.75, e: 1 = 1 }
        wall between { gap: b - a - 0.5, restitution: e }
        body first on ground {
            mass: m, joint: prismatic(x), coordinate: a, dry_friction: mu, static_friction: at_rest,
        }
        body second on ground {
            mass: 1, joint: prismatic(x), coordinate: b, dry_friction: mu, static_friction: at_rest,
        }
    }
}

/// The second block sticks until the first runs into it.
#[test]
fn an_impact_breaks_loose_what_sticks() {
    for (m, e) in [(1.0, 1.0), (2.0, 0.5), (0.5, 0.25)] {
        let (mu, gap, v) = (0.5, 1.0, 2.0_f64);
        let model = Chain::new(ChainParams {
            m,
            mu,
            at_rest: 0.75,
            e,
        })
        .expect("physical");
        let braked = mu / m;
        let arrives = (v * v - 2.0 * braked * gap).sqrt();
        let hits = (v - arrives) / braked;
        let together = m * arrives / (m + 1.0);
        let (first, second) = (
            together - e * arrives / (m + 1.0),
            together + m * e * arrives / (m + 1.0),
        );
        let place = |rate: f64, braked: f64| rate * rate.abs() / (2.0 * braked);
        let end = [gap + place(first, braked), gap + 0.5 + place(second, mu), 0.0, 0.0];
        let rests = [first.abs() / braked, second / mu].map(|time| hits + time);
        for (name, solution) in by_each(&model, rests[0].max(rests[1]) + 0.1, [0.0, gap + 0.5, v, 0.0]) {
            let what = format!("{name}, {m} kg, {e}");
            let modes = solution.modes();
            assert_eq!(
                modes[0].1.0[..3],
                [Status::Forward, Status::Stuck, Status::Free],
                "{what}"
            );
            assert_near(modes[1].0, hits, 1e-12, &what);
            let after = if first == 0.0 || (first.abs() < 1e-15) {
                Status::Stuck
            } else if first > 0.0 {
                Status::Forward
            } else {
                Status::Backward
            };
            assert_eq!(modes[1].1.0[..3], [after, Status::Forward, Status::Free], "{what}");
            assert_near(modes.last().expect("a mode").0, rests[0].max(rests[1]), 1e-12, &what);
            assert_state(solution.end(), end, 1e-12, &what);
            assert_eq!(solution.end().rows(2, 2), SVector::<f64, 2>::zeros(), "{what}");
        }
    }
}

mechanism! {
    /// A tile in a corner, with one wall declared twice.
    pub Twice {
        generate: [rhs, jacobian, energy, taylor, canonical],
        params { pull: N = 0 }
        wall east { gap: 1 - x, restitution: 1 }
        wall east_again { gap: 2 m - 2*x, restitution: 1 }
        wall north { gap: 1 - y, restitution: 1 }
        body slide on ground { joint: prismatic(x), coordinate: x, torque: pull }
        body tile on slide { mass: 1, joint: prismatic(y), coordinate: y, torque: pull }
    }
}

#[test]
fn a_wall_that_is_declared_twice_is_one() {
    let model = Twice::new(TwiceParams { pull: 0.0 }).expect("physical");
    for (name, solution) in by_each(&model, 2.0, [0.0, 0.5, 1.0, 0.5]) {
        assert_state(solution.end(), [0.0, 0.5, -1.0, -0.5], 1e-12, name);
    }
    let model = Twice::new(TwiceParams { pull: 1.0 }).expect("physical");
    for (name, solution) in by_each(&model, 1.0, [1.0, 1.0, 0.0, 0.0]) {
        assert_eq!(solution.modes()[0].1.0[..3], [Status::Low; 3], "{name}");
        assert_state(solution.end(), [1.0, 1.0, 0.0, 0.0], 0.0, name);
    }
}

mechanism! {
    /// Two point masses on massless rods, beside a wall.
    pub TwoPoints {
        generate: [rhs, jacobian, energy, taylor, canonical],
        gravity: [0, -9.81, 0],
        point elbow on upper at [0, -1, 0],
        point tip on lower at [0, -1, 0],
        wall beside_elbow { gap: elbow.x, restitution: 0.1 }
        wall beside_tip { gap: tip.x, restitution: 0.1 }
        body upper on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a }
        body lower on upper {
            mass: 1, com: [0, -1, 0], joint: revolute(z) at [0, -1, 0], coordinate: b absolute,
        }
    }
}

/// F. A. Potra, M. Anitescu, B. Gavrea, J. Trinkle, "A linearly implicit trapezoidal method for integrating stiff
/// multibody dynamics with contact, joints, and friction", Int. J. Numer. Meth. Eng. 66 (2006) 1079-1124, as shown in
/// the validation manual of Solfec 1.0: read off the curve of the energy, to 0.004 s and 0.03 J.
#[test]
fn a_published_pendulum_hits_its_wall_when_and_as_hard_as_it_should() {
    let model = TwoPoints::new(TwoPointsParams {}).expect("physical");
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 2.5, [PI / 3.0, PI / 5.0, 0.0, 0.0]);
    let solution = solution.expect("a motion");
    let least = model.energy(0.0, &SVector::from([0.0; 4]));
    let energy = |t: f64| model.energy(t, &solution.at(t).expect("inside")) - least;
    let published = [
        (0.546, 9.04),
        (0.707, 0.92),
        (1.283, 0.67),
        (2.096, 0.54),
        (2.131, 0.01),
    ];
    let changes = changes(&solution);
    assert_eq!(changes.len(), published.len());
    assert_near(energy(0.0), 11.69, 0.03, "energy at the start");
    for (&(t, _), (read, left)) in changes.iter().zip(published) {
        assert_near(t, read, 0.004, "impact");
        assert_near(energy(t + 0.01), left, 0.03, "energy after it");
    }
}

/// A reset may set a sticking block in motion, or throw it against its stop.
#[test]
fn a_reset_begins_another_mode() {
    let model = track(TrackParams {
        mu: 0.5,
        at_rest: 0.5,
        e: 0.5,
        ..TrackParams::default()
    });
    for (to, mode, rests) in [
        ([0.0, 0.5], Status::Forward, [0.25, 2.0]),
        ([1.0, 1.0], Status::Backward, [0.75, 2.0]),
        ([-1.0, 0.0], Status::Low, [-1.0, 1.0]),
    ] {
        let kick = Event::new(|t, _: &SVector<f64, 2>| t - 1.0).reset(move |_, _| to.into());
        let solution = Tsit5::new()
            .rtol(1e-13)
            .atol(1e-13)
            .solve_with(&model, 0.0, 4.0, [0.0; 2], &[kick]);
        let solution = solution.expect("a motion");
        let (first, after) = (solution.modes()[0].1.0[0], solution.modes()[1]);
        assert_eq!((first, after.1.0[0]), (Status::Stuck, mode), "{to:?}");
        assert_near(after.0, 1.0, 1e-12, "the reset");
        assert_near(solution.modes().last().expect("a mode").0, rests[1], 1e-12, "at rest");
        assert_state(solution.end(), [rests[0], 0.0], 1e-12, "at the end");
    }
}

mechanism! {
    /// A block that sticks for long, and breaks loose once.
    pub Swelling {
        generate: [rhs, jacobian, energy, taylor, canonical],
        params { k: N/s = 0.02, w: rad/s = 1, limit: N = 0.9 }
        body block on ground {
            mass: 1, joint: prismatic(x), coordinate: s, torque: k*t*sin(w*t), dry_friction: limit,
        }
    }
}

/// The holding force is a growing wave that first reaches 0.9 N at 45.417 s, where steps at rest would be long.
#[test]
fn what_rests_breaks_loose_the_first_time_that_its_force_is_too_large() {
    let model = Swelling::new(SwellingParams::default()).expect("physical");
    let mut t = 45.4;
    for _ in 0..20 {
        let (sine, cosine) = f64::sin_cos(t);
        t -= (0.02 * t * sine - 0.9) / (0.02 * sine + 0.02 * t * cosine);
    }
    macro_rules! check {
        ($($method:expr),*) => {$(
            let solution = $method.solve(&model, 0.0, 60.0, [0.0, 0.0]).expect("a motion");
            let breaks = solution.modes().get(1).map_or(f64::NAN, |(t, _)| *t);
            assert!((breaks - t).abs() < 1e-9, "{}: {breaks}, not {t}", stringify!($method));
        )*};
    }
    check!(
        Tsit5::new(),
        Vern7::new(),
        Vern9::new(),
        Rodas5P::new(),
        Radau5::new(),
        Auto::new(),
        Rk4::new(0.05)
    );
}

// Impacts

mechanism! {
    /// A ball of 2 kg on a floor.
    pub Bouncing {
        params { e: 1 = 0.5 }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, taylor, canonical],
        wall floor { gap: y, restitution: e }
        body ball on ground { mass: 2, joint: prismatic(y), coordinate: y }
    }
}

/// Each impulse is the mass times the change of the rate, and each rate is the one before times the restitution.
#[test]
fn impacts_of_a_ball_are_known() {
    let e = 0.5;
    let model = Bouncing::new(BouncingParams { e }).expect("physical");
    let (hits, falls) = ((2.0 / 9.81_f64).sqrt(), (2.0 * 9.81_f64).sqrt());
    for (name, solution) in by_each(&model, 2.0, [1.0, 0.0]) {
        // further rebounds are lower than 1e-13 m; the last one followed ends them all
        let impacts = solution.impacts();
        assert!(impacts.len() > 15, "{name}: {}", impacts.len());
        assert_eq!(solution.modes().len(), impacts.len() + 1, "{name}");
        let (mut t, mut rate) = (hits, falls);
        for (n, impact) in impacts.iter().enumerate() {
            let left = if n + 1 < impacts.len() { e * rate } else { 0.0 };
            assert_near(impact.t, t, 1e-12, name);
            assert_state(impact.before, [0.0, -rate], 1e-12, name);
            assert_state(impact.after, [0.0, left], 1e-12, name);
            let pushes: Vec<_> = impact.pushes().collect();
            assert_eq!((pushes.len(), pushes[0].0), (1, 0), "{name}");
            assert_near(pushes[0].1, 2.0 * (rate + left), 1e-11, name);
            let place = solution.t().iter().position(|&t| t == impact.t).expect("a point");
            assert_eq!(solution.x()[place..place + 2], [impact.before, impact.after], "{name}");
            (t, rate) = (t + 2.0 * left / 9.81, left);
        }
    }
}

/// Two simultaneous impacts are one, with an impulse for each wall. Impacts at the start and after a reset are
/// recorded.
#[test]
fn impacts_at_once_at_the_start_and_after_a_reset_are_recorded() {
    let model = Twice::new(TwiceParams { pull: 0.0 }).expect("physical");
    for (name, solution) in by_each(&model, 1.5, [0.0, 0.0, 1.0, 1.0]) {
        let [impact] = solution.impacts() else {
            panic!("{name}: {:?}", solution.impacts())
        };
        assert_near(impact.t, 1.0, 1e-13, name);
        assert_state(impact.after, [1.0, 1.0, -1.0, -1.0], 1e-13, name);
        // a wall declared twice pushes once
        let pushes: Vec<_> = impact.pushes().collect();
        assert_eq!(pushes.iter().map(|(n, _)| *n).collect::<Vec<_>>(), [0, 2], "{name}");
        assert!(
            pushes.iter().all(|(_, impulse)| (impulse - 2.0).abs() < 1e-13),
            "{name}"
        );
    }
    let thrown = [1.0, 0.0, 1.0, 0.5];
    for (name, solution) in by_each(&model, 1.5, thrown) {
        let [impact] = solution.impacts() else {
            panic!("{name}: {:?}", solution.impacts())
        };
        assert_eq!((impact.t, impact.before), (0.0, thrown.into()), "{name}");
        assert_eq!(solution.t()[..2], [0.0; 2], "{name}");
        assert_eq!(solution.x()[..2], [impact.before, impact.after], "{name}");
        assert_state(solution.end(), [-0.5, 0.75, -1.0, 0.5], 1e-13, name);
        assert_state(solution.at(1.0).expect("inside"), [0.0, 0.5, -1.0, 0.5], 1e-13, name);
    }
    let kick = Event::new(|t, _: &SVector<f64, 4>| t - 1.0).reset(move |_, _| thrown.into());
    let solution = Tsit5::new().solve_with(&model, 0.0, 2.5, [-0.5, 0.0, 0.0, 0.0], &[kick]);
    let solution = solution.expect("a motion");
    let [impact] = solution.impacts() else {
        panic!("{:?}", solution.impacts())
    };
    assert_eq!(impact.before, SVector::from(thrown));
    assert_state(impact.after, [1.0, 0.0, -1.0, 0.5], 1e-13, "after the reset");
    assert_state(
        solution.at(2.5).expect("inside"),
        [-0.5, 0.75, -1.0, 0.5],
        1e-12,
        "at the end",
    );
    assert_state(
        solution.at(1.5).expect("inside"),
        [0.5, 0.25, -1.0, 0.5],
        1e-12,
        "after it",
    );
}

mechanism! {
    /// Two balls on separate floors.
    pub Unjoined {
        params { e: 1 = 0.8 }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, taylor, canonical],
        body first on ground { mass: 1, joint: prismatic(y), coordinate: y, stop: [0 m, 10 m] restitution(e) }
        body second on ground { mass: 3, joint: prismatic(y), coordinate: z, stop: [0 m, 10 m] restitution(0) }
    }
}

#[test]
fn impacts_at_once_keep_their_restitutions_where_nothing_joins_them() {
    let e = 0.8;
    let model = Unjoined::new(UnjoinedParams { e }).expect("physical");
    let (hits, falls) = ((2.0 / 9.81_f64).sqrt(), (2.0 * 9.81_f64).sqrt());
    for (name, solution) in by_each(&model, 0.8, [1.0, 1.0, 0.0, 0.0]) {
        let [impact] = solution.impacts() else {
            panic!("{name}: {:?}", solution.impacts())
        };
        assert_near(impact.t, hits, 1e-12, name);
        assert_state(impact.after, [0.0, 0.0, e * falls, 0.0], 1e-12, name);
        assert_eq!((solution.end()[1], solution.end()[3]), (0.0, 0.0), "{name}");
    }
}

mechanism! {
    /// Three balls of 0.2 m on a rail.
    pub Rail {
        params { e: 1 = 0.5 }
        generate: [rhs, jacobian, energy, taylor, canonical],
        wall left { gap: b - a - 0.2 m, restitution: e }
        wall right { gap: c - b - 0.2 m, restitution: e }
        body first on ground { mass: 1, joint: prismatic(x), coordinate: a }
        body second on ground { mass: 1, joint: prismatic(x), coordinate: b }
        body third on ground { mass: 1, joint: prismatic(x), coordinate: c }
    }
}

/// Rounding errors separate no two bodies that arrive simultaneously from both sides.
#[test]
fn two_that_meet_a_third_at_once_do_so_at_once() {
    let e = 0.5;
    let model = Rail::new(RailParams { e }).expect("physical");
    for n in 0..40 {
        let n = f64::from(n);
        let (hits, [v, w]) = (1.0 + 0.0137 * n, [0.3 + 0.071 * n, 2.9 - 0.043 * n]);
        let start = [-0.2 - v * hits, 0.0, 0.2 + w * hits, v, 0.0, -w];
        // both gaps open at `e` times their closing rate, and momentum is conserved
        let middle = (v - w) / 3.0 * (1.0 + e);
        let after = [middle - e * v, middle, middle + e * w];
        for (name, solution) in by_each(&model, hits + 1.0, start) {
            let [impact] = solution.impacts() else {
                panic!("{name}, {n}: {:?}", solution.impacts())
            };
            assert_near(impact.t, hits, 1e-13, name);
            let end = [after[0] - 0.2, after[1], after[2] + 0.2, after[0], after[1], after[2]];
            assert_state(solution.end(), end, 1e-12, name);
        }
    }
}

mechanism! {
    /// A block under an oscillating force.
    pub Pushed {
        params { push: N = 0.6 }
        generate: [rhs, jacobian, energy, taylor, canonical],
        body block on ground {
            mass: 1, joint: prismatic(x), coordinate: s, torque: push*sin(1 rad/s*t), dry_friction: 0.5,
                static_friction: 0.6,
        }
    }
}

/// A force at the limit, up to rounding errors, is held; a larger one is not.
#[test]
fn friction_holds_up_to_its_limit() {
    for (push, holds) in [(0.6, true), (0.6 * (1.0 + 1e-15), true), (0.6 * (1.0 + 1e-9), false)] {
        let model = Pushed::new(PushedParams { push }).expect("physical");
        for (name, solution) in by_each(&model, 12.0, [0.0; 2]) {
            assert_eq!(solution.modes().len() == 1, holds, "{name}: {:?}", solution.modes());
        }
    }
}

/// Rebounds end at the resolution of single precision: they are up to 64 ulps of a metre high, and each ends up to 16
/// ulps, or 1.6e-4 s, away.
#[test]
fn a_ball_in_single_precision_comes_to_rest() {
    for (e, rests) in [(0.3_f32, 0.838_543_9), (0.7, 2.558_634), (0.9, 8.578_949)] {
        let model = Bouncing::new(BouncingParams { e: f64::from(e) }).expect("physical");
        let model = model.cast::<f32>();
        macro_rules! assert_rests {
            ($($method:expr),*) => { $(
                let solution = $method.solve(&model, 0.0, 10.0, [1.0, 0.0]).expect("a motion");
                let rest = solution.modes().last().expect("a mode").0;
                assert!(solution.impacts().len() < 70, "{e}: {}", solution.impacts().len());
                assert!((rest - rests).abs() < 1.6e-4, "{e}: {rest} {rests}");
                assert_eq!(solution.end(), SVector::from([0.0, 0.0]), "{e}");
            )* };
        }
        assert_rests!(Rk4::new(0.01), Tsit5::new(), Vern7::new(), Vern9::new(), Rodas5P::new());
    }
}

mechanism! {
    /// A rod of 1 m in a box of 1.6 m.
    pub InABox {
        gravity: [0, -9.81, 0],
        point left on rod at [-0.5, 0, 0], point right on rod at [0.5, 0, 0],
        wall floor_left { gap: left.y } wall floor_right { gap: right.y }
        wall near_left { gap: left.x + 0.8 } wall near_right { gap: 0.8 - right.x }
        wall far_left { gap: right.x + 0.8 } wall far_right { gap: 0.8 - left.x }
        body across on ground { joint: prismatic(x), coordinate: x }
        body up on across { joint: prismatic(y), coordinate: y }
        body rod on up { solids: [rod(1, [-0.5, 0, 0], [0.5, 0, 0])], joint: revolute(z), coordinate: turn }
    }
}

/// The rod ends upright in a corner, where the wall carries no force.
#[test]
fn contacts_without_a_force_stay_as_they_are() {
    let model = InABox::new(InABoxParams {}).expect("physical");
    let start = [
        0.225_188_270_503_441_6,
        1.145_629_611_831_863_8,
        -2.645_559_130_922_957_4,
        -1.552_597_932_259_590_6,
        2.633_735_633_758_805,
        1.659_046_269_445_624,
    ];
    for n in 0..40 {
        let mut start = start;
        start[2] += 1e-13 * f64::from(n);
        let solution = Vern7::new().solve(&model, 0.0, 4.0, start).expect("it comes to rest");
        let end = solution.end();
        assert!(
            (end[1] - 0.5).abs() < 1e-12 && end.rows(3, 3).amax() < 1e-6,
            "{n}: {end}"
        );
        assert!(solution.modes().len() < 100, "{n}: {}", solution.modes().len());
    }
}

mechanism! {
    /// A ball on a slope, whose gap is in units of `scale`.
    pub Scaled {
        params { scale: 1 = 1 }
        gravity: [0, -9.81, 0],
        wall plane { gap: scale*(cos(0.35)*y + sin(0.35)*x), restitution: 0.6 }
        body slide on ground { joint: prismatic(x), coordinate: x }
        body ball on slide { mass: 0.7, joint: prismatic(y), coordinate: y }
    }
}

/// Every point of a motion is a valid initial condition.
#[test]
fn gaps_may_be_in_any_unit() {
    for scale in [1e-3, 1.0, 1e3, 1e6] {
        let model = Scaled::new(ScaledParams { scale }).expect("physical");
        let solution = Vern9::new()
            .solve(&model, 0.0, 4.0, [0.1, 1.0, 3.0, 0.0])
            .expect("a motion");
        for (t, x) in solution.points() {
            let started = Vern9::new().solve(&model, t, t + 1e-3, *x);
            assert!(started.is_ok(), "{scale}: {}", started.expect_err("it is one"));
        }
    }
}
