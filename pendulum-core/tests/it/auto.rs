//! The method with automatic stiffness detection, observed through its statistics.

use approx::assert_abs_diff_eq;
use pendulum_core::Statistics;
use pendulum_core::method::{Explicit, Fixed, Rosenbrock};
use pendulum_core::prelude::*;
use pendulum_core::tableau::{Steinebach5, Verner7};

/// `x' = -lambda (x - cos t) - sin t`, with the solution `cos t` (Prothero and Robinson). The stiffness is `lambda`.
struct Prothero {
    lambda: f64,
}

impl System<f64, 1> for Prothero {
    fn rhs(&self, t: f64, x: &SVector<f64, 1>) -> SVector<f64, 1> {
        SVector::from([-self.lambda * (x[0] - t.cos()) - t.sin()])
    }
}

impl Jacobian<f64, 1> for Prothero {
    fn jacobian(&self, _t: f64, _x: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> {
        SMatrix::from([[-self.lambda]])
    }
}

#[test]
fn stiff_systems_are_left_to_the_implicit_method() {
    for (tolerance, lambda) in [(1e-3, 1e4), (1e-6, 1e4), (1e-9, 1e4), (1e-6, 1e8)] {
        let system = Prothero { lambda };
        let method = Auto::new().rtol(tolerance).atol(tolerance);
        let solution = method.solve(&system, 0.0, 20.0, [1.5]).expect("regular");
        let Statistics {
            accepted,
            stiff,
            switches,
            ..
        } = solution.statistics();
        assert_eq!(switches, 1, "{lambda} {tolerance}");
        assert!(
            stiff + 100 > accepted && accepted < 1000,
            "{lambda} {tolerance}: {stiff} of {accepted}"
        );
        assert_abs_diff_eq!(solution.end()[0], 20.0_f64.cos(), epsilon = 10.0 * tolerance);
    }
}

/// Three reactions of very different speed (H. H. Robertson, 1966).
fn robertson() -> impl Jacobian<f64, 3> {
    FnSystem::with_jacobian(
        |_t: f64, x: &SVector<f64, 3>| {
            let (slow, fast, square) = (0.04 * x[0], 1e4 * x[1] * x[2], 3e7 * x[1] * x[1]);
            SVector::from([fast - slow, slow - fast - square, square])
        },
        |_t: f64, x: &SVector<f64, 3>| {
            SMatrix::from([
                [-0.04, 0.04, 0.0],
                [1e4 * x[2], -1e4 * x[2] - 6e7 * x[1], 6e7 * x[1]],
                [1e4 * x[1], -1e4 * x[1], 0.0],
            ])
        },
    )
}

/// With tight tolerances, error estimates grow far below the limit of stability: explicit steps crept along slow
/// solutions, 178,000 and 106,000 evaluations, where the implicit method takes 28,000 and 26,000.
#[test]
fn explicit_steps_do_not_creep_at_tight_tolerances() {
    fn check<S: Jacobian<f64, 3>>(system: &S, t1: f64, x0: [f64; 3], tolerance: f64) {
        let evaluations = |method: &dyn Fn() -> Statistics| method().evaluations as f64;
        let (rtol, atol) = (tolerance, 1e-3 * tolerance);
        let auto = || {
            Auto::new()
                .rtol(rtol)
                .atol(atol)
                .solve(system, 0.0, t1, x0)
                .expect("regular")
        };
        let implicit = || {
            Rodas5P::new()
                .rtol(rtol)
                .atol(atol)
                .solve(system, 0.0, t1, x0)
                .expect("regular")
        };
        let ratio = evaluations(&|| auto().statistics()) / evaluations(&|| implicit().statistics());
        assert!(ratio < 1.2, "{ratio}");
    }
    check(&robertson(), 1e11, [1.0, 0.0, 0.0], 1e-12);
    let oregonator = FnSystem::with_jacobian(
        |_t: f64, x: &SVector<f64, 3>| {
            SVector::from([
                77.27 * (x[1] + x[0] * (1.0 - 8.375e-6 * x[0] - x[1])),
                (x[2] - (1.0 + x[0]) * x[1]) / 77.27,
                0.161 * (x[0] - x[2]),
            ])
        },
        |_t: f64, x: &SVector<f64, 3>| {
            SMatrix::from([
                [77.27 * (1.0 - 1.675e-5 * x[0] - x[1]), -x[1] / 77.27, 0.161],
                [77.27 * (1.0 - x[0]), -(1.0 + x[0]) / 77.27, 0.0],
                [0.0, 1.0 / 77.27, -0.161],
            ])
        },
    );
    check(&oregonator, 360.0, [1.0, 2.0, 3.0], 1e-8);
}

/// With tight tolerances, explicit steps crept along very smooth solutions, at 0.1 to 0.35 of the limit of
/// stability.
#[test]
fn explicit_steps_do_not_creep_along_very_smooth_solutions() {
    for (tolerance, lambda) in [(1e-9, 300.0), (1e-12, 300.0), (1e-12, 1e4)] {
        let method = Auto::new().rtol(tolerance).atol(tolerance);
        let solution = method.solve(&Prothero { lambda }, 0.0, 20.0, [1.0]).expect("regular");
        let statistics = solution.statistics();
        assert!(
            statistics.switches == 1 && statistics.accepted < 200,
            "{lambda} {tolerance}: {statistics:?}"
        );
        assert_abs_diff_eq!(solution.end()[0], 20.0_f64.cos(), epsilon = 10.0 * tolerance);
    }
}

/// A mass on a spring with a damper, whose other end moves by `sin t`. Error estimates of explicit methods grow far
/// below the limit of stability where stiff modes oscillate: steps at the limit alone took up to 4000 times as many
/// evaluations as the implicit method.
#[test]
fn stiff_modes_that_oscillate_are_left_to_the_implicit_method() {
    fn run<M: Method<S, f64, 2>, S: Jacobian<f64, 2>>(method: M, system: &S) -> (usize, f64) {
        let solution = method.solve(system, 0.0, 10.0, [0.0, 1.0]).expect("regular");
        (solution.statistics().evaluations, solution.end()[0])
    }
    for natural in [10.0, 30.0, 100.0, 1e3, 1e4] {
        for damping in [0.0, 0.01, 0.1, 0.3, 0.7, 1.0] {
            let (stiffness, rate) = (natural * natural, 2.0 * damping * natural);
            let system = FnSystem::with_jacobian(
                |t: f64, x: &SVector<f64, 2>| {
                    let (drive, speed) = t.sin_cos();
                    SVector::from([x[1], -stiffness * (x[0] - drive) - rate * (x[1] - speed) - drive])
                },
                |_t: f64, _x: &SVector<f64, 2>| SMatrix::from([[0.0, -stiffness], [1.0, -rate]]),
            );
            for tolerance in [1e-3, 2e-4, 1e-5, 1e-7, 1e-8, 1e-10] {
                let (evaluations, end) = run(Auto::new().rtol(tolerance).atol(tolerance), &system);
                let (implicit, _) = match tolerance {
                    1e-3 | 2e-4 => run(Rodas4::new().rtol(tolerance).atol(tolerance), &system),
                    1e-10 => run(Radau13::new().rtol(tolerance).atol(tolerance), &system),
                    _ => run(Rodas5P::new().rtol(tolerance).atol(tolerance), &system),
                };
                let ratio = evaluations as f64 / implicit as f64;
                assert!(ratio < 2.8, "{natural} {damping} {tolerance}: {ratio}");
                assert_abs_diff_eq!(end, 10.0_f64.sin(), epsilon = tolerance);
            }
        }
    }
}

/// A swing beside a fall, whose derivative changes more but does not bend: in one norm of all components it would hide
/// the bend of the swing.
#[test]
fn a_swing_that_falls_is_not_stiff() {
    let system = FnSystem::with_jacobian(
        |_t: f64, x: &SVector<f64, 4>| SVector::from([x[1], -9.81, x[3], -4.0 * x[2]]),
        |_t: f64, _x: &SVector<f64, 4>| {
            let mut jacobian = SMatrix::zeros();
            (jacobian[(0, 1)], jacobian[(2, 3)], jacobian[(3, 2)]) = (1.0, 1.0, -4.0);
            jacobian
        },
    );
    for (rtol, atol) in [(1e-4, 1e-7), (1e-6, 1e-9), (1e-6, 1e-6), (1e-9, 1e-12), (1e-11, 1e-11)] {
        for swing in [0.1, 0.01] {
            let method = Auto::new().rtol(rtol).atol(atol);
            let solution = method
                .solve(&system, 0.0, 30.0, [0.0, 0.0, swing, 0.0])
                .expect("regular");
            assert_eq!(solution.statistics().switches, 0, "{rtol} {atol} {swing}");
        }
    }
}

/// An oscillation beside a motion of constant rate, which almost hides how the derivative changes.
#[test]
fn a_constant_part_of_the_derivative_is_not_smoothness() {
    let system = FnSystem::with_jacobian(
        |_t: f64, x: &SVector<f64, 3>| SVector::from([1000.0, x[2], -x[1]]),
        |_t: f64, _x: &SVector<f64, 3>| SMatrix::from([[0.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]),
    );
    for tolerance in [1e-3, 1e-6, 1e-9, 1e-12] {
        let method = Auto::new().rtol(tolerance).atol(tolerance);
        let solution = method.solve(&system, 0.0, 60.0, [0.0, 1.0, 0.0]).expect("regular");
        assert_eq!(solution.statistics().switches, 0, "{tolerance}");
    }
}

/// Relaxation oscillations of van der Pol, in the time of the slow phases.
fn relaxation() -> impl Jacobian<f64, 2> {
    FnSystem::with_jacobian(
        |_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], 1e6 * ((1.0 - x[0] * x[0]) * x[1] - x[0])]),
        |_t: f64, x: &SVector<f64, 2>| {
            let (x, v) = (x[0], x[1]);
            SMatrix::from([[0.0, 1e6 * (-2.0 * x * v - 1.0)], [1.0, 1e6 * (1.0 - x * x)]])
        },
    )
}

