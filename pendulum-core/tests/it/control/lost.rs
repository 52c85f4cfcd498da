//! Modes that inputs do not reach or outputs do not show.

use pendulum_core::control::{ControlError, LostModes, PbhTest, StateSpace};
use pendulum_core::nalgebra::{SMatrix, SVector};
use pendulum_core::stability::Complex;

use super::Random;

/// A pair with the eigenvalues `planted` out of reach of its `M` inputs, in rotated axes and random units.
fn planted<const N: usize, const M: usize>(
    random: &mut Random,
    planted: &[Complex<f64>],
) -> (SMatrix<f64, N, N>, SMatrix<f64, N, M>) {
    let reached = N - planted.len();
    let mut a = SMatrix::<f64, N, N>::from_fn(|i, j| if i >= reached && j < i { 0.0 } else { random.number() });
    for (n, value) in planted.iter().enumerate() {
        let i = reached + n;
        a[(i, i)] = value.re;
        if value.im < 0.0 {
            (a[(i - 1, i)], a[(i, i - 1)]) = (-value.im, value.im);
        }
    }
    let b = SMatrix::<f64, N, M>::from_fn(|i, _| if i >= reached { 0.0 } else { random.number() });
    let axes = random.rotation::<N>();
    let units = SVector::<f64, N>::from_fn(|_, _| 10.0_f64.powf(random.number()));
    let (scale, over) = (
        SMatrix::from_diagonal(&units),
        SMatrix::from_diagonal(&units.map(f64::recip)),
    );
    (scale * axes * a * axes.transpose() * over, scale * axes * b)
}

/// Each eigenvalue is found once, with its left eigenvector, on which the inputs do not act.
fn check<const N: usize, const M: usize>(
    lost: &LostModes<N>,
    expected: &[Complex<f64>],
    a: &SMatrix<f64, N, N>,
    b: &SMatrix<f64, N, M>,
) {
    assert_eq!(lost.modes.len(), expected.len(), "{expected:?}: {lost:?}");
    let mut rest = expected.to_vec();
    for mode in &lost.modes {
        let nearest = (0..rest.len())
            .min_by(|&i, &j| {
                (rest[i] - mode.eigenvalue)
                    .norm()
                    .total_cmp(&(rest[j] - mode.eigenvalue).norm())
            })
            .expect("one for each");
        assert!(
            (rest.swap_remove(nearest) - mode.eigenvalue).norm() < 1e-6,
            "{expected:?}: {lost:?}"
        );
        let row = mode.direction.transpose();
        let change = row * a.map(Complex::from) - row * mode.eigenvalue;
        assert!(
            change.map(Complex::norm).max() < 1e-9 * a.norm(),
            "{}",
            change.map(Complex::norm).max()
        );
        let influence = row * b.map(Complex::from);
        assert!(influence.map(Complex::norm).max() < 1e-10 * b.norm());
        assert!((mode.direction.map(Complex::norm).max() - 1.0).abs() < 1e-12);
    }
}

fn tried<const N: usize, const M: usize>(random: &mut Random, modes: &[Complex<f64>]) {
    let (a, b) = planted::<N, M>(random, modes);
    let model = StateSpace::new(a, b);
    let test: PbhTest<N> = model.controllability().expect("finite");
    check(&test.lost, modes, &a, &b);
    // Observability of the transposed pair is the same question.
    let dual = StateSpace::new(a.transpose(), SMatrix::<f64, N, 0>::zeros());
    let dual = dual.with_output_matrices(b.transpose(), SMatrix::zeros());
    check(&dual.observability().expect("finite").lost, modes, &a, &b);
    let persistent: Vec<_> = modes.iter().copied().filter(|mode| mode.re >= 0.0).collect();
    match model.lqr(&SMatrix::identity(), &SMatrix::identity()) {
        Err(ControlError::Unstabilizable(lost)) => check(&lost, &persistent, &a, &b),
        result => assert!(persistent.is_empty() && result.is_ok(), "{persistent:?}: {result:?}"),
    }
    match dual.kalman(&SMatrix::identity(), &SMatrix::identity()) {
        Err(ControlError::Undetectable(lost)) => check(&lost, &persistent, &a, &b),
        result => assert!(persistent.is_empty() && result.is_ok(), "{persistent:?}: {result:?}"),
    }
}

