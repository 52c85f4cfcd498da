//! Integrators against exact solutions and reference trajectories.

use std::cell::Cell;

use approx::assert_abs_diff_eq;
use pendulum_core::method::{Explicit, Fixed};
use pendulum_core::prelude::*;
use pendulum_core::tableau::{DormandPrince5, Kutta4, Tableau, Tsitouras5, Verner7, Verner9};
use pendulum_core::{OutsideSpan, Reason, Solution};
use testbed::eq22::Eq22;
use testbed::trajectories::scene;

// Observed orders

/// `x' = -2 t x^2`, `y' = 2 t exp(-y)`: nonlinear and time-dependent; see [`exact`].
fn curve(t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
    SVector::from([-2.0 * t * x[0] * x[0], 2.0 * t * (-x[1]).exp()])
}

/// Solution of [`curve`] with `x(0) = 1`, `y(0) = 0`.
fn exact(t: f64) -> SVector<f64, 2> {
    SVector::from([1.0 / (1.0 + t * t), (1.0 + t * t).ln()])
}

/// Largest errors of a solution of [`curve`]: at the accepted points, and between them.
fn errors(solution: &Solution<f64, 2>) -> (f64, f64) {
    let at_points = solution.points().map(|(t, x)| (x - exact(t)).amax());
    let between = solution.t().windows(2).flat_map(|pair| {
        let time = move |theta: f64| pair[0] + theta * (pair[1] - pair[0]);
        [0.2, 0.5, 0.7].map(time)
    });
    let dense = between.map(|t| (solution.at(t).expect("within") - exact(t)).amax());
    (at_points.fold(0.0, f64::max), dense.fold(0.0, f64::max))
}

/// Orders at which both of [`errors`] decrease when the step `h` is halved.
fn observed_orders<B: Tableau<S> + Default, const S: usize>(h: f64) -> (f64, f64) {
    let system = FnSystem(curve);
    let solve = |h: f64| Fixed::<Explicit<B, S>>::new(h).solve(&system, 0.0, 2.0, exact(0.0));
    let coarse = errors(&solve(h).expect("regular"));
    let fine = errors(&solve(h / 2.0).expect("regular"));
    ((coarse.0 / fine.0).log2(), (coarse.1 / fine.1).log2())
}

#[test]
fn errors_fall_with_the_order_of_the_method() {
    // the next term of the error is smaller by a factor of some hundredths, so orders are accurate to a quarter
    let (points, between) = observed_orders::<Kutta4, 5>(0.04);
    assert_abs_diff_eq!(points, 4.0, epsilon = 0.25);
    assert_abs_diff_eq!(between, 4.0, epsilon = 0.25);
    for (points, between) in [
        observed_orders::<DormandPrince5, 7>(0.04),
        observed_orders::<Tsitouras5, 7>(0.04),
    ] {
        assert_abs_diff_eq!(points, 5.0, epsilon = 0.25);
        assert_abs_diff_eq!(between, 5.0, epsilon = 0.25);
    }
}

/// Order at which the error of the dense output decreases with the length `h` of a single step from exact data.
fn observed_dense_order<B: Tableau<S> + Default, const S: usize>(h: f64) -> f64 {
    let system = FnSystem(curve);
    let error = |h: f64| {
        let method = Fixed::<Explicit<B, S>>::new(h);
        let mut stepper = method.stepper(&system, 0.5, 0.5 + h, exact(0.5)).expect("valid");
        stepper.step().expect("finite").expect("a step");
        let step = stepper.dense();
        let within = [0.2, 0.4, 0.6, 0.8].map(|theta| 0.5 + theta * h);
        let errors = within.map(|t| (step.at(t) - exact(t)).amax());
        errors.into_iter().fold(0.0, f64::max)
    };
    (error(h) / error(h / 2.0)).log2() - 1.0
}

#[test]
fn errors_of_high_order_fall_with_the_order_of_the_method() {
    // steps with errors above rounding are so long that the next term is visible: it adds up to 1 to the order
    let (points, between) = observed_orders::<Verner7, 11>(0.1);
    assert!(
        (7.0..8.0).contains(&points) && (7.0..8.0).contains(&between),
        "{points} {between}"
    );
    let (points, between) = observed_orders::<Verner9, 17>(1.0 / 3.0);
    assert!(
        (9.0..10.0).contains(&points) && (9.0..10.0).contains(&between),
        "{points} {between}"
    );
}

#[test]
fn dense_output_of_one_step_has_its_order() {
    assert_abs_diff_eq!(observed_dense_order::<Kutta4, 5>(0.02), 3.0, epsilon = 0.25);
    for order in [
        observed_dense_order::<DormandPrince5, 7>(0.02),
        observed_dense_order::<Tsitouras5, 7>(0.02),
    ] {
        assert_abs_diff_eq!(order, 4.0, epsilon = 0.25);
    }
}

