//! Models with inputs.

use approx::assert_abs_diff_eq;
use pendulum_core::prelude::*;
use pendulum_core::{Plant, PlantJacobian, Real, WithInputs};

/// A pushed cart of mass 2 kg; the state is its position and velocity.
struct Cart;

impl<T: Real> Plant<T, 2> for Cart {
    type Given = [T; 1];

    fn eval(&self, _t: T, x: &SVector<T, 2>, u: &[T; 1]) -> SVector<T, 2> {
        SVector::from([x[1], u[0] * T::from_f64(0.5)])
    }
}

impl<T: Real> PlantJacobian<T, 2> for Cart {
    fn eval_with_jacobian(&self, t: T, x: &SVector<T, 2>, u: &[T; 1]) -> (SVector<T, 2>, SMatrix<T, 2, 2>) {
        let (zero, one) = (T::default(), T::from_f64(1.0));
        (self.eval(t, x, u), SMatrix::from([[zero, zero], [one, zero]]))
    }
}

impl<T: Real> Controlled<T, 2, 1> for Cart {
    type Inputs = [T; 1];

    fn input_jacobian(&self, _t: T, _x: &SVector<T, 2>, _u: &[T; 1]) -> SMatrix<T, 2, 1> {
        SMatrix::from([[T::default(), T::from_f64(0.5)]])
    }
}

#[test]
fn a_law_for_the_inputs_closes_the_loop() {
    // Only a spring: x'' = -k/m x with k = 8 N/m oscillates at 2 rad/s.
    let spring = WithInputs::new(Cart, |_t: f64, x: &SVector<f64, 2>| [-8.0 * x[0]]);
    let method = Rk45::new().rtol(1e-10).atol(1e-10);
    let solution = method.solve(&spring, 0.0, 1.0, [1.0, 0.0]).expect("regular");
    let exact = SVector::from([2.0_f64.cos(), -2.0 * 2.0_f64.sin()]);
    assert_abs_diff_eq!(solution.end(), exact, epsilon = 10e-10);
}
