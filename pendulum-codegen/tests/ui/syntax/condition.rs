mechanism! {
    pub Arm {
        body b0 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th0,
            torque: if t > 1 { 1 } else { 0 } }
        body b1 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th1, torque: th1 > 0 }
        body b2 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th2,
            torque: match th2 { _ => 0 } }
        body b3 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th3, torque: th3 == 0 }
        body b4 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th4, torque: (th4 < 1)*2 }
    }
}
