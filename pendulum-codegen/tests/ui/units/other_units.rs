mechanism! {
    pub Arm {
        params {
            a: deg = 90, b: cm, c: g, d: Nms, e: kgm2, f: Kg, g: f64 = 1, h: rpm, i: meter, j: M, k: furlong,
                l: ms, n: Ohm,
            m: 1.0, o: 2, p: "kg", q1: N/(m s), r: kg^2.5, s, u: kg*m**2, v kg = 3,
        }
        body bob on ground {
            mass: a + b + c + d + e + f + g + h + i + j + k + l + n + m + o + p + q1 + r + s + u + v,
            com: [0, -1, 0], joint: revolute(z), coordinate: th,
        }
    }
}
