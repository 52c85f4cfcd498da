mechanism! {
    pub Arm {
        shape stick { mass: 1, com: [0, -1, 0], joint: revolute(z) }
        body a on ground {
            gravity: [0, -9.81, 0], params { m: kg = 1 } mass: 1, joint: revolute(z), shape: stick, coordinate: th,
        }
        mass: 1,
    }
}