#[test]
fn planted_modes_are_named() {
    let mut random = Random(5);
    let (real, i) = (Complex::from, Complex::new(0.0, 1.0));
    let pair = |re: f64, im: f64| [re + i * im, re - i * im];
    for _ in 0..6 {
        tried::<2, 1>(&mut random, &[real(0.7)]);
        tried::<3, 1>(&mut random, &[]);
        tried::<4, 1>(&mut random, &pair(0.2, 1.5));
        tried::<5, 2>(&mut random, &[real(-0.4), real(0.3)]);
        tried::<8, 1>(&mut random, &[pair(-0.1, 2.0), pair(0.0, 0.5)].concat());
        tried::<8, 3>(&mut random, &[&pair(0.0, 3.0)[..], &[real(0.0)]].concat());
        tried::<12, 2>(&mut random, &[real(-1.0), real(1.0), real(2.0)]);
        tried::<14, 1>(&mut random, &[real(0.5)]);
        tried::<14, 3>(&mut random, &[]);
    }
}

#[test]
fn a_lost_mode_may_share_its_eigenvalue_with_one_that_is_reached() {
    // x' = v + u, v' = 0: a constant disturbance beside a velocity that is controlled.
    let a = SMatrix::<f64, 2, 2>::new(0.0, 1.0, 0.0, 0.0);
    let test = StateSpace::new(a, SMatrix::from([[1.0, 0.0]]))
        .controllability()
        .expect("finite");
    assert_eq!(test.lost.modes.len(), 1);
    let mode = test.lost.modes[0];
    assert_eq!(mode.eigenvalue, Complex::ZERO);
    assert_eq!(mode.direction.map(Complex::norm), SVector::from([0.0, 1.0]));
    // Of two equal masses with a common force, the difference is lost, twice at 0.
    let mut a = SMatrix::<f64, 4, 4>::zeros();
    (a[(0, 2)], a[(1, 3)]) = (1.0, 1.0);
    let test = StateSpace::new(a, SMatrix::from([[0.0, 0.0, 1.0, 1.0]]))
        .controllability()
        .expect("finite");
    assert_eq!(test.lost.modes.len(), 2);
    for mode in &test.lost.modes {
        assert!((mode.direction[2] + mode.direction[3]).norm() < 1e-12, "{mode:?}");
    }
    assert!(!test.is_complete() && test.least_margin() < 1e-15);
}

#[test]
fn margins_are_distances_from_a_lost_mode() {
    // The mode of 1 is reached by epsilon: B without it is the nearest pair that loses it.
    let epsilon = 1e-3;
    let model = StateSpace::new(
        SMatrix::<f64, 2, 2>::new(1.0, 0.0, 0.0, -5.0),
        SMatrix::from([[epsilon, 2.0]]),
    );
    let test = model.controllability().expect("finite");
    assert!(test.is_complete());
    assert_eq!(test.margins[0].eigenvalue, Complex::from(1.0));
    // sigma of [0, 0, e; 0, -6, 2] is e up to the share of the second row
    let exact = epsilon * 6.0 / 40.0_f64.sqrt();
    assert!((test.margins[0].margin / exact - 1.0).abs() < 1e-6, "{test:?}");
    assert!((test.margins[1].margin - 2.0).abs() < 1e-5, "{test:?}");
}

#[test]
fn modes_on_the_limit_of_stability_have_to_be_weighted() {
    // An oscillator at 3 rad/s without damping, and a mass; the cost depends on the mass alone.
    let mut a = SMatrix::<f64, 4, 4>::zeros();
    (a[(0, 1)], a[(1, 0)], a[(2, 3)]) = (1.0, -9.0, 1.0);
    let b = SMatrix::<f64, 4, 1>::new(0.0, 1.0, 0.0, 1.0);
    let q = super::diagonal([0.0, 0.0, 1.0, 0.0]);
    let model = StateSpace::new(a, b);
    let Err(ControlError::Unweighted(lost)) = model.lqr(&q, &SMatrix::identity()) else {
        panic!("the oscillator does not contribute")
    };
    assert!(
        lost.modes
            .iter()
            .all(|mode| (mode.eigenvalue.im.abs() - 3.0).abs() < 1e-9),
        "{lost}"
    );
    assert_eq!(
        lost.to_string(),
        "2 modes: (0.0000 +- 3.0000i) 1/s along (0.000-0.333i) x[0] + x[1]"
    );
    let sampled = model.discretize(0.1).expect("finite");
    assert!(matches!(sampled.lqr(&q, &SMatrix::identity()), Err(ControlError::Unweighted(lost)) if lost.is_sampled));
    let shown = SMatrix::<f64, 1, 4>::new(1.0, 0.0, 1.0, 0.0);
    let observed = model.with_output_matrices(shown, SMatrix::zeros());
    let noise = super::diagonal([0.0, 0.0, 0.0, 1.0]);
    assert!(matches!(
        observed.kalman(&noise, &SMatrix::identity()),
        Err(ControlError::Undisturbed(_))
    ));
}
