mechanism! {
    pub Furuta {
        body arm on ground { mass: 1, com: [1, 0, 0], inertia: 0.2, joint: revolute(y), coordinate: turn }
        body rod on arm { mass: 1, com: [0, -1, 0], inertia: 0.1, joint: revolute(x), coordinate: swing }
    }
}
