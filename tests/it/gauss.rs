//! Gauss-Legendre methods: orders, conserved quantities, and failures.

use approx::assert_abs_diff_eq;
use nalgebra::{SMatrix, SVector};
use pendulum_core::hybrid::{Mode, Status};
use pendulum_core::prelude::*;
use pendulum_core::{Canonical, Reason};
use testbed::trajectories::scene;

mechanism! {
    /// Two plates with m = I = c = d = 1, the pendulum of the reference trajectories.
    pub Pair {
        params { gamma: N m s = 0.0 }
        gravity: [0, -9.8, 0],
        generate: [rhs, energy, canonical],
        shape plate { mass: 1, com: [0, -1, 0], inertia: 1 }
        body upper on ground: plate { joint: revolute(z), coordinate: theta1 absolute, friction: gamma }
        body lower on upper: plate { joint: revolute(z) at [0, -1, 0], coordinate: theta2 absolute, friction: gamma }
    }
}

fn pair(gamma: f64) -> Pair {
    Pair::new(PairParams { gamma }).expect("physical")
}

const CHAOTIC: [f64; 4] = [2.0, 2.5, 0.0, 0.0];

fn end<M: Method<Pair, f64, 4>>(method: &M, model: &Pair, t1: f64, x0: [f64; 4]) -> SVector<f64, 4> {
    let mut stepper = method.stepper(model, 0.0, t1, x0).expect("regular");
    stepper.run().expect("regular")
}

// Observed orders

/// Order at which the error at `t` decreases when the step is halved, and the error of the shorter step.
fn order<M: Method<Pair, f64, 4>>(method: impl Fn(f64) -> M, h: f64, name: &str, t: f64) -> (f64, f64) {
    let scene = scene(name);
    let model = pair(scene.bodies[0].friction);
    let (_, exact) = *scene
        .points::<4>()
        .iter()
        .find(|(time, _)| *time == t)
        .expect("a time of the scene");
    let error = |h: f64| (end(&method(h), &model, t, scene.start()) - SVector::from(exact)).amax();
    let (coarse, fine) = (error(h), error(0.5 * h));
    ((coarse / fine).log2(), fine)
}

#[test]
fn errors_fall_with_the_order_of_the_method() {
    for (name, t) in [("large_swing", 2.0), ("paper_gamma_0.1", 5.0), ("paper_gamma_1", 2.0)] {
        let four = order(Gauss4::new, 0.02, name, t);
        let six = order(Gauss6::new, 0.05, name, t);
        assert_abs_diff_eq!(four.0, 4.0, epsilon = 0.1);
        assert_abs_diff_eq!(six.0, 6.0, epsilon = 0.1);
    }
}

#[test]
fn the_error_of_the_longest_falls_with_its_sixteenth_power() {
    // so long that the error of half the step is not only rounding
    for (name, t, h) in [
        ("large_swing", 2.0, 0.25),
        ("paper_gamma_0.1", 5.0, 1.0),
        ("paper_gamma_1", 2.0, 1.0),
    ] {
        let (order, error) = order(Gauss16::new, h, name, t);
        assert_abs_diff_eq!(order, 16.0, epsilon = 0.6);
        assert!(error < 1e-11, "{name}: {error:e}");
    }
}

#[test]
fn a_last_step_of_some_ulps_is_taken() {
    let model = pair(0.0);
    let there = end(&Gauss16::new(0.1), &model, 0.1, CHAOTIC);
    for ulps in 1..100 {
        let t1 = 0.1 * (1.0 + f64::from(ulps) * f64::EPSILON);
        assert_abs_diff_eq!(end(&Gauss16::new(0.1), &model, t1, CHAOTIC), there, epsilon = 1e-12);
    }
}

