mechanism! {
    pub Arm {
        body b0 on ground { mass: 1, com: [0, -1, 0], joint: hinge(z), angle: th0, damping: 0.1*th0 }
        body b1 on ground {
            weight: 1, center_of_mass: [0, -1, 0], moi: [1, 1], joint: slider(x), coordinate: s1, force: -s1 - th0 - y,
        }
        body b2 on ground {
            mass: 1, joint: ball, coordinate: s2, limits: [0, 1], length: 1, axis: z, parent: b0,
            position: [0, 0, 0], stiffness: 3, initial: 0,
        }
        body b3 on ground {
            solids: [bar(1, [0, 0, 0], [0, -1, 0]), box(1, [1, 1, 1], [0, 0, 0]), ring(1)],
            joint: Revolute(z) on [0, 0, 0], coordinate: th3,
        }
        body b4 on ground { mass: 1, joint: Revolut(z), coordinate: th4 }
    }
}
