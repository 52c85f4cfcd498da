//! Products of weights with derivatives of the right-hand side, against its Jacobians.

use nalgebra::SVector;
use pendulum_core::dual::Dual;
use pendulum_core::prelude::*;

use crate::states::{
    Linkage, LinkageParams, Lorenz, LorenzParams, Mixed, MixedParams, Motor, MotorInputs, MotorParams, Servo,
    ServoParams,
};

/// Largest difference relative to the largest number, below which two results agree.
const TOLERANCE: f64 = 1e-13;

#[track_caller]
fn agree<const N: usize>(what: &str, ours: &SVector<f64, N>, theirs: &SVector<f64, N>) {
    let scale = theirs.amax().max(1.0);
    assert!(
        (ours - theirs).amax() < TOLERANCE * scale,
        "{what}: {ours} and not {theirs}"
    );
}

/// Weights and a direction without symmetry.
fn numbers<const N: usize>(first: f64) -> SVector<f64, N> {
    SVector::from_fn(|n, _| (first + 1.7 * n as f64).sin() + 0.3)
}

/// Checks the routines of a scene without inputs. The derivative of `J^T w` along a direction is that of dual numbers.
macro_rules! check {
    ($model:expr, $dual:expr, $t:expr, $x:expr) => {{
        let (model, x) = ($model, SVector::from($x));
        let (weights, direction) = (numbers(0.4), numbers(2.1));
        let (by_state, by_parameters) = model.adjoint($t, &x, &weights);
        agree("by state", &by_state, &(model.jacobian($t, &x).transpose() * weights));
        let jacobian = model.parameter_jacobian($t, &x);
        agree("by parameters", &by_parameters, &(jacobian.transpose() * weights));
        let moved = x.zip_map(&direction, |x, d| Dual { value: x, slopes: [d] });
        let jacobian = $dual.jacobian(Dual::from_f64($t), &moved).map(|entry| entry.slopes[0]);
        let product = model.hessian_product($t, &x, &weights, &direction);
        agree("second derivative", &product, &(jacobian.transpose() * weights));
    }};
}

#[test]
fn equations_without_bodies() {
    let model = Lorenz::new(LorenzParams::default()).expect("valid");
    check!(model, model.cast::<Dual<f64, 1>>(), 0.0, [1.5, -2.0, 20.0]);
}

#[test]
fn a_closed_loop() {
    let model = Linkage::new(LinkageParams::default()).expect("physical");
    check!(model, model.cast::<Dual<f64, 1>>(), 0.0, [0.7, 2.0, 1.5]);
}

#[test]
fn a_ball_joint_on_a_driven_pivot() {
    let model = Mixed::new(MixedParams::default()).expect("physical");
    let x = [0.8, 0.4, 0.4, 0.2, 0.5, -0.7, 1.1, 2.5];
    check!(model, model.cast::<Dual<f64, 1>>(), 0.7, x);
}

#[test]
fn dry_friction_that_slips() {
    let model = Servo::new(ServoParams::default()).expect("physical");
    check!(model, model.cast::<Dual<f64, 1>>(), 0.0, [0.3, 2.0, 1.5, 0.1]);
}

#[test]
fn inputs() {
    let model = Motor::new(MotorParams::default()).expect("physical");
    let (x, u) = (SVector::from([0.3, -1.2, 2.0, 0.1]), MotorInputs { u: 6.0 });
    let weights = numbers(0.4);
    let (by_state, by_parameters, by_input) = model.adjoint(0.0, &x, &u, &weights);
    let (_, jacobian) = model.eval_with_jacobian(0.0, &x, &u);
    agree("by state", &by_state, &(jacobian.transpose() * weights));
    let jacobian = model.parameter_jacobian(0.0, &x, &u);
    agree("by parameters", &by_parameters, &(jacobian.transpose() * weights));
    let jacobian = model.input_jacobian(0.0, &x, &u);
    agree("by input", &by_input, &(jacobian.transpose() * weights));
    let (by_state, by_input) = model.hessian_product(0.0, &x, &u, &weights, &numbers(2.1));
    assert_eq!(by_input, SVector::from([0.0]));
    let direction = numbers::<5>(2.1);
    let moved = SVector::<Dual<f64, 1>, 4>::from_fn(|n, _| Dual {
        value: x[n],
        slopes: [direction[n]],
    });
    let u = MotorInputs {
        u: Dual {
            value: 6.0,
            slopes: [direction[4]],
        },
    };
    let (_, jacobian) = model
        .cast::<Dual<f64, 1>>()
        .eval_with_jacobian(Dual::from_f64(0.0), &moved, &u);
    let jacobian = jacobian.map(|entry| entry.slopes[0]);
    agree("second derivative", &by_state, &(jacobian.transpose() * weights));
}
