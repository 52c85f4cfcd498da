mechanism! {
    pub Driven {
        params { w: rad/s = 1 }
        input push: N,
        let shaken = sin(w*t) + theta,
        body a on ground { joint: prismatic(x), motion: sin(theta) }
        body b on a { joint: prismatic(x), motion: dot(theta) * t }
        body c on b { joint: prismatic(x), motion: push }
        body d on c { joint: prismatic(x), motion: shaken }
        body e on d { joint: prismatic(x), motion: sin(w*t) + 0.1*abs(cos(w*t)) }
        body f on e { joint: prismatic(x), motion: sin(w*t), coordinate: x }
        body g on f { joint: prismatic(x), motion: sin(w*t), friction: 1 }
        body i on g { joint: prismatic(x), motion: abs(t)*t }
        body h on g { joint: fixed, motion: sin(w*t) }
        body arm on h { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta }
    }
}
mechanism! {
    pub Stateless {
        body arm on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), motion: t }
    }
}
mechanism! {
    pub Still {
        generate: [rhs, drive_forces],
        body arm on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta }
    }
}
