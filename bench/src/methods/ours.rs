//! Our own methods.

use pendulum_core::prelude::*;

use super::entrant::{End, Entrant, OURS, Scenes};
use super::lanes::Together;

/// Entrants by name, scenes, and the method for a tolerance, one per line.
macro_rules! methods {
    ($($name:literal, $scenes:ident: $method:expr;)*) => {
        vec![$(
            Entrant::new(OURS, $name, Scenes::$scenes, |scene, tolerance| {
                let method: fn(f64) -> _ = $method;
                let stepper = method(tolerance).stepper(&scene.model, 0.0, scene.t1, scene.x0);
                let mut stepper = stepper.map_err(|reason| reason.to_string())?;
                while stepper.step().map_err(|reason| reason.to_string())?.is_some() {}
                Ok(End {
                    t: stepper.t(),
                    x: stepper.x().into(),
                    evaluations: Some(stepper.statistics().evaluations),
                })
            }),
        )*]
    };
}

/// Like `methods`, but for ensembles in lanes.
macro_rules! ensembles {
    ($($name:literal: $method:expr;)*) => {
        vec![$(
            Together {
                by: OURS,
                method: $name,
                integrate: Box::new(|scene, tolerance, starts| {
                    let method: fn(f64) -> _ = $method;
                    let ends = method(tolerance).ensemble(&[scene.model], 0.0, scene.t1, starts);
                    ends.map_err(|error| error.to_string())
                }),
            },
        )*]
    };
}

/// All methods. For fixed steps, the step size is such that an error of order 4 is about the tolerance.
pub(crate) fn entrants() -> Vec<Entrant> {
    methods! {
        "Rk4", Smooth: |tolerance| Rk4::new(tolerance.powf(0.25));
        "Rk45", All: |tolerance| Rk45::new().rtol(tolerance).atol(tolerance);
        "Tsit5", Smooth: |tolerance| Tsit5::new().rtol(tolerance).atol(tolerance);
        "Vern7", Smooth: |tolerance| Vern7::new().rtol(tolerance).atol(tolerance);
        "Vern9", Smooth: |tolerance| Vern9::new().rtol(tolerance).atol(tolerance);
        "Taylor", Smooth: |tolerance| Taylor::new().rtol(tolerance).atol(tolerance);
        "Rodas4", Stiff: |tolerance| Rodas4::new().rtol(tolerance).atol(tolerance);
        "Rodas5P", Stiff: |tolerance| Rodas5P::new().rtol(tolerance).atol(tolerance);
        "Radau5", Stiff: |tolerance| Radau5::new().rtol(tolerance).atol(tolerance);
        "Auto", All: |tolerance| Auto::new().rtol(tolerance).atol(tolerance);
    }
}

pub(crate) fn ensembles() -> Vec<Together> {
    ensembles! {
        "Rk4": |tolerance| Rk4::new(tolerance.powf(0.25));
        "Rk45": |tolerance| Rk45::new().rtol(tolerance).atol(tolerance);
        "Tsit5": |tolerance| Tsit5::new().rtol(tolerance).atol(tolerance);
        "Vern7": |tolerance| Vern7::new().rtol(tolerance).atol(tolerance);
        "Vern9": |tolerance| Vern9::new().rtol(tolerance).atol(tolerance);
        "Taylor": |tolerance| Taylor::new().rtol(tolerance).atol(tolerance);
    }
}
