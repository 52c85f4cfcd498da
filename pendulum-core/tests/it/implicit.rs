//! Rosenbrock and Radau methods on problems with known answers.

use std::cell::Cell;

use pendulum_core::StateLayout;
use pendulum_core::method::{Fixed, RadauIIA, Rosenbrock};
use pendulum_core::prelude::*;
use pendulum_core::tableau;
use pendulum_core::{Real, Reason};

type FixedRodas4 = Fixed<Rosenbrock<tableau::HairerWanner4, 6>>;
type FixedRodas5P = Fixed<Rosenbrock<tableau::Steinebach5, 8>>;
type FixedRadau5 = Fixed<RadauIIA>;
type FixedRadau9 = Fixed<RadauIIA<5, 2>>;
type FixedRadau13 = Fixed<RadauIIA<7, 3>>;

/// `x = (1 / (1 + t^2), exp(sin(t)))`: nonautonomous, nonlinear, not stiff.
struct Known;

impl Known {
    /// Factor of `x_0 x_1^2` in the second component.
    fn factor<T: Real>(t: T) -> T {
        let (sin, cos) = t.sin_cos();
        cos * (-sin).exp() * (T::from_f64(1.0) + t * t)
    }
}

impl<T: Real> System<T, 2> for Known {
    fn rhs(&self, t: T, x: &SVector<T, 2>) -> SVector<T, 2> {
        SVector::from([-((t + t) * x[0] * x[0]), Self::factor(t) * x[0] * x[1] * x[1]])
    }
}

impl<T: Real> Jacobian<T, 2> for Known {
    fn jacobian(&self, t: T, x: &SVector<T, 2>) -> SMatrix<T, 2, 2> {
        let factor = Self::factor(t);
        SMatrix::from([
            [-((t + t) * (x[0] + x[0])), factor * x[1] * x[1]],
            [T::default(), factor * x[0] * (x[1] + x[1])],
        ])
    }
}

fn known(t: f64) -> SVector<f64, 2> {
    SVector::from([1.0 / (1.0 + t * t), t.sin().exp()])
}

/// The problem of A. Prothero and A. Robinson (Math. Comput. 28 (1974) 145-162): `x = sin(t)` for any rate.
struct Follower {
    rate: f64,
}

impl System<f64, 1> for Follower {
    fn rhs(&self, t: f64, x: &SVector<f64, 1>) -> SVector<f64, 1> {
        SVector::from([-self.rate * (x[0] - t.sin()) + t.cos()])
    }
}

