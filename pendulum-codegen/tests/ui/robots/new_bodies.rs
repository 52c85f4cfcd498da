mechanism! {
    pub Arm {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/arm.urdf"),
        body uper_arm on base { mass: 2 }
        body elbow on upper_arm { friction: 0.1 }
        body forearms on upper_arm { mass: 2, joint: fixed }
        body load on forearm { mass: 2 }
    }
}
