//! Closed loops against reference data made without screws and closed forms: positions, rates and accelerations from a
//! tree, its closures and their null space, to 20 digits.

use std::f64::consts::TAU;

use nalgebra::SVector;
use pendulum_core::prelude::*;
use pendulum_core::real::lanes::Isa;
use pendulum_core::stability::equilibrium;
use pendulum_core::{EnsembleError, Name, Reason, Solution, SolveError};
use serde_json::Value;
use testbed::linkages::{
    Andrews, AndrewsParams, FiveBar, FiveBarParams, FourBar, FourBarParams, Parallelogram, ParallelogramParams,
    SliderCrank, SliderCrankParams,
};
use testbed::random::share;

/// Largest error over the largest entry.
const TOLERANCE: f64 = 1e-11;

fn number(value: &Value) -> f64 {
    value
        .as_str()
        .map_or_else(|| value.as_f64(), |text| text.parse().ok())
        .expect("a number")
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(number).collect()
}

fn mechanism(name: &str) -> Value {
    let all: Value = serde_json::from_str(include_str!("../../testbed/data/loops.json")).expect("valid JSON");
    let list = all["mechanisms"].as_array().expect("a list");
    list.iter()
        .find(|m| m["name"] == name)
        .expect("a mechanism of that name")
        .clone()
}

fn assert_close(what: &str, ours: &[f64], reference: &[f64]) {
    let size = reference.iter().fold(1e-300, |size: f64, x| size.max(x.abs()));
    assert_eq!(ours.len(), reference.len());
    for (a, b) in ours.iter().zip(reference) {
        assert!(
            (a - b).abs() <= TOLERANCE * size,
            "{what}: {ours:?} instead of {reference:?}"
        );
    }
}

/// Angle closest to `to` that differs by whole turns.
fn nearest(angle: f64, to: f64) -> f64 {
    angle - TAU * ((angle - to) / TAU).round()
}

macro_rules! agrees {
    ($($test:ident: $model:ident, $params:ident, $free:literal, angles $angles:expr;)*) => {$(
        #[test]
        fn $test() {
            const D: usize = $free;
            const N: usize = 2 * D;
            let model = $model::new($params::default()).expect("the parameters are physical");
            let data = mechanism(stringify!($test));
            let free = numbers(&data["independent"]);
            let free: Vec<usize> = free.into_iter().map(|k| k as usize).collect();
            for sample in data["samples"].as_array().expect("a list") {
                let [q, qd, qdd] = ["q", "qd", "qdd"].map(|key| numbers(&sample[key]));
                let x = SVector::<f64, N>::from_fn(|n, _| if n < D { q[free[n]] } else { qd[free[n - D]] });
                let rest = |all: &[f64]| -> Vec<f64> {
                    (0..all.len()).filter(|k| !free.contains(k)).map(|k| all[k]).collect() };
                let angles: Vec<usize> = $angles;
                let expected = rest(&q);
                let following = model.following(0.0, &x);
                let following: Vec<f64> = (0..expected.len()).map(|k| {
                    if angles.contains(&k) { nearest(following[k], expected[k]) } else { following[k] }
                }).collect();
                assert_close("positions that follow", &following, &expected);
                assert_close("rates that follow", model.following_rates(0.0, &x).as_slice(), &rest(&qd));
                let rates = model.rhs(0.0, &x);
                let accelerations = numbers(&sample["independent_acceleration"]);
                assert_close("accelerations", &rates.as_slice()[D..], &accelerations);
                assert_close("accelerations that follow", model.following_rates_rate(0.0, &x).as_slice(), &rest(&qdd));
                assert_close("energies", &[model.kinetic(0.0, &x), model.potential(0.0, &x)],
                    &[number(&sample["kinetic"]), number(&sample["potential"])]);
                assert!(model.gaps(0.0, &x).amax() < 1e-15, "closed: {}", model.gaps(0.0, &x));
            }
        }
    )*};
}

