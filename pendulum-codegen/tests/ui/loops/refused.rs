mechanism! {
    pub Canonical {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: [0.1, 0.1, 0.1] }
        generate: [rhs, canonical],
        body first on ground: bar {
            joint: revolute(z) at [0.8, 0, 0] rpy [0.8928089789005025, 0, 0], coordinate: a near 2
        }
        body second on first: bar { joint: revolute(z) at [0.4, 0, 0] rpy [0.4, 0, 0], coordinate: b depends near 2 }
        body third on second: bar {
            joint: revolute(z) at [0.8, 0, 0] rpy [0.8928089789005025, 0, 0], coordinate: c depends near -2
        }
        close third at [0.4, 0, 0] rpy [0.4, 0, 0] to ground: revolute(z),
    }
}

mechanism! {
    pub Rusty {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: [0.1, 0.1, 0.1] }
        body first on ground: bar {
            joint: revolute(z) at [0.8, 0, 0] rpy [0.8928089789005025, 0, 0],
            coordinate: a near 2, dry_friction: 0.1 N m,
        }
        body second on first: bar { joint: revolute(z) at [0.4, 0, 0] rpy [0.4, 0, 0], coordinate: b depends near 2 }
        body third on second: bar {
            joint: revolute(z) at [0.8, 0, 0] rpy [0.8928089789005025, 0, 0], coordinate: c depends near -2
        }
        close third at [0.4, 0, 0] rpy [0.4, 0, 0] to ground: revolute(z),
    }
}

mechanism! {
    pub Open {
        generate: [rhs, loop_wrenches],
        body rod on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta }
    }
}

mechanism! {
    pub Reactions {
        generate: [rhs, reactions],
        body rod on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta }
    }
}
