//! Measurement of all methods on each problem.

use pendulum_core::{
    Canonical, Cast, CastJacobian, CastTaylor, Gauss4, Gauss6, Gauss16, Jacobian, Rk4, System, TaylorSeries,
};
use testbed::counted::Counted;
use testbed::problems::Visitor;
use testbed::work::{Measurement, Scene, Study, steps, tolerances};
use testbed::{adaptive, adaptive_in_lanes};

/// Problems with the measurements of the methods that solve them.
#[derive(Default)]
pub(crate) struct Measured(pub(crate) Vec<Problem>);

pub(crate) struct Problem {
    pub(crate) name: &'static str,
    pub(crate) title: &'static str,
    pub(crate) t1: f64,
    /// Largest component of the state at the end.
    pub(crate) size: f64,
    /// Uncertainty of the reference at the end and in the middle.
    pub(crate) uncertainty: [f64; 2],
    pub(crate) measurement: Measurement,
}

const ROUNDS: usize = 9;

impl Visitor for Measured {
    fn visit<S, const N: usize>(&mut self, scene: Scene<S, N>, is_stiff: bool)
    where
        S: Cast<N, In<f64> = S> + CastJacobian<N> + CastTaylor<N> + Jacobian<f64, N> + TaylorSeries<f64, N>,
        S::In<Counted>: Jacobian<Counted, N> + TaylorSeries<Counted, N>,
    {
        let study = study(&scene);
        let measurement = if is_stiff {
            let study = adaptive!(study, tolerances(LEAST); Auto Rodas4 Rodas5P Radau5 Radau9 Radau13);
            adaptive_in_lanes!(study, tolerances(LEAST); Auto).run()
        } else {
            in_lanes(not_stiff(study, scene.t1)).run()
        };
        self.0.push(Problem::new(&scene, measurement));
    }

    fn visit_conservative<S, const N: usize>(&mut self, scene: Scene<S, N>)
    where
        S: Cast<N, In<f64> = S> + CastTaylor<N> + Jacobian<f64, N> + TaylorSeries<f64, N> + Canonical<f64, N>,
        S::In<Counted>: Jacobian<Counted, N> + TaylorSeries<Counted, N> + Canonical<Counted, N>,
    {
        let t1 = scene.t1;
        let study = not_stiff(study(&scene), t1)
            .method("Gauss4", steps(t1 / 50.0, t1 / 5e3), Gauss4::new)
            .method("Gauss6", steps(t1 / 50.0, t1 / 5e3), Gauss6::new)
            .method("Gauss16", steps(t1 / 50.0, t1 / 2e3), Gauss16::new);
        self.0.push(Problem::new(&scene, in_lanes(study).run()));
    }
}

fn study<S: Cast<N, In<f64> = S> + System<f64, N>, const N: usize>(scene: &Scene<S, N>) -> Study<'_, S, N> {
    eprintln!("measuring: {} ..", scene.title);
    Study::of(scene, scene.problem(), ROUNDS)
}

/// Adds the methods for problems that are not stiff.
fn not_stiff<S, const N: usize>(study: Study<'_, S, N>, t1: f64) -> Study<'_, S, N>
where
    S: Cast<N, In<f64> = S> + Jacobian<f64, N> + TaylorSeries<f64, N>,
    S::In<Counted>: Jacobian<Counted, N> + TaylorSeries<Counted, N>,
{
    let study = study.method("Rk4", steps(t1 / 50.0, t1 / 2e4), Rk4::new);
    adaptive!(study, tolerances(LEAST); Rk45 Tsit5 Vern7 Vern9 Taylor Auto Rodas5P Radau5 Radau9 Radau13)
}

/// Adds the methods in lanes for problems that are not stiff.
fn in_lanes<S, const N: usize>(study: Study<'_, S, N>) -> Study<'_, S, N>
where
    S: Cast<N, In<f64> = S> + CastTaylor<N> + TaylorSeries<f64, N>,
{
    adaptive_in_lanes!(study, tolerances(LEAST); Tsit5 Vern7 Vern9 Taylor)
}

/// Least tolerance; references have 1e-14.
const LEAST: f64 = 1e-13;

impl Problem {
    fn new<S, const N: usize>(scene: &Scene<S, N>, measurement: Measurement) -> Self {
        let size = scene.reference.at(scene.t1).expect("the end").amax();
        Self {
            name: scene.name,
            title: scene.title,
            t1: scene.t1,
            size,
            uncertainty: [1.0, 0.5].map(|part| scene.reference.uncertainty(part * scene.t1)),
            measurement,
        }
    }

    /// Fastest setting of each method for a relative error, with its time; methods that do not reach it are left out.
    pub(crate) fn to_reach(&self, error: f64) -> impl Iterator<Item = (&str, f64)> {
        let found = self.measurement.report.time_to_reach(error * self.size);
        found.filter_map(|(name, found)| Some((name, found?.1.minimum)))
    }
}
