//! Failures of all methods: each error has a type and a reason, and the state reached is kept.

use std::f64::consts::PI;

use approx::assert_abs_diff_eq;
use pendulum_core::ensemble::Together;
use pendulum_core::method::{Adaptive, Estimates, Fixed, OneStep};
use pendulum_core::prelude::*;
use pendulum_core::{EnsembleError, Reason};
use testbed::methods::Promise;
use testbed::scenes::DoublePendulum;

mechanism! {
    /// A force of `sqrt(1 - t)`, which is NaN for `t > 1`.
    pub Ending {
        units: none,
        generate: [rhs, jacobian, energy, taylor, canonical],
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: x, torque: sqrt(1 - t) }
    }
}

mechanism! {
    /// A force that is defined up to `x = 1`, where the cart arrives at full speed.
    pub Cliff {
        units: none,
        params { push: N = 1.0 }
        generate: [rhs, jacobian, energy, taylor, canonical],
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: x, torque: push * sqrt(1 - x) }
    }
}

mechanism! {
    /// A fall into the centre of an inverse-square force from the distance 1, which takes `pi / sqrt(8)`.
    pub Pole {
        params { strength: N m^2 = 1.0 }
        generate: [rhs, jacobian, energy, taylor, canonical],
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: x, torque: strength / (1 - x)^2 }
    }
}

mechanism! {
    /// `x = cos t`.
    pub Spring {
        generate: [rhs, jacobian, energy, taylor, canonical],
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: x, spring: (1, 0) }
    }
}

// Bad input

/// Name of the input that a method rejects.
fn refused(method: &impl Method<Spring, f64, 2>, (t0, t1): (f64, f64), x0: [f64; 2]) -> &'static str {
    let model = Spring::new(SpringParams {}).expect("physical");
    let error = method.solve(&model, t0, t1, x0).expect_err("nonsense");
    assert_eq!(error.t().to_bits(), t0.to_bits());
    assert_eq!(error.x().map(f64::to_bits), SVector::from(x0.map(f64::to_bits)));
    let Reason::InvalidInput { what, .. } = error.reason else {
        panic!("{error}")
    };
    assert!(error.to_string().starts_with(&format!("`{what}` is ")));
    what
}

#[test]
fn nonsense_is_refused_by_name() {
    const NAN: f64 = f64::NAN;
    const INFINITY: f64 = f64::INFINITY;
    fn check(method: &impl Method<Spring, f64, 2>) {
        for (t0, t1, what) in [
            (NAN, 1.0, "t0"),
            (0.0, INFINITY, "t1"),
            (0.0, NAN, "t1"),
            (-1e308, 1e308, "t1 - t0"),
        ] {
            assert_eq!(refused(method, (t0, t1), [1.0, 0.0]), what);
        }
        for x in [NAN, INFINITY] {
            assert_eq!(refused(method, (0.0, 1.0), [1.0, x]), "x0");
            assert_eq!(refused(method, (1.0, 1.0), [x, 0.0]), "x0");
        }
    }
    fn fixed<F: OneStep<Spring, f64, 2> + Default>(_: &Promise) {
        check(&Fixed::<F>::new(0.1));
        for h in [0.0, -0.1, NAN, INFINITY, 1e-18] {
            assert_eq!(refused(&Fixed::<F>::new(h), (0.0, 1.0), [1.0, 0.0]), "h");
        }
        assert_eq!(refused(&Fixed::<F>::new(1e-7), (1e9, 1e9 + 1.0), [1.0, 0.0]), "h");
    }
    fn adaptive<F: OneStep<Spring, f64, 2> + Estimates + Default>(_: &Promise) {
        let (method, unit, x0) = (Adaptive::<F>::new, (0.0, 1.0), [1.0, 0.0]);
        check(&method());
        for rtol in [0.0, -1e-6, NAN, INFINITY, 9.0 * f64::EPSILON] {
            assert_eq!(refused(&method().rtol(rtol), unit, x0), "rtol");
        }
        for atol in [0.0, -1e-6, NAN, INFINITY] {
            assert_eq!(refused(&method().atol(atol), unit, x0), "atol");
        }
        for h0 in [0.0, -0.1, NAN, INFINITY] {
            assert_eq!(refused(&method().h0(h0), unit, x0), "h0");
        }
        for h_min in [-0.1, NAN, INFINITY] {
            assert_eq!(refused(&method().h_min(h_min), unit, x0), "h_min");
        }
        for h_max in [0.0, -0.1, NAN] {
            assert_eq!(refused(&method().h_max(h_max), unit, x0), "h_max");
        }
        assert_eq!(refused(&method().h_min(0.2).h_max(0.1), unit, x0), "h_max");
        assert_eq!(refused(&method().h_max(1e-7), (1e9, 1e9 + 1.0), x0), "h_max");
    }
    testbed::each_adaptive!(fixed);
    testbed::each_without_estimate!(fixed);
    testbed::each_adaptive!(adaptive);
}

