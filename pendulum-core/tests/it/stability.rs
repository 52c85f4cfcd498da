//! Spectra, transition matrices, Lyapunov exponents and sections of systems with known answers.

use std::f64::consts::{PI, TAU};

use pendulum_core::Reason;
use pendulum_core::prelude::*;
use pendulum_core::stability::{Complex, Lyapunov, Spectrum, StabilityError, equilibrium, section, transition};

/// `x' = matrix x`.
fn linear<const N: usize>(matrix: SMatrix<f64, N, N>) -> impl Jacobian<f64, N> {
    FnSystem::with_jacobian(move |_t, x: &SVector<f64, N>| matrix * x, move |_t, _x: &_| matrix)
}

/// A pendulum with `g / l = 1`; angles from the hanging position.
fn swing() -> impl Jacobian<f64, 2> {
    FnSystem::with_jacobian(
        |_t, x: &SVector<f64, 2>| SVector::from([x[1], -x[0].sin()]),
        |_t, x: &SVector<f64, 2>| SMatrix::<f64, 2, 2>::new(0.0, 1.0, -x[0].cos(), 0.0),
    )
}

// Spectra

fn spectrum<const N: usize>(matrix: &SMatrix<f64, N, N>) -> Spectrum<N> {
    let spectrum = Spectrum::of(matrix).expect("finite");
    for mode in spectrum.modes() {
        let complex = matrix.map(Complex::from);
        let left = complex * mode.shape - mode.shape * mode.eigenvalue;
        assert!(left.map(Complex::norm).max() < 1e-7 * matrix.norm(), "{mode:?}");
        assert!((mode.shape.map(Complex::norm).max() - 1.0).abs() < 1e-12);
    }
    spectrum
}

fn assert_near(found: impl IntoIterator<Item = Complex<f64>>, expected: &[(f64, f64)], within: f64) {
    let found: Vec<_> = found.into_iter().collect();
    assert_eq!(found.len(), expected.len());
    for (found, &(re, im)) in found.iter().zip(expected) {
        assert!((found - Complex::new(re, im)).norm() < within, "{found} {re} {im}");
    }
}

#[test]
fn eigenvalues_are_the_roots_of_their_polynomial_in_order() {
    // (z + 1)(z + 2)(z^2 + 2 z + 5) = z^4 + 5 z^3 + 13 z^2 + 19 z + 10
    let companion = SMatrix::<f64, 4, 4>::new(
        0.0, 1.0, 0.0, 0.0, //
        0.0, 0.0, 1.0, 0.0, //
        0.0, 0.0, 0.0, 1.0, //
        -10.0, -19.0, -13.0, -5.0,
    );
    let spectrum = spectrum(&companion);
    assert_near(
        spectrum.eigenvalues(),
        &[(-1.0, 2.0), (-1.0, -2.0), (-1.0, 0.0), (-2.0, 0.0)],
        1e-13,
    );
    let [swinging, _, _, creeping] = spectrum.modes() else {
        panic!("there are four")
    };
    assert!((swinging.growth_rate() + 1.0).abs() < 1e-13 && (swinging.angular_frequency() - 2.0).abs() < 1e-13);
    assert!((swinging.damping_ratio() - 0.2_f64.sqrt()).abs() < 1e-13);
    assert!((creeping.damping_ratio() - 1.0).abs() < 1e-13);
}

#[test]
fn equal_eigenvalues_have_as_many_vectors_as_there_are() {
    // two uncoupled oscillators: pairs +-i, twice
    let matrix = SMatrix::<f64, 4, 4>::new(
        0.0, 0.0, 1.0, 0.0, //
        0.0, 0.0, 0.0, 1.0, //
        -1.0, 0.0, 0.0, 0.0, //
        0.0, -1.0, 0.0, 0.0,
    );
    let spectrum = spectrum(&matrix);
    assert_near(
        spectrum.eigenvalues(),
        &[(0.0, 1.0), (0.0, -1.0), (0.0, 1.0), (0.0, -1.0)],
        1e-14,
    );
    let rows = spectrum
        .modes()
        .iter()
        .map(|mode| mode.shape.transpose())
        .collect::<Vec<_>>();
    let shapes = SMatrix::<Complex<f64>, 4, 4>::from_rows(&rows);
    assert!(shapes.determinant().norm() > 0.1, "{shapes}");
}

