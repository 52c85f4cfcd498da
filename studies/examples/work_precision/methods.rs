//! Measured methods, one per line.

use pendulum_core::prelude::*;
use testbed::work::{Measurement, Study, steps, tolerances};
use testbed::{adaptive, adaptive_in_lanes};

use crate::scenes::{Scene, problem};

const ROUNDS: usize = 21;
/// Least tolerance. Not smaller, since the reference between the points has 1e-14 itself.
const LEAST: f64 = 3e-14;

/// Measures all methods for nonstiff motions, alone and in lanes.
pub(crate) fn measure(scene: &Scene) -> Measurement {
    let study = Study::of(scene, problem(scene), ROUNDS).method("Rk4", steps(0.2, 1e-3), Rk4::new);
    let study = adaptive!(study, tolerances(LEAST);
        Rk45 Tsit5 Vern7 Vern9 Taylor Auto Rodas5P Radau5 Radau9 Radau13)
    .method("Gauss4", steps(0.2, 2e-3), Gauss4::new)
    .method("Gauss6", steps(0.4, 1e-2), Gauss6::new)
    .in_lanes("Rk4", steps(0.2, 1e-3), Rk4::new);
    adaptive_in_lanes!(study, tolerances(LEAST); Rk45 Tsit5 Vern7 Vern9 Taylor).run()
}

/// Measures the methods for stiff motions, and two explicit ones for comparison.
pub(crate) fn measure_stiff(scene: &Scene) -> Measurement {
    let study = Study::of(scene, problem(scene), ROUNDS);
    adaptive!(study, tolerances(LEAST); Rk45 Taylor Auto Rodas4 Rodas5P Radau5 Radau9 Radau13).run()
}
