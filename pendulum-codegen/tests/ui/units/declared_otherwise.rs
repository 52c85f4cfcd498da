mechanism! {
    pub Arm {
        params { gamma: N m/s, l: m = 30 deg, a: rad = 0.3 m, k: N m = 2 }
        body b0 on ground { mass: 3/4 kg, com: [0, -l, 0], joint: revolute(z), coordinate: th0, friction: gamma }
        body b1 on b0 { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: th1, spring: (k*l, a) }
        body b2 on b1 { mass: 1, joint: prismatic(z), motion: th1 * 5 mm/turn }
    }
}
