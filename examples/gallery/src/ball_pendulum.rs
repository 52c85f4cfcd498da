//! # Double pendulum in space
//!
//! A rod and a board, one below the other, on two ball joints. No torque acts about the vertical, so the angular
//! momentum about it is conserved, and so is the energy.

use nalgebra::Vector3;
use pendulum_core::prelude::*;

use crate::{Check, Run, double_pendulum, jacobian_by_differences, larger, orientation};

mechanism! {
    /// Two bodies on ball joints; z points upward.
    pub BallPendulum {
        gravity: [0, 0, -9.81],
        body rod on ground {
            solids: [cylinder(0.8, 0.02, [0, 0, 0], [0, 0, -0.5])],
            joint: ball, orientation: a,
        }
        body board on rod {
            solids: [cuboid(0.6, [0.02, 0.14, 0.36], [0, 0, -0.2])],
            joint: ball at [0, 0, -0.5], orientation: b,
        }
        point tip on board at [0, 0, -0.38],
        generate: [rhs, jacobian, energy, momentum, shapes],
    }
}

/// Moments of inertia of the rod.
const ROD: [f64; 3] = [
    0.8 * (3.0 * 0.02 * 0.02 + 0.5 * 0.5) / 12.0,
    0.8 * (3.0 * 0.02 * 0.02 + 0.5 * 0.5) / 12.0,
    0.8 * 0.02 * 0.02 / 2.0,
];
/// Moments of inertia of the board.
const BOARD: [f64; 3] = [
    0.6 * (0.14 * 0.14 + 0.36 * 0.36) / 12.0,
    0.6 * (0.02 * 0.02 + 0.36 * 0.36) / 12.0,
    0.6 * (0.02 * 0.02 + 0.14 * 0.14) / 12.0,
];

/// Angular momentum about the upper joint, body by body, by hand.
fn angular_momentum(x: &SVector<f64, 14>) -> Vector3<f64> {
    let rates = |at: usize| -> Vector3<f64> { x.fixed_rows::<3>(at).into_owned() };
    let rod = orientation(x, BallPendulum::A);
    let inward = orientation(x, BallPendulum::B);
    let board = rod * inward;
    // angular velocities in body frames, and in space
    let first = rates(BallPendulum::DOT_A);
    let second = rates(BallPendulum::DOT_B) + inward.inverse() * first;
    let turns = [rod * first, board * second];
    let down = [rod, board].map(|turned| turned * -Vector3::z());
    let [upper, joint, lower] = [0.25 * down[0], 0.5 * down[0], 0.2 * down[1]];
    let velocity = turns[0].cross(&joint) + turns[1].cross(&lower);
    let orbits = 0.8 * upper.cross(&turns[0].cross(&upper)) + 0.6 * (joint + lower).cross(&velocity);
    orbits + rod * Vector3::from(ROD).component_mul(&first) + board * Vector3::from(BOARD).component_mul(&second)
}

/// Checks energy and angular momentum (also by the momentum along the upper joint), a planar motion against its closed
/// form, and the Jacobian.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let model = BallPendulum::new(BallPendulumParams {})?;
    // rotations about y by these angles from the vertical, and their rates
    let [a, b, da, db] = [0.7, -0.4, 2.0, -3.0_f64];
    let mut plane = SVector::from([0.0; 14]);
    for (at, angle) in [(BallPendulum::A, a), (BallPendulum::B, b - a)] {
        let (sine, cosine) = (angle / 2.0).sin_cos();
        (plane[at], plane[at + 2]) = (cosine, sine);
    }
    (plane[BallPendulum::DOT_A + 1], plane[BallPendulum::DOT_B + 1]) = (da, db - da);
    let change = model.rhs(0.0, &plane);
    let first = change[BallPendulum::DOT_A + 1];
    let known = double_pendulum(
        [0.8, 0.25, ROD[1], 0.0],
        [0.6, 0.2, BOARD[1], 0.0],
        0.5,
        9.81,
        [a, b, da, db],
    );

    // leaning to one side, and pushed to the other
    let lean = |angle: f64| (angle / 2.0).sin_cos();
    let mut start = SVector::from([0.0; 14]);
    let ((s1, c1), (s2, c2)) = (lean(1.2), lean(0.8));
    (start[BallPendulum::A], start[BallPendulum::A + 2]) = (c1, s1);
    (start[BallPendulum::B], start[BallPendulum::B + 1]) = (c2, s2);
    start
        .fixed_rows_mut::<3>(BallPendulum::DOT_A)
        .copy_from_slice(&[2.5, 0.0, 1.0]);
    start
        .fixed_rows_mut::<3>(BallPendulum::DOT_B)
        .copy_from_slice(&[0.0, 2.0, 6.0]);
    let solution = Vern9::new().rtol(1e-13).atol(1e-13).solve(&model, 0.0, 3.0, start)?;
    let (energy, vertical) = (model.energy(0.0, &start), angular_momentum(&start).z);
    let (mut lost, mut turned, mut apart) = (0.0, 0.0, 0.0);
    for (t, x) in solution.points() {
        let ours = angular_momentum(x);
        let along = model.momentum(t, x).fixed_rows::<3>(0).into_owned();
        lost = larger(lost, (model.energy(t, x) - energy).abs());
        turned = larger(turned, (ours.z - vertical).abs());
        apart = larger(apart, (orientation(x, BallPendulum::A) * along - ours).norm());
    }
    let checks = vec![
        Check::same(
            "accelerations in a plane, in rad/s^2",
            &[first, first + change[BallPendulum::DOT_B + 1]],
            &known,
            1e-12,
        ),
        Check::new("change of the energy, in J", lost, 0.0, 1e-11),
        Check::new(
            "change of the angular momentum about the vertical, in N m s",
            turned,
            0.0,
            1e-12,
        ),
        Check::new("momentum along the upper joint, in N m s", apart, 0.0, 1e-13),
        jacobian_by_differences(&model, 0.0, start.into()),
    ];
    Run::new(
        checks,
        model,
        solution,
        |_, _| Vec::new(),
        |drawing| drawing.seen_from([0.6, -1.0, 0.5], [0.0, 0.0, 1.0]).ghosts(3),
    )
}
