//! Two scenes of one name in one module.

use pendulum_core::prelude::*;

mechanism! {
    pub Arm {
        body arm on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta }
    }
}

mechanism! {
    pub Arm {
        body arm on ground { mass: 2, com: [0, -1, 0], joint: revolute(z), coordinate: theta }
    }
}

fn main() {}
