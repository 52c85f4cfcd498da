//! Stability functions of all methods, against their steps, the exponential function, closed forms and known limits.

use nalgebra::{SMatrix, SVector};
use pendulum_core::method::{Adaptive, Fixed, PowerSeries, RadauIIA, Rosenbrock};
use pendulum_core::prelude::*;
use pendulum_core::stability::{Complex, StabilityFunction, imaginary_limit, max_stable_step, real_limit};
use pendulum_core::tableau;
use pendulum_core::{Canonical, TaylorSeries};

type C = Complex<f64>;

/// `x' = lambda x` in two real components, with all traits that a method may require.
struct Linear(C);

impl Linear {
    fn matrix(&self) -> SMatrix<f64, 2, 2> {
        SMatrix::from([[self.0.re, self.0.im], [-self.0.im, self.0.re]])
    }
}

impl System<f64, 2> for Linear {
    fn rhs(&self, _t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        self.matrix() * x
    }
}

impl Jacobian<f64, 2> for Linear {
    fn jacobian(&self, _t: f64, _x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        self.matrix()
    }
}

/// Canonical variables with a unit mass.
impl Canonical<f64, 2> for Linear {
    fn canonical(&self, t: f64, x: &SVector<f64, 2>) -> (SVector<f64, 2>, SVector<f64, 2>) {
        (*x, self.rhs(t, x))
    }

    fn canonical_jacobian(&self, _t: f64, _x: &SVector<f64, 2>) -> (SMatrix<f64, 2, 2>, SMatrix<f64, 2, 2>) {
        (SMatrix::identity(), self.matrix())
    }
}

impl TaylorSeries<f64, 2> for Linear {
    type Workspace = ();

    fn workspace(&self) {}

    fn series(&self, _t: f64, x: &mut [SVector<f64, 2>], _work: &mut ()) {
        for k in 1..x.len() {
            x[k] = self.matrix() * x[k - 1] / k as f64;
        }
    }
}

// Comparison with steps

/// Oscillation, decay, growth, and mixtures of them.
const SAMPLES: [C; 6] = [
    C::new(0.0, 1.3),
    C::new(-2.5, 0.0),
    C::new(1.1, 0.0),
    C::new(-1.7, 2.9),
    C::new(0.6, -4.2),
    C::new(-8.0, 3.0),
];

/// Step size.
const H: f64 = 0.5;

/// Compares one step along `x' = lambda x` with the stability function. They differ by rounding errors of the stages.
/// These are proportional to the powers of `|z|` of the stages, times `sums`, the largest sum of absolute coefficients.
#[track_caller]
fn check_step<M>(method: &M, sums: f64)
where
    M: Method<Linear, f64, 2> + StabilityFunction,
{
    for z in SAMPLES {
        let linear = Linear(z / H);
        let mut stepper = method.stepper(&linear, 0.0, H, [1.0, 0.0]).expect("regular");
        let h = stepper.step().expect("regular").expect("a step is left").h;
        let (end, expected) = (stepper.x(), method.stability_function(linear.0 * h));
        let error = (C::new(end[0], end[1]) - expected).norm();
        assert!(error < 4.0 * f64::EPSILON * sums * z.norm().exp(), "{z}: {error:e}");
    }
}

/// Disables step size control, so that the first step is accepted with size [`H`].
fn lax<F>(method: Adaptive<F>) -> Adaptive<F> {
    method.atol(1e200).h0(H)
}

#[test]
fn a_step_multiplies_a_mode_by_the_stability_function() {
    check_step(&Rk4::new(H), 1.0);
    check_step(&Gauss4::new(H), 1.0);
    check_step(&Gauss6::new(H), 1.0);
    check_step(&Fixed::<RadauIIA>::new(H), 1.0);
    check_step(&Fixed::<Rosenbrock<tableau::HairerWanner4, 6>>::new(H), 18.0);
    check_step(&Fixed::<PowerSeries>::new(H), 1.0);
    check_step(&lax(Rk45::new()), 25.0);
    check_step(&lax(Tsit5::new()), 27.0);
    check_step(&lax(Vern7::new()), 413.0);
    check_step(&lax(Vern9::new()), 124.0);
    check_step(&lax(Rodas5P::new()), 69.0);
    for tolerance in [1e-2, 1e-6, 1e-12] {
        check_step(&Taylor::new().rtol(tolerance).atol(tolerance), 1.0);
    }
}

