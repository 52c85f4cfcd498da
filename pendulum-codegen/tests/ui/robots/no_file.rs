mechanism! {
    pub Arm {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/amr.urdf"),
    }
}

mechanism! {
    pub Empty {
        gravity: [0, 0, -9.81],
        robot: urdf(""),
    }
}

mechanism! {
    pub Folder {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots"),
    }
}

mechanism! {
    pub Beyond {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/arm.urdf/arm.urdf"),
    }
}
