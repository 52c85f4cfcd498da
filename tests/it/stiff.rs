//! Methods for stiff systems: their promises, tested on problems with known solutions.

use pendulum_core::Solution;
use pendulum_core::prelude::*;

mod driven {
    pendulum_core::mechanism! {
        /// A pendulum with a motor torque that depends on time.
        pub Driven {
            params { m: kg = 1.3, l: m = 0.7, g: m/s^2 = 9.81, w: 1/s = 2.3, u: N m = 0.9 }
            gravity: [0, -g, 0],
            body bob on ground {
                joint: revolute(z),
                coordinate: theta,
                mass: m,
                com: [0, -l, 0],
                inertia: m * l^2,
                torque: u * exp(-w * t) * cos(theta) + u * sin(w * t),
            }
        }
    }
}

use driven::{Driven, DrivenParams};
use testbed::scenes::{DoublePendulum, double_pendulum};
use testbed::trajectories::scene;

#[test]
fn the_generated_derivative_by_time_is_that_of_the_right_hand_side() {
    let model = Driven::new(DrivenParams::default()).expect("physical");
    let x = SVector::from([0.7, -0.4]);
    for t in [0.0, 0.3, 2.9] {
        // a central difference of order 4, with truncation errors of 1e-11 and rounding errors of 1e-13
        let h = 1e-3;
        let difference = |h: f64| (model.rhs(t + h, &x) - model.rhs(t - h, &x)) / (2.0 * h);
        let expected = (difference(h) * 4.0 - difference(2.0 * h)) / 3.0;
        let exact = model.time_derivative(t, &x);
        assert!((exact - expected).amax() < 1e-9, "{exact} {expected}");
        assert!(exact.amax() > 0.1 && exact[0] == 0.0, "{exact}");
    }
    assert_eq!(Driven::<f64>::COST["time_derivative"].operations.sincos, 2);
}

const START: [f64; 4] = [1.0, -1.0, 0.0, 0.0];

/// Solutions by all methods at a tolerance.
fn solve(system: &DoublePendulum, tolerance: f64, t1: f64) -> [Solution<f64, 4>; 3] {
    [
        Rodas4::new()
            .rtol(tolerance)
            .atol(tolerance)
            .solve(system, 0.0, t1, START)
            .expect("regular"),
        Rodas5P::new()
            .rtol(tolerance)
            .atol(tolerance)
            .solve(system, 0.0, t1, START)
            .expect("regular"),
        Radau5::new()
            .rtol(tolerance)
            .atol(tolerance)
            .solve(system, 0.0, t1, START)
            .expect("regular"),
    ]
}

#[test]
fn a_stiff_trajectory_agrees_with_its_reference() {
    let reference = scene("stiff_axles").points();
    let system = double_pendulum(1e4);
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        for solution in solve(&system, tolerance, 5.0) {
            let mut worst = 0.0_f64;
            for &(t, expected) in &reference {
                worst = worst.max((solution.at(t).expect("within") - SVector::from(expected)).amax());
            }
            assert!(worst < 10.0 * tolerance, "{tolerance:e}: {worst:e}");
        }
    }
}
