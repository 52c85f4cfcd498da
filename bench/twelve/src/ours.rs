//! Our own methods.

use pendulum_core::{
    Auto, Jacobian, Method, Radau5, Radau9, Radau13, Rodas4, Rodas5P, Taylor, TaylorSeries, Tsit5, Vern7, Vern9,
};

use crate::entrant::{Entrant, Task};

/// Name under which our methods enter.
pub const OURS: &str = "ours";

/// A method for each name, with its settings for a relative and an absolute tolerance.
macro_rules! entrants {
    ($task:expr; $($method:ident)*) => {
        vec![$(entrant($task, stringify!($method), |rtol, atol| $method::new().rtol(rtol).atol(atol)),)*]
    };
}

pub(crate) fn smooth<S, const N: usize>(task: Task<S, N>) -> Vec<Entrant>
where
    S: Jacobian<f64, N> + TaylorSeries<f64, N>,
{
    entrants!(task; Tsit5 Vern7 Vern9 Taylor Auto)
}

pub(crate) fn stiff<S: Jacobian<f64, N>, const N: usize>(task: Task<S, N>) -> Vec<Entrant> {
    entrants!(task; Rodas4 Rodas5P Radau5 Radau9 Radau13 Auto)
}

fn entrant<S, M, const N: usize>(task: Task<S, N>, name: &'static str, make: fn(f64, f64) -> M) -> Entrant
where
    M: Method<S, f64, N> + 'static,
    S: Jacobian<f64, N>,
{
    Entrant::new(OURS, name, move |tolerance| {
        let stepper = make(tolerance, task.absolute * tolerance).stepper(&task.model, 0.0, task.t1, task.x0);
        let mut stepper = stepper.map_err(|reason| reason.to_string())?;
        let end = stepper.run().map_err(|reason| reason.to_string())?;
        Ok((stepper.t(), end.into(), Some(stepper.statistics().evaluations)))
    })
}