#[test]
fn dense_output_is_smooth_across_the_points() {
    // values and slopes agree from both sides, up to rounding errors of a difference over 1e-6
    let system = FnSystem(curve);
    let solution = Rk45::new().solve(&system, 0.0, 2.0, exact(0.0)).expect("regular");
    for (t, x) in solution.points().skip(1).rev().skip(1) {
        let (before, after) = (
            solution.at(t - 1e-6).expect("within"),
            solution.at(t + 1e-6).expect("within"),
        );
        assert_eq!(solution.at(t).expect("within"), *x);
        assert_abs_diff_eq!((after - before) / 2e-6, curve(t, x), epsilon = 1e-8);
    }
}

// Accuracy

fn pendulum(name: &str, tolerance: f64, t1: f64) -> Solution<f64, 4> {
    let scene = scene(name);
    let method = Rk45::new().rtol(tolerance).atol(tolerance);
    method
        .solve(&scene.eq22(), 0.0, t1, scene.start::<4>())
        .expect("regular")
}

/// Distance of a solution from a reference scene at the time `t`.
fn distance(solution: &Solution<f64, 4>, name: &str, t: f64) -> f64 {
    let points = scene(name).points::<4>();
    let (_, reference) = points.into_iter().find(|point| point.0 == t).expect("time");
    (solution.at(t).expect("within") - SVector::from(reference)).amax()
}

#[test]
fn rk45_stays_near_the_reference_trajectories() {
    // the tolerance bounds the error of a step; errors of many steps add up and grow with the motion: damped swings
    // forget them (a factor of 8.8 observed after 20 s), chaotic ones stretch them by exp(1.45 t), which is 18 after 2
    // s (9.2 observed); the factors allow for twice the observed values, not more
    let cases = [
        ("paper_gamma_1", 20.0, 18.0),
        ("paper_gamma_0.4", 20.0, 18.0),
        ("paper_gamma_0.1", 20.0, 9.0),
        ("large_swing", 2.0, 18.0),
        ("irregular_plates", 10.0, 36.0),
    ];
    for (name, t1, factor) in cases {
        let solution = pendulum(name, 1e-10, t1);
        for &t in scene(name).times.iter().filter(|&&t| t <= t1) {
            let error = distance(&solution, name, t);
            assert!(error < factor * 1e-10, "{name} at {t}: {error:e}");
        }
    }
}

#[test]
fn rk4_reaches_the_reference_with_small_steps() {
    // 1e-3 s steps of a motion at a few rad/s: (1e-3 * 10)^4 = 1e-8, and much less where it is slow
    let scene = scene("large_swing");
    let solution = Rk4::new(1e-3).solve(&scene.eq22(), 0.0, 2.0, scene.start::<4>());
    let solution = solution.expect("regular");
    assert!(distance(&solution, "large_swing", 1.0) < 1e-8);
    assert!(distance(&solution, "large_swing", 2.0) < 1e-8);
}

#[test]
fn the_hand_written_jacobian_is_the_derivative() {
    // central differences: their own error is h^2 times third derivatives of about 100, and rounding errors over h
    let plate = scene("irregular_plates");
    let (model, t, h) = (plate.eq22(), 0.0, 1e-5);
    for x in plate.points::<4>().into_iter().map(|(_, x)| SVector::from(x)) {
        let jacobian = model.jacobian(t, &x);
        for column in 0..4 {
            let mut step = SVector::zeros();
            step[column] = h;
            let difference = (model.rhs(t, &(x + step)) - model.rhs(t, &(x - step))) / (2.0 * h);
            assert_abs_diff_eq!(jacobian.column(column).into_owned(), difference, epsilon = 1e-6);
        }
    }
}

// Time

#[test]
fn a_distant_origin_of_time_costs_what_it_resolves() {
    // the pendulum does not depend on time, so only the step lengths change, by up to an ulp of 1e9 s, 1.2e-7 s
    let model = Eq22::paper(0.1);
    let solve = |t0: f64| {
        let method = Rk45::new().rtol(1e-9).atol(1e-9);
        let solution = method.solve(&model, t0, t0 + 1.0, [0.0, 0.07, 0.0, 0.0]);
        solution.expect("regular").end()
    };
    assert_abs_diff_eq!(solve(0.0), solve(1e9), epsilon = 2e-9);
}

