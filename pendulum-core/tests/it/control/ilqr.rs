//! Iterative LQR against closed forms, and on mechanisms.

use std::f64::consts::PI;

use pendulum_core::control::{
    Controller, CostDerivatives, Ilqr, IlqrError, LeastSquares, LinearLaw, Objective, Quadratic, Residuals, Sampled,
    linearize,
};
use pendulum_core::nalgebra::SMatrix;
use pendulum_core::prelude::*;
use pendulum_core::{CastControlled, InputLaw, Real};

use super::{Random, diagonal};

mechanism! {
    /// A mass that is pushed: held inputs move it exactly as in a step of the midpoint rule.
    pub Cart {
        input push: N,
        body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, torque: push }
    }
}

mechanism! {
    /// Two carts with springs and dampers, and a motor for each.
    pub Carts {
        input left: N, input right: N,
        body a on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: left, spring: (3, 0), friction: 0.2 }
        body b on a { mass: 2, joint: prismatic(x), coordinate: r, torque: right, spring: (2, 0), friction: 0.1 }
    }
}

mechanism! {
    /// An arm; the angle is 0 upright.
    pub Arm {
        input motor: N m,
        gravity: [0, -9.81, 0],
        body rod on ground {
            solids: [rod(1, [0, 0, 0], [0, 1, 0])], joint: revolute(z), coordinate: angle, torque: motor,
        }
    }
}

mechanism! {
    /// Two rods on a cart that is pushed; the angles are 0 upright, and both from the vertical.
    pub TwoRods {
        input push: N,
        gravity: [0, -9.81, 0],
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: push }
        body lower on cart { solids: [rod(0.3, [0, 0, 0], [0, 0.5, 0])], joint: revolute(z), coordinate: a }
        body upper on lower {
            solids: [rod(0.3, [0, 0, 0], [0, 0.5, 0])], joint: revolute(z) at [0, 0.5, 0], coordinate: b absolute,
        }
    }
}

fn cart() -> Cart {
    Cart::new(CartParams {}).expect("physical")
}

fn arm() -> Arm {
    Arm::new(ArmParams {}).expect("physical")
}

/// Weights of a cart, and a search over `K` steps of 0.1 s.
fn pushed<const K: usize>() -> Ilqr<Quadratic<f64, 2, 1>, f64, 2, 1, K> {
    Ilqr::new(0.1, Quadratic::diagonal([1.0, 0.5], [0.2]))
}

#[test]
fn a_long_motion_of_a_linear_model_has_the_gain_of_the_regulator() {
    let mut ilqr = pushed::<300>();
    let solved = ilqr.solve(&cart(), 0.0, [1.0, -0.5]).expect("convex");
    assert_eq!(solved.iterations, 2, "one step, and one that finds nothing to improve");
    let linear = linearize(&cart(), 0.0, [0.0; 2], [0.0]).expect("finite");
    let sampled = linear.discretize(0.1).expect("a period");
    let regulator = sampled
        .lqr(&diagonal([0.1, 0.05]), &SMatrix::from([[0.02]]))
        .expect("reached");
    assert!((ilqr.gain(0) + regulator.law.gain).amax() < 1e-12);
    let start = SVector::from([1.0, -0.5]);
    assert!((solved.cost - start.dot(&(regulator.cost * start))).abs() < 1e-12);
}