agrees! {
    four_bar: FourBar, FourBarParams, 1, angles vec![0, 1];
    slider_crank: SliderCrank, SliderCrankParams, 1, angles vec![0];
    five_bar: FiveBar, FiveBarParams, 2, angles vec![0, 1];
    andrews: Andrews, AndrewsParams, 1, angles (0..6).collect();
}

/// The published motion of Andrews' mechanism, from rest to 0.03 s: reference to 18 digits.
#[test]
fn andrews_moves_as_published() {
    let data: Value = serde_json::from_str(include_str!("../../testbed/data/andrews.json")).expect("valid JSON");
    let motion = &data["motions"][0];
    let model = Andrews::new(AndrewsParams::default()).expect("the parameters are physical");
    let start = numbers(&motion["x0"]);
    let times = numbers(&motion["times"]);
    // beta, theta, gamma, phi, delta, omega, epsilon and their rates
    const ORDER: [usize; 6] = [0, 1, 3, 2, 5, 4];
    for (&t, state) in times.iter().zip(motion["states"].as_array().expect("a list")) {
        let method = Vern9::new().rtol(1e-13).atol(1e-13);
        let x = &method
            .solve(&model, 0.0, t, [start[0], start[7]])
            .expect("it moves")
            .end();
        let state = numbers(state);
        assert!((x[0] - state[0]).abs() < 1e-11, "{t}: {} instead of {}", x[0], state[0]);
        assert!(
            (x[1] - state[7]).abs() < 1e-11 * 1500.0,
            "{t}: {} instead of {}",
            x[1],
            state[7]
        );
        let (following, rates) = (model.following(t, x), model.following_rates(t, x));
        for (k, &place) in ORDER.iter().enumerate() {
            let expected = state[1 + k];
            let ours = nearest(following[place], expected);
            assert!(
                (ours - expected).abs() < 1e-11,
                "{t}, {k}: {ours} instead of {expected}"
            );
            assert!((rates[place] - state[8 + k]).abs() < 1e-11 * 1500.0, "{t}, {k}");
        }
        assert!(model.gaps(t, x).amax() < 1e-14 * 0.09, "closed: {}", model.gaps(t, x));
    }
}

mechanism! {
    /// A crank that cannot turn all the way.
    pub Rocking {
        generate: [rhs, jacobian, energy, taylor, canonical],
        gravity: [0, -9.81, 0],
        body crank on ground { solids: [rod(1, [0, 0, 0], [0.5, 0, 0])], joint: revolute(z),
            coordinate: theta near 0.8 }
        body coupler on crank {
            solids: [rod(1, [0, 0, 0], [0.3, 0, 0])], joint: revolute(z) at [0.5, 0, 0],
                coordinate: phi depends near -0.5,
        }
        body rocker on ground {
            solids: [rod(1, [0, 0, 0], [0.5, 0, 0])], joint: revolute(z) at [0.6, 0, 0],
                coordinate: psi depends near 1.4,
        }
        close coupler at [0.3, 0, 0] to rocker at [0.5, 0, 0]: revolute(z),
        output margin: margin(coupler, rocker),
        event flat: margin(coupler, rocker) - 0.1,
    }
}

mechanism! {
    /// A slider-crank with the slider in the state. At a dead centre the crank may turn either way, and the motion of
    /// the slider does not determine which.
    pub DeadCentre {
        generate: [rhs, jacobian, energy, taylor, canonical],
        body crank on ground { mass: 0.5, inertia: 5e-3, joint: revolute(z), coordinate: theta depends near 1 }
        body rod on crank {
            mass: 0.2, com: [0.15, 0, 0], inertia: 1e-3, joint: revolute(z) at [0.1, 0, 0],
            coordinate: phi depends near -1.3,
        }
        body slider on ground { mass: 0.3, joint: prismatic(x), coordinate: s near 0.34 }
        close rod at [0.3, 0, 0] to slider: revolute(z),
        output margin: margin(rod, slider),
    }
}

