mechanism! {
    pub Arm {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/unknown_attributes.urdf"),
    }
}