#[test]
fn the_gains_are_those_of_the_riccati_recursion() {
    let model = Carts::new(CartsParams {}).expect("physical");
    let mut random = Random(7);
    let h = 0.05;
    let mut weights = || {
        let factor = random.matrix::<4, 4>();
        factor * factor.transpose()
    };
    let (q, end, r) = (weights(), weights(), SMatrix::<f64, 2, 2>::new(0.3, 0.1, 0.1, 0.2));
    let mut ilqr = Ilqr::<_, _, 4, 2, 8>::new(h, Quadratic::new(q, r).end(end));
    let start = SVector::from([1.0, -0.5, 0.2, 0.3]);
    let solved = ilqr.solve(&model, 0.0, start).expect("convex");
    assert_eq!(solved.iterations, 2);

    let linear = linearize(&model, 0.0, [0.0; 4], [0.0; 2]).expect("finite");
    let rate = linear.a * h;
    let a = SMatrix::identity() + rate + rate * rate * 0.5;
    let b = (SMatrix::identity() + rate * 0.5) * linear.b * h;
    let mut cost = end;
    for node in (0..8).rev() {
        let inverse = (r * h + b.transpose() * cost * b).try_inverse().expect("definite");
        let gain = inverse * b.transpose() * cost * a;
        cost = q * h + a.transpose() * cost * (a - b * gain);
        assert!((ilqr.gain(node) + gain).amax() < 1e-12, "node {node}");
    }
    assert!((solved.cost - start.dot(&(cost * start))).abs() < 1e-12);
}

/// The least cost of ten steps of the cart within limits, by coordinate descent over the inputs.
fn by_descent(limit: f64, start: [f64; 2]) -> [f64; 10] {
    let cost = |u: &[f64; 10]| {
        let ([mut s, mut v], mut cost) = (start, 0.0);
        for push in u {
            cost += 0.1 * (s * s + 0.5 * v * v + 0.2 * push * push);
            (s, v) = (s + 0.1 * v + 0.0025 * push, v + 0.05 * push);
        }
        cost + 3.0 * (s * s + v * v)
    };
    let mut u = [0.0; 10];
    for _ in 0..20_000 {
        for k in 0..10 {
            let at = |push: f64| {
                let mut moved = u;
                moved[k] = push;
                cost(&moved)
            };
            // a parabola
            let [left, here, right] = [at(-1.0), at(0.0), at(1.0)];
            u[k] = (0.5 * (left - right) / (left + right - 2.0 * here)).clamp(-limit, limit);
        }
    }
    u
}

#[test]
fn a_linear_motion_within_limits_is_the_best_one() {
    let cost = Quadratic::diagonal([1.0, 0.5], [0.2]).end(SMatrix::identity() * 3.0);
    let mut ilqr = Ilqr::<_, _, 2, 1, 10>::new(0.1, cost)
        .limits([-1.0], [1.0])
        .tolerance(0.0);
    ilqr.solve(&cart(), 0.0, [0.2, 0.4]).expect("convex");
    let expected = by_descent(1.0, [0.2, 0.4]);
    let limited = expected.iter().filter(|push| push.abs() == 1.0).count();
    assert!(
        (1..10).contains(&limited),
        "some are at the limit, but not all: {expected:?}"
    );
    for (k, ([push], expected)) in ilqr.inputs().iter().zip(expected).enumerate() {
        assert!((push - expected).abs() < 1e-7, "step {k}: {push} is not {expected}");
        let is_limited = expected.abs() == 1.0;
        assert_eq!(ilqr.gain(k).amax() == 0.0, is_limited, "step {k}");
    }
}

/// A search for the swing-up of the arm with a motor that is too weak to lift it at once.
fn swing_up() -> Ilqr<Quadratic<f64, 2, 1>, f64, 2, 1, 150> {
    let cost = Quadratic::diagonal([0.0, 0.0], [0.1]).end(SMatrix::identity() * 100.0);
    Ilqr::new(0.02, cost).limits([-2.0], [2.0]).start([0.5])
}

#[test]
fn a_warm_start_needs_fewer_iterations() {
    let mut ilqr = swing_up();
    let cold = ilqr.solve(&arm(), 0.0, [PI, 0.0]).expect("a motion");
    assert!(ilqr.end().amax() < 0.1);
    assert!(ilqr.inputs().iter().all(|[motor]| motor.abs() <= 2.0));
    assert!(ilqr.inputs().iter().any(|[motor]| motor.abs() == 2.0));
    let (before, after) = (ilqr, ilqr.states()[1]);
    ilqr.shift();
    assert_eq!((ilqr.states()[0], ilqr.states()[149]), (after, *before.end()));
    assert_eq!(ilqr.inputs()[..149], before.inputs()[1..]);
    assert_eq!(ilqr.inputs()[149], before.inputs()[149]);
    assert_eq!((ilqr.gain(7), ilqr.gain(149)), (before.gain(8), before.gain(149)));
    let warm = ilqr
        .solve(&arm(), 0.02, after + SVector::from([1e-3, -1e-3]))
        .expect("a motion");
    assert!(3 * warm.iterations < cold.iterations, "{warm:?} after {cold:?}");
}

