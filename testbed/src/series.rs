//! Scenes with generated power series.

use pendulum_core::mechanism;

mechanism! {
    /// Eq. 22 of Williams (2023): two plates on joints with friction.
    pub Pendulums {
        units: none,
        params {
            m: kg = 1, inertia: kg m^2 = 1, c: m = 1, d: m = 1, g: m/s^2 = 9.8,
            gamma1: N m s = 0.1, gamma2: N m s = 0.1,
        }
        gravity: [0, -g, 0],
        generate: [taylor],
        shape plate { mass: m, com: [0, -c, 0], inertia: inertia }
        body upper on ground: plate { joint: revolute(z), coordinate: theta1, friction: gamma1 }
        body lower on upper: plate { joint: revolute(z) at [0, -d, 0], coordinate: theta2 absolute, friction: gamma2 }
    }
}

mechanism! {
    /// Three revolute joints along different axes.
    pub Elbow {
        units: none,
        gravity: [0, 0, -9.81],
        generate: [rhs, taylor],
        body shoulder on ground {
            mass: 3, com: [0.1, 0.02, 0.2], inertia: [0.2, 0.25, 0.15, 0.01, -0.02, 0.03],
            joint: revolute(z), coordinate: q1, friction: 0.1,
        }
        body upper on shoulder {
            mass: 2, com: [0.3, 0.05, 0.01], inertia: [0.05, 0.15, 0.16, 0.02, 0.01, -0.01],
            joint: revolute(y) at [0, 0.1, 0.4], coordinate: q2, friction: 0.2,
        }
        body fore on upper {
            mass: 1, com: [0.2, -0.03, 0.04], inertia: [0.05, 0.06, 0.07, 0.01, 0.005, -0.01],
            joint: revolute([1, 2, 3]) at [0.6, 0, 0], coordinate: q3, friction: 0.05,
        }
    }
}

mechanism! {
    /// A cart, a nut on a thread and a slider on the nut.
    pub Slides {
        units: none,
        params { k: N/m = 20, pitch: m = 0.1 }
        gravity: [0, -9.81, 0],
        generate: [taylor, jacobian],
        body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, spring: (k, 0.2) }
        body nut on cart {
            mass: 1, com: [0.1, -0.3, 0.2], inertia: [0.1, 0.12, 0.08, 0.01, 0.02, 0.005],
            joint: helical(z, pitch), coordinate: theta,
        }
        body slider on nut {
            mass: 0.5, com: [0.02, 0.1, 0], inertia: [0.02, 0.03, 0.01],
            joint: prismatic(y), coordinate: u, spring: (30, -0.1),
        }
    }
}

mechanism! {
    /// A single slider, whose series has no products at all.
    pub Spring {
        generate: [taylor],
        body slider on ground { mass: 2, joint: prismatic(x), coordinate: s, spring: (8, 0.5), friction: 0.3 }
    }
}

mechanism! {
    /// Torque with the tangent.
    pub Tangent {
        units: none,
        gravity: [0, -9.81, 0],
        generate: [taylor],
        body bob on ground {
            mass: 1.3, com: [0.1, -0.8, 0], inertia: 0.2,
            joint: revolute(z), coordinate: theta,
            torque: tan(theta / 3),
        }
    }
}

mechanism! {
    /// Torque with the exponential of a rate and of a product.
    pub Exponential {
        units: none,
        gravity: [0, -9.81, 0],
        generate: [taylor],
        body bob on ground {
            mass: 1.3, com: [0.1, -0.8, 0], inertia: 0.2,
            joint: revolute(z), coordinate: theta,
            torque: exp(-dot(theta) / 4) - exp(theta * dot(theta) / 5),
        }
    }
}

mechanism! {
    /// Torque with the logarithm.
    pub Logarithm {
        units: none,
        gravity: [0, -9.81, 0],
        generate: [taylor],
        body bob on ground {
            mass: 1.3, com: [0.1, -0.8, 0], inertia: 0.2,
            joint: revolute(z), coordinate: theta,
            torque: ln(3 + sin(theta) * dot(theta)),
        }
    }
}

mechanism! {
    /// Torque with the square root.
    pub Root {
        units: none,
        gravity: [0, -9.81, 0],
        generate: [taylor],
        body bob on ground {
            mass: 1.3, com: [0.1, -0.8, 0], inertia: 0.2,
            joint: revolute(z), coordinate: theta,
            torque: (2 + cos(theta)^2 + dot(theta)^2)^(1/2),
        }
    }
}

mechanism! {
    /// Torque with integer and fractional, positive and negative powers.
    pub Powers {
        units: none,
        gravity: [0, -9.81, 0],
        generate: [taylor],
        body bob on ground {
            mass: 1.3, com: [0.1, -0.8, 0], inertia: 0.2,
            joint: revolute(z), coordinate: theta,
            torque: (2 + cos(theta))^(-3/2) + dot(theta)^3 / 9 - (3 + theta)^(-2)
                + (2 + sin(theta))^(5/3) + (1 + theta^2)^(-1),
        }
    }
}

mechanism! {
    /// Torque with quotients whose numerator and denominator vary.
    pub Quotient {
        units: none,
        gravity: [0, -9.81, 0],
        generate: [taylor],
        body bob on ground {
            mass: 1.3, com: [0.1, -0.8, 0], inertia: 0.2,
            joint: revolute(z), coordinate: theta,
            torque: dot(theta) / (2 + sin(theta)) - 3 / (1 + theta^2) + 2 * theta / (5 + t),
        }
    }
}

mechanism! {
    /// Smoothed dry friction.
    pub Saturated {
        units: none,
        gravity: [0, -9.81, 0],
        generate: [taylor],
        body bob on ground {
            mass: 1.3, com: [0.1, -0.8, 0], inertia: 0.2,
            joint: revolute(z), coordinate: theta,
            torque: -2 * tanh(dot(theta) / 2),
        }
    }
}

mechanism! {
    /// Torques clamped between limits, one of which varies.
    pub Clamped {
        units: none,
        gravity: [0, -9.81, 0],
        generate: [taylor],
        body bob on ground {
            mass: 1.3, com: [0.1, -0.8, 0], inertia: 0.2,
            joint: revolute(z), coordinate: theta,
            torque: clamp(-3*theta - dot(theta)^2, -1, 1.5) + clamp(2*sin(theta), -cos(t), 0.7),
        }
    }
}

mechanism! {
    /// The angle of a moving point.
    pub Angle {
        units: none,
        gravity: [0, -9.81, 0],
        generate: [taylor],
        body bob on ground {
            mass: 1.3, com: [0.1, -0.8, 0], inertia: 0.2,
            joint: revolute(z), coordinate: theta,
            torque: atan2(theta + 1, 2 + dot(theta)) - atan2(1, theta * dot(theta)),
        }
    }
}

mechanism! {
    /// Quadratic drag, and a one-sided spring.
    pub Drag {
        units: none,
        gravity: [0, -9.81, 0],
        generate: [taylor],
        body bob on ground {
            mass: 1.3, com: [0.1, -0.8, 0], inertia: 0.2,
            joint: revolute(z), coordinate: theta,
            torque: -abs(dot(theta)) * dot(theta) / 3 - abs(theta),
        }
    }
}

mechanism! {
    /// Torque that depends on the time.
    pub Driven {
        units: none,
        gravity: [0, -9.81, 0],
        generate: [taylor],
        body bob on ground {
            mass: 1.3, com: [0.1, -0.8, 0], inertia: 0.2,
            joint: revolute(z), coordinate: theta,
            torque: 2 * sin(3 * t + 1) + t^2 * exp(-t) + t,
        }
    }
}
