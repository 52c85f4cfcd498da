mechanism! {
    pub Arm {
        parameters { m: kg = 1 }
        inputs push: N,
        link a on ground { mass: m, com: [0, -1, 0], joint: revolute(z), coordinate: th, torque: push + y }
        define x = 3,
        x = 3,
        initial: [0, 0],
        output h: th,
        event touch: th,
        friction: 0.1,
        generate: [dynamics, kinetic],
    }
}
