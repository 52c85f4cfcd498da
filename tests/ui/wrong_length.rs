//! A start has as many numbers as the state, and a hint where their names are.

use pendulum_core::prelude::*;

mechanism! {
    pub Cart {
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: s }
    }
}

fn main() {
    let cart = Cart::new(CartParams {}).unwrap();
    let _ = Rk45::new().solve(&cart, 0.0, 1.0, [0.0; 3]);
}
