//! Modes that inputs do not reach or outputs do not show.

use pendulum_core::control::{ControlError, LostModes, PbhTest, StateSpace};
use pendulum_core::nalgebra::{SMatrix, SVector};
use pendulum_core::stability::Complex;

use super::{Random, diagonal};

/// A pair whose inputs do not reach some modes, in units of the state that differ.
struct Planted<const N: usize, const M: usize> {
    a: SMatrix<f64, N, N>,
    b: SMatrix<f64, N, M>,
    /// The pair in equal units.
    plain: (SMatrix<f64, N, N>, SMatrix<f64, N, M>),
    units: SVector<f64, N>,
}

impl<const N: usize, const M: usize> Planted<N, M> {
    /// The eigenvalues `modes` are out of reach, in rotated axes, in units of `10^spread` or `10^-spread`.
    fn new(random: &mut Random, modes: &[Complex<f64>], spread: f64) -> Self {
        let reached = N - modes.len();
        let mut a = SMatrix::<f64, N, N>::from_fn(|i, j| if i >= reached && j < i { 0.0 } else { random.number() });
        for (n, value) in modes.iter().enumerate() {
            let i = reached + n;
            a[(i, i)] = value.re;
            if value.im < 0.0 {
                (a[(i - 1, i)], a[(i, i - 1)]) = (-value.im, value.im);
            }
        }
        let b = SMatrix::<f64, N, M>::from_fn(|i, _| if i >= reached { 0.0 } else { random.number() });
        let axes = random.rotation::<N>();
        let plain = (axes * a * axes.transpose(), axes * b);
        let units = SVector::<f64, N>::from_fn(|_, _| 10.0_f64.powf(spread * random.number().signum()));
        let scale = SMatrix::from_diagonal(&units);
        Self {
            a: scale * plain.0 * SMatrix::from_diagonal(&units.map(f64::recip)),
            b: scale * plain.1,
            plain,
            units,
        }
    }

    fn model(&self) -> StateSpace<N, M> {
        StateSpace::new(self.a, self.b)
    }

    /// The model whose outputs show what the inputs of [`model`](Self::model) reach.
    fn dual(&self) -> StateSpace<N, 0, M> {
        StateSpace::new(self.a.transpose(), SMatrix::zeros()).with_output_matrices(self.b.transpose(), SMatrix::zeros())
    }

    /// Each eigenvalue is found once, with its left eigenvector, on which the inputs do not act.
    fn check(&self, lost: &LostModes<N>, expected: &[Complex<f64>]) {
        assert_eq!(lost.modes.len(), expected.len(), "{expected:?}: {lost:?}");
        let mut rest = expected.to_vec();
        for mode in &lost.modes {
            let distance = |value: &Complex<f64>| (value - mode.eigenvalue).norm();
            let nearest = (0..rest.len()).min_by(|&i, &j| distance(&rest[i]).total_cmp(&distance(&rest[j])));
            let nearest = rest.swap_remove(nearest.expect("one for each"));
            assert!(distance(&nearest) < 1e-6, "{expected:?}: {lost:?}");
            let largest = mode.direction.map(Complex::norm).max();
            assert!((largest - 1.0).abs() < 1e-12, "{largest}");
            let row = mode
                .direction
                .component_mul(&self.units.map(Complex::from))
                .normalize()
                .transpose();
            let change = row * self.plain.0.map(Complex::from) - row * mode.eigenvalue;
            assert!(
                change.map(Complex::norm).max() < 1e-8,
                "{}",
                change.map(Complex::norm).max()
            );
            let influence = row * self.plain.1.map(Complex::from);
            assert!(
                influence.map(Complex::norm).max() < 1e-8,
                "{}",
                influence.map(Complex::norm).max()
            );
        }
    }

    fn check_tests(&self, modes: &[Complex<f64>]) {
        let test: PbhTest<N> = self.model().controllability().expect("finite");
        self.check(&test.lost, modes);
        self.check(&self.dual().observability().expect("finite").lost, modes);
    }
}

