mechanism! {
    pub Arm {
        body b0 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th0, torque: f64::sin(th0) }
        body b1 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th1,
            torque: std::f64::consts::PI }
        body b2 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th2,
            torque: core::f64::consts::TAU*th2 }
        body b3 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th3, torque: pi::pi - th3:: }
    }
}
