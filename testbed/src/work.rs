//! Errors, times and operations of methods on a problem.

use nalgebra::SVector;
use pendulum_core::accuracy::{Measured, Problem, Reference, Report, Sweep};
use pendulum_core::{Cast, Ensemble, Method, Operations, Statistics, System};

use crate::counted::{Counted, spent};

/// Suffix of the names of methods that integrate many trajectories side by side.
pub const LANES: &str = ", lanes";
/// Number of these trajectories.
pub const TOGETHER: u32 = 64;

/// Methods whose settings are step sizes; those of others are tolerances.
pub const FIXED: [&str; 4] = ["Rk4", "Gauss4", "Gauss6", "Gauss16"];

/// Motion on which methods are measured.
pub struct Scene<S, const N: usize> {
    pub name: &'static str,
    pub title: &'static str,
    pub model: S,
    pub x0: SVector<f64, N>,
    pub t1: f64,
    pub reference: Reference<'static, N>,
}

/// Operations of a run, with its steps and evaluations.
type Work = (Operations, Statistics);

impl<S: Cast<N, In<f64> = S> + System<f64, N>, const N: usize> Scene<S, N> {
    pub fn problem(&self) -> Problem<'_, S, N> {
        Problem::new(&self.model, 0.0, self.t1, self.x0, &self.reference)
    }

    /// Starts of the other trajectories of an ensemble: the last component, a rate in mechanisms, differs by multiples
    /// of 1e-4 of the largest.
    fn neighbours(&self) -> Vec<SVector<f64, N>> {
        let neighbour = |n: u32| {
            let mut x = self.x0;
            x[N - 1] += 1e-4 * self.x0.amax() * f64::from(n);
            x
        };
        (1..TOGETHER).map(neighbour).collect()
    }

    /// Counts the operations of a method from the start to the end; `None` if it does not reach the end.
    fn count(&self, method: &impl Method<S::In<Counted>, Counted, N>) -> Option<Work> {
        let model = self.model.cast::<Counted>();
        let mut work = None;
        let operations = spent(|| {
            let stepper = method.stepper(&model, Counted(0.0), Counted(self.t1), self.x0.map(Counted));
            let end = stepper.map(|mut stepper| stepper.run().map(|_| stepper.statistics()));
            work = end.ok().and_then(Result::ok);
        });
        work.map(|work| (operations, work))
    }
}

/// Errors and times of all methods, and the operations of the ones that run alone.
pub struct Measurement {
    pub report: Report,
    /// Operations of each method with each setting, or none if the run failed.
    operations: Vec<Vec<Option<Operations>>>,
}

impl Measurement {
    /// Additions and multiplications of method `n` with a setting: all of its own and those of the model, from the
    /// start to the end.
    pub fn flops(&self, n: usize, setting: f64) -> Option<usize> {
        let run = self.report.methods[n]
            .runs
            .iter()
            .position(|run| run.setting == setting)?;
        Some(self.operations.get(n)?.get(run)?.as_ref()?.flops())
    }
}

/// Methods to measure on a scene.
pub struct Study<'s, S, const N: usize> {
    scene: &'s Scene<S, N>,
    sweep: Sweep<'s, S, N>,
    counted: Vec<Vec<Option<Work>>>,
}

impl<'s, S: Cast<N, In<f64> = S> + System<f64, N>, const N: usize> Study<'s, S, N> {
    /// Without methods; `problem` is that of the scene, for example with energies.
    pub fn of(scene: &'s Scene<S, N>, problem: Problem<'s, S, N>, rounds: usize) -> Self {
        Self {
            scene,
            sweep: Sweep::new(problem).rounds(rounds),
            counted: Vec::new(),
        }
    }

    #[must_use]
    pub fn method<M>(mut self, name: &str, settings: impl Iterator<Item = f64> + Clone, make: impl Fn(f64) -> M) -> Self
    where
        M: Method<S, f64, N> + Method<S::In<Counted>, Counted, N> + 's,
    {
        let counted = settings.clone().map(|setting| self.scene.count(&make(setting)));
        self.counted.push(counted.collect());
        self.sweep = self.sweep.method(name, settings, make);
        self
    }

    /// Adds a method that integrates the trajectory together with [others](TOGETHER), whose starts are a little apart;
    /// its operations are not counted.
    #[must_use]
    pub fn in_lanes<M>(mut self, name: &str, settings: impl Iterator<Item = f64>, make: impl Fn(f64) -> M) -> Self
    where
        M: Ensemble<S, f64, N> + 's,
    {
        self.counted.push(Vec::new());
        let name = format!("{name}{LANES}");
        self.sweep = self.sweep.ensemble(name, settings, &self.scene.neighbours(), make);
        self
    }

    /// Measures all methods.
    ///
    /// # Panics
    /// If numbers that count take other steps.
    pub fn run(self) -> Measurement {
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

/// Adds adaptive methods to a study, each with these tolerances.
#[macro_export]
macro_rules! adaptive {
    ($study:expr, $tolerances:expr; $($method:ident)*) => {
        $study$(.method(stringify!($method), $tolerances, |tol| {
            pendulum_core::$method::new().rtol(tol).atol(tol)
        }))*
    };
}

/// Like `adaptive!`, for methods in lanes.
#[macro_export]
macro_rules! adaptive_in_lanes {
    ($study:expr, $tolerances:expr; $($method:ident)*) => {
        $study$(.in_lanes(stringify!($method), $tolerances, |tol| {
            pendulum_core::$method::new().rtol(tol).atol(tol)
        }))*
    };
}

/// Tolerances from 1e-3 down to `least`, two per decade.
pub fn tolerances(least: f64) -> impl Iterator<Item = f64> + Clone {
    let tolerance = |n: u32| 10.0_f64.powf(-0.5 * f64::from(n));
    (6..)
        .map(tolerance)
        .take_while(move |&tolerance| tolerance > 0.9 * least)
}

/// Setting of a run, in words, with its work.
pub fn note(method: &str, setting: f64, measured: &Measured) -> String {
    let setting = match FIXED.contains(&method) {
        true => format!("step of {setting:.3e}"),
        false => format!("tolerance {setting:.1e}"),
    };
    let work = measured.work.map(|work| {
        let steps = work.accepted + work.rejected;
        format!("; {steps} steps, {} evaluations", work.evaluations)
    });
    format!("{setting}{}", work.unwrap_or_default())
}

/// Step sizes that decrease from `first` by the square root of two, down to `least`.
pub fn steps(first: f64, least: f64) -> impl Iterator<Item = f64> + Clone {
    let step = move |n: u32| first * 0.5_f64.powf(0.5 * f64::from(n));
    (0..).map(step).take_while(move |&h| h >= least)
}
