//! Inertias that no body can have; the root does not move, so nobody judges it.
mechanism! {
    pub Arm {
        robot: urdf("tests/robots/unphysical.urdf"),
    }
}

// what cannot be repaired is still an error
mechanism! {
    pub Repaired {
        robot: urdf("tests/robots/unphysical.urdf", repair),
    }
}

// the root moves
mechanism! {
    pub Floating {
        robot: urdf("tests/robots/sound_together.urdf"),
        body base on ground { joint: free, orientation: o, position: p }
    }
}
