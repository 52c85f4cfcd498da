mechanism! {
    pub Arm {
        body b0 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z) rpy [90, 0, -180], coordinate: th0 }
        body b1 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z) rpy [0, 0, 90deg], coordinate: th1 }
    }
}
