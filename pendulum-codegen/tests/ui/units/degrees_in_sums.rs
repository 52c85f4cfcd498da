mechanism! {
    pub Arm {
        params { a: rad = 1, k: N m = 2 }
        let offset = 45,
        body b0 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th0, torque: -k*sin(th0 - 30) }
        body b1 on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th1, torque: k*cos(-(a + th1) - offset)
        }
        body b2 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th2, spring: (k, a - 90) }
        body b3 on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th3, torque: k*sin(th3 - 7 rad - 30 deg)
        }
    }
}
