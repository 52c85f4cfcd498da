//! # Four-bar linkage
//!
//! A crank with full rotation, a coupler and a rocker: one loop, one degree of freedom, one coordinate in the state.
//! The two other angles follow from it in closed form. A point of the coupler draws its curve.

use pendulum_core::prelude::*;

use crate::{Check, Run, larger};

mechanism! {
    /// Three bars between two pivots on the ground, the last with friction.
    pub FourBar {
        params { a: m = 0.2, b: m = 0.5, c: m = 0.4, d: m = 0.6, gamma: N m s = 0.02 }
        gravity: [0, -9.81, 0],
        body crank on ground {
            solids: [rod(0.5, [0, 0, 0], [a, 0, 0])],
            joint: revolute(z), coordinate: theta near 0.8,
        }
        body coupler on crank {
            solids: [rod(1.1, [0, 0, 0], [b, 0, 0]), rod(0.6, [0.3, 0, 0], [0.3, 0.3, 0])],
            joint: revolute(z) at [a, 0, 0], coordinate: phi depends near -0.3,
        }
        body rocker on ground {
            solids: [rod(0.9, [0, 0, 0], [c, 0, 0])],
            joint: revolute(z) at [d, 0, 0], coordinate: psi depends near 1.6, friction: gamma,
        }
        close coupler at [b, 0, 0] to rocker at [c, 0, 0]: revolute(z),
        point tip on coupler at [0.3, 0.3, 0],
        point end on coupler at [b, 0, 0], point other on rocker at [c, 0, 0],
        output follow: [phi, psi],
        output gap: [end.x - other.x, end.y - other.y],
        output rocking: dot(psi),
        generate: [rhs, jacobian, energy, shapes],
    }
}

/// Checks Freudenstein's equation between the angles of crank and rocker, the closure of the loop, the Jacobian, and
/// the power of friction.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let model = FourBar::new(FourBarParams::default())?;
    let solution = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&model, 0.0, 4.0, [0.8, 16.0])?;
    let FourBarParams { a, b, c, d, gamma } = FourBarParams::default();
    let (mut worst, mut open) = (0.0, 0.0);
    for (t, x) in solution.points() {
        let (theta, psi) = (x[FourBar::THETA], model.follow(t, x)[1]);
        let lengths = (a * a - b * b + c * c + d * d) / (2.0 * a * c);
        let freudenstein = d / a * psi.cos() - d / c * theta.cos() + lengths - (theta - psi).cos();
        worst = larger(worst, freudenstein.abs());
        open = larger(open, model.gap(t, x).amax());
    }
    let checks = vec![
        Check::new("Freudenstein's equation", worst, 0.0, 1e-14),
        Check::new("ends of the loop apart, in m", open, 0.0, 1e-15),
        crate::jacobian_by_differences(&model, 0.0, [0.7, -3.0]),
    ];
    let powers = move |t: f64, x: &SVector<f64, 2>| vec![-gamma * model.rocking(t, x).powi(2)];
    Run::new(checks, model, solution, powers, |drawing| drawing)
}
