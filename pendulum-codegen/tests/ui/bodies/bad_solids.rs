mechanism! {
    pub Arm {
        params { m: kg = 1 }
        body a on ground {
            mass: m,
            solids: [rod(m, [0, 0, 0], [0, -1, 0])],
            joint: revolute(z), coordinate: x1,
        }
        body b on ground { solids: [plate(m, [[0, 0], [1, 1], [1, 0], [0, 1]])], joint: revolute(z), coordinate: x2 }
        body c on ground { solids: [ring(m, 1)], joint: revolute(z), coordinate: x3 }
        body d on ground { solids: [disk(m, [0, 0, 0], 1)], joint: revolute(z), coordinate: x4 }
        body e on ground { solids: [point(-m * 0 - 2, [0, 1, 0])], joint: revolute(z), coordinate: x5 }
    }
}
