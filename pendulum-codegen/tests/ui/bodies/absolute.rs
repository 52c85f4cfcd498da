mechanism! {
    pub Furuta {
        body arm on ground { mass: 1, com: [1, 0, 0], inertia: [1, 1, 1], joint: revolute(y), coordinate: turn }
        body rod on arm { mass: 1, com: [0, -1, 0], inertia: 0.1, joint: revolute(x), coordinate: swing absolute }
        body bead on arm { mass: 1, joint: prismatic(y), coordinate: slide absolute }
    }
}
