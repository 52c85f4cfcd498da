//! Motions whose power series do not reveal their radius of convergence.

use std::f64::consts::FRAC_PI_2;

use approx::assert_abs_diff_eq;
use pendulum_core::TaylorSeries;
use pendulum_core::prelude::*;

mechanism! {
    /// Released from the horizontal, it has nonzero coefficients of orders 1 and 2 modulo 4 only.
    pub Swing {
        gravity: [0, -9.81, 0],
        generate: [rhs, taylor],
        body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle }
    }
}

mechanism! {
    /// Friction that saturates: on its flat parts the series contains no trace of the step.
    pub Rubbing {
        params { steep: s = 30.0 }
        gravity: [0, -9.81, 0],
        generate: [rhs, taylor],
        body bob on ground {
            mass: 1, com: [0, -1, 0],
            joint: revolute(z), coordinate: angle,
            torque: -0.2 * tanh(steep * qd),
        }
    }
}

/// Compares the Taylor method with Verner's, at several tolerances and orders.
fn assert_alike<S>(system: &S, x0: [f64; 2])
where
    S: TaylorSeries<f64, 2>,
{
    let expected = Vern9::new().rtol(1e-13).atol(1e-13).h_max(0.02);
    let expected = expected.solve(system, 0.0, 10.0, x0).expect("regular").end();
    for tolerance in [1e-6, 1e-9, 1e-12] {
        for order in [4, 8, 11, 12, 13, 14, 15, 16, 20, 24] {
            let method = Taylor::new().order(order).rtol(tolerance).atol(tolerance);
            let x = method.solve(system, 0.0, 10.0, x0).expect("regular").end();
            // ten seconds multiply an error by some tens
            assert_abs_diff_eq!(x, expected, epsilon = 100.0 * tolerance);
        }
    }
}

#[test]
fn a_motion_with_every_fourth_coefficient() {
    assert_alike(&Swing::new(SwingParams {}).expect("physical"), [FRAC_PI_2, 0.0]);
}

#[test]
fn a_friction_that_saturates() {
    for steep in [1.0, 30.0, 1000.0] {
        assert_alike(&Rubbing::new(RubbingParams { steep }).expect("physical"), [1.0, 0.0]);
    }
}
