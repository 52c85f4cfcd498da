//! Integrations that must fail: each reports the reason and keeps the part of the solution it reached.

use approx::assert_abs_diff_eq;
use pendulum_core::Reason;
use pendulum_core::prelude::*;

/// Exponential decay, undefined after `t = 1`.
fn ends_at_one(t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
    SVector::from([-x[0], if t > 1.0 { f64::NAN } else { -x[1] }])
}

#[test]
fn a_right_hand_side_that_ends_is_followed_to_its_end() {
    let system = FnSystem(ends_at_one);
    let error = Rk45::new()
        .solve(&system, 0.0, 2.0, [1.0, 1.0])
        .expect_err("NaN after 1");
    assert!(
        matches!(error.reason, Reason::NonFinite { component: 1, .. }),
        "{error}"
    );
    // The smallest step is 4 ulps, and a step beyond the end is divided by four, so the integration stops within 16
    // ulps.
    assert!(error.t() <= 1.0 && error.t() > 1.0 - 16.0 * f64::EPSILON);
    // The default tolerance of 1e-6 per step, accumulated over several steps.
    assert_abs_diff_eq!(error.x()[0], (-1.0_f64).exp(), epsilon = 5e-6);
    assert_abs_diff_eq!(
        error.solution.at(0.5).expect("kept")[1],
        (-0.5_f64).exp(),
        epsilon = 5e-6
    );
    assert!(error.to_string().contains("component 1"), "{error}");

    let error = Rk4::new(0.3)
        .solve(&system, 0.0, 2.0, [1.0, 1.0])
        .expect_err("NaN after 1");
    assert!(
        matches!(error.reason, Reason::NonFinite { component: 1, .. }),
        "{error}"
    );
    assert_abs_diff_eq!(error.t(), 0.9, epsilon = 1e-15);
    assert_eq!(error.solution.statistics().accepted, 3);
}

#[test]
fn a_step_that_leaves_the_domain_is_shortened() {
    // x' = -sqrt(x) reaches 0 at t = 2 with zero slope; long steps overshoot into the undefined range.
    let system = FnSystem(|_t: f64, x: &SVector<f64, 1>| SVector::from([-x[0].sqrt()]));
    let method = Rk45::new().h0(1.9);
    let solution = method.solve(&system, 0.0, 1.9, [1.0]).expect("defined up to 2");
    assert!(solution.statistics().rejected > 0);
    // x = (1 - t/2)^2 is 0.0025; the tolerance of 1e-6 per step, accumulated over several steps.
    assert_abs_diff_eq!(solution.end()[0], 0.0025, epsilon = 5e-6);
}

#[test]
fn a_blow_up_ends_in_a_step_underflow_at_the_pole() {
    // The solution of x' = x^2 from 1 is 1 / (1 - t).
    let system = FnSystem(|_t: f64, x: &SVector<f64, 1>| x.component_mul(x));
    let method = Rk45::new().rtol(1e-10).atol(1e-10);
    let error = method.solve(&system, 0.0, 2.0, [1.0]).expect_err("a pole at 1");
    assert!(matches!(error.reason, Reason::StepUnderflow { .. }), "{error}");
    // The integration error shifts the pole; the state follows the shifted one up to rounding errors.
    assert_abs_diff_eq!(error.t(), 1.0, epsilon = 1e-9);
    assert!(error.x()[0] > 1e12);
    assert_abs_diff_eq!(error.solution.at(0.9).expect("kept")[0], 10.0, epsilon = 1e-7);
}

#[test]
fn too_many_steps_keep_the_part_that_was_reached() {
    let system = FnSystem(|t: f64, x: &SVector<f64, 1>| SVector::from([-1e4 * (x[0] - t.cos())]));
    let method = Rk45::new().max_steps(100);
    let error = method.solve(&system, 0.0, 20.0, [0.0]).expect_err("stiff");
    assert_eq!(error.reason, Reason::TooManySteps { max_steps: 100 });
    let statistics = error.solution.statistics();
    assert_eq!(statistics.accepted + statistics.rejected, 100);
    assert_eq!(error.solution.t().len(), statistics.accepted + 1);
    assert!(error.t() > 0.0 && error.x().iter().all(|x| x.is_finite()));
}

