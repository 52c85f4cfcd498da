mechanism! {
    pub Arm {
        generate: [],
        body a on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th }
    }
}

mechanism! {
    pub Arm {
        generate: rhs,
        body a on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th }
    }
}
