mechanism! {
    pub Plain {
        units: SI,
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: x }
    }
}
mechanism! {
    pub Plain {
        units: none,
        units: none,
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: x, torque: x + t + y }
    }
}
