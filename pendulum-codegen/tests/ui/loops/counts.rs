mechanism! {
    pub TooMany {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta depends }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6 }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub TooFew {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi near 1.6 }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub NoLoop {
        body rod on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta depends near 1 }
    }
}

mechanism! {
    pub Rigid {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body left on ground: bar { joint: revolute(z), coordinate: a depends near 0.8 }
        body right on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: b depends near 2 }
        close left at [0.5, 0, 0] to right at [0.5, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub Held {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8, dry_friction: 0.1 N m }
        body coupler on crank: bar {
            joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3, dry_friction: 0.1 N m
        }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6, stop: [1, 2] }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub None {
        shape bar { solids: [rod(1, [0, 0, 0], [0.5, 0, 0])] }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub Balls {
        body stone on ground { mass: 1, inertia: [1, 1, 1], joint: ball, orientation: o }
        close stone at [0.5, 0, 0] to ground at [0.5, 0, 0]: ball,
    }
}

mechanism! {
    pub BallInLoop {
        shape bar { solids: [cuboid(1, [0.5, 0.1, 0.1], [0.2, 0, 0])] }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.3 }
        body link on crank: bar { joint: ball at [0.2, 0, 0], orientation: o }
        body rocker on ground: bar { joint: revolute(x) at [0.6, 0, 0], coordinate: psi depends near 0.3 }
        close link at [0.7, 0, 0] to rocker at [0, 0.5, 0]: ball,
    }
}

mechanism! {
    pub Twice {
        shape bar { solids: [rod(1, [0, 0, 0], [0.5, 0, 0])] }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6 }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
        close rocker at [0.4, 0, 0] to coupler at [0.5, 0, 0]: revolute(z),
    }
}
