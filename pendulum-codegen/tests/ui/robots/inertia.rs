mechanism! {
    pub Arm {
        body a on ground { mass: 1, inertia: [1, 1, 1] rpy [90, 0, 0], joint: revolute(z), coordinate: p }
        body b on a { mass: 1, inertia: 1 rpy [1, 0, 0], joint: revolute(z), coordinate: x }
        body c on a { mass: 1, inertia: [1, 1, 1] rpy [p, 0, 0] rpy [1, 0, 0], joint: revolute(z), coordinate: r }
        body d on a { mass: 1, inertia: [1, 1, 3] rpy [0.5, 0, 0] about joint, joint: revolute(z), coordinate: s }
    }
}