#[test]
fn near_and_distant_eigenvalues_have_vectors_of_their_own() {
    // The eigenvectors (1, 0) and (1, d) of 1 and 1 + d enclose the angle atan(d), whose sine is the reciprocal of the
    // condition number.
    for d in [1.0, 1e-3, 1e-6] {
        let spectrum = spectrum(&SMatrix::<f64, 2, 2>::new(1.0, 1.0, 0.0, 1.0 + d));
        let [upper, lower] = spectrum.modes() else {
            panic!("two modes")
        };
        let slope = |mode: &pendulum_core::stability::Eigenmode<2>| mode.shape[1] / mode.shape[0];
        assert!(
            (slope(upper) - d).norm() < 1e-12 && slope(lower).norm() < 1e-12,
            "{spectrum:?}"
        );
        for mode in [upper, lower] {
            assert!((mode.condition * d.atan().sin() - 1.0).abs() < 1e-6, "{d} {mode:?}");
        }
    }
    // A triple eigenvalue: the vectors span all space.
    let triple = SMatrix::<f64, 3, 3>::new(2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 2.0);
    let spectrum = spectrum(&triple);
    let shapes: Vec<_> = spectrum.modes().iter().map(|mode| mode.shape).collect();
    let determinant = SMatrix::<Complex<f64>, 3, 3>::from_columns(&shapes).determinant();
    assert!(determinant.norm() > 0.1, "{shapes:?}");
    assert!(spectrum.modes().iter().all(|mode| (mode.condition - 1.0).abs() < 1e-12));
}

/// `q d q^-1`. Rounding splits equal eigenvalues of `d`, and no eigenvector lies along an axis.
fn mixed<const N: usize>(d: &SMatrix<f64, N, N>, seed: usize) -> SMatrix<f64, N, N> {
    let entry = |i: usize, j: usize| ((seed + 7 * i + 3 * j + i * j) as f64).sin();
    let q = SMatrix::<f64, N, N>::from_fn(|i, j| entry(i, j) + if i == j { 2.0 } else { 0.0 });
    q * d * q.try_inverse().expect("regular")
}

#[test]
fn eigenvalues_that_are_equal_but_for_rounding_have_vectors_of_their_own() {
    let mut twice = SMatrix::<f64, 6, 6>::zeros();
    for k in [0, 2] {
        twice
            .fixed_view_mut::<2, 2>(k, k)
            .copy_from(&SMatrix::<f64, 2, 2>::new(-0.5, -2.0, 2.0, -0.5));
    }
    (twice[(4, 4)], twice[(5, 5)]) = (3.0, 3.0);
    let thrice = SMatrix::<f64, 5, 5>::from_diagonal(&SVector::from([2.0, 2.0, 2.0, -1.0, -1.0]));
    fn are_apart<const N: usize>(matrix: &SMatrix<f64, N, N>) {
        let spectrum = spectrum(matrix);
        let unit: Vec<_> = spectrum.modes().iter().map(|mode| mode.shape.normalize()).collect();
        for (k, mode) in spectrum.modes().iter().enumerate() {
            // Eigenvectors of equal eigenvalues are orthogonal.
            for (other, vector) in spectrum.modes().iter().zip(&unit).take(k) {
                if (other.eigenvalue - mode.eigenvalue).norm() < 1e-9 {
                    assert!(vector.dotc(&unit[k]).norm() < 1e-9, "{spectrum:?}");
                }
            }
            // The largest component is 1, and the condition is at most that of `q`.
            assert!(
                mode.shape.iter().any(|component| (component - 1.0).norm() < 1e-15),
                "{mode:?}"
            );
            assert!((1.0 - 1e-12..100.0).contains(&mode.condition), "{mode:?}");
        }
    }
    for seed in 0..200 {
        are_apart(&mixed(&twice, seed));
        are_apart(&mixed(&thrice, seed));
    }
}

#[test]
fn an_oscillation_slower_than_rounding_errors_has_its_vectors() {
    for sign in [1.0, -1.0] {
        let slow = 1e-8 * sign;
        let spectrum = spectrum(&SMatrix::<f64, 3, 3>::new(
            0.0, slow, 0.0, -slow, 0.0, 0.0, 0.0, 0.0, -1e6,
        ));
        let [swinging, ..] = spectrum.modes() else {
            panic!("three modes")
        };
        assert_eq!(swinging.eigenvalue, Complex::new(0.0, 1e-8));
        assert!(
            (swinging.shape[1] / swinging.shape[0] - Complex::I * sign).norm() < 1e-12,
            "{swinging:?}"
        );
    }
}