#[test]
fn the_reference_is_reached() {
    for (name, t) in [
        ("large_swing", 5.0),
        ("paper_gamma_0.1", 20.0),
        ("paper_gamma_0.4", 20.0),
    ] {
        let (_, error) = order(Gauss6::new, 0.01, name, t);
        assert!(error < 1e-11, "{name}: {error:e}");
    }
}

/// Order at which the error of the dense output decreases with the length of a single step.
fn dense_order<M: Method<Pair, f64, 4>>(method: impl Fn(f64) -> M, h: f64) -> f64 {
    let model = pair(0.1);
    let x0 = [1.2, -0.4, 2.0, -1.0];
    let error = |h: f64| {
        let mut stepper = method(h).stepper(&model, 0.0, h, x0).expect("regular");
        stepper.step().expect("regular");
        let dense = stepper.dense();
        let times = [0.2, 0.5, 0.7].map(|theta| theta * h);
        let errors = times.map(|t| (dense.at(t) - end(&Gauss6::new(h / 40.0), &model, t, x0)).amax());
        assert_eq!(dense.at(0.0), SVector::from(x0));
        assert_eq!(dense.at(h), stepper.x());
        errors.into_iter().fold(0.0, f64::max)
    };
    (error(h) / error(0.5 * h)).log2()
}

#[test]
fn dense_output_of_one_step_has_its_order() {
    // of order 3, 5 and 8: the error of one step has an order higher by one
    let orders = (dense_order(Gauss4::new, 0.02), dense_order(Gauss6::new, 0.02));
    assert_abs_diff_eq!(orders.0, 4.0, epsilon = 0.2);
    assert_abs_diff_eq!(orders.1, 6.0, epsilon = 0.2);
    assert_abs_diff_eq!(dense_order(Gauss16::new, 0.2), 9.0, epsilon = 0.5);
}

// Conserved quantities

/// Errors of these long steps are a thousand times larger than rounding errors, but the way back repeats them.
#[test]
fn forth_and_back_returns_to_the_start_up_to_rounding() {
    fn distances<M: Method<Pair, f64, 4>>(method: &M) -> [f64; 2] {
        let model = pair(0.0);
        let turn = end(method, &model, 2.0, CHAOTIC);
        let exact = SVector::from(scene("large_swing").points::<4>()[1].1);
        let back = method
            .stepper(&model, 2.0, 0.0, turn)
            .expect("regular")
            .run()
            .expect("regular");
        [(turn - exact).amax(), (back - SVector::from(CHAOTIC)).amax()]
    }
    for [there, back] in [distances(&Gauss4::new(0.05)), distances(&Gauss6::new(0.1))] {
        assert!(there > 1e-6 && back < 1e-13, "{there:e}, {back:e}");
    }
}

mechanism! {
    /// Two rods in free flight in a plane.
    pub Rods {
        generate: [rhs, canonical, momentum],
        body along on ground { joint: prismatic(x), coordinate: x }
        body across on along { joint: prismatic(y), coordinate: y }
        body first on across { mass: 1, com: [0.5, 0, 0], inertia: 0.1, joint: revolute(z),
            coordinate: theta1 absolute }
        body second on first { mass: 0.7, com: [0.2, 0.3, 0], inertia: 0.05, joint: revolute(z) at [1, 0, 0],
            coordinate: theta2 absolute }
    }
}

/// Linear and quadratic invariants, here the angular momentum `x p_y - y p_x + p_1 + p_2`, are conserved up to rounding
/// errors.
#[test]
fn momenta_are_conserved_up_to_rounding() {
    let model = Rods::new(RodsParams {}).expect("physical");
    let momenta = |x: &SVector<f64, 8>| {
        let p = model.momentum(0.0, x);
        [p[0], p[1], x[0] * p[1] - x[1] * p[0] + p[2] + p[3]]
    };
    let x0 = SVector::from([0.1, -0.2, 0.5, 1.5, 0.2, -0.1, 3.0, -4.0]);
    let start = momenta(&x0);
    let mut stepper = Gauss4::new(0.02).stepper(&model, 0.0, 200.0, x0).expect("regular");
    let mut worst = [0.0_f64; 3];
    while let Some(step) = stepper.step().expect("regular") {
        for (worst, (now, start)) in worst.iter_mut().zip(momenta(&step.x1).into_iter().zip(start)) {
            *worst = worst.max((now - start).abs());
        }
    }
    assert_eq!(stepper.statistics().accepted, 10_000);
    // it flies 400 m away, and the terms of the angular momentum grow to 1500
    assert!(worst[0] < 1e-14 && worst[1] < 1e-14 && worst[2] < 4e-12, "{worst:?}");
}

