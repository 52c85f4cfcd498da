//! A law that changes what it captures is an error on that, not on the declaration.

use pendulum_core::prelude::*;

mechanism! {
    pub Arm {
        input push: N m,
        body arm on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta, torque: push }
    }
}

fn main() {
    let arm = Arm::new(ArmParams {}).unwrap();
    let mut integral = 0.0;
    let _ = arm.with_inputs(|_t, x| {
        integral += x[0];
        ArmInputs { push: -integral }
    });
}
