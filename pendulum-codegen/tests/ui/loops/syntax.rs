mechanism! {
    pub Words {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi dependent near 0.3 }
        close coupler at [0.5, 0, 0]: revolute(z),
        close coupler at [0.5, 0, 0] and rocker at [0.4, 0, 0]: revolute(z),
        close coupler to rocker revolute(z),
        close coupler to rocker: revolve(z),
        loop coupler to rocker: revolute(z),
    }
}

mechanism! {
    pub Margins {
        params { l: m = 0.2 }
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [l, 0, 0], coordinate: phi depends near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6 }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
        event toggle: margin(coupler) - 0.1,
        event other: margin(crank, rocker) - 0.1,
        event fast: dot(margin(rocker, coupler)) - 0.1,
        output fine: margin(rocker, coupler),
    }
}

mechanism! {
    pub NoLoops {
        body rod on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta near 1 }
        output m: margin(rod, ground),
    }
}

mechanism! {
    pub Closing {
        shape bar { solids: [rod(1, [0, 0, 0], [0.5, 0, 0])] }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6 }
        point tip on coupler at [0.5, 0, 0],
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: hinge(z),
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: floating,
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: distance(0.1),
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0] rpy 90 deg: revolute(z),
        close tip to rocker at [0.4, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub Places {
        shape bar { solids: [rod(1, [0, 0, 0], [0.5, 0, 0])] }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6 }
        close coupler [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
        close coupler at [0.5, 0, 0] to rocker [0.4, 0, 0]: revolute(z),
        close coupler to rocker: revolute(z) at [0.4, 0, 0],
        close coupler to rocker,
        output m: margin(coupler, rocker),
    }
}
