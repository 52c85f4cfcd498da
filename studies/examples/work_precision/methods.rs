//! Measured methods, one per line.

use pendulum_core::accuracy::{Report, Sweep};
use pendulum_core::prelude::*;

use crate::scenes::Scene;
use charts::chart::Line;
use charts::methods;

/// Suffix of the method's name in the rows of ensembles.
pub(crate) const LANES: &str = ", lanes";

const ROUNDS: usize = 21;

/// Measures all methods for nonstiff motions, alone and in lanes.
pub(crate) fn measure(scene: &Scene) -> Report {
    let more = &scene.neighbours();
    Sweep::new(scene.problem())
        .rounds(ROUNDS)
        .method("Rk4", steps(0.2, 1e-3), Rk4::new)
        .method("Rk45", tolerances(), |tol| Rk45::new().rtol(tol).atol(tol))
        .method("Tsit5", tolerances(), |tol| Tsit5::new().rtol(tol).atol(tol))
        .method("Vern7", tolerances(), |tol| Vern7::new().rtol(tol).atol(tol))
        .method("Vern9", tolerances(), |tol| Vern9::new().rtol(tol).atol(tol))
        .method("Taylor", tolerances(), |tol| Taylor::new().rtol(tol).atol(tol))
        .method("Auto", tolerances(), |tol| Auto::new().rtol(tol).atol(tol))
        .method("Rodas5P", tolerances(), |tol| Rodas5P::new().rtol(tol).atol(tol))
        .method("Radau5", tolerances(), |tol| Radau5::new().rtol(tol).atol(tol))
        .method("Gauss4", steps(0.2, 2e-3), Gauss4::new)
        .method("Gauss6", steps(0.4, 1e-2), Gauss6::new)
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
        })
        .run()
}

/// Measures the methods for stiff motions, and two explicit ones for comparison.
pub(crate) fn measure_stiff(scene: &Scene) -> Report {
    Sweep::new(scene.problem())
        .rounds(ROUNDS)
        .method("Rk45", tolerances(), |tol| Rk45::new().rtol(tol).atol(tol))
        .method("Taylor", tolerances(), |tol| Taylor::new().rtol(tol).atol(tol))
        .method("Auto", tolerances(), |tol| Auto::new().rtol(tol).atol(tol))
        .method("Rodas4", tolerances(), |tol| Rodas4::new().rtol(tol).atol(tol))
        .method("Rodas5P", tolerances(), |tol| Rodas5P::new().rtol(tol).atol(tol))
        .method("Radau5", tolerances(), |tol| Radau5::new().rtol(tol).atol(tol))
        .run()
}

/// Line style of a method, alone or in lanes.
pub(crate) fn line(name: &str) -> Line {
    methods::line(name.trim_end_matches(LANES))
}

/// Tolerances from 1e-3 to 3e-14, two per decade. Not smaller, since the reference between the points has 1e-14 itself.
fn tolerances() -> impl Iterator<Item = f64> {
    (6..=27).map(|n| 10.0_f64.powf(-0.5 * f64::from(n)))
}

/// Step sizes that decrease from `first` by the square root of two, down to `least`.
fn steps(first: f64, least: f64) -> impl Iterator<Item = f64> {
    let step = move |n: u32| first * 0.5_f64.powf(0.5 * f64::from(n));
    (0..).map(step).take_while(move |&h| h >= least)
}
