//! Methods for many trajectories at a time.

use nalgebra::SVector;

use super::scene::Scene;

/// Method for many trajectories.
pub(crate) struct Together {
    pub by: &'static str,
    pub method: &'static str,
    /// Integrates a scene from each initial state with a tolerance, and returns the final states.
    pub integrate: Box<Integrate>,
}

pub(crate) type Integrate = dyn Fn(&Scene, f64, &[SVector<f64, 4>]) -> Result<Vec<SVector<f64, 4>>, String>;

/// Number of trajectories: twice as many as the widest lanes hold.
pub(crate) const COUNT: usize = 64;

/// Difference of neighbouring initial states in the first angle. It makes their step sizes differ a little.
pub(crate) const APART: f64 = 1e-4;

/// Initial state of a scene, and others near it.
pub(crate) fn starts(scene: &Scene) -> Vec<SVector<f64, 4>> {
    let start = |n: usize| SVector::from(scene.x0) + SVector::from([APART * n as f64, 0.0, 0.0, 0.0]);
    (0..COUNT).map(start).collect()
}
