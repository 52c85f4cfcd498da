mechanism! {
    pub Arm {
        params { m: kg = 1 }
        body b0 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th0, torque: 2**3 }
        body b1 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th1, torque: th1 % 2 }
        body b2 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th2, torque: -.5 }
        body b3 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th3, torque: +1 }
        body b4 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th4, torque: |th4| }
        body b5 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th5, torque: m as f64 }
        body b6 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th6, torque: !th6 }
        body b7 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th7, torque: [1, 2] }
        body b8 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th8, torque: m ? 1 : 2 }
        body b9 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th9, torque: m* }
    }
}
