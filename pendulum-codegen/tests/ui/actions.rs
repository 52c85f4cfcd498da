mechanism! {
    pub Arm {
        params { k: N/m = 1 }
        input push: N,
        point tip on arm at [0, -1, 0],
        point end on arm at [0, -2, 0],
        point nail on ground at [1, 0, 0],
        point hook on ground at [2, 0, 0],
        point axle on cart,
        force thet: 1,
        force tip: 1,
        force cart: 1,
        force on nail: [1, 0, 0],
        force on tpi: [1, 0, 0],
        force on tip: [1, 0],
        force on tip: [1, 0, 0] in leg,
        force on tip [1, 0, 0],
        spring between tip and end: (k, 1),
        spring between nail and hook: (k, 1),
        spring between tip and tip: (k, 1),
        spring between tip and nail: k,
        spring between tip and nail: (-1, 1),
        spring tip and nail: (k, 1),
        spring: (k, 1),
        damper between tip and nail: -1,
        damper between tip and nail: dot(theta),
        potential: tip.x^2 * dot(theta),
        potential: push * tip.x,
        potential: k * abs(tip.x),
        dissipation: theta^2,
        dissipation: abs(dot(theta)),
        body cart on ground { joint: prismatic(x), motion: sin(t) }
        body arm on cart { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta }
    }
}
