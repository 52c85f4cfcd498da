mechanism! {
    #[]
    pub Arm {
        body b0 on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th0 }
    }
}

mechanism! {
    pub Leg {
        #[derive(Clone)]
        body b0 on ground { #[+] mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th0 }
    }
}
