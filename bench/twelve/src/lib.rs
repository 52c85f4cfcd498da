//! Methods in Rust on the twelve problems of the test bed. A crate of its own, because it takes minutes to compile.
#![forbid(unsafe_code)]
#![allow(missing_docs, reason = "fields and functions whose names say what they are")]

mod differential_equations;
mod diffsol;
mod entrant;
mod flops;
mod model;
mod ode_solvers;
mod ours;

use std::error::Error;

use pendulum_core::{Cast, Jacobian, TaylorSeries};
use testbed::counted::Counted;
use testbed::problems::{self, Visitor};
use testbed::work::Scene;

pub use entrant::{End, Entrant, Integrate, Request, output_times};
pub use flops::Flops;
pub use model::Model;
pub use ours::OURS;

/// Number of times within the span at which dense output is compared.
pub const OUTPUTS: usize = 100;

/// Problem with its reference, and the methods in Rust.
pub struct Problem {
    pub name: &'static str,
    pub title: &'static str,
    pub is_stiff: bool,
    pub x0: Vec<f64>,
    pub t1: f64,
    /// Absolute tolerance over the relative one.
    pub absolute: f64,
    /// State at `t1`.
    pub end: Vec<f64>,
    /// Uncertainty of `end`, relative to its largest component.
    pub uncertainty: f64,
    /// States at [`OUTPUTS`] output times.
    pub along: Vec<Vec<f64>>,
    /// Uncertainty of `along`, relative to its largest component.
    pub uncertainty_along: f64,
    pub model: &'static Model,
    pub flops: Flops,
    pub entrants: Vec<Entrant>,
}

/// All problems.
///
/// # Errors
/// If a reference cannot be computed.
pub fn problems() -> Result<Vec<Problem>, Box<dyn Error>> {
    let mut all = All(Vec::new());
    problems::each(&mut all)?;
    Ok(all.0)
}

/// Absolute tolerance over the relative one. In Robertson's problem a concentration of 1e-5 and less decides on the
/// reactions, and a method that lets it become negative fails. The value is from Hairer and Wanner, IV.10.
fn absolute(problem: &str) -> f64 {
    if problem == "robertson" { 1e-6 } else { 1.0 }
}

struct All(Vec<Problem>);

impl Visitor for All {
    fn visit<S, const N: usize>(&mut self, scene: Scene<S, N>, is_stiff: bool)
    where
        S: Cast<N, In<f64> = S> + Jacobian<f64, N> + TaylorSeries<f64, N> + 'static,
        S::In<Counted>: Jacobian<Counted, N> + TaylorSeries<Counted, N>,
    {
        let end = scene.reference.at(scene.t1).expect("the end");
        let uncertainty = scene.reference.uncertainty(scene.t1) / end.amax();
        let (name, title, t1) = (scene.name, scene.title, scene.t1);
        let flops = Flops::count(&scene.model, &scene.x0);
        // entrants are kept to the end of the program
        let task: entrant::Task<S, N> = Box::leak(Box::new(entrant::Motion {
            model: scene.model,
            x0: scene.x0,
            t1,
            absolute: absolute(name),
            flops,
        }));
        let outputs = output_times(t1, OUTPUTS);
        let (along, uncertainty_along) = ours::known_along(task, is_stiff, &outputs).expect("states along the way");
        let size = along.iter().fold(0.0_f64, |size, x| size.max(x.amax()));
        let model: &'static Model = Box::leak(Box::new(Model::of(&task.model)));
        let entrants = if is_stiff {
            vec![
                ours::stiff(task),
                differential_equations::stiff(task),
                diffsol::stiff(model, task),
            ]
        } else {
            vec![
                ours::smooth(task),
                ode_solvers::smooth(task),
                differential_equations::smooth(task),
                diffsol::smooth(model, task),
            ]
        };
        self.0.push(Problem {
            name,
            title,
            is_stiff,
            x0: task.x0.as_slice().to_vec(),
            t1,
            absolute: task.absolute,
            end: end.as_slice().to_vec(),
            uncertainty,
            along: along.iter().map(|x| x.as_slice().to_vec()).collect(),
            uncertainty_along: uncertainty_along / size,
            model,
            flops,
            entrants: entrants.into_iter().flatten().collect(),
        });
    }
}