#[test]
fn too_many_steps_keep_the_part_that_was_reached() {
    fn check<F: OneStep<DoublePendulum, f64, 4> + Estimates + Default>(promise: &Promise) {
        let model = DoublePendulum::new(Default::default()).expect("physical");
        let method = Adaptive::<F>::new().max_steps(7);
        let error = method
            .solve(&model, 0.0, 100.0, [2.0, 2.5, 0.0, 0.0])
            .expect_err("a long time");
        let work = error.solution.statistics();
        assert_eq!(error.reason, Reason::TooManySteps { max_steps: 7 }, "{promise:?}");
        assert_eq!(
            (work.accepted + work.rejected, error.solution.t().len()),
            (7, work.accepted + 1)
        );
        assert!(
            error.t() > 0.0 && error.x().iter().all(|x| x.is_finite()),
            "{promise:?}"
        );
    }
    testbed::each_adaptive!(check);
}

// Right-hand sides that become undefined

/// Exact motion of [`Ending`].
fn until_the_end(t: f64) -> SVector<f64, 2> {
    let left = (1.0 - t).max(0.0);
    SVector::from([
        (2.0 * t - 0.8 * (1.0 - left.powf(2.5))) / 3.0,
        2.0 / 3.0 * (1.0 - left.powf(1.5)),
    ])
}

/// True if the right-hand side has become undefined. The steps of the Taylor method shrink as they approach that time.
fn is_end(reason: &Reason, promise: &Promise) -> bool {
    matches!(reason, Reason::NonFinite { .. })
        || (promise.name == "Taylor" && matches!(reason, Reason::StepUnderflow { .. }))
}

#[test]
fn a_right_hand_side_that_ends_is_followed_to_its_end() {
    fn fixed<F: OneStep<Ending, f64, 2> + Default>(promise: &Promise) {
        let model = Ending::new(EndingParams {}).expect("physical");
        let method = Fixed::<F>::new(0.3);
        let error = method
            .solve(&model, 0.0, 2.0, [0.0, 0.0])
            .expect_err("no number after 1");
        assert!(matches!(error.reason, Reason::NonFinite { .. }), "{promise:?}: {error}");
        assert_eq!(
            (error.t(), error.solution.statistics().accepted),
            (0.3 * 3.0, 3),
            "{promise:?}"
        );
        assert_abs_diff_eq!(error.x(), until_the_end(error.t()), epsilon = 2e-4);
        // a second run from there fails in the same way
        let mut stepper = method.stepper(&model, 0.0, 2.0, [0.0, 0.0]).expect("valid");
        assert_eq!(stepper.run(), Err(error.reason), "{promise:?}");
        assert_eq!(stepper.step(), Err(error.reason), "{promise:?}");
        assert_eq!(
            (stepper.t(), stepper.x(), stepper.dense().at(0.1)),
            (error.t(), error.x(), error.x())
        );
        let error = method.solve(&model, 1.5, 2.0, [0.0, 0.0]).expect_err("no number");
        assert_eq!(
            (error.reason, error.t()),
            (Reason::NonFinite { component: 1, h: None }, 1.5),
            "{promise:?}"
        );
    }
    fn adaptive<F: OneStep<Ending, f64, 2> + Estimates + Default>(promise: &Promise) {
        let model = Ending::new(EndingParams {}).expect("physical");
        let method = Adaptive::<F>::new().rtol(1e-9);
        let error = method
            .solve(&model, 0.0, 2.0, [0.0, 0.0])
            .expect_err("no number after 1");
        assert!(is_end(&error.reason, promise), "{promise:?}: {error}");
        assert!((error.t() - 1.0).abs() < 16.0 * f64::EPSILON, "{promise:?}: {error}");
        assert_abs_diff_eq!(error.x(), until_the_end(error.t()), epsilon = 1e-7);
        assert_abs_diff_eq!(
            error.solution.at(0.5).expect("kept"),
            until_the_end(0.5),
            epsilon = 1e-7
        );
        let error = method.solve(&model, 1.5, 2.0, [0.0, 0.0]).expect_err("no number");
        assert_eq!(
            (error.reason, error.t()),
            (Reason::NonFinite { component: 1, h: None }, 1.5),
            "{promise:?}"
        );
    }
    testbed::each_adaptive!(fixed);
    testbed::each_without_estimate!(fixed);
    testbed::each_adaptive!(adaptive);
}

