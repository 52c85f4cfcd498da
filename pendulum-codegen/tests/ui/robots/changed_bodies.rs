mechanism! {
    pub Arm {
        robot: urdf("tests/robots/arm.urdf"),
        body upper_arm on ground { mass: 2 }
        body forearm on upper_arm { mass: -1, inertia: [1, 1, 3] }
        body forearm on upper_arm { mass: 2 }
        body hand on wrist { mass: 1 }
    }
}
