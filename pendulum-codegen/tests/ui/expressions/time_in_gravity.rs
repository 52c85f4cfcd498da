mechanism! {
    pub Arm {
        gravity: [0, -9.81*sin(1 rad/s*t), 0],
        body a on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th }
    }
}
