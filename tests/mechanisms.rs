//! Ten mechanisms, declared with the macro, against reference data that was made without screws: energies, mass matrix, bias,
//! acceleration and state Jacobian at four states each.

mod common;

use common::dual::Dual;
use common::mechanisms::*;
use nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;
use serde_json::Value;

/// Largest error over largest entry. The reference has 20 digits; the rest is rounding of some hundred operations.
const TOLERANCE: f64 = 1e-12;

/// One sample of the reference.
struct Sample<const N: usize, const D: usize> {
    state: SVector<f64, N>,
    kinetic: f64,
    potential: f64,
    mass_matrix: SMatrix<f64, D, D>,
    bias: SVector<f64, D>,
    acceleration: SVector<f64, D>,
    state_jacobian: SMatrix<f64, N, N>,
}

fn samples<const N: usize, const D: usize>(name: &str) -> Vec<Sample<N, D>> {
    let data: Value = serde_json::from_str(include_str!("data/mechanisms.json")).expect("valid JSON");
    let mechanisms = data["mechanisms"].as_array().expect("a list");
    let mechanism = mechanisms
        .iter()
        .find(|m| m["name"] == name)
        .expect("a mechanism of that name");
    let samples = mechanism["samples"].as_array().expect("a list");
    assert_eq!(samples.len(), 4, "every mechanism has four samples");
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

fn assert_close<const R: usize, const C: usize>(what: &str, ours: SMatrix<f64, R, C>, reference: SMatrix<f64, R, C>) {
    let error = (ours - reference).amax() / reference.amax();
    assert!(
        error < TOLERANCE,
        "{what}: error {error:e} of the largest entry\nours {ours}reference {reference}"
    );
}

macro_rules! agrees {
    ($($test:ident: $model:ident, $dof:literal;)*) => {$(
        #[test]
        fn $test() {
            const D: usize = $dof;
            const N: usize = 2 * D;
            let model = $model::new(Default::default()).expect("the parameters are physical");
            let dual = $model::new(Default::default()).expect("the parameters are physical").cast::<Dual>();
            assert_eq!($model::DOF, D);
            for sample in samples::<N, D>(stringify!($test)) {
                let x = &sample.state;
                let scalar = |value: f64| SMatrix::<f64, 1, 1>::from([[value]]);
                assert_close("kinetic", scalar(model.kinetic(0.0, x)), scalar(sample.kinetic));
                assert_close("potential", scalar(model.potential(0.0, x)), scalar(sample.potential));
                assert_close("mass matrix", model.mass_matrix(0.0, x), sample.mass_matrix);
                assert_close("bias", model.bias(0.0, x), sample.bias);
                let rhs = model.rhs(0.0, x);
                assert_eq!(rhs.fixed_rows::<D>(0), x.fixed_rows::<D>(D), "the rates come first");
                assert_close("acceleration", rhs.fixed_rows::<D>(D).into_owned(), sample.acceleration);
                assert_close("state Jacobian", model.jacobian(0.0, x), sample.state_jacobian);
                let columns: [SVector<f64, N>; N] = std::array::from_fn(|k| {
                    let x = SVector::from_fn(|n, _| Dual::new(x[n], if n == k { 1.0 } else { 0.0 }));
                    dual.rhs(Dual::default(), &x).map(|component| component.slope)
                });
                assert_close("derivative", model.jacobian(0.0, x), SMatrix::from_columns(&columns));
                assert!(model.mass_matrix(0.0, x).cholesky().is_some(), "the mass matrix is positive definite");
            }
        }
    )*};
}

agrees! {
    eq22: Eq22, 2;
    eq22_joint: Eq22Joint, 2;
    irregular_plates: IrregularPlates, 2;
    chain5: Chain5, 5;
    cart_pole: CartPole, 2;
    furuta: Furuta, 2;
    screw_joint: ScrewJoint, 2;
    elbow3: Elbow3, 3;
    tree: Tree, 4;
    spring_pendulum_rig: SpringPendulumRig, 2;
}
