//! Dry friction, stops and walls: generated code and motion.

use std::array::from_fn;

use nalgebra::SVector;
use pendulum_core::Slot;
use pendulum_core::hybrid::{Constraint, Hold, Hybrid, HybridJacobian, InMode, MAX_CONSTRAINTS, Mode, Status};
use pendulum_core::prelude::*;
use pendulum_core::real::Real;
use pendulum_core::stability::equilibrium;
use pendulum_core::system::{Differences, WithJacobian};
use pendulum_core::taylor::HybridSeries;
use pendulum_core::{Canonical, Plant, Solution, SolveError, TaylorSeries};
use testbed::dual::Dual;
use testbed::power_series::difference;
use testbed::power_series::{LENGTH, Series, motion};
use testbed::random::{Random, share};

mechanism! {
    /// Dry friction on both joints, and a wall at the tip.
    pub Dry {
        params { m: kg = 0.7, l: m = 0.8, mu: N m = 0.4, more: N m = 0.1, e: 1 = 0.6 }
        generate: [rhs, jacobian, energy, taylor, canonical, parameter_jacobian],
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(m, [0, 0, 0], [0, -l, 0])] }
        point tip on lower at [0, -l, 0],
        wall side { gap: 1 + tip.x - tip.y^2/7 m, restitution: e, slow: 0.001 }
        body upper on ground: arm {
            joint: revolute(z), coordinate: a, dry_friction: mu, static_friction: mu + more, friction: 0.03,
        }
        body lower on upper: arm {
            joint: revolute(z) at [0, -l, 0], coordinate: b, dry_friction: 0.2, stop: [-2, 2.5] restitution(0.3, 0.01),
        }
    }
}

mechanism! {
    /// The bodies of `Dry` without constraints, with the same forces as inputs.
    pub Smooth {
        params { m: kg = 0.7, l: m = 0.8 }
        input on_a: N m,
        input on_b: N m,
        input on_tip: N,
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(m, [0, 0, 0], [0, -l, 0])] }
        point tip on lower at [0, -l, 0],
        force on tip: [on_tip, -2/7*on_tip*tip.y/1 m, 0],
        body upper on ground: arm { joint: revolute(z), coordinate: a, torque: on_a, friction: 0.03 }
        body lower on upper: arm { joint: revolute(z) at [0, -l, 0], coordinate: b, torque: on_b }
    }
}

mechanism! {
    /// Absolute coordinates, a driven joint, a moving wall, and bodies declared in another order than their joints.
    pub Driven {
        params { w: rad/s = 3, mu: N m = 0.3 }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, inverse_dynamics, drive_forces, mass_matrix, taylor, canonical],
        point tip on last at [0, -0.5, 0],
        output speed: dot(tip.x),
        wall lid { gap: 2 - tip.y + 0.1 m*sin(w*t) + tip.x/9 }
        body last on middle {
            solids: [rod(0.3, [0, 0, 0], [0, -0.5, 0])], joint: revolute(-z) at [0, -0.6, 0], coordinate: c,
            dry_friction: mu,
        }
        body middle on first {
            solids: [rod(0.4, [0, 0, 0], [0, -0.6, 0])], joint: revolute(z) at [0, -0.7, 0], coordinate: b absolute,
            dry_friction: 0.2, static_friction: 0.25, stop: [-1, 1],
        }
        body first on turned {
            mass: 1, com: [0, -0.4, 0], inertia: 0.1, joint: revolute(z), coordinate: a absolute, stop: [-2, 2],
        }
        body turned on slide { joint: revolute(z), motion: 0.3*sin(w*t) }
        body slide on ground { mass: 1, joint: prismatic(x), coordinate: s, dry_friction: 2 }
    }
}

mechanism! {
    /// The bodies of `Driven` without constraints.
    pub DrivenSmooth {
        params { w: rad/s = 3 }
        input on_s: N,
        input on_first: N m,
        input on_middle: N m,
        input on_last: N m,
        input on_tip: N,
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, inverse_dynamics, drive_forces, mass_matrix],
        point tip on last at [0, -0.5, 0],
        force on tip: [on_tip/9, -on_tip, 0],
        body last on middle {
            solids: [rod(0.3, [0, 0, 0], [0, -0.5, 0])], joint: revolute(-z) at [0, -0.6, 0], coordinate: c,
            torque: on_last,
        }
        body middle on first {
            solids: [rod(0.4, [0, 0, 0], [0, -0.6, 0])], joint: revolute(z) at [0, -0.7, 0], coordinate: b absolute,
            torque: on_middle,
        }
        body first on turned {
            mass: 1, com: [0, -0.4, 0], inertia: 0.1, joint: revolute(z), coordinate: a absolute, torque: on_first,
        }
        body turned on slide { joint: revolute(z), motion: 0.3*sin(w*t) }
        body slide on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: on_s }
    }
}

fn dry() -> Dry {
    Dry::new(DryParams::default()).expect("physical")
}

fn driven() -> Driven {
    Driven::new(DrivenParams::default()).expect("physical")
}

/// Random times, states, and forces on the first `count` constraints.
fn places<const N: usize>(count: usize) -> impl Iterator<Item = (f64, SVector<f64, N>, [f64; MAX_CONSTRAINTS])> {
    let mut random = Random::new(5);
    (0..40).map(move |_| {
        let x = SVector::from_fn(|_, _| random.between(-1.5, 1.5));
        let forces = from_fn(|n| if n < count { random.between(-2.0, 2.0) } else { 0.0 });
        (random.between(0.0, 3.0), x, forces)
    })
}

fn assert_near(ours: f64, theirs: f64, what: &str) {
    let allowed = 1e-11 * (1.0 + theirs.abs());
    assert!((ours - theirs).abs() <= allowed, "{what}: {ours:e}, not {theirs:e}");
}

fn assert_all_near<const N: usize>(ours: &SVector<f64, N>, theirs: &SVector<f64, N>, what: &str) {
    for (ours, theirs) in ours.iter().zip(theirs.iter()) {
        assert_near(*ours, *theirs, what);
    }
}

