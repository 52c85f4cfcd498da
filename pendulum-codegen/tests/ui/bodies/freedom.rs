mechanism! {
    pub Names {
        body coordinate on ground { mass: 1, inertia: [1, 1, 1], joint: ball, coordinate: theta }
        body both on ground { mass: 1, inertia: [1, 1, 1], joint: ball, orientation: o1, coordinate: phi }
        body none on ground { mass: 1, inertia: [1, 1, 1], joint: ball }
        body slides on ground { mass: 1, inertia: [1, 1, 1], joint: ball, orientation: o2, position: p2 }
        body without on ground { mass: 1, inertia: [1, 1, 1], joint: free, orientation: o3 }
        body hinge on ground { mass: 1, inertia: [1, 1, 1], joint: revolute(z), orientation: o4 }
        body placed on ground { mass: 1, inertia: [1, 1, 1], joint: revolute(z), coordinate: psi, position: p4 }
        body list on ground { mass: 1, inertia: [1, 1, 1], joint: ball, orientation: [0, 0, 1] }
        body argument on ground { mass: 1, inertia: [1, 1, 1], joint: ball(z), orientation: o5 }
        body word on ground { mass: 1, inertia: [1, 1, 1], joint: spherical, orientation: o6 }
        output turned: atan2(theta.x, theta.w),
        output rate: dot(theta).x + dot(phi),
    }
}

mechanism! {
    pub Forces {
        params { k: N m = 1 }
        body bob on ground {
            mass: 1, com: [0, -1, 0], inertia: [1, 1, 1], joint: ball, orientation: o,
            spring: (k, 0), torque: k, dry_friction: k, static_friction: k, stop: [-1, 1],
        }
        body drone on ground {
            mass: 1, inertia: [1, 1, 1], joint: free, orientation: turn, position: place, friction: k,
        }
        body driven on ground { mass: 1, inertia: [1, 1, 1], joint: ball, motion: sin(2 rad/s*t) }
        body kg on ground { mass: 1, inertia: [1, 1, 1], joint: ball, orientation: p, friction: 2 kg }
        body less on ground { mass: 1, inertia: [1, 1, 1], joint: ball, orientation: s, friction: -1 }
        body law on ground { mass: 1, inertia: [1, 1, 1], joint: ball, orientation: r, friction: r.w }
        body scalar on ground { mass: 1, inertia: 1, joint: ball, orientation: u }
    }
}

mechanism! {
    pub Expressions {
        generate: [rhs, canonical],
        point tip on bob at [0, -1, 0],
        potential: 1 J*o,
        potential: 1 J*o.q + 1 J*dot(o).x,
        potential: 1 J*place.w,
        potential: o.w,
        dissipation: 1 W*dot(o),
        dissipation: 1 J*dot(o).w + 1 J*dot(theta).x + 1 N*dot(tip).x + 1 J*dot(k).x,
        force o: 1,
        body bob on ground { mass: 1, com: [0, -1, 0], inertia: [1, 1, 1], joint: ball, orientation: o }
        body arm on bob { mass: 1, inertia: [1, 1, 1], joint: revolute(z), coordinate: theta absolute }
        body drone on ground { mass: 1, inertia: [1, 1, 1], joint: free, orientation: o, position: place }
        body twice on ground { mass: 1, inertia: [1, 1, 1], joint: free, position: one, orientation: one }
    }
}

mechanism! {
    pub Rod {
        body rod on ground { mass: 1, inertia: [0, 0, 0], joint: ball, orientation: o }
    }
}

mechanism! {
    pub Places {
        body bob on ground { mass: 1, inertia: [1, 1, 1], joint: ball, orientation: cost }
        body drone on ground { mass: 1, inertia: [1, 1, 1], joint: free, orientation: dof2, position: q_ }
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: q__x }
    }
}

mechanism! {
    pub Depending {
        body turned on ground { mass: 1, inertia: [1, 1, 1], joint: ball, orientation: o depends near 0.3 }
        body guessed on ground { mass: 1, inertia: [1, 1, 1], joint: ball, orientation: r near 0.3 }
        body placed on ground { mass: 1, inertia: [1, 1, 1], joint: free, orientation: s, position: p depends }
        body named on ground { mass: 1, inertia: [1, 1, 1], joint: ball, coordinate: phi depends }
        body other on ground { mass: 1, inertia: [1, 1, 1], joint: ball, orientation: u absolute }
        body far on ground { mass: 1, inertia: [1, 1, 1], joint: ball at 0.5, orientation: v }
        body twisted on ground { mass: 1, inertia: [1, 1, 1], joint: ball, orientation: w, torque: [0, 0, 1] }
    }
}

mechanism! {
    pub Forced {
        force o: [1, 0, 0],
        force p: 3,
        force o.x: 3,
        force dot(o).x: 3,
        force on drone at [0, 0, 1]: [1, 0, 0],
        torque on drone: [1, 0, 0],
        moment on drone: [1, 0, 0],
        point tip on o at [0, 0, 1],
        output all: drone,
        body drone on ground { mass: 1, inertia: [1, 1, 1], joint: free, orientation: o, position: p }
    }
}

mechanism! {
    pub OtherJoints {
        body a on ground { mass: 1, inertia: [1, 1, 1], joint: planar(z), coordinate: s1 }
        body b on ground { mass: 1, inertia: [1, 1, 1], joint: cylindrical(z), coordinate: s2 }
        body c on ground { mass: 1, inertia: [1, 1, 1], joint: cardan, coordinate: s3 }
        body d on ground { mass: 1, inertia: [1, 1, 1], joint: gimbal, coordinate: s4 }
        body e on ground { mass: 1, inertia: [1, 1, 1], joint: gear, coordinate: s5 }
        body f on ground { mass: 1, inertia: [1, 1, 1], joint: rope, coordinate: s6 }
        body g on ground { mass: 1, inertia: [1, 1, 1], joint: [revolute(x), revolute(y)], coordinate: s7 }
    }
}

mechanism! {
    pub Empty {
        body hull on ground { joint: free, orientation: o, position: p }
        body arm on hull {
            mass: 0.5, com: [0.2, 0, 0], inertia: [0.01, 0.01, 0.01], joint: revolute(z) at [0.1, 0, 0], coordinate: a
        }
    }
}

mechanism! {
    pub Between {
        body hull on ground { joint: ball, orientation: o }
        body stone on hull {
            mass: 0.5, com: [0.2, 0, 0], inertia: [0.01, 0.01, 0.01], joint: ball at [0.1, 0, 0], orientation: u
        }
    }
}

mechanism! {
    pub Hinged {
        body hull on ground { joint: revolute(x), coordinate: a }
        body stone on hull { mass: 0.5, com: [0.2, 0, 0], inertia: [0.01, 0.01, 0.01], joint: ball, orientation: u }
    }
}
