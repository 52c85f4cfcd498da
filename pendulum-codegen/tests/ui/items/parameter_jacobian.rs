mechanism! {
    pub Arm {
        generate: [rhs, parameter_jacobian],
        body a on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: x1 }
    }
}
