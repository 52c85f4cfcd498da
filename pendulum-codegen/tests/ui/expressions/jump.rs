mechanism! {
    pub Arm {
        body b0 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th0, torque: sign(th0) }
        body b1 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th1, torque: signum(th1) }
        body b2 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th2, torque: sgn(qd) }
        body b3 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th3, torque: step(t) }
        body b4 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th4, torque: floor(th4) }
        body b5 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th5, torque: saturate(th5, 0, 1) }
        body b6 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th6, torque: max(th6, 0) }
    }
}
