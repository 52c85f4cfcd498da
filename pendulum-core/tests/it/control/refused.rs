//! Bad input of the design of controllers.

use pendulum_core::control::{ControlError, StateSpace};
use pendulum_core::nalgebra::SMatrix;

use super::diagonal;

fn mass() -> StateSpace<2, 1> {
    StateSpace::new(
        SMatrix::<f64, 2, 2>::new(0.0, 1.0, 0.0, 0.0),
        SMatrix::from([[0.0, 1.0]]),
    )
}

fn lqr(q: SMatrix<f64, 2, 2>, r: f64) -> ControlError<2> {
    mass().lqr(&q, &SMatrix::from([[r]])).expect_err("refused")
}

#[test]
fn periods_are_positive_and_finite() {
    for period in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        assert!(
            matches!(mass().discretize(period), Err(ControlError::Period(_))),
            "{period}"
        );
        let sampled = StateSpace::sampled(mass().a, mass().b, period);
        assert!(matches!(sampled, Err(ControlError::Period(_))), "{period}");
    }
    let sampled = mass().discretize(0.1).expect("finite");
    assert!(matches!(sampled.discretize(0.2), Err(ControlError::Sampled { period }) if period == 0.1));
    let fast = StateSpace::new(SMatrix::from([[1.0]]), SMatrix::from([[1.0]]));
    assert!(matches!(
        fast.discretize(1e3),
        Err(ControlError::NotFinite { what: "A" })
    ));
}

#[test]
fn weights_are_symmetric_and_positive() {
    let skewed = SMatrix::<f64, 2, 2>::new(1.0, 0.5, 0.2, 1.0);
    assert!(matches!(
        lqr(skewed, 1.0),
        ControlError::NotSymmetric {
            what: "Q",
            entry: [1, 0],
            values: [0.2, 0.5]
        }
    ));
    let indefinite = SMatrix::<f64, 2, 2>::new(1.0, 2.0, 2.0, 1.0);
    let ControlError::NotPositive {
        what: "Q",
        strictly: false,
        eigenvalue,
    } = lqr(indefinite, 1.0)
    else {
        panic!("Q is indefinite")
    };
    assert!((eigenvalue + 1.0).abs() < 1e-12);
    assert!(matches!(
        lqr(diagonal([1.0, -1e-20]), 1.0),
        ControlError::NotPositive { what: "Q", .. }
    ));
    for r in [0.0, -1.0] {
        assert!(matches!(
            lqr(diagonal([1.0, 1.0]), r),
            ControlError::NotPositive {
                what: "R",
                strictly: true,
                ..
            }
        ));
    }
    assert!(matches!(
        lqr(diagonal([1.0, f64::NAN]), 1.0),
        ControlError::NotFinite { what: "Q" }
    ));
    assert!(matches!(
        lqr(diagonal([1.0, 1.0]), f64::INFINITY),
        ControlError::NotFinite { what: "R" }
    ));
    // Weights of any units are judged alike.
    assert!(mass().lqr(&diagonal([1e-18, 1e-12]), &SMatrix::from([[1e-20]])).is_ok());
    let message = lqr(skewed, 1.0).to_string();
    assert_eq!(
        message,
        "Q is not symmetric: entry (1, 0) is 0.2, and entry (0, 1) is 0.5; use (Q + Q^T) / 2"
    );
}

#[test]
fn models_are_finite_and_at_rest() {
    let mut model = mass();
    model.a[(1, 0)] = f64::NAN;
    let one = SMatrix::identity();
    assert!(matches!(
        model.lqr(&SMatrix::identity(), &one),
        Err(ControlError::NotFinite { what: "A" })
    ));
    assert!(matches!(
        model.controllability(),
        Err(ControlError::NotFinite { what: "A" })
    ));
    assert!(matches!(
        model.observability(),
        Err(ControlError::NotFinite { what: "A" })
    ));
    assert!(matches!(
        model.discretize(0.1),
        Err(ControlError::NotFinite { what: "A" })
    ));
    let mut model = mass();
    model.drift[1] = -9.81;
    let error = model.lqr(&SMatrix::identity(), &one).expect_err("it falls");
    assert!(matches!(&error, ControlError::NotAtRest { component, rate } if component == "x[1]" && *rate == -9.81));
}
