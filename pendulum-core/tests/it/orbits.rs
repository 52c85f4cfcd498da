//! Periodic orbits and their Floquet multipliers, against closed forms and quadrature.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use approx::assert_abs_diff_eq;
use nalgebra::{DMatrix, SMatrix, SVector};
use pendulum_core::prelude::*;
use pendulum_core::stability::{PeriodicOrbit, Shooting, Stability, StabilityError};
use pendulum_core::{Slot, StateLayout};

/// `x'' = f(t, x, x')`, in components `[x, x']`; `by` returns the derivatives of `f` with respect to both.
fn planar(f: impl Fn(f64, f64, f64) -> f64, by: impl Fn(f64, f64, f64) -> [f64; 2]) -> impl Jacobian<f64, 2> {
    FnSystem::with_jacobian(
        move |t, x: &SVector<f64, 2>| SVector::from([x[1], f(t, x[0], x[1])]),
        move |t, x: &SVector<f64, 2>| {
            let [by_x, by_v] = by(t, x[0], x[1]);
            SMatrix::from([[0.0, by_x], [1.0, by_v]])
        },
    )
}

/// `q'' = -sin q`.
struct Pendulum;

impl System<f64, 2> for Pendulum {
    fn rhs(&self, _t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        SVector::from([x[1], -x[0].sin()])
    }

    fn layout(&self) -> Option<StateLayout<'_>> {
        const LAYOUT: StateLayout<'_> = StateLayout::new(&[Slot::angle("q", 0, 1).periodic()]).autonomous();
        Some(LAYOUT)
    }
}

impl Jacobian<f64, 2> for Pendulum {
    fn jacobian(&self, _t: f64, x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        SMatrix::from([[0.0, -x[0].cos()], [1.0, 0.0]])
    }
}

fn van_der_pol(mu: f64) -> impl Jacobian<f64, 2> {
    planar(
        move |_, x, v| mu * (1.0 - x * x) * v - x,
        move |_, x, v| [-2.0 * mu * x * v - 1.0, mu * (1.0 - x * x)],
    )
}

/// `x'' = (2 q cos 2t - a) x`.
fn mathieu(a: f64, q: f64) -> impl Jacobian<f64, 2> {
    planar(
        move |t: f64, x, _| (2.0 * q * (2.0 * t).cos() - a) * x,
        move |t: f64, _, _| [2.0 * q * (2.0 * t).cos() - a, 0.0],
    )
}

/// The complete elliptic integral of the first kind for the modulus `k`, by the arithmetic-geometric mean.
fn elliptic_k(k: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - k * k).sqrt());
    while (a - b).abs() > 1e-15 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    FRAC_PI_2 / a
}

#[test]
fn the_cycle_of_van_der_pol_has_its_period_and_multiplier() {
    let orbit = Shooting::new()
        .autonomous(&van_der_pol(1.0), [2.0, 0.5], 6.0)
        .expect("a cycle");
    // E. Hairer, S. P. Norsett, G. Wanner, "Solving Ordinary Differential Equations I", 2nd ed. (1993), I.16, exercise
    // 1
    assert_abs_diff_eq!(orbit.period, 6.663_286_859_323_13, epsilon = 1e-10);
    // Liouville: the determinant of the monodromy matrix is the exponential of the divergence integrated along the
    // orbit
    let with_divergence = FnSystem(|_t: f64, x: &SVector<f64, 3>| {
        let divergence = 1.0 - x[0] * x[0];
        SVector::from([x[1], divergence * x[1] - x[0], divergence])
    });
    let start = [orbit.x[0], orbit.x[1], 0.0];
    let tight = Vern7::new().rtol(1e-13).atol(1e-13);
    let end = tight
        .solve(&with_divergence, 0.0, orbit.period, start)
        .expect("a smooth system")
        .end();
    let [multiplier] = orbit.nontrivial() else {
        panic!("there is one across the orbit")
    };
    assert_abs_diff_eq!(multiplier.value.re, end[2].exp(), epsilon = 1e-12);
    assert!(multiplier.uncertainty < 1e-8);
    assert_eq!(orbit.stability(), Stability::AsymptoticallyStable);
    // the other multiplier is 1, for the motion along the orbit
    let first = &orbit.multipliers.modes()[0];
    assert_abs_diff_eq!(first.eigenvalue.re, 1.0, epsilon = 1e-10);
    let motion = van_der_pol(1.0).rhs(0.0, &orbit.x);
    let along = first.shape.map(|component| component.re);
    assert_abs_diff_eq!(along.perp(&motion) / motion.norm(), 0.0, epsilon = 1e-9);
}

