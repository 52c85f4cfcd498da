mechanism! {
    pub Arm {
        input push: N,
        point tip on arm at [0, -1, 0],
        output rhs: theta,
        output height: tip.y,
        output height: tip.x,
        output height_rate: tip.x,
        output power: push * dot(theta),
        output turned: rotation(ground),
        output twisted: rotation(theta),
        output skewed: rotation(arm) * 2,
        output nothing: [],
        output many,
        output THETA: theta,
        output DOF: theta,
        event EVENTS: theta,
        event lands: push,
        event height: tip.y,
        body arm on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta }
    }
}