// Failures

/// A free body of mass 1 on a line. From one time on its mass is zero, or from another its rates are NaN.
struct Line {
    massless: f64,
    unknown: f64,
}

impl System<f64, 2> for Line {
    fn rhs(&self, _t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        SVector::from([x[1], 0.0])
    }
}

impl Canonical<f64, 2> for Line {
    fn canonical(&self, t: f64, x: &SVector<f64, 2>) -> (SVector<f64, 2>, SVector<f64, 2>) {
        let force = if t > self.unknown { f64::NAN } else { 0.0 };
        (*x, SVector::from([x[1], force]))
    }

    fn canonical_jacobian(&self, t: f64, _x: &SVector<f64, 2>) -> (SMatrix<f64, 2, 2>, SMatrix<f64, 2, 2>) {
        let mass = if t > self.massless { 0.0 } else { 1.0 };
        (
            SMatrix::from([[1.0, 0.0], [0.0, mass]]),
            SMatrix::from([[0.0, 0.0], [1.0, 0.0]]),
        )
    }
}

#[test]
fn what_has_no_solution_is_an_error_with_the_last_good_state() {
    let never = f64::INFINITY;
    let fails = |massless: f64, unknown: f64| {
        let error = Gauss6::new(0.25)
            .solve(&Line { massless, unknown }, 0.0, 2.0, [0.0, 1.0])
            .err()?;
        assert_abs_diff_eq!(error.x(), SVector::from([error.t(), 1.0]), epsilon = 1e-15);
        Some((error.reason, error.t()))
    };
    assert_eq!(fails(never, never), None);
    assert_eq!(fails(1.1, never), Some((Reason::NoConvergence { h: 0.25 }, 1.0)));
    assert_eq!(
        fails(never, 1.1),
        Some((
            Reason::NonFinite {
                component: 1,
                h: Some(0.25)
            },
            1.0
        ))
    );
}

#[test]
fn steps_that_are_far_too_long_do_not_converge() {
    let model = pair(0.0);
    let error = Gauss4::new(3.0)
        .solve(&model, 0.0, 30.0, CHAOTIC)
        .expect_err("no solution near the start");
    assert!(matches!(error.reason, Reason::NoConvergence { .. }), "{error}");
}

// Scenes with constraints

mechanism! {
    /// A double pendulum whose joints rebound from stops, and whose tip rebounds from a wall.
    pub Bouncing {
        params { e: 1 = 1, mu: N m = 0, side: m = 1 }
        gravity: [0, -9.8, 0],
        generate: [rhs, energy, canonical],
        shape plate { mass: 1, com: [0, -1, 0], inertia: 1 }
        point tip on lower at [0, -1, 0],
        wall side { gap: side - tip.x, restitution: e }
        body upper on ground: plate { joint: revolute(z), coordinate: a, dry_friction: mu,
            stop: [-1.5, 1.5] restitution(e) }
        body lower on upper: plate {
            joint: revolute(z) at [0, -1, 0], coordinate: b, dry_friction: mu/2, stop: [-2, 2] restitution(e),
        }
    }
}