/// Checks that adaptive methods stop at a singularity (toggle), alone and in lanes.
macro_rules! end_at_toggle {
    ($($method:ident)*, of $model:ident from $start:expr, by $tolerance:expr, $check:ident) => {$(
        let method = $method::new().rtol($tolerance).atol($tolerance).max_steps(2000);
        let alone = $check(stringify!($method), method.solve(&$model, 0.0, 5.0, $start), 0.0);
        let starts = [SVector::from($start); 5];
        for isa in Isa::available() {
            let Err(EnsembleError::Stopped { stopped, x }) = method.ensemble_on(isa, &[$model], 0.0, 5.0,
                &starts) else {
                panic!("{} goes on in lanes on {isa:?}", stringify!($method));
            };
            assert_eq!(stopped.len(), starts.len());
            for (stopped, x) in stopped.iter().zip(&x) {
                assert!(matches!(stopped.reason, Reason::Toggle { .. }), "{}", stopped.reason);
                assert_eq!((stopped.t, *x), alone, "{} on {isa:?}", stringify!($method));
            }
        }
    )*};
}

/// A motion ends where a loop is flat: no method jumps to another assembly.
#[test]
fn a_motion_ends_at_a_toggle() {
    let rocking = Rocking::new(RockingParams::default()).expect("the parameters are physical");
    let parallelogram = Parallelogram::new(ParallelogramParams::default()).expect("the parameters are physical");
    macro_rules! ends {
        ($model:ident, $names:expr, from $angle:expr, $rates:expr, $tolerances:expr) => {
            for rate in $rates {
                let check = |method: &str, solved: Result<Solution<f64, 2>, SolveError<f64, 2>>, h: f64| {
                    let error = solved.expect_err(method);
                    let Reason::Toggle { bodies, margin } = error.reason else {
                        panic!("{method} from {rate}: {error}");
                    };
                    let (t, x) = error.solution.last();
                    assert_eq!(bodies, $names, "{method}: {error}");
                    assert!((margin - $model.margin(t, &x)).abs() < 1e-14, "{method}: {error}");
                    // the margin is the sine of an angle; it falls to zero within two steps, or within one as the root
                    // of the remainder
                    let [angle, rate_of_sine] = [margin.asin(), $model.loop_margins(t, &x).1.amax()];
                    let within = h * rate_of_sine / angle.cos();
                    let nearest = 0.02 + 2.0 * within.max((h * rate).sqrt());
                    assert!(margin >= 1e-3 && angle < nearest, "{method} from {rate} stopped {margin:e} before");
                    (t, x)
                };
                let start = [$angle, rate];
                for tolerance in $tolerances {
                    end_at_toggle!(
                        Rk45 Tsit5 Vern7 Vern9 Taylor Radau5 Rodas5P, of $model from start, by tolerance, check
                    );
                    let auto = Auto::new().rtol(tolerance).atol(tolerance).max_steps(2000);
                    check("Auto", auto.solve(&$model, 0.0, 5.0, start), 0.0);
                }
                for h in &[0.1, 0.01, 1e-4][..1 + share(2)] {
                    let h = *h;
                    check("Rk4", Rk4::new(h).solve(&$model, 0.0, 5.0, start), h);
                    check("Gauss4", Gauss4::new(h).solve(&$model, 0.0, 5.0, start), h);
                    check("Gauss6", Gauss6::new(h).solve(&$model, 0.0, 5.0, start), h);
                }
            }
        };
    }
    ends!(rocking, ["coupler", "rocker"], from 0.8, [3.0], [1e-2, 1e-3, 1e-6, 1e-10]);
    // the fastest start turns by more than half a turn within a step
    ends!(parallelogram, ["beam", "right"], from 0.1, [1.0, 2.0, 15.0], [1e-2, 1e-3, 1e-6, 1e-10]);
    let slider_crank = DeadCentre::new(DeadCentreParams::default()).expect("the parameters are physical");
    // the whole path to the dead centre is 0.06 m long
    ends!(slider_crank, ["rod", "slider"], from 0.34, [0.1, 0.5, 1.0, 4.0], [1e-4, 1e-6, 1e-10]);
    let flat = rocking.flat_event().terminal();
    let ended = Vern9::new()
        .solve_with(&rocking, 0.0, 5.0, [0.8, 3.0], &[flat])
        .expect("the event ends it");
    let (t, x) = ended.last();
    assert!((rocking.margin(t, &x) - 0.1).abs() < 1e-12);
}

