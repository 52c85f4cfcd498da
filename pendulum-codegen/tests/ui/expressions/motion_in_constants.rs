mechanism! {
    pub Arm {
        body a on ground { mass: 1 + sin(1 rad/s*t), com: [0, -1, 0], joint: revolute(z), coordinate: x1 }
        body b on a { mass: 1, com: [0, -1, x1], joint: revolute(z) at [0, -dot(x1), 0], coordinate: x2 }
        body c on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: x3, friction: 0.1 * qd }
    }
}
