//! Forces between limits: their values and derivatives, and steps that end where they saturate.

use approx::assert_relative_eq;
use nalgebra::SVector;
use pendulum_core::prelude::*;
use pendulum_core::real::lanes::{F64x4, Lanes};
use pendulum_core::{Dense, ObservedEnsemble, Observer, Real, Solution};
use testbed::dual::Dual;

mechanism! {
    /// A cart on a spring whose force is at most `most`, and a motor with commands between 1 and -1.
    pub Cart {
        params { m: kg = 1, k: N/m = 10, most: N = 1, gain: N = 0.5 }
        input order: 1,
        generate: [rhs, jacobian],
        let pull = clamp(-k*x, -most, most),
        body cart on ground {
            mass: m,
            joint: prismatic(x),
            coordinate: x,
            torque: pull + gain*clamp(order, -1, 1),
        }
        event passes: x,
    }
}

mechanism! {
    /// The cart of `Cart` with its spring alone.
    pub Held {
        params { m: kg = 1, k: N/m = 10, most: N = 1 }
        generate: [rhs, jacobian, taylor],
        body cart on ground { mass: m, joint: prismatic(x), coordinate: x, torque: clamp(-k*x, -most, most) }
    }
}

/// Exact position at 1.5 s. From rest at 1.1 m the cart moves under constant force to 0.1 m, and then as on a spring.
fn exact() -> f64 {
    let (fall, rate) = (2.0_f64.sqrt(), 10.0_f64.sqrt());
    let (sin, cos) = (rate * (1.5 - fall)).sin_cos();
    0.1 * cos - fall / rate * sin
}

const START: [f64; 2] = [1.1, 0.0];

fn held() -> Held {
    Held::new(HeldParams::default()).expect("physical")
}

#[test]
fn forces_stay_between_their_limits() {
    let model = Cart::new(CartParams::default()).expect("physical");
    for (x, order, force) in [
        (0.05, 0.4, -0.5 + 0.2),
        (0.3, 0.4, -1.0 + 0.2),
        (-7.0, 3.0, 1.0 + 0.5),
        (-0.1, -3.0, 1.0 - 0.5),
    ] {
        let given = CartInputs { order };
        assert_eq!(model.eval(0.0, &SVector::from([x, 0.0]), &given)[1], force);
    }
    let undefined = model.eval(0.0, &SVector::from([f64::NAN, 0.0]), &CartInputs { order: 0.0 });
    assert!(undefined[1].is_nan(), "a limit must not hide it");
}

#[test]
fn derivatives_are_those_of_the_limit_beyond_it() {
    let model = Cart::new(CartParams::default()).expect("physical");
    let dual = model.cast::<Dual>();
    for (x, order) in [(0.05, 0.4), (0.3, 0.4), (-0.3, 1.4), (0.02, -1.4)] {
        let column = |seeds: [f64; 2]| {
            let state = SVector::from([Dual::new(x, seeds[0]), Dual::new(0.2, 0.0)]);
            let order = Dual::new(order, seeds[1]);
            dual.eval(Dual::new(0.0, 0.0), &state, &CartInputs { order })
                .map(|component| component.slope)
        };
        let (state, given) = (SVector::from([x, 0.2]), CartInputs { order });
        let by_state = model.eval_with_jacobian(0.0, &state, &given).1;
        assert_relative_eq!(by_state.column(0).into_owned(), column([1.0, 0.0]), epsilon = 1e-14);
        let by_input = model.input_jacobian(0.0, &state, &given);
        assert_relative_eq!(by_input.column(0).into_owned(), column([0.0, 1.0]), epsilon = 1e-14);
    }
}

#[test]
fn lanes_have_the_bits_of_scalars() {
    let model = held();
    let places = [-0.3, -0.1, 0.04, f64::NAN];
    let state = SVector::from([F64x4::from_fn(|i| places[i]), F64x4::from_f64(0.0)]);
    let forces = model.cast::<F64x4>().rhs(F64x4::from_f64(0.0), &state)[1];
    for (i, x) in places.into_iter().enumerate() {
        let alone = model.rhs(0.0, &SVector::from([x, 0.0]))[1];
        assert_eq!(forces.lane(i).to_bits(), alone.to_bits(), "at {x}");
    }
}

#[test]
fn events_are_those_declared_and_those_of_known_limits() {
    assert_eq!(Cart::EVENTS, ["passes", "saturation_1"]);
    let model = Cart::new(CartParams::default()).expect("physical");
    // the clamp of the input `order` is no event: only the control law determines its value
    assert_eq!(model.saturation_1(0.0, &[0.3, 0.0]), (-3.0 + 1.0) * (1.0 + 3.0));
    assert_relative_eq!(model.saturation_1(0.0, &[-0.02, 5.0]), 1.2 * 0.8, max_relative = 1e-15);
}

#[test]
fn limits_are_in_order() {
    let params = HeldParams {
        most: -1.0,
        ..Default::default()
    };
    let error = Held::new(params).expect_err("reversed limits").to_string();
    assert!(error.contains("must be in order: -most below most"), "{error}");
}