#[test]
fn a_domain_that_ends_is_followed_to_its_edge() {
    // v^2 = 1 + 4/3 (1 - (1 - x)^1.5)
    fn check<F: OneStep<Cliff, f64, 2> + Estimates + Default>(promise: &Promise) {
        let model = Cliff::new(CliffParams::default()).expect("physical");
        let method = Adaptive::<F>::new().rtol(1e-9);
        let error = method
            .solve(&model, 0.0, 2.0, [0.0, 1.0])
            .expect_err("no number beyond 1");
        assert!(is_end(&error.reason, promise), "{promise:?}: {error}");
        let edge = SVector::from([1.0, (7.0_f64 / 3.0).sqrt()]);
        assert_abs_diff_eq!(error.x(), edge, epsilon = 1e-7);
    }
    testbed::each_adaptive!(check);
}

#[test]
fn a_pole_is_the_end() {
    fn check<F: OneStep<Pole, f64, 2> + Estimates + Default>(promise: &Promise) {
        let model = Pole::new(PoleParams::default()).expect("physical");
        let method = Adaptive::<F>::new().rtol(1e-7).max_steps(50_000);
        let error = method.solve(&model, 0.0, 2.0, [0.0, 0.0]).expect_err("the centre");
        // Either steps become too short for the time, or one of the shortest hits the centre.
        assert!(
            matches!(error.reason, Reason::StepUnderflow { .. } | Reason::NonFinite { .. }),
            "{promise:?}: {error}"
        );
        assert_abs_diff_eq!(error.t(), PI / 8.0_f64.sqrt(), epsilon = 1e-6);
        assert!(
            error.x()[0] < 1.0 && error.x()[0] > 0.999 && error.x()[1] > 100.0,
            "{promise:?}: {}",
            error.x()
        );
    }
    testbed::each_adaptive!(check);
}

/// Close to a pole the terms of a series overflow, and must not be accepted as a step.
#[test]
fn a_series_does_not_leap_over_a_pole() {
    let model = Pole::new(PoleParams::default()).expect("physical");
    // also by hitting the centre, or by too many steps on the way
    let ends = |reason: &Reason| !matches!(reason, Reason::InvalidInput { .. });
    for tolerance in [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15] {
        let method = Taylor::new()
            .rtol(tolerance.max(3e-15))
            .atol(tolerance)
            .max_steps(20_000);
        let error = method.solve(&model, 0.0, 2.0, [0.0, 0.0]).expect_err("the centre");
        assert!(ends(&error.reason), "{tolerance:e}: {error}");
        assert!(
            (error.t() - PI / 8.0_f64.sqrt()).abs() < 2.0 * tolerance.max(1e-6),
            "{tolerance:e}: {error}"
        );
    }
    for order in [4, 8, 16, 24] {
        let method = Taylor::new().order(order).max_steps(20_000);
        let error = method
            .solve(&model.cast::<f32>(), 0.0_f32, 2.0, [0.0, 0.0])
            .expect_err("the centre");
        assert!(ends(&error.reason), "{order}: {error}");
    }
}

