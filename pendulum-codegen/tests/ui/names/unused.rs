mechanism! {
    pub Arm {
        params { m: kg = 1, l: m = 1, g: m/s^2 = 9.81 }
        let heavy = 2 * m,
        shape stick { solids: [rod(m, [0, 0, 0], [0, -l, 0])] }
        body arm on ground { mass: m, com: [0, -l, 0], joint: revolute(z), coordinate: theta }
    }
}
