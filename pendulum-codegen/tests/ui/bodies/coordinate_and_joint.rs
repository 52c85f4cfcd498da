mechanism! {
    pub Arm {
        body base on ground { mass: 1, joint: fixed, coordinate: x1, friction: 1 }
        body arm on base { mass: 1, com: [0, -1, 0], joint: revolute(z) }
        body tip on arm { mass: 1, joint: fixed at [0, -1, 0], torque: 3 }
    }
}
