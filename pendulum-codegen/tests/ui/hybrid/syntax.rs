mechanism! {
    pub Stops {
        body a on ground { mass: 1, joint: prismatic(x), coordinate: q1, stop: 1 }
        body b on a { mass: 1, joint: prismatic(y), coordinate: q2, stop: [-1, 0, 1] }
        body c on b { mass: 1, joint: prismatic(z), coordinate: q3, stop: [-1, 1] rebound(0.5) }
        body d on c { mass: 1, joint: prismatic([1, 1, 0]), coordinate: q4, stop: [-1, 1] restitution }
        body e on d { mass: 1, joint: prismatic([1, 0, 1]), coordinate: q5, stop: [-1, 1] (0.5) }
    }
}

mechanism! {
    pub Walls {
        point tip on rod at [0, -1, 0],
        wall { gap: tip.x }
        wall open: tip.x,
        wall nothing {}
        wall twice { gap: 2 + tip.x, gap: 3 + tip.x }
        wall rough { gap: 2 + tip.x, friction: 0.3 }
        wall renamed { distance: 2 + tip.x, cor: 0.5, color: 3 }
        floor below { gap: 2 + tip.y }
        body rod on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, stiction: 0.1, limits: [-1, 1], min: 1
        }
    }
}

mechanism! {
    pub Fields {
        stop: [-1, 1],
        body rod on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, torque: -0.1*sign(qd),
            wall side { gap: 2 },
        }
    }
}
