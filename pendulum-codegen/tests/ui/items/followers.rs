mechanism! {
    pub Following {
        params { k: 1 = 2 }
        body a on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: p }
        body b on a { mass: 1, com: [0, -1, 0], joint: revolute(z), motion: k*p }
        body c on a { mass: 1, com: [0, -1, 0], joint: revolute(z), motion: p^2 }
        body d on a { mass: 1, com: [0, -1, 0], joint: revolute(z), motion: p + 1 rad/s*t }
        body e on a { mass: 1, com: [0, -1, 0], joint: revolute(z), motion: -p, dry_friction: 1 }
        body f on a { mass: 1, com: [0, -1, 0], joint: revolute(z), motion: -p, stop: [-1, 1] }
        body h on a { mass: 1, com: [0, -1, 0], joint: prismatic(z), motion: dot(p) }
        body i on a { mass: 1, com: [0, -1, 0], joint: fixed, motion: p }
        body j on a { mass: 1, com: [0, -1, 0], joint: revolute(z), motion: p, coordinate: x }
    }
}

mechanism! {
    pub Turned {
        body a on ground { mass: 1, com: [0, 0, 0.2], inertia: [0.1, 0.2, 0.25], joint: ball, orientation: o }
        body b on a { mass: 1, com: [0, -1, 0], inertia: [0.1, 0.1, 0.1], joint: revolute(z), motion: 2*o.x }
    }
}