#[test]
fn passes_converge_to_the_motion_of_a_search() {
    let (mut searched, mut passed) = (swing_up().tolerance(1e-10), swing_up());
    let solved = searched.solve(&arm(), 0.0, [PI, 0.0]).expect("a motion");
    let mut cost = f64::INFINITY;
    for _ in 0..solved.iterations {
        let pass = passed.pass(&arm(), 0.0, [PI, 0.0]).expect("a motion");
        assert!(pass.cost <= pass.cost_before && pass.cost_before <= cost * (1.0 + 1e-12));
        cost = pass.cost;
    }
    assert!(
        (cost - solved.cost).abs() < 1e-8 * cost,
        "{cost} is not {}",
        solved.cost
    );
}

#[test]
fn a_tracker_takes_node_by_node_and_states_between_them() {
    let mut ilqr = swing_up();
    ilqr.solve(&arm(), 0.0, [PI, 0.0]).expect("a motion");
    let hold = LinearLaw {
        gain: SMatrix::from([[3.0], [0.5]]),
        x0: SVector::zeros(),
        u0: [0.0],
    };
    let tracker = ilqr.tracker(hold);
    // a start and a period whose multiples are rounded
    let (t0, period) = (0.7, 0.02);
    let mut state = Controller::<f64, 2, 1>::start(&tracker, period);
    let off = SVector::from([1e-3, -2e-3]);
    for node in 0..150 {
        let x = ilqr.states()[node] + off;
        let command = tracker.sample(t0 + period * node as f64, &x, &mut state);
        assert!((command[0] - ilqr.command(node, &x)[0]).abs() < 1e-9, "node {node}");
        assert_eq!(state.then, None);
    }
    let x = SVector::from([0.1, 0.2]);
    assert_eq!(tracker.sample(t0 + 3.0, &x, &mut state), hold.inputs(0.0, &x));
    // a quarter of a step after a node, and after the last one
    let mut state = Controller::<f64, 2, 1>::start(&tracker, 0.005);
    tracker.sample(t0, &ilqr.states()[0], &mut state);
    for node in [40, 149] {
        let next = *ilqr.states().get(node + 1).unwrap_or(ilqr.end());
        let between = ilqr.states()[node].lerp(&next, 0.25) + off;
        let command = tracker.sample(t0 + 0.02 * (node as f64 + 0.25), &between, &mut state);
        let at_node = ilqr.command(node, &(ilqr.states()[node] + off));
        assert!((command[0] - at_node[0]).abs() < 1e-9, "node {node}");
    }
}