#[test]
fn steps_that_time_cannot_resolve_are_refused() {
    let decay = FnSystem(|_t: f64, x: &SVector<f64, 1>| -x);
    let spans = [
        (0.0, 0.0, 1.0),
        (-0.1, 0.0, 1.0),
        (f64::NAN, 0.0, 1.0),
        (f64::INFINITY, 0.0, 1.0),
        (1e-7, 1e9, 1e9 + 1.0),
        (1e-7, 0.0, 1e9),
    ];
    for (h, t0, t1) in spans {
        let error = Rk4::new(h).solve(&decay, t0, t1, [1.0]).expect_err("nonsense");
        assert!(
            matches!(error.reason, Reason::InvalidInput { what: "h", .. }),
            "{error}"
        );
        assert_eq!((error.t(), error.x()), (t0, SVector::from([1.0])));
    }
    let decay = FnSystem(|_t: f32, x: &SVector<f32, 1>| -x);
    let error = Rk45::new().rtol(1e-7).solve(&decay, 0.0, 1.0, [1.0]);
    let error = error.expect_err("below 10 ulps of f32");
    assert!(
        matches!(error.reason, Reason::InvalidInput { what: "rtol", .. }),
        "{error}"
    );
}

#[test]
fn no_more_points_are_kept_than_fit() {
    let still = FnSystem(|_t, _x: &SVector<f64, 1>| SVector::from([0.0]));
    let error = Rk4::new(1e-8).solve(&still, 0.0, 1.0, [0.0]).expect_err("1e8 points");
    assert!(
        matches!(error.reason, Reason::InvalidInput { what: "h", .. }),
        "{error}"
    );
    assert!(error.to_string().contains("`stepper`, which stores none"), "{error}");
    let mut kept = Solution::start(0.0, SVector::from([0.0]));
    let followed = Rk4::new(1e-8).follow(&still, 0.0, 1.0, [0.0], &[], &mut kept);
    assert_eq!(followed, Err(error.reason));
    let mut stepper = Rk4::new(1e-8).stepper(&still, 0.0, 1.0, [0.0]).expect("no points");
    assert!(stepper.step().expect("regular").is_some());
}

#[test]
fn a_stepper_restarts_between_the_start_of_its_last_step_and_the_end() {
    let decay = FnSystem(|_t: f64, x: &SVector<f64, 1>| -x);
    for t1 in [2.0, -2.0] {
        let (x, direction) = (SVector::from([3.0]), t1.signum());
        let mut stepper = Rk4::new(0.25).stepper(&decay, 0.0, t1, [1.0]).expect("valid");
        for _ in 0..2 {
            stepper.step().expect("regular");
        }
        let (from, reached) = (0.25 * direction, 0.5 * direction);
        for t in [from - 1e-15 * direction, 2.0 * t1, t1 + 1e-15 * direction, f64::NAN] {
            let refused = stepper.restart(t, x);
            assert!(
                matches!(refused, Err(Reason::InvalidInput { what: "t", .. })),
                "{t}: {refused:?}"
            );
            assert_eq!(stepper.t(), reached);
        }
        stepper.restart(from, x).expect("where the step began");
        assert_eq!((stepper.t(), stepper.x()), (from, x));
        // The step times are preserved, and no step of zero length is taken.
        assert_eq!(
            stepper.step().expect("regular").map(|step| (step.t0, step.t1)),
            Some((from, reached))
        );
        stepper.restart(t1, x).expect("the end");
        assert_eq!((stepper.t(), stepper.x()), (t1, x));
        assert_eq!(stepper.step(), Ok(None));
        // At the end, only a restart at the same time is valid.
        stepper.restart(t1, x).expect("where it is");
        assert!(stepper.restart(reached, x).is_err());
    }
}

