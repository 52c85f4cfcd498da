mechanism! {
    pub Ring {
        body a on c { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: x1 }
        body b on a { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: x2 }
        body c on b { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: x3 }
    }
}