#[test]
fn forces_act_as_torques_and_forces_on_points_do() {
    let (model, smooth) = (dry(), Smooth::new(SmoothParams::default()).expect("physical"));
    for (t, x, forces) in places(3) {
        let u = SmoothInputs {
            on_a: forces[0],
            on_b: forces[1],
            on_tip: forces[2],
        };
        let (rhs, jacobian) = smooth.eval_with_jacobian(t, &x, &u);
        assert_all_near(&model.eval(t, &x, &forces), &rhs, "right-hand side");
        let (own_rhs, own_jacobian) = model.eval_with_jacobian(t, &x, &forces);
        assert_all_near(&own_rhs, &rhs, "with its Jacobian");
        // the force on the tip is constant in both, but its direction changes with the position
        for (n, column) in own_jacobian.column_iter().enumerate() {
            assert_all_near(&column.into(), &jacobian.column(n).into(), "Jacobian");
        }
    }
    let (model, smooth) = (
        driven(),
        DrivenSmooth::new(DrivenSmoothParams::default()).expect("physical"),
    );
    for (t, x, forces) in places(5) {
        let [on_s, on_first, on_middle, on_last, on_tip, ..] = forces;
        let u = DrivenSmoothInputs {
            on_s,
            on_first,
            on_middle,
            on_last,
            on_tip,
        };
        let (rhs, jacobian) = smooth.eval_with_jacobian(t, &x, &u);
        assert_all_near(&model.eval(t, &x, &forces), &rhs, "right-hand side");
        let (own_rhs, own_jacobian) = model.eval_with_jacobian(t, &x, &forces);
        assert_all_near(&own_rhs, &rhs, "with its Jacobian");
        assert!((own_jacobian - jacobian).amax() < 1e-10 * jacobian.amax());
    }
}

/// Order of the constraints, and the sums of rates that form theirs.
#[test]
fn constraints_name_their_rates() {
    fn listed<'a>(constraints: &[Constraint<'a>]) -> Vec<(&'a str, Vec<(usize, i8)>)> {
        constraints.iter().map(|c| (c.name, c.rate.to_vec())).collect()
    }
    let (dry, driven) = (dry(), driven());
    let of_dry = Plant::<f64, 4>::constraints(&dry);
    assert_eq!(
        listed(of_dry),
        [("a", vec![(2, 1)]), ("b", vec![(3, 1)]), ("side", vec![])]
    );
    // the order of the state is c, b, a, s; a driven joint is below `first`, and `last` turns backwards
    let of_driven = Plant::<f64, 8>::constraints(&driven);
    let expected = [
        ("s", vec![(7, 1)]),
        ("a", vec![]),
        ("b", vec![(6, -1), (5, 1)]),
        ("c", vec![(4, 1)]),
        ("lid", vec![]),
    ];
    assert_eq!(listed(of_driven), expected);
}

#[test]
fn laws_are_those_declared() {
    let model = Dry::new(DryParams {
        mu: 0.5,
        more: 0.25,
        e: 0.75,
        ..DryParams::default()
    })
    .expect("physical");
    let [a, b, side, none, ..] = Plant::<f64, 4>::laws(&model);
    assert_eq!((a.slipping, a.sticking, a.low, a.high), (0.5, 0.75, None, None));
    assert_eq!(
        (b.slipping, b.sticking, b.low, b.high),
        (0.2, 0.2, Some(-2.0), Some(2.5))
    );
    assert_eq!((b.restitution, b.slow), (0.3, 0.01));
    assert_eq!(
        (side.sticking, side.low, side.high, side.restitution, side.slow),
        (0.0, Some(0.0), None, 0.75, 0.001)
    );
    assert_eq!(none, pendulum_core::hybrid::Law::default());
    let [_, a, b, ..] = Plant::<f64, 8>::laws(&driven());
    assert_eq!(
        (a.sticking, a.low, b.slipping, b.sticking),
        (0.0, Some(-2.0), 0.2, 0.25)
    );
    let refused = |params: DryParams| Dry::new(params).expect_err("refused").rule;
    let rules = [
        (
            DryParams {
                mu: -1.0,
                more: 2.0,
                ..DryParams::default()
            },
            "the dry friction of `upper` must not be negative",
        ),
        (
            DryParams {
                more: -0.1,
                ..DryParams::default()
            },
            "the static friction of `upper` must not be below its dry friction",
        ),
        (
            DryParams {
                e: 1.5,
                ..DryParams::default()
            },
            "the restitution of wall `side` must lie between 0 and 1",
        ),
        (
            DryParams {
                e: -0.5,
                ..DryParams::default()
            },
            "the restitution of wall `side` must lie between 0 and 1",
        ),
    ];
    for (params, rule) in rules {
        assert_eq!(refused(params), rule);
    }
}

/// State in dual numbers, with its slope along a direction.
fn along<const N: usize>(x: &SVector<f64, N>, direction: &SVector<f64, N>) -> SVector<Dual, N> {
    SVector::from_fn(|n, _| Dual::new(x[n], direction[n]))
}

