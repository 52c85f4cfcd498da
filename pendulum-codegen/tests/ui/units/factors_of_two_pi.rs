mechanism! {
    pub Screw {
        params { w: rad/s = 30 Hz, f: Hz = 30 rpm, lead: m/rad = 5 mm/turn }
        let turns = w + f,
        body a on ground {
            mass: 1, inertia: [1, 1, 1], joint: helical(z, 5 mm), coordinate: a1, torque: 1*sin(turns*t)
        }
        body b on a { mass: 1, inertia: [1, 1, 1], joint: helical(z, 5 mm/turn), coordinate: b1 }
        body c on b { mass: 1, inertia: [1, 1, 1], joint: helical(x, lead), coordinate: c1 }
    }
}
