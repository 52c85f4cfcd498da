//! The parameters of a model are fixed, since its constants follow from them.

use pendulum_core::prelude::*;

mechanism! {
    pub Swing {
        params { l: m = 1 }
        gravity: [0, -9.81, 0],
        body bob on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: angle }
    }
}

fn main() {
    let mut swing = Swing::new(SwingParams::default()).unwrap();
    swing.params.l = 2.0;
}
