//! All mistakes of a declaration are reported together, and uses of the model are no errors of their own.

use pendulum_core::prelude::*;

mechanism! {
    pub Arm {
        params { m: kg = 1, l: meter = 1, unused: m = 2 }
        gravty: [0, -9.81, 0],
        body arm on ground {
            mass: -1,
            com: [0, -l],
            joint: revolut(z),
            coordinate: theta1,
            friction: 0.1 * gamma,
        }
        body tip on amr { mass: m, joint: prismatic([0, 0, 0]), coordinate: theta2 }
    }
}

fn main() {
    let arm = Arm::new(ArmParams::default()).unwrap();
    let solution = Rk45::new().solve(&arm, 0.0, 1.0, [0.0, 0.0, 0.0, 0.0]).unwrap();
    println!("{} {}", solution.end(), arm.energy(0.0, &solution.end()));
}
