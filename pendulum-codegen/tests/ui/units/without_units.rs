mechanism! {
    pub Plain {
        units: none,
        params { m: 1 = 3, g: 1 = 10 }
        gravity: [0, -g, 0],
        body a on ground {
            mass: m, com: [0, -1, 0], joint: revolute(z), coordinate: th, torque: -2 m*sin(q) - 2 g + 90 deg
        }
    }
}
mechanism! {
    pub Named {
        let m = 3,
        let l = 2 m,
        body a on ground { mass: m, com: [0, -l, 0], joint: revolute(z), coordinate: th }
    }
}
