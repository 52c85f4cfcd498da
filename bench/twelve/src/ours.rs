//! Our own methods.

use nalgebra::SVector;
use pendulum_core::taylor::MAX_ORDER;
use pendulum_core::{
    Auto, Jacobian, Method, Radau5, Radau9, Radau13, Rodas4, Rodas5P, Statistics, Taylor, TaylorSeries, Tsit5, Vern7,
    Vern9,
};

use crate::entrant::{Entrant, Reached, Task, due};
use crate::flops::Flops;

/// Name under which our methods enter.
pub const OURS: &str = "ours";

/// A method for each name, with its settings for a relative and an absolute tolerance.
macro_rules! entrants {
    ($task:expr; $($method:ident)*) => {
        vec![$(entrant($task, stringify!($method), |rtol, atol| $method::new().rtol(rtol).atol(atol), calls),)*]
    };
}

/// Operations of the model in a run with a tolerance.
type Operations = fn(&Flops, f64, &Statistics) -> f64;

fn calls(flops: &Flops, _tolerance: f64, work: &Statistics) -> f64 {
    flops.of(work.evaluations, work.jacobians)
}

/// Operations of the series of `Taylor`, whose order follows from the larger one of its tolerances.
fn series(flops: &Flops, tolerance: f64, work: &Statistics) -> f64 {
    let order = (5.0 - 0.5 * tolerance.ln()).ceil() as usize;
    (work.evaluations * flops.series[order.clamp(4, MAX_ORDER)]) as f64
}

pub(crate) fn smooth<S, const N: usize>(task: Task<S, N>) -> Vec<Entrant>
where
    S: Jacobian<f64, N> + TaylorSeries<f64, N>,
{
    let taylor = entrant(task, "Taylor", |rtol, atol| Taylor::new().rtol(rtol).atol(atol), series);
    let mut entrants = entrants!(task; Tsit5 Vern7 Vern9 Auto);
    entrants.push(taylor);
    entrants
}

pub(crate) fn stiff<S: Jacobian<f64, N>, const N: usize>(task: Task<S, N>) -> Vec<Entrant> {
    entrants!(task; Rodas4 Rodas5P Radau5 Radau9 Radau13 Auto)
}

fn entrant<S, M, const N: usize>(
    task: Task<S, N>,
    name: &'static str,
    make: fn(f64, f64) -> M,
    operations: Operations,
) -> Entrant
where
    M: Method<S, f64, N> + 'static,
    S: Jacobian<f64, N>,
{
    Entrant::new(OURS, name, task.t1, move |tolerance, outputs| {
        let method = make(tolerance, task.absolute * tolerance);
        let (mut reached, work) = integrate(&method, &task.model, [0.0, task.t1], task.x0, outputs)?;
        reached.operations = Some(operations(&task.flops, tolerance, &work));
        Ok(reached)
    })
}

fn integrate<S, M, const N: usize>(
    method: &M,
    model: &S,
    [t0, t1]: [f64; 2],
    x0: SVector<f64, N>,
    outputs: &[f64],
) -> Result<(Reached<N>, Statistics), String>
where
    M: Method<S, f64, N>,
    S: Jacobian<f64, N>,
{
    let mut stepper = method.stepper(model, t0, t1, x0).map_err(|reason| reason.to_string())?;
    let mut along = Vec::new();
    while stepper.step().map_err(|reason| reason.to_string())?.is_some() {
        while let Some(t) = due(outputs, &along, stepper.t()) {
            along.push(stepper.dense().at(t).into());
        }
    }
    let work = stepper.statistics();
    let reached = Reached {
        t: stepper.t(),
        x: stepper.x().into(),
        evaluations: Some(work.evaluations),
        operations: None,
        along,
    };
    Ok((reached, work))
}

/// Tolerance of references.
const TIGHT: f64 = 1e-14;

/// States at the output times, and their uncertainty: the largest difference of two methods. They integrate from output
/// to output, so that no state is interpolated.
pub(crate) fn known_along<S, const N: usize>(
    task: Task<S, N>,
    is_stiff: bool,
    outputs: &[f64],
) -> Result<(Vec<SVector<f64, N>>, f64), String>
where
    S: Jacobian<f64, N> + TaylorSeries<f64, N>,
{
    let (rtol, atol) = (TIGHT, task.absolute * TIGHT);
    let [best, other] = if is_stiff {
        [
            legs(&Radau13::new().rtol(rtol).atol(atol), task, outputs)?,
            legs(&Radau9::new().rtol(rtol).atol(atol), task, outputs)?,
        ]
    } else {
        [
            legs(&Taylor::new().rtol(rtol).atol(atol), task, outputs)?,
            legs(&Vern9::new().rtol(rtol).atol(atol), task, outputs)?,
        ]
    };
    let differences = best.iter().zip(&other).map(|(a, b)| (a - b).amax());
    let uncertainty = differences.fold(0.0, f64::max);
    Ok((best, uncertainty))
}

fn legs<S, M, const N: usize>(method: &M, task: Task<S, N>, outputs: &[f64]) -> Result<Vec<SVector<f64, N>>, String>
where
    M: Method<S, f64, N>,
    S: Jacobian<f64, N>,
{
    let (mut t, mut x) = (0.0, task.x0);
    let leg = |&output: &f64| {
        x = integrate(method, &task.model, [t, output], x, &[])?.0.x.into();
        t = output;
        Ok(x)
    };
    outputs.iter().map(leg).collect()
}
