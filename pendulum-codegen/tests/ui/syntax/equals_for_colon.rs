mechanism! {
    pub Arm {
        gravity = [0, -9.81, 0],
        params: { m: kg: 1, l: m := 1 }
        input push = N,
        let x: 1 = 3,
        body a on ground { mass = m, com: [0, -l, 0], joint revolute(z), coordinate: th, torque: push + x }
    }
}
