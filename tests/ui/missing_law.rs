//! A model with inputs is no system before these have a law, and a law has no derivative before it is given one.

use pendulum_core::prelude::*;

mechanism! {
    pub Cart {
        input push: N,
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: push }
    }
}

fn main() {
    let cart = Cart::new(CartParams {}).unwrap();
    let _ = Rk45::new().solve(&cart, 0.0, 1.0, [0.0, 0.0]);
    let pushed = cart.with_inputs(|_, _| CartInputs { push: 1.0 });
    let _ = Rodas5P::new().solve(&pushed, 0.0, 1.0, [0.0, 0.0]);
}
