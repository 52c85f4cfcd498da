//! Branches of equilibria and of periodic orbits, and their bifurcations, against closed forms.

use std::f64::consts::{PI, TAU};

use approx::assert_abs_diff_eq;
use nalgebra::{SMatrix, SVector};
use pendulum_core::ParameterError;
use pendulum_core::prelude::*;
use pendulum_core::stability::{
    Bifurcation, BifurcationKind, BranchEnd, Continuation, PeriodicOrbit, Stability, StabilityError,
};

/// `x' = f(x)` with its derivative.
fn line(f: impl Fn(f64) -> f64, slope: impl Fn(f64) -> f64) -> impl Jacobian<f64, 1> {
    FnSystem::with_jacobian(
        move |_, x: &SVector<f64, 1>| SVector::from([f(x[0])]),
        move |_, x: &SVector<f64, 1>| SMatrix::from([[slope(x[0])]]),
    )
}

fn van_der_pol(mu: f64) -> Result<impl Jacobian<f64, 2>, ParameterError> {
    van_der_pol_at(1.0, mu)
}

/// `x'' = mu (1 - x^2) x' - frequency^2 x`
pub(crate) fn van_der_pol_at(frequency: f64, mu: f64) -> Result<impl Jacobian<f64, 2>, ParameterError> {
    let stiffness = frequency * frequency;
    Ok(FnSystem::with_jacobian(
        move |_, x: &SVector<f64, 2>| SVector::from([x[1], mu * (1.0 - x[0] * x[0]) * x[1] - stiffness * x[0]]),
        move |_, x: &SVector<f64, 2>| {
            let of_place = -2.0 * mu * x[0] * x[1] - stiffness;
            SMatrix::from([[0.0, of_place], [1.0, mu * (1.0 - x[0] * x[0])]])
        },
    ))
}

/// `z' = g(|z|^2) z + drive exp(i omega t)` in the plane, from `g` as `[Re, Im]` with its derivative.
pub(crate) fn rotor(g: impl Fn(f64) -> ([f64; 2], [f64; 2]), (drive, omega): (f64, f64)) -> impl Jacobian<f64, 2> {
    let g = std::rc::Rc::new(g);
    let of = g.clone();
    FnSystem::with_jacobian(
        move |t: f64, z: &SVector<f64, 2>| {
            let [re, im] = g(z.norm_squared()).0;
            let (sin, cos) = (omega * t).sin_cos();
            SVector::from([re * z[0] - im * z[1] + drive * cos, im * z[0] + re * z[1] + drive * sin])
        },
        move |_, z: &SVector<f64, 2>| {
            let ([re, im], [dre, dim]) = of(z.norm_squared());
            let turned = SVector::from([dre * z[0] - dim * z[1], dim * z[0] + dre * z[1]]);
            SMatrix::from([[re, im], [-im, re]]) + turned * (2.0 * z).transpose()
        },
    )
}

#[test]
fn rest_gives_way_to_the_cycle_of_van_der_pol_at_zero_with_frequency_one() {
    let branch = Continuation::new(van_der_pol, -1.0, 1.5)
        .equilibria([0.1, 0.1], -0.7)
        .expect("rest");
    let [
        Bifurcation {
            kind: BifurcationKind::Hopf { angular_frequency },
            parameter,
            ..
        },
    ] = branch.bifurcations()
    else {
        panic!("{:?}", branch.bifurcations())
    };
    assert_abs_diff_eq!(*parameter, 0.0, epsilon = 1e-10);
    assert_abs_diff_eq!(*angular_frequency, 1.0, epsilon = 1e-10);
    assert_eq!(branch.ends(), [const { BranchEnd::Span }; 2]);
    let parameters: Vec<f64> = branch.points().iter().map(|point| point.parameter).collect();
    assert!(parameters.is_sorted());
    assert_eq!((parameters[0], *parameters.last().expect("points")), (-1.0, 1.5));
    for point in branch.points() {
        let expected = if point.parameter < 0.0 {
            Stability::AsymptoticallyStable
        } else {
            Stability::Unstable
        };
        assert_eq!(point.solution.stability(), expected);
    }
}

#[test]
fn the_cycle_of_van_der_pol_is_followed_to_long_periods() {
    let branch = Continuation::new(van_der_pol, 0.5, 3.0)
        .autonomous_orbits([2.0, 0.0], 6.6, 1.0)
        .expect("a cycle");
    assert_eq!(branch.ends(), [const { BranchEnd::Span }; 2]);
    assert_eq!(branch.bifurcations(), []);
    let last = &branch.points().last().expect("points").solution;
    // compare with shooting from another initial guess
    let system = van_der_pol(3.0).expect("a member");
    let direct = pendulum_core::stability::Shooting::new()
        .autonomous(&system, [2.0, 0.0], 9.0)
        .expect("a cycle");
    assert_abs_diff_eq!(last.period, direct.period, epsilon = 1e-8);
}

