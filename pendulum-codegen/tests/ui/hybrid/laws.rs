mechanism! {
    pub Negative {
        body b on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, dry_friction: -0.1 }
    }
}

mechanism! {
    pub BelowKinetic {
        body b on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, dry_friction: 0.3, static_friction: 0.2,
        }
    }
}

mechanism! {
    pub StaticAlone {
        body b on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, static_friction: 0.2 }
    }
}

mechanism! {
    pub Turned {
        body b on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, stop: [1, -1] }
        body c on b { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: d, stop: [1, 1] }
    }
}

mechanism! {
    pub Rebounds {
        point tip on b at [0, -1, 0],
        wall side { gap: tip.x + 2, restitution: 1.2, slow: -1 }
        body b on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, stop: [-1, 1] restitution(-0.1)
        }
        body c on b { mass: 1, joint: prismatic(x), coordinate: s, stop: [-1, 1] restitution(0.1, -2) }
    }
}

mechanism! {
    pub Defaults {
        params { mu: N m = -1, at_rest: N m = 0.1, e: 1 = 2, low: rad = 1 }
        body b on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a,
            dry_friction: mu, stop: [low, 0.5] restitution(e),
        }
        body c on b {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: d, dry_friction: 0.2, static_friction: at_rest,
        }
    }
}

mechanism! {
    pub OneSided {
        body rod on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, stop: [0, inf] }
    }
}
