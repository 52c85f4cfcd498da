mechanism! {
    pub Arm {
        let a = b + 90 deg,
        let b = 2*c,
        let c = a,
        body a on ground { mass: a, com: [0, -b, 0], joint: revolute(z), coordinate: th, torque: c }
    }
}
