// Eq. 20 and Eq. 25 of the paper as they are printed, as torques.
mechanism! {
    /// The rates of the velocity terms are not squared.
    pub Eq20 {
        params { m: kg = 1, inertia: kg m^2 = 1, d: m = 1, g: m/s^2 = 9.8, gamma1: N m s = 0.1, gamma2: N m s = 0.1 }
        body upper on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta1,
            torque: -m*d^2*sin(theta1 - theta2)*dot(theta2) - 2*m*g*d*sin(theta1) - gamma1*dot(theta1)
        }
        body lower on upper {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta2,
            torque: m*d^2*sin(theta1 - theta2)*dot(theta1)^2 - m*g*d*sin(theta2) - gamma2*inertia/(m*d^2)*dot(theta2)
        }
    }
}
mechanism! {
    /// A friction stands in the denominator in place of an inertia.
    pub Eq25 {
        params { m: kg = 1, inertia: kg m^2 = 1, d: m = 1, g: m/s^2 = 9.8, gamma1: N m s = 0.1 }
        let denominator = d^4*m^2 - gamma1*(d^2*m + inertia) + 3*d^2*m*inertia + inertia^2,
        body upper on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta1,
            torque: -m*g*d*(m*d^2 + inertia)^2/denominator*theta1
        }
    }
}
