//! Scenes so small that the absolute tolerance hides their motion.

use std::f64::consts::TAU;

use pendulum_core::prelude::*;

/// `x'' = -x` and, uncoupled, `y'' = -y`.
fn springs() -> impl System<f64, 4> {
    FnSystem(|_t: f64, x: &SVector<f64, 4>| SVector::from([x[2], x[3], -x[0], -x[1]]))
}

/// Components that are reported after some periods from the state `x0`, and the relative error of the state.
fn listed(method: &impl Method<FnSystem<Spring>, f64, 2>, x0: [f64; 2]) -> (Vec<usize>, f64) {
    let spring: FnSystem<Spring> = FnSystem(|_t, x| SVector::from([x[1], -x[0]]));
    let solution = method.solve(&spring, 0.0, 20.0 * TAU, x0).expect("regular");
    let error = (solution.end() - SVector::from(x0)).norm() / SVector::from(x0).norm();
    let components = solution.below_tolerance().iter().map(|below| below.component).collect();
    (components, error)
}

type Spring = fn(f64, &SVector<f64, 2>) -> SVector<f64, 2>;

#[test]
fn a_small_motion_is_reported_where_it_is_wrong() {
    // at the default absolute tolerance, 1e-9
    for (size, is_listed) in [
        (1e-12, true),
        (1e-9, true),
        (5e-9, true),
        (9e-8, true),
        (2e-7, true),
        (2e-6, false),
        (1.0, false),
    ] {
        let (components, error) = listed(&Rk45::new(), [size, 0.0]);
        assert_eq!(
            components,
            if is_listed { vec![0, 1] } else { vec![] },
            "{size}: {error}"
        );
        if size <= 5e-9 {
            assert!(error > 1.0, "{size}: {error}");
        }
        if !is_listed {
            assert!(error < 0.02, "{size}: {error}");
        }
    }
    // the suggested tolerance gives the relative accuracy of a large motion
    let spring: FnSystem<Spring> = FnSystem(|_t, x| SVector::from([x[1], -x[0]]));
    let below = Rk45::new()
        .solve(&spring, 0.0, 20.0 * TAU, [1e-9, 0.0])
        .expect("regular")
        .below_tolerance();
    assert!((below[0].largest / 1e-9 - 1.0).abs() < 1.0 || below[0].largest > 1e-9);
    assert_eq!(below[0].atol, 1e-6 * below[0].largest);
    let text = below[0].to_string();
    assert!(text.starts_with("x[0] is ") && text.contains("set `atol("), "{text}");
    let (components, error) = listed(&Rk45::new().atol(1e-15), [1e-9, 0.0]);
    assert!(components.is_empty() && error < 1e-3, "{error}");
    // fixed steps have no tolerance
    assert_eq!(listed(&Rk4::new(0.01), [1e-9, 0.0]).0, [0; 0]);
    // no report if the relative tolerance is that coarse
    assert_eq!(listed(&Rk45::new().rtol(0.01).atol(1e-9), [1e-6, 0.0]).0, [0; 0]);
}

#[test]
fn what_is_small_beside_others_is_reported_only_where_it_was_asked_for() {
    let of = |x0: [f64; 4]| {
        let solution = Tsit5::new().solve(&springs(), 0.0, 10.0, x0).expect("regular");
        solution
            .below_tolerance()
            .iter()
            .map(|below| below.component)
            .collect::<Vec<_>>()
    };
    // at rest, next to moving and to resting components
    assert_eq!(of([1.0, 0.0, 0.0, 0.0]), [0; 0]);
    assert_eq!(of([0.0; 4]), [0; 0]);
    // a small motion next to a large one, and rounding errors
    assert_eq!(of([1.0, 1e-9, 0.0, 0.0]), [1]);
    assert_eq!(of([1.0, 1e-16, 0.0, 0.0]), [0; 0]);
    assert_eq!(of([1e-9, 0.0, 0.0, 0.0]), [0, 2]);
    // a small perturbation from rest by a large motion
    let coupled = FnSystem(|_t: f64, x: &SVector<f64, 4>| SVector::from([x[2], x[3], -x[0], 1e-10 * x[0] - x[1]]));
    let solution = Tsit5::new()
        .solve(&coupled, 0.0, 10.0, [1.0, 0.0, 0.0, 0.0])
        .expect("regular");
    assert!(solution.end()[1].abs() > 1e-11 && solution.below_tolerance().is_empty());
    // from rest, by small forces
    let pushed = FnSystem(|t: f64, x: &SVector<f64, 2>| SVector::from([x[1], 1e-9 * t.cos()]));
    let solution = Tsit5::new().solve(&pushed, 0.0, 10.0, [0.0, 0.0]).expect("regular");
    assert_eq!(solution.below_tolerance().len(), 2);
    // a decay to zero
    let decay = FnSystem(|_t: f64, x: &SVector<f64, 1>| -x);
    let solution = Tsit5::new().solve(&decay, 0.0, 100.0, [1.0]).expect("regular");
    assert!(solution.end()[0].abs() < 1e-8 && solution.below_tolerance().is_empty());
    // an empty span
    let solution = Tsit5::new().solve(&decay, 0.0, 0.0, [1e-9]).expect("regular");
    assert!(solution.below_tolerance().is_empty());
}

#[test]
fn numbers_of_single_precision_have_a_tolerance_of_their_own() {
    let spring = FnSystem(|_t: f32, x: &SVector<f32, 2>| SVector::from([x[1], -x[0]]));
    let solution = Rk45::new().solve(&spring, 0.0, 10.0, [1e-7, 0.0]).expect("regular");
    assert_eq!(solution.below_tolerance().len(), 2);
    let solution = Rk45::new().solve(&spring, 0.0, 10.0, [1.0, 0.0]).expect("regular");
    assert!(solution.below_tolerance().is_empty());
}