#[test]
fn a_double_eigenvalue_with_one_vector_has_no_condition() {
    for a in [1.0, -0.3, 17.0] {
        let spectrum = spectrum(&SMatrix::<f64, 2, 2>::new(a, 1.0, 0.0, a));
        let [upper, lower] = spectrum.modes() else {
            panic!("two modes")
        };
        for mode in [upper, lower] {
            assert!(
                mode.condition > 1e15 && (mode.shape[0] - 1.0).norm() < 1e-15,
                "{mode:?}"
            );
        }
    }
}

#[test]
fn of_pairs_that_decay_alike_the_faster_comes_first() {
    let mut matrix = SMatrix::<f64, 4, 4>::zeros();
    for (k, turn) in [(0, 2.0), (2, 3.0)] {
        matrix
            .fixed_view_mut::<2, 2>(k, k)
            .copy_from(&SMatrix::<f64, 2, 2>::new(-1.0, turn, -turn, -1.0));
    }
    let expected = [(-1.0, 3.0), (-1.0, -3.0), (-1.0, 2.0), (-1.0, -2.0)];
    assert_near(spectrum(&matrix).eigenvalues(), &expected, 1e-15);
}

#[test]
fn a_symmetric_matrix_magnifies_no_errors_and_has_orthonormal_vectors() {
    for seed in 0..40 {
        let normal = SVector::<f64, 5>::from_fn(|i, _| ((seed + 3 * i) as f64).sin()).normalize();
        let reflection = SMatrix::<f64, 5, 5>::identity() - normal * normal.transpose() * 2.0;
        let values = SMatrix::from_diagonal(&SVector::from([3.0, 3.0, 1.0, -2.0, -4.5]));
        let spectrum = spectrum(&(reflection * values * reflection));
        for mode in spectrum.modes() {
            assert!((mode.condition - 1.0).abs() < 1e-12, "{seed} {mode:?}");
        }
        let shapes: Vec<_> = spectrum.modes().iter().map(|mode| mode.shape.normalize()).collect();
        let shapes = SMatrix::<_, 5, 5>::from_columns(&shapes);
        let rest = shapes.adjoint() * shapes - SMatrix::identity();
        assert!(rest.map(Complex::norm).max() < 1e-12, "{seed} {spectrum:?}");
    }
}

#[test]
fn the_uncertainty_is_what_rounding_errors_do() {
    // A defective double eigenvalue splits by the square root of a perturbation; a simple one of a matrix far from
    // normal moves by a multiple of it.
    for (matrix, least, most) in [
        (SMatrix::<f64, 2, 2>::new(1.0, 1.0, 0.0, 1.0), 1e-9, 1e-6),
        (SMatrix::<f64, 2, 2>::new(1.0, 1e5, 0.0, 2.0), 1e-10, 1e-4),
        (SMatrix::<f64, 2, 2>::new(1.0, 0.0, 0.0, 2.0), 1e-16, 1e-14),
    ] {
        let spectrum = spectrum(&matrix);
        let change = 2.0 * f64::EPSILON * matrix.norm();
        let changed = matrix + SMatrix::from_element(change);
        let moved = Spectrum::of(&changed).expect("finite");
        for (mode, moved) in spectrum.modes().iter().zip(moved.eigenvalues()) {
            let distance = (mode.eigenvalue - moved).norm();
            assert!(distance <= mode.uncertainty, "{distance:e} {mode:?}");
            assert!((least..most).contains(&mode.uncertainty), "{mode:?}");
        }
    }
}

#[test]
fn numbers_that_are_none_are_told() {
    let matrix = SMatrix::<f64, 2, 2>::new(1.0, f64::NAN, 0.0, 1.0);
    assert_eq!(Spectrum::of(&matrix), Err(StabilityError::NotFinite));
    let pole = FnSystem::with_jacobian(
        |_t, x: &SVector<f64, 1>| SVector::from([1.0 / x[0]]),
        |_t, x: &SVector<f64, 1>| SMatrix::from([[-1.0 / (x[0] * x[0])]]),
    );
    assert_eq!(equilibrium(&pole, [0.0]), Err(StabilityError::NotFinite));
}

#[test]
fn what_has_no_zero_has_no_equilibrium() {
    let never = FnSystem::with_jacobian(
        |_t, x: &SVector<f64, 1>| SVector::from([1.0 + x[0] * x[0]]),
        |_t, x: &SVector<f64, 1>| SMatrix::from([[2.0 * x[0]]]),
    );
    let error = equilibrium(&never, [3.0]).expect_err("x^2 + 1 > 0");
    let StabilityError::NoConvergence { residual, .. } = error else {
        panic!("{error}")
    };
    assert!((residual - 1.0).abs() < 1e-3, "{residual}");
}

// Transition matrices

