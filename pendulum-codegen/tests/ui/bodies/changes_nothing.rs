mechanism! {
    pub Arm {
        params { g: m/s^2 = 9.81, k: 1 = 2 }
        input push: N m,
        gravity: [0, 0, -g],
        body a on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th, torque: (k - k)*push }
    }
}
