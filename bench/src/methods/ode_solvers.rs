//! The crate `ode_solvers`: Hairer's DOPRI5 and DOP853.

use ode_solvers::{Dop853, Dopri5, OutputType, System, Vector4};
use pendulum_core::System as _;

use super::entrant::{End, Entrant, Scenes};
use super::pendulum::DoublePendulum;
use super::scene::Scene;

struct Model<'a>(&'a DoublePendulum);

impl System<f64, Vector4<f64>> for Model<'_> {
    fn system(&self, t: f64, x: &Vector4<f64>, slope: &mut Vector4<f64>) {
        let x = nalgebra::SVector::from(x.data.0[0]);
        slope.data.0[0] = self.0.rhs(t, &x).data.0[0];
    }
}

/// The crate either stores the points of all steps, or interpolates between them: the former is less work.
macro_rules! once {
    ($method:ident) => {
        |scene: &Scene, tolerance: f64| {
            let start = Vector4::from(scene.x0);
            let span = (0.0, scene.t1, scene.t1);
            let mut method = $method::new(Model(&scene.model), span.0, span.1, span.2, start, tolerance, tolerance);
            method.set_output(OutputType::Sparse);
            let statistics = method.integrate().map_err(|error| error.to_string())?;
            let (t, x) = (method.x_out().last(), method.y_out().last());
            Ok(End {
                t: *t.ok_or("no points")?,
                x: x.ok_or("no points")?.data.0[0],
                evaluations: Some(statistics.num_eval as usize),
            })
        }
    };
}

pub(crate) fn entrants() -> Vec<Entrant> {
    let by = "ode_solvers";
    vec![
        Entrant::new(by, "DOPRI5", Scenes::Smooth, once!(Dopri5)),
        Entrant::new(by, "DOP853", Scenes::Smooth, once!(Dop853)),
    ]
}
