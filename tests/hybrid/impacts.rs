//! Successive impacts: series that accumulate, ambiguous orders, and scenes of every size.

use nalgebra::SVector;
use pendulum_core::hybrid::{Hybrid, Mode};
use pendulum_core::prelude::*;
use pendulum_core::{Solution, SolveError};
use testbed::contacts::{Boxed, BoxedParams, Row, RowParams};
use testbed::random::share;

/// A row whose impacts accumulate between the second block and both others.
const ROW: RowParams = RowParams {
    m1: 2.0591616492584786,
    m2: 0.4185430268326379,
    m3: 2.09261497854958,
    f1: 1.6440906967340962,
    f2: 20.0,
    f3: 0.0,
    e0: 0.28461803929092666,
    e1: 0.0,
    e2: 0.4784997331860537,
    e3: 0.999,
    k: 27.103263167147308,
    rest: 0.4,
    d: 0.1,
    l: 1.0,
};
const ROW_START: [f64; 6] = [
    0.05382627222935482,
    0.38391271442904584,
    0.6591679887457073,
    1.5699214810999589,
    1.8932469829659428,
    1.448007106775874,
];

const BOXED: BoxedParams = BoxedParams {
    m: 1.0,
    l1: 1.0,
    l2: 1.0598559711723081,
    g: 9.81,
    mu: 0.10041081868792867,
    room: 0.3719820181785105,
    deep: 2.011558469113281,
    e: 0.0,
    ef: 0.1673893731095079,
    es: 0.3816215094052398,
};
const BOXED_START: [f64; 4] = [
    0.7210463251144263,
    -1.8706574095218005,
    -2.2344458224642025,
    -1.5941241505881854,
];

fn row(params: RowParams) -> Row {
    Row::new(params).expect("physical")
}

fn boxed(params: BoxedParams) -> Boxed {
    Boxed::new(params).expect("physical")
}

/// Where impacts accumulate, the final state converges with the tolerance: it does not depend on the number of resolved
/// impacts.
#[test]
fn ends_converge_where_impacts_accumulate() {
    fn converges<S, const N: usize>(model: &S, t: f64, start: [f64; N])
    where
        S: Jacobian<f64, N> + Hybrid<f64, N>,
    {
        let by = |tolerance: f64| {
            let vern = Vern9::new().rtol(tolerance).atol(tolerance).solve(model, 0.0, t, start);
            let rodas = Rodas5P::new()
                .rtol(tolerance)
                .atol(tolerance)
                .solve(model, 0.0, t, start);
            [vern, rodas].map(|solved| {
                let solution = solved.expect("a motion");
                assert!(solution.ambiguities().is_empty());
                solution.end()
            })
        };
        let [expected, _] = by(1e-12);
        for tolerance in [1e-6, 1e-8, 1e-10, 1e-12] {
            for end in by(tolerance) {
                let apart = (end - expected).amax();
                assert!(apart < 10.0 * tolerance.max(1e-11), "{tolerance:e}: {apart:e}");
            }
        }
    }
    converges(&row(ROW), 2.0, ROW_START);
    converges(&boxed(BOXED), 2.932330325324641, BOXED_START);
}

/// Simultaneous impacts are one impact, and all others are in order.
#[test]
fn modes_are_in_order_and_within_the_span() {
    let elastic = row(RowParams {
        m1: 0.914,
        m2: 2.51,
        m3: 1.0,
        f1: 1.0885,
        f2: 1.38,
        f3: 10.0,
        e0: 1.0,
        e1: 1.0,
        e2: 1.0,
        e3: 1.0,
        k: 24.8,
        ..ROW
    });
    for i in 0..200 {
        let start = [0.2, 0.4 + 0.001 * f64::from(i), 0.8, 1.0, -0.5, 0.0];
        let solution = Vern9::new().solve(&elastic, 0.0, 2.0, start).expect("a motion");
        let modes = solution.modes();
        assert!(modes.is_sorted_by_key(|&(t, _)| t), "start {i}: {modes:?}");
        assert!(modes[0].0 == 0.0 && modes[modes.len() - 1].0 <= 2.0, "start {i}");
    }
}

mechanism! {
    /// A ball above a floor.
    pub Ball {
        params { e: 1 = 0.5, g: m/s^2 = 9.81 }
        gravity: [0, -g, 0],
        body ball on ground { mass: 1, joint: prismatic(y), coordinate: y, stop: [0, 1000] restitution(e) }
    }
}

mechanism! {
    /// A slider on a rail with friction, pulled to a stop.
    pub Rail {
        params { mu: N = 9, e: 1 = 0.999, pull: N = 9.81 }
        body slider on ground {
            mass: 1, joint: prismatic(x), coordinate: s, dry_friction: mu, torque: -pull,
            stop: [0, 1000] restitution(e),
        }
    }
}