#[test]
fn the_search_goes_straight_across_to_the_orbit() {
    // from a distant guess, with a period that is a third off
    let orbit = Shooting::new()
        .autonomous(&van_der_pol(3.0), [1.0, 1.0], 6.0)
        .expect("a cycle");
    // a long integration converges to it
    let upward = Event::new(|_t, x: &SVector<f64, 2>| x[0]).rising();
    let method = Vern9::new().rtol(1e-12).atol(1e-12);
    let points = pendulum_core::stability::section(&method, &van_der_pol(3.0), 0.0, 100.0, [2.0, 0.0], &upward);
    let times: Vec<f64> = points.expect("a smooth system").iter().map(|point| point.t).collect();
    let [.., before, last] = times[..] else {
        panic!("it comes again and again")
    };
    assert_abs_diff_eq!(orbit.period, last - before, epsilon = 1e-9);
}

#[test]
fn a_pendulum_swings_and_turns_over_with_the_periods_of_jacobi() {
    let shooting = Shooting::new();
    let swing: PeriodicOrbit<2> = shooting.autonomous(&Pendulum, [1.0, 0.3], 6.5).expect("a libration");
    // sine of half the amplitude, from the energy
    let k = (0.25 * swing.x[1].powi(2) + (0.5 * swing.x[0]).sin().powi(2)).sqrt();
    assert_abs_diff_eq!(swing.period, 4.0 * elliptic_k(k), epsilon = 1e-10);
    assert_eq!(swing.turns, [0, 0]);
    let over: PeriodicOrbit<2> = shooting.autonomous(&Pendulum, [0.2, -2.5], 3.0).expect("a rotation");
    let fastest = (over.x[1].powi(2) + 2.0 - 2.0 * over.x[0].cos()).sqrt();
    assert_abs_diff_eq!(over.period, 4.0 / fastest * elliptic_k(2.0 / fastest), epsilon = 1e-10);
    assert_eq!(over.turns, [-1, 0]);
    for orbit in [swing, over] {
        let [multiplier] = orbit.nontrivial() else {
            panic!("there is one across the orbit")
        };
        assert_abs_diff_eq!(multiplier.value.re, 1.0, epsilon = 1e-9);
        assert_abs_diff_eq!(orbit.monodromy.determinant(), 1.0, epsilon = 1e-9);
        assert_eq!(orbit.stability(), Stability::Undecided);
    }
}

/// Only a layout marks a full turn as closed.
#[test]
fn without_a_layout_a_rotation_does_not_close() {
    let unknown = planar(|_, q: f64, _| -q.sin(), |_, q: f64, _| [-q.cos(), 0.0]);
    let over = Shooting::new().autonomous(&unknown, [0.2, -2.5], 3.0);
    assert!(over.is_err(), "{over:?}");
    let swing = Shooting::new().autonomous(&unknown, [1.0, 0.3], 6.5);
    assert!(swing.is_ok(), "{swing:?}");
}

#[test]
fn of_a_family_of_orbits_that_with_a_given_period_is_found() {
    let orbit = Shooting::new().forced(&Pendulum, [1.5, 0.0], 8.0).expect("a libration");
    let k = (0.25 * orbit.x[1].powi(2) + (0.5 * orbit.x[0]).sin().powi(2)).sqrt();
    assert_abs_diff_eq!(4.0 * elliptic_k(k), 8.0, epsilon = 1e-9);
}

/// Characteristic values of Mathieu's equation for even functions of period pi, in ascending order: eigenvalues of the
/// tridiagonal matrix of their Fourier coefficients.
fn even_characteristic_values(q: f64) -> Vec<f64> {
    let matrix = DMatrix::from_fn(30, 30, |i, j| match (i, j) {
        (i, j) if i == j => (2 * i).pow(2) as f64,
        (0, 1) | (1, 0) => 2.0_f64.sqrt() * q,
        (i, j) if i.abs_diff(j) == 1 => q,
        _ => 0.0,
    });
    let mut values: Vec<f64> = matrix.symmetric_eigenvalues().iter().copied().collect();
    values.sort_by(f64::total_cmp);
    values
}

/// Characteristic values of Mathieu's equation for odd functions of period 2 pi, in ascending order.
fn odd_characteristic_values(q: f64) -> Vec<f64> {
    let matrix = DMatrix::from_fn(30, 30, |i, j| match (i, j) {
        (0, 0) => 1.0 - q,
        (i, j) if i == j => (2 * i + 1).pow(2) as f64,
        (i, j) if i.abs_diff(j) == 1 => q,
        _ => 0.0,
    });
    let mut values: Vec<f64> = matrix.symmetric_eigenvalues().iter().copied().collect();
    values.sort_by(f64::total_cmp);
    values
}