/// Checks a response against the right-hand side, and its derivatives against dual numbers.
pub(crate) fn check_response<S, D, const N: usize>(model: &S, dual: &D, count: usize)
where
    S: HybridJacobian<f64, N>,
    D: System<Dual, N> + Hybrid<Dual, N>,
{
    let lift = |forces: &[f64; MAX_CONSTRAINTS]| forces.map(Dual::from_f64);
    for (t, x, forces) in places::<N>(count) {
        // quaternions have unit length
        let mut x: SVector<Dual, N> = x.map(Dual::from_f64);
        dual.project(Dual::from_f64(t), &mut x);
        let x = x.map(|x| x.value);
        let response = model.response(t, &x, &forces);
        assert_all_near(&response.rates, &model.eval(t, &x, &forces), "rates");
        let measures = model.measures(t, &x);
        // derivatives of the measures along the motion: rates, and second derivatives
        let moved = along(&x, &response.rates);
        let along_motion = dual.measures(Dual::new(t, 1.0), &moved);
        for n in 0..MAX_CONSTRAINTS {
            assert_near(measures[n][1], along_motion[n][0].slope, "rate");
            assert_near(response.accelerations[n], along_motion[n][1].slope, "second derivative");
            let mut more = forces;
            more[n] += 1.0;
            let pushed = model.response(t, &x, &more);
            assert_all_near(&response.columns[n], &(pushed.rates - response.rates), "column");
            for m in 0..MAX_CONSTRAINTS {
                assert_near(
                    response.matrix[m][n],
                    pushed.accelerations[m] - response.accelerations[m],
                    "matrix",
                );
                assert!(response.matrix[m][n] == response.matrix[n][m], "symmetric");
            }
            assert_eq!(response.matrix[n][n] > 0.0, n < count);
            assert!(response.columns[n].iter().take(N / 2).all(|&rate| rate == 0.0));
        }
        let derivative = model.response_derivative(t, &x, &forces);
        assert_all_near(&derivative.response.rates, &response.rates, "rates beside derivatives");
        for n in 0..MAX_CONSTRAINTS {
            assert_near(
                derivative.response.accelerations[n],
                response.accelerations[n],
                "beside derivatives",
            );
            assert_all_near(
                &derivative.response.columns[n],
                &response.columns[n],
                "beside derivatives",
            );
            for m in 0..MAX_CONSTRAINTS {
                assert_near(
                    derivative.response.matrix[n][m],
                    response.matrix[n][m],
                    "beside derivatives",
                );
            }
        }
        let near = |ours: f64, theirs: f64, what: &str| {
            assert!(
                (ours - theirs).abs() <= 1e-9 * (1.0 + theirs.abs()),
                "{what}: {ours:e}, not {theirs:e}"
            );
        };
        for component in 0..N {
            let direction = SVector::from_fn(|n, _| f64::from(u8::from(n == component)));
            let theirs = dual.response(Dual::from_f64(t), &along(&x, &direction), &lift(&forces));
            for n in 0..N {
                near(
                    derivative.rates[(n, component)],
                    theirs.rates[n].slope,
                    "derivative of the rates",
                );
            }
            for n in 0..MAX_CONSTRAINTS {
                near(
                    derivative.accelerations[n][component],
                    theirs.accelerations[n].slope,
                    "gradient",
                );
            }
        }
        let theirs = dual.response(Dual::new(t, 1.0), &along(&x, &SVector::zeros()), &lift(&forces));
        for n in 0..N {
            near(derivative.rates_by_time[n], theirs.rates[n].slope, "by time");
        }
        for n in 0..MAX_CONSTRAINTS {
            near(
                derivative.accelerations_by_time[n],
                theirs.accelerations[n].slope,
                "second derivative by time",
            );
        }
    }
}

#[test]
fn responses_are_those_of_the_right_hand_side() {
    check_response::<_, _, 4>(&dry(), &dry().cast::<Dual>(), 3);
    check_response::<_, _, 8>(&driven(), &driven().cast::<Dual>(), 5);
}

/// On its own, a model has friction against each rate, and no other forces along its constraints.
#[test]
fn the_right_hand_side_has_friction_by_the_sign_of_each_rate() {
    let model = driven();
    for (t, x, _) in places::<8>(5) {
        let (laws, measures) = (Plant::<f64, 8>::laws(&model), model.measures(t, &x));
        let forces = from_fn(|n| -laws[n].slipping * Real::signum(measures[n][1]));
        let rhs = model.eval(t, &x, &forces);
        assert_eq!(model.rhs(t, &x), rhs);
        assert_eq!(model.rhs_and_jacobian(t, &x), model.eval_with_jacobian(t, &x, &forces));
        // drive forces, rates of outputs and inverse dynamics include the same friction
        let smooth = DrivenSmooth::new(DrivenSmoothParams::default()).expect("physical");
        let [on_s, on_first, on_middle, on_last, on_tip, ..] = forces;
        let u = DrivenSmoothInputs {
            on_s,
            on_first,
            on_middle,
            on_last,
            on_tip,
        };
        assert_near(
            model.drive_forces(t, &x)[0],
            smooth.drive_forces(t, &x, &u)[0],
            "drive force",
        );
        let moved = model.cast::<Dual>().speed(Dual::new(t, 1.0), &along(&x, &rhs));
        assert_near(model.speed_rate(t, &x), moved.slope, "rate of an output");
        let qdd = SVector::from_fn(|n, _| 0.3 * n as f64 - 0.2);
        assert_all_near(
            &model.inverse_dynamics(t, &x, &qdd),
            &smooth.inverse_dynamics(t, &x, &qdd),
            "inverse dynamics",
        );
        assert_near(model.energy(t, &x), smooth.energy(t, &x), "energy");
    }
}

mechanism! {
    /// A block on a plane that is slightly tilted.
    pub Block {
        params { m: kg = 2, mu: N = 0.5, at_rest: N = 0.75, pull: N = 0.25 }
        body block on ground {
            mass: m, joint: prismatic(x), coordinate: s,
            dry_friction: mu, static_friction: at_rest, torque: pull, stop: [-10, 1] restitution(0.5),
        }
    }
}

mechanism! {
    pub Pendulum {
        params { mu: N m = 0.3 }
        gravity: [0, -9.81, 0],
        body rod on ground {
            solids: [rod(1, [0, 0, 0], [0, -1, 0])], joint: revolute(z), coordinate: theta, dry_friction: mu,
        }
    }
}

mechanism! {
    /// A ball above a floor that may rise.
    pub Ball {
        params { e: 1 = 0.8, v: m/s = 0 }
        gravity: [0, -9.81, 0],
        point under on ball,
        /// The floor.
        wall floor { gap: under.y - v*t, restitution: e }
        body ball on ground { mass: 1, joint: prismatic(y), coordinate: h }
    }
}

mechanism! {
    /// A ball between two walls, without derivatives and without parameters.
    pub Between {
        generate: [rhs],
        wall left { gap: s, restitution: 1 }
        wall right { gap: 1 - s, restitution: 1 }
        body ball on ground { mass: 1, joint: prismatic(x), coordinate: s }
    }
}

/// Solves with each method, at a tolerance of 1e-13 if the method is adaptive.
macro_rules! with_each {
    (|$method:ident| $check:expr) => {
        with_each!(@ $method, $check, Tsit5::new().rtol(1e-13).atol(1e-13), "Tsit5");
        with_each!(@ $method, $check, Vern9::new().rtol(1e-13).atol(1e-13), "Vern9");
        with_each!(@ $method, $check, Rodas5P::new().rtol(1e-13).atol(1e-13), "Rodas5P");
        with_each!(@ $method, $check, Radau5::new().rtol(1e-13).atol(1e-13), "Radau5");
        with_each!(@ $method, $check, Rk4::new(1.0 / 256.0), "Rk4");
    };
    (@ $method:ident, $check:expr, $given:expr, $name:literal) => {{
        let $method = $given;
        let holds: bool = $check;
        assert!(holds, $name);
    }};
}

