//! Scenes with sequences of impacts: blocks in a row between walls, and two rods in a box.

pendulum_core::mechanism! {
    /// Three blocks in a row between two walls, with a spring to the first.
    pub Row {
        params {
            m1: kg, m2: kg, m3: kg, f1: N, f2: N, f3: N, e0: 1, e1: 1, e2: 1, e3: 1,
            k: N/m, rest: m, d: m, l: m,
        }
        generate: [rhs, jacobian, energy, taylor, canonical],
        wall w0 { gap: x1, restitution: e0 }
        wall w1 { gap: x2 - x1 - d, restitution: e1 }
        wall w2 { gap: x3 - x2 - d, restitution: e2 }
        wall w3 { gap: l - x3, restitution: e3 }
        body a on ground { mass: m1, joint: prismatic(x), coordinate: x1, dry_friction: f1, spring: (k, rest) }
        body b on ground {
            mass: m2, joint: prismatic(x), coordinate: x2, dry_friction: f2, static_friction: 1.5*f2,
        }
        body c on ground { mass: m3, joint: prismatic(x), coordinate: x3, dry_friction: f3 }
    }
}

pendulum_core::mechanism! {
    /// Two rods; the tip of the lower one is in a box without a lid.
    pub Boxed {
        params { m: kg, l1: m, l2: m, g: m/s^2, mu: N m, room: m, deep: m, e: 1, ef: 1, es: 1 }
        generate: [rhs, jacobian, energy, taylor, canonical],
        gravity: [0, -g, 0],
        point tip on lower at [0, -l2, 0],
        wall left { gap: tip.x + room, restitution: e }
        wall right { gap: room - tip.x, restitution: e }
        wall floor { gap: tip.y + deep, restitution: ef }
        body upper on ground {
            solids: [rod(m, [0, 0, 0], [0, -l1, 0])], joint: revolute(z), coordinate: a, dry_friction: mu,
            stop: [-2, 2] restitution(es),
        }
        body lower on upper {
            solids: [rod(1.1979814889429492*m, [0, 0, 0], [0, -l2, 0])], joint: revolute(z) at [0, -l1, 0],
            coordinate: b,
        }
    }
}
