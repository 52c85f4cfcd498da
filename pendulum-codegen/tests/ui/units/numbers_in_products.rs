mechanism! {
    pub Coefficients {
        params { k: N m = 1, c: N m s = 2, l: m = 1 }
        body a on ground { mass: 1/2 kg, com: [0, -1/2 m, 0], joint: revolute(z), coordinate: a1, torque: 3 mNm }
        body b on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: b1, torque: -k*tanh(qd/0.01) }
        body c on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: c1, torque: 1/2*0.3*dot(c1)^2 }
        body d on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: d1, torque: k*q + 0.02*qd }
        body e on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: e1, torque: -(3 N)*sin(q) }
        body f on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: f1, torque: -q }
        body g on ground {
            mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: g1, torque: -k*q - 0.3*l/l*sin(q) + 0.3*c
        }
    }
}
