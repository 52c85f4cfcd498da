//! Promises of every method, all tested alike.

use std::f64::consts::PI;

use approx::assert_abs_diff_eq;
use pendulum_core::method::{Adaptive, Estimates, Fixed, OneStep};
use pendulum_core::prelude::*;
use pendulum_core::{Occurrence, Reason, Solution, Statistics};
use testbed::methods::Promise;
use testbed::scenes::{DoublePendulum, double_pendulum};
use testbed::trajectories::scene;

const START: [f64; 4] = [2.0, 2.5, 0.0, 0.0];

fn reference(name: &str, t: f64) -> SVector<f64, 4> {
    scene(name).state(t)
}

mechanism! {
    /// An oscillator whose motion is `x = cos t`.
    pub Spring {
        generate: [rhs, jacobian, energy, taylor, canonical],
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: x, spring: (1, 0) }
    }
}

// Orders and accuracy

/// The large swing at a tenth of the tolerances compared with it; it is itself compared with the reference.
fn swing() -> Solution<f64, 4> {
    let method = Taylor::new().rtol(3e-15).atol(3e-15);
    let solution = method.solve(&double_pendulum(0.0), 0.0, 2.0, START).expect("regular");
    assert_abs_diff_eq!(solution.end(), reference("large_swing", 2.0), epsilon = 1e-13);
    solution
}

#[test]
fn errors_fall_with_the_order() {
    fn check<F: OneStep<DoublePendulum, f64, 4> + Default>(promise: &Promise) {
        let (model, exact) = (double_pendulum(0.0), reference("large_swing", 2.0));
        let error = |h: f64| {
            let mut stepper = Fixed::<F>::new(h).stepper(&model, 0.0, 2.0, START).expect("valid");
            (stepper.run().expect("regular") - exact).amax()
        };
        let (coarse, fine) = (error(promise.h), error(0.5 * promise.h));
        let order = (coarse / fine).log2();
        // steps with errors above rounding are so long that the next term of high orders is visible
        assert!(
            order > 0.96 * promise.order && order < promise.order + 1.0,
            "{promise:?}: {order}"
        );
    }
    testbed::each_adaptive!(check);
    testbed::each_without_estimate!(check);
}

#[test]
fn dense_errors_fall_with_their_order() {
    fn check<F: OneStep<DoublePendulum, f64, 4> + Default>(promise: &Promise) {
        let (model, swing) = (double_pendulum(0.0), swing());
        let start = swing.at(0.5).expect("within");
        // error of one step, whose order is higher by one
        let error = |h: f64| {
            let mut stepper = Fixed::<F>::new(h).stepper(&model, 0.5, 0.5 + h, start).expect("valid");
            stepper.step().expect("regular").expect("a step");
            let x1 = stepper.x();
            let dense = stepper.dense();
            assert_eq!((dense.at(0.5), dense.at(0.5 + h)), (start, x1));
            let times = [0.2, 0.5, 0.7].map(|theta| 0.5 + theta * h);
            times
                .map(|t| (dense.at(t) - swing.at(t).expect("within")).amax())
                .into_iter()
                .fold(0.0, f64::max)
        };
        let (coarse, fine) = (error(promise.one), error(0.5 * promise.one));
        let order = (coarse / fine).log2() - 1.0;
        assert!(
            order > 0.96 * promise.dense && order < promise.dense + 1.2,
            "{promise:?}: {order}"
        );
    }
    testbed::each_adaptive!(check);
    testbed::each_without_estimate!(check);
}

/// Final state at a tolerance.
fn end<F: OneStep<DoublePendulum, f64, 4> + Estimates + Default>(
    model: &DoublePendulum,
    tolerance: f64,
    (t0, t1): (f64, f64),
    x0: SVector<f64, 4>,
) -> SVector<f64, 4> {
    let method = Adaptive::<F>::new().rtol(tolerance).atol(tolerance);
    method
        .stepper(model, t0, t1, x0)
        .expect("valid")
        .run()
        .expect("regular")
}

#[test]
fn errors_fall_with_the_tolerance() {
    fn check<F: OneStep<DoublePendulum, f64, 4> + Estimates + Default>(promise: &Promise) {
        for (name, gamma, t) in [("large_swing", 0.0, 2.0), ("paper_gamma_0.1", 0.1, 20.0)] {
            let (model, start) = (double_pendulum(gamma), SVector::from(scene(name).start::<4>()));
            let error = |tolerance| (end::<F>(&model, tolerance, (0.0, t), start) - reference(name, t)).amax();
            let errors = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12].map(error);
            // the tolerance bounds the error of a step; errors of many steps add up, to 14 tolerances in the worst
            // observed case
            assert!(
                std::iter::zip(errors, [1e-4, 1e-6, 1e-8, 1e-10, 1e-12]).all(|(e, tol)| e < 20.0 * tol),
                "{promise:?} {name}: {errors:?}"
            );
            // at a hundredth of the tolerance the error is at most a tenth, since errors far below the tolerance are
            // luck; over eight powers of ten it decreases by at least seven
            let falls = errors.windows(2).all(|pair| pair[1] < 0.1 * pair[0] || pair[1] < 1e-13);
            assert!(falls && errors[4] < 1e-7 * errors[0], "{promise:?} {name}: {errors:?}");
        }
    }
    testbed::each_adaptive!(check);
}

