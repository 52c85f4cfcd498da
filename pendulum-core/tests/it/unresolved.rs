//! Fixed steps that are too long to resolve a motion.

use std::f64::consts::PI;

use pendulum_core::prelude::*;

mechanism! {
    Swing {
        gravity: [0, -1, 0],
        body bob on ground { solids: [point(1, [0, -1, 0])], joint: revolute(z), coordinate: theta }
        generate: [rhs, jacobian, energy, canonical],
    }
}

fn swing() -> Swing {
    Swing::new(SwingParams {}).expect("valid parameters")
}

/// Components that are reported after small swings of angular frequency 1 for 100 s, and the largest relative error of
/// a state.
fn small_swings<M: Method<Swing, f64, 2>>(method: &M) -> (Vec<usize>, f64) {
    let solution = method.solve(&swing(), 0.0, 100.0, [1e-3, 0.0]).expect("finite");
    let error = |(t, x): (f64, &SVector<f64, 2>)| (x / 1e-3 - SVector::from([t.cos(), -t.sin()])).norm();
    let largest = solution.points().map(error).fold(0.0, f64::max);
    let components = solution.unresolved().into_iter().map(|unresolved| unresolved.component);
    (components.collect(), largest)
}

#[test]
fn steps_too_long_for_a_swing_are_reported_and_resolved_ones_are_not() {
    for h in (1..40).map(|n| 0.1 * f64::from(n)) {
        let (rk4, gauss4, gauss6) = (
            small_swings(&Rk4::new(h)),
            small_swings(&Gauss4::new(h)),
            small_swings(&Gauss6::new(h)),
        );
        for ((components, error), resolved) in [(rk4, 1.25), (gauss4, 1.25), (gauss6, 2.45)] {
            assert_eq!(components.is_empty(), h <= resolved, "{h}: {components:?}, {error}");
            assert!(components.is_empty() || error > 0.1, "{h}: {error}");
        }
    }
}

#[test]
fn a_pendulum_in_steps_of_a_minute_is_reported() {
    let pendulum = swing();
    let solution = Rk4::new(50.0)
        .solve(&pendulum, 0.0, 1000.0, [1.0, 0.0])
        .expect("finite");
    assert!(solution.end()[0].abs() > 1e3, "{}", solution.end());
    let unresolved = solution.unresolved();
    assert!(!unresolved.is_empty());
    let text = unresolved[0].to_string();
    assert!(
        text.contains("steps of 50 resolve") && text.contains("shorter steps"),
        "{text}"
    );
    // at rest, rounding errors are no motion
    let standing = Rk4::new(2.0).solve(&pendulum, 0.0, 6.0, [PI, 0.0]).expect("finite");
    assert!(standing.end()[1].abs() > 1e-16 && standing.unresolved().is_empty());
    let hanging = Rk4::new(1.0).solve(&pendulum, 0.0, 100.0, [0.0, 0.0]).expect("finite");
    assert!(hanging.unresolved().is_empty());
    // an adaptive method chooses its steps
    let adaptive = Rk45::new()
        .rtol(0.1)
        .solve(&pendulum, 0.0, 1000.0, [1.0, 0.0])
        .expect("finite");
    assert!(adaptive.unresolved().is_empty());
    // a span without a step
    let none = Rk4::new(50.0).solve(&pendulum, 1.0, 1.0, [1.0, 0.0]).expect("finite");
    assert!(none.unresolved().is_empty());
}