#[test]
fn a_restart_that_fails_changes_nothing() {
    fn check(method: &impl Method<FnSystem<fn(f64, &SVector<f64, 2>) -> SVector<f64, 2>>, f64, 2>) {
        let system = FnSystem(ends_at_one as fn(f64, &SVector<f64, 2>) -> SVector<f64, 2>);
        let mut stepper = method.stepper(&system, 0.0, 2.0, [1.0, 1.0]).expect("valid");
        let mut twin = method.stepper(&system, 0.0, 2.0, [1.0, 1.0]).expect("valid");
        for _ in 0..2 {
            stepper.step().expect("regular");
            twin.step().expect("regular");
        }
        let no_slope = Err(Reason::NonFinite { component: 1, h: None });
        assert_eq!(stepper.restart(1.5, [0.1, 0.1].into()), no_slope);
        assert_eq!((stepper.t(), stepper.x()), (twin.t(), twin.x()));
        // The reached state remains; the last step, which the scheme has overwritten, is not available.
        assert_eq!(stepper.dense().at(0.5 * twin.t()), twin.x());
        let no_number = stepper.restart(twin.t(), [0.1, f64::NAN].into());
        assert!(matches!(no_number, Err(Reason::InvalidInput { what: "x0", .. })));
        assert_eq!((stepper.t(), stepper.x()), (twin.t(), twin.x()));
        assert_eq!(stepper.step(), twin.step());
    }
    check(&Rk4::new(0.125));
    check(&Rk45::new().h0(0.125));
}

#[test]
fn where_there_is_no_way_to_go_nothing_is_evaluated() {
    let never = FnSystem(|_t: f64, _x: &SVector<f64, 1>| SVector::from([f64::NAN]));
    let mut stepper = Rk45::new().stepper(&never, 1.0, 1.0, [2.0]).expect("no way");
    assert_eq!((stepper.run(), stepper.statistics().evaluations), (Ok([2.0].into()), 0));
    // Likewise after a restart at the end, where the right-hand side is NaN.
    let ending = FnSystem(|t: f64, x: &SVector<f64, 1>| x * if t < 1.0 { -1.0 } else { f64::NAN });
    let mut stepper = Rk4::new(0.125).stepper(&ending, 0.0, 1.0, [2.0]).expect("valid");
    stepper.step().expect("regular");
    let before = stepper.statistics();
    stepper.restart(1.0, [3.0].into()).expect("the end");
    assert_eq!((stepper.run(), stepper.statistics()), (Ok([3.0].into()), before));
}

#[test]
fn a_step_to_where_there_is_no_slope_is_none() {
    // From 1 the stages of Kutta's method are at 1, 1.25, 1.3125 and 1.65625, and its step ends at 1.6484375.
    let gap = FnSystem(|_t: f64, x: &SVector<f64, 1>| x * if x[0] == 1.648_437_5 { f64::NAN } else { 1.0 });
    let mut stepper = Rk4::new(0.5).stepper(&gap, 0.0, 1.0, [1.0]).expect("valid");
    let no_slope = Err(Reason::NonFinite {
        component: 0,
        h: Some(0.5),
    });
    assert_eq!((stepper.step(), stepper.x()[0]), (no_slope, 1.0));
    assert_eq!((stepper.statistics().accepted, stepper.statistics().rejected), (0, 1));
}

#[test]
fn before_the_first_step_and_after_a_failed_one_all_is_the_point_reached() {
    let system = FnSystem(ends_at_one);
    let mut stepper = Vern9::new().stepper(&system, 0.0, 2.0, [1.0, 2.0]).expect("valid");
    let before = stepper.statistics();
    assert_eq!(stepper.dense().at(0.5), SVector::from([1.0, 2.0]));
    assert_eq!(stepper.statistics(), before);
    let mut stepper = Rk4::new(0.75).stepper(&system, 0.0, 2.0, [1.0, 2.0]).expect("valid");
    stepper.step().expect("regular");
    stepper.step().expect_err("beyond 1");
    let reached = stepper.x();
    assert_eq!(stepper.dense().at(0.5), reached);
}

#[test]
fn all_evaluations_are_counted() {
    let calls = std::cell::Cell::new(0);
    let system = FnSystem(|t: f64, x: &SVector<f64, 1>| {
        calls.set(calls.get() + 1);
        SVector::from([(20.0 * t).sin() - x[0]])
    });
    let count = |count: usize| assert_eq!(calls.replace(0), count);
    count(
        Rk4::new(0.1)
            .solve(&system, 0.0, 1.0, [1.0])
            .expect("regular")
            .statistics()
            .evaluations,
    );
    count(
        Rk45::new()
            .solve(&system, 0.0, 1.0, [1.0])
            .expect("regular")
            .statistics()
            .evaluations,
    );
    count(
        Vern9::new()
            .solve(&system, 0.0, 1.0, [1.0])
            .expect("regular")
            .statistics()
            .evaluations,
    );
}
