mechanism! {
    pub Turning {
        params { mu: N, at_rest: N m s, low: m, slow: m/s, e: m }
        body b on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a,
            dry_friction: mu, static_friction: at_rest, stop: [low, 1 m] restitution(e, slow),
        }
    }
}

mechanism! {
    pub Sliding {
        params { mu: N m, slow: rad/s }
        body b on ground {
            mass: 1, joint: prismatic(x), coordinate: s,
            dry_friction: mu, stop: [-1, 1] restitution(0.5, slow),
        }
    }
}

mechanism! {
    pub Walls {
        params { slow: rad/s = 1 }
        point tip on b at [0, -1, 0],
        wall area { gap: tip.x^2 }
        wall force { gap: 3 N }
        wall side { gap: tip.x + 2, slow: slow }
        wall corner { gap: 1 - a, slow: 1 m/s }
        body b on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a }
    }
}
