//! Reference data of models (energies, mass matrix, bias, acceleration and state Jacobian), derived without screws.

use nalgebra::{SMatrix, SVector};
use serde_json::Value;

/// Sample of the reference data.
pub struct Sample<const N: usize, const D: usize> {
    pub state: SVector<f64, N>,
    pub kinetic: f64,
    pub potential: f64,
    pub mass_matrix: SMatrix<f64, D, D>,
    pub bias: SVector<f64, D>,
    pub acceleration: SVector<f64, D>,
    pub state_jacobian: SMatrix<f64, N, N>,
}

/// Loads the samples of a mechanism or a robot.
pub fn samples<const N: usize, const D: usize>(name: &str) -> Vec<Sample<N, D>> {
    let files = [
        include_str!("../data/mechanisms.json"),
        include_str!("../data/robots.json"),
    ];
    let lists = files.map(|file| serde_json::from_str::<Value>(file).expect("valid JSON"));
    let mut mechanisms = lists
        .iter()
        .flat_map(|list| list["mechanisms"].as_array().expect("a list"));
    let mechanism = mechanisms
        .find(|m| m["name"] == name)
        .expect("a mechanism of that name");
    let samples = mechanism["samples"].as_array().expect("a list");
    assert!(samples.len() >= 3, "every mechanism has some samples");
    samples.iter().map(sample).collect()
}

fn sample<const N: usize, const D: usize>(sample: &Value) -> Sample<N, D> {
    let entry = |row: &Value, n: usize| number(&row[n]);
    Sample {
        state: SVector::from_fn(|n, _| {
            if n < D {
                entry(&sample["q"], n)
            } else {
                entry(&sample["qd"], n - D)
            }
        }),
        kinetic: number(&sample["kinetic"]),
        potential: number(&sample["potential"]),
        mass_matrix: SMatrix::from_fn(|i, j| entry(&sample["mass_matrix"][i], j)),
        bias: SVector::from_fn(|i, _| entry(&sample["bias"], i)),
        acceleration: SVector::from_fn(|i, _| entry(&sample["acceleration"], i)),
        state_jacobian: SMatrix::from_fn(|i, j| entry(&sample["state_jacobian"][i], j)),
    }
}

fn number(value: &Value) -> f64 {
    match value {
        Value::String(text) => text.parse().expect("a number"),
        other => other.as_f64().expect("a number"),
    }
}

/// Asserts that the largest error is below `tolerance` times the largest entry.
pub fn assert_close<const R: usize, const C: usize>(
    what: &str,
    tolerance: f64,
    ours: SMatrix<f64, R, C>,
    reference: SMatrix<f64, R, C>,
) {
    let error = (ours - reference).amax() / reference.amax();
    assert!(
        error < tolerance,
        "{what}: error {error:e} of the largest entry\nours {ours}reference {reference}"
    );
}

/// Defines a test for each model that compares all generated functions with the reference, to `TOLERANCE`.
#[macro_export]
macro_rules! agrees {
    ($($test:ident: $model:ident, $dof:literal;)*) => {$(
        #[test]
        fn $test() {
            const D: usize = $dof;
            const N: usize = 2 * D;
            let model = $model::new(Default::default()).expect("the parameters are physical");
            let dual = $model::new(Default::default())
                .expect("the parameters are physical")
                .cast::<$crate::dual::Dual>();
            assert_eq!($model::DOF, D);
            for sample in $crate::reference::samples::<N, D>(stringify!($test)) {
                let (x, tolerance) = (&sample.state, TOLERANCE);
                let scalar = |value: f64| SMatrix::<f64, 1, 1>::from([[value]]);
                $crate::reference::assert_close(
                    "kinetic",
                    tolerance,
                    scalar(model.kinetic(0.0, x)),
                    scalar(sample.kinetic),
                );
                $crate::reference::assert_close(
                    "potential",
                    tolerance,
                    scalar(model.potential(0.0, x)),
                    scalar(sample.potential),
                );
                $crate::reference::assert_close(
                    "mass matrix",
                    tolerance,
                    model.mass_matrix(0.0, x),
                    sample.mass_matrix,
                );
                $crate::reference::assert_close("bias", tolerance, model.bias(0.0, x), sample.bias);
                let rates = x.fixed_rows::<D>(D).into_owned();
                $crate::reference::assert_close(
                    "momentum",
                    tolerance,
                    model.momentum(0.0, x),
                    sample.mass_matrix * rates,
                );
                // inverse dynamics is 0 at the free acceleration, and so `M qdd` at twice the free acceleration
                let taken = model.inverse_dynamics(0.0, x, &(2.0 * sample.acceleration));
                $crate::reference::assert_close(
                    "inverse dynamics",
                    tolerance,
                    taken,
                    sample.mass_matrix * sample.acceleration,
                );
                let rhs = model.rhs(0.0, x);
                assert_eq!(rhs.fixed_rows::<D>(0), x.fixed_rows::<D>(D), "the rates come first");
                $crate::reference::assert_close(
                    "acceleration",
                    tolerance,
                    rhs.fixed_rows::<D>(D).into_owned(),
                    sample.acceleration,
                );
                let (together, jacobian) = model.rhs_and_jacobian(0.0, x);
                $crate::reference::assert_close("right-hand side", tolerance, together, rhs);
                assert_eq!(jacobian, model.jacobian(0.0, x));
                $crate::reference::assert_close("state Jacobian", tolerance, jacobian, sample.state_jacobian);
                let columns: [SVector<f64, N>; N] = std::array::from_fn(|k| {
                    let x = SVector::from_fn(|n, _| $crate::dual::Dual::new(x[n], if n == k { 1.0 } else { 0.0 }));
                    dual.rhs($crate::dual::Dual::default(), &x).map(|component| component.slope)
                });
                $crate::reference::assert_close(
                    "derivative",
                    tolerance,
                    model.jacobian(0.0, x),
                    SMatrix::from_columns(&columns),
                );
                assert!(model.mass_matrix(0.0, x).cholesky().is_some(), "the mass matrix is positive definite");
            }
        }
    )*};
}