impl Jacobian<f64, 1> for Follower {
    fn jacobian(&self, _t: f64, _x: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> {
        SMatrix::from([[-self.rate]])
    }

    fn time_derivative(&self, t: f64, _x: &SVector<f64, 1>) -> SVector<f64, 1> {
        SVector::from([self.rate * t.cos() - t.sin()])
    }
}

/// `x' = z x`.
struct Linear {
    z: f64,
}

impl System<f64, 1> for Linear {
    fn rhs(&self, _t: f64, x: &SVector<f64, 1>) -> SVector<f64, 1> {
        x * self.z
    }
}

impl Jacobian<f64, 1> for Linear {
    fn jacobian(&self, _t: f64, _x: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> {
        SMatrix::from([[self.z]])
    }
}

/// Observed orders, from the errors at step sizes 1, 1/2, 1/4, .. of the first.
fn orders(errors: &[f64]) -> Vec<f64> {
    errors.windows(2).map(|pair| (pair[0] / pair[1]).log2()).collect()
}

fn end<M: Method<S, f64, N>, S: System<f64, N>, const N: usize>(
    method: M,
    system: &S,
    (t0, t1): (f64, f64),
    x0: impl pendulum_core::IntoState<f64, N>,
) -> SVector<f64, N> {
    method.solve(system, t0, t1, x0).expect("regular").end()
}

/// Solution at time 1 from the state 1, in one step of each method.
fn in_one_step(system: &Linear) -> [f64; 5] {
    [
        end(FixedRodas4::new(1.0), system, (0.0, 1.0), [1.0])[0],
        end(FixedRodas5P::new(1.0), system, (0.0, 1.0), [1.0])[0],
        end(FixedRadau5::new(1.0), system, (0.0, 1.0), [1.0])[0],
        end(FixedRadau9::new(1.0), system, (0.0, 1.0), [1.0])[0],
        end(FixedRadau13::new(1.0), system, (0.0, 1.0), [1.0])[0],
    ]
}

/// Runs a test for each method with its expected values and the first of its step sizes.
macro_rules! for_each {
    ($test:ident: $rodas4:expr, $rodas5p:expr, $radau5:expr, $radau9:expr, $radau13:expr) => {
        $test(FixedRodas4::new, $rodas4);
        $test(FixedRodas5P::new, $rodas5p);
        $test(FixedRadau5::new, $radau5);
        $test(FixedRadau9::new, $radau9);
        $test(FixedRadau13::new, $radau13);
    };
}

#[test]
fn the_order_shows_on_a_problem_that_is_not_autonomous() {
    fn check<M: Method<Known, f64, 2>>(method: fn(f64) -> M, (order, h): (f64, f64)) {
        let error = |h| (end(method(h), &Known, (0.0, 2.0), known(0.0)) - known(2.0)).amax();
        let errors = [h, 0.5 * h].map(error);
        let orders = orders(&errors);
        // 9.3 and 13.8 at the large steps of the last two, at which the errors are not those of rounding
        assert!((orders[0] - order).abs() < 0.07 * order, "{orders:?} {errors:?}");
        assert!(errors[1] < 1e-6, "{errors:?}");
    }
    for_each!(check: (4.0, 0.02), (5.0, 0.02), (5.0, 0.02), (9.0, 0.4), (13.0, 0.8));
}

#[test]
fn dense_output_has_its_order() {
    fn check<M: Method<Known, f64, 2>>(method: fn(f64) -> M, (order, h): (f64, f64)) {
        let error = |h: f64| {
            let solution = method(h).solve(&Known, 1.0, 1.0 + h, known(1.0)).expect("regular");
            let t = 1.0 + 0.7 * h;
            (solution.at(t).expect("within") - known(t)).amax()
        };
        // within one step: one more than the order
        let orders = orders(&[h, 0.5 * h].map(error));
        // 7.4 in place of 8 at the large steps of the last, at which the errors are not those of rounding
        assert!((orders[0] - order - 1.0).abs() < 0.05 * order + 0.3, "{orders:?}");
    }
    for_each!(check: (3.0, 0.025), (4.0, 0.025), (3.0, 0.025), (5.0, 0.1), (7.0, 0.4));
}

#[test]
fn a_stiff_follower_is_followed() {
    fn check<M: Method<Follower, f64, 1>>(method: fn(f64) -> M, (order, most, h): (f64, f64, f64)) {
        let follower = Follower { rate: 1e6 };
        let error = |h| (end(method(h), &follower, (0.0, 2.0), [0.0])[0] - 2.0_f64.sin()).abs();
        let errors = [h, 0.5 * h, 0.25 * h].map(error);
        // For large rates the order is reduced, but the error is divided by the rate, since the fast mode has decayed
        // at the end of a step.
        assert!((orders(&errors)[1] - order).abs() < 0.1, "{errors:?}");
        assert!(errors[2] < most, "{errors:?}");
    }
    for_each!(
        check: (1.0, 1e-9, 0.1), (3.0, 1e-12, 0.1), (3.0, 1e-12, 0.1), (5.0, 1e-11, 1.0), (7.0, 1e-12, 2.0)
    );
}

#[test]
fn a_fast_start_is_resolved_within_the_tolerance() {
    fn check<M: Method<Follower, f64, 1>>(method: M) {
        let follower = Follower { rate: 1e3 };
        let solution = method.solve(&follower, 0.0, 1.0, [2.0]).expect("regular");
        let exact = |t: f64| t.sin() + 2.0 * (-1e3 * t).exp();
        let error = solution.points().map(|(t, x)| (x[0] - exact(t)).abs());
        let worst = error.fold(0.0, f64::max);
        assert!(worst < 1e-5, "{worst:e}");
    }
    // the first step is rejected; the error estimate after it must be sound
    check(Rodas4::new().rtol(1e-5).atol(1e-5).h0(1.0));
    check(Rodas5P::new().rtol(1e-5).atol(1e-5).h0(1.0));
    check(Radau5::new().rtol(1e-5).atol(1e-5).h0(1.0));
    check(Radau9::new().rtol(1e-5).atol(1e-5).h0(1.0));
    check(Radau13::new().rtol(1e-5).atol(1e-5).h0(1.0));
}

#[test]
fn linear_equations_take_one_iteration_and_one_more_to_see_it() {
    let solution = FixedRadau5::new(0.5)
        .solve(&Linear { z: -3.0 }, 0.0, 5.0, [1.0])
        .expect("regular");
    let work = solution.statistics();
    assert_eq!((work.accepted, work.factorizations, work.jacobians), (10, 20, 11));
    assert!(work.iterations <= 20, "{}", work.iterations);
}

#[test]
fn what_is_infinitely_stiff_dies_out_in_one_step() {
    for x in in_one_step(&Linear { z: -1e10 }) {
        assert!(x.abs() < 1e-8, "{x}");
    }
    for z in [-0.5_f64, -2.0, -10.0, -100.0, -1e4] {
        let after = in_one_step(&Linear { z });
        assert!(after.iter().all(|x| x.abs() < 1.0), "{z}: {after:?}");
        // The stability function of Radau IIA is the Padé approximation (2, 3) of the exponential: Hairer and Wanner
        // II, Table IV.5.6.
        let pade = (1.0 + 0.4 * z + 0.05 * z * z) / (1.0 - 0.6 * z + 0.15 * z * z - z * z * z / 60.0);
        assert!((after[2] - pade).abs() < 1e-14, "{z}");
    }
}

/// A system given by its right-hand side and Jacobian as functions of the state.
fn of<const N: usize>(
    f: impl Fn(&SVector<f64, N>) -> SVector<f64, N>,
    g: impl Fn(&SVector<f64, N>) -> SMatrix<f64, N, N>,
) -> impl Jacobian<f64, N> {
    FnSystem::with_jacobian(move |_t, x: &_| f(x), move |_t, x: &_| g(x))
}

#[test]
fn chemistry_of_robertson() {
    let rates = |x: &SVector<f64, 3>| {
        let (slow, fast, square) = (0.04 * x[0], 1e4 * x[1] * x[2], 3e7 * x[1] * x[1]);
        SVector::from([fast - slow, slow - fast - square, square])
    };
    let jacobian = |x: &SVector<f64, 3>| {
        SMatrix::from([
            [-0.04, 0.04, 0.0],
            [1e4 * x[2], -1e4 * x[2] - 6e7 * x[1], 6e7 * x[1]],
            [1e4 * x[1], -1e4 * x[1], 0.0],
        ])
    };
    let robertson = of(rates, jacobian);
    // Radau IIA of order 13 in 32 digits with mpmath; tolerances of 1e-8 and 1e-10 agree in these digits.
    let expected = [
        0.107_300_428_537_804_04,
        4.800_166_972_571_66e-7,
        0.892_699_091_445_498_7,
    ];
    for (tolerance, most) in [(1e-6, 200), (1e-9, 1000)] {
        let atol = tolerance * 1e-6;
        let rodas = Rodas5P::new()
            .rtol(tolerance)
            .atol(atol)
            .solve(&robertson, 0.0, 1e4, [1.0, 0.0, 0.0]);
        let radau = Radau5::new()
            .rtol(tolerance)
            .atol(atol)
            .solve(&robertson, 0.0, 1e4, [1.0, 0.0, 0.0]);
        for solution in [rodas, radau] {
            let solution = solution.expect("regular");
            let (t, x) = solution.last();
            let error = std::iter::zip(x.iter(), expected)
                .map(|(x, y)| ((x - y) / y).abs())
                .fold(0.0, f64::max);
            assert!(t == 1e4 && error < 10.0 * tolerance, "{error:e}");
            assert!(solution.statistics().accepted < most, "{:?}", solution.statistics());
        }
    }
}

/// Relaxation oscillations, with jumps that take 1e-6 of the time between them.
fn van_der_pol() -> impl Jacobian<f64, 2> {
    const EPSILON: f64 = 1e-6;
    of(
        |x: &SVector<f64, 2>| SVector::from([x[1], ((1.0 - x[0] * x[0]) * x[1] - x[0]) / EPSILON]),
        |x: &SVector<f64, 2>| {
            SMatrix::from([
                [0.0, (-2.0 * x[0] * x[1] - 1.0) / EPSILON],
                [1.0, (1.0 - x[0] * x[0]) / EPSILON],
            ])
        },
    )
}

#[test]
fn relaxation_of_van_der_pol() {
    let oscillator = van_der_pol();
    // Computed like the reference of Robertson's problem, with tolerances of 1e-9 and 1e-11.
    let expected = [-1.863_646_006_138_871_6, 0.753_543_268_399_36];
    for tolerance in [1e-5, 1e-7, 1e-9] {
        let rodas = Rodas5P::new()
            .rtol(tolerance)
            .atol(tolerance)
            .solve(&oscillator, 0.0, 1.0, [2.0, -0.66]);
        let radau = Radau5::new()
            .rtol(tolerance)
            .atol(tolerance)
            .solve(&oscillator, 0.0, 1.0, [2.0, -0.66]);
        for solution in [rodas, radau] {
            let solution = solution.expect("regular");
            let error = (solution.end() - SVector::from(expected)).amax();
            assert!(error < 10.0 * tolerance, "{error:e}");
        }
    }
}

/// The Jacobian serves several steps, and a step that hardly changes in length has the matrix of the last one. SciPy's
/// Radau, of order 5, takes 855 Jacobians and 1984 factorizations. Real and complex matrices count as one each.
#[test]
fn matrices_are_kept_along_the_relaxation_of_van_der_pol() {
    let oscillator = van_der_pol();
    // Hairer and Wanner's test set, to these digits
    const END: [f64; 2] = [1.706_167_732_170_48, -0.892_809_701_024_795];
    fn check<M: Method<S, f64, 2>, S: System<f64, 2>>(method: M, system: &S, most: [usize; 2]) {
        let solution = method.solve(system, 0.0, 2.0, [2.0, 0.0]).expect("regular");
        let error = (solution.end() - SVector::from(END)).amax();
        let work = solution.statistics();
        assert!(error < 1e-9, "{error:e}");
        assert!(work.jacobians <= most[0] && work.factorizations <= most[1], "{work:?}");
    }
    check(Radau5::new().rtol(1e-9).atol(1e-9), &oscillator, [900, 2600]);
    check(Radau9::new().rtol(1e-9).atol(1e-9), &oscillator, [320, 1500]);
    check(Radau13::new().rtol(1e-9).atol(1e-9), &oscillator, [190, 1400]);
}

#[test]
fn single_precision_has_its_own_tolerance() {
    let expected = known(2.0);
    let rodas = Rodas5P::new()
        .solve(&Known, 0.0_f32, 2.0, [1.0, 1.0])
        .expect("regular")
        .end();
    let radau = Radau5::new()
        .solve(&Known, 0.0_f32, 2.0, [1.0, 1.0])
        .expect("regular")
        .end();
    for x in [rodas, radau] {
        assert!((x.map(f64::from) - expected).amax() < 2e-4, "{x}");
    }
}

/// Reason and time of a failed integration.
fn failure<S: Jacobian<f64, 1>>(system: &S, max_steps: usize) -> [(Reason, f64); 2] {
    let rodas = Rodas5P::new()
        .max_steps(max_steps)
        .solve(system, 0.0, 2.0, [1.0])
        .expect_err("fails");
    let radau = Radau5::new()
        .max_steps(max_steps)
        .solve(system, 0.0, 2.0, [1.0])
        .expect_err("fails");
    assert!(rodas.x()[0].is_finite() && radau.x()[0].is_finite());
    [(rodas.reason, rodas.t()), (radau.reason, radau.t())]
}

#[test]
fn failures_are_told_with_the_last_good_state() {
    // 1 / (1 - t) has a pole at t = 1
    let blows_up = of(
        |x: &SVector<f64, 1>| x.component_mul(x),
        |x: &SVector<f64, 1>| SMatrix::from([[2.0 * x[0]]]),
    );
    for (reason, t) in failure(&blows_up, 1_000_000) {
        let is_known = matches!(
            reason,
            Reason::StepUnderflow { .. } | Reason::NonFinite { .. } | Reason::NoConvergence { .. }
        );
        assert!(is_known && (t - 1.0).abs() < 1e-5, "{reason:?} {t}");
    }
    // NaN beyond 2
    let ends = of(
        |x: &SVector<f64, 1>| (x * -1.0).add_scalar(2.0).map(f64::sqrt).add_scalar(1.0),
        |_: &SVector<f64, 1>| SMatrix::from([[0.0]]),
    );
    for (reason, t) in failure(&ends, 1_000_000) {
        assert!(
            matches!(reason, Reason::NonFinite { component: 0, .. }),
            "{reason:?} {t}"
        );
        assert!(t > 0.5 && t < 0.7, "{t}");
    }
    for (reason, t) in failure(&Linear { z: 1.0 }, 3) {
        assert!(reason == Reason::TooManySteps { max_steps: 3 } && t < 2.0);
    }
    // a Jacobian that is not finite cannot be factored
    let blind = of(
        |x: &SVector<f64, 1>| -x,
        |_: &SVector<f64, 1>| SMatrix::from([[f64::NAN]]),
    );
    for (reason, t) in failure(&blind, 1_000_000) {
        assert!(matches!(reason, Reason::NoConvergence { .. }) && t == 0.0, "{reason:?}");
    }
}

/// `x' = -x` with counted evaluations.
struct Decay(Cell<usize>);

impl System<f64, 1> for Decay {
    fn rhs(&self, _t: f64, x: &SVector<f64, 1>) -> SVector<f64, 1> {
        self.0.set(self.0.get() + 1);
        -x
    }

    fn layout(&self) -> Option<StateLayout<'_>> {
        const LAYOUT: StateLayout<'_> = StateLayout::new(&[]).autonomous();
        Some(LAYOUT)
    }
}

impl Jacobian<f64, 1> for Decay {
    fn jacobian(&self, _t: f64, _x: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> {
        SMatrix::from([[-1.0]])
    }
}

#[test]
fn a_system_that_is_known_not_to_depend_on_time_is_not_evaluated_to_find_out() {
    let decay = Decay(Cell::new(0));
    assert_eq!(decay.time_derivative(0.3, &SVector::from([2.0]))[0], 0.0);
    assert_eq!(decay.0.get(), 0);
}