/// An ensemble reports the same failures as its members alone.
macro_rules! stopped_alike {
    ($test:ident: $model:ident, $params:ident, $symbol:ident, $x0:expr) => {
        #[test]
        fn $test() {
            fn check<F: Together<$model, f64, 2> + Estimates + Default>(promise: &Promise) {
                // some end, and some do not
                let models = [1.0, -0.5, 0.9, -0.2, 1.1, 1.2, -0.1, 1.3, 1.4, 1.5, 1.6]
                    .map(|$symbol| $model::new($params { $symbol }).expect("physical"));
                let method = Adaptive::<F>::new().rtol(1e-7).max_steps(50_000);
                let starts = [SVector::from($x0); 11];
                let error = method.ensemble(&models, 0.0, 1.5, &starts).expect_err("most end");
                let EnsembleError::Stopped { stopped, x } = error else {
                    panic!("{promise:?}: {error}")
                };
                let mut alone = Vec::new();
                for (index, model) in models.iter().enumerate() {
                    match method.solve(model, 0.0, 1.5, starts[index]) {
                        Ok(solution) => assert_eq!(solution.end(), x[index], "{promise:?} {index}"),
                        Err(error) => {
                            assert_eq!(error.x(), x[index], "{promise:?} {index}");
                            alone.push((index, error.t(), error.reason));
                        }
                    }
                }
                assert!(alone.len() > 3 && alone.len() < 11, "{promise:?}: {alone:?}");
                let stopped: Vec<_> = stopped
                    .iter()
                    .map(|member| (member.index, member.t, member.reason))
                    .collect();
                assert_eq!(stopped, alone, "{promise:?}");
            }
            testbed::each_in_lanes!(check);
        }
    };
}

stopped_alike!(ensembles_stop_at_the_edge_of_a_domain: Cliff, CliffParams, push, [0.0, 0.3]);
stopped_alike!(ensembles_stop_at_a_pole: Pole, PoleParams, strength, [0.0, 0.0]);

// Restarts

#[test]
fn a_restart_that_fails_changes_nothing() {
    fn check(promise: &Promise, method: &impl Method<Ending, f64, 2>) {
        let model = Ending::new(EndingParams {}).expect("physical");
        let mut stepper = method.stepper(&model, 0.0, 2.0, [0.0, 0.0]).expect("valid");
        stepper.step().expect("regular");
        let (t, x) = (stepper.t(), stepper.x());
        assert_eq!(
            stepper.restart(1.5, x),
            Err(Reason::NonFinite { component: 1, h: None }),
            "{promise:?}"
        );
        assert!(matches!(
            stepper.restart(t, x * f64::NAN),
            Err(Reason::InvalidInput { what: "x0", .. })
        ));
        assert!(matches!(
            stepper.restart(-1.0, x),
            Err(Reason::InvalidInput { what: "t", .. })
        ));
        assert_eq!((stepper.t(), stepper.x()), (t, x));
        let step = stepper.step().expect("as before").expect("not at the end");
        assert!(step.t0 == t && step.t1 < 1.0, "{promise:?}: {step:?}");
        assert_abs_diff_eq!(step.x1, until_the_end(step.t1), epsilon = 1e-5);
    }
    fn fixed<F: OneStep<Ending, f64, 2> + Default>(promise: &Promise) {
        check(promise, &Fixed::<F>::new(0.2));
    }
    fn adaptive<F: OneStep<Ending, f64, 2> + Estimates + Default>(promise: &Promise) {
        check(promise, &Adaptive::<F>::new().h0(0.2));
    }
    testbed::each_adaptive!(fixed);
    testbed::each_without_estimate!(fixed);
    testbed::each_adaptive!(adaptive);
}
