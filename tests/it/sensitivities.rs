//! Derivatives of trajectories by initial conditions and parameters.

use nalgebra::{SMatrix, SVector};
use pendulum_core::dual::Dual;
use pendulum_core::prelude::*;
use pendulum_core::real::Real;
use pendulum_core::sensitivity::{self, Seeded, Sensitivity, Variable};
use pendulum_core::taylor::MAX_ORDER;
use pendulum_core::{CastTaylor, InputLaw, Parametric, Reason, TaylorSeries, stability};
use testbed::problems::{HenonHeiles, HenonHeilesParams};
use testbed::random::Random;
use testbed::scenes::{DoublePendulum, DoublePendulumParams};
use testbed::series::{Elbow, ElbowParams, Slides, SlidesParams};

use crate::states::{
    Linkage, LinkageParams, Lorenz, LorenzParams, Mixed, MixedParams, Motor, MotorParams, Robertson, RobertsonParams,
    Servo, ServoParams,
};

use Variable::{Parameter, Start};

/// Derivatives by differences of order six of solutions with other initial conditions and parameters.
fn by_differences<M, X, const N: usize, const P: usize, const K: usize>(
    method: &X,
    model: &M,
    (t0, t1): (f64, f64),
    x0: [f64; N],
    variables: [Variable; K],
) -> SMatrix<f64, N, K>
where
    M: Parametric<N, P>,
    X: Method<M::In<f64>, f64, N>,
{
    const STENCIL: [(f64, f64); 6] = [
        (-3.0, -1.0),
        (-2.0, 9.0),
        (-1.0, -45.0),
        (1.0, 45.0),
        (2.0, -9.0),
        (3.0, 1.0),
    ];
    let columns = variables.map(|variable| {
        let (mut start, mut parameters) = (x0, model.parameters());
        let mut sum = SVector::<f64, N>::zeros();
        let size = match variable {
            Start(n) => x0[n].abs().max(1.0),
            Parameter(n) => parameters[n].abs(),
        };
        let h = 2e-4 * size;
        for (steps, weight) in STENCIL {
            let own = match variable {
                Start(n) => &mut start[n],
                Parameter(n) => &mut parameters[n],
            };
            let kept = *own;
            *own += steps * h;
            let end = method
                .solve(&model.with_parameters(parameters), t0, t1, start)
                .expect("regular")
                .end();
            match variable {
                Start(n) => start[n] = kept,
                Parameter(n) => parameters[n] = kept,
            }
            sum += end * weight;
        }
        sum / (60.0 * h)
    });
    SMatrix::from_columns(&columns)
}

#[track_caller]
fn close<const N: usize, const K: usize>(
    what: &str,
    ours: &SMatrix<f64, N, K>,
    theirs: &SMatrix<f64, N, K>,
    within: f64,
) {
    let error = (ours - theirs).amax() / (1.0 + theirs.amax());
    println!("{what}: {error:.1e}");
    assert!(error < within, "{what}: {error:e}\n{ours}{theirs}");
}

