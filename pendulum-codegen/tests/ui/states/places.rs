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

mechanism! {
    pub Bodiless {
        params { k: J = 1, tau: s = 1 }
        gravity: [0, 0, -9.81],
        state x { unit: 1, rate: -x/tau, init: 3 }
        potential: k*x^2,
    }
}