#[test]
fn two_rods_on_a_cart_swing_up_from_any_start_around_rest() {
    let model = TwoRods::new(TwoRodsParams {}).expect("physical");
    let upright = linearize(&model, 0.0, [0.0; 6], [0.0]).expect("finite");
    let weights = diagonal([1.0, 10.0, 10.0, 1.0, 1.0, 1.0]);
    let regulator = upright.lqr(&weights, &SMatrix::from([[0.1]])).expect("reached");
    let cost = Quadratic::diagonal([0.1, 0.1, 0.1, 0.01, 0.01, 0.01], [0.01]).end(regulator.cost);
    let mut random = Random(1);
    // All 20 take about a minute without optimization.
    let starts = if cfg!(debug_assertions) { 2 } else { 20 };
    for start in 0..starts {
        let [s, a, b, ds, da, db] = random.matrix::<6, 1>().into();
        let x0 = SVector::from([0.2 * s, PI + 0.3 * a, PI + 0.3 * b, 0.2 * ds, 0.5 * da, 0.5 * db]);
        let mut ilqr = Ilqr::<_, _, 6, 1, 200>::new(0.02, cost).limits([-20.0], [20.0]);
        ilqr.solve(&model, 0.0, x0).expect("a motion");
        assert!(ilqr.end().amax() < 0.1, "start {start}: {}", ilqr.end());
        // on the motion of the equations themselves, instead of their steps
        let sampled = Sampled::new(ilqr.tracker(regulator.law), 0.02).limits([-20.0], [20.0]);
        let end = sampled.end(&Vern7::new(), &model, 0.0, 12.0, x0).expect("regular");
        assert!(end.amax() < 1e-3, "start {start}: {end}");
    }
}

#[test]
fn a_predictive_controller_swings_an_arm_up_and_holds_it() {
    let cost = Quadratic::diagonal([0.1, 0.01], [0.1]).end(SMatrix::identity() * 100.0);
    let mut ilqr = Ilqr::<_, _, 2, 1, 150>::new(0.02, cost)
        .limits([-2.0], [2.0])
        .start([0.5]);
    ilqr.solve(&arm(), 0.0, [PI, 0.0]).expect("a motion");
    assert!(ilqr.end().amax() < 0.1, "{}", ilqr.end());
    let controller = ilqr.controller(arm()).expect("in range");
    for period in [0.02, 0.05] {
        let sampled = Sampled::new(controller, period).limits([-2.0], [2.0]);
        let motion = sampled
            .solve(&Vern7::new(), &arm(), 0.0, 8.0, [PI, 0.0])
            .expect("regular");
        assert!(motion.trajectory.end().amax() < 1e-2, "{}", motion.trajectory.end());
        assert!(motion.samples.iter().all(|sample| sample.command == sample.sent));
    }
}

#[test]
fn a_predictive_controller_moves_its_plan_on_with_the_time() {
    let mut by_hand = swing_up();
    let controller = by_hand.controller(arm()).expect("in range");
    let mut state = controller.start(0.02);
    let mut x = SVector::from([PI, 0.0]);
    // the last sample is three steps late
    for (t, shifts) in [(0.0, 0), (0.02, 1), (0.04, 1), (0.12, 4)] {
        let command = controller.sample(t, &x, &mut state);
        (0..shifts).for_each(|_| by_hand.shift());
        by_hand.pass(&arm(), t, x).expect("a motion");
        assert_eq!(state.ilqr, by_hand, "at {t} s");
        assert_eq!((command, state.failure), (by_hand.inputs()[0], None));
        x += SVector::from([0.01, -0.02]);
    }
    // what is not finite does not move the plan
    let clock = state.t;
    for (t, angle) in [(0.14, f64::NAN), (f64::NAN, 1.0), (f64::INFINITY, 1.0)] {
        let command = controller.sample(t, &SVector::from([angle, 0.0]), &mut state);
        assert!(command[0].is_nan());
        assert!(matches!(state.failure, Some(IlqrError::NotFinite { .. })));
        assert!(state.ilqr == by_hand && state.t == clock, "{t} s, {angle}");
    }
}

/// A cost that is the same after each turn of the arm; `effort` is the weight of the motor.
#[derive(Clone, Copy)]
struct Upright {
    effort: f64,
}

impl Objective<f64, 2, 1> for Upright {
    fn running(&self, _t: f64, _x: &SVector<f64, 2>, [motor]: &[f64; 1]) -> f64 {
        self.effort * motor * motor
    }

    fn running_derivatives(&self, _t: f64, _x: &SVector<f64, 2>, [motor]: &[f64; 1]) -> CostDerivatives<f64, 2, 1> {
        CostDerivatives {
            x: SVector::zeros(),
            u: SVector::from([2.0 * self.effort * motor]),
            xx: SMatrix::zeros(),
            xu: SMatrix::zeros(),
            uu: SMatrix::from([[2.0 * self.effort]]),
        }
    }

