mechanism! {
    pub HalfATurn {
        body a on ground { solids: [rod(1, [0, 0, 0], [0.5, 0, 0])], joint: revolute(z), coordinate: th near 0 }
        body u on ground { joint: prismatic(x), coordinate: x depends near 0.1 }
        body v on u { joint: prismatic(y), coordinate: y depends near 0.1 }
        body w on v { solids: [rod(1, [0, 0, 0], [0.5, 0, 0])], joint: revolute(z), coordinate: phi depends near 3.1 }
        close a at [0, 0, 0] to w at [0, 0, 0]: fixed,
    }
}

mechanism! {
    pub UpsideDown {
        body a on ground { mass: 1, com: [0, 0.1, 0], inertia: [0.01, 0.01, 0.01], joint: revolute(x), coordinate: th }
        body u on ground { mass: 1, inertia: [0.01, 0.01, 0.01], joint: revolute(z), coordinate: phi depends near 3 }
        body v on u {
            mass: 1, com: [0, 0.1, 0], inertia: [0.01, 0.01, 0.01], joint: revolute(y), coordinate: psi depends near 0.1
        }
        close a at [0, 0, 0] to v at [0, 0, 0]: revolute(x),
    }
}

mechanism! {
    pub BeyondABall {
        body arm on ground { mass: 1, com: [0.2, 0, 0], inertia: [0.1, 0.1, 0.1], joint: ball, orientation: o }
        body yoke on arm { joint: revolute(z) at [0.5, 0, 0], coordinate: alpha depends near 0.3 }
        body rod on yoke {
            mass: 1, com: [0.2, 0, 0], inertia: [0.1, 0.1, 0.1], joint: revolute(y), coordinate: beta depends near 0.3
        }
        body block on ground { mass: 1, joint: prismatic(x) at [0, 0.9, 0], coordinate: s depends near 0.3 }
        close rod at [0.5, 0, 0] to block at [0, 0, 0]: ball,
    }
}

mechanism! {
    pub NoLoop {
        body stone on ground {
            mass: 1, com: [0, 0, 0.1], inertia: [1, 1, 1], joint: ball, orientation: o near [0, 0, 1]
        }
    }
}

mechanism! {
    pub NoVector {
        body stone on ground {
            mass: 1, com: [0, 0, 0.1], inertia: [1, 1, 1],
            joint: free, orientation: o near [0, 0, 1 m], position: p near 0.2
        }
    }
}

mechanism! {
    pub Skew {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6 }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0] rpy [0.4, 0, 0]: revolute(z),
    }
}