/// An initial condition beyond the reach of a loop names the loop.
#[test]
fn a_loop_that_cannot_close_is_named() {
    let rocking = Rocking::new(RockingParams::default()).expect("the parameters are physical");
    let error = Rk4::new(0.01)
        .solve(&rocking, 0.0, 1.0, [2.5, 0.0])
        .expect_err("it is too far");
    let bodies = ["coupler", "rocker"].map(Name::from);
    assert!(error.reason == Reason::CannotClose { bodies }, "{error}");
    let far = Event::new(|t, _x: &SVector<f64, 2>| t - 0.1).reset(|_t, _x| SVector::from([2.5, 0.0]));
    let error = Vern9::new().solve_with(&rocking, 0.0, 1.0, [0.8, 0.0], &[far]);
    let text = error.expect_err("it is too far").to_string();
    assert!(
        text.contains("the loop between `coupler` and `rocker` cannot close"),
        "{text}"
    );
    let error = equilibrium(&rocking, [2.5, 0.0])
        .expect_err("it is too far")
        .to_string();
    assert!(
        error.contains("the loop between `coupler` and `rocker` cannot close"),
        "{error}"
    );
}

mechanism! {
    /// A linkage on a free body, beside a driven joint and one that follows a dependent joint.
    pub Flying {
        gravity: [0, 0.5, -9.81],
        body craft on ground {
            mass: 3, com: [0.1, 0.1, -0.1], inertia: [0.3, 0.25, 0.2], joint: free, orientation: o, position: p,
        }
        body crank on craft {
            mass: 0.5, com: [0.1, 0, 0], inertia: [0.001, 0.002, 0.002],
            joint: revolute(z) at [0.1, 0, 0.2], coordinate: theta near 0.8,
        }
        body coupler on crank {
            mass: 1.1, com: [0.25, 0, 0], inertia: [0.01, 0.02, 0.02],
            joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3,
        }
        body rocker on craft {
            mass: 0.9, com: [0.2, 0, 0], inertia: [0.01, 0.01, 0.012],
            joint: revolute(z) at [0.7, 0, 0.2], coordinate: psi depends near 1.6,
        }
        body rotor on craft {
            mass: 0.3, com: [0.02, 0, 0], inertia: [0.001, 0.001, 0.002], joint: revolute(x) at [0, 0.3, 0],
                motion: 4 rad/s * t,
        }
        body gear on craft {
            mass: 0.2, com: [0.05, 0, 0], inertia: [0.001, 0.001, 0.001], joint: revolute(y) at [0, 0, 0.4],
                motion: 2*psi,
        }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
        force theta: 0.7,
        output following: psi,
        output turned: rotation(gear),
        output craft: rotation(craft),
        generate: [rhs, energy, drive_forces],
    }
}

