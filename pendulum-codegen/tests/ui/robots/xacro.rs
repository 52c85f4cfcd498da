mechanism! {
    pub Arm {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/xacro.urdf"),
    }
}
mechanism! {
    pub Undeclared {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/xacro_undeclared.urdf"),
    }
}
mechanism! {
    pub Expressions {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/xacro_expressions.urdf"),
    }
}