fn error_of(solution: &Solution<f64, 2>) -> f64 {
    (solution.last().1[0] - exact()).abs()
}

/// Classical steps have order 4 if they end at the kink, and about 2 if they cross it.
#[test]
fn steps_that_end_where_a_force_saturates_keep_their_order() {
    let model = held();
    let errors = [0.025, 0.0125, 0.00625].map(|h| {
        let method = Rk4::new(h);
        let with = method
            .solve_with(&model, 0.0, 1.5, START, &model.events())
            .expect("regular");
        assert_eq!(with.events().len(), 1);
        assert_relative_eq!(with.events()[0].t, 2.0_f64.sqrt(), epsilon = 1e-9);
        [
            error_of(&with),
            error_of(&method.solve(&model, 0.0, 1.5, START).expect("regular")),
        ]
    });
    for pair in errors.windows(2) {
        let order = (pair[0][0] / pair[1][0]).log2();
        assert!((3.7..4.3).contains(&order), "{errors:?}");
    }
    assert!(errors[2][0] < 1e-3 * errors[2][1], "{errors:?}");
}

#[test]
fn every_method_ends_a_step_there() {
    const TOLERANCE: f64 = 1e-9;
    fn check(name: &str, solution: &Solution<f64, 2>) {
        let error = error_of(solution);
        assert!(error < 10.0 * TOLERANCE, "{name}: {error:e}");
        let kink = solution.events()[0].t;
        let ends = solution.points().any(|(t, _)| t == kink);
        assert!(
            ends && (kink - 2.0_f64.sqrt()).abs() < 10.0 * TOLERANCE,
            "{name}: {kink}"
        );
    }
    let model = held();
    macro_rules! methods {
        ($($method:ident)*) => { $(
            let method = $method::new().rtol(TOLERANCE).atol(TOLERANCE);
            let solution = method.solve_with(&model, 0.0, 1.5, START, &model.events()).expect("regular");
            check(stringify!($method), &solution);
        )* };
    }
    methods! { Rk45 Tsit5 Vern7 Vern9 Rodas5P Radau5 Taylor Auto }
}

/// A motion continues from rest at the limit, where rounding errors decide if the force saturates.
#[test]
fn a_force_that_rests_at_its_limit_is_no_end() {
    mechanism! {
        pub Level {
            params { most: N = 1, k: N/m = 10 }
            generate: [rhs, jacobian],
            body cart on ground { mass: 1, joint: prismatic(x), coordinate: x, friction: 2,
                torque: clamp(-k*x, -most, most) + most }
        }
    }
    let model = Level::new(LevelParams::default()).expect("physical");
    let solution = Vern9::new()
        .solve_with(&model, 0.0, 50.0, [0.02, 0.0], &model.events())
        .expect("regular");
    let (t, x) = solution.last();
    assert!(t == 50.0 && x[0] > 0.0999, "{x}");
    assert!(solution.statistics().accepted < 2000, "{:?}", solution.statistics());
}

/// Trajectories of an ensemble end their steps at the same times as single ones.
#[test]
fn ensembles_have_the_bits_of_trajectories_alone() {
    let model = held();
    let starts: Vec<SVector<f64, 2>> = (0..11)
        .map(|n| SVector::from([0.3 + 0.1 * f64::from(n), 0.0]))
        .collect();
    let events = model.events();
    let method = Tsit5::new();
    let mut seen = vec![Last; starts.len()];
    let ends = method
        .observe(&[held()], (0.0, 1.5), &starts, |_| &events, &mut seen)
        .expect("regular");
    for (start, end) in starts.iter().zip(ends) {
        let alone = method.solve_with(&model, 0.0, 1.5, *start, &events).expect("regular");
        assert_eq!(end, alone.last().1);
    }
}

/// Observer that stores nothing.
#[derive(Clone)]
struct Last;

impl Observer<f64, 2> for Last {
    fn step(&mut self, _: &Dense<'_, f64, 2>) {}
}

mechanism! {
    /// A servo that saturates on its way to 1.2 rad.
    pub Servo {
        gravity: [0, -9.81, 0],
        body arm on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle,
            torque: clamp(40*(1.2 - angle) - 8 N m s*qd + 9.81*sin(angle), -6, 6),
        }
    }
}

/// Each crossing of a limit is one event, and no step is of the length of rounding errors.
#[test]
fn a_crossing_is_recorded_once() {
    fn check(name: &str, start: f64, solution: &Solution<f64, 2>) {
        let times: Vec<f64> = solution.events().iter().map(|event| event.t).collect();
        let apart = times.windows(2).all(|pair| pair[1] - pair[0] > 1e-9);
        assert!(apart, "{name} from {start}: {times:?}");
        let steps = solution.t().windows(2).all(|pair| pair[1] - pair[0] > 1e-12);
        assert!(steps, "{name} from {start}: {:?}", solution.t());
    }
    let model = Servo::new(ServoParams {}).expect("physical");
    for n in 0..60 {
        let start = 0.02 * f64::from(n);
        macro_rules! methods {
            ($($method:expr),*) => { $(
                let solution = $method.solve_with(&model, 0.0, 10.0, [start, 0.0], &model.events());
                check(stringify!($method), start, &solution.expect("regular"));
            )* };
        }
        methods!(
            Rk4::new(0.02),
            Vern9::new().rtol(1e-9).atol(1e-9),
            Tsit5::new(),
            Rodas5P::new(),
            Auto::new()
        );
    }
}

