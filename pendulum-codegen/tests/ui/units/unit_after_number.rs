mechanism! {
    pub Arm {
        body b0 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th0, torque: 90deg }
        body b1 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th1, torque: 90 deg }
        body b2 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th2, torque: 5cm }
        body b3 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th3, torque: 1.5 kg }
        body b4 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th4, torque: 2 m }
        body b5 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th5, torque: 3 Nm }
        body b6 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th6, torque: 1f64 }
        body b7 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th7, torque: 4 N*th6 }
        body b8 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th8, torque: 3 rpm }
    }
}
