mechanism! {
    pub Arm {
        // the products of inertia are too large for the moments: the determinant of the second moments is negative
        body a on ground { mass: 1, inertia: [1, 1, 1, 0.3, 0.3, 0.3], joint: revolute(z), coordinate: x1 }
        // one product is
        body b on ground { mass: 1, inertia: [1, 1, 1.5, 0, 0.9, 0], joint: revolute(z), coordinate: x2 }
        // less than the mass at the centre of mass has about the joint
        body c on ground { mass: 1, com: [0, -1, 0], inertia: 0.9 about joint, joint: revolute(z), coordinate: x3 }
        body d on ground {
            mass: 1, com: [0, -1, 0], inertia: [1, 0.1, 0.9] about joint, joint: revolute(z), coordinate: x4
        }
        body e on ground { solids: [], joint: revolute(z), coordinate: x5 }
        body f on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: x6, torque: ln(-1) * qd }
    }
}
