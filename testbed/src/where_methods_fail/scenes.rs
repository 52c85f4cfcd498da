//! Mechanisms of the cases.

use pendulum_core::prelude::*;

mechanism! {
    /// A mass on a spring with friction: `x'' = -k x - gamma x'`.
    pub Cart {
        params { k: N/m = 0.0, gamma: N s/m = 0.0 }
        generate: [rhs, jacobian, taylor, canonical],
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: x, spring: (k, 0), friction: gamma }
    }
}

pub fn cart(k: f64, gamma: f64) -> Cart {
    Cart::new(CartParams { k, gamma }).expect("physical")
}

mechanism! {
    /// Two point masses on massless rods of 1 m.
    pub Points {
        params { m1: kg = 1.0, m2: kg = 1.0 }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, taylor, canonical],
        body upper on ground { mass: m1, com: [0, -1, 0], joint: revolute(z), coordinate: theta1 absolute }
        body lower on upper { mass: m2, com: [0, -1, 0], joint: revolute(z) at [0, -1, 0], coordinate: theta2 absolute }
    }
}

mechanism! {
    /// Two rods with dry friction in the joints.
    pub DryPendulum {
        params { mu1: N m, mu2: N m }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy],
        shape rod { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body upper on ground: rod { joint: revolute(z), coordinate: theta1, dry_friction: mu1 }
        body lower on upper: rod { joint: revolute(z) at [0, -1, 0], coordinate: theta2, dry_friction: mu2 }
    }
}

mechanism! {
    /// Like `DryPendulum`, but with friction smoothed over a rate of `eps`.
    pub SmoothedPendulum {
        params { mu1: N m, mu2: N m, eps: rad/s }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian],
        shape rod { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body upper on ground: rod { joint: revolute(z), coordinate: theta1, torque: -mu1*tanh(qd/eps) }
        body lower on upper: rod { joint: revolute(z) at [0, -1, 0], coordinate: theta2, torque: -mu2*tanh(qd/eps) }
    }
}
