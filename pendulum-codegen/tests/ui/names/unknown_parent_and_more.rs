mechanism! {
    pub Arm {
        body a on b { mass: x, joint: revolute(z), coordinate: th1 }
        body b on a { mass: 1, joint: prismatic([0, 0, 0]), coordinate: th2 }
        body c on b { mass: -1, joint: revolut(z), coordinate: th3 }
        body d on nothing {
            mass: 1, com: [0, -1], joint: revolute(z), coordinate: th4, torque: 2*th1 + 2*dot(th4) + th3 + y
        }
        body e { mass: 1, joint: revolute(z), coordinate: th5, friction: -1 }
        body f at a { mass: 1, joint: revolute(z), coordinate: th6, spring: (1) }
        body on a { mass: 1, joint: revolute(z), coordinate: th7 }
        body g on e: shp
    }
}
