//! Elements that are not known are left out, unless all must be.
mechanism! {
    pub Arm {
        robot: urdf("tests/robots/sound_together.urdf", strict),
    }
}
