//! Measured methods, one per line.

use pendulum_core::prelude::*;
use testbed::adaptive;
use testbed::work::{Measurement, Study, steps};

use crate::scenes::{Scene, neighbours, problem};

/// Suffix of the method's name in the rows of ensembles.
pub(crate) const LANES: &str = ", lanes";

const ROUNDS: usize = 21;

/// Measures all methods for nonstiff motions, alone and in lanes.
pub(crate) fn measure(scene: &Scene) -> Measurement {
    let more = &neighbours(scene);
    let study = Study::of(scene, problem(scene), ROUNDS).method("Rk4", steps(0.2, 1e-3), Rk4::new);
    let mut study = adaptive!(study, tolerances();
        Rk45 Tsit5 Vern7 Vern9 Taylor Auto Rodas5P Radau5 Radau9 Radau13)
    .method("Gauss4", steps(0.2, 2e-3), Gauss4::new)
    .method("Gauss6", steps(0.4, 1e-2), Gauss6::new);
    study.sweep = study
        .sweep
        .ensemble("Rk4, lanes", steps(0.2, 1e-3), more, Rk4::new)
        .ensemble("Rk45, lanes", tolerances(), more, |tol| Rk45::new().rtol(tol).atol(tol))
        .ensemble("Tsit5, lanes", tolerances(), more, |tol| {
            Tsit5::new().rtol(tol).atol(tol)
        })
        .ensemble("Vern7, lanes", tolerances(), more, |tol| {
            Vern7::new().rtol(tol).atol(tol)
        })
        .ensemble("Vern9, lanes", tolerances(), more, |tol| {
            Vern9::new().rtol(tol).atol(tol)
        })
        .ensemble("Taylor, lanes", tolerances(), more, |tol| {
            Taylor::new().rtol(tol).atol(tol)
        });
    study.run()
}

/// Measures the methods for stiff motions, and two explicit ones for comparison.
pub(crate) fn measure_stiff(scene: &Scene) -> Measurement {
    let study = Study::of(scene, problem(scene), ROUNDS);
    adaptive!(study, tolerances(); Rk45 Taylor Auto Rodas4 Rodas5P Radau5 Radau9 Radau13).run()
}

/// Tolerances from 1e-3 to 3e-14, two per decade. Not smaller, since the reference between the points has 1e-14 itself.
fn tolerances() -> impl Iterator<Item = f64> + Clone {
    (6..=27).map(|n| 10.0_f64.powf(-0.5 * f64::from(n)))
}