#[test]
fn the_last_step_is_never_a_tiny_one() {
    for i in 0..50 {
        let solution = pendulum("large_swing", 1e-8, 1.0 + 0.0137 * f64::from(i));
        let t = solution.t();
        let (before, last) = (t[t.len() - 2] - t[t.len() - 3], t[t.len() - 1] - t[t.len() - 2]);
        assert!(last > 0.5 * before, "{last} after {before}");
    }
}

#[test]
fn there_are_no_states_outside_of_the_span() {
    let solution = pendulum("large_swing", 1e-6, 1.0);
    assert_eq!(
        solution.at(1.0 + f64::EPSILON),
        Err(OutsideSpan {
            t: 1.0 + f64::EPSILON,
            start: 0.0,
            end: 1.0
        })
    );
    assert!(solution.at(-1e-300).is_err());
    assert!(solution.at(f64::NAN).is_err());
    assert!(solution.sample([0.5, 1.5]).is_err());
    let states = solution.sample((0..=10).map(|i| f64::from(i) / 10.0));
    let states = states.expect("within");
    assert_eq!((states.len(), states[10]), (11, solution.end()));
}

// Steps

#[test]
fn a_stepper_takes_the_steps_of_solve() {
    let scene = scene("large_swing");
    let (model, x0) = (scene.eq22(), scene.start::<4>());
    let solution = pendulum("large_swing", 1e-6, 5.0);
    let method = Rk45::new().rtol(1e-6).atol(1e-6);
    let mut stepper = method.stepper(&model, 0.0, 5.0, x0).expect("valid");
    let mut points = vec![(0.0, SVector::from(x0))];
    while let Some(step) = stepper.step().expect("regular") {
        assert_eq!((step.t0, step.x0), points[points.len() - 1]);
        assert_eq!(step.h, step.t1 - step.t0);
        let middle = step.t0 + 0.3 * step.h;
        assert_eq!(Ok(stepper.dense().at(middle)), solution.at(middle));
        points.push((step.t1, step.x1));
    }
    assert_eq!((stepper.t(), stepper.x()), solution.last());
    assert_eq!(stepper.statistics(), solution.statistics());
    assert!(stepper.step().expect("still at the end").is_none());
    let recorded = solution.t().iter().copied().zip(solution.x().iter().copied());
    assert!(recorded.eq(points));
}

#[test]
fn statistics_count_every_evaluation() {
    let count = Cell::new(0);
    let counting = FnSystem(|t: f64, x: &SVector<f64, 4>| {
        count.set(count.get() + 1);
        Eq22::paper(0.0).rhs(t, x)
    });
    let solution = Rk45::new().solve(&counting, 0.0, 10.0, [2.0, 2.5, 0.0, 0.0]);
    let statistics = solution.expect("regular").statistics();
    assert_eq!(statistics.evaluations, count.get());
    assert!(statistics.rejected > 0);
    // two for the first step size, then six for each step, accepted or rejected
    assert_eq!(
        statistics.evaluations,
        2 + 6 * (statistics.accepted + statistics.rejected)
    );
}

#[test]
fn the_bounds_of_the_steps_are_kept() {
    let model = Eq22::paper(0.1);
    let x0 = [0.0, 0.07, 0.0, 0.0];
    let method = Rk45::new().h0(1e-3).h_max(0.02);
    let solution = method.solve(&model, 0.0, 1.0, x0).expect("regular");
    assert_eq!(solution.t()[1], 1e-3);
    let longest = solution.t().windows(2).map(|pair| pair[1] - pair[0]);
    // plus an ulp: a step is the difference of two rounded times
    assert!(longest.fold(0.0, f64::max) <= 1.01 * 0.02 + f64::EPSILON);
    let solution = Rk45::new().h0(0.5).h_max(0.02).solve(&model, 0.0, 1.0, x0);
    assert_eq!(solution.expect("regular").t()[1], 0.02);
    let error = Rk45::new().rtol(1e-12).atol(1e-12).h_min(0.02);
    let error = error.solve(&model, 0.0, 1.0, x0).expect_err("too coarse");
    assert!(
        matches!(error.reason, Reason::StepUnderflow { least: 0.02, .. }),
        "{error}"
    );
}

#[test]
fn systems_may_be_borrowed_and_dynamic() {
    let model = Eq22::paper(0.1);
    let x0 = [0.0, 0.07, 0.0, 0.0];
    let method = Rk45::new();
    let direct = method.solve(&model, 0.0, 1.0, x0).expect("regular");
    let borrowed = method.solve(&&model, 0.0, 1.0, x0).expect("regular");
    let system: &dyn System<f64, 4> = &model;
    let dynamic = method.solve(system, 0.0, 1.0, x0).expect("regular");
    assert_eq!(direct, borrowed);
    assert_eq!(direct, dynamic);
}
