//! Tests of the accuracy measurement, on systems whose solutions and errors are known in closed form.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use pendulum_core::Reason;
use pendulum_core::accuracy::{Errors, Failure, Measured, Problem, Reference, Report, Sweep};
use pendulum_core::prelude::*;

/// Mass on a spring: `x'' = -x`, energy `(x^2 + x'^2) / 2`.
struct Spring;

impl System<f64, 2> for Spring {
    fn rhs(&self, _t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        SVector::from([x[1], -x[0]])
    }
}

impl Energy<f64, 2> for Spring {
    fn kinetic(&self, _t: f64, x: &SVector<f64, 2>) -> f64 {
        0.5 * x[1] * x[1]
    }

    fn potential(&self, _t: f64, x: &SVector<f64, 2>) -> f64 {
        0.5 * x[0] * x[0]
    }
}

/// Motion of [`Spring`] from rest at 1.
fn turning(t: f64) -> SVector<f64, 2> {
    SVector::from([t.cos(), -t.sin()])
}

/// `x' = x^2`, which diverges at `t = 1` if it is 1 at 0, and returns from minus infinity.
fn explodes(_t: f64, x: &SVector<f64, 1>) -> SVector<f64, 1> {
    x.component_mul(x)
}

const HALVED: [f64; 3] = [0.1, 0.05, 0.025];

fn rk4_on_the_spring() -> Report {
    let reference = Reference::exact(turning);
    let problem = Problem::new(&Spring, 0.0, 10.0, [1.0, 0.0], &reference).energy(0.25);
    Sweep::new(problem).rounds(3).method("Rk4", HALVED, Rk4::new).run()
}

fn all(report: &Report) -> Vec<Measured> {
    report.methods[0].measured().map(|(_, measured)| *measured).collect()
}

#[test]
fn every_norm_falls_with_its_order() {
    let report = rk4_on_the_spring();
    let errors: Vec<_> = all(&report).iter().map(|measured| measured.errors).collect();
    for pair in errors.windows(2) {
        let order = |norm: fn(&Errors) -> f64| (norm(&pair[0]) / norm(&pair[1])).log2();
        assert_abs_diff_eq!(order(|e| e.last), 4.0, epsilon = 0.1);
        assert_abs_diff_eq!(order(|e| e.largest.expect("known")), 4.0, epsilon = 0.1);
        // The dense output is of order 3, so its error in one step is proportional to h^4.
        assert_abs_diff_eq!(order(|e| e.dense.expect("known")), 4.0, epsilon = 0.1);
        // On a linear oscillator the energy is one order better.
        assert_abs_diff_eq!(order(|e| e.energy.expect("known")), 5.0, epsilon = 0.1);
        assert!(pair[0].last <= pair[0].largest.expect("known"));
    }
}

/// A step of RK4 multiplies the energy of an oscillator by `1 - h^6 / 72 + h^8 / 576`: the squared modulus of its
/// stability function on the imaginary axis.
#[test]
fn the_energy_is_off_by_what_the_method_loses() {
    for (h, measured) in HALVED.into_iter().zip(all(&rk4_on_the_spring())) {
        let growth = -h.powi(6) / 72.0 + h.powi(8) / 576.0;
        let lost = 0.5 * -((10.0 / h).round() * growth.ln_1p()).exp_m1();
        assert_relative_eq!(measured.errors.energy.expect("known"), lost / 0.25, max_relative = 1e-5);
    }
}

/// A step of RK4 multiplies `x + i x'` by `1 + z + z^2 / 2 + z^3 / 6 + z^4 / 24` at `z = -i h`.
#[test]
fn errors_are_absolute_and_of_the_largest_component() {
    for (h, measured) in HALVED.into_iter().zip(all(&rk4_on_the_spring())) {
        let (re, im) = (1.0 - h * h / 2.0 + h.powi(4) / 24.0, -h + h.powi(3) / 6.0);
        let factor = (re.hypot(im), im.atan2(re));
        let steps = (10.0 / h).round();
        let (modulus, turn) = (factor.0.powf(steps), steps * factor.1);
        let end = SVector::from([modulus * turn.cos(), modulus * turn.sin()]);
        assert_relative_eq!(measured.errors.last, (end - turning(10.0)).amax(), max_relative = 1e-5);
    }
}

