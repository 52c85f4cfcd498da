mechanism! {
    pub Arm {
        params { m: kg = -1, l: m = 1, gamma: N m s = -0.1, ixx: kg m^2 = 1, iyy: kg m^2 = 1, izz: kg m^2 = 3 }
        body a on ground {
            mass: m, com: [0, -l, 0], inertia: [ixx, iyy, izz], joint: revolute(z), coordinate: th, friction: gamma,
        }
    }
}
