//! # Bennett's linkage
//!
//! Four hinges in a ring, no two of them parallel, and yet it moves: opposite links are equal, and the lengths are
//! proportional to the sines of the twists (Bennett 1903). The dependent angles are part of the state.

use pendulum_core::prelude::*;

use crate::{Check, Run, jacobian_by_differences, larger};

mechanism! {
    /// Three links and the frame, with a pin at each hinge; a motor turns the first against friction.
    pub Bennett {
        params { skew: rad = 0.4, other: rad = 0.8928089789005025, drive: N m = 0.4, gamma: N m s = 0.05 }
        gravity: [0, 0, -9.81],
        shape short { solids: [rod(0.5, [0, 0, 0], [0.4, 0, 0]), cylinder(0.2, 0.015, [0, 0, -0.08], [0, 0, 0.08])] }
        shape long { solids: [rod(1, [0, 0, 0], [0.8, 0, 0]), cylinder(0.2, 0.015, [0, 0, -0.08], [0, 0, 0.08])] }
        body frame on ground: long {}
        body first on frame: short {
            joint: revolute(z) at [0.8, 0, 0] rpy [other, 0, 0],
            coordinate: theta near 2, torque: drive, friction: gamma,
        }
        body second on first: long {
            joint: revolute(z) at [0.4, 0, 0] rpy [skew, 0, 0], coordinate: phi depends near 2,
        }
        body third on second: short {
            joint: revolute(z) at [0.8, 0, 0] rpy [other, 0, 0], coordinate: psi depends near -2,
        }
        close third at [0.4, 0, 0] rpy [skew, 0, 0] to frame: revolute(z),
        point middle on second at [0.4, 0, 0], point corner on second,
        point end on third at [0.4, 0, 0], point pin on third at [0.4, -0.08*sin(skew), 0.08*cos(skew)],
        output gap: [end.x, end.y, end.z, pin.x, pin.y],
        generate: [rhs, jacobian, energy, shapes],
    }
}

/// Checks Bennett's relation between neighbours, opposite angles, the closure of the loop, the Jacobian, and the power
/// of motor and friction.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let model = Bennett::new(BennettParams::default())?;
    let BennettParams {
        skew,
        other,
        drive,
        gamma,
    } = BennettParams::default();
    // theta and its rate, with guesses of the dependent angles
    let start = model.assemble(0.0, [2.0, 2.0, -2.0, 6.0])?;
    let solution = Vern9::new().rtol(1e-12).atol(1e-12).solve(&model, 0.0, 2.05, start)?;
    let (mut relation, mut opposite, mut open) = (0.0, 0.0, 0.0);
    // tan(theta/2) tan(phi/2) = sin((other + skew)/2) / sin((other - skew)/2), without the quotients
    let (sum, difference) = ((0.5 * (other + skew)).sin(), (0.5 * (other - skew)).sin());
    for (t, x) in solution.points() {
        let (theta, phi, psi) = (x[Bennett::THETA], x[Bennett::PHI], x[Bennett::PSI]);
        let ((s1, c1), (s2, c2)) = ((0.5 * theta).sin_cos(), (0.5 * phi).sin_cos());
        relation = larger(relation, (s1 * s2 * difference - c1 * c2 * sum).abs());
        opposite = larger(opposite, (0.5 * (theta + psi)).sin().abs());
        open = larger(open, model.gap(t, x).amax());
    }
    let checks = vec![
        Check::new("Bennett's relation", relation, 0.0, 1e-14),
        Check::new("half the sum of opposite angles, its sine", opposite, 0.0, 1e-14),
        Check::new("ends of the loop apart, in m", open, 0.0, 5e-15),
        jacobian_by_differences(&model, 0.0, start.into()),
    ];
    let powers = move |_: f64, x: &SVector<f64, 4>| {
        let rate = x[Bennett::DOT_THETA];
        vec![drive * rate, -gamma * rate * rate]
    };
    Run::new(checks, model, solution, powers, |drawing| {
        drawing.seen_from([0.6, -0.8, 0.5], [0.0, 0.0, 1.0]).ghosts(3)
    })
}