#[test]
fn no_size_is_too_small() {
    // falls, and rebounds in times that shrink by e
    for (e, g, height) in [(0.5, 1e-20, 1.0), (0.9, 9.81, 1e-14), (0.5, 1e20, 1e-30)] {
        let ball = Ball::new(BallParams { e, g }).expect("physical");
        let fall = (2.0 * height / g).sqrt();
        let rests = fall * (1.0 + 2.0 * e / (1.0 - e));
        let solution = Vern9::new()
            .solve(&ball, 0.0, 2.0 * rests, [height, 0.0])
            .expect("a motion");
        let &(t, mode) = solution.modes().last().expect("it rests");
        assert!(
            (t / rests - 1.0).abs() < 1e-9 && mode.is_held(0),
            "{e} {g:e} {height:e}: {t:e} for {rests:e}"
        );
    }
    // without gravity a slow rise continues
    let free = Ball::new(BallParams { e: 1.0, g: 0.0 }).expect("physical");
    let end = Vern9::new()
        .solve(&free, 0.0, 1.0, [0.0, 1e-15])
        .expect("a motion")
        .end();
    assert_eq!(end, SVector::from([1e-15, 1e-15]));
}

/// Friction slows the rise and the fall: the rates of rebounds shrink by `e sqrt(down / up)`.
#[test]
fn the_last_rebounds_know_friction() {
    for (mu, e) in [(9.0, 0.999), (2.0, 0.9), (0.0, 0.9)] {
        let rail = Rail::new(RailParams {
            mu,
            e,
            ..RailParams::default()
        })
        .expect("physical");
        let (up, down) = (9.81 + mu, 9.81 - mu);
        let start = 1.0;
        let hit = (2.0 * start * down).sqrt();
        let ratio = e * (down / up).sqrt();
        // each rebound at the rate v rises for v/up, and falls for v sqrt(down/up)/down
        let rests = hit / down + e * hit * (1.0 / up + 1.0 / (up * down).sqrt()) / (1.0 - ratio);
        let solution = Vern9::new()
            .rtol(1e-12)
            .atol(1e-12)
            .solve(&rail, 0.0, 2.0 * rests, [start, 0.0]);
        let &(t, mode) = solution.as_ref().expect("a motion").modes().last().expect("it rests");
        assert!(
            (t - rests).abs() < 1e-8 * rests && mode.is_held(0),
            "{mu} {e}: {t} for {rests}"
        );
    }
}

/// Units of length, mass and time, in SI units.
#[derive(Clone, Copy)]
struct Units {
    length: f64,
    mass: f64,
    time: f64,
}

impl Units {
    fn force(&self) -> f64 {
        self.mass * self.length / (self.time * self.time)
    }

    fn row(&self) -> (Row, SVector<f64, 6>) {
        let force = self.force();
        let params = RowParams {
            m1: ROW.m1 * self.mass,
            m2: ROW.m2 * self.mass,
            m3: ROW.m3 * self.mass,
            f1: ROW.f1 * force,
            f2: 1.38 * force,
            f3: 0.5 * force,
            k: ROW.k * force / self.length,
            rest: ROW.rest * self.length,
            d: ROW.d * self.length,
            l: ROW.l * self.length,
            ..ROW
        };
        let rate = self.length / self.time;
        let start = SVector::from_fn(|k, _| ROW_START[k] * if k < 3 { self.length } else { rate });
        (row(params), start)
    }

    fn boxed(&self) -> (Boxed, SVector<f64, 4>) {
        let params = BoxedParams {
            m: BOXED.m * self.mass,
            l1: BOXED.l1 * self.length,
            l2: BOXED.l2 * self.length,
            g: BOXED.g * self.length / (self.time * self.time),
            mu: BOXED.mu * self.force() * self.length,
            room: BOXED.room * self.length,
            deep: BOXED.deep * self.length,
            ..BOXED
        };
        let start = SVector::from_fn(|k, _| {
            if k < 2 {
                BOXED_START[k]
            } else {
                BOXED_START[k] / self.time
            }
        });
        (boxed(params), start)
    }
}