#[test]
fn the_transition_matrix_of_a_linear_system_is_its_exponential() {
    let (decay, turn) = (0.3_f64, 2.0_f64);
    let system = linear(SMatrix::<f64, 2, 2>::new(-decay, -turn, turn, -decay));
    for t in [5.0, -3.0] {
        let (x, matrix) = transition(&system, 1.0, 1.0 + t, [1.0, 0.0], 1e-12).expect("regular");
        let (sin, cos) = (turn * t).sin_cos();
        let expected = SMatrix::<f64, 2, 2>::new(cos, -sin, sin, cos) * (-decay * t).exp();
        assert!(
            (matrix - expected).amax() < 1e-11 * expected.amax(),
            "{matrix} {expected}"
        );
        assert!((x - expected.column(0)).amax() < 1e-11 * expected.amax());
    }
}

/// The state is constant at an equilibrium, so only the tangents can limit the step size.
#[test]
fn tangents_are_accurate_where_the_state_rests() {
    let (x, matrix) = transition(&swing(), 0.0, 10.0, [PI, 0.0], 1e-11).expect("regular");
    assert!((x - SVector::from([PI, 0.0])).amax() < 1e-11);
    let (sinh, cosh) = (10.0_f64.sinh(), 10.0_f64.cosh());
    let expected = SMatrix::<f64, 2, 2>::new(cosh, sinh, sinh, cosh);
    assert!((matrix - expected).amax() < 1e-9 * cosh, "{matrix}");
}

#[test]
fn the_transition_matrix_is_the_derivative_of_the_flow() {
    let start = SVector::from([2.0, 0.5]);
    let (x, matrix) = transition(&swing(), 0.0, 7.0, start, 1e-13).expect("regular");
    let end = |x0: SVector<f64, 2>| {
        let method = Vern9::new().rtol(1e-13).atol(1e-13);
        method.solve(&swing(), 0.0, 7.0, x0).expect("regular").end()
    };
    assert!((end(start) - x).amax() < 1e-11);
    let h = 1e-3;
    for j in 0..2 {
        let apart = |h: f64| {
            let mut step = SVector::zeros();
            step[j] = h;
            (end(start + step) - end(start - step)) / (2.0 * h)
        };
        let slope = (apart(h) * 4.0 - apart(2.0 * h)) / 3.0;
        assert!((slope - matrix.column(j)).amax() < 1e-8, "{slope} {matrix}");
    }
    // Liouville: areas are preserved, since the trace of the Jacobian is zero.
    assert!((matrix.determinant() - 1.0).abs() < 1e-11);
}

// Lyapunov exponents

#[test]
fn exponents_of_a_linear_system_are_its_growth_rates() {
    let system = linear(SMatrix::<f64, 3, 3>::new(
        -2.0, 1.0, 0.5, //
        0.0, 0.25, 3.0, //
        0.0, 0.0, -0.5,
    ));
    let exponents = Lyapunov::new().tolerance(1e-10).transient(40.0).duration(60.0);
    // The state stays on the first axis, along which it decays; the tangents must not.
    let found = exponents.exponents::<3, _>(&system, [1.0, 0.0, 0.0]).expect("regular");
    for (value, expected) in found.values.iter().zip([0.25, -0.5, -2.0]) {
        assert!((value - expected).abs() < 1e-8, "{found:?}");
    }
    assert!((found.horizon(1e-16, 1e-6) - 40.0 * 10.0_f64.ln()).abs() < 1e-5);
    assert!(found.uncertainty.iter().all(|&uncertainty| uncertainty < 1e-8));
    assert_eq!(found.t, 100.0);
}

/// Tangents `v' = t v` about a state at rest. Over a time T from t0 on, their mean growth rate is t0 + T / 2. In the
/// k-th of ten parts it differs by (k - 4.5) T / 10, with a standard error of sqrt(82.5 / 10 / 9) T / 10.
#[test]
fn uncertainty_is_the_scatter_of_ten_parts() {
    let system = FnSystem::with_jacobian(
        |_t, _x: &SVector<f64, 1>| SVector::zeros(),
        |t, _x| SMatrix::from([[t]]),
    );
    for (transient, duration) in [(0.0, 20.0), (10.0, 20.0), (3.0, 1.0)] {
        let measure = Lyapunov::new().tolerance(1e-13).transient(transient).duration(duration);
        let found = measure.largest(&system, [0.0]).expect("regular");
        // The first step may extend beyond the end of the transient.
        let (value, uncertainty) = (transient + duration / 2.0, (8.25_f64 / 9.0).sqrt() * duration / 10.0);
        let slack = if transient == 0.0 { 1e-9 } else { 0.05 * duration };
        assert!((found.values[0] - value).abs() < slack, "{found:?} {value}");
        assert!(
            (found.uncertainty[0] / uncertainty - 1.0).abs() < 0.05,
            "{found:?} {uncertainty}"
        );
    }
}