fn near(ours: f64, theirs: f64) -> bool {
    let is_near = (ours - theirs).abs() <= 1e-12 * (1.0 + theirs.abs());
    if !is_near {
        eprintln!("{ours:e}, not {theirs:e}");
    }
    is_near
}

#[test]
fn a_block_comes_to_rest_where_and_when_it_must() {
    let model = Block::new(BlockParams::default()).expect("physical");
    // pulled by less than static friction: decelerates by mu - pull
    let (v0, a) = (-0.6, (0.5 + 0.25) / 2.0);
    with_each!(|method| {
        let solution = method.solve(&model, 0.0, 4.0, [0.0, v0]).expect("a motion");
        let (rests, mode) = *solution.modes().last().expect("a mode");
        near(rests, -v0 / a)
            && mode.0[0] == Status::Stuck
            && near(solution.end()[0], -v0 * v0 / (2.0 * a))
            && solution.end()[1] == 0.0
    });
    // pulled by more than static friction, into the stop, from which it rebounds
    let model = Block::new(BlockParams {
        pull: 1.0,
        ..BlockParams::default()
    })
    .expect("physical");
    let (pushed, braked) = ((1.0 - 0.5) / 2.0, (1.0 + 0.5) / 2.0);
    let hits = (2.0_f64 / pushed).sqrt();
    let back = 0.5 * pushed * hits;
    let height = back * back / (2.0 * braked);
    let (turns, again) = (
        hits + back / braked,
        hits + back / braked + (2.0 * height / pushed).sqrt(),
    );
    with_each!(|method| {
        let solution = method.solve(&model, 0.0, again - 1e-3, [0.0, 0.0]).expect("a motion");
        let times: Vec<f64> = solution.modes().iter().map(|(t, _)| *t).collect();
        let at_end = 1.0 - height + 0.5 * pushed * (again - 1e-3 - turns).powi(2);
        times.len() == 3 && near(times[1], hits) && near(times[2], turns) && near(solution.end()[0], at_end)
    });
}

#[test]
fn a_pendulum_comes_to_rest() {
    let model = Pendulum::new(PendulumParams::default()).expect("physical");
    let mut rests = Vec::new();
    with_each!(|method| {
        let solution = method.solve(&model, 0.0, 20.0, [2.0, 0.0]).expect("a motion");
        let (theta, rate) = (solution.end()[0], solution.end()[1]);
        rests.push(theta);
        // friction holds it there
        let (_, mode) = *solution.modes().last().expect("a mode");
        rate == 0.0 && mode.0[0] == Status::Stuck && (0.5 * 9.81 * theta.sin()).abs() < 0.3 && theta != 0.0
    });
    // by energy: each swing loses the friction times its angle
    let swing = |from: f64| {
        let (mut low, mut high) = (0.0, from.abs());
        for _ in 0..200 {
            let to: f64 = (low + high) / 2.0;
            let left = 0.5 * 9.81 * (to.cos() - from.abs().cos()) - 0.3 * (from.abs() + to);
            if left > 0.0 { low = to } else { high = to }
        }
        -from.signum() * low
    };
    let mut place: f64 = 2.0;
    while (0.5 * 9.81 * place.sin()).abs() > 0.3 {
        place = swing(place);
    }
    for theta in &rests[..4] {
        assert!((theta - place).abs() < 1e-10, "{theta:e}, not {place:e}");
    }
    assert!((rests[4] - place).abs() < 1e-6, "{:e}, not {place:e}", rests[4]);
}

#[test]
fn a_ball_rebounds_and_comes_to_rest() {
    let model = Ball::new(BallParams::default()).expect("physical");
    let fall = (2.0_f64 / 9.81).sqrt();
    let rests = fall * (1.0 + 2.0 * 0.8 / (1.0 - 0.8));
    with_each!(|method| {
        let solution = method.solve(&model, 0.0, 5.0, [1.0, 0.0]).expect("a motion");
        let (t, mode) = *solution.modes().last().expect("a mode");
        near(t, rests) && mode.0[0] == Status::Low && solution.end()[0].abs() < 1e-12 && solution.end()[1] == 0.0
    });
    // a rising floor carries it along
    let model = Ball::new(BallParams { e: 0.0, v: 0.5 }).expect("physical");
    let meets = (-0.5 + (0.25_f64 + 2.0 * 9.81).sqrt()) / 9.81;
    with_each!(|method| {
        let solution = method.solve(&model, 0.0, 2.0, [1.0, 0.0]).expect("a motion");
        let (t, _) = *solution.modes().last().expect("a mode");
        near(t, meets) && near(solution.end()[0], 0.5 * 2.0) && near(solution.end()[1], 0.5)
    });
}

#[test]
fn a_ball_goes_to_and_fro_between_walls() {
    let model = Between::new(BetweenParams {}).expect("physical");
    let solution = Tsit5::new().solve(&model, 0.0, 10.0, [0.5, 2.0]).expect("a motion");
    // a path of 20 m: to and fro ten times
    assert!(
        near(solution.end()[0], 0.5) && near(solution.end()[1], 2.0),
        "{}",
        solution.end()
    );
    assert_eq!(solution.modes().len(), 21);
}

/// Simultaneous impacts are one, with one restitution.
#[test]
fn an_elastic_ball_shares_its_rate_with_two_that_touch() {
    mechanism! {
        pub Cradle {
            wall first { gap: b - a, restitution: 1 }
            wall second { gap: c - b, restitution: 1 }
            body ball_a on ground { mass: 1, joint: prismatic(x), coordinate: a }
            body ball_b on ground { mass: 1, joint: prismatic(x), coordinate: b }
            body ball_c on ground { mass: 1, joint: prismatic(x), coordinate: c }
        }
    }
    let cradle = Cradle::new(CradleParams {}).expect("physical");
    for (gap, rates) in [(0.0, [-1.0, 2.0, 2.0].map(|rate| rate / 3.0)), (0.01, [0.0, 0.0, 1.0])] {
        let solution = Vern7::new().solve(&cradle, 0.0, 1.0, [-0.5, 0.0, gap, 1.0, 0.0, 0.0]);
        let end = solution.expect("a motion").end();
        for (n, rate) in rates.into_iter().enumerate() {
            assert_near(end[3 + n], rate, "rate");
        }
    }
}

