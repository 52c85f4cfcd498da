//! Equations by hand in every number type: their derivatives, and their lanes.

use nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;
use pendulum_core::real::Real;
use pendulum_core::system::{Equations, EquationsSystem, FnSystem};

/// A follower of an oscillation in time, and a product.
#[derive(Clone, Debug, PartialEq)]
struct Follower {
    stiffness: f64,
}

impl Equations<2> for Follower {
    fn rhs<T: Real>(&self, t: T, x: &SVector<T, 2>) -> SVector<T, 2> {
        let stiffness = T::from_f64(self.stiffness);
        SVector::from([x[0] * x[1], stiffness * (t.sin_cos().1 - x[1])])
    }
}

fn follower(stiffness: f64) -> EquationsSystem<Follower> {
    EquationsSystem(Follower { stiffness })
}

#[test]
fn derivatives_are_exact() {
    let (system, t, x) = (follower(3.0), 0.7, SVector::from([2.0, 5.0]));
    let (rhs, jacobian) = system.rhs_and_jacobian(t, &x);
    assert_eq!(rhs, system.rhs(t, &x));
    assert_eq!(jacobian, system.jacobian(t, &x));
    assert_eq!(jacobian, SMatrix::<f64, 2, 2>::new(5.0, 2.0, 0.0, -3.0));
    let expected = -3.0 * Real::sin_cos(t).0;
    assert_eq!(system.time_derivative(t, &x), SVector::from([0.0, expected]));
}

#[test]
fn a_stiff_method_has_the_bits_of_derivatives_by_hand() {
    let by_hand = FnSystem::with_jacobian(
        |t: f64, x: &SVector<f64, 2>| SVector::from([x[0] * x[1], 3.0 * (Real::sin_cos(t).1 - x[1])]),
        |_t, x| SMatrix::<f64, 2, 2>::new(x[1], x[0], 0.0, -3.0),
    )
    .with_time_derivative(|t: f64, _x| SVector::from([0.0, -3.0 * Real::sin_cos(t).0]));
    let start = [1.0, 0.0];
    let expected = Rodas5P::new().solve(&by_hand, 0.0, 4.0, start).expect("regular");
    let found = Rodas5P::new().solve(&follower(3.0), 0.0, 4.0, start).expect("regular");
    assert_eq!(found.end(), expected.end());
    assert_eq!(found.statistics(), expected.statistics());
}

#[test]
fn each_of_an_ensemble_has_the_bits_that_it_has_alone() {
    let models = vec![follower(3.0); 5];
    let starts = [0.5, 1.0, 1.5, 2.0, -3.0].map(|x| SVector::from([x, 0.0]));
    macro_rules! same {
        ($($method:expr),*) => {$(
            let ends = $method.ensemble(&models, 0.0, 2.0, &starts).expect("regular");
            for ((model, start), end) in models.iter().zip(starts).zip(ends) {
                assert_eq!($method.solve(model, 0.0, 2.0, start).expect("regular").end(), end);
            }
        )*};
    }
    same!(
        Vern7::new(),
        Rodas5P::new(),
        Auto::new(),
        Rk4::new(1e-2),
        Taylor::new().rtol(1e-10).atol(1e-10)
    );
}

#[test]
fn an_ensemble_has_equal_equations() {
    let models = [follower(3.0), follower(3.0), follower(2.0)];
    let error = Vern7::new().ensemble(&models, 0.0, 2.0, &[SVector::from([1.0, 0.0]); 3]);
    let text = error.expect_err("other constants").to_string();
    assert!(text.contains("equations by hand"), "{text}");
}

/// A point that falls towards the edge of the domain of a square root.
#[derive(Clone, Debug, PartialEq)]
struct Falling;

impl Equations<1> for Falling {
    fn rhs<T: Real>(&self, _t: T, x: &SVector<T, 1>) -> SVector<T, 1> {
        SVector::from([-x[0].sqrt()])
    }
}

#[test]
fn a_motion_without_a_series_is_an_error() {
    // x = (1 - t/2)^2
    let method = Taylor::new().rtol(1e-9).atol(1e-9);
    let before = method
        .solve(&EquationsSystem(Falling), 0.0, 1.9, [1.0])
        .expect("regular");
    assert!((before.end()[0] - 0.0025).abs() < 1e-8);
    method
        .solve(&EquationsSystem(Falling), 0.0, 1.0, [0.0])
        .expect_err("at the edge");
}

/// `|x|` in the right-hand side, and the sign of `x`: the motion passes zero once.
#[derive(Clone, Debug, PartialEq)]
struct Kinked;

impl Equations<2> for Kinked {
    fn rhs<T: Real>(&self, _t: T, x: &SVector<T, 2>) -> SVector<T, 2> {
        SVector::from([T::from_f64(1.0), x[0].abs() + x[0].signum()])
    }
}

#[test]
fn steps_across_a_kink_are_as_precise_as_tolerated() {
    let solution = Taylor::new()
        .rtol(1e-9)
        .atol(1e-9)
        .solve(&EquationsSystem(Kinked), 0.0, 3.0, [-1.0, 0.0]);
    // from -1 to 0: 1/2 - 1; from 0 to 2: 2 + 2
    assert!((solution.expect("regular").end()[1] - 3.5).abs() < 1e-6);
}

/// A right-hand side that integrates another one, from a start that is constant for the outer one.
#[derive(Clone, Debug, PartialEq)]
struct Nested;

impl Equations<1> for Nested {
    fn rhs<T: Real>(&self, _t: T, x: &SVector<T, 1>) -> SVector<T, 1> {
        let doubled = x[0] + x[0];
        let inner = Taylor::new()
            .rtol(1e-12)
            .atol(1e-12)
            .solve(&EquationsSystem(Falling), 0.0, 1.0, [1.0]);
        let quarter = inner.expect("regular").end()[0];
        SVector::from([doubled * T::from_f64(quarter)])
    }
}

#[test]
fn a_right_hand_side_may_integrate_another() {
    let end = Taylor::new()
        .rtol(1e-11)
        .atol(1e-11)
        .solve(&EquationsSystem(Nested), 0.0, 1.0, [1.0]);
    assert!((end.expect("regular").end()[0] - 0.5_f64.exp()).abs() < 1e-9);
}
