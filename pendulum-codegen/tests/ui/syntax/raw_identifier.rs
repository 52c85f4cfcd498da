mechanism! {
    pub Arm {
        params { m: kg = 1, r#m: kg = 2, r#t: s = 1, r#in: m = 1 }
        body r#a on ground { mass: m, com: [0, -r#in, 0], joint: revolute(z), coordinate: th, torque: 2*r#th }
        body a on ground { mass: r#m, com: [0, -1, 0], joint: r#revolute(z), coordinate: r#th }
    }
}