/// Two joints stick and slip, and a stop and a wall are hit: all methods agree, and the energy never grows.
#[test]
fn methods_agree_on_a_dry_double_pendulum() {
    let model = dry();
    let start = [1.2, 0.4, -3.0, 2.0];
    let reference = Vern9::new()
        .rtol(1e-13)
        .atol(1e-13)
        .solve(&model, 0.0, 15.0, start)
        .expect("a motion");
    let seen = reference.modes().len();
    assert!(seen > 10, "{seen} modes");
    let (_, last) = reference.modes().last().expect("a mode");
    assert!(last.is_held(0) && last.is_held(1), "{last:?}");
    for tight in [
        Tsit5::new().rtol(1e-12).atol(1e-12).solve(&model, 0.0, 15.0, start),
        Rodas5P::new().rtol(1e-12).atol(1e-12).solve(&model, 0.0, 15.0, start),
        Taylor::new().rtol(1e-13).atol(1e-13).solve(&model, 0.0, 15.0, start),
    ] {
        let end = tight.expect("a motion").end();
        assert!((end - reference.end()).amax() < 1e-8, "{end} {}", reference.end());
        assert!(end[2] == 0.0 && end[3] == 0.0, "{end}");
    }
    let mut before = f64::INFINITY;
    for (t, x) in reference.points() {
        let energy = model.energy(t, x);
        assert!(energy <= before + 1e-10, "{energy} at {t}");
        before = energy;
    }
}

/// Derivatives of the right-hand side with respect to friction and all other parameters.
#[test]
fn parameters_move_the_right_hand_side() {
    let model = dry();
    let params = model.params().to_array();
    for (t, x, _) in places::<4>(3) {
        let jacobian = model.parameter_jacobian(t, &x);
        for (n, &value) in params.iter().enumerate() {
            let rates = |value: f64| {
                let mut params = params;
                params[n] = value;
                let model = model.with_params(DryParams::from_array(params)).expect("physical");
                model.rhs(t, &x)
            };
            let (less, more) = (value - 1e-5, value + 1e-5);
            let slopes = (rates(more) - rates(less)) / (more - less);
            for row in 0..4 {
                let (ours, theirs) = (jacobian[(row, n)], slopes[row]);
                let what = DryParams::NAMES[n];
                assert!(
                    (ours - theirs).abs() < 1e-7 * (1.0 + theirs.abs()),
                    "{what}: {ours:e}, not {theirs:e}"
                );
            }
        }
        // static friction and restitution do not affect it
        assert!(
            jacobian.columns(3, 2).amax() == 0.0 && jacobian.column(2).amax() > 0.1,
            "{jacobian}"
        );
    }
}

/// Zero friction is no constraint, and does not appear in the code.
#[test]
fn a_friction_of_zero_leaves_no_trace() {
    let scene = |more: &str| {
        let text = format!(
            "pub Rod {{ body rod on ground {{
                mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, {more} }} }}"
        );
        pendulum_codegen::expand(text.parse().expect("tokens")).to_string()
    };
    assert_eq!(scene("dry_friction: 0,"), scene(""));
    assert!(scene("dry_friction: 0, static_friction: 1").contains("hybrid"));
}

#[test]
fn equations_list_the_constraints() {
    let lines: Vec<&str> = Dry::EQUATIONS.lines().collect();
    assert!(
        lines.iter().any(|line| line.starts_with("Q[a] = force(a)")),
        "{}",
        Dry::EQUATIONS
    );
    let at = lines.iter().position(|line| *line == "and along the constraints");
    let expected = [
        "force(a): dry friction of mu, at rest up to mu + more",
        "force(b): dry friction of 0.2; stops at -2 and 2.5, restitution 0.3 from a rate of 0.01",
    ];
    assert_eq!(lines[at.expect("a line") + 1..][..2], expected, "{}", Dry::EQUATIONS);
    // join continuation lines
    let wall = Dry::EQUATIONS.split("force(side): ").nth(1).expect("a wall");
    let wall = wall.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(wall.starts_with("a wall at the zero of "), "{wall}");
    assert!(wall.ends_with(", restitution e from a rate of 0.001"), "{wall}");
}

/// Stops and walls break symmetries of the forces; friction breaks none.
#[test]
fn layouts_know_what_stops_and_walls_end() {
    let periodic = |slots: &[Slot]| slots.iter().map(|slot| slot.periodic).collect::<Vec<_>>();
    assert_eq!(periodic(Pendulum::LAYOUT.slots), [true]);
    assert_eq!(periodic(Dry::LAYOUT.slots), [true, false]);
    assert!(!Ball::LAYOUT.slots[0].cyclic && !Block::LAYOUT.slots[0].cyclic);
    const { assert!(Dry::LAYOUT.autonomous && !Ball::LAYOUT.autonomous) };
}

mechanism! {
    /// Two rods with dry axles; the lower one has stops before it folds.
    pub Rods {
        params { mu: N m = 0.3 }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, taylor],
        shape rod { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body upper on ground: rod { joint: revolute(z), coordinate: a, dry_friction: mu, static_friction: 1.2*mu }
        body lower on upper: rod {
            joint: revolute(z) at [0, -1, 0], coordinate: b, dry_friction: 0.1, stop: [-1.5, 1] restitution(0.5),
        }
    }
}

/// Random models, each with an initial condition.
fn rods() -> (Vec<Rods>, Vec<SVector<f64, 4>>) {
    let mut random = Random::new(8);
    (0..share(60))
        .map(|_| {
            let params = RodsParams {
                mu: random.between(0.2, 0.8),
            };
            let start = [(-2.0, 2.0), (-1.5, 1.0), (-3.0, 3.0), (-3.0, 3.0)];
            let start = start.map(|(low, high)| random.between(low, high));
            (Rods::new(params).expect("physical"), SVector::from(start))
        })
        .unzip()
}

