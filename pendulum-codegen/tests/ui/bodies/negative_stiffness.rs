mechanism! {
    pub Arm {
        body b0 on ground { mass: 1, joint: prismatic(x), coordinate: s0, spring: (-3, 0) }
        body b1 on ground { mass: 1, joint: prismatic(x), coordinate: s1, spring: (2 - 3*1, 0) }
        body b2 on ground { mass: 1, joint: prismatic(x), coordinate: s2, friction: -0.1 }
    }
}
mechanism! {
    pub Pushed {
        params { k: N/m = -3 }
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: x, spring: (2*k, 0) }
    }
}