#[test]
fn forth_and_back_returns_to_the_start() {
    fn check<F: OneStep<DoublePendulum, f64, 4> + Estimates + Default>(promise: &Promise) {
        for (name, gamma) in [("large_swing", 0.0), ("paper_gamma_0.1", 0.1)] {
            let (model, start) = (double_pendulum(gamma), SVector::from(scene(name).start::<4>()));
            let there = end::<F>(&model, 1e-10, (0.0, 2.0), start);
            let back = end::<F>(&model, 1e-10, (2.0, 0.0), there);
            let error = (back - start).amax();
            assert!(
                (there - start).amax() > 0.01 && error < 20e-10,
                "{promise:?} {name}: {error:e}"
            );
        }
    }
    testbed::each_adaptive!(check);
    fn check_fixed<F: OneStep<DoublePendulum, f64, 4> + Default>(promise: &Promise) {
        let (model, method) = (double_pendulum(0.0), Fixed::<F>::new(0.5 * promise.h));
        let there = method
            .stepper(&model, 0.0, 2.0, START)
            .expect("valid")
            .run()
            .expect("regular");
        let back = method
            .stepper(&model, 2.0, 0.0, there)
            .expect("valid")
            .run()
            .expect("regular");
        // like the forward motion, whose largest errors are 1e-7
        assert_abs_diff_eq!(back, SVector::from(START), epsilon = 2e-7);
    }
    testbed::each_adaptive!(check_fixed);
    testbed::each_without_estimate!(check_fixed);
}

#[test]
fn single_precision_reaches_its_own_accuracy() {
    fn check(promise: &Promise, method: &impl Method<DoublePendulum<f32>, f32, 4>, most: f64) {
        let start = scene("paper_gamma_0.1").start::<4>().map(|x| x as f32);
        let model = double_pendulum(0.1).cast::<f32>();
        let mut stepper = method.stepper(&model, 0.0, 5.0, start).expect("valid");
        let error = stepper.run().expect("regular").cast::<f64>() - reference("paper_gamma_0.1", 5.0);
        assert!(error.amax() < most, "{promise:?}: {error}");
    }
    // defaults: rtol 1.2e-5, atol 1.2e-7; the amplitude of 0.07 makes this a tolerance of 1e-6, with a margin for many
    // steps
    fn adaptive<F: OneStep<DoublePendulum<f32>, f32, 4> + Estimates + Default>(promise: &Promise) {
        check(promise, &Adaptive::<F>::new(), 5e-6);
    }
    // 250 steps, each rounded to 6e-8 of the amplitude of 0.07
    fn fixed<F: OneStep<DoublePendulum<f32>, f32, 4> + Default>(promise: &Promise) {
        check(promise, &Fixed::<F>::new(0.02), 5e-6);
    }
    testbed::each_adaptive!(adaptive);
    testbed::each_adaptive!(fixed);
    testbed::each_without_estimate!(fixed);
}

// Time

#[test]
fn the_last_point_is_the_end_exactly() {
    const SPANS: [(f64, f64, f64, usize); 7] = [
        (0.1, 0.1 + 3.0 * 0.03, 0.03, 3),
        (0.0, 1.0, 0.1, 10),
        (0.0, 1.0, 0.03, 34),
        (0.7, -0.2, 0.03, 30),
        (1e9, 1e9 + 1.0, 0.01, 100),
        (-1e9, -1e9 - 1.0, 0.01, 100),
        (0.0, 0.01, 7.0, 1),
    ];
    const REST: [f64; 4] = [0.0, 0.07, 0.0, 0.0];
    fn ordered(solution: &Solution<f64, 4>, t0: f64, t1: f64, promise: &Promise) {
        let ordered = |pair: &[f64]| (pair[0] < pair[1]) == (t0 < t1) && pair[0] != pair[1];
        assert!(solution.t()[0] == t0 && solution.last().0 == t1, "{promise:?} to {t1}");
        assert!(solution.t().windows(2).all(ordered), "{promise:?} to {t1}");
        assert!(solution.x().iter().all(|x| x.amax() < 1.0), "{promise:?} to {t1}");
    }
    fn fixed<F: OneStep<DoublePendulum, f64, 4> + Default>(promise: &Promise) {
        for (t0, t1, h, steps) in SPANS {
            let solution = Fixed::<F>::new(h)
                .solve(&double_pendulum(0.1), t0, t1, REST)
                .expect("regular");
            ordered(&solution, t0, t1, promise);
            assert_eq!(solution.t().len(), steps + 1, "{promise:?} to {t1} by {h}");
        }
        let still = Fixed::<F>::new(0.1)
            .solve(&double_pendulum(0.1), 3.0, 3.0, REST)
            .expect("nothing to do");
        assert_eq!(
            (still.t(), still.last(), still.statistics()),
            (&[3.0][..], (3.0, REST.into()), Statistics::default())
        );
    }
    fn adaptive<F: OneStep<DoublePendulum, f64, 4> + Estimates + Default>(promise: &Promise) {
        for (t0, t1, ..) in SPANS {
            ordered(
                &Adaptive::<F>::new()
                    .solve(&double_pendulum(0.1), t0, t1, REST)
                    .expect("regular"),
                t0,
                t1,
                promise,
            );
        }
        let still = Adaptive::<F>::new()
            .solve(&double_pendulum(0.1), 3.0, 3.0, REST)
            .expect("nothing to do");
        assert_eq!(
            (still.t(), still.last(), still.statistics()),
            (&[3.0][..], (3.0, REST.into()), Statistics::default())
        );
        assert_eq!(still.at(3.0), Ok(SVector::from(REST)));
        assert!(still.at(3.1).is_err());
    }
    testbed::each_adaptive!(fixed);
    testbed::each_without_estimate!(fixed);
    testbed::each_adaptive!(adaptive);
}

