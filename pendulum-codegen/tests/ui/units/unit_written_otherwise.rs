mechanism! {
    pub Mistyped {
        params { l: m = 1 }
        gravity: [0, -9.81 m/s2, 0],
        body a on ground {
            mass: 5 Kg, com: [0, -1 m, 0], joint: revolute(z), coordinate: a1, torque: 2 N m * s * dot(a1)
        }
        body b on ground { mass: 1 kg, com: [0, -3 M, 0], joint: revolute(z), coordinate: b1, torque: 2 N*m }
        body c on ground { mass: 1 kg, com: [0, -l, 0], joint: revolute(z), coordinate: c1, torque: 3 kg m2/s2 }
        body d on ground { mass: 1 KG, com: [0, -l, 0], joint: revolute(z), coordinate: d1, torque: 5 n m }
        body e on ground { mass: 1 kg, com: [0, -l, 0], joint: revolute(z), coordinate: e1, torque: 5 N m*Sec*dot(e1) }
    }
}
