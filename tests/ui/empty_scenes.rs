//! Scenes in which nothing is left: their errors cause no others.

use pendulum_core::prelude::*;

mechanism! {
    pub Empty {}
}

mechanism! {
    pub Unread {
        state x: m { rate: -x }
    }
}

fn main() {
    let _ = Empty::new(EmptyParams {});
}
