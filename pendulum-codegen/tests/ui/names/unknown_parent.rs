mechanism! {
    pub Arm {
        body arm on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta1 }
        body tip on amr { mass: 1, com: [0, -1, 0], joint: revolute(z) at [0, -1, 0], coordinate: theta2 }
    }
}
