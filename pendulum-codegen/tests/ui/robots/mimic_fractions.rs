mechanism! {
    pub Hand {
        robot: urdf("tests/robots/mimic_fractions.urdf"),
    }
}
