mechanism! {
    pub Arm {
        params { in: m = 1, pub m: kg = 1, let l: m = 1, self: 1 }
        input type: N,
        let fn = 3,
        body loop on ground { mass: m, com: [0, -l, 0], joint: revolute(z), coordinate: move }
        body a on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: t, torque: self.m }
        shape const { mass: 1 }
    }
}

mechanism! {
    pub New {
        params { gen: kg = 1 }
        body a on ground { mass: gen, com: [0, -1, 0], joint: revolute(z), coordinate: theta }
    }
}
