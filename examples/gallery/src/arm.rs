//! # Arm with an end effector
//!
//! Three joints in space and a hand: its position, velocity, Jacobian and orientation are outputs. A force on the hand
//! acts as `J^T f` on the joints.

use pendulum_core::prelude::*;

use crate::{Check, Run};

mechanism! {
    /// An arm with shoulder, elbow and hand; z points upward.
    pub Arm {
        params { push: N = 3 }
        gravity: [0, 0, -9.81],
        body base on ground {
            solids: [cylinder(3, 0.06, [0, 0, 0], [0, 0, 0.3])],
            joint: revolute(z), coordinate: q1, friction: 0.4,
        }
        body boom on base {
            solids: [cylinder(2, 0.04, [0, 0, 0], [0.4, 0, 0])],
            joint: revolute(y) at [0, 0.1, 0.3], coordinate: q2, friction: 0.4,
        }
        body forearm on boom {
            solids: [cylinder(1, 0.03, [0, 0, 0], [0.35, 0, 0])],
            joint: revolute(y) at [0.4, 0, 0], coordinate: q3, friction: 0.2,
        }
        point hand on forearm at [0.35, 0, 0],
        force on hand: [push, 0, 0],
        output hand: hand,
        output wrist: rotation(forearm),
        generate: [rhs, energy, mass_matrix, bias, shapes],
    }
}

/// Checks the hand against its closed form, its Jacobian by differences, the force through the Jacobian, and the power
/// of friction and force.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let model = Arm::new(ArmParams::default())?;
    let x = SVector::from([0.456, -1.406, -0.991, -0.916, -0.815, -2.263_f64]);
    let ((s1, c1), (s2, c2), (s23, c23)) = (x[0].sin_cos(), x[1].sin_cos(), (x[1] + x[2]).sin_cos());
    let reach = 0.4 * c2 + 0.35 * c23;
    let place = [
        c1 * reach - 0.1 * s1,
        s1 * reach + 0.1 * c1,
        0.3 - 0.4 * s2 - 0.35 * s23,
    ];
    let (hand, jacobian) = model.hand_and_jacobian(0.0, &x);
    let mut by_differences = [0.0; 9];
    for k in 0..3 {
        let moved = |h: f64| {
            let mut x = x;
            x[k] += h;
            model.hand(0.0, &x)
        };
        let slope = |h: f64| (moved(h) - moved(-h)) / (2.0 * h);
        by_differences[3 * k..3 * k + 3].copy_from_slice(((4.0 * slope(1e-3) - slope(2e-3)) / 3.0).as_slice());
    }
    let of_hand = jacobian.fixed_columns::<3>(0).into_owned();
    let rates = x.fixed_rows::<3>(3).into_owned();
    let taken = model.mass_matrix(0.0, &x) * model.rhs(0.0, &x).fixed_rows::<3>(3) + model.bias(0.0, &x);
    let friction = SVector::from([0.4, 0.4, 0.2]).component_mul(&rates);
    let force = of_hand.transpose() * SVector::from([3.0, 0.0, 0.0]) - friction;
    let checks = vec![
        Check::same("position of the hand, in m", hand.as_slice(), &place, 1e-15),
        Check::same("Jacobian by differences", of_hand.as_slice(), &by_differences, 1e-11),
        Check::same(
            "velocity of the hand, in m/s",
            model.hand_rate(0.0, &x).as_slice(),
            (of_hand * rates).as_slice(),
            1e-14,
        ),
        Check::same(
            "forces through the Jacobian, in N m",
            taken.as_slice(),
            force.as_slice(),
            1e-12,
        ),
    ];
    let start = [0.0, -0.8, 0.5, 3.0, 0.0, 0.0];
    let solution = Vern9::new().rtol(1e-12).atol(1e-12).solve(&model, 0.0, 4.0, start)?;
    let powers = move |t: f64, x: &SVector<f64, 6>| {
        let lost = [0.4, 0.4, 0.2]
            .into_iter()
            .zip(x.iter().skip(3))
            .map(|(c, rate)| -c * rate * rate);
        lost.chain([3.0 * model.hand_rate(t, x).x]).collect()
    };
    Run::new(checks, model, solution, powers, |drawing| {
        drawing.seen_from([0.5, -1.0, 0.4], [0.0, 0.0, 1.0])
    })
}
