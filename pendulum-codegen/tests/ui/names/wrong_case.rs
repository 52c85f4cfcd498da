mechanism! {
    pub Arm {
        params { m: kg = 1, g: m/s^2 = 9.81, L: m = 1 }
        body b0 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th0, torque: M*G }
        body b1 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th1, torque: Th1 }
        body b2 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th2, torque: PI*l }
    }
}
