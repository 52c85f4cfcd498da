// Places that do not take states.
mechanism! {
    pub Places {
        params { tau: s = 1 }
        gravity: [0, -9.81, 0],
        state s { unit: m, rate: -s/tau }
        body a on ground { mass: 1, joint: prismatic(x), motion: s }
        body b on a { mass: s, joint: prismatic(y), coordinate: y, friction: s }
        wall w { gap: y - s }
    }
}
