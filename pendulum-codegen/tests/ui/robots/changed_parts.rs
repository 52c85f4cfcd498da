mechanism! {
    pub Arm {
        robot: urdf("tests/robots/floating.urdf"),
        body hull on world { coordinate: s, friction: 0.1 }
        body puck on hull { joint: fixed }
    }
}

mechanism! {
    pub Arm {
        robot: urdf("tests/robots/floating.urdf"),
        body hull on world { joint: revolute(z) }
    }
}
