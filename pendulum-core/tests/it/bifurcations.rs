//! Bifurcations known in closed form or as eigenvalues of a matrix: kind, location and error bound.

use std::f64::consts::{PI, TAU};

use nalgebra::{DMatrix, SMatrix, SVector};
use pendulum_core::prelude::*;
use pendulum_core::stability::{Bifurcation, BifurcationKind, Continuation};
use pendulum_core::{ParameterError, Slot, SlotKind, StateLayout};

use super::continuation::{rotor, subcritical, van_der_pol_at};

/// A bifurcation with its known and its computed parameter.
struct Case {
    family: &'static str,
    known: f64,
    found: f64,
    uncertainty: f64,
}

fn is_named(kind: BifurcationKind, name: &str) -> bool {
    format!("{kind:?}").starts_with(name)
}

/// Compares all bifurcations of a branch with the known ones.
fn compare<P>(
    cases: &mut Vec<Case>,
    family: &'static str,
    found: &[Bifurcation<P>],
    mut known: Vec<(&'static str, f64)>,
) {
    known.sort_by(|a, b| a.1.total_cmp(&b.1));
    let mut listed: Vec<_> = found
        .iter()
        .map(|bifurcation| (bifurcation.kind, bifurcation))
        .collect();
    listed.sort_by(|a, b| a.1.parameter.total_cmp(&b.1.parameter));
    let names: Vec<_> = listed.iter().map(|(kind, found)| (*kind, found.parameter)).collect();
    assert_eq!(listed.len(), known.len(), "{family}: {names:?}, known {known:?}");
    for ((kind, found), (name, at)) in listed.into_iter().zip(known) {
        assert!(is_named(kind, name), "{family}: {names:?}, known {name} at {at}");
        cases.push(Case {
            family,
            known: at,
            found: found.parameter,
            uncertainty: found.uncertainty,
        });
    }
}

/// Values of `p` for which `x'' + damping x' + (offset + p weight(t)) x = 0`, with `weight = 1 + ripple cos 2t`, has a
/// solution of period pi, or of period `2 pi` with a sign change after half of it. They are eigenvalues of a matrix of
/// Fourier coefficients of cosines and sines.
fn hill(damping: f64, offset: impl Fn(&DMatrix<f64>) -> (DMatrix<f64>, DMatrix<f64>), odd: bool) -> Vec<f64> {
    const HARMONICS: usize = 24;
    let harmonic = |k: usize| if odd { 2 * k + 1 } else { 2 * k };
    // cosines first, then sines; the even case has no sine of frequency 0
    let first = usize::from(!odd);
    let (cosines, sines) = (HARMONICS, HARMONICS - first);
    let size = cosines + sines;
    let mut motion = DMatrix::zeros(size, size);
    for k in 0..HARMONICS {
        let n = harmonic(k) as f64;
        motion[(k, k)] = n * n;
        if k >= first {
            let sine = cosines + k - first;
            motion[(sine, sine)] = n * n;
            // from -damping x': the derivative of a cosine is a sine
            motion[(sine, k)] = damping * n;
            motion[(k, sine)] = -damping * n;
        }
    }
    // multiplication by cos 2t
    let mut wave = DMatrix::zeros(size, size);
    for k in 0..HARMONICS {
        let n = harmonic(k) as i64;
        for shifted in [n + 2, n - 2] {
            let place = |n: i64| (0..HARMONICS).find(|&k| harmonic(k) as i64 == n);
            if let Some(to) = place(shifted.abs()) {
                wave[(to, k)] += 0.5;
                if k >= first && to >= first {
                    let sign = if shifted < 0 { -0.5 } else { 0.5 };
                    wave[(cosines + to - first, cosines + k - first)] += sign;
                }
            }
        }
    }
    // motion v = (constant + p varying) v
    let (constant, varying) = offset(&wave);
    let matrix = varying.lu().solve(&(motion - constant)).expect("regular");
    let eigenvalues = matrix.complex_eigenvalues();
    let mut real: Vec<f64> = eigenvalues
        .iter()
        .filter(|value| value.im.abs() < 1e-9)
        .map(|value| value.re)
        .collect();
    real.sort_by(f64::total_cmp);
    real
}

/// `x'' = acceleration(t, x) - c x'`, with the derivative of the acceleration.
fn swing(
    c: f64,
    acceleration: impl Fn(f64, f64) -> f64,
    slope: impl Fn(f64, f64) -> f64,
) -> Result<impl Jacobian<f64, 2>, ParameterError> {
    Ok(FnSystem::with_jacobian(
        move |t: f64, x: &SVector<f64, 2>| SVector::from([x[1], acceleration(t, x[0]) - c * x[1]]),
        move |t: f64, x: &SVector<f64, 2>| SMatrix::from([[0.0, slope(t, x[0])], [1.0, -c]]),
    ))
}

/// The rest solution of `x'' + c x' + (a - 2 q cos 2t) x = 0`, with the parameter `a`.
fn mathieu(cases: &mut Vec<Case>, c: f64, q: f64, tolerance: f64) {
    let span = (-0.8, 4.6);
    let family = |a: f64| {
        let stiffness = move |t: f64| a - 2.0 * q * (2.0 * t).cos();
        swing(c, move |t, x| -stiffness(t) * x, move |t, _| -stiffness(t))
    };
    let branch = Continuation::new(family, span.0, span.1)
        .tolerance(tolerance)
        .forced_orbits([0.0, 0.0], |_| PI, 0.5)
        .expect("rest");
    compare(cases, "Mathieu", branch.bifurcations(), of_mathieu(span, c, q));
}

fn of_mathieu(span: (f64, f64), c: f64, q: f64) -> Vec<(&'static str, f64)> {
    let known = |odd, name| {
        let of_wave = |wave: &DMatrix<f64>| (wave * (2.0 * q), DMatrix::identity(wave.nrows(), wave.nrows()));
        let all = hill(c, of_wave, odd).into_iter();
        all.filter(move |a| (span.0..span.1).contains(a))
            .map(move |a| (name, a))
    };
    known(false, "Crossing").chain(known(true, "PeriodDoubling")).collect()
}

/// A pendulum with a vertically oscillating pivot, `x'' + c x' + (a - 2 q cos 2t) sin x = 0`, hanging or standing, with
/// the parameter `a`.
fn pendulum(cases: &mut Vec<Case>, c: f64, q: f64, standing: bool) {
    let (span, sign) = if standing {
        ((-1.2, 0.6), -1.0)
    } else {
        ((0.2, 4.6), 1.0)
    };
    let family = |a: f64| {
        let stiffness = move |t: f64| a - 2.0 * q * (2.0 * t).cos();
        swing(
            c,
            move |t, x| -sign * stiffness(t) * x.sin(),
            move |t, x| -sign * stiffness(t) * x.cos(),
        )
    };
    let branch = Continuation::new(family, span.0, span.1)
        .forced_orbits([0.0, 0.0], |_| PI, 0.5)
        .expect("rest");
    let known = if standing {
        // standing at a is equivalent to hanging at -a, half a drive period later
        of_mathieu((-span.1, -span.0), c, q)
            .into_iter()
            .map(|(name, a)| (name, -a))
            .collect()
    } else {
        of_mathieu(span, c, q)
    };
    compare(cases, "pendulum", branch.bifurcations(), known);
}

/// Duffing's equation `x'' + c x' + k x + x^3`, driven so that `x = A cos t`, with the parameter `A`.
fn duffing(cases: &mut Vec<Case>, c: f64, k: f64, tolerance: f64) {
    let span = (0.1, 3.0);
    let family = |amplitude: f64| {
        let drive = move |t: f64| {
            let x = amplitude * t.cos();
            (k - 1.0) * x - c * amplitude * t.sin() + x * x * x
        };
        swing(
            c,
            move |t, x| drive(t) - k * x - x * x * x,
            move |_, x| -k - 3.0 * x * x,
        )
    };
    let branch = Continuation::new(family, span.0, span.1)
        .step(0.02)
        .tolerance(tolerance)
        .forced_orbits([0.2, 0.0], |_| TAU, 0.2)
        .expect("a response");
    let mut known = Vec::new();
    for odd in [false, true] {
        let of_wave = |wave: &DMatrix<f64>| {
            let one = DMatrix::identity(wave.nrows(), wave.nrows());
            (&one * k, (one + wave) * 1.5)
        };
        let squares = hill(c, of_wave, odd).into_iter().filter(|square| *square > 0.0);
        known.extend(
            squares
                .map(|square| ("Crossing", square.sqrt()))
                .filter(|(_, a)| (span.0..span.1).contains(a)),
        );
    }
    compare(cases, "Duffing", branch.bifurcations(), known);
}

fn lorenz(sigma: f64, beta: f64) -> impl Fn(f64) -> Result<Lorenz, ParameterError> {
    move |rho| Ok(Lorenz { sigma, beta, rho })
}

struct Lorenz {
    sigma: f64,
    beta: f64,
    rho: f64,
}

impl System<f64, 3> for Lorenz {
    fn rhs(&self, _t: f64, x: &SVector<f64, 3>) -> SVector<f64, 3> {
        let Self { sigma, beta, rho } = *self;
        SVector::from([
            sigma * (x[1] - x[0]),
            x[0] * (rho - x[2]) - x[1],
            x[0] * x[1] - beta * x[2],
        ])
    }
}

impl Jacobian<f64, 3> for Lorenz {
    fn jacobian(&self, _t: f64, x: &SVector<f64, 3>) -> SMatrix<f64, 3, 3> {
        let Self { sigma, beta, rho } = *self;
        SMatrix::from([[-sigma, rho - x[2], x[1]], [sigma, -1.0, x[0]], [0.0, -x[0], -beta]])
    }
}

fn rest_of_lorenz(cases: &mut Vec<Case>, sigma: f64, beta: f64) {
    let family = lorenz(sigma, beta);
    let rest = Continuation::new(&family, 0.2, 2.0)
        .equilibria([0.0; 3], 0.5)
        .expect("rest");
    compare(cases, "Lorenz", rest.bifurcations(), vec![("Crossing", 1.0)]);
    let hopf = sigma * (sigma + beta + 3.0) / (sigma - beta - 1.0);
    let beside = (beta * (0.9 * hopf - 1.0)).sqrt();
    let convection = Continuation::new(&family, 0.7 * hopf, 1.2 * hopf)
        .equilibria([beside, beside, 0.9 * hopf - 1.0], 0.9 * hopf)
        .expect("convection");
    compare(cases, "Lorenz", convection.bifurcations(), vec![("Hopf", hopf)]);
}

/// `r' = p r + b r^3 - r^5` with the angular velocity `1 + r^2`: rest, and the cycle with a fold at `-b^2 / 4`.
fn cycles(cases: &mut Vec<Case>, b: f64) {
    let family = |p: f64| {
        Ok(rotor(
            move |rr| ([p + b * rr - rr * rr, 1.0 + rr], [b - 2.0 * rr, 1.0]),
            (0.0, 0.0),
        ))
    };
    let continuation = Continuation::new(family, -0.4 * b * b, 0.3);
    let start = (0.5 * (b + (b * b + 0.4).sqrt())).sqrt();
    let branch = continuation
        .autonomous_orbits([start, 0.0], TAU / (1.0 + start * start), 0.1)
        .expect("the large cycle");
    compare(cases, "cycles", branch.bifurcations(), vec![("Fold", -0.25 * b * b)]);
    let rest = continuation.equilibria([0.0, 0.0], -0.1 * b * b).expect("rest");
    compare(cases, "cycles", rest.bifurcations(), vec![("Hopf", 0.0)]);
}

/// `z' = (p + 2 i - |z|^2) z + F exp(3 i t)`. In the frame that rotates with the drive, the trace is zero at
/// `p = 2 |z|^2`.
fn torus(cases: &mut Vec<Case>, square: f64) {
    let p = 2.0 * square;
    let drive = (square * (1.0 + (p - square).powi(2))).sqrt();
    let family = |p: f64| Ok(rotor(move |rr| ([p - rr, 2.0], [-1.0, 0.0]), (drive, 3.0)));
    let branch = Continuation::new(family, p - 0.3, p + 0.3)
        .forced_orbits([0.3, 0.3], |_| TAU / 3.0, p - 0.25)
        .expect("a response");
    compare(cases, "torus", branch.bifurcations(), vec![("Torus", p)]);
}

fn van_der_pol(cases: &mut Vec<Case>, frequency: f64) {
    let branch = Continuation::new(|mu| van_der_pol_at(frequency, mu), -1.0, 1.5)
        .equilibria([0.1, 0.1], -0.7)
        .expect("rest");
    compare(cases, "van der Pol", branch.bifurcations(), vec![("Hopf", 0.0)]);
}

#[test]
fn characteristic_values_of_mathieu_are_right() {
    // J. Meixner, F. W. Schaefke, "Mathieusche Funktionen und Sphaeroidfunktionen" (1954)
    let known = of_mathieu((-0.8, 4.6), 0.0, 1.0);
    let reference = [
        -0.455_138_604_107_414,
        3.917_024_772_998_471,
        4.371_300_982_735_085,
        -0.110_248_816_992_095,
        1.859_108_072_514_364,
    ];
    let mut found: Vec<f64> = known.into_iter().map(|(_, a)| a).collect();
    found[..3].sort_by(f64::total_cmp);
    found[3..].sort_by(f64::total_cmp);
    for (found, reference) in found.into_iter().zip(reference) {
        assert!((found - reference).abs() < 1e-12, "{found} {reference}");
    }
}

/// A pair of multipliers inside the unit circle is no torus bifurcation, however weak the damping.
#[test]
fn bifurcations_are_named_and_their_uncertainty_covers_the_error() {
    let mut cases = Vec::new();
    let is_thorough = std::env::var_os("PENDULUM_THOROUGH").is_some();
    mathieu(&mut cases, 1e-6, 1.0, 1e-8);
    if is_thorough {
        for (c, q, tolerance) in [(0.0, 1.0, 1e-8), (1e-6, 0.9, 1e-10), (1e-3, 1.0, 1e-8)] {
            mathieu(&mut cases, c, q, tolerance);
        }
        duffing(&mut cases, 0.1, 0.3, 1e-8);
        duffing(&mut cases, 1e-6, 0.3, 1e-10);
        pendulum(&mut cases, 1e-6, 0.7, false);
    }
    pendulum(&mut cases, 0.1, 0.7, true);
    for &sigma in &[10.0, 8.0, 12.0, 16.0][..if is_thorough { 4 } else { 1 }] {
        for beta in [1.0, 1.5, 2.0, 2.5, 8.0 / 3.0, 3.0, 4.0] {
            rest_of_lorenz(&mut cases, sigma, beta);
        }
    }
    for &size in &[1.0, 0.7, 1.5][..if is_thorough { 3 } else { 1 }] {
        cycles(&mut cases, size);
        van_der_pol(&mut cases, size);
    }
    for square in [0.2, 0.25, 0.3] {
        torus(&mut cases, square);
    }
    let mut families: Vec<&str> = cases.iter().map(|case| case.family).collect();
    families.dedup();
    families.sort_unstable();
    families.dedup();
    let median = |mut values: Vec<f64>| {
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    let mut covered = 0;
    for family in families {
        let of: Vec<&Case> = cases.iter().filter(|case| case.family == family).collect();
        let error = |case: &&Case| (case.found - case.known).abs();
        let within = of.iter().filter(|case| error(case) <= case.uncertainty).count();
        let ratio = median(
            of.iter()
                .map(|case| case.uncertainty / error(case).max(1e-16))
                .collect(),
        );
        println!(
            "{family}: {within} of {}; errors to {:.1e}, in the median {:.1e}; \
             stated to {:.1e}, in the median {:.1e}; ratio {ratio:.1}",
            of.len(),
            of.iter().map(error).fold(0.0, f64::max),
            median(of.iter().map(error).collect()),
            of.iter().map(|case| case.uncertainty).fold(0.0, f64::max),
            median(of.iter().map(|case| case.uncertainty).collect()),
        );
        for case in of.iter().filter(|case| error(case) > case.uncertainty) {
            println!(
                "  {:?} known {} stated {:e} error {:e}",
                case.found,
                case.known,
                case.uncertainty,
                error(case)
            );
        }
        covered += within;
    }
    assert!(cases.len() > 100 || !is_thorough, "{}", cases.len());
    assert!(covered * 100 >= cases.len() * 95, "{covered} of {}", cases.len());
}

/// Two uncoupled systems with simultaneous period doublings: the determinant does not change sign.
#[test]
fn what_cannot_be_named_is_reported_with_its_multipliers() {
    let family = |a: f64| {
        let stiffness = move |t: f64| a - 2.0 * (2.0 * t).cos();
        Ok(FnSystem::with_jacobian(
            move |t: f64, x: &SVector<f64, 4>| {
                let k = stiffness(t);
                SVector::from([x[2], x[3], -k * x[0] - 0.1 * x[2], -k * x[1] - 0.1 * x[3]])
            },
            move |t: f64, _: &SVector<f64, 4>| {
                let k = stiffness(t);
                SMatrix::from([
                    [0.0, 0.0, -k, 0.0],
                    [0.0, 0.0, 0.0, -k],
                    [1.0, 0.0, -0.1, 0.0],
                    [0.0, 1.0, 0.0, -0.1],
                ])
            },
        ))
    };
    let branch = Continuation::new(family, -0.2, 1.0)
        .forced_orbits([0.0; 4], |_| PI, 0.9)
        .expect("rest");
    let [found] = branch.bifurcations() else {
        panic!("{:?}", branch.bifurcations())
    };
    assert_eq!(found.kind, BifurcationKind::Unnamed);
    let known = of_mathieu((-0.2, 1.0), 0.1, 1.0);
    assert_eq!(known.len(), 1);
    assert!((found.parameter - known[0].1).abs() < 1e-6);
    let at_limit = found
        .solution
        .nontrivial()
        .iter()
        .filter(|multiplier| (multiplier.value + 1.0).norm() < 1e-5);
    assert_eq!(at_limit.count(), 2);
}

/// Continuation of cycles from their Hopf bifurcation: the small cycle of `r' = p r + r^3 - r^5` around its fold, and
/// the unstable cycle of the Lorenz system.
#[test]
fn cycles_are_followed_from_the_bifurcation_where_they_begin() {
    let continuation = Continuation::new(subcritical, -0.4, 0.3);
    let rest = continuation.equilibria([0.0, 0.0], -0.1).expect("rest");
    let cycles = continuation.cycles(&rest.bifurcations()[0]).expect("a cycle");
    assert_eq!(cycles.bifurcations().len(), 1);
    assert_eq!(cycles.bifurcations()[0].kind, BifurcationKind::Fold);
    for point in cycles.points() {
        let rr = point.solution.x.norm_squared();
        assert!((point.parameter + rr - rr * rr).abs() < 1e-9);
        assert!((point.solution.period - TAU / (1.0 + rr)).abs() < 1e-8);
    }
    let ends = cycles.points().iter().map(|point| point.parameter);
    assert!(ends.clone().fold(f64::INFINITY, f64::min) < -0.24 && ends.fold(-1.0, f64::max) == 0.3);
    let no = continuation.cycles(&Bifurcation {
        kind: BifurcationKind::Fold,
        ..rest.bifurcations()[0].clone()
    });
    assert!(
        no.expect_err("a fold")
            .to_string()
            .contains("cycles begin at a Hopf bifurcation")
    );

    let continuation = Continuation::new(lorenz(10.0, 8.0 / 3.0), 20.0, 26.0);
    let convection = continuation.equilibria([7.8, 7.8, 23.0], 24.0).expect("convection");
    let cycles = continuation.cycles(&convection.bifurcations()[0]).expect("a cycle");
    let near = |rho: f64| {
        let apart = |point: &&pendulum_core::stability::BranchPoint<_>| (point.parameter - rho).abs();
        cycles
            .points()
            .iter()
            .min_by(|a, b| apart(a).total_cmp(&apart(b)))
            .expect("points")
    };
    for rho in [24.0, 22.0, 20.5] {
        let point = near(rho);
        assert!((point.parameter - rho).abs() < 0.5, "{}", point.parameter);
        let [outside, inside] = [0, 1].map(|k| point.solution.nontrivial()[k].value);
        assert!(
            outside.re > 1.0 && outside.im == 0.0 && inside.norm() < 1.0,
            "{outside} {inside}"
        );
        // the divergence is constant
        let product = (outside * inside).re;
        let known = (-(10.0 + 1.0 + 8.0 / 3.0) * point.solution.period).exp();
        assert!(
            (product / known - 1.0).abs() < 1e-2 || inside.norm() < point.solution.noise(),
            "{product} {known}"
        );
    }
}

/// A mass on a cubic spring, in metres and in millimetres: `x'' + 0.1 x' + 0.5 x + x^3 = p cos t`.
struct Spring {
    unit: f64,
    p: f64,
}

impl System<f64, 2> for Spring {
    fn rhs(&self, t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        let place = x[0] / self.unit;
        let force = self.p * t.cos() - 0.5 * place - place.powi(3);
        SVector::from([x[1], force * self.unit - 0.1 * x[1]])
    }

    fn layout(&self) -> Option<StateLayout<'_>> {
        const LAYOUT: StateLayout<'_> = StateLayout::new(&[Slot::new("x", SlotKind::Length, 0..1, 1..2)]);
        Some(LAYOUT)
    }
}

impl Jacobian<f64, 2> for Spring {
    fn jacobian(&self, _t: f64, x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        let place = x[0] / self.unit;
        SMatrix::from([[0.0, -0.5 - 3.0 * place * place], [1.0, -0.1]])
    }
}

#[test]
fn steps_along_a_branch_do_not_depend_on_units() {
    let follow = |unit: f64| {
        let branch = Continuation::new(|p| Ok(Spring { unit, p }), 0.0, 3.0)
            .length(unit)
            .tolerance(1e-12)
            .step(0.1)
            .forced_orbits([-0.01 * unit, 0.0], |_| TAU, 0.01)
            .expect("a response");
        let points: Vec<_> = branch
            .points()
            .iter()
            .map(|point| (point.parameter, point.solution.x[0] / unit))
            .collect();
        let bifurcations: Vec<_> = branch
            .bifurcations()
            .iter()
            .map(|found| (found.kind, found.parameter))
            .collect();
        (points, bifurcations)
    };
    let (expected, folds) = follow(1.0);
    let folds_of = folds.iter().filter(|(kind, _)| *kind == BifurcationKind::Fold).count();
    assert!(folds_of >= 2, "{folds:?}");
    for unit in [2.0_f64.powi(-10), 2.0_f64.powi(10)] {
        let (points, bifurcations) = follow(unit);
        assert_eq!(points.len(), expected.len());
        for (point, expected) in points.iter().zip(&expected) {
            assert!((point.0 - expected.0).abs() < 1e-8 && (point.1 - expected.1).abs() < 1e-8);
        }
        for (found, expected) in bifurcations.iter().zip(&folds) {
            assert!((found.1 - expected.1).abs() < 1e-8 && found.0 == expected.0);
        }
    }
}

/// Multipliers below the integration error are distinguished from resolved ones.
#[test]
fn multipliers_below_the_noise_are_told() {
    use pendulum_core::stability::Shooting;
    let mut hidden = 0;
    for damping in [0.5, 2.0, 5.0, 12.0] {
        let family = swing(damping, |t, x| t.cos() - x, |_, _| -1.0).expect("a member");
        let orbit = Shooting::new()
            .forced(&family, [0.0, 1.0 / damping], TAU)
            .expect("a response");
        let root = (damping * damping / 4.0 - 1.0_f64).abs().sqrt();
        let rates = if damping > 2.0 {
            [-damping / 2.0 + root, -damping / 2.0 - root]
        } else {
            [-damping / 2.0; 2]
        };
        for (multiplier, rate) in orbit.nontrivial().iter().zip(rates) {
            let known = (rate * TAU).exp();
            let found = multiplier.value.norm();
            assert!(
                (found - known).abs() <= multiplier.uncertainty.max(orbit.noise()),
                "{found} {known}"
            );
            hidden += u32::from(found < orbit.noise());
        }
    }
    assert_eq!(hidden, 2);
}