#[test]
fn lanes_have_the_bits_of_trajectories_alone() {
    fn same<M>(method: &M)
    where
        M: Ensemble<Rods, f64, 4> + Method<Rods, f64, 4>,
    {
        let (models, starts) = rods();
        let ends = method.ensemble(&models, 0.0, 8.0, &starts).expect("regular");
        for ((model, start), end) in models.iter().zip(&starts).zip(&ends) {
            let alone = method.solve(model, 0.0, 8.0, *start).expect("regular");
            assert_eq!(alone.end().map(f64::to_bits), end.map(f64::to_bits), "from {start}");
        }
    }
    same(&Tsit5::new());
    same(&Vern7::new().rtol(1e-9).atol(1e-9));
    same(&Rk4::new(0.01));
    // methods without lanes
    if share(2) == 2 {
        same(&Rodas5P::new());
        same(&Auto::new());
        same(&Taylor::new());
        same(&Taylor::new().rtol(1e-13).atol(1e-13));
    }
}

#[test]
fn a_pendulum_rests_in_an_interval() {
    mechanism! {
        pub Rusty {
            params { mu: N m = 2 }
            gravity: [0, -9.81, 0],
            body bob on ground {
                mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle,
                dry_friction: 0.8*mu, static_friction: mu,
            }
        }
    }
    let model = Rusty::new(RustyParams::default()).expect("physical");
    // while gravity requires no more than static friction can hold
    let most = (2.0_f64 / 9.81).asin();
    let resting = pendulum_core::stability::resting(&model, [0.1, 0.0]).expect("it rests");
    assert_eq!(resting.x, SVector::from([0.1, 0.0]));
    assert_eq!(resting.mode.0[0], Status::Stuck);
    assert_near(resting.margin, 1.0 - 9.81 * 0.1_f64.sin() / 2.0, "margin");
    // wherever it stops on its way, on either side
    let moving = pendulum_core::stability::resting(&model, [-0.1, 0.5]).expect("it rests");
    assert_eq!(moving.x, SVector::from([-0.1, 0.0]));
    assert_eq!(moving.margin, resting.margin);
    let [low, high] = resting.interval(&model, 0, 1.0).expect("regular");
    assert_near(low, -most, "lower end");
    assert_near(high, most, "upper end");
    // where it slips, the equilibrium is that without friction
    let resting = pendulum_core::stability::resting(&model, [1.0, 0.0]).expect("it rests");
    assert!(resting.x[0].abs() < 1e-9 && resting.margin > 0.999_999, "{resting:?}");
    // every state of rest is within the interval; about the top there is another one
    let end = |start: f64| {
        let solution = Tsit5::new().solve(&model, 0.0, 50.0, [start, 0.0]);
        solution.expect("regular").end()
    };
    for start in [1.0, -2.0, 0.5] {
        assert!(end(start)[1] == 0.0 && end(start)[0].abs() <= most, "{}", end(start));
    }
    assert_eq!(end(3.0), SVector::from([3.0, 0.0]));
}

#[test]
fn a_rocking_block_comes_to_rest() {
    mechanism! {
        pub Rocking {
            params { b: m = 0.08, h: m = 0.25 }
            gravity: [0, -9.81, 0],
            generate: [rhs],
            point left on block at [-b, -h, 0],
            point right on block at [b, -h, 0],
            wall under_left { gap: left.y },
            wall under_right { gap: right.y },
            body up on ground { joint: prismatic(y), coordinate: y }
            body block on up { mass: 1, inertia: 0.02, joint: revolute(z), coordinate: phi }
        }
    }
    let RockingParams { b, h } = RockingParams::default();
    let model = Rocking::new(RockingParams { b, h }).expect("physical");
    for tilt in [0.28, 0.1, -0.2_f64] {
        let start = [b * tilt.abs().sin() + h * tilt.cos(), tilt, 0.0, 0.0];
        let solution = Vern9::new()
            .rtol(1e-12)
            .atol(1e-12)
            .max_steps(2000)
            .solve(&model, 0.0, 2.0, start);
        let solution = solution.expect("regular");
        let (end, (_, mode)) = (solution.end(), *solution.modes().last().expect("a mode"));
        assert_eq!(mode.0[..2], [Status::Low; 2], "from {tilt}");
        assert!(
            (end[0] - h).abs() < 1e-12 && end[1].abs() < 1e-12 && end[2].abs() + end[3].abs() < 1e-14,
            "{end}"
        );
    }
}

/// Differences apply in each mode, and miss no event.
#[test]
fn differences_pass_modes() {
    let (model, start) = (dry(), [1.2, -0.4, 0.3, 2.0]);
    let exact = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 3.0, start)
        .expect("regular");
    let near = |solution: Result<Solution<f64, 4>, SolveError<f64, 4>>, method: &str| {
        let solution = solution.expect(method);
        assert_eq!(solution.modes().len(), exact.modes().len(), "{method}");
        let error = (solution.end() - exact.end()).amax();
        assert!(error < 1e-7, "{method}: {error:e}");
    };
    let derived = Differences(model);
    let radau5 = Radau5::new().rtol(1e-10).atol(1e-10);
    let rodas5p = Rodas5P::new().rtol(1e-10).atol(1e-10);
    near(radau5.solve(&derived, 0.0, 3.0, start), "Radau5");
    near(rodas5p.solve(&derived, 0.0, 3.0, start), "Rodas5P");
    // a user-supplied Jacobian is valid in no mode
    let with_jacobian = WithJacobian::new(model, |t, x: &SVector<f64, 4>| model.jacobian(t, x));
    near(radau5.solve(&with_jacobian, 0.0, 3.0, start), "Radau5 with a Jacobian");
    let error = equilibrium(&derived, start).expect_err("no mode is known there");
    assert!(error.to_string().contains("hybrid"), "{error}");
}

