mechanism! {
    pub TooShort {
        params { a: m = 0.2, b: m = 0.1 }
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: q1 near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [a, 0, 0], coordinate: q2 depends near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: q3 depends near 1.6 }
        close coupler at [b, 0, 0] to rocker at [b, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub Stretched {
        params { b: m = 0.4, c: m = 0.3999999999999 }
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 3.141592653589793 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6 }
        close coupler at [b, 0, 0] to rocker at [c, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub ByChance {
        params { height: m = 0.1, lift: m = 0.1 }
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: [0.1, 0.1, 0.1] }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, height], coordinate: psi depends near 1.6 }
        close coupler at [0.5, 0, lift] to rocker at [0.4, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub Undecided {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub OutOfPlane {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: [0.1, 0.1, 0.1] }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0.1], coordinate: psi depends near 1.6 }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub OtherAxis {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: [0.1, 0.1, 0.1] }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6 }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(x),
    }
}

mechanism! {
    pub Spatial {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: [0.1, 0.1, 0.1] }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3 }
        body rocker on ground: bar { joint: revolute(x) at [0.6, 0, 0], coordinate: psi depends near 1.6 }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub Screwed {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6 }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: helical(z, 0.1),
    }
}

mechanism! {
    pub NoTriangle {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta depends near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi near 1.6 }
        body flag on rocker: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: chi depends near 1.6 }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub Wrong {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 m }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near theta }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6 }
        close coupler at [0.5 kg, 0, 0] to rokcer at [0.4, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub Flat {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta depends near 0 }
        body rod on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near 0 }
        body slider on ground: bar { joint: prismatic(x), coordinate: s near 0.7 }
        close rod at [0.5, 0, 0] to slider: revolute(z),
    }
}

mechanism! {
    pub Itself {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta }
        body rod on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near 0 }
        body end on rod: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: psi depends near 0 }
        close end at [0.5, 0, 0] to end: revolute(z),
    }
}

mechanism! {
    pub Weightless {
        body stone on ground { mass: 1, com: [0, 0, 0.1], joint: ball, orientation: o }
    }
}

mechanism! {
    pub FarAway {
        shape bar { solids: [rod(1, [0, 0, 0], [0.5, 0, 0])] }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends }
        body rocker on ground: bar { joint: revolute(z) at [6 km, 0, 0], coordinate: psi depends }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub FarGuess {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near 2.8 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6 }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
    }
}

mechanism! {
    pub Rigidly {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6 }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: fixed,
    }
}