#[test]
fn curves_that_cross_are_told_from_folds() {
    // a pitchfork next to x = sin p, on both branches
    let family = |p: f64| {
        let of = move |x: f64| x - p.sin();
        Ok(line(
            move |x| of(x) * (p - of(x).powi(2)),
            move |x| p - 3.0 * of(x).powi(2),
        ))
    };
    let through = Continuation::new(family, -1.0, 1.0)
        .equilibria([-0.4], -0.5)
        .expect("the straight branch");
    let [crossing] = through.bifurcations() else {
        panic!("{:?}", through.bifurcations())
    };
    assert_eq!(crossing.kind, BifurcationKind::Crossing);
    assert_abs_diff_eq!(crossing.parameter, 0.0, epsilon = 1e-8);
    let aside = Continuation::new(family, -1.0, 1.0)
        .equilibria([1.5], 0.7)
        .expect("a side branch");
    let [crossing] = aside.bifurcations() else {
        panic!("{:?}", aside.bifurcations())
    };
    assert_eq!(crossing.kind, BifurcationKind::Crossing);
    assert_abs_diff_eq!(crossing.parameter, 0.0, epsilon = 1e-8);
    // transcritical: x' = (x - p) (x + 2 p - 1), where x = p crosses x = 1 - 2 p at p = 1/3
    let family = |p: f64| Ok(line(move |x| (x - p) * (x + 2.0 * p - 1.0), move |x| 2.0 * x + p - 1.0));
    let branch = Continuation::new(family, -1.0, 1.0)
        .equilibria([-0.9], -0.9)
        .expect("a branch");
    let [crossing] = branch.bifurcations() else {
        panic!("{:?}", branch.bifurcations())
    };
    assert_eq!(crossing.kind, BifurcationKind::Crossing);
    assert_abs_diff_eq!(crossing.parameter, 1.0 / 3.0, epsilon = 1e-8);
}

#[test]
fn a_closed_branch_ends_where_it_began_with_both_its_folds() {
    let family = |p: f64| Ok(line(move |x| 1.0 - x * x - p * p, |x| -2.0 * x));
    let circle = Continuation::new(family, -3.0, 3.0)
        .equilibria([1.0], 0.1)
        .expect("a point of the circle");
    assert_eq!(circle.ends(), [const { BranchEnd::Closed }; 2]);
    assert_eq!(circle.points().first(), circle.points().last());
    let folds: Vec<f64> = circle.bifurcations().iter().map(|fold| fold.parameter).collect();
    assert_eq!(folds.len(), 2);
    assert_abs_diff_eq!(folds[0], 1.0, epsilon = 1e-9);
    assert_abs_diff_eq!(folds[1], -1.0, epsilon = 1e-9);
    assert!(
        circle
            .bifurcations()
            .iter()
            .all(|fold| fold.kind == BifurcationKind::Fold)
    );
}

#[test]
fn a_branch_that_ends_early_keeps_its_points_and_tells_why() {
    let root = |p: f64| Ok(line(move |x| p.powf(1.5) - x, |_| -1.0));
    let branch = Continuation::new(root, -1.0, 1.0)
        .equilibria([0.1], 0.25)
        .expect("a point");
    assert_eq!(
        branch.ends(),
        [BranchEnd::Failed(StabilityError::NotFinite), BranchEnd::Span]
    );
    assert_abs_diff_eq!(branch.points()[0].parameter, 0.0, epsilon = 1e-3);
    let error = || ParameterError::new("m", -0.5, "a mass must be positive", &[]);
    let family = |m: f64| {
        if m > 0.5 {
            Ok(line(move |x| 1.0 - m * x, move |_| -m))
        } else {
            Err(error())
        }
    };
    let branch = Continuation::new(family, 0.0, 2.0)
        .equilibria([1.0], 1.0)
        .expect("a point");
    assert_eq!(
        branch.ends(),
        [BranchEnd::Failed(StabilityError::Build(error())), BranchEnd::Span]
    );
    assert_abs_diff_eq!(branch.points()[0].parameter, 0.5, epsilon = 1e-4);
    let none = Continuation::new(family, 0.0, 2.0).equilibria([1.0], 0.3);
    assert_eq!(none, Err(StabilityError::Build(error())));
    let short = Continuation::new(family, 0.6, 2.0)
        .points(3)
        .equilibria([1.0], 1.0)
        .expect("a point");
    assert_eq!(
        (short.ends(), short.points().len()),
        ([const { BranchEnd::Points }; 2], 7)
    );
    let outside = Continuation::new(family, 0.6, 2.0)
        .equilibria([1.0], 3.0)
        .expect_err("3 is not in the span");
    assert_eq!(outside.to_string(), "`p0` is 3.0: the start must lie in the span");
}

/// `r' = mu r + r^3 - r^5` with the angular velocity `1 + r^2`.
pub(crate) fn subcritical(mu: f64) -> Result<impl Jacobian<f64, 2>, ParameterError> {
    Ok(rotor(
        move |rr| ([mu + rr - rr * rr, 1.0 + rr], [1.0 - 2.0 * rr, 1.0]),
        (0.0, 0.0),
    ))
}