// Comparison with the exponential function

/// Relative deviation of the coefficient of `z^k` from the one of the exponential function. It is computed from values
/// on a circle, by Cauchy's integral with the trapezoidal rule.
fn defect(method: &dyn StabilityFunction, radius: f64, k: usize) -> f64 {
    const POINTS: usize = 128;
    let angles = (0..POINTS).map(|i| std::f64::consts::TAU * i as f64 / POINTS as f64);
    let sum: C = angles
        .map(|angle| method.stability_function(C::from_polar(radius, angle)) * C::from_polar(1.0, -(k as f64) * angle))
        .sum();
    // k! / radius^k
    let over = (1..=k).fold(1.0, |product, i| product * i as f64 / radius);
    (over * sum / POINTS as f64 - 1.0).norm()
}

#[test]
fn the_exponential_function_is_met_to_the_order_of_the_method_and_no_further() {
    let implicit: [(&dyn StabilityFunction, usize); 5] = [
        (&Rodas4::new(), 4),
        // one more than for nonlinear systems
        (&Rodas5P::new(), 6),
        (&Radau5::new(), 5),
        (&Gauss4::new(H), 4),
        (&Gauss6::new(H), 6),
    ];
    let explicit: [(&dyn StabilityFunction, usize); 5] = [
        (&Rk4::new(H), 4),
        (&Rk45::new(), 5),
        (&Tsit5::new(), 5),
        (&Vern7::new(), 7),
        (&Vern9::new(), 9),
    ];
    // Pade approximants of higher order deviate by less, s! (s - 1)! / (2 s - 1)!: 0.8 % and 0.06 %
    let radau: [(&dyn StabilityFunction, usize); 2] = [(&Radau9::new(), 9), (&Radau13::new(), 13)];
    let series: [(&dyn StabilityFunction, usize); 2] = [(&Taylor::new().order(12), 12), (&Taylor::new().order(20), 20)];
    // The circles lie within the poles, the closest of which is at 3.6, and are large enough to resolve the
    // coefficients above rounding errors.
    for (methods, radius, least) in [
        (&implicit[..], 1.0, 0.01),
        (&explicit[..], 2.0, 0.01),
        (&radau[..], 3.0, 5e-4),
        (&series[..], 8.0, 0.01),
    ] {
        for &(method, order) in methods {
            for k in 0..=order {
                let defect = defect(method, radius, k);
                assert!(defect < 1e-9, "z^{k} of a method of order {order}: {defect:e}");
            }
            // 1.5 % for Verner's method of order 7, the smallest deviation
            assert!(defect(method, radius, order + 1) > least);
        }
    }
}

// Closed forms

/// `sum_k coefficients_k z^k`.
fn polynomial(coefficients: &[f64], z: C) -> C {
    coefficients.iter().rev().fold(C::default(), |sum, &c| sum * z + c)
}

#[test]
fn closed_forms_are_met() {
    // Pade approximants of the exponential function: Hairer, Wanner II, IV.3, Table 3.1
    let ratio = |above: &[f64], below: &[f64], z: C| polynomial(above, z) / polynomial(below, z);
    for z in SAMPLES {
        let gauss4 = [1.0, 1.0 / 2.0, 1.0 / 12.0];
        let gauss6 = [1.0, 1.0 / 2.0, 1.0 / 10.0, 1.0 / 120.0];
        let symmetric = |above: &[f64]| polynomial(above, z) / polynomial(above, -z);
        let dormand_prince = [1.0, 1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0, 1.0 / 600.0];
        for (found, expected) in [
            (
                Rk4::new(H).stability_function(z),
                polynomial(&[1.0, 1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0], z),
            ),
            (Rk45::new().stability_function(z), polynomial(&dormand_prince, z)),
            (Gauss4::new(H).stability_function(z), symmetric(&gauss4)),
            (Gauss6::new(H).stability_function(z), symmetric(&gauss6)),
            (
                Radau5::new().stability_function(z),
                ratio(
                    &[1.0, 2.0 / 5.0, 1.0 / 20.0],
                    &[1.0, -3.0 / 5.0, 3.0 / 20.0, -1.0 / 60.0],
                    z,
                ),
            ),
        ] {
            let error = (found - expected).norm();
            assert!(error < 1e-14 * (1.0 + expected.norm()), "{z}: {error:e}");
        }
    }
}