/// A limit that is reached together with a stop: the impact is no zero of an event.
#[test]
fn a_kink_at_an_impact_leaves_other_events_alone() {
    mechanism! {
        pub EndStop {
            params { s: m = 1 }
            event turns: dot(a),
            body a on ground {
                mass: 1, joint: prismatic(x), coordinate: a, stop: [-1, 1] restitution(0.5),
                torque: 1 N + 1 N/m*clamp(a, -s, s),
            }
        }
    }
    let turns = |s: f64| {
        let model = EndStop::new(EndStopParams { s }).expect("physical");
        let solution = Vern9::new()
            .solve_with(&model, 0.0, 4.0, [0.0, 0.0], &model.events())
            .expect("regular");
        let turns = solution
            .events()
            .iter()
            .filter(|event| event.index == 0 && event.t > 0.0);
        let turns: Vec<[f64; 2]> = turns.map(|event| event.x.into()).collect();
        assert!(turns.iter().all(|x| x[1].abs() < 1e-9), "{s}: {turns:?}");
        turns.len()
    };
    assert_eq!(turns(1.0), turns(0.9));
}

/// A range that is crossed within 1/500 of a step is not missed, and ends steps where the method can resolve it.
#[test]
fn steep_limits_are_found() {
    let params = HeldParams {
        k: 1e4,
        ..Default::default()
    };
    let model = Held::new(params).expect("physical");
    let coarse = Rk4::new(0.1).solve_with(&model, 0.0, 5.0, [0.537, 0.0], &model.events());
    assert!(coarse.expect("regular").events().len() >= 4);
    let start = [0.537, 0.0];
    let tight = Vern9::new()
        .rtol(1e-13)
        .atol(1e-13)
        .solve(&model, 0.0, 5.0, start)
        .expect("regular")
        .end();
    let method = Vern7::new().rtol(1e-6).atol(1e-6);
    let with = method
        .solve_with(&model, 0.0, 5.0, start, &model.events())
        .expect("regular");
    assert_eq!(with.events().len(), 4, "{:?}", with.events());
    let error = |end: SVector<f64, 2>| (end - tight).norm();
    let without = error(method.solve(&model, 0.0, 5.0, start).expect("regular").end());
    assert!(
        error(with.end()) < 0.1 * without,
        "{:e}, {without:e}",
        error(with.end())
    );
}

/// A limit that is never reached does not blur the other one.
#[test]
fn a_far_limit_takes_no_digits() {
    mechanism! {
        pub Rope {
            params { top: N = 1e15, k: N/m = 50 }
            body a on ground {
                mass: 1, joint: prismatic(x), coordinate: l, torque: 2 N - clamp(k*(l - 1 m), 0, top),
            }
        }
    }
    let model = Rope::new(RopeParams::default()).expect("physical");
    let solution = Vern9::new()
        .solve_with(&model, 0.0, 1.5, [0.0, 0.0], &model.events())
        .expect("regular");
    assert_relative_eq!(solution.events()[0].t, 1.0, epsilon = 1e-13);
}

/// An unstable step crosses its limits again and again: the number of steps stays bounded.
#[test]
fn unstable_steps_do_not_multiply() {
    mechanism! {
        pub Damped {
            params { d: N s/m = 1e6 }
            body a on ground {
                mass: 1, joint: prismatic(x), coordinate: x1, torque: clamp(-d*dot(x1) - 1 N/m*x1, -1e6, 1e6),
            }
        }
    }
    let model = Damped::new(DampedParams::default()).expect("physical");
    let solution = Rk4::new(0.1)
        .solve_with(&model, 0.0, 10.0, [0.3, 2.0], &model.events())
        .expect("finite");
    assert!(solution.t().len() < 1000, "{}", solution.t().len());
}

/// A kink begins no mode.
#[test]
fn modes_begin_where_they_change() {
    mechanism! {
        pub Rubbed {
            body a on ground {
                mass: 1, joint: prismatic(x), coordinate: a, dry_friction: 0.1,
                torque: -2 N/m*a + clamp(3 N/m*a, -0.5, 0.5),
            }
        }
    }
    let model = Rubbed::new(RubbedParams {}).expect("physical");
    let modes = |events: &[pendulum_core::Event<f64, 2>]| {
        let solution = Vern9::new()
            .solve_with(&model, 0.0, 20.0, [1.0, 0.0], events)
            .expect("regular");
        solution.modes().len()
    };
    assert_eq!(modes(&model.events()), modes(&[]));
}