// Events

/// Checks that the position passes zero at `pi / 2 + k pi`.
fn passages(promise: &Promise, method: &impl Method<Spring, f64, 2>, within: f64) {
    let model = Spring::new(SpringParams {}).expect("physical");
    let zero = |_t: f64, x: &SVector<f64, 2>| x[0];
    let near = |found: &[Occurrence<f64, 2>], index: usize, expected: &[f64]| {
        let times: Vec<f64> = found
            .iter()
            .filter(|event| event.index == index)
            .map(|event| event.t)
            .collect();
        assert!(times.len() == expected.len(), "{promise:?}: {times:?}");
        assert!(
            std::iter::zip(&times, expected).all(|(t, k)| (t.abs() - k * PI).abs() < within),
            "{promise:?}: {times:?}"
        );
    };
    let events = [Event::new(zero), Event::new(zero).rising(), Event::new(zero).falling()];
    for t1 in [10.0, -10.0] {
        let solution = method
            .solve_with(&model, 0.0, t1, [1.0, 0.0], &events)
            .expect("regular");
        near(solution.events(), 0, &[0.5, 1.5, 2.5]);
        near(solution.events(), 1, &[1.5]);
        near(solution.events(), 2, &[0.5, 2.5]);
        assert_eq!(solution.last().0, t1);
    }
    // rebounds give `|cos t|`
    let wall = || Event::new(zero).falling().reset(|_t, x| SVector::from([x[0], -x[1]]));
    let solution = method
        .solve_with(&model, 0.0, 10.0, [1.0, 0.0], &[wall()])
        .expect("regular");
    near(solution.events(), 0, &[0.5, 1.5, 2.5]);
    assert!((solution.end()[0] - 10.0_f64.cos().abs()).abs() < within, "{promise:?}");
    let solution = method
        .solve_with(&model, 0.0, 10.0, [1.0, 0.0], &[wall().terminal()])
        .expect("regular");
    near(solution.events(), 0, &[0.5]);
    assert!(
        (solution.last().0 - 0.5 * PI).abs() < within && solution.end()[1] > 0.9,
        "{promise:?}"
    );
    // undefined at the start, or once the position is negative
    let undefined = Event::new(|_t: f64, _x: &SVector<f64, 2>| f64::NAN);
    let error = method
        .solve_with(&model, 0.0, 10.0, [1.0, 0.0], &[undefined])
        .expect_err("undefined");
    assert_eq!(
        (error.reason, error.t()),
        (Reason::EventNotFinite { event: 0, t: 0.0 }, 0.0)
    );
    let root = Event::new(|_t: f64, x: &SVector<f64, 2>| x[0].sqrt() + 1.0);
    let error = method
        .solve_with(&model, 0.0, 10.0, [1.0, 0.0], &[root])
        .expect_err("undefined");
    assert!(
        matches!(error.reason, Reason::EventNotFinite { event: 0, t } if t > 0.5 * PI),
        "{promise:?}: {error}"
    );
    assert!(
        error.t() < 0.5 * PI && (error.x()[0] - error.t().cos()).abs() < within,
        "{promise:?}: {error}"
    );
}

#[test]
fn events_are_found_when_they_occur() {
    fn fixed<F: OneStep<Spring, f64, 2> + Default>(promise: &Promise) {
        passages(promise, &Fixed::<F>::new(0.02), 1e-6);
    }
    fn adaptive<F: OneStep<Spring, f64, 2> + Estimates + Default>(promise: &Promise) {
        passages(promise, &Adaptive::<F>::new().rtol(1e-10).atol(1e-10), 1e-8);
    }
    testbed::each_adaptive!(fixed);
    testbed::each_without_estimate!(fixed);
    testbed::each_adaptive!(adaptive);
}
