mechanism! {
    pub Stiff {
        gravity: [0, -9.81, 0],
        body bob on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta, torque: -1e290*1e30*theta
        }
    }
}
