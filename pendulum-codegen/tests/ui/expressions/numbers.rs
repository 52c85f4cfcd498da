mechanism! {
    pub Arm {
        params { m: kg = 1f64, l: m = 1/0, k: 2 = 3, n = 3 }
        body a on ground { mass: 2 l, com: [0, -sqrt(-2), 0] joint: revolute(z), coordinate: x1 }
        body b on ground { mass: 1, com: [0, -1/(1 - 1), 0], joint: revolute(z), coordinate: x2 }
        body c on ground { mass: 1, com: [0, 2^l, 0], joint: revolute(z), coordinate: x3 }
        body d on ground { mass: "heavy", com: [0, 1, 0], joint: revolute(z), coordinate: x4 }
    }
}
