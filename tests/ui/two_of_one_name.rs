//! Two mechanisms of one name are told by that name, and by little else.

use pendulum_core::prelude::*;

mechanism! {
    pub Swing {
        gravity: [0, -9.81, 0],
        body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle }
    }
}

mechanism! {
    pub Swing {
        gravity: [0, -9.81, 0],
        body bob on ground { mass: 2, com: [0, -1, 0], joint: revolute(z), coordinate: angle }
    }
}

fn main() {
    let _ = Swing::new(SwingParams {});
}
