mechanism! {
    pub Driven {
        params { w: rad/s = 1, l: m = 1 }
        input push: N,
        let shaken = l*(sin(w*t) + theta),
        body a on ground { joint: prismatic(x), motion: l*sin(theta) }
        body b on a { joint: prismatic(x), motion: l*dot(theta) * t }
        body c on b { joint: prismatic(x), motion: push }
        body d on c { joint: prismatic(x), motion: shaken }
        body e on d { joint: prismatic(x), motion: l*sin(w*t) + 0.1*l*abs(cos(w*t)) }
        body f on e { joint: prismatic(x), motion: l*sin(w*t), coordinate: x }
        body g on f { joint: prismatic(x), motion: l*sin(w*t), friction: 1 }
        body i on g { joint: prismatic(x), motion: abs(w*t)*w*t*l }
        body h on g { joint: fixed, motion: sin(w*t) }
        body arm on h { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta }
    }
}
mechanism! {
    pub Stateless {
        body arm on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), motion: 1 rad/s*t }
    }
}
mechanism! {
    pub Held {
        params { theta: rad = 0.3 }
        body arm on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), motion: theta }
    }
}
mechanism! {
    pub Still {
        generate: [rhs, drive_forces],
        body arm on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta }
    }
}
