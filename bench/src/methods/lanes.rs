//! Many trajectories at a time.

use nalgebra::SVector;

use super::scene::Scene;

/// A method for many trajectories.
pub(crate) struct Together {
    pub by: &'static str,
    pub method: &'static str,
    /// Integrates a scene from each of the starts with a tolerance, and gives the ends.
    pub integrate: Box<Integrate>,
}

pub(crate) type Integrate = dyn Fn(&Scene, f64, &[SVector<f64, 4>]) -> Result<Vec<SVector<f64, 4>>, String>;

/// As many as the widest lanes take together, twice.
pub(crate) const COUNT: usize = 64;

/// How far the starts of two neighbours differ in the first angle. Their steps differ, too, but not by much.
pub(crate) const APART: f64 = 1e-4;

/// The start of a scene, and others near it.
pub(crate) fn starts(scene: &Scene) -> Vec<SVector<f64, 4>> {
    let start = |n: usize| SVector::from(scene.x0) + SVector::from([APART * n as f64, 0.0, 0.0, 0.0]);
    (0..COUNT).map(start).collect()
}
