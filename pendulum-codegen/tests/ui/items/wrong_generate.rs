mechanism! {
    pub Arm {
        generate: [rhs, jacobain, rhs, mass, "energy"],
        body a on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th }
    }
}

mechanism! {
    pub Arm {
        generate: [rhs, jacobain, rhs, mass, hamiltonian],
        body a on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th }
    }
}
