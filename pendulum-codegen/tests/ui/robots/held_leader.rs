mechanism! {
    pub Gripper {
        robot: urdf("tests/robots/gripper.urdf"),
        body left on base { joint: fixed }
    }
}
