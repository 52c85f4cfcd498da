//! Scenes: the double pendulum of Eq. 22 from three initial conditions.

use std::error::Error;

use super::pendulum::{DoublePendulum, DoublePendulumParams, double_pendulum};
use testbed::trajectories;

/// Scene of `testbed/data/trajectories.json`, up to its last time.
pub(crate) struct Scene {
    /// One letter.
    pub name: &'static str,
    pub title: &'static str,
    pub stiff: bool,
    /// Friction of both joints; all scenes share the other parameters of the paper.
    pub gamma: f64,
    pub x0: [f64; 4],
    pub t1: f64,
    /// Initial step size, for libraries that require one.
    pub h0: f64,
    /// State at `t1`, rounded from 20 digits.
    pub expected: [f64; 4],
    pub model: DoublePendulum,
}

pub(crate) fn scenes() -> Result<[Scene; 3], Box<dyn Error>> {
    Ok([
        scene("F", "large swing without friction", "large_swing", 1e-2)?,
        scene("P", "small swing with friction", "paper_gamma_0.1", 1e-2)?,
        scene("S", "much friction, stiff", "stiff_axles", 1e-6)?,
    ])
}

fn scene(name: &'static str, title: &'static str, reference: &str, h0: f64) -> Result<Scene, Box<dyn Error>> {
    let reference = trajectories::scene(reference);
    let [upper, lower] = reference.bodies[..] else {
        return Err("not a double pendulum".into());
    };
    let gamma = upper.friction;
    let model = double_pendulum(gamma)?;
    let DoublePendulumParams {
        m, inertia, c, d, g, ..
    } = *model.params();
    let same = [upper, lower]
        .iter()
        .all(|body| [body.mass, body.inertia, body.c, body.d, body.friction] == [m, inertia, c, d, gamma]);
    if !same || reference.g != g {
        return Err(format!("{} has other parameters", reference.name).into());
    }
    let (t1, expected) = *reference.points().last().ok_or("no state")?;
    Ok(Scene {
        name,
        title,
        stiff: gamma > 100.0,
        gamma,
        x0: reference.start(),
        t1,
        h0,
        expected,
        model,
    })
}

impl Scene {
    /// Largest component of the error of a final state.
    pub(crate) fn error(&self, x: &[f64; 4]) -> f64 {
        let differences = x.iter().zip(&self.expected).map(|(x, expected)| (x - expected).abs());
        // keep NaN, which `max` would ignore
        differences.fold(0.0, |worst, error| if error <= worst { worst } else { error })
    }

    /// True if `t` is the end time, up to its last two digits.
    pub(crate) fn is_end(&self, t: f64) -> bool {
        (t - self.t1).abs() <= 2.0 * f64::EPSILON * self.t1
    }
}