#[test]
fn cycles_fold_at_minus_a_quarter_and_shrink_to_rest_at_zero() {
    let continuation = Continuation::new(subcritical, -0.4, 0.3);
    let branch = continuation
        .autonomous_orbits([1.05, 0.0], 3.0, 0.1)
        .expect("the large cycle");
    let [fold] = branch.bifurcations() else {
        panic!("{:?}", branch.bifurcations())
    };
    assert_eq!(fold.kind, BifurcationKind::Fold);
    assert_abs_diff_eq!(fold.parameter, -0.25, epsilon = 1e-9);
    assert_abs_diff_eq!(fold.solution.x.norm_squared(), 0.5, epsilon = 1e-5);
    assert_eq!(
        branch.ends(),
        [BranchEnd::Failed(StabilityError::AtRest), BranchEnd::Span]
    );
    let multiplier = |orbit: &PeriodicOrbit<2>| orbit.nontrivial()[0].value.re;
    for point in branch.points() {
        let (mu, rr) = (point.parameter, point.solution.x.norm_squared());
        assert_abs_diff_eq!(mu + rr - rr * rr, 0.0, epsilon = 1e-9);
        assert_abs_diff_eq!(point.solution.period, TAU / (1.0 + rr), epsilon = 1e-8);
        let expected = (point.solution.period * (2.0 * rr - 4.0 * rr * rr)).exp();
        assert_abs_diff_eq!(multiplier(&point.solution), expected, epsilon = 1e-8);
    }
    // the branch ends at the Hopf bifurcation of the equilibrium
    assert_abs_diff_eq!(branch.points()[0].parameter, 0.0, epsilon = 1e-6);
    let rest = continuation.equilibria([0.0, 0.0], -0.3).expect("rest");
    assert_eq!(
        rest.bifurcations()[0].kind,
        BifurcationKind::Hopf { angular_frequency: 1.0 }
    );
    assert_abs_diff_eq!(rest.bifurcations()[0].parameter, 0.0, epsilon = 1e-10);
}

/// `z' = (mu + 2 i - |z|^2) z + F exp(3 i t)`. In the frame that rotates with the drive it is
/// `w' = (mu - i - |w|^2) w + F`, where `|w|^2` determines the equilibria and the trace and determinant of their
/// linearisation.
fn driven_rotor(mu: f64) -> Result<impl Jacobian<f64, 2>, ParameterError> {
    let drive = (0.25 * (1.0 + 0.0625_f64)).sqrt();
    Ok(rotor(move |rr| ([mu - rr, 2.0], [-1.0, 0.0]), (drive, 3.0)))
}

#[test]
fn a_driven_cycle_loses_its_lock_to_a_torus() {
    // |w|^2 = 1/4 at mu = 1/2, where the trace 2 (mu - 2 |w|^2) is zero and the determinant is 1 - |w|^4
    let branch = Continuation::new(driven_rotor, 0.0, 1.0).forced_orbits([0.3, 0.3], |_| TAU / 3.0, 0.1);
    let branch = branch.expect("a response");
    let [
        Bifurcation {
            kind: BifurcationKind::Torus { angle },
            parameter,
            solution,
            ..
        },
    ] = branch.bifurcations()
    else {
        panic!("{:?}", branch.bifurcations())
    };
    assert_abs_diff_eq!(*parameter, 0.5, epsilon = 1e-9);
    assert_abs_diff_eq!(solution.x.norm_squared(), 0.25, epsilon = 1e-9);
    assert_abs_diff_eq!(*angle, (15.0_f64 / 16.0).sqrt() * TAU / 3.0, epsilon = 1e-8);
    assert_eq!(branch.ends(), [const { BranchEnd::Span }; 2]);
}

#[test]
fn a_period_that_depends_on_the_parameter_is_followed_through_resonance() {
    // x'' + 0.1 x' + x = cos(p t), with the known frequency response
    let family = |p: f64| {
        Ok(FnSystem::with_jacobian(
            move |t: f64, x: &SVector<f64, 2>| SVector::from([x[1], (p * t).cos() - x[0] - 0.1 * x[1]]),
            |_, _: &SVector<f64, 2>| SMatrix::from([[0.0, -1.0], [1.0, -0.1]]),
        ))
    };
    let branch = Continuation::new(family, 0.5, 2.0)
        .step(0.5)
        .forced_orbits([1.0, 0.0], |p| TAU / p, 0.6);
    let branch = branch.expect("a response");
    assert_eq!(branch.bifurcations(), []);
    for point in branch.points() {
        let p = point.parameter;
        let (a, b) = (1.0 - p * p, 0.1 * p);
        assert_abs_diff_eq!(point.solution.x[0], a / (a * a + b * b), epsilon = 1e-8);
        // the moduli of the multipliers follow from the decay in one drive period
        assert_abs_diff_eq!(
            point.solution.nontrivial()[0].value.norm(),
            (-0.1 * PI / p).exp(),
            epsilon = 1e-8
        );
    }
}
