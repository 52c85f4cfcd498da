//! Iterative LQR through mode switches: derivatives of steps against differences, and motions with friction and stops.

use pendulum_core::Reason;
use pendulum_core::control::{Ilqr, IlqrError, Integrated, Objective, Quadratic, Sampled, StepDerivatives, StepMap};
use pendulum_core::prelude::*;

use super::diagonal;

mechanism! {
    /// A block that is pushed over a floor: 2 N break it away.
    pub Block {
        input push: N,
        body block on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: push, dry_friction: 2 }
    }
}

mechanism! {
    /// A pole on a cart with friction, between two stops; the angle is 0 upright.
    pub Railed {
        input push: N,
        gravity: [0, -9.81, 0],
        body cart on ground {
            mass: 1, joint: prismatic(x), coordinate: s, torque: push,
            dry_friction: 1.5, stop: [-0.5, 0.5] restitution(0.4),
        }
        body rod on cart { solids: [rod(0.2, [0, 0, 0], [0, 0.6, 0])], joint: revolute(z), coordinate: theta }
    }
}

mechanism! {
    /// A rod with a motor too weak to stop it before it rebounds; the angle is 0 hanging.
    pub Rebounding {
        input motor: N m,
        gravity: [0, -9.81, 0],
        body rod on ground {
            solids: [rod(1, [0, 0, 0], [0, -0.5, 0])], joint: revolute(z), coordinate: angle, torque: motor,
            stop: [-2.5, 0.6] restitution(0.7),
        }
    }
}

/// Accuracy of the integration, far below the error of the differences.
const ACCURATE: f64 = 1e-12;
/// Change of a component for a difference, in both directions.
const CHANGE: f64 = 1e-7;
/// Largest error of a derivative.
const ERROR: f64 = 1e-6;

fn block() -> Block {
    Block::new(BlockParams {}).expect("physical")
}

fn railed() -> Railed {
    Railed::new(RailedParams {}).expect("physical")
}

/// 40 steps of 50 ms that push the block by 1 m, with the inputs of the start.
fn pushed(start: f64) -> Ilqr<Quadratic<f64, 2, 1>, f64, 2, 1, 40> {
    let cost = Quadratic::diagonal([0.0, 0.0], [0.01])
        .end(diagonal([100.0, 10.0]))
        .goal([1.0, 0.0], [0.0]);
    Ilqr::new(0.05, cost).limits([-6.0], [6.0]).start([start])
}

/// Central difference of the ends of two steps.
fn difference<const N: usize>(end: impl Fn(f64) -> SVector<f64, N>) -> SVector<f64, N> {
    (end(CHANGE) - end(-CHANGE)) / (2.0 * CHANGE)
}

/// Largest difference of the derivatives of a step from central differences, by the state but for `without`, and by
/// the input.
fn error<S, const N: usize>(model: &S, h: f64, x: &SVector<f64, N>, u: [f64; 1], without: &[usize]) -> f64
where
    S: StepMap<f64, N, 1>,
{
    let StepDerivatives { a, b } = model.step_derivatives(0.0, h, x, &u).expect("derivatives");
    let end = |x, u| model.step(0.0, h, &x, &u).expect("a step");
    let moved = |n: usize, by| {
        let mut x = *x;
        x[n] += by;
        x
    };
    let by_state = (0..N)
        .filter(|n| !without.contains(n))
        .map(|n| (a.column(n) - difference(|by| end(moved(n, by), u))).amax());
    let by_input = (b.column(0) - difference(|by| end(*x, [u[0] + by]))).amax();
    by_state.fold(by_input, f64::max)
}

/// Breaks away, slides, comes to rest and stays there within one step or at its start.
#[test]
fn derivatives_of_a_block_are_those_of_differences() {
    let model = Integrated::new(block(), Vern9::new().rtol(ACCURATE).atol(ACCURATE));
    let end = |x: [f64; 2], u| model.step(0.0, 0.05, &x.into(), &[u]).expect("a step");
    assert_eq!(end([0.3, 0.0], 1.9), SVector::from([0.3, 0.0]), "held");
    assert_eq!(end([0.3, 0.05], -1.0)[1], 0.0, "comes to rest");
    for (x, u, without) in [
        ([0.3, 0.0], 1.9, &[][..]),
        ([0.3, 0.8], 3.0, &[]),
        ([0.3, 0.05], -1.0, &[]),
        ([0.3, 0.05], -4.0, &[]),
        // the derivative by the rate is taken over slower and faster starts in the direction of the slip
        ([0.3, 0.0], 4.0, &[1]),
    ] {
        let error = error(&model, 0.05, &x.into(), [u], without);
        assert!(error < ERROR, "{x:?}, {u} N: {error:.1e}");
    }
}

