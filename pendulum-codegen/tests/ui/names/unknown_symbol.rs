mechanism! {
    pub Arm {
        params { tau: N m = 1, omega: rad/s = 2 }
        body arm on ground {
            mass: 1,
            com: [0, -1, 0],
            joint: revolute(z),
            coordinate: theta,
            torque: tau * sin(omga * t) + sine(omega),
        }
    }
}