/// The motion does not depend on the units: powers of 4, whose square roots are exact, too.
#[test]
fn units_make_no_difference() {
    let one = Units {
        length: 1.0,
        mass: 1.0,
        time: 1.0,
    };
    // absolute tolerances have one unit for lengths and rates, so this one is negligible
    let solve = |units: &Units| {
        let method = Vern9::new()
            .rtol(1e-10)
            .atol(1e-200)
            .h0(1e-3 * units.time)
            .max_steps(20_000);
        let (model, start) = units.row();
        let row = method.solve(&model, 0.0, 2.0 * units.time, start).expect("a motion");
        let (model, start) = units.boxed();
        (
            row,
            method.solve(&model, 0.0, 2.0 * units.time, start).expect("a motion"),
        )
    };
    let modes = |modes: &[(f64, Mode)]| modes.iter().map(|&(_, mode)| mode).collect::<Vec<_>>();
    let expected = solve(&one);
    assert!(expected.0.impacts().len() > 5 && expected.1.impacts().len() > 5);
    for sign in [1, -1] {
        let (alone, together) = (4.0_f64.powi(50 * sign), 4.0_f64.powi(20 * sign));
        for units in [
            Units { length: alone, ..one },
            Units { mass: alone, ..one },
            Units { time: alone, ..one },
            Units {
                length: together,
                mass: together,
                time: together,
            },
        ] {
            let found = solve(&units);
            assert_eq!(modes(found.0.modes()), modes(expected.0.modes()));
            assert_eq!(modes(found.1.modes()), modes(expected.1.modes()));
            let rate = units.length / units.time;
            for k in 0..6 {
                let size = if k < 3 { units.length } else { rate };
                assert!((found.0.end()[k] / size - expected.0.end()[k]).abs() < 1e-12, "{k}");
            }
            for k in 0..4 {
                let size = if k < 2 { 1.0 } else { 1.0 / units.time };
                assert!((found.1.end()[k] / size - expected.1.end()[k]).abs() < 1e-12, "{k}");
            }
        }
    }
}

mechanism! {
    /// A rod that falls flat, so that both ends reach the floor at once.
    pub Flat {
        params { e: 1 = 0.5 }
        generate: [rhs, jacobian],
        gravity: [0, -9.81, 0],
        point left on rod at [-1, 0, 0], point right on rod at [1, 0, 0],
        wall one { gap: left.y, restitution: e } wall other { gap: right.y, restitution: e }
        body slide on ground { joint: prismatic(y), coordinate: y }
        body rod on slide { mass: 1, inertia: 0.5, joint: revolute(z), coordinate: tilt }
    }
}

/// The order of the two impacts decides which way the rod turns. Simultaneous impacts are reported as ambiguous, and
/// both ends rebound alike.
#[test]
fn an_order_that_decides_and_is_not_known_is_reported() {
    let flat = Flat::new(FlatParams::default()).expect("physical");
    let solve = |tilt: f64| {
        Tsit5::new()
            .rtol(1e-9)
            .atol(1e-9)
            .solve(&flat, 0.0, 0.46, [1.0, tilt, 0.0, 0.0])
    };
    let solution = solve(0.0).expect("a motion");
    let hit = (2.0 / 9.81_f64).sqrt();
    let [ambiguity] = solution.ambiguities() else {
        panic!("{:?}", solution.ambiguities())
    };
    assert!(
        (ambiguity.t - hit).abs() < 1e-9 && ambiguity.constraints().eq([0, 1]),
        "{ambiguity:?}"
    );
    assert_eq!(solution.statistics().ambiguities, 1);
    let [impact] = solution.impacts() else {
        panic!("one impact")
    };
    assert!((impact.after[Flat::DOT_Y] / impact.before[Flat::DOT_Y] + 0.5).abs() < 1e-12 && solution.end()[1] == 0.0);
    // with a small tilt one end comes first
    let [left, right] = [1e-7, -1e-7].map(|tilt| {
        let solution = solve(tilt).expect("a motion");
        assert!(solution.ambiguities().is_empty() && solution.statistics().ambiguities == 0);
        solution.end()
    });
    let apart = (left[Flat::DOT_TILT] - right[Flat::DOT_TILT]).abs();
    assert!(
        apart > 0.1 && (ambiguity.difference - apart).abs() < 1e-3,
        "{apart} {ambiguity:?}"
    );
    // without `std`, and for observers of ensembles, only the count is reported
    let mut stepper = Tsit5::new()
        .stepper(&flat, 0.0, 0.6, [1.0, 0.0, 0.0, 0.0])
        .expect("a start");
    stepper.run().expect("a motion");
    assert_eq!(stepper.statistics().ambiguities, 1);
    // ends that do not interact are not ambiguous
    let apart = [0.0, 0.0, 2.0, 2.0];
    let tile = super::corner::tile(0.0, 1.0, 0.0);
    assert!(
        Vern9::new()
            .solve(&tile, 0.0, 1.0, apart)
            .expect("a motion")
            .ambiguities()
            .is_empty()
    );
}

/// Contradictory contacts are an error wherever they occur.
#[test]
fn a_row_that_is_crushed_is_an_error() {
    let solved: Result<Solution<f64, 6>, SolveError<f64, 6>> =
        Vern9::new().solve(&row(ROW), 0.0, 1.0, [0.5, 0.55, 0.9, 0.0, 0.0, 0.0]);
    assert!(solved.expect_err("the blocks overlap").to_string().contains("w1"));
}

