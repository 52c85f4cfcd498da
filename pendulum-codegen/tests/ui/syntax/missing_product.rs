mechanism! {
    pub Arm {
        params { m: kg = 1, l: m = 1 }
        body b0 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th0, torque: m l }
        body b1 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th1, torque: (m)(l) }
        body b2 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th2, torque: m(l) }
        body b3 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th3, torque: 2 l }
        body b4 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th4, torque: sin th4 }
        body b5 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th5, torque: sin }
        body b6 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th6, torque: (m l) }
    }
}