/// J. C. Sprott, "Chaos and Time-Series Analysis" (2003): 0.9056, 0 and -14.5723.
#[test]
fn exponents_of_lorenz() {
    let (sigma, rho, beta) = (10.0, 28.0, 8.0 / 3.0);
    let lorenz = FnSystem::with_jacobian(
        move |_t, x: &SVector<f64, 3>| {
            SVector::from([
                sigma * (x[1] - x[0]),
                x[0] * (rho - x[2]) - x[1],
                x[0] * x[1] - beta * x[2],
            ])
        },
        move |_t, x: &SVector<f64, 3>| {
            SMatrix::<f64, 3, 3>::new(
                -sigma,
                sigma,
                0.0, //
                rho - x[2],
                -1.0,
                -x[0], //
                x[1],
                x[0],
                -beta,
            )
        },
    );
    let measure = Lyapunov::new().tolerance(1e-7).transient(20.0).duration(1000.0);
    let found = measure.exponents::<3, _>(&lorenz, [1.0, 1.0, 1.0]).expect("regular");
    for (k, expected) in [0.9056, 0.0, -14.5723].into_iter().enumerate() {
        let apart = (found.values[k] - expected).abs();
        assert!(apart < 0.015 && apart < 4.0 * found.uncertainty[k] + 1e-4, "{found:?}");
    }
    // The trace of the Jacobian is constant.
    let sum: f64 = found.values.iter().sum();
    assert!((sum + sigma + 1.0 + beta).abs() < 1e-6, "{sum}");
}

#[test]
fn nonsense_is_refused_by_name() {
    let refused = |measure: Lyapunov| match measure.largest(&swing(), [1.0, 0.0]) {
        Err(StabilityError::Integration(Reason::InvalidInput { what, .. })) => what,
        other => panic!("{other:?}"),
    };
    assert_eq!(refused(Lyapunov::new().tolerance(0.0)), "rtol");
    for value in [-1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(refused(Lyapunov::new().transient(value)), "transient");
        assert_eq!(refused(Lyapunov::new().duration(value)), "duration");
    }
    assert_eq!(refused(Lyapunov::new().duration(0.0)), "duration");
}

// Sections

#[test]
fn a_driven_oscillator_settles_on_one_point() {
    // x'' + 0.4 x' + x = cos(2 t): x tends to the real part of e^(2 i t) / (1 - 4 + 0.8 i)
    let system = FnSystem(|t: f64, x: &SVector<f64, 2>| SVector::from([x[1], (2.0 * t).cos() - x[0] - 0.4 * x[1]]));
    let response = Complex::new(-3.0, 0.8).inv();
    let expected = SVector::from([response.re, -2.0 * response.im]);
    // each half turn of the sine is one drive period
    let surface = Event::new(|t: f64, _x: &SVector<f64, 2>| t.sin());
    let method = Vern9::new().rtol(1e-12).atol(1e-12);
    let points = section(&method, &system, 0.5, 400.0, [3.0, 0.0], &surface).expect("regular");
    assert_eq!(points.len(), 127);
    for (k, point) in (1..).zip(&points) {
        assert!((point.t - PI * f64::from(k)).abs() < 1e-12 * point.t);
    }
    let last = points[126].x;
    assert!((last - expected).amax() < 1e-10, "{last} {expected}");
}

#[test]
fn a_section_is_the_events_of_the_trajectory() {
    let surface = Event::new(|_t, x: &SVector<f64, 2>| x[0] - 0.3).falling();
    let method = Rk45::new();
    let points = section(&method, &swing(), 0.0, 50.0, [2.0, 0.0], &surface).expect("regular");
    let solution = method
        .solve_with(&swing(), 0.0, 50.0, [2.0, 0.0], &[surface])
        .expect("regular");
    assert_eq!(points, solution.events());
    assert!(points.len() == 6 && points.iter().all(|point| point.x[1] < 0.0));
    let period = (points[5].t - points[0].t) / 5.0;
    // 4 K(sin 1), by the arithmetic-geometric mean
    let (mut a, mut b) = (1.0, 1.0_f64.cos());
    for _ in 0..6 {
        (a, b) = ((a + b) / 2.0, f64::sqrt(a * b));
    }
    assert!((period - TAU / a).abs() < 1e-4, "{period}");
}
