mechanism! {
    params { m: kg = 1 }
    body a on ground { mass: m, joint: revolute(z), coordinate: th }
}

mechanism! {
    pub struct Arm {
        body a on ground { mass: 1, joint: revolute(z), coordinate: th }
    }
}

mechanism! {
    scene Arm {
        body a on ground { mass: 1, joint: revolute(z), coordinate: th }
    }
}

mechanism! {
    pub Arm: {
        body a on ground { mass: 1, joint: revolute(z), coordinate: th }
    }
}

mechanism! {
    pub "Arm" {}
}

mechanism! {
    pub(in) Arm {
        body a on ground { mass: 1, joint: revolute(z), coordinate: th }
    }
}

mechanism! {

}
