mechanism! {
    pub Cart {
        generate: [rhs, canonical],
        input push: N,
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: push }
    }
}
