mechanism! {
    pub Driven {
        body a on ground { mass: 1, joint: prismatic(x), motion: 0.1 m*sin(2*t) }
        body b on a { mass: 1, joint: prismatic(x), coordinate: s, torque: 1 N*cos(2*pi*t) }
        body c on b { mass: 1, joint: prismatic(x), coordinate: u, torque: 1 N*exp(-t/2)*tanh(3*s) }
        body d on c { mass: 1, com: [1, 0, 0], joint: revolute(z), motion: 2*t }
        body e on d { mass: 1, com: [1, 0, 0], joint: revolute(z), coordinate: v, torque: 2*u*v*1 N*sin(2*3*t) }
    }
}
