//! Measured methods, one per line.

use pendulum_core::accuracy::{Report, Sweep};
use pendulum_core::prelude::*;
use pendulum_core::{Operations, Statistics};

use crate::scenes::{DoublePendulum, Scene};
use testbed::counted::Counted;

/// Suffix of the method's name in the rows of ensembles.
pub(crate) const LANES: &str = ", lanes";
/// Methods whose settings are step sizes; those of others are tolerances.
pub(crate) const FIXED: [&str; 3] = ["Rk4", "Gauss4", "Gauss6"];

const ROUNDS: usize = 21;

/// Errors and times of all methods, and the operations of those that run alone.
pub(crate) struct Measurement {
    pub report: Report,
    /// Operations of each method with each setting, or none if the run failed.
    operations: Vec<Vec<Option<Operations>>>,
}

/// Operations of a run, with its steps and evaluations.
type Work = (Operations, Statistics);

impl Measurement {
    /// Additions and multiplications of method `n` with a setting: all of its own and those of the model, from the
    /// start to the end.
    pub(crate) fn flops(&self, n: usize, setting: f64) -> Option<usize> {
        let run = self.report.methods[n]
            .runs
            .iter()
            .position(|run| run.setting == setting)?;
        Some(self.operations.get(n)?[run]?.flops())
    }
}

/// Methods to measure on a scene.
struct Study<'s> {
    scene: &'s Scene,
    sweep: Sweep<'s, DoublePendulum, 4>,
    counted: Vec<Vec<Option<Work>>>,
}

impl<'s> Study<'s> {
    fn of(scene: &'s Scene) -> Self {
        Self {
            scene,
            sweep: Sweep::new(scene.problem()).rounds(ROUNDS),
            counted: Vec::new(),
        }
    }

    fn method<M>(mut self, name: &str, settings: impl Iterator<Item = f64> + Clone, make: impl Fn(f64) -> M) -> Self
    where
        M: Method<DoublePendulum, f64, 4> + Method<DoublePendulum<Counted>, Counted, 4> + 's,
    {
        let counted = settings.clone().map(|setting| self.scene.count(&make(setting)));
        self.counted.push(counted.collect());
        self.sweep = self.sweep.method(name, settings, make);
        self
    }

    fn run(self) -> Measurement {
        let report = self.sweep.run();
        for (series, counted) in report.methods.iter().zip(&self.counted) {
            for ((setting, measured), (_, counted)) in series.measured().zip(counted.iter().flatten()) {
                assert_eq!(
                    measured.work,
                    Some(*counted),
                    "{} with {setting} took other steps",
                    series.name
                );
            }
        }
        let of_runs = |runs: Vec<Option<Work>>| runs.into_iter().map(|run| Some(run?.0)).collect();
        Measurement {
            report,
            operations: self.counted.into_iter().map(of_runs).collect(),
        }
    }
}

/// Measures all methods for nonstiff motions, alone and in lanes.
pub(crate) fn measure(scene: &Scene) -> Measurement {
    let more = &scene.neighbours();
    let mut study = Study::of(scene)
        .method("Rk4", steps(0.2, 1e-3), Rk4::new)
        .method("Rk45", tolerances(), |tol| Rk45::new().rtol(tol).atol(tol))
        .method("Tsit5", tolerances(), |tol| Tsit5::new().rtol(tol).atol(tol))
        .method("Vern7", tolerances(), |tol| Vern7::new().rtol(tol).atol(tol))
        .method("Vern9", tolerances(), |tol| Vern9::new().rtol(tol).atol(tol))
        .method("Taylor", tolerances(), |tol| Taylor::new().rtol(tol).atol(tol))
        .method("Auto", tolerances(), |tol| Auto::new().rtol(tol).atol(tol))
        .method("Rodas5P", tolerances(), |tol| Rodas5P::new().rtol(tol).atol(tol))
        .method("Radau5", tolerances(), |tol| Radau5::new().rtol(tol).atol(tol))
        .method("Radau9", tolerances(), |tol| Radau9::new().rtol(tol).atol(tol))
        .method("Radau13", tolerances(), |tol| Radau13::new().rtol(tol).atol(tol))
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
    Study::of(scene)
        .method("Rk45", tolerances(), |tol| Rk45::new().rtol(tol).atol(tol))
        .method("Taylor", tolerances(), |tol| Taylor::new().rtol(tol).atol(tol))
        .method("Auto", tolerances(), |tol| Auto::new().rtol(tol).atol(tol))
        .method("Rodas4", tolerances(), |tol| Rodas4::new().rtol(tol).atol(tol))
        .method("Rodas5P", tolerances(), |tol| Rodas5P::new().rtol(tol).atol(tol))
        .method("Radau5", tolerances(), |tol| Radau5::new().rtol(tol).atol(tol))
        .method("Radau9", tolerances(), |tol| Radau9::new().rtol(tol).atol(tol))
        .method("Radau13", tolerances(), |tol| Radau13::new().rtol(tol).atol(tol))
        .run()
}

/// Tolerances from 1e-3 to 3e-14, two per decade. Not smaller, since the reference between the points has 1e-14 itself.
fn tolerances() -> impl Iterator<Item = f64> + Clone {
    (6..=27).map(|n| 10.0_f64.powf(-0.5 * f64::from(n)))
}

/// Step sizes that decrease from `first` by the square root of two, down to `least`.
fn steps(first: f64, least: f64) -> impl Iterator<Item = f64> + Clone {
    let step = move |n: u32| first * 0.5_f64.powf(0.5 * f64::from(n));
    (0..).map(step).take_while(move |&h| h >= least)
}