    fn end(&self, _t: f64, x: &SVector<f64, 2>) -> f64 {
        100.0 * (2.0 - 2.0 * x[0].cos() + x[1] * x[1])
    }

    /// The residuals are `sin`, `1 - cos` and the rate, so that `J^T J` is the identity.
    fn end_derivatives(&self, _t: f64, x: &SVector<f64, 2>) -> (SVector<f64, 2>, SMatrix<f64, 2, 2>) {
        (SVector::from([200.0 * x[0].sin(), 200.0 * x[1]]), diagonal([200.0; 2]))
    }
}

#[test]
fn other_costs_lead_to_the_nearest_turn() {
    for turns in [-1.0, 0.0, 3.0] {
        let mut ilqr = Ilqr::<_, _, 2, 1, 150>::new(0.02, Upright { effort: 0.1 })
            .limits([-2.0], [2.0])
            .start([0.5]);
        ilqr.solve(&arm(), 0.0, [PI * (1.0 + 2.0 * turns), 0.0])
            .expect("a motion");
        let [angle, rate] = (*ilqr.end()).into();
        assert!(1.0 - angle.cos() < 5e-3 && rate.abs() < 0.1, "{angle} and {rate}");
        assert!((angle - 2.0 * PI * turns).abs() < 7.0, "{angle}");
    }
}

/// Deviation from a goal: residuals that make least squares of a quadratic cost.
#[derive(Clone, Copy)]
struct Deviation;

impl Residuals<2, 2> for Deviation {
    fn residuals<T: Real>(&self, _t: T, x: &SVector<T, 2>) -> [T; 2] {
        [x[0] - T::from_f64(0.3), x[1]]
    }
}

#[test]
fn least_squares_of_the_state_are_a_quadratic_cost() {
    let squares = LeastSquares::new(Deviation, [1.0, 0.2], [0.1])
        .end([100.0, 20.0])
        .rest([0.5]);
    let quadratic = Quadratic::diagonal([1.0, 0.2], [0.1])
        .end(diagonal([100.0, 20.0]))
        .goal([0.3, 0.0], [0.5]);
    let mut by_squares = Ilqr::<_, _, 2, 1, 50>::new(0.02, squares).limits([-2.0], [2.0]);
    let mut by_weights = Ilqr::<_, _, 2, 1, 50>::new(0.02, quadratic).limits([-2.0], [2.0]);
    let first = by_squares.solve(&arm(), 0.0, [0.5, 0.1]).expect("a motion");
    let second = by_weights.solve(&arm(), 0.0, [0.5, 0.1]).expect("a motion");
    assert!(
        (first.cost - second.cost).abs() < 1e-12 * first.cost,
        "{first:?} {second:?}"
    );
    for (a, b) in by_squares.inputs().iter().zip(by_weights.inputs()) {
        assert!((a[0] - b[0]).abs() < 1e-9, "{a:?} {b:?}");
    }
}

/// Place of the end of the arm, relative to a moving goal, and rates.
#[derive(Clone, Copy)]
struct Tip;

impl Residuals<2, 3> for Tip {
    fn residuals<T: Real>(&self, t: T, x: &SVector<T, 2>) -> [T; 3] {
        let (sin, cos) = x[0].sin_cos();
        [sin - t, cos - T::from_f64(0.2), x[1] * x[0]]
    }
}

