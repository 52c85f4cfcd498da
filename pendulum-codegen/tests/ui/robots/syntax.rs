mechanism! {
    pub Arm {
        robot: "tests/robots/arm.urdf",
        robot: sdf("tests/robots/arm.urdf"),
        robot: urdf,
        robot: urdf(arm),
        robot: urdf("tests/robots/arm.urdf", stops),
        robot: urdf("tests/robots/arm.urdf", limits) { },
        robot: urdf("tests/robots/arm.urdf"),
        robto: urdf("tests/robots/arm.urdf"),
        urdf: "tests/robots/arm.urdf",
    }
}