/// Pushes back and forth: the cart sticks while the pole swings, and rebounds from both stops.
#[test]
fn derivatives_through_friction_and_impacts_are_those_of_differences() {
    let (model, h) = (
        Integrated::new(railed(), Vern9::new().rtol(ACCURATE).atol(ACCURATE)),
        0.025,
    );
    let (mut x, mut held, mut impacts) = (SVector::from([0.0, 2.0, 0.0, 0.0]), 0, 0);
    for k in 0..160 {
        let u = [match k / 20 % 4 {
            _ if k < 20 => 1.0,
            1 => 6.0,
            3 => -6.0,
            _ => 0.0,
        }];
        let end = model.step(0.0, h, &x, &u).expect("a step");
        let slips_at_once = x[2] == 0.0 && end[2] != 0.0;
        let without: &[usize] = if slips_at_once { &[2] } else { &[] };
        let error = error(&model, h, &x, u, without);
        assert!(error < ERROR, "node {k}: {error:.1e}");
        held += usize::from(x[2] == 0.0 && end[2] == 0.0);
        impacts += usize::from((end[2] - x[2]).abs() > 0.3);
        x = end;
    }
    assert!(held > 15 && impacts > 2, "{held} steps at rest, {impacts} impacts");
}

/// Cost of the motion of a block under given inputs.
fn cost(model: &impl StepMap<f64, 2, 1>, cost: &Quadratic<f64, 2, 1>, inputs: &[[f64; 1]; 40]) -> f64 {
    let mut x = SVector::zeros();
    let mut sum = 0.0;
    for u in inputs {
        sum += 0.05 * cost.running(0.0, &x, u);
        x = model.step(0.0, 0.05, &x, u).expect("a step");
    }
    sum + cost.end(0.0, &x)
}

#[test]
fn a_block_is_pushed_through_friction_and_comes_to_rest_at_its_target() {
    let model = Integrated::new(block(), Tsit5::new());
    let mut ilqr = pushed(5.0);
    let mut last = f64::INFINITY;
    for _ in 0..5 {
        let pass = ilqr.pass(&model, 0.0, [0.0, 0.0]).expect("a motion");
        assert!(pass.cost < last && pass.share > 0.0, "{pass:?} after {last}");
        last = pass.cost;
    }
    let solved = ilqr.solve(&model, 0.0, [0.0, 0.0]).expect("a motion");
    assert!(solved.cost < 0.1 && solved.cost < last, "{solved:?}");
    // friction brakes and holds it, without force
    let held = ilqr
        .states()
        .iter()
        .zip(ilqr.inputs())
        .skip(1)
        .filter(|(x, _)| x[1] == 0.0);
    let forces: Vec<f64> = held.map(|(_, u)| u[0].abs()).collect();
    assert!(forces.len() > 3, "{forces:?}");
    assert!(
        (ilqr.end()[0] - 1.0).abs() < 1e-3 && ilqr.end()[1] == 0.0,
        "{}",
        ilqr.end()
    );
    assert!(forces.iter().filter(|&&force| force < 1e-6).count() > 3, "{forces:?}");
    // no single input decreases the cost
    let weights = *ilqr.cost_mut();
    for k in 0..40 {
        for change in [-1e-3, 1e-3] {
            let mut inputs = *ilqr.inputs();
            inputs[k][0] += change;
            let changed = cost(&model, &weights, &inputs);
            assert!(
                changed > solved.cost * (1.0 - 1e-5),
                "{k}, {change}: {changed} from {}",
                solved.cost
            );
        }
    }
}

/// Friction holds the block under small forces, so that their derivatives are zero.
#[test]
fn forces_below_the_friction_are_a_local_minimum() {
    let model = Integrated::new(block(), Tsit5::new());
    let mut ilqr = pushed(1.9);
    let solved = ilqr.solve(&model, 0.0, [0.0, 0.0]).expect("a motion");
    assert_eq!(ilqr.end(), &SVector::from([0.0, 0.0]));
    assert!((solved.cost - 100.0).abs() < 1e-9, "{solved:?}");
}

