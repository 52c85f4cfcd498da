mechanism! {
    pub Arm {
        params { m: kg = 1 }
        body b0 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th0, torque: th0_dot }
        body b1 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th1, torque: dth1 }
        body b2 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th2, torque: dot(dot(th2)) }
        body b3 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th3, torque: dot(q) }
        body b4 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th4, torque: dot(m) }
        body b5 on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th5, torque: 1 N m s*dot(th5 + th5)
        }
        body b6 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th6, torque: qdot }
    }
}
