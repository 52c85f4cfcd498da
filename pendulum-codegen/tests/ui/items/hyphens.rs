mechanism! {
    pub Arm {
        generate: [rhs, mass-matrix],
        body a on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th }
    }
}