#[test]
fn derivatives_of_least_squares_are_those_of_differences() {
    let weights = [3.0, 2.0, 0.5];
    let cost = LeastSquares::new(Tip, weights, [0.1]).end([5.0, 6.0, 7.0]).rest([0.4]);
    let (t, x, u) = (0.3, SVector::from([0.7, -1.2]), [0.9]);
    let h = 1e-6;
    let running = cost.running_derivatives(t, &x, &u);
    let (by_end, _) = Objective::<f64, 2, 1>::end_derivatives(&cost, t, &x);
    for n in 0..2 {
        let moved = |by: f64| {
            let mut x = x;
            x[n] += by;
            x
        };
        let difference = |cost: &dyn Fn(&SVector<f64, 2>) -> f64| (cost(&moved(h)) - cost(&moved(-h))) / (2.0 * h);
        let by_state = difference(&|x| cost.running(t, x, &u));
        assert!((running.x[n] - by_state).abs() < 1e-8, "{n}: {by_state}");
        let by_state = difference(&|x| Objective::<f64, 2, 1>::end(&cost, t, x));
        assert!((by_end[n] - by_state).abs() < 1e-8, "{n}: {by_state}");
    }
    let by_input = (cost.running(t, &x, &[0.9 + h]) - cost.running(t, &x, &[0.9 - h])) / (2.0 * h);
    assert!((running.u[0] - by_input).abs() < 1e-8 && running.uu == SMatrix::from([[0.2]]));
    // Gauss and Newton: 2 J^T W J
    let j = SMatrix::<f64, 3, 2>::from([[x[0].cos(), -x[0].sin(), x[1]], [0.0, 0.0, x[0]]]);
    let expected = 2.0 * j.transpose() * diagonal(weights) * j;
    assert!((running.xx - expected).amax() < 1e-14, "{}", running.xx);
}

#[test]
fn weights_of_least_squares_are_checked() {
    let refused = |cost: LeastSquares<Deviation, f64, 1, 2>| {
        let mut ilqr = Ilqr::<_, _, 2, 1, 50>::new(0.02, cost);
        ilqr.solve(&arm(), 0.0, [0.5, 0.0]).expect_err("refused")
    };
    let cost = |w: f64, r: f64| LeastSquares::new(Deviation, [1.0, w], [r]);
    let negative = |what, strictly| IlqrError::NotPositive { what, strictly };
    assert_eq!(refused(cost(-1.0, 1.0)), negative("W", false));
    assert_eq!(refused(cost(0.0, 0.0)), negative("R", true));
    assert_eq!(refused(cost(0.0, 1.0).end([0.0, -2.0])), negative("Wf", false));
    assert_eq!(refused(cost(f64::NAN, 1.0)), IlqrError::NotFinite { what: "W" });
    assert_eq!(
        refused(cost(0.0, 1.0).rest([f64::NAN])),
        IlqrError::NotFinite { what: "the goal" }
    );
}

#[test]
fn a_cost_that_is_not_convex_is_refused() {
    let mut ilqr = Ilqr::<_, _, 2, 1, 150>::new(0.02, Upright { effort: 1.0 });
    ilqr.solve(&arm(), 0.0, [0.5, 0.0]).expect("a motion");
    *ilqr.cost_mut() = Upright { effort: -1e3 };
    let motion = |ilqr: &Ilqr<_, _, 2, 1, 150>| (*ilqr.states(), *ilqr.end(), *ilqr.inputs());
    let before = motion(&ilqr);
    ilqr.pass(&arm(), 0.0, [0.1, 0.0]).expect_err("refused");
    assert!(motion(&ilqr) == before, "the motion is kept");
    let error = ilqr.solve(&arm(), 0.0, [0.1, 0.0]).expect_err("refused");
    assert!(matches!(error, IlqrError::NotConvex { .. }), "{error}");
    assert!(
        error.to_string().contains("\nhelp: return second derivatives"),
        "{error}"
    );
}

#[test]
fn single_precision_finds_the_motion_as_well() {
    let arm: <Arm as CastControlled<2, 1>>::In<f32> = CastControlled::cast(&arm());
    let cost = Quadratic::diagonal([0.0, 0.0], [0.1]).end(SMatrix::identity() * 100.0);
    let mut ilqr = Ilqr::<_, _, 2, 1, 150>::new(0.02_f32, cost)
        .limits([-2.0], [2.0])
        .start([0.5]);
    ilqr.solve(&arm, 0.0, [std::f32::consts::PI, 0.0]).expect("a motion");
    assert!(ilqr.end().amax() < 0.1);
}