#[test]
fn a_linkage_flies() {
    let model = Flying::new(FlyingParams {}).expect("the parameters are physical");
    let start = SVector::from([
        0.1, 0.2, 0.3, 0.8, 0.0, 0.6, 0.0, 0.9, 0.3, -0.2, 0.1, 0.5, -0.4, 0.8, 2.0,
    ]);
    // order of the state in its layout, and the energy against the work of the force and of the drive
    assert_eq!(
        (Flying::P_X, Flying::O, Flying::THETA, Flying::DOT_THETA),
        (0, 3, 7, 14)
    );
    let power = |t: f64, x: &SVector<f64, 15>| 0.7 * x[Flying::DOT_THETA] + 4.0 * model.drive_forces(t, x)[0];
    const STEP: f64 = 2.5e-4;
    let method = Vern9::new().rtol(1e-13).atol(1e-13);
    let mut state = start;
    for n in 0..20 {
        let t = 0.05 * f64::from(n);
        let energies = [-2.0, -1.0, 1.0, 2.0].map(|steps| {
            let moved = method
                .solve(&model, t, t + steps * STEP, state)
                .expect("it moves")
                .end();
            model.energy(t + steps * STEP, &moved)
        });
        let [a, b, c, d] = energies;
        let rate = (a - 8.0 * b + 8.0 * c - d) / (12.0 * STEP);
        assert!(
            (rate - power(t, &state)).abs() < 1e-8 * rate.abs().max(1.0),
            "{t}: {rate} instead of {}",
            power(t, &state)
        );
        // the gear turns twice as far as the rocker
        let relative = model.craft(t, &state).transpose() * model.turned(t, &state);
        let (sine, cosine) = (2.0 * model.following(t, &state)).sin_cos();
        assert!((relative[(0, 0)] - cosine).abs() < 1e-12 && (relative[(0, 2)] - sine).abs() < 1e-12);
        state = method.solve(&model, t, t + 0.05, state).expect("it moves").end();
    }
}

mechanism! {
    /// A four-bar that drives a slider beside it, with forces on dependent bodies.
    pub Lengths {
        params { a: m = 0.2, b: m = 0.5, c: m = 0.4, d: m = 0.6, l: m = 0.9, k: N/m = 30, m: kg = 1.1 }
        gravity: [0, -9.81, 0],
        body crank on ground { solids: [rod(0.5, [0, 0, 0], [a, 0, 0])], joint: revolute(z),
            coordinate: theta near 0.8 }
        body coupler on crank {
            solids: [rod(m, [0, 0, 0], [b, 0, 0])], joint: revolute(z) at [a, 0, 0], coordinate: phi depends near -0.3,
        }
        body rocker on ground {
            solids: [rod(0.9, [0, 0, 0], [c, 0, 0])], joint: revolute(z) at [d, 0, 0],
                coordinate: psi depends near 1.6, friction: 0.05,
        }
        body rod on rocker {
            solids: [rod(0.3, [0, 0, 0], [l, 0, 0])], joint: revolute(z) at [c, 0, 0], coordinate: chi depends near -2,
        }
        body slider on ground {
            solids: [point(0.4, [0, 0, 0])], joint: prismatic(x), coordinate: s depends near 1.3, spring: (k, 1),
        }
        close coupler at [b, 0, 0] to rocker at [c, 0, 0]: revolute(z),
        close rod at [l, 0, 0] to slider: revolute(z),
        potential: 0.2*(phi - psi)^2 * 1 N m,
        generate: [rhs, parameter_jacobian],
    }
}

/// Dependent coordinates also vary with the parameters.
#[test]
fn loops_are_derived_by_their_lengths() {
    let params = LengthsParams::default();
    let model = Lengths::new(params).expect("the parameters are physical");
    for x in [[0.8, 12.0], [2.5, -3.0], [-1.2, 0.0]] {
        let x = SVector::from(x);
        let jacobian = model.parameter_jacobian(0.0, &x);
        let size = jacobian.amax();
        for n in 0..LengthsParams::NAMES.len() {
            let at = |step: f64| {
                let mut all = params.to_array();
                all[n] += step;
                let moved = Lengths::new(LengthsParams::from_array(all)).expect("the parameters are physical");
                moved.rhs(0.0, &x)
            };
            const STEP: f64 = 1e-4;
            let difference = (at(-2.0 * STEP) - at(-STEP) * 8.0 + at(STEP) * 8.0 - at(2.0 * STEP)) / (12.0 * STEP);
            let ours = jacobian.column(n);
            assert!(
                (ours - difference).amax() < 1e-9 * size,
                "{}: {ours} and not {difference}",
                LengthsParams::NAMES[n]
            );
        }
    }
}