/// Two corners that hit the floor in turn, and hold each other. The time of rest depends neither on the height of the
/// floor, nor on the order of declaration, nor on the method.
#[test]
fn corners_come_to_rest_when_their_series_ends() {
    mechanism! {
        pub Corners {
            params { left: 1, right: 1, floor: m }
            body z on ground { mass: 1, joint: prismatic(z), coordinate: z, torque: -9.81 }
            body u on ground { mass: 0.05, joint: prismatic(x), coordinate: u }
            wall under_left { gap: z - floor - 0.3*u, restitution: left }
            wall under_right { gap: z - floor + 0.3*u, restitution: right }
        }
    }
    // the first by its series in 80 digits
    for (left, right, known) in [
        (0.3, 0.3, Some(0.181_146_187_017)),
        (0.5, 0.0, None),
        (0.5, 0.7, None),
        (0.2, 0.6, None),
    ] {
        let rests = |floor: f64, mirrored: bool, fast: bool| {
            let (left, right) = if mirrored { (right, left) } else { (left, right) };
            let model = Corners::new(CornersParams { left, right, floor }).expect("physical");
            let start = [floor + 0.03, if mirrored { -0.1 } else { 0.1 }, 0.0, 0.0];
            let solution = if fast {
                Tsit5::new()
                    .rtol(1e-10)
                    .atol(1e-10)
                    .max_steps(2000)
                    .solve(&model, 0.0, 5.0, start)
            } else {
                Vern9::new()
                    .rtol(1e-12)
                    .atol(1e-12)
                    .max_steps(2000)
                    .solve(&model, 0.0, 5.0, start)
            };
            let solution = solution.expect("it comes to rest");
            let (t, mode) = *solution.modes().last().expect("a mode");
            assert_eq!(mode.0[..2], [Status::Low; 2], "{left} {right}");
            t
        };
        let first = rests(0.0, false, false);
        for (floor, mirrored, fast) in [(1.0, false, false), (0.0, true, true), (1.0, true, true)] {
            let t = rests(floor, mirrored, fast);
            assert!((t - first).abs() < 1e-12, "{left} {right}: {t} and {first}");
        }
        assert!(known.is_none_or(|known| (first - known).abs() < 1e-12), "{first}");
    }
}

/// Checks derivatives in each mode against dual numbers: held constraints act only through their forces.
pub(crate) fn check_derivatives<S, D, const N: usize>(model: &S, dual: &D, count: usize)
where
    S: Jacobian<f64, N>,
    D: System<Dual, N> + Hybrid<Dual, N>,
{
    for (n, (t, mut x, mut forces)) in places::<N>(count).enumerate() {
        model.project(t, &mut x);
        let held = n as u8 & ((1 << count) - 1);
        (0..count).filter(|n| held & 1 << n != 0).for_each(|n| forces[n] = 0.0);
        let hold = Hold {
            forces,
            held,
            solved: held,
        };
        let lifted = Hold {
            forces: forces.map(Dual::from_f64),
            held,
            solved: held,
        };
        let along = |t: Dual, direction: &SVector<f64, N>| {
            InMode::new(dual, &lifted)
                .rhs(t, &along(&x, direction))
                .map(|rate| rate.slope)
        };
        let near = |ours: SVector<f64, N>, theirs: SVector<f64, N>, what: &str| {
            let error = (ours - theirs).amax() / (1.0 + theirs.amax());
            assert!(error < 1e-9, "{what} with {held:b} held: {error:e}");
        };
        let in_mode = InMode::new(model, &hold);
        let (rates, jacobian) = in_mode.rhs_and_jacobian(t, &x);
        near(rates, in_mode.rhs(t, &x), "right-hand side");
        for component in 0..N {
            let direction = SVector::from_fn(|n, _| f64::from(u8::from(n == component)));
            near(
                jacobian.column(component).into(),
                along(Dual::from_f64(t), &direction),
                "Jacobian",
            );
        }
        let by_time = in_mode.time_derivative(t, &x);
        near(by_time, along(Dual::new(t, 1.0), &SVector::zeros()), "time");
    }
}

#[test]
fn derivatives_hold_in_every_mode() {
    check_derivatives::<_, _, 4>(&dry(), &dry().cast::<Dual>(), 3);
    check_derivatives::<_, _, 8>(&driven(), &driven().cast::<Dual>(), 4);
}

mechanism! {
    /// Two rods, the upper one shaken in a dry axle, beside a wall that moves to and fro.
    pub Struck {
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        point tip on lower at [0, -1, 0],
        wall side { gap: 0.3 - tip.x + 0.2 m*sin(5 rad/s*t), restitution: 0.7 }
        body upper on ground: arm {
            joint: revolute(z), coordinate: a, torque: 2 N m*sin(3 rad/s*t), dry_friction: 4,
        }
        body lower on upper: arm { joint: revolute(z) at [0, -1, 0], coordinate: b, dry_friction: 0.1 }
    }
}

/// Checks the power series of a motion in modes of all kinds against its right-hand side in power series.
pub(crate) fn check_series<S, M, const N: usize>(model: &S, series: &M, count: usize)
where
    S: TaylorSeries<f64, N> + HybridSeries<f64, N, Workspace = <S as TaylorSeries<f64, N>>::Workspace> + Hybrid<f64, N>,
    M: System<Series, N>,
{
    let mut work = model.workspace();
    for (n, (t, start, mut forces)) in places::<N>(count).enumerate() {
        // quaternions have unit length
        let mut unit = start.map(Series::from_f64);
        series.project(Series::from_f64(t), &mut unit);
        let start = unit.map(|x| x.0[0]);
        let held = n as u8 & ((1 << count) - 1);
        (0..count).filter(|n| held & 1 << n != 0).for_each(|n| forces[n] = 0.0);
        let solved = held;
        let hold = Hold { forces, held, solved };
        let mut x = [start; LENGTH];
        model.eval_series(&hold, t, &mut x, &mut work);
        let forces = forces.map(Series::from_f64);
        let theirs = motion(&InMode::new(series, &Hold { forces, held, solved }), t, start);
        let difference = difference(&x, &theirs);
        assert!(difference < 1e-12, "{difference:e} with {held:b} held");
        for (n, constraint) in model
            .constraints()
            .iter()
            .enumerate()
            .filter(|(n, _)| held & 1 << n != 0)
        {
            if constraint.rate.is_empty() {
                continue;
            }
            for (k, x) in x.iter().enumerate().skip(1) {
                let rate: f64 = constraint.rate.iter().map(|&(at, sign)| f64::from(sign) * x[at]).sum();
                assert!(rate == 0.0, "{rate:e} of {n} at order {k}");
            }
        }
    }
}