/// Largest energy errors in the first and in the second half of a long motion, and the number of mode switches.
fn energy_errors<S>(model: &S, start: [f64; 4]) -> ([f64; 2], usize)
where
    S: Canonical<f64, 4> + Energy<f64, 4>,
{
    let (t1, start) = (200.0, SVector::from(start));
    let energy = model.energy(0.0, &start);
    let mut stepper = Gauss4::new(0.02).stepper(model, 0.0, t1, start).expect("valid");
    let (mut largest, mut changes, mut since) = ([0.0_f64; 2], 0, 0.0);
    while let Some(step) = stepper.step().expect("regular") {
        let half = usize::from(step.t1 > 0.5 * t1);
        largest[half] = largest[half].max((model.energy(step.t1, &step.x1) - energy).abs());
        if let Some((from, _)) = stepper.mode() {
            changes += usize::from(from != since);
            since = from;
        }
    }
    (largest, changes)
}

#[test]
#[ignore = "takes long"]
fn the_energy_does_not_drift_over_many_elastic_impacts() {
    let wide = Bouncing::new(BouncingParams {
        e: 1.0,
        mu: 0.0,
        side: 10.0,
    })
    .expect("physical");
    let narrow = Bouncing::new(BouncingParams {
        e: 1.0,
        mu: 0.0,
        side: 0.5,
    })
    .expect("physical");
    let start = [-1.2, 1.5, 0.0, 0.0];
    let (free, none) = energy_errors(&pair(0.0), [-1.2, 0.3, 0.0, 0.0]);
    assert_eq!(none, 0);
    for (model, least) in [(wide, 30), (narrow, 70)] {
        let ([early, late], impacts) = energy_errors(&model, start);
        assert!(impacts > least, "{impacts} impacts");
        assert!(
            late < 1.2 * early && late < 1.2 * free[0].max(free[1]),
            "{early:e} {late:e}, without {free:?}"
        );
    }
}

#[test]
fn errors_fall_with_the_order_through_friction_and_impacts() {
    let model = Bouncing::new(BouncingParams {
        e: 0.5,
        mu: 1.5,
        side: 0.7,
    })
    .expect("physical");
    let (start, t1) = ([-1.4, 0.5, 0.0, 0.0], 8.0);
    let tight = Vern9::new().rtol(1e-13).atol(1e-13);
    let reference = tight.solve(&model, 0.0, t1, start).expect("regular");
    let stuck = |n: usize| move |(_, mode): &&(f64, Mode)| mode.0[n] == Status::Stuck;
    assert!(reference.modes().len() > 8, "{:?}", reference.modes());
    assert!(
        reference.modes().iter().any(|mode| stuck(0)(&mode)) && reference.modes().iter().any(|mode| stuck(1)(&mode))
    );
    macro_rules! errors {
        ($method:ident, $h:expr) => {
            [$h, 0.5 * $h].map(|h| {
                let solution = $method::new(h).solve(&model, 0.0, t1, start).expect("regular");
                assert_eq!(solution.modes().len(), reference.modes().len());
                let modes = solution.modes().iter().zip(reference.modes());
                for pair in solution.modes().windows(2) {
                    let ((from, mode), (to, _)) = (pair[0], pair[1]);
                    let x = solution.at(0.5 * (from + to)).expect("inside");
                    for n in (0..2).filter(|&n| mode.0[n].is_held()) {
                        assert!(x[2 + n] == 0.0, "{x} in {mode:?}");
                    }
                }
                let apart = (solution.end() - reference.end()).amax();
                modes.fold(apart, |most, ((t, mode), (exact, same))| {
                    assert_eq!(mode, same);
                    most.max((t - exact).abs())
                })
            })
        };
    }
    let [coarse, fine] = errors!(Gauss4, 0.02);
    assert_abs_diff_eq!((coarse / fine).log2(), 4.0, epsilon = 0.2);
    let [coarse, fine] = errors!(Gauss6, 0.04);
    assert_abs_diff_eq!((coarse / fine).log2(), 6.0, epsilon = 0.4);
    assert!(fine < 1e-11, "{fine:e}");
}
