mechanism! {
    pub Extreme {
        params { k: m = 1e300*1e300, n: kg = 1e-300 mg^4, l: m = 1, p: s = 1 s s s s s s s s s }
        let a = 1/l^64,
        let b = a^64,
        let c = b^64,
        let d = c^64,
        let e = d^64,
        let f = e^2,
        body a0 on ground { mass: f + n, com: [0, k, p], joint: revolute(z), coordinate: th, torque: 1e200*1e200*q }
    }
}
