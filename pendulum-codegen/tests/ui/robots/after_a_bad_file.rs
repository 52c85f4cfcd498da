mechanism! {
    pub Arm {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/no_rigid_body.urdf"),
        body load on hand { mass: 1, joint: revolute(x), coordinate: swing }
        point tip on load,
        output tip: tip,
        force swing: 1,
    }
}

mechanism! {
    pub Unread {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/unknown_link.urdf"),
        body load on hand { mass: 1, joint: revolute(x), coordinate: swing }
        output turned: rotation(hand),
        force wrist: 1,
    }
}