#[test]
fn far_away_stiff_methods_damp_and_those_of_gauss_ring() {
    let far = |method: &dyn StabilityFunction| {
        let limit = method.stability_at_infinity();
        let there = method.stability_function(C::new(-1e9, 1e9)).norm();
        assert!((there - limit).abs() < 1e-7, "{there} for {limit}");
        limit
    };
    for method in [
        &Rodas4::new() as &dyn StabilityFunction,
        &Rodas5P::new(),
        &Radau5::new(),
        &Radau9::new(),
        &Radau13::new(),
    ] {
        assert!(far(method) < 1e-12);
    }
    for method in [
        &Gauss4::new(H) as &dyn StabilityFunction,
        &Gauss6::new(H),
        &Gauss16::new(H),
    ] {
        assert!((far(method) - 1.0).abs() < 1e-12);
    }
    for method in [&Rk4::new(H) as &dyn StabilityFunction, &Vern9::new(), &Taylor::new()] {
        assert_eq!(method.stability_at_infinity(), f64::INFINITY);
    }
}

// Limits

#[test]
fn limits_are_those_of_the_literature() {
    let taylor = Taylor::new().order(20);
    let methods: [(&str, &dyn StabilityFunction, f64, f64); 6] = [
        ("Rk4", &Rk4::new(H), 2.785, 2.828),
        ("Rk45", &Rk45::new(), 3.307, 0.997),
        ("Tsit5", &Tsit5::new(), 3.507, 0.479),
        ("Vern7", &Vern7::new(), 4.640, 0.468),
        ("Vern9", &Vern9::new(), 4.476, 2.757),
        ("Taylor", &taylor, 8.821, 3.498),
    ];
    for (name, method, real, imaginary) in methods {
        let found = (real_limit(method), imaginary_limit(method));
        assert!(
            (found.0 - real).abs() < 1e-3 && (found.1 - imaginary).abs() < 1e-3,
            "{name}: {found:?}"
        );
    }
    // |R(iy)|^2 = 1 - y^6 / 72 + y^8 / 576
    let rk4 = Rk4::new(H);
    assert!((imaginary_limit(&rk4) - 8.0_f64.sqrt()).abs() < 1e-8);
    // real root of (R(z) - 1) / z = 1 + z / 2 + z^2 / 6 + z^3 / 24
    let z = -real_limit(&rk4);
    assert!((1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0))).abs() < 1e-8);
}

#[test]
fn a_stable_methods_have_no_limits() {
    let methods: [&dyn StabilityFunction; 8] = [
        &Rodas4::new(),
        &Rodas5P::new(),
        &Radau5::new(),
        &Radau9::new(),
        &Radau13::new(),
        &Gauss4::new(H),
        &Gauss6::new(H),
        &Gauss16::new(H),
    ];
    let jacobian = Linear(C::new(-0.3, 1e3)).matrix();
    for method in methods {
        assert_eq!(real_limit(method), f64::INFINITY);
        assert_eq!(imaginary_limit(method), f64::INFINITY);
        assert_eq!(max_stable_step(method, &jacobian), Ok(f64::INFINITY));
    }
}

#[test]
fn an_order_without_sense_is_stable_nowhere() {
    let taylor = Taylor::new().order(100);
    assert!(taylor.stability_function(C::new(-1.0, 0.0)).norm().is_nan());
    assert_eq!(real_limit(&taylor), 0.0);
}

/// Stable except in a narrow ring.
struct Ring;

impl StabilityFunction for Ring {
    fn stability_function(&self, z: C) -> C {
        C::from(if (3.3..3.33).contains(&z.norm()) { 1.1 } else { 0.9 })
    }

