// Names that are taken, and routines that scenes of states do not have.
mechanism! {
    pub Taken {
        params { tau: s = 1, x: m = 1 }
        state x { unit: m, rate: -x/tau }
        state theta { unit: rad, rate: -theta/tau }
        body b on ground { mass: x, inertia: 1, joint: revolute(z), coordinate: theta }
    }
}

mechanism! {
    pub Bodiless {
        params { tau: s = 1 }
        state x { unit: m, rate: -x/tau }
        generate: [rhs, energy, mass_matrix, shapes],
    }
}

mechanism! {
    pub Momenta {
        params { tau: s = 1 }
        state x { unit: m, rate: (y - x)/tau }
        body b on ground { mass: 1, joint: prismatic(y), coordinate: y }
        generate: [rhs, canonical],
    }
}

mechanism! {
    pub Empty {
        params { tau: s = 1 }
    }
}

mechanism! {
    pub Unused {
        params { tau: s = 1, left: kg = 2 }
        state x { unit: m, rate: -x/tau }
    }
}

mechanism! {
    pub Constants {
        params { tau: s = 1 }
        state dof { unit: m, rate: -dof/tau }
        state a { unit: m, rate: -a/tau }
        state A { unit: m, rate: -A/tau }
        state dot_y { unit: m, rate: -dot_y/tau }
        body b on ground { mass: 1, joint: prismatic(y), coordinate: y }
    }
}
