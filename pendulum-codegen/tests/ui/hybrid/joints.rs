mechanism! {
    pub Prescribed {
        body hand on ground { joint: prismatic(x), motion: 0.1*sin(2 rad/s*t), dry_friction: 1 }
        body arm on hand { joint: prismatic(y), motion: 0.1*sin(2 rad/s*t), stop: [-1, 1] }
        body rod on arm { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a }
    }
}

mechanism! {
    pub Fixed {
        body plate on ground { mass: 1, dry_friction: 1, stop: [-1, 1] }
        body rod on plate { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a }
    }
}

mechanism! {
    pub Laws {
        body rod on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a,
            dry_friction: 0.1 + a^2, stop: [-1, dot(a)] restitution(t),
        }
    }
}
