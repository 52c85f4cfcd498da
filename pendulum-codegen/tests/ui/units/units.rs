mechanism! {
    pub Swapped {
        params { m: kg = 1, l: m = 2, k: N/m = 3, gamma: N m = 0.1, c: N s/m = 0.1, g: m/s^2 = 9.81, w: rad/s = 1 }
        input push: N,
        gravity: [0, -g*l, 0],
        point tip on arm at [0, -m, 0],
        point nail on ground,
        force on tip: [-0.05*dot(tip.x), 2*push*dot(theta), 3 N*sin(theta)],
        force theta: push,
        spring between tip and nail: (k*l, m),
        damper between tip and nail: k,
        potential: m*g*l + k*tip.x,
        dissipation: c*tip.x^2,
        let both = m + l,
        let bend = sin(l) + cos(theta)*l,
        let way = sqrt(l^2 + theta^2),
        let turned = atan2(tip.x, theta),
        let big = 2^theta + exp(t) + ln(m) + tanh(0.5*t),
        output all: [both, bend, way, turned, big],
        shape plate { mass: l, com: [0, -m, 0], inertia: m*l }
        body cart on ground: plate {
            joint: prismatic(x), coordinate: s, friction: gamma, spring: (gamma, m), torque: gamma
        }
        body arm on cart {
            solids: [rod(l, [0, 0, 0], [0, -m, 0]), sphere(m, m, [0, 0, 0]), plate(m, [[0, 0], [m, 0], [0, l]])],
            joint: revolute([l, m, 0]) at [m, 0, 0] rpy [l, 0, 0], coordinate: theta,
            friction: c, spring: (k, l), torque: push - k*q,
        }
        body nut on arm { mass: m, joint: helical(z, w), coordinate: turn, torque: -c*qd }
        body bolt on nut { mass: m, joint: screw([0, 0, 1, 0, m, l]), coordinate: thread }
        body pin on bolt { mass: m, joint: prismatic([1, l, 0]), motion: w*t }
    }
}