mechanism! {
    /// Four bodies in a row, two of which may move side by side, above a floor or in space.
    pub Four {
        params { mb: kg, e0: 1, w: m, g: m/s^2 }
        gravity: [-g, 0, 0],
        wall floor { gap: a, restitution: e0 }
        wall ab { gap: b - a, restitution: 1 }
        wall bc { gap: c - b, restitution: 0 }
        wall cd { gap: d - c, restitution: 1 }
        wall lid { gap: w - d, restitution: 0 }
        body one on ground { mass: 1, joint: prismatic(x), coordinate: a }
        body two on ground { mass: mb, joint: prismatic(x), coordinate: b }
        body three on ground { mass: 1, joint: prismatic(x), coordinate: c }
        body four on ground { mass: 2, joint: prismatic(x), coordinate: d }
    }
}

/// Bodies moving side by side stay together, however light one of them is: rounding errors must not decide the next
/// impacts.
#[test]
fn what_is_light_stays_with_what_is_heavy() {
    for mb in [1.0, 0.1, 0.01, 1e-3, 1e-4] {
        let params = FourParams {
            mb,
            e0: 0.0,
            w: 1e3,
            g: 0.0,
        };
        let model = Four::new(params).expect("physical");
        let end = |v: f64| {
            let start = [100.0, 101.0, 101.0, 103.0, -0.1 * v, -v, -v, -1.3 * v];
            let solution = Vern9::new().rtol(1e-12).atol(1e-12).solve(&model, 0.0, 4.0 / v, start);
            let solution = solution.expect("a motion");
            assert!(solution.ambiguities().is_empty());
            (solution.impacts().len(), solution.end().fixed_rows::<4>(4) / v)
        };
        let (impacts, expected) = end(1.0);
        assert!(impacts > 0);
        for k in 0..share(200) {
            let (found, rates) = end(1.0 + 0.001234567 * k as f64);
            assert_eq!(found, impacts, "{mb}, {k}");
            assert!((rates - expected).amax() < 1e-11, "{mb}, {k}: {rates} {expected}");
        }
    }
    let params = FourParams {
        mb: 1e-3,
        e0: 0.3,
        w: 3.0,
        g: 9.81,
    };
    let model = Four::new(params).expect("physical");
    let start = [
        0.038052464544782394,
        1.8967983915923299,
        2.076580328396224,
        2.491892619057563,
        0.16416331112045002,
        -0.5424100851208609,
        2.0358980306196783,
        1.2241939210244508,
    ];
    let t1 = 0.9696513211906062;
    let expected = Vern9::new().rtol(1e-13).atol(1e-13).solve(&model, 0.0, t1, start);
    let expected = expected.expect("a motion").end();
    for k in 0..24 {
        let tolerance = 1e-6 * 0.5_f64.powi(k);
        let explicit = Tsit5::new()
            .rtol(tolerance)
            .atol(tolerance)
            .solve(&model, 0.0, t1, start);
        let implicit = Rodas5P::new()
            .rtol(tolerance)
            .atol(tolerance)
            .solve(&model, 0.0, t1, start);
        for solution in [explicit, implicit] {
            let apart = (solution.expect("a motion").end() - expected).amax();
            assert!(apart < 1e-6, "{tolerance}: {apart:e}");
        }
    }
}

mechanism! {
    /// A heavy rod with a light one on it between two stops. The tip of the light rod hits a wall.
    pub Tip {
        params { l: m }
        gravity: [0, -9.81, 0],
        point tip on lower at [0, -l, 0],
        wall side { gap: 0.5*l - tip.x, restitution: 0.7 }
        body upper on ground {
            solids: [rod(1000, [0, 0, 0], [0, -l, 0])], joint: revolute(z), coordinate: th,
        }
        body lower on upper {
            solids: [rod(0.001, [0, 0, 0], [0, -l, 0])], joint: revolute(z) at [0, -l, 0], coordinate: ph,
            stop: [-0.5, 0.5] restitution(0), dry_friction: 4.905e-4 N * l,
        }
    }
}

/// Holding forces are only as accurate as the weights they balance. A light rod on a heavy one, at every tolerance and
/// in every size.
#[test]
fn what_is_light_rests_as_long_as_it_should() {
    for &l in &[1e-3, 0.1, 1.0][..share(3)] {
        let model = Tip::new(TipParams { l }).expect("physical");
        let v = (9.81_f64 / l).sqrt();
        for k in 0..share(40) {
            let tolerance = 1e-6 * 0.7_f64.powi(k as i32);
            let method = Tsit5::new().rtol(tolerance).atol(tolerance);
            let solved = method.solve(&model, 0.0, 5.0 / v, [-1.0, 0.2, 2.0 * v, 0.0]);
            if let Err(error) = solved {
                panic!("{l} m, {tolerance}: {error}");
            }
        }
    }
}
