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
    let error = fast.discretize(1e3).expect_err("exp(1000) overflows");
    assert!(
        error.to_string().ends_with("within 1000 s\nhelp: use a shorter period"),
        "{error}"
    );
    // The balance of such matrices does not end.
    for period in [1e155, 1e200] {
        let error = mass()
            .discretize(period)
            .expect_err("the square of the period overflows");
        assert!(matches!(error, ControlError::Growth { period: given } if given == period));
    }
}

#[test]
fn squares_of_entries_are_finite() {
    let one = SMatrix::identity();
    let mut model = mass();
    model.a[(1, 0)] = 1e160;
    let failures = [
        model.controllability().expect_err("too large"),
        model.observability().expect_err("too large"),
        model.lqr(&SMatrix::identity(), &one).expect_err("too large"),
        model.discretize(0.1).expect_err("too large"),
    ];
    for error in failures {
        assert!(matches!(error, ControlError::TooLarge { what: "A" }), "{error}");
    }
    let mut model = mass();
    model.b[1] = 1e160;
    let error = model.controllability().expect_err("too large");
    assert!(matches!(error, ControlError::TooLarge { what: "B" }), "{error}");
    // Solutions whose squares overflow are refused, instead of a residual that is zero beside infinite terms.
    let model = StateSpace::new(SMatrix::from([[1.0]]), SMatrix::from([[1e-78]]));
    let error = model.lqr(&SMatrix::zeros(), &one).expect_err("P is 2e156");
    assert!(matches!(error, ControlError::NoConvergence { .. }), "{error}");
    // Inputs that are nearly free act by more than a number holds.
    let mut model = mass();
    model.b[1] = 1e100;
    let error = model
        .lqr(&SMatrix::identity(), &SMatrix::from([[1e-200]]))
        .expect_err("overflow");
    assert!(matches!(error, ControlError::NoConvergence { .. }), "{error}");
}

#[test]
fn models_without_inputs_or_outputs_have_designs_if_they_are_stable() {
    let one = SMatrix::<f64, 2, 2>::identity();
    // The outputs are forgotten.
    let error = mass()
        .kalman(&one, &SMatrix::identity())
        .expect_err("nothing is measured");
    assert!(
        matches!(&error, ControlError::Undetectable(lost) if lost.modes.len() == 2),
        "{error}"
    );
    let free = StateSpace::<2, 0>::new(mass().a, SMatrix::zeros());
    let error = free.lqr(&one, &SMatrix::identity()).expect_err("nothing is pushed");
    assert!(
        matches!(&error, ControlError::Unstabilizable(lost) if lost.modes.len() == 2),
        "{error}"
    );
    let shown = free.with_outputs(|_, x, _| [x[0]]);
    assert_eq!(shown.c, SMatrix::from([[1.0], [0.0]]));
    assert!(shown.observability().expect("finite").is_complete());

    // With x' = -x, the integral of x^2 is x0^2 / 2.
    let stable = StateSpace::<2, 0>::new(-one, SMatrix::zeros());
    let regulator = stable.lqr(&one, &SMatrix::identity()).expect("stable");
    assert!((regulator.cost - one * 0.5).amax() < 1e-14, "{}", regulator.cost);
    let filter = stable.kalman(&one, &SMatrix::identity()).expect("stable");
    assert!((filter.covariance - one * 0.5).amax() < 1e-14, "{}", filter.covariance);
    let sampled = StateSpace::<2, 0>::sampled(one * 0.5, SMatrix::zeros(), 0.1).expect("period");
    let filter = sampled.kalman(&one, &SMatrix::identity()).expect("stable");
    assert!((filter.covariance - one / 0.75).amax() < 1e-14, "{}", filter.covariance);
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
    // Units do not matter, nor do the other entries.
    for unit in [1.0, 1e-14, 1e14] {
        assert!(matches!(lqr(skewed * unit, 1.0), ControlError::NotSymmetric { .. }));
        let unlike = SMatrix::<f64, 2, 2>::new(1e6, 0.0, 1e-5, 1e-12);
        assert!(matches!(lqr(unlike * unit, 1.0), ControlError::NotSymmetric { .. }));
        let hollow = SMatrix::<f64, 2, 2>::new(0.0, 1.0, 1.0, 1.0);
        let crossed = SMatrix::<f64, 2, 2>::new(1e-200, 1e80, 1e80, 1e-200);
        for indefinite in [indefinite, hollow, crossed, diagonal([1.0, -1.0])] {
            assert!(
                matches!(lqr(indefinite * unit, 1.0), ControlError::NotPositive { .. }),
                "{indefinite} {unit}"
            );
        }
    }
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
        "Q is not symmetric: entry (1, 0) is 0.2, and entry (0, 1) is 0.5\nhelp: use (Q + Q^T) / 2"
    );
    assert_eq!(
        lqr(diagonal([1.0, f64::NAN]), 1.0).to_string(),
        "Q has an entry that is infinite or NaN\nhelp: pass finite weights and covariances"
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
    let ControlError::NotAtRest {
        component,
        rate,
        period: None,
    } = &error
    else {
        panic!("{error}");
    };
    assert_eq!((&**component, *rate), ("x[1]", -9.81));
    assert!(
        error.to_string().contains("the rate of x[1] is -9.810e0\nhelp: "),
        "{error}"
    );
    // From sample to sample, however short the period is.
    for period in [1e-8, 0.1] {
        let sampled = model.discretize(period).expect("finite");
        let error = sampled.lqr(&SMatrix::identity(), &one).expect_err("it falls");
        assert!(
            matches!(&error, ControlError::NotAtRest { period: Some(_), .. }),
            "{error}"
        );
        assert!(error.to_string().contains(" per sample\n"), "{error}");
    }
    // The fall is not hidden by a stiff mode.
    let mut stiff = StateSpace::new(
        SMatrix::<f64, 4, 4>::zeros(),
        SMatrix::<f64, 4, 1>::new(0.0, 1.0, 0.0, 1.0),
    );
    (stiff.a[(0, 1)], stiff.a[(2, 3)], stiff.a[(3, 2)], stiff.a[(3, 3)]) = (1.0, 1.0, -1e9, -1e3);
    stiff.drift[1] = -9.81;
    for model in [stiff.discretize(1e-3).expect("finite"), stiff] {
        let error = model.lqr(&SMatrix::identity(), &one).expect_err("it falls");
        assert!(matches!(error, ControlError::NotAtRest { .. }), "{error}");
    }
}

#[test]
fn inputs_that_hold_the_state_leave_rounding_errors() {
    // A thrust of 1e12 N, and the weight.
    let mut held = mass();
    (held.u0, held.drift[1]) = ([1e12], 1e-4);
    assert!(held.lqr(&SMatrix::identity(), &SMatrix::identity()).is_ok());
}

#[test]
fn a_steady_motion_is_held_by_a_model_without_drift() {
    let mut moving = mass();
    (moving.x0, moving.u0, moving.drift[0]) = ([3.0, 2.0].into(), [0.5], 2.0);
    let still = moving.clone().without_drift();
    let one = SMatrix::identity();
    assert!(moving.lqr(&SMatrix::identity(), &one).is_err());
    let law = still.lqr(&SMatrix::identity(), &one).expect("controllable").law;
    assert_eq!((law.x0, law.u0), (moving.x0, moving.u0));
    let sampled = moving.discretize(0.1).expect("finite").without_drift();
    assert_eq!(sampled.period, Some(0.1));
    assert!(sampled.lqr(&SMatrix::identity(), &one).is_ok());
}
