pendulum_core::mechanism! {
    pub Statue {
        body a on ground { mass: 1 }
    }
}

pendulum_core::mechanism! {
    pub Void {}
}

pendulum_core::mechanism! {
    pub Headless
}

fn main() {}
