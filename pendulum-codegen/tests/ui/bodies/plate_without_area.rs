mechanism! {
    pub Arm {
        params { a: m = 1, b: m = 2 }
        body p on ground {
            solids: [plate(1, [[-a, -b], [a, b], [a, -b], [-a, b]])],
            joint: revolute(z), coordinate: th1,
        }
        body o on p { solids: [plate(1, [[0, 0], [a, b], [2*a, 2*b]])], joint: revolute(z), coordinate: th2 }
    }
}

mechanism! {
    pub Arm {
        params { a: m = 1, b: m = 0.5 }
        body p on ground {
            solids: [plate(1, [[-a, -a], [a, b], [a, -b], [-a, a/4]])],
            joint: revolute(z), coordinate: th,
        }
    }
}
