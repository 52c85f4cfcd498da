mechanism! {
    pub Arm {
        params { m: kg = 1, m: kg = 2, t: s = 1 }
        body arm on ground { mass: m, com: [0, -1, 0], joint: revolute(z), coordinate: m, mass: 2 }
        body arm on ground { mass: m, com: [0, -1, 0], joint: revolute(z), coordinate: theta }
    }
}
