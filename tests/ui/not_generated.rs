//! Using a routine that was not generated is an error.

use pendulum_core::prelude::*;

mechanism! {
    pub Arm {
        params { gamma: N m s }
        generate: [rhs],
        body arm on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta, friction: gamma }
    }
}

fn main() {
    let arm = Arm::new(ArmParams::default()).unwrap();
    let x = SVector::from([0.1, 0.0]);
    println!("{} {}", arm.mass_matrix(0.0, &x), arm.kinetic(0.0, &x));
}
