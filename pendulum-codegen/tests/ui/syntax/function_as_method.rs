mechanism! {
    pub Arm {
        body b0 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th0, torque: th0.sin() }
        body b1 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th1, torque: th1.powi(2) }
        body b2 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th2, torque: 2.0.sqrt() }
        body b3 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th3, torque: (1 + th3).cos() }
        body b4 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th4, torque: th4.dot }
        body b5 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th5, torque: th5.atan2(1) }
    }
}