mod refused {
    use super::*;

    mechanism! {
        /// A cart with dry friction.
        pub Braked {
            input push: N,
            gravity: [0, -9.81, 0],
            body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, torque: push, dry_friction: 1 }
        }
    }

    mechanism! {
        /// Bennett's linkage, with a motor.
        pub Bennett {
            input motor: N m,
            body first on ground {
                solids: [rod(0.5, [0, 0, 0], [0.4, 0, 0])],
                joint: revolute(z) at [0.8, 0, 0] rpy [0.8928089789005025, 0, 0],
                coordinate: theta near 2,
                torque: motor,
            }
            body second on first {
                solids: [rod(1, [0, 0, 0], [0.8, 0, 0])],
                joint: revolute(z) at [0.4, 0, 0] rpy [0.4, 0, 0],
                coordinate: phi depends near 2,
            }
            body third on second {
                solids: [rod(0.5, [0, 0, 0], [0.4, 0, 0])],
                joint: revolute(z) at [0.8, 0, 0] rpy [0.8928089789005025, 0, 0],
                coordinate: psi depends near -2,
            }
            close third at [0.4, 0, 0] rpy [0.4, 0, 0] to ground: revolute(z),
        }
    }

    /// The error of a search, which is also that of a pass and of a controller.
    fn error(ilqr: Ilqr<Quadratic<f64, 2, 1>, f64, 2, 1, 10>) -> IlqrError {
        let error = { ilqr }.solve(&cart(), 0.0, [1.0, 0.0]).expect_err("refused");
        let others = [
            { ilqr }.pass(&cart(), 0.0, [1.0, 0.0]).expect_err("refused"),
            ilqr.controller(cart()).expect_err("refused"),
        ];
        // as text, since errors about NaN are not equal
        assert_eq!(
            others.map(|other| other.to_string()),
            [(); 2].map(|()| error.to_string())
        );
        assert!(error.to_string().contains("\nhelp: "), "{error}");
        error
    }

    #[test]
    fn steps_and_tolerances_are_in_range() {
        for h in [0.0, -0.1, f64::NAN, f64::INFINITY] {
            let ilqr = Ilqr::new(h, Quadratic::diagonal([1.0, 1.0], [1.0]));
            assert!(matches!(error(ilqr), IlqrError::Step(_)), "{h}");
        }
        for tolerance in [-1e-6, 1.0, f64::NAN] {
            assert!(matches!(error(pushed().tolerance(tolerance)), IlqrError::Tolerance(_)));
        }
    }

    #[test]
    fn limits_are_in_order_and_include_the_start() {
        let limits = [1.0, -1.0];
        assert_eq!(
            error(pushed().limits([1.0], [-1.0])),
            IlqrError::Limits { input: 0, limits }
        );
        let error_of = error(pushed().limits([f64::NAN], [1.0]));
        assert!(matches!(error_of, IlqrError::Limits { .. }));
        let limits = [1.0, 2.0];
        let (input, node) = (0, 0);
        for value in [0.0, 3.0] {
            let beyond = IlqrError::StartBeyondLimits {
                input,
                node,
                value,
                limits,
            };
            assert_eq!(error(pushed().limits([1.0], [2.0]).start([value])), beyond);
        }
        let mut start = [[1.5]; 10];
        start[7] = [f64::NAN];
        let error_of = error(pushed().limits([1.0], [2.0]).start_from(start));
        assert!(matches!(error_of, IlqrError::StartBeyondLimits { node: 7, .. }));
    }

    #[test]
    fn weights_are_symmetric_and_positive() {
        let of = |cost| error(Ilqr::new(0.1, cost));
        let one = || Quadratic::<f64, 2, 1>::diagonal([1.0, 1.0], [1.0]);
        for r in [0.0, -1.0] {
            let error = of(Quadratic::diagonal([1.0, 1.0], [r]));
            assert_eq!(
                error,
                IlqrError::NotPositive {
                    what: "R",
                    strictly: true
                }
            );
        }
        let not_positive = |what| IlqrError::NotPositive { what, strictly: false };
        assert_eq!(of(Quadratic::diagonal([1.0, -1.0], [1.0])), not_positive("Q"));
        // symmetric, with an eigenvalue of -1
        let indefinite = SMatrix::<f64, 2, 2>::new(1e-4, 2.0, 2.0, 1e4);
        assert_eq!(of(one().end(indefinite)), not_positive("Qf"));
        let skew = SMatrix::<f64, 2, 2>::new(1.0, 0.5, 0.0, 1.0);
        let error = of(one().end(skew));
        assert!(
            matches!(
                error,
                IlqrError::NotSymmetric {
                    what: "Qf",
                    entry: [1, 0],
                    ..
                }
            ),
            "{error}"
        );
        let error = of(Quadratic::diagonal([1.0, f64::NAN], [1.0]));
        assert_eq!(error, IlqrError::NotFinite { what: "Q" });
        let error = of(one().goal([0.0, 0.0], [f64::INFINITY]));
        assert_eq!(error, IlqrError::NotFinite { what: "the goal" });
        // a weight without full rank is none of these
        let flat = SMatrix::<f64, 2, 2>::new(1e-4, 1.0, 1.0, 1e4);
        Ilqr::<_, _, 2, 1, 10>::new(0.1, one().end(flat))
            .solve(&cart(), 0.0, [1.0, 0.0])
            .expect("semidefinite");
    }

    #[test]
    fn states_are_finite() {
        let mut ilqr = pushed::<10>();
        let error = ilqr.solve(&cart(), 0.0, [f64::NAN, 0.0]).expect_err("refused");
        assert_eq!(error, IlqrError::NotFinite { what: "the state" });
        let error = ilqr.pass(&cart(), f64::INFINITY, [0.0, 0.0]).expect_err("refused");
        assert_eq!(error, IlqrError::NotFinite { what: "the time" });
        // the cost overflows
        let error = ilqr.solve(&cart(), 0.0, [1e200, 0.0]).expect_err("refused");
        assert!(matches!(error, IlqrError::Diverged { .. }), "{error}");
        let mut fast = pushed::<10>().start([1e308]);
        let error = fast.solve(&cart(), 0.0, [0.0, 0.0]).expect_err("refused");
        assert!(matches!(error, IlqrError::Diverged { .. }), "{error}");
    }

    #[test]
    fn a_search_ends_after_its_iterations_and_goes_on() {
        let mut ilqr = swing_up().max_iterations(5);
        let error = ilqr.solve(&arm(), 0.0, [PI, 0.0]).expect_err("too few");
        let IlqrError::TooManyIterations { cost, .. } = error else {
            panic!("{error}");
        };
        let error = ilqr.solve(&arm(), 0.0, [PI, 0.0]).expect_err("too few");
        assert!(matches!(error, IlqrError::TooManyIterations { cost: next, .. } if next < cost));
    }

    #[test]
    fn mode_switches_and_loops_without_a_closed_form_are_refused() {
        let braked = Braked::new(BrakedParams {}).expect("physical");
        let error = pushed::<10>().solve(&braked, 0.0, [1.0, 0.0]).expect_err("refused");
        assert!(
            matches!(error, IlqrError::ModeSwitches { constraint } if constraint == "s"),
            "{error}"
        );
        let bennett = Bennett::new(BennettParams {}).expect("physical");
        let start = bennett.assemble(0.0, [2.0, 2.0, -2.0, 1.0]).expect("closes");
        let mut ilqr = Ilqr::<_, _, 4, 1, 10>::new(0.1, Quadratic::diagonal([1.0; 4], [1.0]));
        let error = ilqr.solve(&bennett, 0.0, start).expect_err("refused");
        assert!(matches!(error, IlqrError::ClosedLoop { .. }), "{error}");
    }
}
