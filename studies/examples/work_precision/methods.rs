//! Measured methods, one per line.

use pendulum_core::prelude::*;
use testbed::adaptive;
use testbed::work::{Measurement, Study, steps, tolerances};

use crate::scenes::{Scene, neighbours, problem};

/// Suffix of the method's name in the rows of ensembles.
pub(crate) const LANES: &str = ", lanes";

const ROUNDS: usize = 21;
/// Least tolerance. Not smaller, since the reference between the points has 1e-14 itself.
const LEAST: f64 = 3e-14;

/// Measures all methods for nonstiff motions, alone and in lanes.
pub(crate) fn measure(scene: &Scene) -> Measurement {
    let more = &neighbours(scene);
    let study = Study::of(scene, problem(scene), ROUNDS).method("Rk4", steps(0.2, 1e-3), Rk4::new);
    let mut study = adaptive!(study, tolerances(LEAST);
        Rk45 Tsit5 Vern7 Vern9 Taylor Auto Rodas5P Radau5 Radau9 Radau13)
    .method("Gauss4", steps(0.2, 2e-3), Gauss4::new)
    .method("Gauss6", steps(0.4, 1e-2), Gauss6::new);
    study.sweep = study
        .sweep
        .ensemble("Rk4, lanes", steps(0.2, 1e-3), more, Rk4::new)
        .ensemble("Rk45, lanes", tolerances(LEAST), more, |tol| {
            Rk45::new().rtol(tol).atol(tol)
        })
        .ensemble("Tsit5, lanes", tolerances(LEAST), more, |tol| {
            Tsit5::new().rtol(tol).atol(tol)
        })
        .ensemble("Vern7, lanes", tolerances(LEAST), more, |tol| {
            Vern7::new().rtol(tol).atol(tol)
        })
        .ensemble("Vern9, lanes", tolerances(LEAST), more, |tol| {
            Vern9::new().rtol(tol).atol(tol)
        })
        .ensemble("Taylor, lanes", tolerances(LEAST), more, |tol| {
            Taylor::new().rtol(tol).atol(tol)
        });
    study.run()
}

/// Measures the methods for stiff motions, and two explicit ones for comparison.
pub(crate) fn measure_stiff(scene: &Scene) -> Measurement {
    let study = Study::of(scene, problem(scene), ROUNDS);
    adaptive!(study, tolerances(LEAST); Rk45 Taylor Auto Rodas4 Rodas5P Radau5 Radau9 Radau13).run()
}
