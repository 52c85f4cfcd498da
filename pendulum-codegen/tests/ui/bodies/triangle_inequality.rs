mechanism! {
    pub Arm {
        body arm on ground {
            mass: 1,
            com: [0, -1, 0],
            inertia: [1, 1, 5],
            joint: revolute(z),
            coordinate: theta,
        }
    }
}
