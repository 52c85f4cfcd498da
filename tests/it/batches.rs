//! Functions of many states at once have the bits of each evaluation alone, whatever remains in the last lanes.

use pendulum_core::Real;
use pendulum_core::batch::{self, StateFunction};
use pendulum_core::error::Reason;
use pendulum_core::prelude::*;
use testbed::random::Random;

mechanism! {
    pub Arm {
        params { l: m = 0.7, gamma: N m s = 0.1 }
        gravity: [0, -9.81, 0],
        point tip on lower at [0, -l, 0],
        output tip: tip,
        body upper on ground {
            solids: [rod(1, [0, 0, 0], [0, -l, 0])], joint: revolute(z), coordinate: a, friction: gamma,
        }
        body lower on upper {
            solids: [rod(1, [0, 0, 0], [0, -l, 0])], joint: revolute(z) at [0, -l, 0], coordinate: b, friction: gamma,
        }
    }
}

mechanism! {
    pub Cart {
        params { m: kg = 2 }
        input push: N,
        input torque: N m,
        gravity: [0, -9.81, 0],
        body cart on ground { mass: m, joint: prismatic(x), coordinate: s, torque: push }
        body pole on cart { mass: 1, com: [0, 1, 0], joint: revolute(z), coordinate: angle, torque: torque }
    }
}

/// More than a whole number of registers of any machine.
const COUNT: usize = 37;

fn states() -> Vec<SVector<f64, 4>> {
    let mut random = Random::new(3);
    (0..COUNT)
        .map(|_| SVector::from_fn(|_, _| random.between(-2.0, 2.0)))
        .collect()
}

fn arms() -> Vec<Arm> {
    let arm = |n: usize| {
        Arm::new(ArmParams {
            l: 0.5 + 0.01 * n as f64,
            gamma: 0.1,
        })
    };
    (0..COUNT).map(|n| arm(n).expect("positive lengths")).collect()
}

#[test]
fn batches_have_the_bits_of_single_evaluations() {
    let (arms, states) = (arms(), states());
    for models in [&arms[..], &arms[..1]] {
        let of = |n: usize| &models[n.min(models.len() - 1)];
        let (mut rates, mut jacobians) = ([SVector::zeros(); COUNT], [SMatrix::zeros(); COUNT]);
        batch::rhs(models, 0.5, &states, &mut rates).expect("one for each");
        batch::jacobian(models, 0.5, &states, &mut jacobians).expect("one for each");
        for n in 0..COUNT {
            assert_eq!(rates[n], of(n).rhs(0.5, &states[n]), "rate {n}");
            assert_eq!(jacobians[n], of(n).jacobian(0.5, &states[n]), "Jacobian {n}");
        }
    }
}

/// Energy, and height of the tip.
struct EnergyAndHeight;

impl StateFunction<Arm, 4, 2> for EnergyAndHeight {
    #[inline(always)]
    fn value<T: Real>(&self, arm: &Arm<T>, t: T, x: &SVector<T, 4>) -> SVector<T, 2> {
        SVector::from([arm.energy(t, x), arm.tip(t, x)[1]])
    }
}

#[test]
fn functions_of_the_user_run_in_lanes() {
    let (arms, states) = (arms(), states());
    let mut values = [SVector::zeros(); COUNT];
    batch::evaluate(&EnergyAndHeight, &arms, 0.0, &states, &mut values).expect("one for each");
    for n in 0..COUNT {
        assert_eq!(values[n], EnergyAndHeight.value(&arms[n], 0.0, &states[n]), "value {n}");
    }
}

#[test]
fn inputs_differ_from_state_to_state() {
    let cart = Cart::new(CartParams::default()).expect("valid");
    let states = states();
    let inputs: Vec<SVector<f64, 2>> = states.iter().map(|x| SVector::from([x[0] * x[1], x[2]])).collect();
    let mut rates = [SVector::zeros(); COUNT];
    batch::rhs_with_inputs(&[cart], 0.0, &states, &inputs, &mut rates).expect("one for each");
    for n in 0..COUNT {
        let [push, torque] = inputs[n].into();
        let held = cart.with_inputs(|_, _| CartInputs { push, torque });
        assert_eq!(rates[n], held.rhs(0.0, &states[n]), "rate {n}");
    }
}

#[test]
fn batches_of_nothing_and_of_other_lengths() {
    let arm = &arms()[..1];
    batch::rhs(arm, 0.0, &[], &mut [] as &mut [SVector<f64, 4>]).expect("nothing to do");
    batch::rhs(&[] as &[Arm], 0.0, &[], &mut [] as &mut [SVector<f64, 4>]).expect("nothing to do");
    let (states, mut rates) = (states(), [SVector::zeros(); COUNT]);
    let name = |result: Result<(), Reason>| match result.expect_err("lengths differ") {
        Reason::InvalidInput { what, .. } => what,
        other => panic!("{other}"),
    };
    assert_eq!(name(batch::rhs(arm, 0.0, &states, &mut rates[1..])), "results");
    assert_eq!(name(batch::rhs(&arms()[..2], 0.0, &states, &mut rates)), "models");
    let cart = Cart::new(CartParams::default()).expect("valid");
    let inputs = [SVector::zeros(); 3];
    assert_eq!(
        name(batch::rhs_with_inputs(&[cart], 0.0, &states, &inputs, &mut rates)),
        "inputs"
    );
}