/// The recurrences of each mode give the same series as the right-hand side evaluated on series.
#[test]
fn series_hold_in_every_mode() {
    check_series::<_, _, 4>(&dry(), &dry().cast::<Series>(), 3);
    check_series::<_, _, 8>(&driven(), &driven().cast::<Series>(), 4);
}

/// In every mode the canonical variables change along the motion by their rates, and their derivatives equal those by
/// dual numbers, at fixed forces. Only held walls have a force.
#[test]
fn canonical_equations_hold_in_every_mode() {
    fn check<S, D, const N: usize>(model: &S, dual: &D, count: usize)
    where
        S: Canonical<f64, N> + Hybrid<f64, N>,
        D: Canonical<Dual, N>,
    {
        for (n, (t, x, mut forces)) in places::<N>(count).enumerate() {
            let held = n as u8 & ((1 << count) - 1);
            (0..count).filter(|n| held & 1 << n != 0).for_each(|n| forces[n] = 0.0);
            let solved = held;
            let hold = Hold { forces, held, solved };
            let forces = forces.map(Dual::from_f64);
            let lifted = Hold { forces, held, solved };
            let moved = |by_time: f64, direction: &SVector<f64, N>| {
                let (variables, rates) =
                    InMode::new(dual, &lifted).canonical(Dual::new(t, by_time), &along(&x, direction));
                [variables, rates].map(|both| both.map(|x| x.slope))
            };
            let near = |ours: SVector<f64, N>, theirs: SVector<f64, N>, what: &str| {
                let error = (ours - theirs).amax() / (1.0 + theirs.amax());
                assert!(error < 1e-9, "{what} with {held:b} held: {error:e}");
            };
            let (_, rates) = InMode::new(model, &hold).canonical(t, &x);
            let [along_motion, _] = moved(1.0, &InMode::new(model, &hold).rhs(t, &x));
            near(rates, along_motion, "rates");
            let of_walls = model
                .constraints()
                .iter()
                .enumerate()
                .filter(|(_, wall)| wall.rate.is_empty());
            if of_walls.clone().any(|(n, _)| held & 1 << n != 0) {
                continue;
            }
            let (of_variables, of_rates) = InMode::new(model, &hold).canonical_jacobian(t, &x);
            for component in 0..N {
                let direction = SVector::from_fn(|n, _| f64::from(u8::from(n == component)));
                let [variables, rates] = moved(0.0, &direction);
                near(of_variables.column(component).into(), variables, "variables");
                near(of_rates.column(component).into(), rates, "derivative of the rates");
            }
        }
    }
    check::<_, _, 4>(&dry(), &dry().cast::<Dual>(), 3);
    check::<_, _, 8>(&driven(), &driven().cast::<Dual>(), 4);
}

/// Checks tangents against differences of neighbouring motions. Returns the number of impacts, and the last mode.
pub(crate) fn check_tangents<S, const N: usize>(model: &S, start: [f64; N], t: f64, allowed: f64) -> (usize, Mode)
where
    S: Jacobian<f64, N>,
{
    let method = Vern9::new().rtol(1e-13).atol(1e-13);
    let end = |x| {
        method
            .stepper(model, 0.0, t, x)
            .and_then(|mut stepper| stepper.run())
            .expect("regular")
    };
    let (_, matrix) = pendulum_core::stability::transition(model, 0.0, t, start, 1e-12).expect("regular");
    let reach = 1e-5;
    for (component, column) in matrix.column_iter().enumerate() {
        let mut step = SVector::zeros();
        step[component] = reach;
        let start = SVector::from(start);
        let theirs = (end(start + step) - end(start - step)) / (2.0 * reach);
        let error = (column - theirs).amax() / (1.0 + theirs.amax());
        assert!(error < allowed, "{error:e} in {component} at {t}");
    }
    let solution = method.solve(model, 0.0, t, start).expect("regular");
    let jumps = |pair: &&[(f64, SVector<f64, N>)]| (pair[1].1 - pair[0].1).amax() > 1e-6 && pair[0].0 == pair[1].0;
    let points: Vec<_> = solution.points().map(|(t, x)| (t, *x)).collect();
    let (_, last) = *solution.modes().last().expect("a mode");
    (points.windows(2).filter(jumps).count(), last)
}

/// Tangents through impacts, also on a moving wall, and through sticking and slipping.
#[test]
fn tangents_are_those_of_neighbours() {
    let (impacts, _) = check_tangents(&dry(), [1.2, 0.4, -3.0, 2.0], 0.5, 1e-7);
    assert_eq!(impacts, 1);
    let struck = Struck::new(StruckParams {}).expect("physical");
    let (impacts, last) = check_tangents(&struck, [-0.5, 0.3, 0.5, 1.0], 1.5, 1e-7);
    assert!(impacts == 1 && last.is_held(0));
    // neighbours of a sticking state soon stick, and their lost motion moves the other joint; differences resolve this
    // only up to their accuracy
    let (_, last) = check_tangents(&struck, [0.0, -0.3, 0.0, -0.5], 0.2, 1e-5);
    assert!(last.is_held(0));
}

/// The dense output of a step ends at the end of the step, also if the step was cut short.
#[test]
fn dense_output_ends_where_steps_do() {
    let model = dry();
    let start = [1.2, 0.4, -3.0, 2.0];
    let mut stepper = Rk4::new(0.2).stepper(&model, 0.0, 10.0, start).expect("a start");
    while let Some(step) = stepper.step().expect("regular") {
        let shortly_before = step.t1 - 1e-12;
        let apart = (stepper.dense().at(shortly_before) - step.x1).amax();
        assert!(apart < 1e-10, "{apart:e} at {}", step.t1);
    }
}

/// Lanes run out of steps at the same place as single trajectories.
#[test]
fn steps_in_lanes_are_counted_as_alone() {
    let (models, starts) = rods();
    let steps = |n: usize| {
        let statistics = Tsit5::new()
            .solve(&models[n], 0.0, 8.0, starts[n])
            .expect("regular")
            .statistics();
        statistics.accepted + statistics.rejected
    };
    let count = steps(0);
    let ends = |most: usize| {
        Tsit5::new()
            .max_steps(most)
            .ensemble(&models[..1], 0.0, 8.0, &starts[..1])
    };
    assert!(ends(count).is_ok());
    assert!(ends(count - 1).is_err());
}
