//! The crate `diffsol`, on nalgebra's matrices.

use std::hint::black_box;

use diffsol::{NalgebraLU, NalgebraMat, NalgebraVec, OdeBuilder, OdeSolverMethod, OdeSolverStopReason};

use crate::entrant::{End, Entrant, Request, Task, due, output_times};
use crate::model::Model;

/// Motion without its type.
#[derive(Clone, Copy)]
struct Span {
    model: &'static Model,
    x0: &'static [f64],
    t1: f64,
    absolute: f64,
}

impl Span {
    fn new<S, const N: usize>(model: &'static Model, task: Task<S, N>) -> Self {
        Self {
            model,
            x0: task.x0.as_slice(),
            t1: task.t1,
            absolute: task.absolute,
        }
    }
}

/// Takes step after step without recording them; the problem is set up once for all repetitions. The crate needs
/// products of the Jacobian with a vector.
macro_rules! entrant {
    ($span:ident; $name:literal, $($method:tt)*) => { Entrant {
        by: "diffsol",
        method: $name,
        integrate: Box::new(move |request| {
            let (Span { model, x0, t1, absolute }, Request { tolerance, times, outputs }) = ($span, request);
            let outputs = output_times(t1, outputs);
            let problem = OdeBuilder::<NalgebraMat<f64>>::new()
                .rtol(tolerance)
                .atol(vec![absolute * tolerance; model.length])
                .rhs_implicit(
                    move |x: &[f64], _, _, slope: &mut [f64]| (model.rhs)(x, slope),
                    move |x: &[f64], _, _, v: &[f64], product: &mut [f64]| (model.product)(x, v, product),
                )
                .init(move |_, _, x: &mut [f64]| x.copy_from_slice(x0), model.length)
                .build()
                .map_err(|error| error.to_string())?;
            let once = || {
                let mut method = problem.$($method)*().map_err(|error| error.to_string())?;
                method.set_stop_time(t1).map_err(|error| error.to_string())?;
                let state = |y: &NalgebraVec<f64>| (0..model.length).map(|component| y[component]).collect();
                let mut along = Vec::new();
                for _ in 0..STEPS {
                    let reason = method.step().map_err(|error| error.to_string())?;
                    while let Some(t) = due(&outputs, &along, method.state().t) {
                        along.push(state(&method.interpolate(t).map_err(|error| error.to_string())?));
                    }
                    if let OdeSolverStopReason::TstopReached = reason {
                        let end = method.state();
                        return Ok(End { t: end.t, x: state(end.y), evaluations: None, operations: None, along });
                    }
                }
                Err("too many steps".to_owned())
            };
            for _ in 1..times {
                black_box(once()?);
            }
            once()
        }),
    } };
}

/// Maximum number of steps, more than any useful setting needs.
const STEPS: usize = 1_000_000;

pub(crate) fn smooth<S, const N: usize>(model: &'static Model, task: Task<S, N>) -> Vec<Entrant> {
    let span = Span::new(model, task);
    vec![tsit45(span)]
}

pub(crate) fn stiff<S, const N: usize>(model: &'static Model, task: Task<S, N>) -> Vec<Entrant> {
    let span = Span::new(model, task);
    vec![tr_bdf2(span), esdirk34(span), bdf(span)]
}

fn tsit45(span: Span) -> Entrant {
    entrant!(span; "TSIT45", tsit45)
}

fn tr_bdf2(span: Span) -> Entrant {
    entrant!(span; "TR-BDF2", tr_bdf2::<NalgebraLU<f64>>)
}

fn esdirk34(span: Span) -> Entrant {
    entrant!(span; "ESDIRK34", esdirk34::<NalgebraLU<f64>>)
}

fn bdf(span: Span) -> Entrant {
    entrant!(span; "BDF", bdf::<NalgebraLU<f64>>)
}
