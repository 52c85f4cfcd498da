mechanism! {
    pub Arm {
        params { m: kg = 1, l: m = 2*m, d: m = x }
        body a on ground { mass: m, com: [d, -l, 0], joint: revolute(z), coordinate: th }
    }
}