#[test]
fn multipliers_of_mathieus_equation_are_one_on_its_characteristic_curves() {
    let rest = |a, q| {
        Shooting::new()
            .forced(&mathieu(a, q), [0.0, 0.0], PI)
            .expect("rest is periodic")
    };
    // M. Abramowitz, I. Stegun, "Handbook of Mathematical Functions", table 20.1
    let a = even_characteristic_values(5.0);
    assert_abs_diff_eq!(a[0], -5.800_046_02, epsilon = 1e-8);
    let b = odd_characteristic_values(5.0);
    assert_abs_diff_eq!(b[0], -5.790_080_60, epsilon = 1e-8);
    for (a, q, multiplier) in [(a[0], 5.0, 1.0), (a[1], 5.0, 1.0), (b[0], 5.0, -1.0), (b[1], 5.0, -1.0)] {
        let orbit = rest(a, q);
        assert_abs_diff_eq!(orbit.monodromy.trace(), 2.0 * multiplier, epsilon = 1e-8);
        for found in orbit.nontrivial() {
            let error = (found.value - multiplier).norm();
            assert!(error <= found.uncertainty && error < 1e-3, "{found:?}");
        }
    }
    // between a0 and b1 solutions are bounded; between b1 and a1 they grow
    assert_eq!(rest(0.5 * (a[0] + b[0]), 5.0).stability(), Stability::Undecided);
    assert_eq!(rest(b[0] + 1.0, 5.0).stability(), Stability::Unstable);
    // without drive, the multipliers of a linear oscillator over one drive period
    let [plus, _] = rest(0.3, 0.0).nontrivial().to_vec()[..] else {
        panic!("there are two")
    };
    assert_abs_diff_eq!(plus.value.arg(), PI * 0.3_f64.sqrt(), epsilon = 1e-11);
}

#[test]
fn a_pendulum_stands_upright_from_kapitzas_frequency_on() {
    // pivot at a cos(omega t); the linearisation about the top is Mathieu's equation with the parameters -4 g / (l
    // omega^2) and 2 a / l
    let (gravity, a) = (9.81, 0.2);
    let critical = (-4.0 * gravity / even_characteristic_values(2.0 * a)[0]).sqrt();
    // P. L. Kapitza's average over fast oscillation: a omega = sqrt(2 g l)
    assert_abs_diff_eq!(critical * a / (2.0 * gravity).sqrt(), 1.0, epsilon = 0.02);
    let upright = |omega: f64| {
        let pull = move |t: f64| gravity - a * omega * omega * (omega * t).cos();
        let shaken = planar(
            move |t, q: f64, _| pull(t) * q.sin(),
            move |t, q: f64, _| [pull(t) * q.cos(), 0.0],
        );
        Shooting::new()
            .forced(&shaken, [0.0, 0.0], TAU / omega)
            .expect("upright is periodic")
            .stability()
    };
    assert_eq!(upright(critical * (1.0 - 1e-7)), Stability::Unstable);
    assert_eq!(upright(critical * (1.0 + 1e-7)), Stability::Undecided);
}

#[test]
fn a_search_that_fails_tells_why() {
    let shooting = Shooting::new();
    let at_rest = shooting.autonomous(&van_der_pol(1.0), [1e-3, 0.0], 6.3);
    assert_eq!(at_rest, Err(StabilityError::AtRest));
    // free fall has no periodic motion
    let falling = planar(|_, _, _| -9.81, |_, _, _| [0.0, 0.0]);
    let none = shooting.forced(&falling, [0.0, 1.0], 1.0);
    assert!(
        matches!(none, Err(StabilityError::NoConvergence { residual, .. }) if residual > 9.0),
        "{none:?}"
    );
    let backward = shooting
        .forced(&Pendulum, [0.0, 1.0], -1.0)
        .expect_err("no period is negative");
    assert_eq!(
        backward.to_string(),
        "`period` is -1.0: a period must be finite and positive"
    );
    // the solution of x'' = x^2 blows up
    let escape = planar(|_, x, _| x * x, |_, x, _| [2.0 * x, 0.0]);
    let lost = shooting.forced(&escape, [10.0, 10.0], 10.0);
    assert!(matches!(lost, Err(StabilityError::Integration(_))), "{lost:?}");
}