/// The cart sticks, slips and rebounds. The search goes along several kinks of the cost, which takes long: after 40
/// iterations the motion reaches the target, whatever has ended the search.
#[test]
fn a_pole_swings_up_between_stops() {
    let model = Integrated::new(railed(), Tsit5::new());
    let cost = Quadratic::diagonal([1.0, 1.0, 0.0, 0.0], [0.1]).end(diagonal([30.0, 30.0, 5.0, 5.0]));
    let mut ilqr = Ilqr::<_, _, 4, 1, 80>::new(0.025, cost)
        .limits([-8.0], [8.0])
        .start([2.0])
        .max_iterations(40);
    let cost = match ilqr.solve(&model, 0.0, [0.0, 2.5, 0.0, 0.0]) {
        Ok(solved) => solved.cost,
        Err(IlqrError::NoDecrease { cost, .. } | IlqrError::TooManyIterations { cost, .. }) => cost,
        Err(error) => panic!("{error}"),
    };
    assert!(cost < 21.0 && ilqr.end().amax() < 0.2, "{cost}, {}", ilqr.end());
    let steps = || ilqr.states().windows(2).map(|pair| [pair[0][2], pair[1][2]]);
    let held = steps().filter(|rates| *rates == [0.0; 2]).count();
    let rebounds = steps().filter(|[before, after]| before * after < -0.1).count();
    assert!(held > 5 && rebounds > 0, "{held} steps at rest, {rebounds} rebounds");
    assert!(ilqr.states().iter().all(|x| x[0].abs() <= 0.5));
}

/// The impact comes to a node, where the cost has a kink: the search goes along it to the same motion from all starts.
#[test]
fn searches_end_at_a_kink_of_the_cost() {
    let model = Integrated::new(Rebounding::new(ReboundingParams {}).expect("physical"), Tsit5::new());
    let cost = Quadratic::diagonal([0.0, 0.0], [0.05])
        .end(diagonal([100.0, 10.0]))
        .goal([-1.0, 0.0], [0.0]);
    for start in [-1.0, -0.5, 0.0, 0.5, 1.0] {
        let mut ilqr = Ilqr::<_, _, 2, 1, 60>::new(0.025, cost)
            .limits([-2.0], [2.0])
            .start([start]);
        let solved = ilqr.solve(&model, 0.0, [0.0, 5.0]).expect("a motion");
        assert!(
            solved.iterations < 50 && solved.cost < 1.7e-3,
            "{start} N m: {solved:?}"
        );
        assert!(
            ilqr.states()
                .windows(2)
                .any(|pair| pair[0][1] > 2.0 && pair[1][1] < -1.0),
            "rebounds"
        );
        assert!(ilqr.gain(0).norm() > 0.0, "the gains are kept");
    }
}

#[test]
fn a_predictive_controller_stops_a_block_at_its_target() {
    let mut ilqr = pushed(5.0);
    let model = Integrated::new(block(), Tsit5::new());
    ilqr.solve(&model, 0.0, [0.0, 0.0]).expect("a motion");
    let sampled = Sampled::new(ilqr.controller(model).expect("in range"), 0.05).limits([-6.0], [6.0]);
    let end = sampled
        .end(&Tsit5::new(), &block(), 0.0, 3.0, [0.0, 0.0])
        .expect("a motion");
    assert!((end[0] - 1.0).abs() < 1e-2 && end[1] == 0.0, "{end}");
}

#[test]
fn steps_that_fail_say_why() {
    let model = Integrated::new(railed(), Tsit5::new());
    let mut ilqr = Ilqr::<_, _, 4, 1, 10>::new(0.025, Quadratic::diagonal([1.0; 4], [0.1]));
    let error = ilqr.solve(&model, 0.0, [0.6, 0.0, 0.0, 0.0]).expect_err("beyond");
    let IlqrError::StepFailed {
        node: 0,
        reason: Reason::BeyondLimit { .. },
    } = error
    else {
        panic!("{error}");
    };
    assert!(
        error.to_string().contains("\nhelp: ") || error.to_string().contains("start within"),
        "{error}"
    );
}
