mechanism! {
    pub Arm {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/degrees.urdf", limits),
    }
}

mechanism! {
    pub Changed {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/degrees.urdf", limits),
        body a on base {
            inertia: [1, 1, 1.5] rpy [0, -45, 0], joint: revolute(x) rpy [90 rad, 0, 0], stop: [-90 deg, 2 turn]
        }
    }
}
