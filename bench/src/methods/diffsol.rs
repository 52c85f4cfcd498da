//! The crate `diffsol`, on nalgebra's matrices.

use std::hint::black_box;

use diffsol::{NalgebraLU, NalgebraMat, OdeBuilder, OdeSolverMethod, OdeSolverStopReason};
use nalgebra::SVector;
use pendulum_core::{Jacobian, System};

use super::entrant::{End, Entrant, Scenes};

/// Takes step after step without recording them; the problem is set up once for all repetitions. The crate needs
/// products of the Jacobian with a vector.
macro_rules! entrant {
    ($name:literal, $scenes:ident, $($method:tt)*) => { Entrant {
        by: "diffsol",
        method: $name,
        scenes: Scenes::$scenes,
        integrate: Box::new(|scene, tolerance, times| {
            let (model, x0) = (scene.model, scene.x0);
            let state = |x: &[f64]| SVector::<f64, 4>::from_column_slice(x);
            let problem = OdeBuilder::<NalgebraMat<f64>>::new()
                .rtol(tolerance)
                .atol([tolerance])
                .rhs_implicit(
                    move |x, _, t, slope| slope.copy_from_slice(model.rhs(t, &state(x)).as_slice()),
                    move |x, _, t, v, product| {
                        product.copy_from_slice((model.jacobian(t, &state(x)) * state(v)).as_slice());
                    },
                )
                .init(move |_, _, x| x.copy_from_slice(&x0), 4)
                .build()
                .map_err(|error| error.to_string())?;
            let once = || {
                let mut method = problem.$($method)*().map_err(|error| error.to_string())?;
                method.set_stop_time(scene.t1).map_err(|error| error.to_string())?;
                loop {
                    let reason = method.step().map_err(|error| error.to_string())?;
                    if let OdeSolverStopReason::TstopReached = reason {
                        break;
                    }
                }
                let end = method.state();
                Ok(End {
                    t: end.t,
                    x: std::array::from_fn(|component| end.y[component]),
                    evaluations: None,
                })
            };
            for _ in 1..times {
                black_box(once()?);
            }
            once()
        }),
    } };
}

pub(crate) fn entrants() -> Vec<Entrant> {
    vec![
        entrant!("TSIT45", Smooth, tsit45),
        entrant!("TR-BDF2", Stiff, tr_bdf2::<NalgebraLU<f64>>),
        entrant!("ESDIRK34", Stiff, esdirk34::<NalgebraLU<f64>>),
        entrant!("BDF", Stiff, bdf::<NalgebraLU<f64>>),
    ]
}
