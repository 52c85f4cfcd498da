//! Three motions of the double pendulum, whose final states are known to 20 digits.

use std::error::Error;

use pendulum_core::accuracy::{Problem, Reference};
use pendulum_core::prelude::*;
use testbed::{trajectories, work};

mechanism! {
    /// Two identical plates on joints with equal friction: Williams (2023), Eq. 22.
    pub(crate) DoublePendulum {
        params { gamma: N m s = 0.1 }
        gravity: [0, -9.8, 0],
        generate: [rhs, jacobian, energy, taylor, canonical],

        shape plate { mass: 1, com: [0, -1, 0], inertia: 1 }

        body upper on ground: plate {
            joint: revolute(z),
            coordinate: theta1,
            friction: gamma,
        }
        body lower on upper: plate {
            joint: revolute(z) at [0, -1, 0],
            coordinate: theta2 absolute,
            friction: gamma,
        }
    }
}

pub(crate) type Scene = work::Scene<DoublePendulum, 4>;

/// A regular motion, a chaotic one, and a stiff one.
pub(crate) fn scenes() -> Result<[Scene; 3], Box<dyn Error>> {
    let degree = 1.0_f64.to_radians();
    Ok([
        scene(
            ["regular", "regular, small swing with friction, 20 s"],
            ("paper_gamma_0.1", 0.1),
            [0.0, 4.0 * degree],
            [0.0; 2],
            20.0,
        )?,
        scene(
            ["chaotic", "chaotic, large swing, no friction, 10 s"],
            ("large_swing", 0.0),
            [2.0, 2.5],
            [0.0; 2],
            10.0,
        )?,
        scene(
            ["stiff", "stiff, very strong friction, 5 s"],
            ("stiff_axles", 1e4),
            [1.0, -1.0],
            [0.0; 2],
            5.0,
        )?,
    ])
}

/// Tolerance of the reference solutions of the stiff scene between the points.
const TIGHT: f64 = 1e-14;

fn scene(
    [name, title]: [&'static str; 2],
    (known, gamma): (&str, f64),
    angles: [f64; 2],
    rates: [f64; 2],
    t1: f64,
) -> Result<Scene, Box<dyn Error>> {
    let model = DoublePendulum::new(DoublePendulumParams { gamma })?;
    let x0 = SVector::from([angles[0], angles[1], rates[0], rates[1]]);
    let reference = if gamma < 100.0 {
        Reference::integrate(&model, 0.0, t1, x0)?
    } else {
        let best = Rodas5P::new().rtol(TIGHT).atol(TIGHT).solve(&model, 0.0, t1, x0)?;
        let other = Radau5::new().rtol(TIGHT).atol(TIGHT).solve(&model, 0.0, t1, x0)?;
        Reference::solutions(best, &other)?
    };
    eprintln!(
        "{name}: between the points the reference is known to {:.0e}",
        reference.uncertainty(0.5 * t1)
    );
    let end = trajectories::scene(known).state(t1);
    Ok(Scene {
        name,
        title,
        model,
        x0,
        t1,
        // the digits are rounded to doubles
        reference: reference.with_points([(t1, end)], f64::EPSILON * end.amax()),
    })
}

/// The problem, with energies in units of the initial energy above hanging at rest.
pub(crate) fn problem(scene: &Scene) -> Problem<'_, DoublePendulum, 4> {
    let energy = |x| scene.model.energy(0.0, x);
    scene.problem().energy(energy(&scene.x0) - energy(&SVector::zeros()))
}