#[test]
fn a_regular_double_pendulum() {
    let model = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
    let x0 = [1.0, 0.5, 0.0, 0.0];
    let variables = [
        Start(0),
        Start(1),
        Start(2),
        Start(3),
        Parameter(0),
        Parameter(2),
        Parameter(5),
        Parameter(6),
    ];
    let tight = Vern9::new().rtol(1e-13).atol(1e-13);
    let expected = by_differences(&tight, &model, (0.0, 3.0), x0, variables);
    let check = |what: &str, motion: Sensitivity<4, 8>, within: f64| close(what, &motion.end().1, &expected, within);
    check(
        "Vern9",
        sensitivity::solve(&tight, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Vern7::new().rtol(1e-12).atol(1e-12);
    check(
        "Vern7",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Tsit5::new().rtol(1e-12).atol(1e-12);
    check(
        "Tsit5",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Rk45::new().rtol(1e-12).atol(1e-12);
    check(
        "Rk45",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Rk4::new(1e-3);
    check(
        "Rk4",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Taylor::new().rtol(1e-14).atol(1e-14);
    check(
        "Taylor",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Rodas5P::new().rtol(1e-11).atol(1e-11);
    check(
        "Rodas5P",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Rodas4::new().rtol(1e-10).atol(1e-10);
    check(
        "Rodas4",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-8,
    );
    let method = Radau5::new().rtol(1e-12).atol(1e-12);
    check(
        "Radau5",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Auto::new().rtol(1e-12).atol(1e-12);
    check(
        "Auto",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Gauss6::new(2e-3);
    check(
        "Gauss6",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Gauss4::new(1e-3);
    check(
        "Gauss4",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-8,
    );
    // the first four are the transition matrix
    let transition = stability::transition(&model, 0.0, 3.0, x0, 1e-13).expect("regular");
    let motion =
        sensitivity::solve(&tight, &model, 0.0, 3.0, x0, [Start(0), Start(1), Start(2), Start(3)]).expect("regular");
    close("transition", &motion.end().1, &transition.1, 1e-10);
}

/// Runs a function on a deep stack: without optimisation, a Taylor series of dual numbers takes more than that of a
/// test.
fn with_deep_stack<R: Send>(run: impl FnOnce() -> R + Send) -> R {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(1 << 26);
        let handle = thread.spawn_scoped(scope, run).expect("a thread");
        handle.join().expect("it ends")
    })
}

/// Checks a model with some methods against differences.
macro_rules! check {
    ($model:expr, $span:expr, $x0:expr, $variables:expr, $reference:expr,
     [$($method:expr => $within:expr),* $(,)?]) => {{
        let (model, span, x0, variables) = ($model, $span, $x0, $variables);
        let expected = by_differences(&$reference, &model, span, x0, variables);
        println!("{expected}");
        $(
            let solved = || sensitivity::solve(&$method, &model, span.0, span.1, x0, variables).expect("regular");
            let motion = with_deep_stack(solved);
            close(stringify!($method), &motion.end().1, &expected, $within);
        )*
    }};
}

#[test]
fn through_breakaway_and_stops() {
    let servo = Servo::new(ServoParams::default()).expect("physical");
    let tight = Vern9::new().rtol(1e-13).atol(1e-13);
    // the initial rate is held by friction: its effect is quadratic
    let all = [
        Start(0),
        Start(2),
        Parameter(0),
        Parameter(1),
        Parameter(2),
        Parameter(3),
        Parameter(4),
        Parameter(5),
        Parameter(6),
    ];
    // slipping after the breakaway
    check!(servo, (0.0, 0.3), [0.0; 4], all, tight, [
        Vern9::new().rtol(1e-13).atol(1e-13) => 1e-9,
        Taylor::new().rtol(1e-14).atol(1e-14) => 1e-9,
        Rodas5P::new().rtol(1e-11).atol(1e-11) => 1e-9,
        Rk4::new(1e-3) => 1e-8,
    ]);
    // after the first rebound
    check!(servo, (0.0, 1.0), [0.0; 4], all, tight, [
        Vern9::new().rtol(1e-13).atol(1e-13) => 1e-9,
        Taylor::new().rtol(1e-14).atol(1e-14) => 1e-9,
        Rk4::new(1e-3) => 1e-8,
    ]);
    // at rest at the stop
    check!(servo, (0.0, 6.0), [0.0; 4], all, tight, [
        Vern9::new().rtol(1e-13).atol(1e-13) => 1e-9,
        Taylor::new().rtol(1e-14).atol(1e-14) => 1e-9,
    ]);
}

#[test]
fn of_loops_balls_and_states() {
    let tight = Vern9::new().rtol(1e-13).atol(1e-13);
    let linkage = Linkage::new(LinkageParams::default()).expect("physical");
    check!(linkage, (0.0, 1.0), [0.7, 0.0, 0.0],
        [Start(0), Start(1), Start(2), Parameter(0), Parameter(1), Parameter(2), Parameter(3)],
        tight, [
        Vern9::new().rtol(1e-12).atol(1e-12) => 1e-9,
        Taylor::new().rtol(1e-14).atol(1e-14) => 1e-9,
    ]);
    let mixed = Mixed::new(MixedParams::default()).expect("physical");
    check!(mixed, (0.0, 2.0), [1.0, 0.0, 0.0, 0.0, 0.5, -0.7, 1.1, 0.3],
        [Start(4), Start(5), Start(7), Parameter(0), Parameter(1), Parameter(2), Parameter(3)],
        tight, [
        Vern9::new().rtol(1e-12).atol(1e-12) => 1e-9,
        Taylor::new().rtol(1e-14).atol(1e-14) => 1e-9,
    ]);
    let lorenz = Lorenz::new(LorenzParams::default()).expect("valid");
    check!(lorenz, (0.0, 3.0), [1.0, 1.0, 20.0],
        [Start(0), Start(1), Start(2), Parameter(0), Parameter(1), Parameter(2)],
        tight, [
        Vern9::new().rtol(1e-13).atol(1e-13) => 1e-8,
        Taylor::new().rtol(1e-14).atol(1e-14) => 1e-8,
    ]);
    let robertson = Robertson::new(RobertsonParams::default()).expect("valid");
    check!(robertson, (0.0, 40.0), [1.0, 0.0, 0.0],
        [Start(0), Parameter(0), Parameter(1), Parameter(2)],
        Radau5::new().rtol(1e-12).atol(1e-16), [
        Radau5::new().rtol(1e-11).atol(1e-15) => 1e-8,
        Rodas5P::new().rtol(1e-10).atol(1e-14) => 1e-8,
    ]);
}

mechanism! {
    /// A ball that falls from a height.
    pub Ball {
        params { g: m/s^2 = 9.81, e: 1 = 0.7, floor: m = 0.1 }
        gravity: [0, -g, 0],
        wall ground { gap: y - floor, restitution: e }
        body ball on ground { mass: 1, joint: prismatic(y), coordinate: y }
        event top: dot(y),
    }
}

mechanism! {
    /// The ball without its floor.
    pub Thrown {
        params { g: m/s^2 = 9.81 }
        gravity: [0, -g, 0],
        body ball on ground { mass: 1, joint: prismatic(y), coordinate: y }
    }
}

/// Height and rate at a time after the first impact, in closed form, in any number type.
fn rebounded<T: Real>([height, g, e, floor]: [T; 4], t: T) -> [T; 3] {
    let (half, two) = (T::from_f64(0.5), T::from_f64(2.0));
    let impact = (two * (height - floor) / g).sqrt();
    let (since, rate) = (t - impact, e * g * impact);
    [
        floor + rate * since - half * g * since * since,
        rate - g * since,
        impact,
    ]
}

#[test]
fn impacts_have_the_derivatives_of_the_closed_form() {
    let ball = Ball::new(BallParams::default()).expect("physical");
    let by = [Start(0), Parameter(0), Parameter(1), Parameter(2)];
    let given = [1.0, 9.81, 0.7, 0.1];
    let seeds: [Dual<f64, 4>; 4] = std::array::from_fn(|n| Dual::variable(given[n], n));
    let check = |what: &str, motion: Sensitivity<2, 4>| {
        let [impact] = motion.solution().impacts() else {
            panic!("one impact")
        };
        for t in [0.5, 0.6, 0.7] {
            let [height, rate, at] = rebounded(seeds, Dual::from_f64(t));
            let (x, slopes) = motion.at(t).expect("inside");
            let expected = SMatrix::from_fn(|n, k| [height, rate][n].slopes[k]);
            close(&format!("{what} at {t}"), &slopes, &expected, 1e-11);
            assert!((x[0] - height.value).abs() < 1e-12);
            for k in 0..4 {
                assert!(
                    (impact.t.slopes[k] - at.slopes[k]).abs() < 1e-11,
                    "{what}: {:?}",
                    impact.t
                );
            }
        }
    };
    check(
        "Vern9",
        sensitivity::solve(&Vern9::new(), &ball, 0.0, 0.7, [1.0, 0.0], by).expect("regular"),
    );
    check(
        "Rk4",
        sensitivity::solve(&Rk4::new(0.01), &ball, 0.0, 0.7, [1.0, 0.0], by).expect("regular"),
    );
    check(
        "Tsit5",
        sensitivity::solve(&Tsit5::new(), &ball, 0.0, 0.7, [1.0, 0.0], by).expect("regular"),
    );
    check(
        "Rodas5P",
        sensitivity::solve(&Rodas5P::new(), &ball, 0.0, 0.7, [1.0, 0.0], by).expect("regular"),
    );
}

/// Height and rate at a time after an impact of a ball with a speed, in closed form.
fn thrown<T: Real>([height, speed, g, e, floor]: [T; 5], t: T) -> [T; 2] {
    let (half, two) = (T::from_f64(0.5), T::from_f64(2.0));
    let impact = (speed + (speed * speed + two * g * (height - floor)).sqrt()) / g;
    let (since, rate) = (t - impact, e * (g * impact - speed));
    [floor + rate * since - half * g * since * since, rate - g * since]
}

#[test]
fn an_impact_at_the_start_has_the_derivatives_of_its_time() {
    let ball = Ball::new(BallParams::default()).expect("physical");
    let (by, given) = (
        [Start(0), Start(1), Parameter(0), Parameter(1), Parameter(2)],
        [0.1, -1.0, 9.81, 0.7, 0.1],
    );
    let expected = thrown(
        std::array::from_fn(|n| Dual::<f64, 5>::variable(given[n], n)),
        Dual::from_f64(0.1),
    );
    let expected = SMatrix::from_fn(|n, k| expected[n].slopes[k]);
    let (_, slopes) = sensitivity::end(&Vern9::new(), &ball, 0.0, 0.1, [0.1, -1.0], by).expect("regular");
    close("impact at the start", &slopes, &expected, 1e-12);
    let (_, slopes) = stability::transition(&ball, 0.0, 0.1, [0.1, -1.0], 1e-10).expect("regular");
    close("transition", &slopes, &expected.fixed_columns::<2>(0).into(), 1e-12);
}

#[test]
fn an_impact_at_the_end_does_not_move_the_end() {
    let params = BallParams {
        g: 8.0,
        floor: 0.0,
        ..BallParams::default()
    };
    let ball = Ball::new(params).expect("physical");
    let by = [Start(0), Start(1), Parameter(0), Parameter(2)];
    let motion = sensitivity::solve(&Vern9::new(), &ball, 0.0, 0.5, [1.0, 0.0], by).expect("regular");
    assert!(motion.solution().impacts().is_empty());
    let falling = SMatrix::from([[1.0, 0.0], [0.5, 1.0], [-0.125, -0.5], [0.0, 0.0]]);
    close("impact at the end", &motion.end().1, &falling, 1e-12);
}

mechanism! {
    /// A ball under a ceiling.
    pub Thrust {
        params { g: m/s^2 = 8, roof: m = 1 }
        gravity: [0, -g, 0],
        wall ceiling { gap: roof - y, restitution: 0.5 }
        body ball on ground { mass: 1, joint: prismatic(y), coordinate: y }
    }
}

/// A ball that reaches the ceiling but for rounding errors has no derivatives: others touch it, or do not.
#[test]
fn an_impact_that_is_not_resolved_is_reported() {
    let ball = Thrust::new(ThrustParams::default()).expect("physical");
    let end = |speed: f64| sensitivity::end(&Vern9::new(), &ball, 0.0, 0.9, [0.0, speed], [Start(0), Parameter(1)]);
    let free = SMatrix::from([[1.0, 0.0], [0.0, 0.0]]);
    let mut reported = 0;
    for ulps in 0..32 {
        match end(4.0 * (1.0 + f64::from(ulps) * f64::EPSILON)) {
            Err(error) => {
                assert!(matches!(error, Reason::NotDifferentiable { .. }), "{error}");
                reported += 1;
            }
            Ok((_, slopes)) => close("a touch", &slopes, &free, 1e-8),
        }
    }
    assert!(reported > 8, "{reported}");
    let below = end(4.0 - 1e-9).expect("a free flight").1;
    close("a free flight", &below, &free, 1e-12);
    let above = end(4.0 + 1e-6).expect("a slow impact").1;
    assert!(above.amax() > 1e2, "{above}");
}

#[test]
fn events_and_resets_have_the_derivatives_of_the_closed_form() {
    let thrown = Thrown::new(ThrownParams::default()).expect("physical");
    let by = [Start(0), Parameter(0)];
    let (model, x0) = sensitivity::seeded(&thrown, [1.0, 0.0], by);
    let floor = Event::new(|_t, x: &SVector<Dual<f64, 2>, 2>| x[0] - Dual::from_f64(0.1)).falling();
    let floor = floor.reset(|_t, x| SVector::from([x[0], x[1] * Dual::from_f64(-0.7)]));
    let [t0, t1] = [0.0, 0.7].map(Dual::from_f64);
    let method = Vern9::new().rtol(1e-12).atol(1e-12);
    let motion: Sensitivity<2, 2> = method.solve_with(&model, t0, t1, x0, &[floor]).expect("regular").into();
    let seeds = [
        Dual::variable(1.0, 0),
        Dual::variable(9.81, 1),
        Dual::from_f64(0.7),
        Dual::from_f64(0.1),
    ];
    for t in [0.5, 0.6, 0.7] {
        let [height, rate, at] = rebounded(seeds, Dual::from_f64(t));
        let expected = SMatrix::from_fn(|n, k| [height, rate][n].slopes[k]);
        close(
            &format!("reset at {t}"),
            &motion.at(t).expect("inside").1,
            &expected,
            1e-11,
        );
        let [event] = motion.solution().events() else {
            panic!("one event")
        };
        for k in 0..2 {
            assert!((event.t.slopes[k] - at.slopes[k]).abs() < 1e-11, "{:?} {at:?}", event.t);
        }
    }
    // a motion that an event ends: at the event, and just before
    let floor = Event::new(|_t, x: &SVector<Dual<f64, 2>, 2>| x[0] - Dual::from_f64(0.1)).terminal();
    let motion: Sensitivity<2, 2> = method.solve_with(&model, t0, t1, x0, &[floor]).expect("regular").into();
    let (x, slopes) = motion.end();
    assert!(
        (x[0] - 0.1).abs() < 1e-12 && slopes.row(0).amax() < 1e-11,
        "it ends on the floor: {slopes}"
    );
    let (t, _) = motion.solution().last();
    let at = rebounded(seeds, t)[2];
    assert!((t.slopes[0] - at.slopes[0]).abs() < 1e-11 && (t.slopes[1] - at.slopes[1]).abs() < 1e-11);
    let (_, at_end) = motion.at(t.value).expect("inside");
    let falling = SMatrix::from([[1.0, 0.0], [-0.5 * at.value * at.value, -at.value]]);
    close("at the time of the end", &at_end, &falling, 1e-10);
}

#[test]
fn a_motion_that_grazes_is_reported() {
    let thrown = Thrown::new(ThrownParams::default()).expect("physical");
    let (model, x0) = sensitivity::seeded(&thrown, [1.0, 0.0], [Start(0), Parameter(0)]);
    let above = |x: &SVector<Dual<f64, 2>, 2>| x[0] - Dual::from_f64(0.1);
    // its zero has no slope, so that the derivatives of its time are a quotient of zeros
    let touched = Event::new(move |_t, x: &SVector<_, 2>| above(x) * above(x) * above(x))
        .reset(|_t, x| *x * Dual::from_f64(-0.5));
    let [t0, t1] = [0.0, 0.7].map(Dual::from_f64);
    let error = Vern9::new()
        .solve_with(&model, t0, t1, x0, &[touched])
        .expect_err("no derivatives");
    assert!(
        error.to_string().contains("only touches the zero of an event"),
        "{error}"
    );
}

#[test]
fn variables_without_influence_are_listed() {
    let ball = Ball::new(BallParams::default()).expect("physical");
    // at rest in the air nothing is held
    let falls = sensitivity::solve(&Vern9::new(), &ball, 0.0, 0.3, [1.0, 0.0], [Start(1)]).expect("regular");
    close("rate", &falls.end().1, &SMatrix::from([[0.3, 1.0]]), 1e-12);
    let by = [Start(0), Parameter(0), Parameter(1), Parameter(2)];
    let falls = sensitivity::solve(&Vern9::new(), &ball, 0.0, 0.3, [1.0, 0.0], by).expect("regular");
    assert!(falls.without_influence().eq([2, 3]));
    let rebounds = sensitivity::solve(&Vern9::new(), &ball, 0.0, 0.7, [1.0, 0.0], by).expect("regular");
    assert_eq!(rebounds.without_influence().count(), 0);
    // the end alone is the same
    let (x, slopes) = sensitivity::end(&Vern9::new(), &ball, 0.0, 0.7, [1.0, 0.0], by).expect("regular");
    assert_eq!((x, slopes), rebounds.end());
}

/// Closed loops of a model and a law carry derivatives through both.
#[test]
fn laws_carry_derivatives() {
    let swing = Motor::new(MotorParams::default()).expect("physical");
    let closed = swing.with_law(Damping);
    let by = [Start(0), Parameter(2), Parameter(4)];
    let tight = Vern9::new().rtol(1e-13).atol(1e-13);
    let expected = by_differences(&tight, &closed, (0.0, 1.0), [0.5, 0.0, 0.0, 0.0], by);
    let motion = sensitivity::solve(&tight, &closed, 0.0, 1.0, [0.5, 0.0, 0.0, 0.0], by).expect("regular");
    close("law", &motion.end().1, &expected, 1e-9);
}

/// A voltage against the rate.
#[derive(Clone, PartialEq)]
struct Damping;

impl InputLaw<4, 1> for Damping {
    fn inputs<T: Real>(&self, _t: T, x: &SVector<T, 4>) -> [T; 1] {
        [x[Motor::DOT_THETA] * T::from_f64(-3.0)]
    }
}

mechanism! {
    /// Two balls that fall side by side.
    pub Pair {
        params { g: m/s^2 = 10 }
        gravity: [0, -g, 0],
        wall below_a { gap: a, restitution: 0.5 }
        wall below_b { gap: b, restitution: 0.5 }
        body first on ground { mass: 1, joint: prismatic(y), coordinate: a }
        body second on ground { mass: 1, joint: prismatic(y), coordinate: b }
    }
}

/// Contacts that close at the same time, and at other times for other values of the variables, are reported: one time
/// cannot carry the derivatives of both.
#[test]
fn simultaneous_contacts_are_reported_unless_they_stay_so() {
    let pair = Pair::new(PairParams::default()).expect("physical");
    let method = Vern9::new().rtol(1e-12).atol(1e-12);
    for starts in [[1.25, 1.25, 0.0, 0.0], [1.25, 1.25 + 1e-14, 0.0, 0.0]] {
        let error = sensitivity::end(&method, &pair, 0.0, 0.8, starts, [Start(0), Start(1)]).expect_err("two times");
        assert!(matches!(error, Reason::NotDifferentiable { .. }), "{error}");
        assert!(error.to_string().contains("close at the same time"), "{error}");
    }
    // gravity moves both contacts alike
    let by_gravity = sensitivity::end(&method, &pair, 0.0, 0.8, [1.25, 1.25, 0.0, 0.0], [Parameter(0)])
        .expect("one time")
        .1;
    let seeds = [
        Dual::constant(1.25),
        Dual::variable(10.0, 0),
        Dual::constant(0.5),
        Dual::constant(0.0),
    ];
    let [height, rate, _] = rebounded::<Dual<f64, 1>>(seeds, Dual::from_f64(0.8));
    let [height, rate] = [height, rate].map(|x| x.slopes[0]);
    close(
        "gravity",
        &by_gravity,
        &SMatrix::from([[height, height, rate, rate]]),
        1e-11,
    );
    // one after the other they have derivatives of their own
    let apart = sensitivity::end(&method, &pair, 0.0, 0.8, [1.25, 1.24, 0.0, 0.0], [Start(0), Start(1)])
        .expect("two times")
        .1;
    assert!(
        apart[(0, 1)].abs() < 1e-12 && apart[(1, 0)].abs() < 1e-12 && apart[(0, 0)] > 0.3 && apart[(1, 1)] > 0.3,
        "{apart}"
    );
}

mechanism! {
    /// A block on the floor, pushed.
    pub Push {
        params { f: N = 3, mu: N = 2 }
        body block on ground { mass: 1, joint: prismatic(x), coordinate: x, dry_friction: mu, torque: f }
    }
}

#[test]
fn a_start_from_rest_against_friction_has_the_derivatives_of_the_slip() {
    let by = [Start(1), Parameter(0), Parameter(1)];
    let slips = sensitivity::solve(
        &Vern9::new(),
        &Push::new(PushParams::default()).expect("physical"),
        0.0,
        1.0,
        [0.0; 2],
        by,
    );
    close(
        "slips",
        &slips.expect("regular").end().1,
        &SMatrix::from([[1.0, 1.0], [0.5, 1.0], [-0.5, -1.0]]),
        1e-12,
    );
    let weak = Push::new(PushParams { f: 1.0, mu: 2.0 }).expect("physical");
    let held = sensitivity::solve(&Vern9::new(), &weak, 0.0, 1.0, [0.0; 2], by).expect("regular");
    assert!(held.without_influence().eq([0, 1, 2]));
}

/// Checks that trajectories in lanes have the bits of single ones, with their derivatives.
#[track_caller]
fn same_in_lanes<'m, X, M, const N: usize, const P: usize, const K: usize>(
    method: &X,
    models: &'m [M],
    t1: f64,
    starts: &[SVector<f64, N>],
    variables: [Variable; K],
) where
    M: Parametric<N, P>,
    X: Method<M::In<Dual<f64, K>>, Dual<f64, K>, N> + Ensemble<Seeded<'m, M, N, P, K>, Dual<f64, K>, N>,
{
    let ends = sensitivity::ensemble(method, models, 0.0, t1, starts, variables).expect("regular");
    assert_eq!(ends.len(), starts.len());
    for (n, (end, &start)) in ends.into_iter().zip(starts).enumerate() {
        let model = if let [model] = models { model } else { &models[n] };
        let alone = sensitivity::end(method, model, 0.0, t1, start, variables).expect("regular");
        assert_eq!(end, alone, "trajectory {n}");
    }
}

#[test]
fn lanes_have_the_bits_of_single_trajectories() {
    let starts: Vec<_> = (0..21)
        .map(|n| SVector::from([0.1 * f64::from(n), 1.0, 0.0, 0.0]))
        .collect();
    let models: Vec<_> = (0..21)
        .map(|n| {
            let d = 0.5 + 0.1 * f64::from(n);
            DoublePendulum::new(DoublePendulumParams {
                d,
                ..DoublePendulumParams::default()
            })
            .expect("physical")
        })
        .collect();
    // a parameter may be several variables
    let variables = [Start(1), Parameter(0), Parameter(3), Parameter(0)];
    same_in_lanes(&Vern9::new(), &models, 2.0, &starts, variables);
    same_in_lanes(&Rk45::new(), &models[..1], 2.0, &starts, variables);
    same_in_lanes(&Rk4::new(0.05), &models, 2.0, &starts, variables);
    same_in_lanes(&Rodas5P::new(), &models, 1.0, &starts, variables);
    with_deep_stack(|| same_in_lanes(&Taylor::new(), &models, 1.0, &starts, variables));
}

#[test]
fn lanes_have_the_bits_of_single_trajectories_through_mode_switches() {
    let servo = Servo::new(ServoParams::default()).expect("physical");
    let starts: Vec<_> = (0..11)
        .map(|n| SVector::from([0.0, 0.5 * f64::from(n), 0.0, 0.0]))
        .collect();
    let variables = [Start(1), Parameter(4), Parameter(5)];
    same_in_lanes(&Vern7::new(), &[servo], 1.5, &starts, variables);
    let model = Motor::new(MotorParams::default()).expect("physical").with_law(Damping);
    same_in_lanes(&Vern7::new(), &[model], 1.5, &starts, variables);
}

/// Compares the power series of a model in dual numbers, whose derivatives come from the linearized equations, with
/// that in nested ones, whose derivatives pass through the recurrences of the motion.
fn assert_series_of_derivatives<M, const N: usize, const P: usize>(name: &str, model: &M)
where
    M: Parametric<N, P> + CastTaylor<N>,
{
    /// Number of derivatives: two registers, half of one, and a scalar.
    const K: usize = 11;
    type Nested = Dual<Dual<f64, 0>, K>;
    let mut random = Random::new(5);
    let mut dual = |value: f64| Dual::<f64, K> {
        value,
        slopes: std::array::from_fn(|_| random.between(-1.0, 1.0)),
    };
    let parameters = model.parameters().map(&mut dual);
    let start = SVector::<_, N>::from_fn(|n, _| dual((1.0 + 0.7 * n as f64).sin()));
    let nested = |number: Dual<f64, K>| Nested {
        value: Dual::constant(number.value),
        slopes: number.slopes.map(Dual::constant),
    };
    let (by_equations, by_recurrences) = (
        model.with_parameters(parameters),
        model.with_parameters(parameters.map(nested)),
    );
    let (by_equations, by_recurrences) = (
        M::with_series::<Dual<f64, K>>(&by_equations),
        M::with_series::<Nested>(&by_recurrences),
    );
    for length in [2, 3, 4, MAX_ORDER + 1] {
        let (mut x, mut expected) = (vec![start; length], vec![start.map(nested); length]);
        by_equations.series(Dual::constant(0.0), &mut x, &mut by_equations.workspace());
        by_recurrences.series(Nested::default(), &mut expected, &mut by_recurrences.workspace());
        for (order, (x, expected)) in x.iter().zip(&expected).enumerate() {
            let size = expected
                .iter()
                .flat_map(|x| x.slopes)
                .map(|slope| slope.value.abs())
                .fold(0.0, f64::max);
            for (x, expected) in x.iter().zip(expected) {
                assert_eq!(
                    x.value.to_bits(),
                    expected.value.value.to_bits(),
                    "{name}, order {order}"
                );
                for (slope, expected) in x.slopes.iter().zip(&expected.slopes) {
                    let error = (slope - expected.value).abs() / size;
                    assert!(error < 1e-13, "{name}, order {order} of {length}: {error:e}");
                }
            }
        }
    }
}

#[test]
fn linearized_equations_have_the_series_of_recurrences() {
    with_deep_stack(|| {
        let pendulum = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
        assert_series_of_derivatives("DoublePendulum", &pendulum);
        assert_series_of_derivatives("Elbow", &Elbow::new(ElbowParams {}).expect("physical"));
        assert_series_of_derivatives("Slides", &Slides::new(SlidesParams::default()).expect("physical"));
        let stars = HenonHeiles::new(HenonHeilesParams::default()).expect("physical");
        assert_series_of_derivatives("HenonHeiles", &stars);
    });
}

#[test]
fn an_ensemble_needs_a_model_for_each_start() {
    let model = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
    let start = SVector::from([1.0, 0.0, 0.0, 0.0]);
    let error = sensitivity::ensemble(&Vern9::new(), &[model; 2], 0.0, 1.0, &[start; 3], [Start(0)]);
    let error = error.expect_err("two models for three starts").to_string();
    assert!(error.contains("one model for all starts, or one for each"), "{error}");
    let none = sensitivity::ensemble(&Vern9::new(), &[model], 0.0, 1.0, &[], [Start(0)]);
    assert!(none.expect("nothing to do").is_empty());
}

mechanism! {
    /// A pendulum that swings at 1 rad/s when it swings little.
    Hanging {
        params { l: m = 1 }
        gravity: [0, -1, 0],
        body bob on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: angle }
        generate: [rhs, jacobian, taylor],
    }
}

#[test]
fn errors_of_derivatives_are_controlled_on_request() {
    let model = Hanging::new(HangingParams::default()).expect("physical");
    // at rest, where the errors of the state are zero
    let t1 = 10.0_f64;
    let expected = SMatrix::<f64, 2, 2>::new(t1.cos(), t1.sin(), -t1.sin(), t1.cos());
    macro_rules! check {
        ($method:expr, $within:expr) => {{
            let (method, variables) = ($method, [Start(0), Start(1)]);
            let end = |method| sensitivity::end(&method, &model, 0.0, t1, [0.0, 0.0], variables).expect("regular");
            let error = |method| (end(method).1 - expected).amax();
            let [controlled, free] = [true, false].map(|controls| error(method.control_derivatives(controls)));
            let name = stringify!($method);
            assert!(controlled < $within && free > 0.1, "{name}: {controlled:e}, {free:e}");
        }};
    }
    check!(Rk45::new().rtol(1e-8).atol(1e-8), 1e-6);
    check!(Tsit5::new().rtol(1e-8).atol(1e-8), 1e-6);
    check!(Vern7::new().rtol(1e-8).atol(1e-8), 1e-6);
    check!(Vern9::new().rtol(1e-8).atol(1e-8), 1e-6);
    check!(Taylor::new().rtol(1e-8).atol(1e-8), 1e-6);
    check!(Rodas4::new().rtol(1e-8).atol(1e-8), 1e-6);
    check!(Rodas5P::new().rtol(1e-8).atol(1e-8), 1e-6);
    check!(Radau5::new().rtol(1e-8).atol(1e-8), 1e-6);
    let method = Vern9::new().control_derivatives(true);
    let starts = [[0.0, 0.0], [0.5, 0.0], [0.0, 1.5]].map(SVector::from);
    same_in_lanes(&method, &[model], t1, &starts, [Start(0), Parameter(0)]);
    with_deep_stack(|| {
        let method = Taylor::new().control_derivatives(true);
        same_in_lanes(&method, &[model], t1, &starts, [Start(0), Parameter(0)]);
    });
}

mechanism! {
    /// A ball with the drag of the air.
    Dropped {
        params { drag: kg/m = 0.1 }
        gravity: [0, -9.81, 0],
        let speed = sqrt(dot(x)^2 + dot(y)^2),
        point centre on ball,
        force on centre: [-drag*speed*dot(x), -drag*speed*dot(y), 0],
        body across on ground { joint: prismatic(x), coordinate: x }
        body ball on across { mass: 1, joint: prismatic(y), coordinate: y }
    }
}

#[test]
fn a_root_of_zero_at_the_start_does_not_stop_what_does_not_vary_there() {
    let ball = Dropped::new(DroppedParams::default()).expect("physical");
    let method = Vern9::new().rtol(1e-11).atol(1e-11);
    let (_, ours) = sensitivity::end(&method, &ball, 0.0, 2.0, [0.0; 4], [Parameter(0)]).expect("regular");
    // v = v_t tanh(g t/v_t), with v_t^2 = m g/drag
    let rate = |drag: f64| {
        let last = (9.81 / drag).sqrt();
        -last * (9.81 * 2.0 / last).tanh()
    };
    let h = 1e-3;
    let expected = (8.0 * (rate(0.1 + h) - rate(0.1 - h)) - (rate(0.1 + 2.0 * h) - rate(0.1 - 2.0 * h))) / (12.0 * h);
    assert!(
        (ours[(3, 0)] - expected).abs() < 1e-6,
        "{} and not {expected}",
        ours[(3, 0)]
    );
}