#[test]
fn work_is_that_of_the_steps_alone() {
    for (h, measured) in HALVED.into_iter().zip(all(&rk4_on_the_spring())) {
        let steps = (10.0 / h).round() as usize;
        let work = measured.work.expect("a single trajectory");
        assert_eq!(
            (work.accepted, work.rejected, work.evaluations),
            (steps, 0, 4 * steps + 1)
        );
        assert!(0.0 < measured.minimum && measured.minimum <= measured.median);
    }
    // Vern7 takes five more evaluations per step for its dense output, which are not counted.
    let reference = Reference::exact(turning);
    let problem = Problem::new(&Spring, 0.0, 1.0, [1.0, 0.0], &reference);
    let method = |tol: f64| Vern7::new().rtol(tol).atol(tol);
    let report = Sweep::new(problem).rounds(1).method("Vern7", [1e-6], method).run();
    let mut stepper = method(1e-6).stepper(&Spring, 0.0, 1.0, [1.0, 0.0]).expect("valid");
    stepper.run().expect("regular");
    assert_eq!(all(&report)[0].work, Some(stepper.statistics()));
}

#[test]
fn a_failed_run_is_no_error_of_zero() {
    let system = FnSystem(explodes);
    let reference = Reference::exact(|t| SVector::from([1.0 / (1.0 - t)]));
    let problem = Problem::new(&system, 0.0, 2.0, [1.0], &reference);
    let report = Sweep::new(problem)
        .rounds(1)
        .method("Rk45", [1e-6, 1e-20], |tol| Rk45::new().rtol(tol).atol(tol))
        .method("short of breath", [1e-6], |tol| Rk45::new().rtol(tol).max_steps(5))
        .run();
    let failure = |series: usize, run: usize| {
        let outcome = &report.methods[series].runs[run].outcome;
        *outcome.as_ref().expect_err("there is no way through")
    };
    // errors of 1e-6 of the solution shift the pole by as much
    assert_abs_diff_eq!(failure(0, 0).t, 1.0, epsilon = 1e-6);
    assert!(matches!(
        failure(0, 0).reason,
        Reason::StepUnderflow { .. } | Reason::NonFinite { .. }
    ));
    assert!(matches!(
        failure(0, 1).reason,
        Reason::InvalidInput { what: "rtol", .. }
    ));
    assert_eq!(failure(1, 0).reason, Reason::TooManySteps { max_steps: 5 });
    assert!(report.time_to_reach(f64::INFINITY).all(|(_, found)| found.is_none()));
    assert_eq!(report.methods[0].measured().count(), 0);
    assert_eq!(report.to_string().matches("stopped at t = ").count(), 3);
}

#[test]
fn the_cheapest_setting_that_is_good_enough() {
    let mut report = rk4_on_the_spring();
    // longer steps take less time, independently of the load of the machine
    for run in &mut report.methods[0].runs {
        run.outcome.as_mut().expect("regular").minimum = 1.0 / run.setting;
    }
    let last: Vec<f64> = all(&report).iter().map(|measured| measured.errors.last).collect();
    let pick = |report: &Report, error: f64| {
        let (name, found) = report.time_to_reach(error).next().expect("a series");
        assert_eq!(name, "Rk4");
        found.map(|(setting, _)| setting)
    };
    assert_eq!(pick(&report, last[0]), Some(0.1));
    assert_eq!(pick(&report, 0.999 * last[0]), Some(0.05));
    assert_eq!(pick(&report, 0.999 * last[2]), None);
    // Errors below the uncertainty of the reference cannot be reached.
    let mut unsure = report;
    unsure.uncertainty = 2.0 * last[0];
    assert_eq!(pick(&unsure, last[0]), None);
}

#[test]
fn a_computed_reference_knows_its_uncertainty() {
    let reference = Reference::integrate(&Spring, 0.0, 10.0, [1.0, 0.0]).expect("regular");
    let uncertainty = reference.uncertainty(10.0);
    assert!(0.0 < uncertainty && uncertainty < 1e-13, "{uncertainty:e}");
    for n in 0..=100 {
        let t = 0.1 * f64::from(n);
        let error = (reference.at(t).expect("within") - turning(t)).amax();
        assert!(error <= 2.0 * uncertainty, "{error:e} at {t}");
    }
    assert_eq!(reference.at(10.1), None);
    assert_eq!(reference.uncertainty(10.1), f64::INFINITY);
}

#[test]
fn solutions_are_trusted_as_far_as_they_agree() {
    // An initial error of 1e-6 persists on the spring: all of it is in x at the turning points, and many steps come
    // close to these.
    let solve = |x0: f64, t1: f64| Vern9::new().h_max(0.1).solve(&Spring, 0.0, t1, [x0, 0.0]);
    let best = solve(1.0, 10.0).expect("regular");
    let reference = Reference::solutions(best.clone(), &solve(1.0 + 1e-6, 10.0).expect("regular"));
    assert_relative_eq!(
        reference.expect("the same span").uncertainty(5.0),
        1e-6,
        max_relative = 1e-2
    );
    for t1 in [9.0, 11.0] {
        assert!(Reference::solutions(best.clone(), &solve(1.0, t1).expect("regular")).is_err());
    }
}

