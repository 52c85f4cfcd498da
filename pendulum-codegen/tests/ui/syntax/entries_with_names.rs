mechanism! {
    pub Arm {
        body b0 on ground { mass: 1, com: [x: 0, y: -1, z: 0], joint: revolute(axis: z), coordinate: th0 }
        body b1 on ground { solids: [rod(mass: 1, from: [0, 0, 0], to: [0, 1, 0])], joint: revolute(z), coordinate: th1,
            torque: sin(x: th1) }
        body b2 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th2, spring: (k: 3, rest: 0) }
        body b3 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th3, spring: 3 }
    }
}