    fn stability_at_infinity(&self) -> f64 {
        0.9
    }
}

#[test]
fn what_lies_beyond_the_first_loss_of_stability_does_not_count() {
    assert!((real_limit(&Ring) - 3.3).abs() < 1e-14);
    assert!((imaginary_limit(&Ring) - 3.3).abs() < 1e-14);
}

// Largest stable step

/// A matrix with the eigenvalues `creeping`, `swinging` and its conjugate, and `growing`, in an oblique basis.
fn askew(creeping: f64, swinging: C, growing: f64) -> SMatrix<f64, 4, 4> {
    let mut matrix = SMatrix::<f64, 4, 4>::zeros();
    matrix[(0, 0)] = creeping;
    matrix
        .fixed_view_mut::<2, 2>(1, 1)
        .copy_from(&Linear(swinging).matrix());
    matrix[(3, 3)] = growing;
    let basis = SMatrix::<f64, 4, 4>::from([
        [1.0, 0.3, -0.2, 0.5],
        [0.1, 1.0, 0.7, -0.3],
        [-0.4, 0.2, 1.0, 0.1],
        [0.3, -0.6, 0.2, 1.0],
    ]);
    basis * matrix * basis.try_inverse().expect("regular")
}

#[test]
fn the_fastest_mode_limits_the_step() {
    let rk4 = Rk4::new(H);
    let longest = |jacobian| max_stable_step(&rk4, &jacobian).expect("finite");
    let swinging = C::new(0.0, 7.0);
    for (jacobian, expected) in [
        // overdamped, oscillating, and unstable modes
        (askew(-30.0, swinging, 1.0), 2.785_293_563_405_3 / 30.0),
        (askew(-1.0, swinging, 1.0), 8.0_f64.sqrt() / 7.0),
        (askew(-1.0, swinging, 1e3), 8.0_f64.sqrt() / 7.0),
        // a conserved quantity
        (askew(0.0, swinging, 0.0), 8.0_f64.sqrt() / 7.0),
        (SMatrix::zeros(), f64::INFINITY),
    ] {
        let found = longest(jacobian);
        assert!(
            found == expected || (found / expected - 1.0).abs() < 2e-9,
            "{found} for {expected}"
        );
    }
}

#[test]
fn what_drifts_freely_limits_no_step() {
    // position and velocity in oblique coordinates: a double eigenvalue 0, which rounding splits into 3e-9 i and -3e-9
    // i
    let drifting = SMatrix::from([[0.21, 0.09], [-0.490_000_000_000_000_1, -0.21]]);
    assert_eq!(max_stable_step(&Rk4::new(H), &drifting), Ok(f64::INFINITY));
}

#[test]
fn a_damped_swing_is_stable_until_the_longest_step_and_not_beyond() {
    let damped = Linear(C::from_polar(5.0, 2.0));
    let check = |longest: f64, factor: &dyn Fn(f64) -> f64| {
        assert!(factor(longest * (1.0 - 1e-8)) < 1.0);
        assert!(factor(longest * (1.0 + 1e-8)) > 1.0);
    };
    // amplification factor of a step, as computed by the code
    let step = |h: f64| {
        let mut stepper = Rk4::new(h).stepper(&damped, 0.0, h, [1.0, 0.0]).expect("regular");
        stepper.run().expect("regular").norm()
    };
    let longest = |method: &dyn StabilityFunction| max_stable_step(method, &damped.matrix()).expect("finite");
    check(longest(&Rk4::new(H)), &step);
    for method in [
        &Rk45::new() as &dyn StabilityFunction,
        &Vern7::new(),
        &Vern9::new(),
        &Taylor::new(),
    ] {
        check(longest(method), &|h| method.stability_function(damped.0 * h).norm());
    }
}

#[test]
fn a_jacobian_that_is_not_finite_is_refused() {
    let jacobian = SMatrix::from([[f64::NAN, 0.0], [0.0, 1.0]]);
    assert!(max_stable_step(&Rk4::new(H), &jacobian).is_err());
}