/// Growth of a plant under light: eight reactions (E. Schaefer, 1975).
fn hires() -> impl Jacobian<f64, 8> {
    FnSystem::with_jacobian(
        |_t: f64, x: &SVector<f64, 8>| {
            let [a, b, c, d, e, f, g, h] = x.data.0[0];
            let bound = 280.0 * f * h;
            SVector::from([
                -1.71 * a + 0.43 * b + 8.32 * c + 0.0007,
                1.71 * a - 8.75 * b,
                -10.03 * c + 0.43 * d + 0.035 * e,
                8.32 * b + 1.71 * c - 1.12 * d,
                -1.745 * e + 0.43 * f + 0.43 * g,
                -bound + 0.69 * d + 1.71 * e - 0.43 * f + 0.69 * g,
                bound - 1.81 * g,
                -bound + 1.81 * g,
            ])
        },
        |_t: f64, x: &SVector<f64, 8>| {
            let (f, h) = (280.0 * x[5], 280.0 * x[7]);
            SMatrix::from([
                [-1.71, 1.71, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                [0.43, -8.75, 0.0, 8.32, 0.0, 0.0, 0.0, 0.0],
                [8.32, 0.0, -10.03, 1.71, 0.0, 0.0, 0.0, 0.0],
                [0.0, 0.0, 0.43, -1.12, 0.0, 0.69, 0.0, 0.0],
                [0.0, 0.0, 0.035, 0.0, -1.745, 1.71, 0.0, 0.0],
                [0.0, 0.0, 0.0, 0.0, 0.43, -h - 0.43, h, -h],
                [0.0, 0.0, 0.0, 0.0, 0.43, 0.69, -1.81, 1.81],
                [0.0, 0.0, 0.0, 0.0, 0.0, -f, f, -f],
            ])
        },
    )
}

/// `Rodas5P` as the implicit method took 201,000, 12,000 and 9,700 evaluations.
#[test]
fn tight_tolerances_take_an_implicit_method_of_high_order() {
    fn evaluations<S: Jacobian<f64, N>, const N: usize>(system: &S, t1: f64, x0: [f64; N]) -> usize {
        let method = Auto::new().rtol(1e-12).atol(1e-12);
        let mut stepper = method.stepper(system, 0.0, t1, x0).expect("valid");
        stepper.run().expect("regular");
        assert!(stepper.statistics().stiff > 0);
        stepper.statistics().evaluations
    }
    let slow = evaluations(&relaxation(), 2.0, [2.0, 0.0]);
    assert!(slow < 20_000, "{slow}");
    let plant = evaluations(&hires(), 321.8122, [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0057]);
    assert!(plant < 5500, "{plant}");
    let reactions = evaluations(&robertson(), 1e11, [1.0, 0.0, 0.0]);
    assert!(reactions < 6500, "{reactions}");
}

#[test]
fn an_unstable_first_step_is_left_to_the_implicit_method() {
    let system = Prothero { lambda: 1e7 };
    let of = |tolerance: f64| {
        let method = Auto::new().rtol(tolerance).atol(tolerance);
        method.solve(&system, 0.0, 20.0, [1.0]).expect("regular").statistics()
    };
    let loose = of(1e-3);
    assert_eq!((loose.switches, loose.stiff), (1, loose.accepted), "{loose:?}");
    let tight = of(1e-6);
    assert!(tight.switches == 1 && tight.stiff < tight.accepted, "{tight:?}");
}

#[test]
fn systems_that_are_not_stiff_are_left_to_the_explicit_method() {
    for tolerance in [1e-3, 1e-6, 1e-9] {
        let system = Prothero { lambda: 0.5 };
        let method = Auto::new().rtol(tolerance).atol(tolerance);
        let statistics = method.solve(&system, 0.0, 200.0, [1.5]).expect("regular").statistics();
        assert_eq!(
            (statistics.switches, statistics.stiff, statistics.jacobians),
            (0, 0, 0),
            "{tolerance}"
        );
    }
}

/// Van der Pol's oscillator, with alternating slow and fast phases.
struct VanDerPol {
    mu: f64,
}

impl System<f64, 2> for VanDerPol {
    fn rhs(&self, _t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        SVector::from([x[1], self.mu * (1.0 - x[0] * x[0]) * x[1] - x[0]])
    }
}

impl Jacobian<f64, 2> for VanDerPol {
    fn jacobian(&self, _t: f64, x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        let (x, v) = (x[0], x[1]);
        SMatrix::from([[0.0, -2.0 * self.mu * x * v - 1.0], [1.0, self.mu * (1.0 - x * x)]])
    }
}

#[test]
fn it_changes_with_the_motion() {
    let system = VanDerPol { mu: 1000.0 };
    let method = Auto::new().rtol(1e-8).atol(1e-8);
    let solution = method.solve(&system, 0.0, 3000.0, [2.0, 0.0]).expect("regular");
    let Statistics {
        accepted,
        rejected,
        stiff,
        switches,
        ..
    } = solution.statistics();
    assert!(switches >= 3, "{switches}");
    assert!(
        stiff * 2 > accepted && accepted + rejected < 4000,
        "{stiff} of {accepted} and {rejected}"
    );
    let implicit = Rodas5P::new().rtol(1e-10).atol(1e-10);
    let expected = implicit.solve(&system, 0.0, 3000.0, [2.0, 0.0]).expect("regular").end();
    assert_abs_diff_eq!(solution.end(), expected, epsilon = 1e-4);
}

/// `x = cos t`, approached at a rate that decreases from 1e4 to 1, with or without a ripple.
struct Loosening {
    ripple: f64,
}

const SMOOTHLY: Loosening = Loosening { ripple: 0.0 };

impl Loosening {
    fn rate(&self, t: f64) -> f64 {
        1e4 * (-4.0 * t).exp() * (1.0 + self.ripple * (40.0 * t).sin()) + 1.0
    }
}

impl System<f64, 1> for Loosening {
    fn rhs(&self, t: f64, x: &SVector<f64, 1>) -> SVector<f64, 1> {
        SVector::from([-self.rate(t) * (x[0] - t.cos()) - t.sin()])
    }
}

impl Jacobian<f64, 1> for Loosening {
    fn jacobian(&self, t: f64, _x: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> {
        SMatrix::from([[-self.rate(t)]])
    }
}

#[test]
fn it_returns_after_four_steps_in_a_row_that_explicit_ones_could_have_taken() {
    // Limits of Tsitouras' method, and of Verner's of orders 7 and 9.
    let limits = [(1e-3, 1.0), (1e-6, 1.4), (1e-9, 0.7)];
    for (ripple, (tolerance, limit)) in [0.0, 0.9]
        .into_iter()
        .flat_map(|ripple| limits.map(|limit| (ripple, limit)))
    {
        let system = Loosening { ripple };
        let method = Auto::new().rtol(tolerance).atol(tolerance);
        let mut stepper = method.stepper(&system, 0.0, 20.0, [1.5]).expect("valid");
        let (mut before, mut implicit, mut free, mut returned) = (Statistics::default(), 0, 0, false);
        while let Some(step) = stepper.step().expect("regular") {
            let now = stepper.statistics();
            if now.switches > before.switches && now.stiff == before.stiff {
                // The step before was the last implicit one.
                assert_eq!(free, 4, "{tolerance}: at {}", step.t0);
                returned = true;
            }
            if now.stiff > before.stiff {
                assert!(free < 4, "{tolerance}: at {}", step.t0);
                implicit += 1;
                // With one state, power iteration is exact. Every second step is tested, for two.
                let is_free = step.h * system.rate(step.t1) <= limit;
                if implicit % 2 == 0 {
                    free = if is_free { free + 2 } else { 0 };
                }
            } else {
                (implicit, free) = (0, 0);
            }
            before = now;
        }
        assert!(returned, "{tolerance}");
    }
}

#[test]
fn the_tolerance_says_which_explicit_method_it_is() {
    fn end(method: impl Method<Prothero, f64, 1>) -> u64 {
        let solution = method.solve(&Prothero { lambda: 0.5 }, 0.0, 20.0, [1.5]);
        solution.expect("regular").end()[0].to_bits()
    }
    let auto = |rtol: f64, atol: f64| end(Auto::new().rtol(rtol).atol(atol));
    // The larger tolerance decides.
    for (rtol, atol) in [(5.01e-4, 1e-9), (1e-9, 5.01e-4)] {
        assert_eq!(auto(rtol, atol), end(Tsit5::new().rtol(rtol).atol(atol)));
    }
    for (rtol, atol) in [(5e-4, 1e-9), (1e-9, 5e-4), (5.01e-8, 1e-9), (1e-9, 5.01e-8)] {
        assert_eq!(auto(rtol, atol), end(Vern7::new().rtol(rtol).atol(atol)));
    }
    assert_eq!(auto(5e-8, 5e-8), end(Vern9::new().rtol(5e-8).atol(5e-8)));
}

#[test]
fn each_step_is_one_of_the_method_at_work() {
    let method = Auto::new().rtol(1e-6).atol(1e-6);
    let mut stepper = method.stepper(&SMOOTHLY, 0.0, 20.0, [1.5]).expect("valid");
    let mut before = Statistics::default();
    while let Some(step) = stepper.step().expect("regular") {
        let now = stepper.statistics();
        let end = if now.stiff > before.stiff {
            let method = Fixed::<Rosenbrock<Steinebach5, 8>>::new(step.h);
            method
                .stepper(&SMOOTHLY, step.t0, step.t1, step.x0)
                .expect("valid")
                .run()
        } else {
            let method = Fixed::<Explicit<Verner7, 11>>::new(step.h);
            method
                .stepper(&SMOOTHLY, step.t0, step.t1, step.x0)
                .expect("valid")
                .run()
        };
        assert_eq!(end, Ok(step.x1), "at {}", step.t0);
        before = now;
    }
    assert_eq!(before.switches, 2);
}

/// [`SMOOTHLY`] with time reversed.
struct Mirrored;

impl System<f64, 1> for Mirrored {
    fn rhs(&self, t: f64, x: &SVector<f64, 1>) -> SVector<f64, 1> {
        -SMOOTHLY.rhs(-t, x)
    }
}

impl Jacobian<f64, 1> for Mirrored {
    fn jacobian(&self, t: f64, x: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> {
        -SMOOTHLY.jacobian(-t, x)
    }
}

#[test]
fn backward_in_time_it_does_the_same() {
    let forward = Auto::new().solve(&SMOOTHLY, 0.0, 20.0, [1.5]).expect("regular");
    let backward = Auto::new().solve(&Mirrored, 0.0, -20.0, [1.5]).expect("regular");
    assert_eq!(forward.statistics(), backward.statistics());
    assert_eq!(forward.end(), backward.end());
}

#[test]
fn a_restart_begins_the_count_anew() {
    let system = Prothero { lambda: 1e4 };
    let switches = |every: usize| {
        let method = Auto::new().rtol(1e-6).atol(1e-6);
        let mut stepper = method.stepper(&system, 0.0, 20.0, [1.5]).expect("valid");
        for _ in 0..20 {
            for _ in 0..every {
                stepper.step().expect("regular");
            }
            stepper.restart(stepper.t(), stepper.x()).expect("where it is");
        }
        stepper.statistics().switches
    };
    // The switch follows four tests, of the first, third, fifth and seventh step; the eighth step is implicit.
    assert_eq!((switches(7), switches(8)), (0, 1));
    // The switch back follows four steps that could be explicit; the fifth is explicit.
    let switches = |every: usize| {
        let method = Auto::new().rtol(1e-6).atol(1e-6);
        let mut stepper = method.stepper(&SMOOTHLY, 0.0, 20.0, [1.5]).expect("valid");
        while stepper.statistics().stiff == 0 {
            stepper.step().expect("regular");
        }
        while stepper.t() < 20.0 {
            for _ in 0..every {
                stepper.step().expect("regular");
            }
            stepper.restart(stepper.t(), stepper.x()).expect("where it is");
        }
        stepper.statistics().switches
    };
    assert_eq!((switches(4), switches(5)), (1, 2));
}

/// `x = cos t`, approached at a rate of 1, and of 1500 in pulses once a second.
struct Pulsed;

impl Pulsed {
    fn rate(t: f64) -> f64 {
        1.0 + 1500.0 * (-((t.fract() - 0.5) / 0.002).powi(2)).exp()
    }
}

impl System<f64, 1> for Pulsed {
    fn rhs(&self, t: f64, x: &SVector<f64, 1>) -> SVector<f64, 1> {
        SVector::from([-Self::rate(t) * (x[0] - t.cos()) - t.sin()])
    }
}

impl Jacobian<f64, 1> for Pulsed {
    fn jacobian(&self, t: f64, _x: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> {
        SMatrix::from([[-Self::rate(t)]])
    }
}

#[test]
fn a_few_steps_at_the_limit_now_and_then_are_not_stiffness() {
    let method = Auto::new().rtol(1e-3).atol(1e-3).h_max(0.002);
    let statistics = method.solve(&Pulsed, 0.0, 20.0, [1.0]).expect("regular").statistics();
    assert_eq!(statistics.switches, 0, "{statistics:?}");
}

/// A stiff spring with a damper, whose far end moves as `cos t`: the mass follows it.
struct Following {
    rate: f64,
    damping: f64,
}

impl System<f64, 2> for Following {
    fn rhs(&self, t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        let (gap, closing) = (x[0] - t.cos(), x[1] + t.sin());
        SVector::from([x[1], -self.rate * self.rate * gap - 2.0 * self.damping * closing])
    }
}

impl Jacobian<f64, 2> for Following {
    fn jacobian(&self, _t: f64, _x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        SMatrix::from([[0.0, -self.rate * self.rate], [1.0, -2.0 * self.damping]])
    }

    fn time_derivative(&self, t: f64, _x: &SVector<f64, 2>) -> SVector<f64, 2> {
        SVector::from([0.0, -self.rate * self.rate * t.sin() - 2.0 * self.damping * t.cos()])
    }
}

#[test]
fn motions_along_a_stiff_spring_take_no_more_steps_than_the_implicit_method_alone() {
    for (rate, damping) in [(1000.0, 300.0), (1000.0, 700.0), (300.0, 90.0)] {
        let system = Following { rate, damping };
        for tolerance in [1e-4, 1e-5, 3e-6] {
            let auto = Auto::new().rtol(tolerance).atol(tolerance);
            let auto = auto
                .solve(&system, 0.0, 10.0, [1.0, 0.0])
                .expect("regular")
                .statistics();
            let alone = Rodas5P::new().rtol(tolerance).atol(tolerance);
            let alone = alone
                .solve(&system, 0.0, 10.0, [1.0, 0.0])
                .expect("regular")
                .statistics();
            assert!(
                auto.switches == 1 && auto.stiff <= alone.accepted,
                "{rate} {damping} {tolerance}: {auto:?} {alone:?}"
            );
        }
    }
}

#[test]
fn where_it_is_stiff_it_takes_the_steps_of_the_implicit_method() {
    fn accepted(method: &impl Method<Prothero, f64, 1>) -> Statistics {
        let solution = method.solve(&Prothero { lambda: 1e4 }, 0.0, 200.0, [1.0]);
        solution.expect("regular").statistics()
    }
    macro_rules! check {
        ($($tolerance:literal: $method:ident;)*) => { $(
            let auto = accepted(&Auto::new().rtol($tolerance).atol($tolerance));
            let implicit = accepted(&$method::new().rtol($tolerance).atol($tolerance));
            assert!(20 * auto.stiff <= 21 * implicit.accepted, "{}: {auto:?} {implicit:?}", stringify!($method));
            assert_eq!(auto.iterations > 0, implicit.iterations > 0, "{}", stringify!($method));
        )* };
    }
    check! { 1e-3: Rodas4; 1.01e-4: Rodas4; 1e-4: Rodas5P; 2e-9: Rodas5P; 1e-9: Radau13; }
}
