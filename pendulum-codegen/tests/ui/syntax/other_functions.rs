mechanism! {
    pub Arm {
        body b0 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th0, torque: sinh(th0) }
        body b1 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th1, torque: acos(th1) }
        body b2 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th2, torque: atan(th2) }
        body b3 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th3, torque: log(2 + th3^2) }
        body b4 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th4, torque: pow(th4, 2) }
        body b5 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th5, torque: hypot(1, th5) }
        body b6 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th6, torque: radians(90) }
        body b7 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th7, torque: ddot(th7) }
        body b8 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th8, torque: der(th8) }
        body b9 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th9, torque: arcsine(th9) }
    }
}
