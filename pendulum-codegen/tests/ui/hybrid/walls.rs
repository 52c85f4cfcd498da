mechanism! {
    pub Constant {
        params { l: m = 1 }
        point tip on rod at [0, -l, 0],
        point peg on ground at [1, 0, 0],
        wall still { gap: l + 1 }
        wall moving { gap: 1 m*sin(1 rad/s*t) }
        wall pegged { gap: peg.x }
        wall turned { gap: distance(tip, hinge) }
        point hinge on rod,
        body rod on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: a }
    }
}

mechanism! {
    pub Rates {
        point tip on rod at [0, -1, 0],
        input push: N m,
        wall fast { gap: dot(tip.x) }
        wall pushed { gap: push/1 N }
        wall sharp { gap: abs(tip.x) }
        body rod on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, torque: push }
    }
}

mechanism! {
    pub Twice {
        point tip on rod at [0, -1, 0],
        wall side { gap: 2 + tip.x }
        wall side { gap: 2 - tip.x }
        wall a { gap: 2 - tip.y }
        body rod on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a }
    }
}
