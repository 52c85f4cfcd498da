//! The crate `ode_solvers`: Hairer's DOPRI5 and DOP853.

use nalgebra::SVector;
use ode_solvers::{Dop853, Dopri5, OutputType, SVector as State, System};

use crate::entrant::{Entrant, Reached, Task};

struct Slopes<S: 'static, const N: usize>(Task<S, N>);

impl<S: pendulum_core::System<f64, N>, const N: usize> System<f64, State<f64, N>> for Slopes<S, N> {
    fn system(&self, t: f64, x: &State<f64, N>, slope: &mut State<f64, N>) {
        slope.data.0[0] = self.0.model.rhs(t, &SVector::from(x.data.0[0])).data.0[0];
    }
}

/// The crate either stores the points of all steps, or interpolates at equal distances: the former is less work.
macro_rules! entrant {
    ($task:ident; $name:literal, $method:ident) => {
        Entrant::new("ode_solvers", $name, $task.t1, move |tolerance, outputs| {
            let start = State::from($task.x0.data.0[0]);
            let absolute = $task.absolute * tolerance;
            let between = outputs.first().copied().unwrap_or($task.t1);
            let mut method = $method::new(Slopes($task), 0.0, $task.t1, between, start, tolerance, absolute);
            if outputs.is_empty() {
                method.set_output(OutputType::Sparse);
            }
            let statistics = method.integrate().map_err(|error| error.to_string())?;
            let (t, x) = (method.x_out(), method.y_out());
            let evaluations = statistics.num_eval as usize;
            Ok(Reached {
                t: *t.last().ok_or("no points")?,
                x: x.last().ok_or("no points")?.data.0[0],
                evaluations: Some(evaluations),
                operations: Some($task.flops.of(evaluations, 0)),
                // the first point is the start
                along: x.iter().skip(1).take(outputs.len()).map(|x| x.data.0[0]).collect(),
            })
        })
    };
}

pub(crate) fn smooth<S: pendulum_core::System<f64, N>, const N: usize>(task: Task<S, N>) -> Vec<Entrant> {
    vec![entrant!(task; "DOPRI5", Dopri5), entrant!(task; "DOP853", Dop853)]
}
