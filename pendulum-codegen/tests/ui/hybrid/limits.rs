mechanism! {
    pub Nine {
        point tip on last at [0, -1, 0],
        wall floor { gap: 9 + tip.y }
        wall lid { gap: 9 - tip.y }
        shape rod { mass: 1, com: [0, -1, 0], inertia: 0.1 }
        body first on ground: rod { joint: revolute(z), coordinate: a, dry_friction: 1, stop: [-1, 1] }
        body second on first: rod { joint: revolute(z) at [0, -1, 0], coordinate: b, dry_friction: 1, stop: [-1, 1] }
        body third on second: rod { joint: revolute(z) at [0, -1, 0], coordinate: c, dry_friction: 1, stop: [-1, 1] }
        body last on third: rod { joint: revolute(z) at [0, -1, 0], coordinate: d, dry_friction: 1 }
        wall left { gap: 9 + tip.x }
        wall right { gap: 9 - tip.x }
        wall far { gap: 20 - tip.x + tip.y }
    }
}

mechanism! {
    pub Words {
        params { mu: N m = 1 }
        input push: N m,
        generate: [rhs, taylor, canonical, parameter_jacobian],
        body rod on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, dry_friction: mu, torque: push,
        }
    }
}

mechanism! {
    pub Names {
        point tip on rod at [0, -1, 0],
        output response: tip.x,
        wall side { gap: 2 + tip.x }
        body rod on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a }
    }
}