fn tried<const N: usize, const M: usize>(random: &mut Random, modes: &[Complex<f64>]) {
    let planted = Planted::<N, M>::new(random, modes, 1.0);
    planted.check_tests(modes);
    let persistent: Vec<_> = modes.iter().copied().filter(|mode| mode.re >= 0.0).collect();
    match planted.model().lqr(&SMatrix::identity(), &SMatrix::identity()) {
        Err(ControlError::Unstabilizable(lost)) => planted.check(&lost, &persistent),
        result => assert!(persistent.is_empty() && result.is_ok(), "{persistent:?}: {result:?}"),
    }
    match planted.dual().kalman(&SMatrix::identity(), &SMatrix::identity()) {
        Err(ControlError::Undetectable(lost)) => planted.check(&lost, &persistent),
        result => assert!(persistent.is_empty() && result.is_ok(), "{persistent:?}: {result:?}"),
    }
    // Units that differ by 6 orders of magnitude hide nothing.
    Planted::<N, M>::new(random, modes, 3.0).check_tests(modes);
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

/// A plate that is steered by its tilt, and its heading: chains of four and of two integrators. Rounding errors decide
/// about the units that balance such a matrix.
#[test]
fn chains_without_eigenvalues_are_reached() {
    let mut random = Random(3);
    for _ in 0..20 {
        // The errors are larger beside entries that are not zero.
        let mut a = SMatrix::<f64, 6, 6>::from_fn(|i, j| {
            let largest = if [3, 5].contains(&i) && [0, 4].contains(&j) {
                1e-16
            } else {
                1e-13
            };
            largest * 10.0_f64.powf(-60.0 * random.number().abs())
        });
        (a[(0, 1)], a[(1, 2)], a[(2, 3)], a[(4, 5)]) = (1.0, 19.62, 0.5, 0.5);
        let mut b = SMatrix::<f64, 6, 2>::zeros();
        (b[(3, 0)], b[(5, 1)]) = (64.9, 67.5);
        let model = StateSpace::new(a, b);
        let test = model.controllability().expect("finite");
        assert!(test.is_complete(), "{:?}", test.lost);
        assert!(model.lqr(&SMatrix::identity(), &SMatrix::identity()).is_ok());
        // Without its second input, the chain of two is lost.
        let test = StateSpace::new(a, b.fixed_columns::<1>(0).into_owned())
            .controllability()
            .expect("finite");
        assert_eq!(test.lost.modes.len(), 2, "{:?}", test.lost);
    }
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
fn torques_that_cancel_reach_nothing() {
    // The second torque is a rounding error; the mode that it drives grows.
    let (a, one) = (diagonal([-1.0, 2.0]), SMatrix::identity());
    for noise in [0.0, 1e-17] {
        let model = StateSpace::new(a, diagonal([1.0, noise]));
        let test = model.controllability().expect("finite");
        assert_eq!(test.lost.modes.len(), 1, "{noise}");
        let error = model.lqr(&SMatrix::identity(), &one).expect_err("out of reach");
        assert!(matches!(error, ControlError::Unstabilizable(_)), "{noise}: {error}");
        let shown = model.with_output_matrices(diagonal([1.0, noise]), SMatrix::zeros());
        assert!(!shown.observability().expect("finite").is_complete());
        let error = shown.kalman(&SMatrix::identity(), &one).expect_err("not shown");
        assert!(matches!(error, ControlError::Undetectable(_)), "{noise}: {error}");
    }
    // Prices of inputs may differ by more.
    let prices = diagonal([1.0, 1e40]);
    let regulator = StateSpace::new(a, one)
        .lqr(&SMatrix::identity(), &prices)
        .expect("reached");
    assert!(
        (regulator.law.gain[(1, 1)] - 4.0).abs() < 1e-12,
        "{}",
        regulator.law.gain
    );
}

/// The mode of a pole that falls, `sqrt(9.81)` in 1/s, without an input.
#[test]
fn messages_have_significant_digits() {
    let pole = |g: f64| StateSpace::<2, 0>::new(SMatrix::<f64, 2, 2>::new(0.0, 1.0, g, 0.0), SMatrix::zeros());
    let message = |model: StateSpace<2, 0>| {
        let one = SMatrix::identity();
        model.lqr(&one, &SMatrix::identity()).expect_err("it falls").to_string()
    };
    assert_eq!(
        message(pole(9.81)),
        "the model cannot be stabilized: no input acts on 1 mode: 3.13 1/s along x[0] + 0.319 x[1]\n\
         help: add an input that acts along it, fix the joint, or give it friction"
    );
    assert!(message(pole(0.0)).contains("no input acts on 2 modes: 0 1/s along x[1], 0 1/s along "));
    assert!(message(pole(0.0)).contains("acts along them"));
    let slow = StateSpace::<2, 0>::new(diagonal([1e-5, -12345.0]), SMatrix::zeros());
    assert!(message(slow).contains("1 mode: 1e-5 1/s along x[0]\n"));
}

#[test]
fn modes_on_the_limit_of_stability_have_to_be_weighted() {
    // An oscillator at 3 rad/s without damping, and a mass; the cost depends on the mass alone.
    let mut a = SMatrix::<f64, 4, 4>::zeros();
    (a[(0, 1)], a[(1, 0)], a[(2, 3)]) = (1.0, -9.0, 1.0);
    let b = SMatrix::<f64, 4, 1>::new(0.0, 1.0, 0.0, 1.0);
    let q = diagonal([0.0, 0.0, 1.0, 0.0]);
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
    assert_eq!(lost.to_string(), "2 modes: (0 +- 3i) 1/s along (0-0.333i) x[0] + x[1]");
    let sampled = model.discretize(0.1).expect("finite");
    assert!(matches!(sampled.lqr(&q, &SMatrix::identity()), Err(ControlError::Unweighted(lost)) if lost.is_sampled));
    let shown = SMatrix::<f64, 1, 4>::new(1.0, 0.0, 1.0, 0.0);
    let observed = model.with_output_matrices(shown, SMatrix::zeros());
    let noise = diagonal([0.0, 0.0, 0.0, 1.0]);
    assert!(matches!(
        observed.kalman(&noise, &SMatrix::identity()),
        Err(ControlError::Undisturbed(_))
    ));
}
