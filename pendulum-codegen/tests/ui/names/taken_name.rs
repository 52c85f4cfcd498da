mechanism! {
    pub f64 {
        body a on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: x1 }
    }
}

mechanism! {
    pub Energy {
        body a on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: x1 }
    }
}

mechanism! {
    pub __Code {
        body a on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: x1 }
    }
}
