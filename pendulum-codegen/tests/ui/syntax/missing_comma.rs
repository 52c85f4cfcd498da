mechanism! {
    pub Arm {
        params { m: kg = 1 l: m = 1; k: N m/kg = 2, }
        gravity: [0, -9.81, 0]
        let x = 2*m;
        let y = x
        body a on ground { mass: m com: [0, -l, 0]; joint: revolute(z) at [0, 0, 0] coordinate: th torque: k*y }
        body b on a { solids: [point(1, [0 -1, 0]) point(1, [0, 0, 0])], joint: revolute(z), coordinate: u },
    }
}
