//! The crate `ode_solvers`.

use nalgebra::SVector;
use ode_solvers::{Dop853, OutputType, SVector as State, System};

use crate::entrant::{Entrant, Task};

struct Slopes<S: 'static, const N: usize>(Task<S, N>);

impl<S: pendulum_core::System<f64, N>, const N: usize> System<f64, State<f64, N>> for Slopes<S, N> {
    fn system(&self, t: f64, x: &State<f64, N>, slope: &mut State<f64, N>) {
        slope.data.0[0] = self.0.model.rhs(t, &SVector::from(x.data.0[0])).data.0[0];
    }
}

/// The crate either stores the points of all steps, or interpolates between them: the former is less work.
pub(crate) fn smooth<S: pendulum_core::System<f64, N>, const N: usize>(task: Task<S, N>) -> Vec<Entrant> {
    let once = move |tolerance: f64| {
        let start = State::from(task.x0.data.0[0]);
        let absolute = task.absolute * tolerance;
        let mut method = Dop853::new(Slopes(task), 0.0, task.t1, task.t1, start, tolerance, absolute);
        method.set_output(OutputType::Sparse);
        let statistics = method.integrate().map_err(|error| error.to_string())?;
        let (t, x) = (method.x_out().last(), method.y_out().last());
        let end = (t.ok_or("no points")?, x.ok_or("no points")?);
        Ok((*end.0, end.1.data.0[0], Some(statistics.num_eval as usize)))
    };
    vec![Entrant::new("ode_solvers", "DOP853", once)]
}
