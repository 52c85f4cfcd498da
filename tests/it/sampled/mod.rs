//! Generated mechanisms under sampled controllers.

mod controllers;
mod devices;
mod events;
mod exact;
mod lanes;
mod modes;
mod refused;

use pendulum_core::control::LinearLaw;
use pendulum_core::prelude::*;
use pendulum_core::{InputLaw, Real};

mechanism! {
    /// A double pendulum with two motors; the angles are 0 where it hangs, the second is relative to the first.
    pub Robot {
        params { m1: kg = 1, m2: kg = 0.8, l1: m = 0.5, l2: m = 0.4, g: m/s^2 = 9.81 }
        input shoulder: N m, input elbow: N m,
        gravity: [0, -g, 0],
        body upper on ground {
            solids: [rod(m1, [0, 0, 0], [0, -l1, 0])], joint: revolute(z), coordinate: theta, torque: shoulder,
        }
        body lower on upper {
            solids: [rod(m2, [0, 0, 0], [0, -l2, 0])], joint: revolute(z) at [0, -l1, 0], coordinate: phi,
            torque: elbow,
        }
    }
}

mechanism! {
    /// A cart on a spring: linear.
    pub Cart {
        params { m: kg = 2, k: N/m = 8, c: kg/s = 0.4 }
        input push: N,
        body cart on ground {
            mass: m, joint: prismatic(x), coordinate: s, torque: push, spring: (k, 0), friction: c,
        }
    }
}

const START: [f64; 4] = [1.0, -0.5, 0.0, 0.0];

/// Holds the arm of a robot stretched out to the side.
const HOLD: LinearLaw<4, 2> = LinearLaw {
    gain: SMatrix::<f64, 2, 4>::new(15.0, 2.0, 3.0, 0.3, 1.5, 4.0, 0.2, 0.5),
    x0: SVector::<f64, 4>::new(1.4, 0.2, 0.0, 0.0),
    u0: [6.0, 1.5],
};

/// Inputs that depend on time alone.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Wave {
    /// Time by which it is late.
    late: f64,
}

impl InputLaw<4, 2> for Wave {
    fn inputs<T: Real>(&self, t: T, _x: &SVector<T, 4>) -> [T; 2] {
        let (sin, cos) = ((t - T::from_f64(self.late)) * T::from_f64(7.0)).sin_cos();
        [T::from_f64(2.0) * sin, cos]
    }
}

fn robot() -> Robot {
    Robot::new(RobotParams::default()).expect("physical")
}

fn cart() -> Cart {
    Cart::new(CartParams::default()).expect("physical")
}

/// A method with the tightest tolerance.
fn tight() -> Vern9 {
    Vern9::new().rtol(1e-13).atol(1e-14)
}

/// Pulls a cart back.
const HOLD_CART: LinearLaw<2, 1> = LinearLaw {
    gain: SMatrix::<f64, 1, 2>::new(20.0, 6.0),
    x0: SVector::<f64, 2>::new(0.5, 0.0),
    u0: [4.0],
};