#[test]
fn points_know_nothing_between() {
    let points = [5.0, 10.0].map(|t| (t, turning(t)));
    let reference = Reference::points(points, 1e-16);
    assert_eq!(reference.at(5.0), Some(turning(5.0)));
    assert_eq!((reference.at(6.0), reference.uncertainty(6.0)), (None, f64::INFINITY));
    assert_eq!(reference.uncertainty(10.0), 1e-16);
    let solution = Rk4::new(0.3).solve(&Spring, 0.0, 10.0, [1.0, 0.0]).expect("regular");
    let errors = Errors::of(&solution, &reference).expect("the end is known");
    let at = |t: f64| (solution.at(t).expect("within") - turning(t)).amax();
    assert_eq!(errors.last, at(10.0));
    assert_eq!((errors.largest, errors.dense), (None, Some(at(5.0).max(at(10.0)))));
    // no errors without a reference at the end
    assert_eq!(
        Errors::of(&solution, &Reference::points([(5.0, turning(5.0))], 0.0)),
        None
    );
}

#[test]
fn better_points_count_before_the_curve() {
    let wrong = Reference::exact(|t| turning(t) * 2.0);
    let reference = wrong.with_points([(10.0, turning(10.0))], 1e-17);
    assert_eq!(reference.at(10.0), Some(turning(10.0)));
    assert_eq!(reference.at(9.0), Some(turning(9.0) * 2.0));
    assert_eq!((reference.uncertainty(10.0), reference.uncertainty(9.0)), (1e-17, 0.0));
}

#[test]
#[should_panic(expected = "the reference has no state at the end, t = 11")]
fn a_problem_wants_to_know_its_end() {
    let reference = Reference::points([(10.0, turning(10.0))], 0.0);
    let _ = Problem::new(&Spring, 0.0, 11.0, [1.0, 0.0], &reference);
}

mechanism! {
    Swing {
        params { l: m = 1.0 }
        gravity: [0, -9.81, 0],
        body bob on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: angle }
    }
}

#[test]
fn an_ensemble_is_judged_by_its_first_trajectory() {
    let swing = Swing::new(SwingParams::default()).expect("physical");
    let reference = Reference::integrate(&swing, 0.0, 2.0, [1.0, 0.0]).expect("regular");
    let more: Vec<_> = (1..40)
        .map(|n| SVector::from([1.0 + 1e-3 * f64::from(n), 0.0]))
        .collect();
    let far = [SVector::from([f64::NAN, 0.0])];
    let problem = Problem::new(&swing, 0.0, 2.0, [1.0, 0.0], &reference);
    let report = Sweep::new(problem)
        .rounds(1)
        .method("alone", [0.01], Rk4::new)
        .ensemble("many", [0.01], &more, Rk4::new)
        .ensemble("one fails", [0.01, -1.0], &far, Rk4::new)
        .run();
    let last = |series: usize| report.methods[series].measured().next().expect("regular").1.errors.last;
    assert_eq!(last(0), last(1));
    let failure = |run: usize| {
        *report.methods[2].runs[run]
            .outcome
            .as_ref()
            .expect_err("one is not finite")
    };
    assert!(matches!(failure(0).reason, Reason::InvalidInput { what: "x0", .. }));
    assert!(matches!(failure(1).reason, Reason::InvalidInput { what: "h", .. }));
}

#[test]
fn other_solvers_are_measured_alike() {
    let reference = Reference::exact(turning);
    let problem = Problem::new(&Spring, 0.0, 10.0, [1.0, 0.0], &reference);
    let stopped = Failure {
        t: 4.0,
        reason: Reason::NoConvergence { h: 0.5 },
    };
    let late = |error: f64| {
        if error < 1.0 {
            Ok(turning(10.0 + error))
        } else {
            Err(stopped)
        }
    };
    let report = Sweep::new(problem).rounds(1).other("late", [1e-5, 1.0], late).run();
    let measured = &all(&report)[..];
    assert_eq!(measured.len(), 1);
    let expected = 1e-5 * (10.0_f64).cos().abs();
    assert_relative_eq!(measured[0].errors.last, expected, max_relative = 1e-4);
    assert_eq!(report.methods[0].runs[1].outcome.as_ref().err(), Some(&stopped));
}
