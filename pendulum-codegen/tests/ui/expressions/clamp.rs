mechanism! {
    pub Arm {
        params { l: m = 1, k: N m = 2, most: N m = -1 }
        let reversed = clamp(t, 2 s, 1 s),
        body a on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: th0, torque: clamp(k*th0) }
        body b on ground {
            mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: th1, torque: clamp(k*th1, -1 N, 1 N m)
        }
        body c on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: th2, torque: clamp(k*th2, -l, l) }
        body d on ground {
            mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: th3, torque: clamp(k*th3, -most, most)
        }
        body e on ground {
            mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: th4, torque: saturate(k*th4, -1, 1)
        }
        body f on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: th5, torque: k*reversed/(1 s) }
        potential: k*clamp(th0, -1, 1),
        output saturation_1: th0,
    }
}
